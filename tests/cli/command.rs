//! Starts the command and looks at what it leaves.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The command in a folder of its own, with plain messages.
pub(crate) fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sphere-dda"));
    command
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .env_remove("SPHERE_DDA_LIBRARY")
        .stdin(Stdio::null());
    command
}

/// What it says, and its exit code.
pub(crate) struct Said {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) error: String,
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        let said = Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            error: String::from_utf8(output.stderr).unwrap(),
        };
        assert!(!said.error.contains("panicked"), "{}", said.error);
        said
    }
}

/// Runs the command to its end.
pub(crate) fn said(folder: &Path, arguments: &[&str]) -> Said {
    command(folder, arguments).output().unwrap().into()
}

/// As [`said`], for what must succeed.
pub(crate) fn done(folder: &Path, arguments: &[&str]) -> Said {
    let said = said(folder, arguments);
    assert_eq!(said.code, Some(0), "{arguments:?}: {}", said.error);
    said
}

/// What a terminal of 80 columns shows of a command line that must succeed.
#[cfg(target_os = "linux")]
pub(crate) fn on_a_terminal(folder: &Path, line: &str) -> String {
    let shown = Command::new("script")
        .args(["-qec", &format!("stty cols 80; {line}"), "/dev/null"])
        .current_dir(folder)
        .env("TERM", "xterm")
        .output()
        .unwrap();
    assert!(shown.status.success(), "{shown:?}");
    String::from_utf8_lossy(&shown.stdout).into_owned()
}

/// An example scene.
pub(crate) fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../examples/{name}/{name}.toml"))
}

/// The funnel in `folder`, with `changes` to its text.
pub(crate) fn funnel(folder: &Path, changes: &[(&str, &str)]) -> PathBuf {
    let mut text = std::fs::read_to_string(example("funnel")).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "the funnel has no `{from}`");
        text = text.replacen(from, to, 1);
    }
    let path = folder.join("funnel.toml");
    std::fs::write(&path, text).unwrap();
    path
}

/// Number of frames that a collection lists, each of which must be whole.
pub(crate) fn frames(pvd: &Path) -> usize {
    let text = std::fs::read_to_string(pvd).unwrap();
    assert!(text.trim_end().ends_with("</VTKFile>"), "{text}");
    let files: Vec<&str> = text
        .split("file=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap())
        .collect();
    for file in &files {
        let bytes = std::fs::read(pvd.with_file_name(file)).unwrap();
        let end = String::from_utf8_lossy(&bytes[bytes.len() - 20..]).into_owned();
        assert!(
            end.trim_end().ends_with("</VTKFile>"),
            "{file} ends with {end}"
        );
    }
    files.len()
}

/// Lines of a CSV file without its header; all must have as many fields as it.
pub(crate) fn rows(csv: &Path) -> usize {
    let text = std::fs::read_to_string(csv).unwrap();
    assert!(text.ends_with('\n'));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map(Result::unwrap).count()
}
