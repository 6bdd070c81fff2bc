//! From a scene file to an FMU archive.
//!
//! ```text
//! modelDescription.xml
//! terminalsAndIcons/terminalsAndIcons.xml   one terminal per boundary
//! binaries/linux64/<identifier>.so      the scene-agnostic library; FMI 3.0: binaries/x86_64-linux/
//! resources/scene.toml, meshes, tables  what the instance reads
//! resources/start.state                 the settled spheres, if there are any
//! documentation/index.html              variables, settings, limits, for people
//! documentation/licenses/               of the library and of all crates it links
//! model.png, documentation/scene.png, terminalsAndIcons/icon.png    the scene
//! ```
//!
//! The same scene and library give the same bytes.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::archive::{self, ArchiveError};
use sphere_dda_model_description::Finding;
use sphere_dda_model_description::names::is_c_identifier;
use thiserror::Error;

use crate::description::{describe, version3};
use crate::documentation;
use crate::model::{Model, ModelError, SCENE_FILE, START_FILE};
use crate::terminals::terminals;

/// Environment variable that names the library to pack.
pub const LIBRARY_VARIABLE: &str = "SPHERE_DDA_LIBRARY";

/// Hash of the sources this crate was built from; the library exports its own as `sphere_dda_build_id`.
pub const BUILD_ID: &str = env!("SPHERE_DDA_BUILD_ID");

/// Where FMI 3.0, and FMI 2.0.4, expect the terminals.
const TERMINALS_FILE: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// Above this number of scalar variables some importers take very long to open the FMU.
const MANY_VARIABLES: usize = 5000;

/// Version of the standard that an FMU keeps to. The library in it is the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Version {
    /// FMI 2.0: scalars.
    #[default]
    Two,
    /// FMI 3.0: arrays.
    Three,
}

impl Version {
    fn library_path(self, identifier: &str) -> String {
        match self {
            Self::Two => archive::library_path(identifier),
            Self::Three => archive::library_path_3(identifier),
        }
    }
}

/// Pictures of a scene, PNG; whoever exports draws them, so that the library needs no drawing code.
#[derive(Debug, Clone)]
pub struct Pictures {
    /// About 100 x 100 px, for `model.png` and the icon.
    pub icon: Vec<u8>,
    /// For the documentation.
    pub page: Vec<u8>,
}

/// What was packed.
#[derive(Debug, Clone)]
pub struct Exported {
    /// Fingerprint of the model.
    pub guid: String,
    /// Name of the library in the archive.
    pub identifier: String,
    /// Number of variables.
    pub variables: usize,
    /// Findings that did not stop the export.
    pub warnings: Vec<String>,
}

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

/// What an archive is made of.
#[derive(Debug)]
pub struct Contents<'a> {
    /// The scene file.
    pub scene: &'a Path,
    /// What the scene has settled to, see [`sphere_dda::simulation::Settled`].
    pub start: Option<Vec<u8>>,
    /// The library, see [`find_library`].
    pub library: &'a Path,
    /// Version of the standard.
    pub version: Version,
    /// Draws the scene as it starts; without pictures the FMU has none.
    pub draw: fn(&Scene) -> Option<Pictures>,
}

/// Packs the contents into the archive `fmu`, replacing it when all is done.
///
/// # Errors
/// [`ExportError`]; no half-written archive is left.
pub fn export(contents: Contents<'_>, fmu: &Path) -> Result<Exported, ExportError> {
    let Contents {
        scene,
        start,
        library,
        version,
        draw,
    } = contents;
    let model = Model::read(scene, start)?;
    let identifier = identifier(scene);
    let pictures = draw(&model.scene);
    let texts = described(&model, &identifier, version, pictures.is_some())?;
    if !texts.findings.is_empty() {
        return Err(ExportError::Invalid(texts.findings));
    }
    check_library(library)?;
    let code = fs::read(library).map_err(|source| ExportError::Read {
        path: library.to_path_buf(),
        source,
    })?;
    let library = version.library_path(&identifier);
    let page = documentation::page(&model, version, pictures.is_some());
    pack(
        &model,
        &texts,
        &page,
        pictures.as_ref(),
        (library, &code),
        fmu,
    )?;

    let variables = match version {
        Version::Two => model.table.variables().len(),
        Version::Three => model.arrays.list().len(),
    };
    let mut warnings = model.warnings;
    if variables > MANY_VARIABLES {
        warnings.push(format!("{variables} variables: some importers take long above {MANY_VARIABLES}; probe fewer spheres"));
    }
    Ok(Exported {
        guid: model.guid,
        identifier,
        variables,
        warnings,
    })
}

/// The XML files of an archive, and what is wrong with them.
struct Texts {
    description: String,
    terminals: String,
    findings: Vec<Finding>,
}

