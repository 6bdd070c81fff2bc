//! Why a report could not be made.

use std::io;
use std::path::PathBuf;

use sphere_dda::error::StepError;
use sphere_dda::scene_file::SceneError;
use sphere_dda_picture::error::DrawingError;
use thiserror::Error;

/// Why a report could not be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// A scene of the study is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A case that must run does not.
    #[error("{case}: {error}")]
    Step {
        /// Which case.
        case: String,
        /// What the solver says.
        error: StepError,
    },
    /// A number that a drawing needs is missing or not finite.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// A table that cannot be written as CSV.
    #[error("table `{name}`: {reason}")]
    Table {
        /// Which table.
        name: String,
        /// Why.
        reason: String,
    },
    /// The folder holds something already.
    #[error(
        "`{}` is not empty; choose another folder or give --overwrite to replace the files of an earlier report",
        .0.display()
    )]
    Occupied(PathBuf),
    /// The disk refuses.
    #[error("cannot write `{}`: {error}", .path.display())]
    Disk {
        /// Which file or folder.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// Asked to end.
    #[error("interrupted; nothing was written")]
    Interrupted,
}
