//! A run's result directory, written by a thread of its own.
//!
//! ```text
//! DIR/run.json                    version, scene title and hash, settings
//! DIR/history.csv                 one row per output time, see `history`
//! DIR/spheres.pvd                 and contacts.pvd, boundaries.pvd: frames with their times
//! DIR/spheres_000042.vtu          frame 42: the first communication point at or after 42 intervals
//! DIR/view.py                     macro for ParaView
//! ```
//!
//! Frames are numbered by time, so a run that goes back and comes again writes the same names. An error of the disk
//! does not stop the simulation: it is counted and told in [`Status`].

use std::collections::VecDeque;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;

use serde_json::json;

use super::Observation;
use super::error::OutputError;
use super::frames::{Series, Surface, frame};
use super::history::{columns, row};
use super::pvd::Collection;
use super::table::Table;
use super::vtu::{Grid, Precision, encode, replace};
use crate::scene::Scene;

/// Frames and rows that may wait for the disk before the simulation waits too.
const QUEUE: usize = 8;
/// Frames that may be held back; older ones are written although they may yet be rolled back.
const HELD_FRAMES: usize = 16;
/// Rows that may be held back, likewise.
const HELD_ROWS: usize = 4096;
/// Share of an interval by which a communication point may fall short of it, for rounding.
const EARLY: f64 = 1e-6;

/// What is written where, and when.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The directory; created with its parents.
    pub directory: PathBuf,
    /// Replace the files of an earlier run in it.
    pub overwrite: bool,
    /// Seconds between VTU frames \[s\]; 0: none.
    pub frame_interval: f64,
    /// Seconds between rows of the history \[s\]; 0: every communication step.
    pub row_interval: f64,
    /// Precision of the frames.
    pub precision: Precision,
    /// Hold frames and rows back until [`Results::commit`] says that they cannot be rolled back any more.
    pub hold: bool,
}

impl Options {
    /// What the scene's `[output]` asks for, into `directory`.
    #[must_use]
    pub fn new(directory: impl Into<PathBuf>, scene: &Scene) -> Self {
        let output = &scene.output;
        Self {
            directory: directory.into(),
            overwrite: false,
            frame_interval: output.vtu_interval,
            row_interval: output.csv_interval,
            precision: if output.float64 {
                Precision::Double
            } else {
                Precision::Single
            },
            hold: false,
        }
    }
}

/// What has reached the disk.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Status {
    /// Frames written, overwritten ones counted again.
    pub frames: u64,
    /// Rows written, likewise.
    pub rows: u64,
    /// Frames, rows or rollbacks that failed.
    pub failures: u64,
    /// The first failure, in words.
    pub first_failure: Option<String>,
}

/// A frame or a row on its way to the disk.
enum Item {
    Frame {
        number: u64,
        time: f64,
        grids: Vec<(Series, Grid)>,
    },
    Row(Vec<f64>),
}

impl Item {
    fn time(&self) -> f64 {
        match self {
            Self::Frame { time, .. } => *time,
            Self::Row(values) => values[0],
        }
    }
}

enum Message {
    Write(Item),
    Rollback(f64),
    Flush(SyncSender<()>),
}

/// A session of results. Dropping it writes what is held and joins the thread.
pub struct Results {
    options: Options,
    surface: Surface,
    /// Times \[s\] of the frames and rows that stand.
    frames: Vec<f64>,
    rows: Vec<f64>,
    held: VecDeque<Item>,
    sender: Option<SyncSender<Message>>,
    worker: Option<JoinHandle<()>>,
    status: Arc<Mutex<Status>>,
}

