//! Reports: what the solver does, measured by running it, as Markdown with plots and pictures.
//!
//! [`document`] and [`table`] hold the text, [`folder`] puts it on the disk with the drawings, [`report`] keeps them
//! together, [`parallel`] runs the cases. [`paper`] is the study of Beyabanaki and Bagtzoglou (2020), [`laws`] that of
//! the laws of granular matter, [`corpus`] that of contact problems of others. Nothing in a report depends on
//! the clock, the number of threads or the machine's load.

pub mod corpus;
pub mod document;
pub mod error;
pub mod folder;
pub mod laws;
pub mod paper;
pub mod parallel;
pub mod report;
pub mod table;

/// How a study tells what it does, and is told to end.
pub trait Watch: Sync {
    /// Something has begun or ended.
    fn note(&self, text: &str);
    /// Whether the study shall end now.
    fn stop(&self) -> bool;
}

/// Tells nobody, never stops.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn note(&self, _: &str) {}

    fn stop(&self) -> bool {
        false
    }
}
