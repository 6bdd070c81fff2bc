//! A run's result directory, written by a thread of its own.
//!
//! ```text
//! DIR/run.json                    version, scene title and hash, settings
//! DIR/history.csv                 one row per output time, see `history`
//! DIR/spheres.pvd                 and contacts.pvd, boundaries.pvd: frames with their times
//! DIR/spheres_000042.vtu          frame 42: the first communication point at or after 42 intervals
//! DIR/checkpoint_000860.state     states to go on from, see `checkpoint`
//! DIR/view.py                     macro for ParaView
//! ```
//!
//! Frames are numbered by time, so a run that goes back and comes again writes the same names. An error of the disk
//! does not stop the simulation: it is counted and reported in [`Status`].

use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::Duration;

use super::checkpoint::{self, Checkpoint};
use super::directory::{self, Directory};
use super::disk::{Disk, Item, Message, fail, lock};
use super::frames::{Surface, frame, series};
use super::history::row;
use crate::communication_points::{due, tick};
use crate::error::SnapshotError;
use crate::formats::durable::replace;
use crate::formats::error::OutputError;
use crate::observe::Observation;
use crate::results::Options;
use crate::scene::Scene;

pub use super::disk::Status;

/// Rows and other messages that may wait for the disk before the simulation waits too.
const QUEUE: usize = 64;
/// Frames queued for the disk, the one that is being written included: each holds some 0.6 kB per sphere in a heap.
const FRAMES: usize = 2;
/// Frames that may wait; older ones are written although they may yet be rolled back.
const HELD_FRAMES: usize = 16;
/// Rows that may wait, likewise.
const HELD_ROWS: usize = 4096;

/// Where a run that was resumed goes on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Resumed {
    /// Time \[s\]; `None`: there was nothing to go on from, the run starts anew.
    pub time: Option<f64>,
    /// Checkpoints that were passed over because they are damaged, and why.
    pub damaged: Vec<String>,
}

/// A session of results. Dropping it writes what waits and joins the thread.
pub struct Results {
    options: Options,
    surface: Surface,
    /// Times \[s\] of the frames and rows that stand.
    frames: Vec<f64>,
    rows: Vec<f64>,
    held: VecDeque<Item>,
    sender: Option<SyncSender<Message>>,
    /// One for each frame that may be sent.
    permits: Receiver<()>,
    worker: Option<JoinHandle<()>>,
    status: Arc<Mutex<Status>>,
}

impl Results {
    /// Prepares the directory and starts the thread.
    ///
    /// # Errors
    /// [`OutputError::Exists`] where a run lies already, unless `overwrite`; [`OutputError::Busy`] where one is going
    /// on; [`OutputError::Io`].
    pub fn create(scene: &Scene, options: Options) -> Result<Self, OutputError> {
        Self::begin(Directory::claim(&options.directory)?, scene, options)
    }

    /// Goes on at `time` \[s\] with the files that another session of the same run left in the directory, or begins where
    /// there are none. What they hold beyond `time` is dropped, for which [`Options::overwrite`] must be set.
    ///
    /// # Errors
    /// As [`Self::resume`]; [`OutputError::Busy`] at once, as a living session keeps its directory.
    pub fn follow(scene: &Scene, options: Options, time: f64) -> Result<Self, OutputError> {
        let directory = Directory::claim_within(Duration::ZERO, &options.directory)?;
        match directory.holds(&directory::about(scene, &options)) {
            Ok(true) => Self::reopen(directory, scene, options, time, &[]),
            // Another run may be replaced, if anything may.
            Err(OutputError::OtherRun { .. }) if options.overwrite => {
                Self::begin(directory, scene, options)
            }
            Ok(false) => Self::begin(directory, scene, options),
            Err(error) => Err(error),
        }
    }

