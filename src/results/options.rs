//! What is written where, and when.

use crate::formats::vtu::Precision;
use crate::scene::Scene;
use std::path::PathBuf;

/// What is written where, and when.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The directory; created with its parents.
    pub directory: PathBuf,
    /// Replace the files of an earlier run in it.
    pub overwrite: bool,
    /// Seconds between VTU frames \[s\]; 0: none.
    pub frame_interval: f64,
    /// Seconds between rows of the history \[s\]; 0: every communication step.
    pub row_interval: f64,
    /// Precision of the frames.
    pub precision: Precision,
    /// Hold frames and rows back until [`Results::commit`](crate::results::writer::Results::commit) says that they cannot be rolled back any more.
    pub hold: bool,
}

impl Options {
    /// What the scene's `[output]` asks for, into `directory`.
    #[must_use]
    pub fn new(directory: impl Into<PathBuf>, scene: &Scene) -> Self {
        let output = &scene.output;
        Self {
            directory: directory.into(),
            overwrite: false,
            frame_interval: output.vtu_interval,
            row_interval: output.csv_interval,
            precision: if output.float64 {
                Precision::Double
            } else {
                Precision::Single
            },
            hold: false,
        }
    }
}
