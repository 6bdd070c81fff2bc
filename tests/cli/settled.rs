//! Scenes that settle before their t = 0, and the files that keep their starts.

use std::fs;
use std::path::Path;

use crate::command::{done, said};
#[cfg(target_os = "linux")]
use crate::command::{funnel, on_a_terminal};

/// Grains above a floor between walls.
const BIN: &str = r#"
title = "Bin"
[simulation]
duration = 0.02
step = 0.002
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "fill"
material = "grain"
radius = 0.02
lattice = { origin = [0.0, 0.0, 0.05], count = [3, 3, 1], spacing = 0.045 }
[[boundary]]
name = "floor"
material = "grain"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
"#;

fn bin(folder: &Path) {
    fs::write(folder.join("bin.toml"), BIN).unwrap();
}

/// Fault: a terminal of 80 columns cut off when a run or a settling will be done.
#[cfg(target_os = "linux")]
#[test]
fn a_narrow_terminal_shows_when_it_will_be_done() {
    let folder = tempfile::tempdir().unwrap();
    funnel(folder.path(), &[]);
    let run = format!(
        "{} run funnel.toml -o out --settle 2 --stop 6",
        env!("CARGO_BIN_EXE_sphere-dda")
    );
    let text = on_a_terminal(folder.path(), &run);
    for (of, what) in [("of 2 s, ETA", "settling"), ("of 6 s, ETA", "run")] {
        assert!(text.contains(of), "{what}: {text}");
    }
}

#[test]
fn a_start_is_kept_and_read_while_scene_and_options_are_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    bin(folder);
    let run = |more: &[&str]| {
        let first = ["run", "bin.toml", "-o", "out", "--overwrite"];
        done(folder, &[&first, more].concat())
    };
    let keep = ["--settle", "0.5", "--start", "bin.start"];
    let settled = run(&keep).error;
    assert!(settled.contains("settled in 0."), "{settled}");
    assert!(settled.contains("start kept in bin.start"), "{settled}");
    let about = fs::read(folder.join("out/run.json")).unwrap();
    let start = fs::read(folder.join("bin.start")).unwrap();

    let again = run(&keep).error;
    assert!(again.contains("start read from bin.start"), "{again}");
    assert!(!again.contains("settled in"), "{again}");
    assert_eq!(fs::read(folder.join("out/run.json")).unwrap(), about);
    assert_eq!(fs::read(folder.join("bin.start")).unwrap(), start);
    let bare = run(&["--start", "bin.start"]).error;
    assert!(bare.contains("start read from bin.start"), "{bare}");
    let exported = done(
        folder,
        &[&["export", "bin.toml", "-o", "bin.fmu"], &keep[..]].concat(),
    );
    assert!(
        exported.error.contains("start read from bin.start"),
        "{}",
        exported.error
    );

    // Other options or another scene: anew.
    let longer = run(&["--settle", "0.6", "--start", "bin.start"]).error;
    assert!(longer.contains("settling anew"), "{longer}");
    assert!(longer.contains("start kept in bin.start"), "{longer}");
    assert_ne!(fs::read(folder.join("bin.start")).unwrap(), start);
}

#[test]
fn a_start_that_does_not_fit_is_refused_and_left() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    bin(folder);
    let run = |more: &[&str]| {
        let first = ["run", "bin.toml", "-o", "out", "--overwrite"];
        said(folder, &[&first, more].concat())
    };
    let missing = run(&["--start", "bin.start"]);
    assert_eq!(missing.code, Some(2));
    assert!(
        missing.error.contains("no start file `bin.start`"),
        "{}",
        missing.error
    );

    fs::write(folder.join("notes.txt"), "mine").unwrap();
    let other = run(&["--settle", "0.1", "--start", "notes.txt"]);
    assert_eq!(other.code, Some(2));
    assert!(other.error.contains("is no start file"), "{}", other.error);
    assert_eq!(fs::read(folder.join("notes.txt")).unwrap(), b"mine");

    assert_eq!(
        run(&["--settle", "0.1", "--start", "bin.start"]).code,
        Some(0)
    );
    let whole = fs::read(folder.join("bin.start")).unwrap();
    fs::write(folder.join("bin.start"), &whole[..whole.len() - 9]).unwrap();
    let damaged = run(&["--settle", "0.1", "--start", "bin.start"]);
    assert_eq!(damaged.code, Some(2));
    assert!(damaged.error.contains("is damaged"), "{}", damaged.error);

    fs::write(folder.join("bin.start"), &whole).unwrap();
    fs::write(folder.join("bin.toml"), BIN.replace("2500", "2600")).unwrap();
    let changed = run(&["--start", "bin.start"]);
    assert_eq!(changed.code, Some(2));
    assert!(
        changed.error.contains("belongs to scene"),
        "{}",
        changed.error
    );
    assert!(
        changed.error.contains("--settle SECONDS"),
        "{}",
        changed.error
    );
    assert!(!folder.join("out/checkpoint_000003.state").exists());
}
