//! `sphere-dda export SCENE -o X.fmu`.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use miette::{IntoDiagnostic, Report, miette};
use sphere_dda_fmu::export::{ExportError, export, find_library};
use sphere_dda_fmu::model::ModelError;

/// Arguments of `export`.
#[derive(Debug, Args)]
pub(crate) struct Export {
    /// The scene file (TOML).
    scene: PathBuf,
    /// The FMU to write; the scene's name with the ending `.fmu`, in the current folder, if absent.
    #[arg(short, long, value_name = "FMU")]
    output: Option<PathBuf>,
    /// The shared library to pack; if absent the one that SPHERE_DDA_LIBRARY names, else the one beside this program.
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
}

/// Packs a scene and the library into an FMU.
///
/// # Errors
/// All problems of the scene, or why there is no FMU.
pub(crate) fn run(arguments: &Export) -> miette::Result<()> {
    let name = || {
        arguments
            .scene
            .with_extension("fmu")
            .file_name()
            .map(PathBuf::from)
    };
    let output = arguments.output.clone().or_else(name);
    let output =
        output.ok_or_else(|| miette!("`{}` is no file name", arguments.scene.display()))?;
    let library = find_library(arguments.library.as_deref()).into_diagnostic()?;
    let exported = export(&arguments.scene, &output, &library).map_err(report)?;
    for warning in &exported.warnings {
        eprintln!("warning: {warning}");
    }
    let size = std::fs::metadata(&output).into_diagnostic()?.len();
    writeln!(
        std::io::stdout().lock(),
        "{}: {} variables, {:.1} MB, guid {}",
        output.display(),
        exported.variables,
        size as f64 * 1e-6,
        exported.guid
    )
    .into_diagnostic()
}

/// The problems of a scene keep their places in the text.
fn report(error: ExportError) -> Report {
    match error {
        ExportError::Model(ModelError::Scene(scene)) => Report::new(*scene),
        other => miette!("{other}"),
    }
}
