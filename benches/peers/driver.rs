//! One run of a scene, as the comparison with other codes times it: one line of JSON.
//!
//! `cargo bench --bench peers -- SCENE.toml [--frames FILE] [--contacts FILE] [--end FILE]`; settings are those of the scene.

mod measure;

use std::path::PathBuf;
use std::process::ExitCode;

use measure::{Outputs, measure, memory};
use sphere_dda::scene::Scene;

/// Time before the end over which the force on the floor is averaged, for every code \[s\].
const MEAN: f64 = 0.04;

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
    frames: Option<PathBuf>,
    end: Option<PathBuf>,
    contacts: Option<PathBuf>,
}

fn run() -> Result<String, String> {
    let arguments = Arguments::read(std::env::args().skip(1))?;
    let path = arguments
        .scene
        .ok_or("no scene: name the TOML file to run")?;
    let before = memory("VmRSS:");
    let loaded = Scene::from_file(path).map_err(|e| e.to_string())?;
    let outputs = Outputs {
        frames: arguments.frames.as_deref(),
        end: arguments.end.as_deref(),
        contacts: arguments.contacts.as_deref(),
        mean_s: MEAN,
    };
    let measured = measure(loaded.scene, outputs, before)?;
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
                "--frames" => read.frames = Some(value()?.into()),
                "--contacts" => read.contacts = Some(value()?.into()),
                "--end" => read.end = Some(value()?.into()),
                option if option.starts_with('-') => {
                    return Err(format!("{option}: known are --frames, --contacts, --end"));
                }
                _ => read.scene = Some(word.into()),
            }
        }
        Ok(read)
    }
}
