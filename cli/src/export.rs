//! `sphere-dda export SCENE -o X.fmu`.

mod package;
mod trial;

use std::path::{Path, PathBuf};

use clap::Args;
use clap::ValueEnum;
use miette::miette;
use sphere_dda::scene::Scene;
use sphere_dda_export::{
    Contents, Exported, Library, Pictures, Platform, SmokeTest, Version, export, find_libraries,
};
use sphere_dda_picture::portrait::portrait;

use package::Package;
use trial::Trial;

use crate::arguments::{assignment, free, parameter};
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
  sphere-dda export hopper.toml --until-rest --start hopper.start     settles once, later exports read the start
  sphere-dda export scene.toml --fmi 3
  sphere-dda export scene.toml --set friction=0.4             changes the start of the FMU's parameter `friction`
  sphere-dda export scene.toml --platform linux64,win64
  sphere-dda export feeder.toml --smoke-test 0.1 --smoke-input drive.csv    then: sphere-dda verify feeder.fmu
  sphere-dda export bed.toml --ssp coupled.ssp --with shaker.fmu --set shaker.amplitude=0.001 \\
      --connect shaker.position=bed.boundary.tray.displacement \\
      --connect 'bed.boundary.tray.averageForce[3]=shaker.force'

With --settle or --until-rest the FMU carries the settled spheres: a full hopper is there at t = 0.

The library is looked for beside this program, in its `deps` folder and in `platforms/NAME`, unless --library or the
environment variable SPHERE_DDA_LIBRARY names it; one that was built from other sources than this program is refused.")]
pub(crate) struct Export {
    /// The scene file (TOML).
    scene: PathBuf,
    /// The FMU to write; the scene's name with the ending `.fmu`, in the current folder, if absent.
    #[arg(short, long, value_name = "FMU")]
    output: Option<PathBuf>,
    /// The shared library to pack.
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    /// Platforms of the FMU: linux64, aarch64-linux, win64, wasm; this one if absent. `fmu/platforms/build` builds the libraries of others,
    /// and one for old Linux.
    #[arg(long = "platform", value_name = "NAME", value_delimiter = ',', value_parser = platform)]
    platforms: Vec<Platform>,
    /// Version of the standard: scalars and wide support in 2, arrays of all spheres in 3.
    #[arg(long, value_name = "VERSION", default_value = "2")]
    fmi: Fmi,
    /// Replace the FMU if there is one.
    #[arg(long)]
    overwrite: bool,
    /// Default of a parameter of the scene, one of its `[[parameter]]`; can be repeated. With --ssp, FMU.VARIABLE=VALUE is a value
    /// in the package's set of parameters, where all others have their start values.
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, String)>,
    #[command(flatten)]
    settling: Settling,
    #[command(flatten)]
    trial: Trial,
    #[command(flatten)]
    package: Package,
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

/// A platform by name.
fn platform(name: &str) -> Result<Platform, String> {
    Platform::named(name.trim()).ok_or_else(|| {
        let apart = Platform::APART.map(|platform| platform.name);
        let mut known = apart.to_vec();
        if !known.contains(&Platform::HERE.name) {
            known.insert(0, Platform::HERE.name);
        }
        format!("found `{name}`, expected one of {}", known.join(", "))
    })
}

/// Packs a scene and the library into an FMU.
///
/// # Errors
/// All problems of the scene, or why there is no FMU.
pub(crate) fn run(arguments: &Export, interrupt: &Interrupt) -> Result<(), Failure> {
    let scene = &arguments.scene;
    if arguments.package.ssp.is_some() && matches!(arguments.fmi, Fmi::Three) {
        return Err(Failure::Input(miette!(
            "--ssp with --fmi 3: SSP 1.0 has no arrays; expected --fmi 2"
        )));
    }
    let output = match (&arguments.output, &arguments.package.ssp) {
        (_, Some(ssp)) => free("--ssp", ssp, "ssp", arguments.overwrite)?.to_path_buf(),
        (Some(fmu), None) => free("--output", fmu, "fmu", arguments.overwrite)?.to_path_buf(),
        (None, None) => {
            let fmu = PathBuf::from(scene.file_stem().unwrap_or_default()).with_extension("fmu");
            free("--output", &fmu, "fmu", arguments.overwrite)?;
            fmu
        }
    };
    let (values, of_package) = arguments.values()?;
    // What would stop the export shows before the spheres settle.
    let others = arguments.package.open()?;
    let libraries = find_libraries(arguments.library.as_deref(), &arguments.platforms)?;
    let start = arguments
        .settling
        .start(&Scene::from_file_with(scene, &values)?.scene, interrupt)?;
    let scene = (&**scene, &*values);
    if arguments.package.ssp.is_none() {
        let (version, trial) = (arguments.fmi.into(), &arguments.trial);
        let exported = trial.write(scene, start, &output, (&libraries, version), interrupt)?;
        return tell(&output, &exported);
    }
    // Its name in the package is that of the scene.
    let folder = tempfile::tempdir().map_err(Failure::run)?;
    let fmu = folder.path().join(scene.0.file_stem().unwrap_or_default());
    let fmu = fmu.with_extension("fmu");
    write(scene, start, &fmu, (&libraries, Version::Two), None)?;
    arguments.package.write(&fmu, &others, &of_package, &output)
}

/// Values of parameters by name: those of the scene, and those of a package, as text.
type Split = (Vec<(String, f64)>, Vec<(String, String)>);

impl Export {
    /// What `--set` says: of the scene's parameters, whose names have no point, and of the package.
    fn values(&self) -> Result<Split, Failure> {
        let (of_package, own): (Vec<_>, Vec<_>) =
            (self.set.iter().cloned()).partition(|(name, _)| name.contains('.'));
        if let (None, Some((name, _))) = (&self.package.ssp, of_package.first()) {
            return Err(Failure::Input(miette!(
                "--set: found `{name}`, expected the name of a parameter of the scene; with --ssp, FMU.VARIABLE"
            )));
        }
        let number = |(name, value): &(String, String)| parameter(&format!("{name}={value}"));
        let own: Result<Vec<_>, _> = own.iter().map(number).collect();
        let own = own.map_err(|problem| Failure::Input(miette!("--set: {problem}")))?;
        Ok((own, of_package))
    }
}

/// A scene file, and other defaults of its parameters.
type Given<'a> = (&'a Path, &'a [(String, f64)]);

/// Exports `scene` and its settled start, if there is one, with `library`, and says what was packed.
///
/// # Errors
/// As [`run`].
pub(crate) fn pack(
    scene: Given<'_>,
    start: Option<Vec<u8>>,
    fmu: &Path,
    libraries: &[Library],
    version: Version,
) -> Result<(), Failure> {
    tell(fmu, &write(scene, start, fmu, (libraries, version), None)?)
}

/// Says what was packed.
fn tell(fmu: &Path, exported: &Exported) -> Result<(), Failure> {
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

/// Exports with warnings.
fn write(
    scene: Given<'_>,
    start: Option<Vec<u8>>,
    fmu: &Path,
    (libraries, version): (&[Library], Version),
    smoke_test: Option<&SmokeTest>,
) -> Result<Exported, Failure> {
    let (scene, values) = scene;
    let contents = Contents {
        scene,
        values,
        start,
        libraries,
        version,
        smoke_test,
        draw: pictures,
    };
    let exported = export(contents, fmu)?;
    for warning in &exported.warnings {
        note(format_args!("warning: {warning}"));
    }
    Ok(exported)
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
