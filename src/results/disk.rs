//! The files of a run, and the thread that owns them.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, SyncSender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::checkpoint::Checkpoint;
use super::directory::Directory;
use super::frames::Series;
use super::history::columns;
use crate::communication_points::due;
use crate::formats::error::OutputError;
use crate::formats::pvd::Collection;
use crate::formats::table::Table;
use crate::formats::vtu::{Grid, Precision, encode};
use crate::scene::Scene;

/// What has reached the disk.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Status {
    /// Frames written, overwritten ones counted again; those of a run that is resumed were written before.
    pub frames: u64,
    /// Rows written, likewise.
    pub rows: u64,
    /// Frames, rows, checkpoints or rollbacks that failed.
    pub failures: u64,
    /// The first failure, in words.
    pub first_failure: Option<String>,
}

/// A frame or a row for the disk.
pub(super) enum Item {
    Frame {
        number: u64,
        time: f64,
        grids: Vec<(Series, Grid)>,
    },
    Row(Vec<f64>),
}

impl Item {
    /// \[s\].
    pub(super) fn time(&self) -> f64 {
        match self {
            Self::Frame { time, .. } => *time,
            Self::Row(values) => values[0],
        }
    }
}

/// What the thread is asked to do, in this order.
pub(super) enum Message {
    Write(Item),
    Rollback(f64),
    Checkpoint(Checkpoint),
    Flush(SyncSender<()>),
}

/// The files of a run.
pub(super) struct Disk {
    directory: Directory,
    precision: Precision,
    /// Of [`Series::ALL`].
    series: Vec<Collection>,
    history: Table,
    status: Arc<Mutex<Status>>,
}

impl Disk {
    /// Files of a new run.
    pub(super) fn create(
        directory: Directory,
        scene: &Scene,
        precision: Precision,
    ) -> Result<Self, OutputError> {
        let path = directory.path();
        Ok(Self {
            precision,
            series: Series::ALL
                .map(|series| Collection::new(collection(path, series)))
                .into(),
            history: Table::create(&path.join(HISTORY), columns(scene))?,
            status: Arc::default(),
            directory,
        })
    }

    /// Files of an earlier run, as they are.
    pub(super) fn open(
        directory: Directory,
        scene: &Scene,
        precision: Precision,
    ) -> Result<Self, OutputError> {
        let path = directory.path();
        let series = Series::ALL.map(|series| Collection::open(collection(path, series)));
        Ok(Self {
            precision,
            series: series.into_iter().collect::<Result<_, _>>()?,
            history: Table::open(&path.join(HISTORY), columns(scene))?,
            status: Arc::default(),
            directory,
        })
    }

    /// The directory.
    pub(super) fn directory(&self) -> &Directory {
        &self.directory
    }

    /// Shared with whoever wants to know how it goes.
    pub(super) fn status(&self) -> Arc<Mutex<Status>> {
        Arc::clone(&self.status)
    }

    /// Times \[s\] of the rows.
    pub(super) fn rows(&self) -> Vec<f64> {
        self.history.times().collect()
    }

    /// Times \[s\] of the frames of a series.
    pub(super) fn frames(&self, series: Series) -> Vec<f64> {
        self.series[series as usize].times().collect()
    }

    /// Time \[s\] of the last row or frame.
    pub(super) fn latest(&self) -> Option<f64> {
        let frames = self.series.iter().flat_map(Collection::times);
        self.history.times().chain(frames).reduce(f64::max)
    }

    /// Refuses files in which a row or a frame is missing that was due up to `time` \[s\].
    ///
    /// # Errors
    /// [`OutputError::Changed`].
    pub(super) fn expect_up_to(
        &self,
        time: f64,
        row_interval: f64,
        frame_interval: f64,
        shown: &[Series],
    ) -> Result<(), OutputError> {
        let check = |path: PathBuf, interval: f64, times: Vec<f64>| {
            let last = times.into_iter().rfind(|&t| t <= time);
            if !due(time, interval, last) {
                return Ok(());
            }
            let found = last.map_or("no entry".to_owned(), |t| {
                format!("{t} s as the last entry")
            });
            let expected = format!("the entries up to {time} s");
            Err(OutputError::Changed {
                path,
                found,
                expected,
            })
        };
        let directory = self.directory.path();
        check(directory.join(HISTORY), row_interval, self.rows())?;
        for &series in shown.iter().filter(|_| frame_interval > 0.0) {
            let path = collection(directory, series);
            check(path, frame_interval, self.frames(series))?;
        }
        Ok(())
    }

    /// Drops what is later than `time` \[s\] and what a killed run has left behind.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(super) fn rewind(&mut self, time: f64, shown: &[Series]) -> Result<(), OutputError> {
        self.rollback(time)?;
        let listed: Vec<&str> = self.series.iter().flat_map(Collection::files).collect();
        self.directory.sweep(&listed)?;
        let frames = shown.first().map_or(0, |&series| self.frames(series).len());
        let mut status = lock(&self.status);
        (status.frames, status.rows) = (frames as u64, self.history.times().count() as u64);
        Ok(())
    }

    /// Handles messages until all senders are gone; returns a permit after each frame.
    pub(super) fn serve(mut self, messages: &Receiver<Message>, written: &SyncSender<()>) {
        while let Ok(message) = messages.recv() {
            let outcome = match message {
                Message::Write(Item::Frame {
                    number,
                    time,
                    grids,
                }) => {
                    let outcome = self.frame(number, time, &grids);
                    drop(grids);
                    // Nobody who waits to send another is no failure.
                    let _ = written.send(());
                    outcome
                }
                Message::Write(Item::Row(values)) => self.history.push(&values).map(|()| {
                    lock(&self.status).rows += 1;
                }),
                Message::Rollback(time) => self.rollback(time),
                Message::Checkpoint(checkpoint) => self.checkpoint(&checkpoint),
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

    fn checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), OutputError> {
        if lock(&self.status).failures > 0 {
            // Whoever goes on from an earlier one writes again what is missing.
            return Ok(());
        }
        for series in &mut self.series {
            series.sync()?;
        }
        self.history.sync()?;
        self.directory.sync()?;
        checkpoint.write(&self.directory)
    }
}

const HISTORY: &str = "history.csv";

fn collection(directory: &Path, series: Series) -> PathBuf {
    directory.join(format!("{}.pvd", series.name()))
}

pub(super) fn lock(status: &Mutex<Status>) -> MutexGuard<'_, Status> {
    status.lock().unwrap_or_else(PoisonError::into_inner)
}

pub(super) fn fail(status: &Mutex<Status>, what: &str) {
    let mut status = lock(status);
    status.failures += 1;
    status.first_failure.get_or_insert_with(|| what.to_owned());
}
