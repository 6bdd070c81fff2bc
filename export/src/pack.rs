//! From a scene file to an FMU archive.
//!
//! ```text
//! modelDescription.xml
//! terminalsAndIcons/terminalsAndIcons.xml   one terminal per boundary
//! binaries/linux64/<identifier>.so      the scene-agnostic library, for each platform; FMI 3.0: binaries/x86_64-linux/
//! resources/scene.toml, meshes, tables  what the instance reads
//! resources/start.state                 the settled spheres, if there are any
//! resources/boundaries.glb              the boundaries as glTF, for viewers: `geometry`
//! documentation/index.html              variables, settings, limits, for people
//! documentation/licenses/               of the library and of all crates it links
//! extra/org.fmi-standard.fmi-ls-ref/    a smoke test and checksums, if it is given: `references`
//! documentation/diagram.png, terminalsAndIcons/icon.png, FMI 2.0: model.png     the scene
//! ```
//!
//! The same scene and library give the same bytes.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::archive;
use sphere_dda_fmi_interface::platform::Platform;
use sphere_dda_model_description::names::is_c_identifier;
use sphere_dda_model_description::{Finding, Severity};

use sphere_dda_fmu::model::{Model, SCENE_FILE, START_FILE};
use sphere_dda_fmu::table::Entry;
use sphere_dda_fmu::version::Version;

use crate::component::{MANIFEST, MANIFEST_FILE, component, core_module};
use crate::description::{version2, version3};
use crate::documentation;
use crate::error::ExportError;
use crate::geometry::{GEOMETRY_FILE, glb};
use crate::library::{Library, find_module};
use crate::references::SmokeTest;
use crate::terminals::terminals;

/// Where FMI 3.0, and FMI 2.0.4, expect the terminals.
const TERMINALS_FILE: &str = "terminalsAndIcons/terminalsAndIcons.xml";

/// Above this number of scalar variables some importers take very long to open the FMU.
const MANY_VARIABLES: usize = 5000;

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

/// What an archive is made of.
#[derive(Debug)]
pub struct Contents<'a> {
    /// The scene file.
    pub scene: &'a Path,
    /// Other defaults of its parameters.
    pub values: &'a [(String, f64)],
    /// What the scene has settled to, see [`sphere_dda::simulation::Settled`].
    pub start: Option<Vec<u8>>,
    /// The libraries, see [`find_libraries`](crate::find_libraries).
    pub libraries: &'a [Library],
    /// Version of the standard.
    pub version: Version,
    /// A run with its results that the FMU brings along.
    pub smoke_test: Option<&'a SmokeTest>,
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
        values,
        start,
        libraries,
        version,
        smoke_test,
        draw,
    } = contents;
    let model = Model::read_with(scene, values, start)?;
    let identifier = identifier(scene);
    let pictures = draw(&model.scene);
    let (mut files, findings) = described(&model, &identifier, version, pictures.is_some())?;
    let own = resources(&model)?;
    for Library { platform, path } in libraries {
        let mut code = read(path)?;
        if *platform == Platform::WASM {
            if version == Version::Two {
                return Err(ExportError::Component2);
            }
            code = component(&code, &by_name(&own))?;
            files.push((MANIFEST_FILE.to_owned(), MANIFEST.as_bytes().into()));
        }
        files.push((library_path(version, platform, &identifier), code.into()));
    }
    let place = |(name, content)| (format!("resources/{name}"), content);
    files.extend(own.into_iter().map(place));
    let components = model.table.entries(Version::Two);
    let shapes = glb(&model.scene, &components);
    files.extend(shapes.map(|shapes| place((GEOMETRY_FILE.to_owned(), shapes.into()))));
    files.extend(documented(&model, version, pictures));
    let mut files: Vec<(String, &[u8])> = files
        .iter()
        .map(|(path, content)| (path.clone(), &**content))
        .collect();
    let proof = smoke_test.map(|test| test.files(&files)).transpose()?;
    let proof = proof.unwrap_or_default();
    files.extend(
        proof
            .iter()
            .map(|(path, content)| (path.clone(), &**content)),
    );
    archive::write(fmu, &files)?;

    let variables = model.table.entries(version).len();
    let mut warnings = model.warnings;
    warnings.extend(findings);
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

/// Path of the library for a platform inside the archive.
fn library_path(version: Version, platform: &Platform, identifier: &str) -> String {
    match version {
        Version::Two => platform.path_2(identifier),
        Version::Three => platform.path_3(identifier),
    }
}

/// Files of an archive, by their paths in it.
type Files<'m> = Vec<(String, Cow<'m, [u8]>)>;