/// Model description and terminals of one version.
fn described(
    model: &Model,
    identifier: &str,
    version: Version,
    icon: bool,
) -> Result<Texts, ModelError> {
    let (xml, mut findings, names) = match version {
        Version::Two => {
            let own = describe(&model.scene, &model.table, identifier, &model.guid);
            let names = model.table.variables().iter().map(|v| v.name.as_str());
            (own.to_xml()?, own.validate(), names.collect::<Vec<_>>())
        }
        Version::Three => {
            let own = version3::describe(&model.scene, &model.arrays, identifier, &model.guid);
            let names = model.arrays.list().iter().map(|a| a.name.as_str());
            (own.to_xml()?, own.validate(), names.collect())
        }
    };
    let terminals = terminals(&model.scene, &names, icon);
    findings.extend(terminals.validate(names));
    Ok(Texts {
        description: xml,
        terminals: terminals.to_xml()?,
        findings,
    })
}

fn pack(
    model: &Model,
    texts: &Texts,
    html: &str,
    pictures: Option<&Pictures>,
    library: (String, &[u8]),
    fmu: &Path,
) -> Result<(), ExportError> {
    let mut files: Vec<(String, &[u8])> = vec![
        (
            "modelDescription.xml".to_owned(),
            texts.description.as_bytes(),
        ),
        (TERMINALS_FILE.to_owned(), texts.terminals.as_bytes()),
        library,
        (format!("resources/{SCENE_FILE}"), model.text.as_bytes()),
        ("documentation/index.html".to_owned(), html.as_bytes()),
        (
            "documentation/licenses/license.txt".to_owned(),
            documentation::LICENSE.as_bytes(),
        ),
        (
            "documentation/licenses/third-party.txt".to_owned(),
            documentation::THIRD_PARTY.as_bytes(),
        ),
    ];
    if let Some(Pictures { icon, page }) = pictures {
        files.push(("model.png".to_owned(), icon));
        files.push(("terminalsAndIcons/icon.png".to_owned(), icon));
        files.push((
            format!("documentation/{}", documentation::PICTURE_FILE),
            page,
        ));
    }
    if let Some(start) = &model.start {
        files.push((format!("resources/{START_FILE}"), start));
    }
    for file in &model.files {
        if [SCENE_FILE, START_FILE].contains(&file.path.as_str()) {
            return Err(ExportError::Reserved(file.path.clone()));
        }
        files.push((format!("resources/{}", file.path), &file.content));
    }
    Ok(archive::write(fmu, &files)?)
}

/// The scene file's name as a C identifier.
fn identifier(scene: &Path) -> String {
    let stem = scene.file_stem().unwrap_or_default().to_string_lossy();
    let name: String = stem
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    if is_c_identifier(&name) {
        name
    } else {
        format!("scene_{name}")
    }
}

/// The library to pack: `explicit`, else the environment variable [`LIBRARY_VARIABLE`], else beside this program or in
/// its `deps` folder, where one that fits this program comes first.
///
/// # Errors
/// [`ExportError::NoLibrary`].
pub fn find_library(explicit: Option<&Path>) -> Result<PathBuf, ExportError> {
    let name = format!(
        "{}sphere_dda_fmu{}",
        env::consts::DLL_PREFIX,
        env::consts::DLL_SUFFIX
    );
    let named = explicit
        .map(Path::to_path_buf)
        .or_else(|| env::var_os(LIBRARY_VARIABLE).map(OsString::into));
    if let Some(path) = named {
        let missing = || ExportError::NoLibrary {
            name: path.display().to_string(),
            searched: vec![path.clone()],
        };
        return if path.is_file() {
            Ok(path)
        } else {
            Err(missing())
        };
    }
    let own = env::current_exe()
        .ok()
        .and_then(|exe| exe.parent().map(Path::to_path_buf))
        .unwrap_or_default();
    // Tests and examples run from below the folder that has the library.
    let mut searched = vec![own.clone(), own.join("deps")];
    searched.extend(own.parent().map(Path::to_path_buf));
    let mut found: Vec<PathBuf> = searched
        .iter()
        .map(|folder| folder.join(&name))
        .filter(|path| path.is_file())
        .collect();
    if found.is_empty() {
        return Err(ExportError::NoLibrary { name, searched });
    }
    // Cargo may leave an old copy beside the program and put the new one into `deps`.
    let fresh = found.iter().position(|path| check_library(path).is_ok());
    Ok(found.swap_remove(fresh.unwrap_or(0)))
}

/// Loads a library once and refuses one that was not built from the sources of this program.
///
/// # Errors
/// [`ExportError::Load`], [`ExportError::Stale`].
pub fn check_library(path: &Path) -> Result<(), ExportError> {
    let load = |error: libloading::Error| ExportError::Load {
        path: path.to_path_buf(),
        reason: error.to_string(),
    };
    let found = crate::ffi::build_id(path).map_err(load)?;
    if found == BUILD_ID {
        return Ok(());
    }
    Err(ExportError::Stale {
        path: path.to_path_buf(),
        found,
    })
}
