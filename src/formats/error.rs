//! What can go wrong when results are written.

use std::path::{Path, PathBuf};

use thiserror::Error;

/// A result file that could not be written.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum OutputError {
    /// The operating system refused.
    #[error("cannot {action} `{}`: {source}; expected a directory that may be written to and has free space: choose another one", path.display())]
    Io {
        /// What was tried, as a verb.
        action: &'static str,
        /// The file or directory.
        path: PathBuf,
        /// The reason given.
        source: std::io::Error,
    },
    /// The directory holds the results of an earlier run.
    #[error("`{}` already holds a run ({found}); choose another directory or allow overwriting", path.display())]
    Exists {
        /// The directory.
        path: PathBuf,
        /// The file that says so.
        found: String,
    },
    /// Another run writes to the directory at this moment.
    #[error("another run is writing to `{}`; wait for its end or choose another directory", path.display())]
    Busy {
        /// The directory.
        path: PathBuf,
    },
    /// The directory holds a run that the present one cannot go on with.
    #[error(
        "`{}` holds another run: {differences}; resume it with its own scene and settings, start a new run in another directory, or use --overwrite", path.display()
    )]
    OtherRun {
        /// The directory.
        path: PathBuf,
        /// What differs, key by key.
        differences: String,
    },
    /// None of the checkpoints can be read.
    #[error("no checkpoint in `{}` can be used: {reasons}; start a new run in another directory, or use --overwrite", path.display())]
    Unusable {
        /// The directory.
        path: PathBuf,
        /// What is wrong with each.
        reasons: String,
    },
    /// A file is not as the run left it.
    #[error(
        "`{}`: found {found}, expected {expected}; the file was changed since the run wrote it: restore it, or start a new run in another directory", path.display()
    )]
    Changed {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        found: String,
        /// What is right.
        expected: String,
    },
    /// A value that readers would show without a word: NaN, infinite, or beyond the range of Float32.
    #[error(
        "{place}: entry {index} of `{array}` is {value}, expected a finite number of the file's precision; the state is broken or needs `float64`"
    )]
    NotFinite {
        /// File or table.
        place: String,
        /// Name of the array or column.
        array: String,
        /// Index of the entry, components counted singly.
        index: usize,
        /// The value.
        value: f64,
    },
    /// Arrays that do not fit each other.
    #[error("{place}: `{array}` has {found} entries, expected {expected}")]
    Shape {
        /// File or table.
        place: String,
        /// Name of the array.
        array: String,
        /// Its length, components counted singly.
        found: usize,
        /// The length that fits.
        expected: usize,
    },
    /// Grids without a cell crash readers.
    #[error("{place}: the grid has no cell, expected at least one")]
    Empty {
        /// File.
        place: String,
    },
}

impl OutputError {
    /// Adds the file and the action to an operating-system error.
    pub(crate) fn io(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::Io {
            action,
            path,
            source,
        }
    }
}
