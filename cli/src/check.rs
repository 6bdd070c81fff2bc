//! `sphere-dda check SCENE`.

use std::path::PathBuf;

use clap::Args;
use miette::{NamedSource, Report};
use sphere_dda::scene::{Loaded, Scene, Summary};

use crate::failure::Failure;
use crate::progress::{note, print};

/// Arguments of `check`.
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  sphere-dda check examples/funnel/funnel.toml")]
pub(crate) struct Check {
    /// The scene file (TOML).
    scene: PathBuf,
}

/// Prints the summary of a scene, warnings before it.
///
/// # Errors
/// All problems of the scene.
pub(crate) fn run(arguments: &Check) -> Result<(), Failure> {
    let loaded = Scene::from_file(&arguments.scene)?;
    warn(&loaded);
    let scene = &loaded.scene;
    print(|out| {
        writeln!(out, "{}", Summary::of(scene))?;
        writeln!(out, "  hash              {}", scene.hash)
    })
}

/// Shows the warnings of a scene on standard error.
pub(crate) fn warn(loaded: &Loaded) {
    for warning in &loaded.warnings {
        let source = NamedSource::new(&loaded.name, loaded.text.clone());
        let report = Report::new(warning.clone()).with_source_code(source);
        note(format_args!("{report:?}"));
    }
}
