//! Why there is no FMU.

use std::io;
use std::path::PathBuf;

use sphere_dda_fmi_interface::archive::ArchiveError;
use sphere_dda_model_description::Finding;
use thiserror::Error;

use super::{BUILD_ID, LIBRARY_VARIABLE};
use crate::model::ModelError;

/// Why there is no FMU.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The scene makes no model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The model description breaks rules of the standard: a name of the scene, as a rule.
    #[error("the model description would be invalid: {}", list(.0))]
    Invalid(Vec<Finding>),
    /// No library to pack.
    #[error(
        "found no {name} in {}; run `cargo build --release -p sphere-dda-fmu`, or name the library with --library or {LIBRARY_VARIABLE}",
        places(.searched)
    )]
    NoLibrary {
        /// File name looked for.
        name: String,
        /// Folders searched.
        searched: Vec<PathBuf>,
    },
    /// No library of another platform, or none built apart.
    #[error(
        "found no {name} for {platform} in {}; run `fmu/platforms/build {platform}`, which builds it there",
        places(.searched)
    )]
    NoLibraryFor {
        /// Name of the platform.
        platform: &'static str,
        /// File name looked for.
        name: String,
        /// Folders searched.
        searched: Vec<PathBuf>,
    },
    /// A library of another platform that was built from other sources than this program.
    #[error(
        "`{}` is not of build {BUILD_ID}: it is older or newer than this program; run `fmu/platforms/build {platform}`",
        path.display()
    )]
    StaleFor {
        /// Name of the platform.
        platform: &'static str,
        /// Its path.
        path: PathBuf,
    },
    /// The library cannot be loaded.
    #[error("cannot load `{}`: {reason}; expected the library of sphere-dda for this platform", path.display())]
    Load {
        /// Its path.
        path: PathBuf,
        /// What the loader says.
        reason: String,
    },
    /// The library was built from other sources than this program.
    #[error(
        "`{}` has build id {found}, expected {BUILD_ID}: it is older or newer than this program; run `cargo build --release -p sphere-dda-fmu`",
        path.display()
    )]
    Stale {
        /// Its path.
        path: PathBuf,
        /// Its build id.
        found: String,
    },
    /// A file of the scene would overwrite another one in the archive.
    #[error("the scene refers to a file named `{0}`, which the FMU needs for itself; rename it")]
    Reserved(String),
    /// The library cannot be read.
    #[error("cannot read `{}`: {source}", path.display())]
    Read {
        /// Its path.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// The archive cannot be written.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
}

fn list(findings: &[Finding]) -> String {
    findings
        .iter()
        .map(Finding::to_string)
        .collect::<Vec<_>>()
        .join("; ")
}

fn places(folders: &[PathBuf]) -> String {
    folders
        .iter()
        .map(|f| format!("`{}`", f.display()))
        .collect::<Vec<_>>()
        .join(", ")
}
