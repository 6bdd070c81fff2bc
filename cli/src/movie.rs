//! `sphere-dda movie DIR -o film.mp4|film.gif|picture.png`: the page of `view`, drawn frame by frame.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use clap::Args;
use miette::miette;
use serde_json::{Value, json};
use sphere_dda::scene::Scene;

use crate::arguments::{assignment, interval, positive, vacant};
use crate::browser::{Browser, on_path};
use crate::check::warn;
use crate::draft::Draft;
use crate::failure::Failure;
use crate::page::{self, Input};
use crate::progress::{Interrupt, Progress, count, note, print};

/// Length \[s\] of a film that is asked for without a speed.
const LENGTH: f64 = 12.0;
/// Largest page that the film is drawn from \[bytes\].
const PAGE: u64 = 200_000_000;

/// Arguments of `movie`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda movie results -o flow.mp4
  sphere-dda movie results -o flow.gif --from 1 --to 3 --speed 0.5 --size 640x480
  sphere-dda movie results -o forces.png --from 1.8 --set forces=true --set view=front
  sphere-dda movie scene.toml -o scene.png

Settings are those of the page: colour, low, high, spheres, forces, width, opacity, names, cut (x, -y ...), place (0 to 1),
view (oblique, front, right, back, left, top,
spheres). Needs Chromium, and ffmpeg for films.")]
pub(crate) struct Movie {
    /// A result folder; for a picture also a scene file (TOML) or an FMU of sphere-dda.
    input: PathBuf,
    /// The film (.mp4 or .gif) or picture (.png) to write.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Replace the film if there is one.
    #[arg(long)]
    overwrite: bool,
    /// First time [s], that of a picture; the start of the run if absent.
    #[arg(long, value_name = "SECONDS", value_parser = interval)]
    from: Option<f64>,
    /// Last time [s]; the end of the run if absent.
    #[arg(long, value_name = "SECONDS", value_parser = interval)]
    to: Option<f64>,
    /// Simulated seconds in a second of the film; as many as make it 12 s long if absent.
    #[arg(long, value_name = "NUMBER", value_parser = positive)]
    speed: Option<f64>,
    /// Pictures in a second.
    #[arg(long, value_name = "COUNT", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..=120))]
    fps: u32,
    /// Width and height [px], even numbers.
    #[arg(long, value_name = "SIZE", default_value = "960x720", value_parser = size)]
    size: (u32, u32),
    /// A setting of the page; can be repeated.
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    set: Vec<(String, String)>,
}

/// `960x720`.
fn size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once('x');
    let sides = sides.and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match sides {
        Some((w, h))
            if [w, h]
                .iter()
                .all(|side| (64..=4096).contains(side) && side % 2 == 0) =>
        {
            Ok((w, h))
        }
        _ => Err("expected WIDTHxHEIGHT, even numbers from 64 to 4096".to_owned()),
    }
}

/// What is written.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Mp4,
    Gif,
    Picture,
}

/// Draws the film.
///
/// # Errors
/// What is no result folder, a browser or an encoder that is missing, a setting that the page does not have.
pub(crate) fn run(arguments: &Movie, interrupt: &Interrupt) -> Result<(), Failure> {
    let output = &arguments.output;
    let kind = kind(output)?;
    vacant(output, arguments.overwrite)?;
    // What would stop it shows before anything is drawn.
    let encoder = (kind != Kind::Picture).then(encoder).transpose()?;
    let (recording, mut options) = match page::kind(&arguments.input)? {
        Input::Folder => page::of_folder(&arguments.input, &[])?,
        Input::Scene => {
            let loaded = Scene::from_file(&arguments.input)?;
            warn(&loaded);
            page::of_scene(loaded.scene, &[])?
        }
        Input::Fmu => page::of_fmu(&arguments.input, &[])?,
    };
    options.max_size = Some(PAGE);
    let times = times(arguments, recording.times(), kind)?;
    let mut browser = Browser::start()?;
    let folder = tempfile::tempdir().map_err(Failure::run)?;
    let page = folder.path().join(page::NAME);
    let made = page::write(&recording, &options, &page)?;
    if made.thinned > 1 {
        note(format_args!(
            "every {}th frame is drawn: the others are told by interpolation",
            made.thinned
        ));
    }
    browser.open(&page)?;
    let settings = arguments.set.iter().map(|(name, text)| {
        let value = serde_json::from_str(text).unwrap_or_else(|_| json!(text));
        (name.clone(), value)
    });
    let settings = Value::Object(settings.collect());
    // At the first picture's time, as a view may depend on where the spheres are.
    let first = times[0];
    browser.run(&format!(
        "sphereDda.setTime({first}).then(() => sphereDda.set({settings}))"
    ))?;
    let draft = Draft::of(output);
    let mut film = match &encoder {
        Some(program) => Some(Film::begin(program, kind, arguments.fps, draft.path())?),
        None => None,
    };
    let (width, height) = arguments.size;
    let mut progress = Progress::counted();
    for (k, time) in times.iter().enumerate() {
        let draw =
            format!("sphereDda.setTime({time}).then(() => sphereDda.picture({width}, {height}))");
        let picture = decoded(&browser.run(&draw)?)?;
        match &mut film {
            Some(film) => film.push(&picture)?,
            None => {
                fs::write(draft.path(), &picture).map_err(|error| unwritable(output, &error))?
            }
        }
        progress.part(k + 1, times.len(), "picture");
        if interrupt.requested() {
            drop(film);
            return Err(Failure::Interrupted);
        }
    }
    drop(progress);
    if let Some(film) = film {
        film.end()?;
    }
    let put = draft.put();
    put.map_err(|error| unwritable(output, &error))?;
    let drawn = count(times.len() as u64, "picture");
    print(|out| {
        writeln!(
            out,
            "{}: {drawn} of {width} x {height} px",
            output.display()
        )
    })
}

