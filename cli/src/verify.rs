//! `sphere-dda verify X.fmu`: the smoke tests that an FMU brings along. `sphere-dda verify -o DIR`: laws of granular matter,
//! measured and written as a report.

mod replay;

use std::path::PathBuf;

use clap::{ArgGroup, Args};
use sphere_dda_studies::laws::{self, Options};

use crate::arguments::positive;
use crate::failure::Failure;
use crate::progress::Interrupt;
use crate::study::{self, Destination};

/// Arguments of `verify`.
#[derive(Debug, Args)]
#[command(group(ArgGroup::new("what").required(true).args(["fmu", "output"])))]
#[command(after_help = "\
Examples:
  sphere-dda verify hopper.fmu                 made with `export --smoke-test`, or any FMU with FMI-LS-REF
  sphere-dda verify -o verification-report

Of an FMU: the checksums of its files, and each of its smoke tests run again: exit code 2 if files were changed, 1 if results are not those
expected.

Measured with -o: the stress in a silo (Janssen), the rate through orifices (Beverloo), the run-out of collapsing columns (Lube), the angle
of repose, the friction angle in triaxial compression. Written to DIR: verification.md, and in verification/ its plots (SVG) and tables (CSV). Takes about three
quarters of an hour of CPU time; what it writes does not depend on the machine's speed or load. Ctrl-C ends it without writing anything.")]
pub(crate) struct Verify {
    /// The FMU to check.
    #[arg(value_name = "FMU")]
    fmu: Option<PathBuf>,
    #[command(flatten)]
    destination: Option<Destination>,
    /// Share of the grains: a trial.
    #[arg(long, value_name = "SHARE", value_parser = positive, default_value_t = 1.0, hide = true)]
    share: f64,
}

/// Checks an FMU, or measures the laws and writes the report.
///
/// # Errors
/// As [`replay::run`]; a folder that cannot be used, a case that does not run, or Ctrl-C.
pub(crate) fn run(arguments: &Verify, interrupt: &Interrupt) -> Result<(), Failure> {
    let share = arguments.share.min(1.0);
    let destination = match (&arguments.fmu, &arguments.destination) {
        (Some(fmu), _) => return replay::run(fmu, interrupt),
        (None, Some(destination)) => destination,
        // Clap asks for one of them.
        (None, None) => return Ok(()),
    };
    study::write(
        destination,
        "verification.md",
        interrupt,
        |threads, watch| laws::study(&Options { share, threads }, watch),
    )
}