impl Results {
    /// Prepares the directory and starts the thread.
    ///
    /// # Errors
    /// [`OutputError::Exists`] where a run lies already, unless `overwrite`; [`OutputError::Io`].
    pub fn create(scene: &Scene, options: Options) -> Result<Self, OutputError> {
        let directory = &options.directory;
        fs::create_dir_all(directory).map_err(OutputError::io("create", directory))?;
        clear(directory, options.overwrite)?;
        let about = directory.join("run.json");
        replace(&about, &describe(scene, &options, &about)?)?;
        replace(&directory.join("view.py"), include_bytes!("view.py"))?;
        let status = Arc::new(Mutex::new(Status::default()));
        let disk = Disk {
            precision: options.precision,
            series: Series::ALL
                .map(|s| Collection::new(directory.join(format!("{}.pvd", s.name())))),
            history: Table::create(&directory.join("history.csv"), columns(scene))?,
            status: Arc::clone(&status),
        };
        let (sender, receiver) = sync_channel(QUEUE);
        let worker = std::thread::Builder::new()
            .name("results".to_owned())
            .spawn(move || disk.serve(&receiver))
            .map_err(OutputError::io("start the writer of", directory))?;
        Ok(Self {
            surface: Surface::new(scene),
            frames: Vec::new(),
            rows: Vec::new(),
            held: VecDeque::new(),
            sender: Some(sender),
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
        if due(time, self.options.row_interval, self.rows.last()) {
            self.rows.push(time);
            self.submit(Item::Row(row(state)));
        }
        let interval = self.options.frame_interval;
        if interval > 0.0 && due(time, interval, self.frames.last()) {
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

    /// Waits until everything that is not held has been written.
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

    /// The directory.
    #[must_use]
    pub fn directory(&self) -> &Path {
        &self.options.directory
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

    /// Sends the oldest item that is held.
    fn release(&mut self) {
        if let Some(item) = self.held.pop_front() {
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

/// Number of the interval that `time` \[s\] lies in.
fn tick(time: f64, interval: f64) -> u64 {
    (time / interval + EARLY).floor().max(0.0) as u64
}

/// Whether an output is due at `time` \[s\], the last one being of time `last` \[s\].
fn due(time: f64, interval: f64, last: Option<&f64>) -> bool {
    last.is_none_or(|&last| {
        if interval > 0.0 {
            tick(time, interval) > tick(last, interval)
        } else {
            time > last
        }
    })
}

/// The thread's side: owns the files.
struct Disk {
    precision: Precision,
    series: [Collection; 3],
    history: Table,
    status: Arc<Mutex<Status>>,
}

impl Disk {
    fn serve(mut self, messages: &Receiver<Message>) {
        while let Ok(message) = messages.recv() {
            let outcome = match message {
                Message::Write(Item::Frame {
                    number,
                    time,
                    grids,
                }) => self.frame(number, time, &grids),
                Message::Write(Item::Row(values)) => self.history.push(&values).map(|()| {
                    lock(&self.status).rows += 1;
                }),
                Message::Rollback(time) => self.rollback(time),
                Message::Flush(done) => {
                    // Nobody waiting any more is no failure.
                    let _ = done.send(());
                    Ok(())
                }
            };
            if let Err(error) = outcome {
                fail(&self.status, &error.to_string());
            }
        }
    }

    fn frame(
        &mut self,
        number: u64,
        time: f64,
        grids: &[(Series, Grid)],
    ) -> Result<(), OutputError> {
        for (series, grid) in grids {
            let file = format!("{}_{number:06}.vtu", series.name());
            let bytes = encode(grid, time, self.precision, &file)?;
            self.series[*series as usize].push(time, &file, &bytes)?;
        }
        lock(&self.status).frames += 1;
        Ok(())
    }

    fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        for series in &mut self.series {
            series.rollback(time)?;
        }
        self.history.rollback(time)
    }
}

fn lock(status: &Mutex<Status>) -> MutexGuard<'_, Status> {
    status.lock().unwrap_or_else(PoisonError::into_inner)
}

fn fail(status: &Mutex<Status>, what: &str) {
    let mut status = lock(status);
    status.failures += 1;
    status.first_failure.get_or_insert_with(|| what.to_owned());
}

/// Refuses or removes the files of an earlier run; files of other names stay.
fn clear(directory: &Path, overwrite: bool) -> Result<(), OutputError> {
    let mut old: Vec<String> = fs::read_dir(directory)
        .and_then(|entries| {
            entries
                .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
                .collect::<Result<Vec<String>, std::io::Error>>()
        })
        .map_err(OutputError::io("list", directory))?;
    old.retain(|name| is_result(name));
    // Collections before the frames they list: a kill in between leaves no dangling name.
    old.sort_by_key(|name| (!name.contains(".pvd"), name.clone()));
    if let Some(found) = old.first()
        && !overwrite
    {
        return Err(OutputError::Exists {
            path: directory.to_path_buf(),
            found: found.clone(),
        });
    }
    for name in old {
        let path = directory.join(name);
        fs::remove_file(&path).map_err(OutputError::io("remove", &path))?;
    }
    Ok(())
}

/// Whether a file name is one of those a run writes.
fn is_result(name: &str) -> bool {
    let name = name.strip_suffix(".tmp").unwrap_or(name);
    let of_series = |name: &str| {
        Series::ALL.iter().any(|series| {
            name.strip_prefix(series.name()).is_some_and(|rest| {
                let number = rest.strip_prefix('_').and_then(|r| r.strip_suffix(".vtu"));
                rest == ".pvd" || number.is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()))
            })
        })
    };
    matches!(name, "run.json" | "history.csv" | "view.py") || of_series(name)
}

/// The text of `run.json`.
fn describe(scene: &Scene, options: &Options, path: &Path) -> Result<Vec<u8>, OutputError> {
    let refuse =
        |error: serde_json::Error| OutputError::io("describe the run in", path)(error.into());
    let about = json!({
        "generator": env!("CARGO_PKG_NAME"),
        "version": env!("CARGO_PKG_VERSION"),
        "title": scene.title,
        "scene_hash": scene.hash,
        "spheres": scene.particles.len(),
        "materials": scene.materials.iter().map(|m| &m.name).collect::<Vec<_>>(),
        "boundaries": scene.boundaries.iter().map(|b| &b.name).collect::<Vec<_>>(),
        "settings": scene.settings,
        "output": {
            "frame_interval": options.frame_interval,
            "row_interval": options.row_interval,
            "float64": options.precision == Precision::Double,
        },
    });
    serde_json::to_vec_pretty(&about).map_err(refuse)
}
