//! `sphere-dda demo`: the funnel example as an FMU, from the scene to results on the disk.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use miette::miette;
use sphere_dda_export::{Version, find_libraries};
use sphere_dda_master::{Fmu, Options, System, Table};

use crate::arguments::positive;
use crate::export::pack;
use crate::failure::Failure;
use crate::page;
use crate::progress::{Interrupt, print, wall_time};
use crate::simulate::drive;

/// The scene, so that the demo works in any folder.
const SCENE: &str = include_str!("../../examples/funnel/funnel.toml");
/// Explains a demo folder, and marks it as one.
const ABOUT: &str = "about.txt";
/// First line of that file.
const MARK: &str = "Output of `sphere-dda demo`";
/// Name of the FMU's instance, and so of the folder that it writes to.
const RESULTS: &str = "results";

/// Arguments of `demo`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda demo
  sphere-dda demo --view
  sphere-dda demo -o /tmp/funnel

Written to DIR: funnel.toml (the scene), funnel.fmu, outputs.csv (what a master reads from the FMU), results/ (VTU, PVD
and CSV files that the FMU itself writes), and view.html, which shows them in the browser. The output of an earlier demo
is replaced.")]
pub(crate) struct Demo {
    /// Folder to write to.
    #[arg(short, long, value_name = "DIR", default_value = "demo-output")]
    output: PathBuf,
    /// Stop time [s]; that of the scene if absent.
    #[arg(long, value_name = "SECONDS", value_parser = positive, hide = true)]
    stop: Option<f64>,
    /// Open the page in the browser.
    #[arg(long)]
    view: bool,
}

/// Exports the funnel, drives the FMU through the interface of FMI, and says how to look at the results.
///
/// # Errors
/// A folder that is not ours, a library that does not fit, or what the importer says.
pub(crate) fn run(arguments: &Demo, interrupt: &Interrupt) -> Result<(), Failure> {
    let folder = prepare(&arguments.output)?;
    let (scene, archive) = (folder.join("funnel.toml"), folder.join("funnel.fmu"));
    put(&scene, SCENE.as_bytes())?;
    pack(
        (&scene, &[]),
        None,
        &archive,
        &find_libraries(None, &[])?,
        Version::Two,
    )?;

    let fmu = Fmu::open(&archive)?;
    let options = Options {
        stop: arguments.stop,
        set: vec![
            ("output.directory".to_owned(), folder.display().to_string()),
            ("output.overwrite".to_owned(), "true".to_owned()),
        ],
        instance_name: Some(RESULTS.to_owned()),
        ..Options::default()
    };
    // An FMU that lacks what the summary tells ends here, at its first row.
    let told = |table: &Table| Told::of(|name| table.real(name));
    let driven = drive(
        &System::of(&fmu),
        &options,
        interrupt,
        |table| match table.time.len() {
            1 => told(table).map(drop),
            _ => Ok(()),
        },
    );
    // Without a row nothing ran that could be told of or shown.
    if let Some(table) = &driven.table
        && let Some(&time) = table.time.last()
    {
        let mut text = Vec::new();
        table.write_csv(&mut text).map_err(Failure::run)?;
        put(&folder.join("outputs.csv"), &text)?;
        let (summary, steps) = (told(table)?, table.time.len() - 1);
        print(|out| summary.write(out, time, steps, driven.wall))?;
        let place = arguments.output.join(RESULTS);
        let shown = arguments.output.join(page::NAME);
        let end = page::end_with(&place, &[], &shown)?;
        print(|out| writeln!(out, "{end}"))?;
        print(|out| out.write_all(how_to_look(&shown, &place).as_bytes()))?;
        if arguments.view {
            page::open(&shown)?;
        }
    }
    driven.end
}

