//! Ctrl-C: the run ends after its current step, and every file is complete.

#![cfg(unix)]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::{Said, command, frames, funnel, rows};

/// Starts the command, waits until `sign` says that it is under way, and presses Ctrl-C.
fn interrupt(folder: &Path, arguments: &[&str], sign: &Path) -> Said {
    let mut started = command(folder, arguments);
    let child = started
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let began = Instant::now();
    while !sign.exists() {
        assert!(
            began.elapsed() < Duration::from_secs(120),
            "{} never came",
            sign.display()
        );
        std::thread::sleep(Duration::from_millis(10));
    }
    let id = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .unwrap()
            .success()
    );
    child.wait_with_output().unwrap().into()
}

/// Too long to come to its end.
fn long(folder: &Path) {
    funnel(folder, &[("duration = 8.6", "duration = 1e6")]);
}

#[test]
fn a_run_that_is_interrupted_leaves_complete_files() {
    let folder = tempfile::tempdir().unwrap();
    long(folder.path());
    let out = folder.path().join("out");
    let told = interrupt(
        folder.path(),
        &["run", "funnel.toml", "-o", "out"],
        &out.join("spheres_000003.vtu"),
    );
    assert_eq!(told.code, Some(130), "{}", told.error);
    assert!(told.error.contains("interrupted at "), "{}", told.error);
    assert!(told.out.contains("worst overlap"), "{}", told.out);
    let count = frames(&out.join("spheres.pvd"));
    assert!(count >= 4, "{count} frames");
    assert!(told.out.contains(&format!(
        "{count} frames, {} rows",
        rows(&out.join("history.csv"))
    )));
}

#[test]
fn a_simulation_that_is_interrupted_leaves_complete_files() {
    let folder = tempfile::tempdir().unwrap();
    long(folder.path());
    crate::command::done(folder.path(), &["export", "funnel.toml"]);
    let out = folder.path().join("out");
    let told = interrupt(
        folder.path(),
        &[
            "simulate",
            "funnel.fmu",
            "--step",
            "0.01",
            "-o",
            "outputs.csv",
            "--set",
            "output.directory=out",
        ],
        &out,
    );
    assert_eq!(told.code, Some(130), "{}", told.error);
    assert!(rows(&folder.path().join("outputs.csv")) > 0);
    let results = std::fs::read_dir(&out)
        .unwrap()
        .next()
        .unwrap()
        .unwrap()
        .path();
    assert!(frames(&results.join("spheres.pvd")) > 0);
}
