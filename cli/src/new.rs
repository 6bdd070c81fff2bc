//! `sphere-dda new KIND NAME`: a folder to begin with.

mod kinds;

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use miette::miette;
use sphere_dda::scene_file::json_schema;

use crate::failure::Failure;
use crate::progress::print;
use kinds::{Kind, Parts};

const README: &str = include_str!("new/README.md.in");
const DRIVER: &str = include_str!("new/drive.py.in");
/// The line by which editors find the schema: that of the examples, and that of a folder of its own.
const SCHEMA_LINES: [&str; 2] = [
    "#:schema ../../docs/scene.schema.json",
    "#:schema scene.schema.json",
];

/// Arguments of `new`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda new hopper silo                 the folder silo with silo.toml, drive.py and README.md
  sphere-dda new feeder machines/feeder2")]
pub(crate) struct New {
    /// What to begin with.
    kind: Kind,
    /// The folder to make; its last part is the name of the scene.
    name: PathBuf,
}

/// Makes the folder.
///
/// # Errors
/// A name that is none, a folder that is there already or cannot be written.
pub(crate) fn run(arguments: &New) -> Result<(), Failure> {
    let folder = &arguments.name;
    let name = folder.file_name().and_then(|name| name.to_str());
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let Some(name) = name.filter(|name| name.chars().all(plain)) else {
        return Err(Failure::Input(miette!(
            "found `{}`, expected the name of a folder of letters, digits, `_` and `-`",
            folder.display()
        )));
    };
    if folder.exists() {
        return Err(Failure::Input(miette!(
            "`{}` exists already: choose another name",
            folder.display()
        )));
    }
    fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
    let files = files(arguments.kind, name);
    for (file, text) in &files {
        let path = folder.join(file);
        fs::write(&path, text).map_err(|error| unwritable(&path, &error))?;
    }
    print(|out| {
        let names: Vec<&str> = files.iter().map(|(file, _)| &**file).collect();
        writeln!(out, "{}: {}", folder.display(), names.join(", "))?;
        writeln!(
            out,
            "To view:        sphere-dda view {} --open",
            folder.join(format!("{name}.toml")).display()
        )
    })
}

fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Input(miette!("cannot write `{}`: {error}", path.display()))
}

/// Names and texts of the files in the folder of the scene `name`.
fn files(kind: Kind, name: &str) -> Vec<(String, String)> {
    let Parts {
        scene,
        files,
        inputs,
        outputs,
        times: [stop, step],
    } = kind.parts();
    let value = kind.to_possible_value();
    let word = value.as_ref().map_or("scene", |value| value.get_name());
    let about = value.as_ref().and_then(|value| value.get_help());
    let about = about.map(ToString::to_string).unwrap_or_default();
    let of_example = format!("examples/{word}/{word}.toml");
    let scene = scene
        .replacen(SCHEMA_LINES[0], SCHEMA_LINES[1], 1)
        .replace(&of_example, &format!("{name}.toml"));
    let inputs: Vec<String> = inputs
        .iter()
        .map(|(input, value)| format!("\"{input}\": lambda t: {value}"))
        .collect();
    // A scene has one of the two.
    let [parameter, usual, other] = match scene.contains("\nfriction_angle = ") {
        true => ["friction_angle", "20.0", "10"],
        false => ["friction", "0.4", "0.2"],
    };
    let outputs: Vec<String> = outputs.iter().map(|name| format!("\"{name}\"")).collect();
    let filled = |text: &str| {
        text.replace("{NAME}", name)
            .replace("{ABOUT}", &format!("{}.", about.trim_end_matches('.')))
            .replace("{INPUTS}", &inputs.join(", "))
            .replace("{OUTPUTS}", &outputs.join(", "))
            .replace("{STOP}", stop)
            .replace("{STEP}", step)
            .replace("{PARAMETER}", parameter)
            .replace("{USUAL}", usual)
            .replace("{OTHER}", other)
    };
    let schema = format!("{:#}\n", json_schema());
    let mut all = vec![
        (format!("{name}.toml"), scene),
        ("scene.schema.json".to_owned(), schema),
        ("drive.py".to_owned(), filled(DRIVER)),
        ("README.md".to_owned(), filled(README)),
    ];
    let own = files.iter().map(|(file, text)| (*file, *text));
    all.extend(own.map(|(file, text)| (file.to_owned(), text.to_owned())));
    all
}