/// Model description and terminals of one version, and warnings about them.
fn described(
    model: &Model,
    identifier: &str,
    version: Version,
    icon: bool,
) -> Result<(Files<'static>, Vec<String>), ExportError> {
    let (scene, table, guid) = (&model.scene, &model.table, &model.guid);
    let (xml, mut findings) = match version {
        Version::Two => {
            let own = version2::describe(scene, table, identifier, guid);
            (own.to_xml(), own.validate())
        }
        Version::Three => {
            let own = version3::describe(scene, table, identifier, guid);
            (own.to_xml(), own.validate())
        }
    };
    let entries = table.entries(version);
    let terminals = terminals(scene, &entries, icon);
    let names: Vec<String> = entries.iter().map(Entry::name).collect();
    findings.extend(terminals.validate(names.iter().map(String::as_str)));
    let warnings = judge(findings)?;
    let xml = xml?.into_bytes();
    let terminals = terminals.to_xml()?.into_bytes();
    let files: Files<'static> = vec![
        ("modelDescription.xml".to_owned(), xml.into()),
        (TERMINALS_FILE.to_owned(), terminals.into()),
    ];
    Ok((files, warnings))
}

/// The findings as warnings, unless one breaks the standard.
fn judge(findings: Vec<Finding>) -> Result<Vec<String>, ExportError> {
    if findings.iter().any(|f| f.severity == Severity::Error) {
        return Err(ExportError::Invalid(findings));
    }
    Ok(findings.iter().map(Finding::to_string).collect())
}

/// The core module of WebAssembly for a model, as its FMU has it in its component: for hosts that need no component.
///
/// # Errors
/// No module beside this program, or one of other sources; files that a scene may not have.
pub fn core_module_of(model: &Model) -> Result<Vec<u8>, ExportError> {
    let code = read(&find_module()?)?;
    Ok(core_module(&code, &by_name(&resources(model)?))?)
}

fn read(path: &Path) -> Result<Vec<u8>, ExportError> {
    fs::read(path).map_err(|source| ExportError::Read {
        path: path.to_path_buf(),
        source,
    })
}

fn by_name<'f>(files: &'f Files<'_>) -> BTreeMap<&'f str, &'f [u8]> {
    let each = files.iter();
    each.map(|(name, content)| (&**name, &**content)).collect()
}

/// What the instance reads, by its path in `resources/`.
fn resources(model: &Model) -> Result<Files<'_>, ExportError> {
    let mut files: Files<'_> = vec![(SCENE_FILE.to_owned(), model.text.as_bytes().into())];
    if let Some(start) = &model.start {
        files.push((START_FILE.to_owned(), start.into()));
    }
    for file in &model.files {
        if [SCENE_FILE, START_FILE, GEOMETRY_FILE].contains(&file.path.as_str()) {
            return Err(ExportError::Reserved(file.path.clone()));
        }
        files.push((file.path.clone(), (&file.content).into()));
    }
    Ok(files)
}

/// What people read.
fn documented(model: &Model, version: Version, pictures: Option<Pictures>) -> Files<'static> {
    let place = |name: &str| format!("documentation/{name}");
    let page = documentation::page(model, version, pictures.is_some()).into_bytes();
    let (own, others) = (documentation::LICENSE, documentation::THIRD_PARTY);
    let mut files: Files<'static> = vec![
        (place("index.html"), page.into()),
        (place("licenses/license.txt"), own.as_bytes().into()),
        (place("licenses/third-party.txt"), others.as_bytes().into()),
    ];
    if let Some(Pictures { icon, page }) = pictures {
        // FMI 3.0 knows the icon only.
        if version == Version::Two {
            files.push(("model.png".to_owned(), icon.clone().into()));
        }
        files.push(("terminalsAndIcons/icon.png".to_owned(), icon.into()));
        files.push((place(documentation::PICTURE_FILE), page.into()));
    }
    files
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_about_a_description_stop_no_export() {
        let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/funnel/funnel.toml");
        let model = Model::read(&scene, None).unwrap();
        let mut two = version2::describe(&model.scene, &model.table, "funnel", &model.guid);
        two.model_structure.outputs.swap(0, 1);
        let warnings = judge(two.validate()).unwrap();
        assert_eq!(warnings.len(), 1);
        assert!(
            warnings[0].contains("ModelStructure/Outputs"),
            "{warnings:?}"
        );
        two.model_structure.outputs.pop();
        assert!(
            matches!(judge(two.validate()), Err(ExportError::Invalid(found)) if found.len() == 2)
        );
    }
}
