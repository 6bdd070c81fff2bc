//! `sphere-dda run`: the solver without an FMU.

use std::fs;
#[cfg(unix)]
use std::process::Command;

use crate::command::{command, done, example, frames, funnel, rows, said};

#[test]
fn a_run_writes_frames_history_and_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    let scene = example("funnel");
    let told = done(
        folder.path(),
        &[
            "run",
            scene.to_str().unwrap(),
            "-o",
            "out",
            "--stop",
            "0.305",
        ],
    );
    let out = folder.path().join("out");
    for series in ["spheres", "contacts", "boundaries"] {
        assert_eq!(frames(&out.join(format!("{series}.pvd"))), 4, "{series}");
    }
    // The start, 30 whole steps and the half one to the stop time.
    assert_eq!(rows(&out.join("history.csv")), 32);
    let history = fs::read_to_string(out.join("history.csv")).unwrap();
    assert!(history.lines().last().unwrap().starts_with("0.305,"));
    assert!(out.join("view.py").is_file());
    assert!(
        fs::read_to_string(out.join("run.json"))
            .unwrap()
            .contains("scene_hash")
    );
    for part in [
        "0.305 s in 31 steps, 0 cuts",
        "sweeps",
        "worst overlap",
        "wall time",
        "out/view.py",
    ] {
        assert!(told.out.contains(part), "{part} is not in\n{}", told.out);
    }
}

#[test]
fn method_and_solver_can_be_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let scene = funnel(folder.path(), &[]);
    let run = |more: &[&str]| {
        let mut arguments = vec![
            "run",
            scene.to_str().unwrap(),
            "-o",
            "out",
            "--overwrite",
            "--stop",
            "0.3",
        ];
        arguments.extend(more);
        done(folder.path(), &arguments).out
    };
    assert!(run(&["--solver", "gauss-seidel"]).contains(" 0 factorizations"));
    assert!(!run(&["--solver", "direct"]).contains(" 0 factorizations"));
    run(&["--method", "penalty"]);
    let about = fs::read_to_string(folder.path().join("out/run.json")).unwrap();
    assert!(about.contains("\"method\": \"penalty\""), "{about}");
}

#[test]
fn an_earlier_run_is_replaced_only_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let scene = example("funnel");
    let arguments = ["run", scene.to_str().unwrap(), "-o", "out", "--stop", "0.2"];
    done(folder.path(), &arguments);
    let history = folder.path().join("out/history.csv");
    fs::write(folder.path().join("out/notes.txt"), "mine").unwrap();
    fs::write(&history, "old\n").unwrap();

    let refused = said(folder.path(), &arguments);
    assert_eq!(refused.code, Some(2));
    assert!(
        refused.error.contains("already holds a run"),
        "{}",
        refused.error
    );
    assert_eq!(fs::read_to_string(&history).unwrap(), "old\n");

    done(folder.path(), &[&arguments[..], &["--overwrite"]].concat());
    assert_eq!(rows(&history), 21);
    assert!(folder.path().join("out/notes.txt").is_file());
}

#[test]
fn a_step_that_fails_leaves_what_was_reached_and_exits_with_1() {
    let folder = tempfile::tempdir().unwrap();
    // One sweep cannot solve a heap, and a step that may not be cut is then given up.
    let scene = funnel(
        folder.path(),
        &[(
            "step = 0.01",
            "step = 0.01\nmax_iterations = 1\nmax_cuts = 0",
        )],
    );
    let told = said(
        folder.path(),
        &["run", scene.to_str().unwrap(), "-o", "out"],
    );
    assert_eq!(told.code, Some(1), "{}{}", told.out, told.error);
    for part in ["step from t = ", "stays above", "loosen tolerance"] {
        assert!(
            told.error.contains(part),
            "{part} is not in\n{}",
            told.error
        );
    }
    let out = folder.path().join("out");
    assert!(frames(&out.join("spheres.pvd")) > 0);
    assert!(rows(&out.join("history.csv")) > 0);
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_told_at_once_and_fails_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let scene = funnel(folder.path(), &[]);
    // Files may have 24 blocks of 512 or 1024 bytes: rows fit, frames do not, and writing on is an error, no signal.
    let limited = "trap '' XFSZ; ulimit -f 24; exec \"$@\"";
    let told = Command::new("sh")
        .args(["-c", limited, "sh", env!("CARGO_BIN_EXE_sphere-dda"), "run"])
        // Long enough for the writer to fail before the run ends.
        .args([scene.to_str().unwrap(), "-o", "out", "--stop", "1.5"])
        .current_dir(folder.path())
        .env("NO_COLOR", "1")
        .output()
        .unwrap();
    let error = String::from_utf8(told.stderr).unwrap();
    assert_eq!(told.status.code(), Some(1), "{error}");
    let at_once = error.find("a result was not written, the run continues: ");
    let in_the_end = error.find("results were not written; the first: ");
    assert!(at_once.is_some() && at_once < in_the_end, "{error}");
    assert_eq!(error.matches("the run continues").count(), 1, "{error}");
    assert!(error.contains("spheres_000000.vtu"), "{error}");
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    let folder = tempfile::tempdir().unwrap();
    let scene = example("funnel");
    for arguments in [vec!["check", scene.to_str().unwrap()], vec!["--help"]] {
        let mut child = command(folder.path(), &arguments)
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        drop(child.stderr.take());
        let status = child.wait().unwrap();
        assert_eq!(status.code(), Some(0), "{arguments:?}");
    }
}
