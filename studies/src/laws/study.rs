//! What the study of the laws is asked for, and what it finds.

use super::{beverloo, collapse, janssen, repose, triaxial};

/// All that was measured.
#[derive(Debug, Clone)]
pub(crate) struct Study {
    pub(super) share: f64,
    pub(super) janssen: janssen::Janssen,
    pub(super) beverloo: beverloo::Beverloo,
    pub(super) collapse: collapse::Collapse,
    pub(super) repose: Vec<repose::Slope>,
    pub(super) triaxial: Vec<triaxial::Test>,
}

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Share of the grains, 0 to 1; below 1 it is a trial, and the report says so.
    pub share: f64,
    /// Threads; they do not change the report.
    pub threads: usize,
}
