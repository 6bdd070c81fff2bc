//! `sphere-dda view DIR|SCENE|X.fmu`: one HTML file that shows results, or a scene before it runs.

use std::fs;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use clap::Args;
use miette::miette;
use sphere_dda::scene::Scene;
use sphere_dda::scene_file::{Loaded, SceneError};
use sphere_dda_fmu::model::Model;
use sphere_dda_picture::viewer::{Options, Recording};

use crate::arguments::{Values, free};
use crate::check::warn;
use crate::failure::Failure;
use crate::live;
use crate::page::{self, Input};
use crate::progress::{Interrupt, note, print};

/// Time between two looks at a watched file.
const PAUSE: Duration = Duration::from_millis(200);

/// Arguments of `view`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda view results --open                     results/view.html, in the browser
  sphere-dda view results -o flow.html --max-size 10MB
  sphere-dda view scene.toml --watch --open          while you write the scene: the page renews itself when you save
  sphere-dda view feeder.fmu                         the scene inside an FMU of sphere-dda
  sphere-dda view scene.toml --live --open           the solver runs in the page; sliders move its inputs
  sphere-dda view results --table outputs.csv        also plots what `simulate` recorded

The page is one file without references to others: it opens offline, can be sent and kept. Centres are exact to 1/1000
of the smallest radius, other values to 0.5 % (2 % in pages that must be small).")]
pub(crate) struct View {
    /// A result folder, a scene file (TOML), or an FMU of sphere-dda.
    input: PathBuf,
    /// The page to write; DIR/view.html, or the scene's name with the ending `.html` in the current folder, if absent.
    #[arg(short, long, value_name = "HTML")]
    output: Option<PathBuf>,
    /// Replace the page if there is one.
    #[arg(long)]
    overwrite: bool,
    /// Open the page in the browser.
    #[arg(long)]
    open: bool,
    /// Of a scene: write the page anew, and have it renew itself in the browser, whenever the file is saved.
    #[arg(long)]
    watch: bool,
    /// Of a scene or an FMU: the solver itself runs in the page, as WebAssembly, and sliders set the inputs. It needs the module that
    /// `fmu/platforms/build wasm` makes.
    #[arg(long, conflicts_with_all = ["watch", "tables"])]
    live: bool,
    /// Largest page: values of spheres get coarser, then frames are left out evenly, until it is smaller. A number of bytes, or of kB, MB, GB.
    #[arg(long, value_name = "SIZE", default_value = "50MB", value_parser = size)]
    max_size: u64,
    /// Another table over time to plot: CSV with the header `time,name,...`; can be repeated.
    #[arg(long = "table", value_name = "CSV")]
    tables: Vec<PathBuf>,
    #[command(flatten)]
    values: Values,
}

/// A number of bytes: `50MB`.
pub(crate) fn size(text: &str) -> Result<u64, String> {
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == ' ');
    let factor = match text[digits.len()..].trim() {
        "" | "B" => 1.0,
        "kB" | "KB" => 1e3,
        "MB" => 1e6,
        "GB" => 1e9,
        _ => f64::NAN,
    };
    let bytes = digits.parse::<f64>().map(|number| number * factor);
    match bytes {
        Ok(bytes) if (1.0..1e15).contains(&bytes) => Ok(bytes as u64),
        _ => Err("expected a size like 50MB, in B, kB, MB or GB".to_owned()),
    }
}