    /// Goes on with the run in the directory: `restore` is handed its checkpoints, newest first, until it has put the
    /// simulation back to one and says to which time \[s\]; `None` passes over one that is whole but not wanted. What
    /// is later is dropped, also from the disk. A directory without checkpoints is begun anew.
    ///
    /// # Errors
    /// [`OutputError::OtherRun`] if the directory holds another scene's or other settings' run,
    /// [`OutputError::Unusable`] if no checkpoint can be read, [`OutputError::Changed`] if rows or frames before it are
    /// missing: then nothing is changed; [`OutputError::Exists`], [`OutputError::Busy`], [`OutputError::Io`].
    pub fn resume(
        scene: &Scene,
        options: Options,
        mut restore: impl FnMut(&[u8]) -> Result<Option<f64>, SnapshotError>,
    ) -> Result<(Self, Resumed), OutputError> {
        let directory = Directory::claim(&options.directory)?;
        if !directory.holds(&directory::about(scene, &options))? {
            let anew = Self::begin(directory, scene, options)?;
            return Ok((anew, Resumed::default()));
        }
        let checkpoints = checkpoint::list(&directory)?;
        let mut damaged = Vec::new();
        for (k, name) in checkpoints.iter().enumerate() {
            let outcome = match directory.read(name) {
                Ok(blob) => restore(&blob).map_err(|error| error.to_string()),
                Err(error) => Err(error.to_string()),
            };
            match outcome {
                Ok(Some(time)) => {
                    // Resuming is permission to drop what came after the checkpoint.
                    let options = Options {
                        overwrite: true,
                        ..options
                    };
                    let results = Self::reopen(directory, scene, options, time, &checkpoints[..k])?;
                    let time = Some(time);
                    return Ok((results, Resumed { time, damaged }));
                }
                Ok(None) => {}
                Err(why) => damaged.push(format!("{name}: {why}")),
            }
        }
        if !damaged.is_empty() {
            return Err(OutputError::Unusable {
                path: options.directory,
                reasons: damaged.join("; "),
            });
        }
        let overwrite = Options {
            overwrite: true,
            ..options
        };
        Ok((
            Self::begin(directory, scene, overwrite)?,
            Resumed::default(),
        ))
    }

    fn begin(directory: Directory, scene: &Scene, options: Options) -> Result<Self, OutputError> {
        if !options.overwrite {
            directory.expect_empty()?;
        }
        directory.clear(&directory::about(scene, &options))?;
        let view = directory.path().join("view.py");
        replace(&view, include_bytes!("view.py"))?;
        let disk = Disk::create(directory, scene, options.precision)?;
        Self::start(disk, Surface::new(scene), options, Vec::new(), Vec::new())
    }

    /// Takes up the files of an earlier run at `time` \[s\], without the checkpoints `later`.
    fn reopen(
        directory: Directory,
        scene: &Scene,
        options: Options,
        time: f64,
        later: &[String],
    ) -> Result<Self, OutputError> {
        let surface = Surface::new(scene);
        let shown = series(scene, &surface);
        let mut disk = Disk::open(directory, scene, options.precision)?;
        disk.expect_up_to(time, options.row_interval, options.frame_interval, &shown)?;
        if !options.overwrite && disk.latest() > Some(time) {
            return Err(OutputError::Exists {
                path: options.directory,
                found: format!("results later than {time} s"),
            });
        }
        // First the promise that the rows and frames are there, then they.
        disk.directory().remove(later)?;
        disk.rewind(time, &shown)?;
        disk.directory()
            .describe(&directory::about(scene, &options))?;
        let frames = match shown.first() {
            Some(&series) => disk.frames(series),
            None => vec![time],
        };
        let rows = disk.rows();
        Self::start(disk, surface, options, frames, rows)
    }

    fn start(
        disk: Disk,
        surface: Surface,
        options: Options,
        frames: Vec<f64>,
        rows: Vec<f64>,
    ) -> Result<Self, OutputError> {
        let status = disk.status();
        let (sender, receiver) = sync_channel(QUEUE);
        let (written, permits) = sync_channel(FRAMES);
        for _ in 0..FRAMES {
            // The queue takes all of them.
            let _ = written.send(());
        }
        let worker = std::thread::Builder::new()
            .name("results".to_owned())
            .spawn(move || disk.serve(&receiver, &written))
            .map_err(OutputError::io("start the writer of", &options.directory))?;
        Ok(Self {
            surface,
            frames,
            rows,
            held: VecDeque::new(),
            sender: Some(sender),
            permits,
            worker: Some(worker),
            status,
            options,
        })
    }