fn ending(output: &Path) -> String {
    output
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase()
}

fn kind(output: &Path) -> Result<Kind, Failure> {
    match ending(output).as_str() {
        "mp4" => Ok(Kind::Mp4),
        "gif" => Ok(Kind::Gif),
        "png" => Ok(Kind::Picture),
        _ => Err(Failure::Input(miette!(
            "--output: found `{}`, expected a name that ends with .mp4, .gif or .png",
            output.display()
        ))),
    }
}

fn encoder() -> Result<PathBuf, Failure> {
    on_path(&["ffmpeg"]).ok_or_else(|| {
        Failure::Input(miette!(
            "found no `ffmpeg` on the PATH, expected it to encode the film; on Debian: apt-get install ffmpeg. \
             A picture (-o picture.png) needs none"
        ))
    })
}

fn unwritable(output: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::Input(miette!("cannot write `{}`: {error}", output.display()))
}

/// Simulated times \[s\] of the pictures.
fn times(arguments: &Movie, frames: &[f64], kind: Kind) -> Result<Vec<f64>, Failure> {
    let (first, last) = (frames[0], frames[frames.len() - 1]);
    let (from, to) = (
        arguments.from.unwrap_or(first),
        arguments.to.unwrap_or(last),
    );
    if kind == Kind::Picture {
        return Ok(vec![from]);
    }
    if from >= to || from >= last {
        return Err(Failure::Input(miette!(
            "found no time from {from} s to {to} s, expected a part of the run, which lasts from {first} s to {last} s"
        )));
    }
    let to = to.min(last);
    let speed = arguments.speed.unwrap_or((to - from) / LENGTH);
    let step = speed / f64::from(arguments.fps);
    let steps = ((to - from) / step + 1e-9).floor();
    if steps > 1e5 {
        return Err(Failure::Input(miette!(
            "found {steps} pictures, expected at most 100000: choose a higher --speed or a shorter part"
        )));
    }
    Ok((0..=steps as usize)
        .map(|k| from + k as f64 * step)
        .collect())
}

/// The bytes of a data URL.
fn decoded(url: &Value) -> Result<Vec<u8>, Failure> {
    let text = url.as_str().and_then(|url| url.split_once("base64,"));
    let (_, data) = text.ok_or_else(|| Failure::Run(miette!("the page drew no picture")))?;
    STANDARD.decode(data).map_err(Failure::run)
}

/// A film that is being encoded.
struct Film {
    process: Child,
    log: tempfile::NamedTempFile,
}

impl Film {
    fn begin(program: &Path, kind: Kind, fps: u32, output: &Path) -> Result<Self, Failure> {
        let log = tempfile::NamedTempFile::new().map_err(Failure::run)?;
        let heard = log.reopen().map_err(Failure::run)?;
        let how: &[&str] = match kind {
            Kind::Gif => &[
                "-vf",
                "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
            ],
            _ => &[
                "-c:v",
                "libx264",
                "-pix_fmt",
                "yuv420p",
                "-crf",
                "20",
                "-movflags",
                "+faststart",
            ],
        };
        let process = Command::new(program)
            .args([
                "-hide_banner",
                "-loglevel",
                "error",
                "-y",
                "-f",
                "image2pipe",
                "-c:v",
                "png",
            ])
            .args(["-framerate", &fps.to_string(), "-i", "-"])
            .args(how)
            .arg(output)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(heard)
            .spawn();
        let process = process.map_err(|error| {
            Failure::Run(miette!("cannot start `{}`: {error}", program.display()))
        })?;
        Ok(Self { process, log })
    }

    fn push(&mut self, picture: &[u8]) -> Result<(), Failure> {
        let written = self
            .process
            .stdin
            .as_mut()
            .map(|pipe| pipe.write_all(picture));
        match written {
            Some(Ok(())) => Ok(()),
            _ => Err(self.refused()),
        }
    }

    fn end(mut self) -> Result<(), Failure> {
        drop(self.process.stdin.take());
        match self.process.wait() {
            Ok(status) if status.success() => Ok(()),
            _ => Err(self.refused()),
        }
    }

    fn refused(&self) -> Failure {
        let said = fs::read_to_string(self.log.path()).unwrap_or_default();
        Failure::Run(miette!("ffmpeg cannot encode the film: {}", said.trim()))
    }
}

impl Drop for Film {
    fn drop(&mut self) {
        drop(self.process.stdin.take());
        // After `end` it has gone already.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