/// The folder as an absolute path, new, empty or of an earlier demo.
fn prepare(folder: &Path) -> Result<PathBuf, Failure> {
    let refuse =
        |error: io::Error| Failure::Input(miette!("cannot use `{}`: {error}", folder.display()));
    fs::create_dir_all(folder).map_err(refuse)?;
    let about = folder.join(ABOUT);
    let empty = fs::read_dir(folder).map_err(refuse)?.next().is_none();
    if !empty && !fs::read_to_string(&about).is_ok_and(|text| text.starts_with(MARK)) {
        return Err(Failure::Input(miette!(
            "`{}` holds other files than those of a demo; choose another folder with -o",
            folder.display()
        )));
    }
    let text = format!(
        "{MARK}, which replaces the files named here when it runs again.\n\n\
         funnel.toml  the scene\n\
         funnel.fmu   the scene as an FMU of FMI 2.0 for co-simulation\n\
         outputs.csv  its outputs, read through the interface of FMI\n\
         results/     VTU, PVD and CSV files that the FMU wrote itself\n\
         view.html    the run in the browser\n\n{}",
        how_to_look(Path::new(page::NAME), Path::new(RESULTS))
    );
    put(&about, text.as_bytes())?;
    std::path::absolute(folder).map_err(refuse)
}

fn put(path: &Path, content: &[u8]) -> Result<(), Failure> {
    fs::write(path, content)
        .map_err(|error| Failure::Input(miette!("cannot write `{}`: {error}", path.display())))
}

/// What happened, from the outputs of the FMU.
#[derive(Debug)]
struct Told {
    /// Mass \[kg\] through the outlet.
    discharged: f64,
    /// Mass \[kg\] of all spheres.
    whole: f64,
    /// Largest overlap over radius.
    overlap: f64,
}

impl Told {
    /// From the values of each output over time, at least one.
    ///
    /// # Errors
    /// An output that the FMU lacks.
    fn of<'t>(output: impl Fn(&str) -> Option<&'t [f64]>) -> Result<Self, Failure> {
        let value = |name: &str, of: fn(&[f64]) -> Option<f64>| {
            output(name).and_then(of).ok_or_else(|| {
                Failure::Run(miette!(
                    "funnel.fmu: found no output `{name}`, expected it for the summary; report it to the makers of sphere-dda"
                ))
            })
        };
        Ok(Self {
            discharged: value("sensor.discharge.mass", |list| list.last().copied())?,
            // All spheres are above the outlet at the start.
            whole: value("sensor.content.mass", |list| list.first().copied())?,
            overlap: value("maxOverlap", |list| list.iter().copied().reduce(f64::max))?,
        })
    }

    /// Of a run to `time` \[s\] in `steps` communication steps, which took the wall time `wall` \[s\].
    fn write(&self, out: &mut dyn io::Write, time: f64, steps: usize, wall: f64) -> io::Result<()> {
        let Self {
            discharged,
            whole,
            overlap,
        } = self;
        writeln!(
            out,
            "simulated       {time} s in {steps} communication steps"
        )?;
        writeln!(out, "discharged      {discharged:.0} kg of {whole:.0} kg")?;
        writeln!(
            out,
            "worst overlap   {overlap:.2e} of the radius, over all steps"
        )?;
        writeln!(out, "wall time       {}", wall_time(wall, time))
    }
}

fn how_to_look(page: &Path, results: &Path) -> String {
    let (page, place) = (page.display(), results.display());
    format!(
        "To view:        open {page} in a browser\n\
         \x20               or paraview --script={place}/view.py\n\
         \x20               or open {place}/spheres.pvd in ParaView\n\
         \x20               or python -c \"import meshio; print(meshio.read('{place}/spheres_000000.vtu'))\"\n"
    )
}

#[cfg(test)]
mod tests {
    use super::{Failure, Told};

    /// The summary said `NaN kg of NaN kg` and an overlap of 0 for outputs that the FMU did not have.
    #[test]
    fn an_output_that_the_fmu_lacks_is_named() {
        let outputs: [(&str, &[f64]); 3] = [
            ("sensor.discharge.mass", &[0.0, 2.0, 7.0]),
            ("sensor.content.mass", &[9.0, 7.0, 2.0]),
            ("maxOverlap", &[0.0, 1e-3, 1e-4]),
        ];
        let all_but = |lacking: &str| {
            Told::of(|name| {
                let mut left = outputs.iter().filter(|(known, _)| *known != lacking);
                left.find(|(known, _)| *known == name)
                    .map(|(_, list)| *list)
            })
        };
        let told = all_but("").unwrap();
        assert_eq!(
            (told.discharged, told.whole, told.overlap),
            (7.0, 9.0, 1e-3)
        );
        for (name, _) in outputs {
            let Err(Failure::Run(report)) = all_but(name) else {
                panic!("{name} is not missed");
            };
            let expected = format!("found no output `{name}`, expected it");
            assert!(report.to_string().contains(&expected), "{report}");
        }
    }
}
