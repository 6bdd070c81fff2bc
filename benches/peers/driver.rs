//! One run of a scene, as the comparison with other codes times it: one line of JSON.
//!
//! `cargo bench --bench peers -- SCENE.toml [--tolerance GAP] [--step S] [--threads N] [--frames FILE] [--end FILE]`

mod measure;

use std::path::PathBuf;
use std::process::ExitCode;

use measure::{Outputs, measure, memory};
use sphere_dda::scene::{Scene, Tolerance};

/// Time before the end over which the force on the floor is averaged, for every code \[s\].
const MEAN: f64 = 0.04;
/// Force residual over the contact's force scale that goes with every gap tolerance \[-\].
const FORCE: f64 = 0.1;

fn main() -> ExitCode {
    match run() {
        Ok(line) => {
            println!("{line}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

#[derive(Default)]
struct Arguments {
    scene: Option<PathBuf>,
    tolerance: Option<f64>,
    step: Option<f64>,
    frames: Option<PathBuf>,
    end: Option<PathBuf>,
}

fn run() -> Result<String, String> {
    let arguments = Arguments::read(std::env::args().skip(1))?;
    let path = arguments
        .scene
        .ok_or("no scene: name the TOML file to run")?;
    let before = memory("VmRSS:");
    let loaded = Scene::from_file(path).map_err(|e| e.to_string())?;
    let mut scene = loaded.scene;
    if let Some(gap) = arguments.tolerance {
        scene.settings.tolerance = Tolerance {
            gap,
            slip: gap,
            force: FORCE,
        };
    }
    scene.settings.step = arguments.step.unwrap_or(scene.settings.step);
    let outputs = Outputs {
        frames: arguments.frames.as_deref(),
        end: arguments.end.as_deref(),
        mean_s: MEAN,
    };
    let measured = measure(scene, outputs, before)?;
    serde_json::to_string(&measured).map_err(|e| e.to_string())
}

impl Arguments {
    fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut read = Self::default();
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                // What `cargo bench` adds.
                "--bench" => {}
                "--tolerance" => read.tolerance = Some(positive(&word, &value()?)?),
                "--step" => read.step = Some(positive(&word, &value()?)?),
                "--threads" => one_thread(&value()?)?,
                "--frames" => read.frames = Some(value()?.into()),
                "--end" => read.end = Some(value()?.into()),
                option if option.starts_with('-') => {
                    return Err(format!(
                        "{option}: known are --tolerance, --step, --threads, --frames, --end"
                    ));
                }
                _ => read.scene = Some(word.into()),
            }
        }
        Ok(read)
    }
}

fn positive(option: &str, text: &str) -> Result<f64, String> {
    let number = text.parse().ok();
    let number = number.filter(|x: &f64| *x > 0.0 && x.is_finite());
    number.ok_or(format!("{option} {text}: a number > 0 is needed"))
}

fn one_thread(text: &str) -> Result<(), String> {
    match text {
        "1" => Ok(()),
        _ => Err(format!(
            "--threads {text}: this version solves on one thread"
        )),
    }
}
