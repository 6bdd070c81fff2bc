//! Pages of `view`, also where another verb ends with one.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::miette;
use sphere_dda::observe::Observation;
use sphere_dda::results::folder::{Folder, Frame};
use sphere_dda::results::frames::Surface;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda_fmu::model::{Model, SCENE_FILE};
use sphere_dda_fmu::table::{Binding, Table as Variables};
use sphere_dda_master::Fmu;
use sphere_dda_picture::viewer::labels::labels;
use sphere_dda_picture::viewer::{Detail, Options, Page, Recording, Table, ViewError, page};

use crate::draft::Draft;
use crate::failure::Failure;
use crate::progress::{Progress, count, note};

/// Name of the page in a result folder.
pub(crate) const NAME: &str = "view.html";
/// Largest page unless asked for otherwise \[bytes\].
pub(crate) const MAX_SIZE: u64 = 50_000_000;

impl From<ViewError> for Failure {
    fn from(error: ViewError) -> Self {
        Self::input(error)
    }
}

/// The recording of a result folder, with what its `run.json` says, its history and other `tables`.
///
/// # Errors
/// A folder that no run wrote, a table that cannot be read.
pub(crate) fn of_folder(
    folder: &Path,
    tables: &[PathBuf],
) -> Result<(Recording, Options), Failure> {
    let folder = Folder::open(folder).map_err(Failure::input)?;
    let names = |key: &str| -> Vec<String> {
        let list = folder.about()[key].as_array();
        let list = list.into_iter().flatten();
        list.filter_map(|name| name.as_str().map(str::to_owned))
            .collect()
    };
    let history = folder.history();
    let tables = history
        .iter()
        .chain(tables)
        .map(|path| Table::from_csv(path));
    let options = Options {
        title: folder.about()["title"]
            .as_str()
            .unwrap_or_default()
            .to_owned(),
        materials: names("materials"),
        boundaries: names("boundaries"),
        tables: tables.collect::<Result<_, _>>()?,
        ..Options::default()
    };
    Ok((Recording::Folder(folder), options))
}

/// What is to be shown.
pub(crate) enum Input {
    /// A result folder.
    Folder,
    /// A scene file.
    Scene,
    /// An FMU.
    Fmu,
}

/// What lies at a path, by its kind and ending.
///
/// # Errors
/// Nothing lies there, or something else.
pub(crate) fn kind(input: &Path) -> Result<Input, Failure> {
    let ends = |with: &str| {
        input
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case(with))
    };
    match input {
        path if path.is_dir() => Ok(Input::Folder),
        path if !path.exists() => Err(Failure::Input(miette!(
            "`{}` does not exist; expected a result folder, a scene file or an FMU",
            path.display()
        ))),
        _ if ends("fmu") => Ok(Input::Fmu),
        _ if ends("toml") => Ok(Input::Scene),
        path => Err(Failure::Input(miette!(
            "`{}`: expected a result folder, a scene file that ends with .toml or an FMU that ends with .fmu",
            path.display()
        ))),
    }
}

/// The scene as it starts, with the names of boundaries, inputs and sensors.
///
/// # Errors
/// A start that the solver refuses, a table that cannot be read, outputs that there are not.
pub(crate) fn of_scene(scene: Scene, tables: &[PathBuf]) -> Result<(Recording, Options), Failure> {
    let table = Variables::new(&scene).map_err(Failure::input)?;
    let inputs = table
        .variables()
        .iter()
        .filter_map(|variable| match variable.binding {
            Binding::Input { boundary, .. } => Some((boundary, variable.name.clone())),
            _ => None,
        });
    let inputs: Vec<(usize, String)> = inputs.collect();
    let names = |list: Vec<&String>| list.into_iter().cloned().collect();
    let tables = tables.iter().map(|path| Table::from_csv(path));
    let options = Options {
        title: scene.title.clone(),
        materials: names(scene.materials.iter().map(|m| &m.name).collect()),
        boundaries: names(scene.boundaries.iter().map(|b| &b.name).collect()),
        labels: labels(&scene, &inputs),
        tables: tables.collect::<Result<_, _>>()?,
        ..Options::default()
    };
    let surface = Surface::new(&scene);
    let simulation = Simulation::new(Arc::new(scene))?;
    let frame = Frame::of(&Observation::of(&simulation), &surface);
    Ok((Recording::Still(Box::new(frame)), options))
}

