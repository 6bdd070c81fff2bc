//! `sphere-dda reproduce-paper -o DIR`: the paper's examples and claims as a report.

use clap::Args;
use sphere_dda_studies::paper::{self, Options};

use crate::arguments::positive;
use crate::failure::Failure;
use crate::progress::Interrupt;
use crate::study::{self, Destination};

/// Arguments of `reproduce-paper`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda reproduce-paper -o paper-report

Written to DIR: paper.md, and in paper/ its plots and pictures (SVG) and tables (CSV). Takes some minutes on two cores; what it
writes does not depend on the machine's speed or load. Ctrl-C ends it without writing anything.")]
pub(crate) struct ReproducePaper {
    #[command(flatten)]
    destination: Destination,
    /// Share of each run's duration: a trial.
    #[arg(long, value_name = "SHARE", value_parser = positive, default_value_t = 1.0, hide = true)]
    duration: f64,
}

/// Runs the study and writes its report.
///
/// # Errors
/// A folder that cannot be used, a case that must run and does not, or Ctrl-C.
pub(crate) fn run(arguments: &ReproducePaper, interrupt: &Interrupt) -> Result<(), Failure> {
    let duration = arguments.duration.min(1.0);
    study::write(
        &arguments.destination,
        "paper.md",
        interrupt,
        |threads, watch| paper::study(&Options { duration, threads }, watch),
    )
}
