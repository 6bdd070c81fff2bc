//! `sphere-dda check SCENE`.

use std::path::{Path, PathBuf};

use clap::Args;
use miette::miette;
use serde_json::{Value, json};
use sphere_dda::scene::Scene;
use sphere_dda::scene_file::{Diagnostic, Loaded, Summary};
use sphere_dda_fmu::table::Table;
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::Causality;
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
  sphere-dda check scene.toml --json
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
    /// Write problems, warnings and the summary as JSON, for programs: {"problems": [{"severity", "path", "line", "message",
    /// "help"}], "summary": text or null}. The exit code is the same.
    #[arg(long, conflicts_with = "picture")]
    json: bool,
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
    if arguments.json {
        return tell(&arguments.scene, &arguments.values.set);
    }
    let loaded = Scene::from_file_with(&arguments.scene, &arguments.values.set)?;
    warn(&loaded);
    let scene = &loaded.scene;
    let table = Table::new(scene).map_err(Failure::input)?;
    let entries = table.entries(Version::Two);
    let of = |causality| {
        entries
            .iter()
            .filter(|entry| entry.variable.causality == causality)
            .count()
    };
    print(|out| {
        writeln!(out, "{}", summary(&loaded))?;
        writeln!(
            out,
            "  as FMI 2.0        {} inputs, {} outputs, {} parameters, {} local variables",
            of(Causality::Input),
            of(Causality::Output),
            of(Causality::Parameter),
            of(Causality::Local)
        )?;
        writeln!(out, "  hash              {}", scene.hash)
    })?;
    match &arguments.picture {
        Some(path) => draw(scene, path),
        None => Ok(()),
    }
}

/// The summary of a scene and of what was fitted in it.
fn summary(loaded: &Loaded) -> String {
    let fitted = loaded.fitted.iter().map(ToString::to_string);
    let texts = std::iter::once(Summary::of(&loaded.scene).to_string()).chain(fitted);
    texts.collect::<Vec<_>>().join("\n")
}

/// Prints all that there is to say about a scene as JSON.
fn tell(scene: &Path, values: &[(String, f64)]) -> Result<(), Failure> {
    let (problems, summary) = match Scene::from_file_with(scene, values) {
        Ok(loaded) => {
            let mut problems: Vec<Value> = loaded.warnings.iter().map(problem).collect();
            let outputs = Table::new(&loaded.scene).map_err(|error| {
                json!({
                    "severity": "error",
                    "path": "fmu.outputs",
                    "line": null,
                    "message": error.to_string(),
                    "help": null,
                })
            });
            let refused = outputs.err();
            let summary = refused.is_none().then(|| summary(&loaded));
            problems.extend(refused);
            (problems, summary)
        }
        Err(error) => (error.problems.iter().map(problem).collect(), None),
    };
    print(|out| {
        writeln!(
            out,
            "{}",
            json!({ "problems": problems, "summary": summary })
        )
    })?;
    summary.map_or(Err(Failure::Told), |_| Ok(()))
}

/// A problem as JSON.
fn problem(found: &Diagnostic) -> Value {
    let severity = miette::Diagnostic::severity(found);
    json!({
        "severity": format!("{:?}", severity.unwrap_or_default()).to_lowercase(),
        "path": found.path,
        "line": found.line,
        "message": found.message,
        "help": found.help,
    })
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
