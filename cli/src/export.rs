//! `sphere-dda export SCENE -o X.fmu`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::ValueEnum;
use miette::miette;
use sphere_dda::scene::Scene;
use sphere_dda_fmu::export::{Contents, Pictures, Version, check_library, export, find_library};
use sphere_dda_report::picture::portrait;

use crate::failure::Failure;
use crate::progress::{Interrupt, note, print};
use crate::settle::Settling;

/// Arguments of `export`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda export examples/feeder/feeder.toml
  sphere-dda export scene.toml -o build/scene.fmu --overwrite
  sphere-dda export hopper.toml --until-rest
  sphere-dda export scene.toml --fmi 3

With --settle or --until-rest the FMU carries the settled spheres: a full hopper is there at t = 0.

The library is looked for beside this program and in its `deps` folder, unless --library or the environment variable
SPHERE_DDA_LIBRARY names it; one that was built from other sources than this program is refused.")]
pub(crate) struct Export {
    /// The scene file (TOML).
    scene: PathBuf,
    /// The FMU to write; the scene's name with the ending `.fmu`, in the current folder, if absent.
    #[arg(short, long, value_name = "FMU")]
    output: Option<PathBuf>,
    /// The shared library to pack.
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    /// Version of the standard: scalars and wide support in 2, arrays of all spheres in 3.
    #[arg(long, value_name = "VERSION", default_value = "2")]
    fmi: Fmi,
    /// Replace the FMU if there is one.
    #[arg(long)]
    overwrite: bool,
    #[command(flatten)]
    settling: Settling,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Fmi {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
}

impl From<Fmi> for Version {
    fn from(fmi: Fmi) -> Self {
        match fmi {
            Fmi::Two => Self::Two,
            Fmi::Three => Self::Three,
        }
    }
}

/// Packs a scene and the library into an FMU.
///
/// # Errors
/// All problems of the scene, or why there is no FMU.
pub(crate) fn run(arguments: &Export, interrupt: &Interrupt) -> Result<(), Failure> {
    let scene = &arguments.scene;
    let output = match &arguments.output {
        Some(output) => output.clone(),
        None => PathBuf::from(scene.file_stem().unwrap_or_default()).with_extension("fmu"),
    };
    // An ending that importers want also keeps a slip of the hand from replacing the scene.
    if output.extension().is_none_or(|ending| ending != "fmu") {
        return Err(Failure::Input(miette!(
            "--output: found `{}`, expected a name that ends with .fmu",
            output.display()
        )));
    }
    if output.exists() && !arguments.overwrite {
        return Err(Failure::Input(miette!(
            "`{}` exists already; choose another name or allow --overwrite",
            output.display()
        )));
    }
    // What would stop the export shows before the spheres settle.
    let library = find_library(arguments.library.as_deref())?;
    check_library(&library)?;
    let start = arguments
        .settling
        .start(&Scene::from_file(scene)?.scene, interrupt)?;
    pack(scene, start, &output, &library, arguments.fmi.into())
}

/// Exports `scene` and its settled start, if there is one, with `library`, and says what was packed.
///
/// # Errors
/// As [`run`].
pub(crate) fn pack(
    scene: &Path,
    start: Option<Vec<u8>>,
    fmu: &Path,
    library: &Path,
    version: Version,
) -> Result<(), Failure> {
    let contents = Contents {
        scene,
        start,
        library,
        version,
        draw: pictures,
    };
    let exported = export(contents, fmu)?;
    for warning in &exported.warnings {
        note(format_args!("warning: {warning}"));
    }
    let size = std::fs::metadata(fmu).map_err(Failure::run)?.len() as f64 * 1e-6;
    print(|out| {
        writeln!(
            out,
            "{}: {} variables, {size:.1} MB, guid {}",
            fmu.display(),
            exported.variables,
            exported.guid
        )
    })
}

/// Pictures of a scene; none of one that has no extent.
fn pictures(scene: &Scene) -> Option<Pictures> {
    let draw = |width| portrait(scene, width).png();
    match (draw(100.0), draw(480.0)) {
        (Ok(icon), Ok(page)) => Some(Pictures { icon, page }),
        (Err(error), _) | (_, Err(error)) => {
            note(format_args!("warning: no picture: {error}"));
            None
        }
    }
}
