//! Why there is no page.

use sphere_dda::results::folder::FolderError;
use thiserror::Error;

/// Why there is no page.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ViewError {
    /// The results cannot be read.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A frame is not as a run writes it.
    #[error("frame at {time} s: {what} is {found}, expected {expected}; run the scene again")]
    Frame {
        /// Time \[s\].
        time: f64,
        /// Which part.
        what: String,
        /// What was found.
        found: String,
        /// What can be shown.
        expected: String,
    },
    /// A table of plots cannot be read.
    #[error("table `{path}`: found {found}, expected {expected}")]
    Table {
        /// The file.
        path: String,
        /// What was found.
        found: String,
        /// What can be plotted.
        expected: &'static str,
    },
    /// Even one frame is larger than asked for.
    #[error(
        "one frame alone makes a page of {least} bytes, expected at most {limit}: allow more by --max-size"
    )]
    Size {
        /// Bytes of the smallest page.
        least: u64,
        /// What was asked for.
        limit: u64,
    },
}