/// Writes the page, and keeps it new where that was asked for.
///
/// # Errors
/// What is no result folder, scene or FMU, all problems of a scene, a page that cannot be written.
pub(crate) fn run(arguments: &View, interrupt: &Interrupt) -> Result<(), Failure> {
    let input = &arguments.input;
    let kind = page::kind(input)?;
    if arguments.watch && !matches!(kind, Input::Scene) {
        return Err(Failure::Input(miette!(
            "--watch: found `{}`, expected a scene file: other input does not change",
            input.display()
        )));
    }
    if arguments.live && matches!(kind, Input::Folder) {
        return Err(Failure::Input(miette!(
            "--live: found the results `{}`, expected a scene file or an FMU: results have run already",
            input.display()
        )));
    }
    let values = &arguments.values.set;
    if !values.is_empty() && !matches!(kind, Input::Scene) {
        return Err(Failure::Input(miette!(
            "--set: found `{}`, expected a scene file: results have their values already",
            input.display()
        )));
    }
    let output = match (&arguments.output, &kind) {
        (Some(output), _) => output.clone(),
        (None, Input::Folder) => input.join(page::NAME),
        (None, _) => PathBuf::from(input.file_stem().unwrap_or_default()).with_extension("html"),
    };
    free("--output", &output, "html", arguments.overwrite)?;
    let show = |(recording, mut options): (Recording, Options), watched: String| {
        options.max_size = Some(arguments.max_size);
        options.watched = watched;
        page::write(&recording, &options, &output)
    };
    let made = match kind {
        Input::Folder => show(page::of_folder(input, &arguments.tables)?, String::new())?,
        Input::Fmu if arguments.live => {
            show(live::of_model(page::model_in(input)?)?, String::new())?
        }
        Input::Fmu => show(page::of_fmu(input, &arguments.tables)?, String::new())?,
        Input::Scene => {
            let loaded = Scene::from_file_with(input, values)?;
            warn(&loaded);
            if arguments.live {
                let model = Model::read_with(input, values, None).map_err(Failure::input)?;
                show(live::of_model(model)?, String::new())?
            } else {
                let mark = if arguments.watch {
                    stamp()
                } else {
                    String::new()
                };
                show(page::of_scene(loaded.scene, &arguments.tables)?, mark)?
            }
        }
    };
    print(|out| writeln!(out, "{}", page::told(&made, &output)))?;
    if arguments.open {
        page::open(&output)?;
    }
    if arguments.watch {
        watch(arguments, interrupt, &output)?;
    }
    Ok(())
}

/// Differs between any two pages.
fn stamp() -> String {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    now.unwrap_or_default().as_nanos().to_string()
}

/// When the scene file and those it refers to were last written, and their lengths.
fn traces(input: &Path, files: &[PathBuf]) -> Vec<Option<(SystemTime, u64)>> {
    let trace = |path: &Path| {
        let about = fs::metadata(path).ok()?;
        Some((about.modified().ok()?, about.len()))
    };
    let others = files.iter().map(|path| trace(path));
    std::iter::once(trace(input)).chain(others).collect()
}

/// The files that a scene refers to.
fn references(input: &Path, loaded: &Result<Loaded, SceneError>) -> Vec<PathBuf> {
    let folder = input.parent().unwrap_or(Path::new(""));
    let attachments = loaded.iter().flat_map(|loaded| &loaded.attachments);
    attachments.map(|file| folder.join(&file.path)).collect()
}

/// Renews the page until Ctrl-C; a scene with problems is told here and on the page, which keeps the last sound one.
fn watch(arguments: &View, interrupt: &Interrupt, output: &Path) -> Result<(), Failure> {
    let input = &arguments.input;
    let values = &arguments.values.set;
    let mut loaded = Scene::from_file_with(input, values);
    let mut files = references(input, &loaded);
    let mut seen = traces(input, &files);
    let sound = loaded.map(|loaded| loaded.scene)?;
    let mut shown = page::of_scene(sound, &arguments.tables)?;
    let renew = |shown: &mut (Recording, Options), mark: String| {
        shown.1.max_size = Some(arguments.max_size);
        shown.1.watched = mark;
        page::write(&shown.0, &shown.1, output)
    };
    note(format_args!("watches `{}`; Ctrl-C ends", input.display()));
    while !interrupt.requested() {
        sleep(PAUSE);
        let now = traces(input, &files);
        if now == seen {
            continue;
        }
        loaded = Scene::from_file_with(input, values);
        if loaded.is_ok() {
            files = references(input, &loaded);
        }
        seen = traces(input, &files);
        shown.1.notice = loaded
            .as_ref()
            .err()
            .map_or_else(String::new, SceneError::plain);
        let problem = match loaded {
            Ok(loaded) => {
                warn(&loaded);
                match page::of_scene(loaded.scene, &arguments.tables) {
                    Ok(new) => {
                        shown = new;
                        None
                    }
                    Err(Failure::Input(report) | Failure::Run(report)) => Some(report),
                    Err(interrupted) => return Err(interrupted),
                }
            }
            Err(error) => Some(error.into()),
        };
        if let Some(report) = problem.as_ref().filter(|_| shown.1.notice.is_empty()) {
            shown.1.notice = report.to_string();
        }
        let made = renew(&mut shown, stamp())?;
        match problem {
            Some(report) => note(format_args!("{report:?}")),
            None => print(|out| writeln!(out, "{}", page::told(&made, output)))?,
        }
    }
    // What is left opens as any other page.
    renew(&mut shown, String::new()).map(|_| ())
}
