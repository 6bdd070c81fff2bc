//! `sphere-dda verify -o DIR`: laws of granular matter, measured and written as a report.

use clap::Args;
use sphere_dda_studies::laws::{self, Options};

use crate::arguments::positive;
use crate::failure::Failure;
use crate::progress::Interrupt;
use crate::study::{self, Destination};

/// Arguments of `verify`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda verify -o verification-report

Measured: the stress in a silo (Janssen), the rate through orifices (Beverloo), the run-out of collapsing columns (Lube), the angle
of repose, the friction angle in triaxial compression. Written to DIR: verification.md, and in verification/ its plots (SVG) and tables (CSV). Takes about three
quarters of an hour of CPU time; what it writes does not depend on the machine's speed or load. Ctrl-C ends it without writing anything.")]
pub(crate) struct Verify {
    #[command(flatten)]
    destination: Destination,
    /// Share of the grains: a trial.
    #[arg(long, value_name = "SHARE", value_parser = positive, default_value_t = 1.0, hide = true)]
    share: f64,
}

/// Measures the laws and writes the report.
///
/// # Errors
/// A folder that cannot be used, a case that does not run, or Ctrl-C.
pub(crate) fn run(arguments: &Verify, interrupt: &Interrupt) -> Result<(), Failure> {
    let share = arguments.share.min(1.0);
    study::write(
        &arguments.destination,
        "verification.md",
        interrupt,
        |threads, watch| laws::study(&Options { share, threads }, watch),
    )
}
