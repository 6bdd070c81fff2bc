//! Laws of granular matter, measured on beds of some thousand grains: what closed forms of a few bodies cannot show.

mod bed;
pub mod beverloo;
pub mod collapse;
pub mod fit;
pub mod janssen;
pub mod repose;
mod sections;
pub mod triaxial;

use crate::Watch;
use crate::error::ReportError;
use crate::folder::Folder;

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Share of the grains, 0 to 1; below 1 it is a trial, and the report says so.
    pub share: f64,
    /// Threads; they do not change the report.
    pub threads: usize,
}

/// All that was measured.
#[derive(Debug, Clone)]
pub(crate) struct Study {
    share: f64,
    janssen: janssen::Janssen,
    beverloo: beverloo::Beverloo,
    collapse: collapse::Collapse,
    repose: Vec<repose::Slope>,
    triaxial: Vec<triaxial::Test>,
}

/// Runs the study and writes it: `verification.md`, and below `verification/` its plots (SVG) and tables (CSV).
///
/// # Errors
/// What a case says, or [`ReportError::Interrupted`].
pub fn study(options: &Options, watch: &dyn Watch) -> Result<Folder, ReportError> {
    let (share, threads) = (options.share, options.threads);
    sections::write(&Study {
        share,
        janssen: janssen::run(share, watch)?,
        repose: repose::run(share, threads, watch)?,
        collapse: collapse::run(share, threads, watch)?,
        beverloo: beverloo::run(share, threads, watch)?,
        triaxial: triaxial::run(share, threads, watch)?,
    })
}
