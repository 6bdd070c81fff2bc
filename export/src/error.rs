//! Why there is no FMU.

use std::io;
use std::path::PathBuf;

use sphere_dda_fmi_interface::archive::ArchiveError;
use sphere_dda_fmu::model::ModelError;
use sphere_dda_fmu::version::BUILD_ID;
use sphere_dda_model_description::Finding;
use thiserror::Error;

/// Environment variable that names the library to pack.
pub const LIBRARY_VARIABLE: &str = "SPHERE_DDA_LIBRARY";

/// Why there is no FMU.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The scene makes no model.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A name or title does not fit into XML.
    #[error("model description: {0}; change the name or title in the scene")]
    Description(#[from] sphere_dda_model_description::Error),
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
    /// A library that was built from other sources than this program.
    #[error(
        "`{}` is not of build {BUILD_ID}: it is older or newer than this program; run `{mend}`",
        path.display()
    )]
    Stale {
        /// Its path.
        path: PathBuf,
        /// The command that builds it.
        mend: String,
    },
    /// A component in an FMU of FMI 2.0.
    #[error("platform wasm: FMI 2.0 has no components of WebAssembly; expected `--fmi 3`")]
    Component2,
    /// There is no component.
    #[error(transparent)]
    Component(#[from] crate::component::ComponentError),
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
