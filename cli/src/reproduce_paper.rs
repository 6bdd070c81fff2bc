//! `sphere-dda reproduce-paper -o DIR`: the paper's examples and claims as a report.

use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Instant;

use clap::Args;
use sphere_dda_report::Watch;
use sphere_dda_report::error::ReportError;
use sphere_dda_report::folder::Folder;
use sphere_dda_report::paper::{Options, study};

use crate::failure::Failure;
use crate::progress::{Interrupt, note, print};
use crate::run::positive;

/// Arguments of `reproduce-paper`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda reproduce-paper -o paper-report

Written to DIR: paper.md, and in paper/ its plots and pictures (SVG) and tables (CSV). Takes some minutes on two cores; what it
writes does not depend on the machine's speed or load. Ctrl-C ends it without writing anything.")]
pub(crate) struct ReproducePaper {
    /// Folder for the report.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Replace the files of an earlier report in DIR.
    #[arg(long)]
    overwrite: bool,
    /// Share of each run's duration: a trial.
    #[arg(long, value_name = "SHARE", value_parser = positive, default_value_t = 1.0, hide = true)]
    duration: f64,
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

/// Runs the study and writes its report.
///
/// # Errors
/// A folder that cannot be used, a case that must run and does not, or Ctrl-C.
pub(crate) fn run(arguments: &ReproducePaper, interrupt: &Interrupt) -> Result<(), Failure> {
    Folder::claim(&arguments.output, arguments.overwrite)?;
    let terminal = Terminal {
        interrupt,
        began: Instant::now(),
        line: Mutex::new(()),
    };
    let options = Options {
        duration: arguments.duration.min(1.0),
        threads: std::thread::available_parallelism().map_or(1, usize::from),
    };
    let report = study(&options, &terminal)?;
    report.write(&arguments.output)?;
    print(|out| {
        let place = arguments.output.display();
        writeln!(
            out,
            "report          {place}/paper.md, {} files",
            report.files().count()
        )?;
        writeln!(
            out,
            "wall time       {:.0} s",
            terminal.began.elapsed().as_secs_f64()
        )
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
