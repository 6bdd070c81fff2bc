//! Builds the foreign FMU and packs it, whole or broken.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use zip::write::SimpleFileOptions;

/// How the library is built.
#[allow(dead_code, reason = "each test binary uses its own part")]
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Build {
    Whole,
    WithoutDoStep,
    WithoutStates,
    UndefinedSymbol,
    OtherVersion,
    OtherTypes,
    NoInstance,
    SetupFails,
    LoadExits,
    InstanceExits,
}

impl Build {
    fn definition(self) -> &'static str {
        match self {
            Self::Whole => "WHOLE",
            Self::WithoutDoStep => "WITHOUT_DO_STEP",
            Self::WithoutStates => "WITHOUT_STATES",
            Self::UndefinedSymbol => "UNDEFINED_SYMBOL",
            Self::OtherVersion => "OTHER_VERSION",
            Self::OtherTypes => "OTHER_TYPES",
            Self::NoInstance => "NO_INSTANCE",
            Self::SetupFails => "SETUP_FAILS",
            Self::LoadExits => "LOAD_EXITS",
            Self::InstanceExits => "INSTANCE_EXITS",
        }
    }
}

fn source(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/foreign_fmu")
        .join(name)
}

/// The shared library, built on first use.
fn library(build: Build) -> PathBuf {
    let definition = format!("-D{}", build.definition());
    let oscillator = source("oscillator.c");
    compiled(build.definition(), &[Path::new(&definition), &oscillator])
}

/// A shared library of this name, built by `cc` with these arguments on first use.
fn compiled(name: &str, arguments: &[&Path]) -> PathBuf {
    static BUILDING: Mutex<()> = Mutex::new(());
    let _guard = BUILDING.lock().unwrap_or_else(|error| error.into_inner());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign_fmu");
    std::fs::create_dir_all(&folder).unwrap();
    // The process is part of the name: other test processes may build at the same time.
    let library = folder.join(format!("{name}-{}.so", std::process::id()));
    if !library.is_file() {
        let status = Command::new("cc")
            .args(["-O2", "-Wall", "-Wextra", "-shared", "-fPIC"])
            .args(arguments)
            .arg("-o")
            .arg(&library)
            .arg("-lm")
            .status()
            .expect("the tests of the importer need a C compiler named `cc`");
        assert!(status.success());
    }
    library
}

/// Folder of this platform's binaries.
fn platform() -> &'static str {
    if cfg!(target_os = "macos") {
        "darwin64"
    } else {
        "linux64"
    }
}

/// The same for FMI 3.0.
fn tuple() -> String {
    let system = match std::env::consts::OS {
        "macos" => "darwin",
        system => system,
    };
    format!("{}-{system}", std::env::consts::ARCH)
}

/// Packs the FMU of FMI 3.0 that needs its importer for events; its steps have any length, or one.
#[allow(dead_code, reason = "each test binary uses its own part")]
pub(crate) fn pack_events(folder: &Path, any_step: bool) -> PathBuf {
    let mut xml = std::fs::read_to_string(source("events.xml")).unwrap();
    let headers = PathBuf::from(format!("-I{}", source("reference_fmus/include").display()));
    let (name, definition) = match any_step {
        true => ("events", "-DANY_STEP"),
        false => ("events-of-one-step", "-DONE_STEP"),
    };
    if !any_step {
        let flags =
            "canHandleVariableCommunicationStepSize=\"true\" mightReturnEarlyFromDoStep=\"true\" ";
        assert!(xml.contains(flags));
        xml = xml.replace(flags, "");
    }
    let arguments = [Path::new(definition), &headers, &source("events.c")];
    let library = std::fs::read(compiled(name, &arguments)).unwrap();
    let binary = format!(
        "binaries/{}/events{}",
        tuple(),
        std::env::consts::DLL_SUFFIX
    );
    let path = folder.join("events.fmu");
    let entries = [
        ("modelDescription.xml", xml.into_bytes()),
        (&*binary, library),
    ];
    write_archive(&path, &entries);
    path
}

/// Names and contents of the files of the FMU, its description first.
pub(crate) fn entries(build: Build, edit: impl FnOnce(&mut String)) -> Vec<(String, Vec<u8>)> {
    let mut xml = std::fs::read_to_string(source("modelDescription.xml")).unwrap();
    edit(&mut xml);
    vec![
        ("modelDescription.xml".to_owned(), xml.into_bytes()),
        (
            format!(
                "binaries/{}/oscillator{}",
                platform(),
                std::env::consts::DLL_SUFFIX
            ),
            std::fs::read(library(build)).unwrap(),
        ),
        (
            "resources/readme.txt".to_owned(),
            b"trace.txt comes here".to_vec(),
        ),
    ]
}

/// Writes the FMU to `path`, its description edited.
pub(crate) fn pack(path: &Path, build: Build, edit: impl FnOnce(&mut String)) {
    let entries = entries(build, edit);
    let entries: Vec<_> = entries
        .iter()
        .map(|(name, bytes)| (&**name, bytes.clone()))
        .collect();
    write_archive(path, &entries);
}

/// Writes an archive of these files, whatever their names.
pub(crate) fn write_archive(path: &Path, entries: &[(&str, Vec<u8>)]) {
    let mut archive = zip::ZipWriter::new(File::create(path).unwrap());
    for (name, bytes) in entries {
        archive
            .start_file(*name, SimpleFileOptions::default())
            .unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap();
}

/// Writes an archive of one symbolic link.
pub(crate) fn write_link(path: &Path, name: &str, target: &str) {
    let mut archive = zip::ZipWriter::new(File::create(path).unwrap());
    archive
        .add_symlink(name, target, SimpleFileOptions::default())
        .unwrap();
    archive.finish().unwrap();
}

/// Packs one of the Reference FMUs of the Modelica Association, built here from its sources for FMI 2.0, as `<model>.fmu`.
#[allow(dead_code, reason = "each test binary uses its own part")]
pub(crate) fn pack_reference(folder: &Path, model: &str) -> PathBuf {
    pack_reference_of(folder, model, 2)
}

/// As [`pack_reference`], for FMI 2.0 or 3.0.
#[allow(dead_code, reason = "each test binary uses its own part")]
pub(crate) fn pack_reference_of(folder: &Path, model: &str, version: u32) -> PathBuf {
    let sources = source("reference_fmus");
    let include = |part: &str| PathBuf::from(format!("-I{}", sources.join(part).display()));
    let (headers, own) = (include("include"), include(model));
    let functions = format!("src/fmi{version}Functions.c");
    let files = [&*functions, "src/cosimulation.c"].map(|file| sources.join(file));
    let definition = format!("-DFMI_VERSION={version}");
    let arguments = [
        Path::new(&definition),
        Path::new("-DDISABLE_PREFIX"),
        Path::new("-w"),
        &headers,
        &own,
        &files[0],
        &files[1],
        &sources.join(model).join("model.c"),
    ];
    let platform = match version {
        2 => platform().to_owned(),
        _ => tuple(),
    };
    let binary = format!(
        "binaries/{platform}/{model}{}",
        std::env::consts::DLL_SUFFIX
    );
    let description = format!("FMI{version}.xml");
    let entries = [
        (
            "modelDescription.xml",
            std::fs::read(sources.join(model).join(description)).unwrap(),
        ),
        (
            &*binary,
            std::fs::read(compiled(&format!("{model}{version}"), &arguments)).unwrap(),
        ),
    ];
    let path = folder.join(format!("{model}.fmu"));
    write_archive(&path, &entries);
    path
}
