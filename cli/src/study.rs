//! What the commands that write a report have in common: its folder, progress on standard error, Ctrl-C.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use clap::Args;
use sphere_dda_studies::Watch;
use sphere_dda_studies::error::ReportError;
use sphere_dda_studies::folder::Folder;

use crate::failure::Failure;
use crate::progress::{Interrupt, Progress, print};

/// Where a report goes.
#[derive(Debug, Args)]
pub(crate) struct Destination {
    /// Folder for the report.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Replace the files of an earlier report in DIR.
    #[arg(long)]
    overwrite: bool,
}

/// Progress on standard error, Ctrl-C.
struct Terminal<'a> {
    interrupt: &'a Interrupt,
    work: Mutex<Work>,
}

/// What is behind of all that is expected, one line at a time, whichever thread has it.
struct Work {
    progress: Progress,
    expected: f64,
    spent: f64,
}

impl Watch for Terminal<'_> {
    fn note(&self, text: &str) {
        let work = self.work();
        let wall = work.progress.wall_time();
        work.progress.note(format_args!("{wall:4.0} s  {text}"));
    }

    fn plan(&self, cost: f64) {
        self.work().expected = cost;
    }

    fn spent(&self, cost: f64) {
        let work = &mut *self.work();
        work.spent += cost;
        work.progress.share(work.spent / work.expected);
    }

    fn stop(&self) -> bool {
        self.interrupt.requested()
    }
}

impl Terminal<'_> {
    fn work(&self) -> MutexGuard<'_, Work> {
        // Who panicked with it left numbers that are sound.
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Makes the report `NAME.md` by `study`, which gets the number of threads, and writes it to its folder.
///
/// # Errors
/// A folder that cannot be used, a case that must run and does not, or Ctrl-C.
pub(crate) fn write(
    destination: &Destination,
    name: &str,
    interrupt: &Interrupt,
    study: impl FnOnce(usize, &dyn Watch) -> Result<Folder, ReportError>,
) -> Result<(), Failure> {
    let folder = &destination.output;
    Folder::claim(folder, destination.overwrite)?;
    let terminal = Terminal {
        interrupt,
        work: Mutex::new(Work {
            progress: Progress::counted(),
            expected: f64::INFINITY,
            spent: 0.0,
        }),
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let report = study(threads, &terminal)?;
    report.write(folder)?;
    let wall = terminal.work().progress.wall_time();
    drop(terminal);
    print(|out| {
        let (place, files) = (folder.join(name), report.files().count());
        writeln!(out, "report          {}, {files} files", place.display())?;
        writeln!(out, "wall time       {wall:.0} s")
    })
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Interrupted => Self::Interrupted,
            ReportError::Scene(scene) => scene.into(),
            ReportError::Occupied(_) | ReportError::Disk { .. } => Self::input(error),
            _ => Self::run(error),
        }
    }
}
