//! `sphere-dda check SCENE`.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use miette::{IntoDiagnostic, NamedSource, Report};
use sphere_dda::scene::{Loaded, Scene, Summary};

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// The scene file (TOML).
    scene: PathBuf,
}

/// Prints the summary of a scene, warnings before it.
///
/// # Errors
/// All problems of the scene.
pub(crate) fn run(arguments: &Check) -> miette::Result<()> {
    let loaded = Scene::from_file(&arguments.scene)?;
    warn(&loaded);
    let mut out = std::io::stdout().lock();
    writeln!(out, "{}", Summary::of(&loaded.scene)).into_diagnostic()?;
    writeln!(out, "  hash              {}", loaded.scene.hash).into_diagnostic()
}

/// Shows the warnings of a scene on standard error.
pub(crate) fn warn(loaded: &Loaded) {
    for warning in &loaded.warnings {
        let source = NamedSource::new(&loaded.name, loaded.text.clone());
        eprintln!(
            "{:?}",
            Report::new(warning.clone()).with_source_code(source)
        );
    }
}