    /// Takes what is due from `state`: call it at the start and after every communication step. A state that is not
    /// later than the last one drops what it overtakes, as [`Self::rollback`] does.
    pub fn record(&mut self, state: &Observation) {
        let time = state.time;
        self.retract(|t| t < time);
        if due(time, self.options.row_interval, self.rows.last().copied()) {
            self.rows.push(time);
            self.submit(Item::Row(row(state)));
        }
        let interval = self.options.frame_interval;
        if interval > 0.0 && due(time, interval, self.frames.last().copied()) {
            self.frames.push(time);
            self.submit(Item::Frame {
                number: tick(time, interval),
                time,
                grids: frame(state, &self.surface),
            });
        }
    }

    /// The simulation was put back to `time` \[s\]: what was recorded later is dropped, also from the disk.
    pub fn rollback(&mut self, time: f64) {
        self.retract(|t| t <= time);
    }

    /// What was recorded up to `time` \[s\] cannot be rolled back any more and may be written.
    pub fn commit(&mut self, time: f64) {
        while self.held.front().is_some_and(|item| item.time() <= time) {
            self.release();
        }
    }

    /// Writes a checkpoint behind the frames and rows recorded so far. After a failure none is written.
    pub fn checkpoint(&mut self, checkpoint: Checkpoint) {
        self.commit(f64::INFINITY);
        self.send(Message::Checkpoint(checkpoint));
    }

    /// Waits until everything that was sent has been written.
    pub fn flush(&mut self) {
        let (done, wait) = sync_channel(1);
        self.send(Message::Flush(done));
        // A closed channel means that the thread is gone, which `send` has counted.
        let _ = wait.recv();
    }

    /// What has reached the disk so far.
    #[must_use]
    pub fn status(&self) -> Status {
        lock(&self.status).clone()
    }

    /// Writes everything, joins the thread, and says how it went.
    #[must_use]
    pub fn finish(mut self) -> Status {
        self.close();
        self.status()
    }

    fn submit(&mut self, item: Item) {
        self.held.push_back(item);
        if !self.options.hold {
            return self.commit(f64::INFINITY);
        }
        let frames = |held: &VecDeque<Item>| {
            held.iter()
                .filter(|item| matches!(item, Item::Frame { .. }))
                .count()
        };
        while self.held.len() > HELD_ROWS || frames(&self.held) > HELD_FRAMES {
            self.release();
        }
    }

    /// Sends the oldest item that waits.
    fn release(&mut self) {
        if let Some(item) = self.held.pop_front() {
            if let Item::Frame { .. } = item {
                // A closed channel means that the thread is gone, which `send` counts.
                let _ = self.permits.recv();
            }
            self.send(Message::Write(item));
        }
    }

    /// Drops everything whose time does not satisfy `keep`, a condition that holds up to some time.
    fn retract(&mut self, keep: impl Fn(f64) -> bool) {
        let count = |times: &[f64]| times.partition_point(|&t| keep(t));
        let (frames, rows) = (count(&self.frames), count(&self.rows));
        if frames == self.frames.len() && rows == self.rows.len() {
            return;
        }
        self.frames.truncate(frames);
        self.rows.truncate(rows);
        self.held.retain(|item| keep(item.time()));
        let last = |times: &[f64]| times.last().copied().unwrap_or(f64::NEG_INFINITY);
        // The latest time that stands separates what is kept from what is not, for frames and rows alike.
        self.send(Message::Rollback(last(&self.frames).max(last(&self.rows))));
    }

    fn send(&mut self, message: Message) {
        let sent = self.sender.as_ref().map(|sender| sender.send(message));
        if !matches!(sent, Some(Ok(()))) {
            fail(&self.status, "the writer of results has stopped");
        }
    }

    fn close(&mut self) {
        self.commit(f64::INFINITY);
        self.sender = None;
        if let Some(worker) = self.worker.take()
            && worker.join().is_err()
        {
            fail(&self.status, "the writer of results has crashed");
        }
    }
}

impl Drop for Results {
    fn drop(&mut self) {
        if self.worker.is_some() {
            self.close();
        }
    }
}