/// The scene that an FMU carries, with its settled start.
///
/// # Errors
/// As [`model_in`] and [`of_scene`].
pub(crate) fn of_fmu(path: &Path, tables: &[PathBuf]) -> Result<(Recording, Options), Failure> {
    of_scene(Arc::unwrap_or_clone(model_in(path)?.scene), tables)
}

/// What an FMU carries.
///
/// # Errors
/// An FMU of something else, a scene that is refused.
pub(crate) fn model_in(path: &Path) -> Result<Model, Failure> {
    let fmu = Fmu::open(path)?;
    let resources = fmu.folder().join("resources");
    if !resources.join(SCENE_FILE).exists() {
        return Err(Failure::Input(miette!(
            "`{}` carries no scene: expected an FMU that `sphere-dda export` wrote",
            path.display()
        )));
    }
    Model::of_resources(&resources).map_err(Failure::input)
}

/// Makes a page, shows how it gets on, and writes it to `output`.
///
/// # Errors
/// Frames that cannot be shown, a page that cannot be written.
pub(crate) fn write(
    recording: &Recording,
    options: &Options,
    output: &Path,
) -> Result<Page, Failure> {
    let mut progress = Progress::counted();
    let made = page(recording, options, |done, of| {
        progress.part(done, of, "frame")
    })?;
    drop(progress);
    put(output, &made.html)?;
    Ok(made)
}

/// Where a page is and what it holds; a note on standard error if frames were left out.
pub(crate) fn told(made: &Page, output: &Path) -> String {
    match made.detail {
        Detail::Whole => {}
        Detail::Fine => note(
            "to keep the page within its size, values of spheres are in it to 2 %; --max-size allows more",
        ),
        Detail::Colours => note(
            "to keep the page within its size, values of spheres are in it as finely as colours show, to 6 %; --max-size allows \
             more",
        ),
        Detail::Sizes => note(
            "to keep the page within its size, velocities and forces of spheres are in it to 6 %, of other values their magnitudes; \
             --max-size allows more",
        ),
        Detail::Telling => note(
            "to keep the page within its size, velocities and forces of spheres are in it to 6 %, other values are not; \
             --max-size allows more",
        ),
        Detail::Magnitudes => note(
            "to keep the page within its size, magnitudes of the velocities and forces of spheres are in it to 6 %, \
             other values are not; --max-size allows more",
        ),
    }
    if made.thinned > 1 && made.frames == 1 {
        note(
            "to keep the page within its size, the first frame alone is in it; --max-size allows more",
        );
    } else if made.thinned > 1 {
        note(format_args!(
            "to keep the page within its size, {} of {} frames are in it: one in {} and the last; --max-size allows more",
            made.frames, made.recorded, made.thinned
        ));
    }
    let size = made.html.len() as f64 * 1e-6;
    let (frames, spheres) = (made.frames as u64, made.spheres as u64);
    let shown = format!("{}, {}", count(spheres, "sphere"), count(frames, "frame"));
    format!(
        "page            {}: {shown}, {size:.1} MB",
        output.display()
    )
}

/// Writes the page of a result folder, the end of other verbs, and returns what is to be said of it.
///
/// # Errors
/// As [`of_folder`] and [`write`].
pub(crate) fn end_with(
    folder: &Path,
    tables: &[PathBuf],
    output: &Path,
) -> Result<String, Failure> {
    let (recording, mut options) = of_folder(folder, tables)?;
    options.max_size = Some(MAX_SIZE);
    let made = write(&recording, &options, output)?;
    Ok(told(&made, output))
}

/// Writes a page under another name first: who opens it sees the old one or the new one.
fn put(output: &Path, html: &str) -> Result<(), Failure> {
    let draft = Draft::of(output);
    let written = fs::write(draft.path(), html).and_then(|()| draft.put());
    written.map_err(|error| {
        Failure::Input(miette!(
            "cannot write `{}`: {error}; choose another name with -o",
            output.display()
        ))
    })
}

/// Starts the browser.
///
/// # Errors
/// There is none.
pub(crate) fn open(page: &Path) -> Result<(), Failure> {
    let place = std::path::absolute(page).map_err(Failure::input)?;
    open::that_detached(&place).map_err(|error| {
        Failure::Run(miette!(
            "cannot start a browser: {error}; open `{}` in one",
            place.display()
        ))
    })
}
