//! Ctrl-C, SIGTERM, SIGHUP: the run ends after its current step, and every file is complete.

#![cfg(unix)]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::{Said, command, frames, funnel, rows};

/// Starts the command, waits until `sign` says that it is under way, and sends the signal.
fn interrupt(signal: &str, folder: &Path, arguments: &[&str], sign: &Path) -> Said {
    let mut started = command(folder, arguments);
    let temporary = folder.join("tmp");
    if temporary.exists() {
        started.env("TMPDIR", temporary);
    }
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
            .args([signal, &id])
            .status()
            .unwrap()
            .success()
    );
    child.wait_with_output().unwrap().into()
}

/// Too long to come to its end; its FMU writes to the folder `funnel`.
fn long(folder: &Path) {
    let title = "Funnel flow (reconstruction of Beyabanaki & Bagtzoglou 2020)";
    let changes = [("duration = 8.6", "duration = 1e6"), (title, "funnel")];
    funnel(folder, &changes);
}

/// Fault: SIGTERM, which schedulers and containers send first, ended a run without a checkpoint.
#[test]
fn a_run_that_is_interrupted_leaves_complete_files() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        run_that_gets(signal);
    }
}

fn run_that_gets(signal: &str) {
    let folder = tempfile::tempdir().unwrap();
    long(folder.path());
    let out = folder.path().join("out");
    let told = interrupt(
        signal,
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
    let names = std::fs::read_dir(&out).unwrap();
    let mut names = names.map(|entry| entry.unwrap().file_name());
    let checkpoint = |name: std::ffi::OsString| name.to_string_lossy().contains("checkpoint");
    assert!(names.any(checkpoint), "{signal}");
}

/// Fault: SIGTERM left the unpacked FMU and lost all rows, as did a process that was killed.
#[test]
fn a_simulation_that_is_interrupted_leaves_complete_files() {
    for (signal, code) in [("-INT", Some(130)), ("-TERM", Some(130)), ("-KILL", None)] {
        simulation_that_gets(signal, code);
    }
}

fn simulation_that_gets(signal: &str, code: Option<i32>) {
    let folder = tempfile::tempdir().unwrap();
    long(folder.path());
    crate::command::done(folder.path(), &["export", "funnel.toml"]);
    let out = folder.path().join("out");
    let temporary = folder.path().join("tmp");
    std::fs::create_dir(&temporary).unwrap();
    let told = interrupt(
        signal,
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
        &out.join("funnel").join("spheres_000001.vtu"),
    );
    assert_eq!(told.code, code, "{}", told.error);
    assert!(rows(&folder.path().join("outputs.csv")) > 0);
    let unpacked = std::fs::read_dir(&temporary).unwrap().count();
    assert!(
        code.is_none() || unpacked == 0,
        "{signal} leaves {unpacked} folders"
    );
    let results = std::fs::read_dir(&out)
        .unwrap()
        .next()
        .unwrap()
        .unwrap()
        .path();
    assert!(frames(&results.join("spheres.pvd")) > 0);
}
