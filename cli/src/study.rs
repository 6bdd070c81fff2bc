//! What the commands that write a report have in common: its folder, progress on standard error, Ctrl-C.

use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Instant;

use clap::Args;
use sphere_dda_studies::Watch;
use sphere_dda_studies::error::ReportError;
use sphere_dda_studies::folder::Folder;

use crate::failure::Failure;
use crate::progress::{Interrupt, note, print};

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
    began: Instant,
    /// One line at a time, whichever thread has it.
    line: Mutex<()>,
}

impl Watch for Terminal<'_> {
    fn note(&self, text: &str) {
        let _line = self.line.lock();
        note(format_args!(
            "{:4.0} s  {text}",
            self.began.elapsed().as_secs_f64()
        ));
    }

    fn stop(&self) -> bool {
        self.interrupt.requested()
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
        began: Instant::now(),
        line: Mutex::new(()),
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let report = study(threads, &terminal)?;
    report.write(folder)?;
    print(|out| {
        let (place, files) = (folder.join(name), report.files().count());
        writeln!(out, "report          {}, {files} files", place.display())?;
        let wall = terminal.began.elapsed().as_secs_f64();
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
