//! Laws of granular matter, measured on beds of some thousand grains: what closed forms of a few bodies cannot show.

mod bed;
pub mod beverloo;
pub mod collapse;
pub mod fit;
pub mod janssen;
pub mod repose;
mod sections;
mod study;
pub mod triaxial;

pub use study::Options;

use bed::Cost;
use study::Study;

use crate::Watch;
use crate::error::ReportError;
use crate::folder::Folder;

/// Runs the study and writes it: `verification.md`, and below `verification/` its plots (SVG) and tables (CSV).
///
/// # Errors
/// What a case says, or [`ReportError::Interrupted`].
pub fn study(options: &Options, watch: &dyn Watch) -> Result<Folder, ReportError> {
    let (share, threads) = (options.share, options.threads);
    watch.plan(Cost::sum(&[
        janssen::COST,
        repose::COST,
        collapse::COST,
        beverloo::FILLING,
        beverloo::OUTFLOW,
        triaxial::COMPACTING,
        triaxial::TEST,
    ]));
    sections::write(&Study {
        share,
        janssen: janssen::run(share, watch)?,
        repose: repose::run(share, threads, watch)?,
        collapse: collapse::run(share, threads, watch)?,
        beverloo: beverloo::run(share, threads, watch)?,
        triaxial: triaxial::run(share, threads, watch)?,
    })
}
