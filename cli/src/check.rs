//! `sphere-dda check SCENE`.

use std::path::{Path, PathBuf};

use clap::Args;
use miette::miette;
use sphere_dda::scene::Scene;
use sphere_dda::scene_file::{Loaded, Summary};
use sphere_dda_picture::portrait::portrait;

use crate::arguments::{Values, free};
use crate::failure::Failure;
use crate::progress::{note, print};

/// Side of the picture [px].
const WIDTH: f64 = 960.0;

/// Arguments of `check`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda check examples/funnel/funnel.toml
  sphere-dda check scene.toml --picture scene.png
  sphere-dda check scene.toml --set friction=0.4         with another value of its parameter `friction`")]
pub(crate) struct Check {
    /// The scene file (TOML).
    scene: PathBuf,
    /// Draw the scene as it starts into this PNG file: boundaries but unbounded planes, and spheres by material.
    #[arg(long, value_name = "PNG")]
    picture: Option<PathBuf>,
    /// Replace the picture if there is one.
    #[arg(long, requires = "picture")]
    overwrite: bool,
    #[command(flatten)]
    values: Values,
}

/// Prints the summary of a scene, warnings before it.
///
/// # Errors
/// All problems of the scene; a picture that cannot be drawn or written.
pub(crate) fn run(arguments: &Check) -> Result<(), Failure> {
    if let Some(picture) = &arguments.picture {
        free("--picture", picture, "png", arguments.overwrite)?;
    }
    let loaded = Scene::from_file_with(&arguments.scene, &arguments.values.set)?;
    warn(&loaded);
    let scene = &loaded.scene;
    print(|out| {
        writeln!(out, "{}", Summary::of(scene))?;
        writeln!(out, "  hash              {}", scene.hash)
    })?;
    match &arguments.picture {
        Some(path) => draw(scene, path),
        None => Ok(()),
    }
}

/// Draws a scene as it starts.
fn draw(scene: &Scene, path: &Path) -> Result<(), Failure> {
    let png = portrait(scene, WIDTH).png().map_err(Failure::run)?;
    std::fs::write(path, png)
        .map_err(|error| Failure::Input(miette!("cannot write `{}`: {error}", path.display())))?;
    print(|out| writeln!(out, "  picture           {}", path.display()))
}

/// Shows the warnings of a scene on standard error.
pub(crate) fn warn(loaded: &Loaded) {
    for report in loaded.reports() {
        note(format_args!("{report:?}"));
    }
}
