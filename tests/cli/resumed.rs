//! `run --resume`: goes on from the last checkpoint, starts, or has nothing left to do; refuses what does not fit.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::command::{Said, done, funnel, said};

/// The funnel with checkpoints; `stop` \[s\] as typed.
fn run(folder: &Path, out: &str, stop: &str, more: &[&str]) -> Said {
    let begin = ["run", "funnel.toml", "-o", out, "--stop", stop];
    said(folder, &[&begin[..], more].concat())
}

fn complete(folder: &Path, out: &str, stop: &str, more: &[&str]) -> Said {
    let told = run(folder, out, stop, more);
    assert_eq!(told.code, Some(0), "{}", told.error);
    told
}

fn prepare() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let output = "[output]\ncheckpoint_interval = 0.1";
    funnel(folder.path(), &[("[output]", output)]);
    folder
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        (name, fs::read(entry.path()).unwrap())
    });
    entries.collect()
}

fn same(folder: &Path, a: &str, b: &str) {
    let (a, b) = (files(&folder.join(a)), files(&folder.join(b)));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in &a {
        assert!(b[name] == *bytes, "{name} differs");
    }
}

/// Names of the checkpoints, oldest first.
fn checkpoints(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = files(folder).into_keys().collect();
    names.retain(|name| name.starts_with("checkpoint_"));
    names
}

/// A run that an error has stopped at 0.4 s: nothing of it has been tidied up.
fn stopped(folder: &Path, out: &str) {
    // The frame of 0.5 s cannot be written, so no checkpoint follows that of 0.4 s.
    fs::create_dir_all(folder.join(out).join("spheres_000005.vtu.tmp")).unwrap();
    let told = run(folder, out, "0.7", &[]);
    assert_eq!(told.code, Some(1), "{}", told.error);
    assert!(
        told.error.contains("spheres_000005.vtu.tmp"),
        "{}",
        told.error
    );
    fs::remove_dir(folder.join(out).join("spheres_000005.vtu.tmp")).unwrap();
    let numbers = [20, 30, 40].map(|k| format!("checkpoint_{k:06}.state"));
    assert_eq!(checkpoints(&folder.join(out)), numbers);
}

#[test]
fn a_finished_run_can_be_made_longer_and_is_otherwise_left_alone() {
    let folder = prepare();
    let folder = folder.path();
    complete(folder, "whole", "0.62", &[]);
    // No multiple of the step, and one that is not for rounding: 57 * 0.01 > 0.57.
    let mut more: &[&str] = &[];
    for (stop, goes_on) in [
        ("0.57", None),
        ("0.605", Some("0.56")),
        ("0.62", Some("0.6")),
    ] {
        let told = complete(folder, "out", stop, more);
        if let Some(time) = goes_on {
            let text = format!("resumes at {time} s");
            assert!(told.error.contains(&text), "{}", told.error);
            assert!(
                told.out.contains(&format!("s (resumed at {time} s) in")),
                "{}",
                told.out
            );
        }
        more = &["--resume"];
    }
    same(folder, "out", "whole");
    assert_eq!(
        checkpoints(&folder.join("out")),
        ["checkpoint_000062.state"]
    );
    let told = complete(folder, "out", "0.62", more);
    assert!(
        told.error.contains("is finished at 0.62 s"),
        "{}",
        told.error
    );
    assert!(told.out.contains("7 frames, 63 rows"), "{}", told.out);
    same(folder, "out", "whole");
}

#[test]
fn a_directory_without_a_run_is_begun() {
    let folder = prepare();
    let folder = folder.path();
    complete(folder, "whole", "0.2", &[]);
    let told = complete(folder, "out", "0.2", &["--resume"]);
    assert!(
        told.error.contains("no checkpoint in `out`"),
        "{}",
        told.error
    );
    same(folder, "out", "whole");
}

#[test]
fn a_damaged_checkpoint_is_passed_over() {
    let folder = prepare();
    let folder = folder.path();
    complete(folder, "whole", "0.7", &[]);
    stopped(folder, "out");
    let [second, newest] = ["checkpoint_000030.state", "checkpoint_000040.state"];
    let damage = |name: &str| {
        let path = folder.join("out").join(name);
        let mut bytes = fs::read(&path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(&path, bytes).unwrap();
    };
    damage(newest);
    // What a kill leaves that nothing writes again: the draft of a checkpoint for Ctrl-C, a frame not yet listed.
    for name in ["checkpoint_000043.state.tmp", "contacts_000099.vtu"] {
        fs::write(folder.join("out").join(name), "").unwrap();
    }
    let told = complete(folder, "out", "0.7", &["--resume"]);
    for part in [&format!("ignored {newest}"), "checksum", "resumes at 0.3 s"] {
        assert!(told.error.contains(part), "{part} is not in {}", told.error);
    }
    same(folder, "out", "whole");

    fs::remove_dir_all(folder.join("out")).unwrap();
    stopped(folder, "out");
    for name in [newest, second, "checkpoint_000020.state"] {
        damage(name);
    }
    let before = files(&folder.join("out"));
    let told = run(folder, "out", "0.7", &["--resume"]);
    assert_eq!(told.code, Some(2), "{}", told.error);
    for part in [
        "no checkpoint in `out` can be used",
        newest,
        second,
        "start a new run",
    ] {
        assert!(told.error.contains(part), "{part} is not in {}", told.error);
    }
    assert!(
        files(&folder.join("out")) == before,
        "something has changed"
    );
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_changes() {
    let folder = prepare();
    let folder = folder.path();
    stopped(folder, "out");
    let before = files(&folder.join("out"));
    let refused = |stop: &str, more: &[&str], parts: &[&str]| {
        let told = run(folder, "out", stop, &[&["--resume"], more].concat());
        assert_eq!(told.code, Some(2), "{more:?}: {}", told.error);
        for part in parts {
            assert!(told.error.contains(part), "{part} is not in {}", told.error);
        }
    };
    refused(
        "0.6",
        &["--method", "penalty", "--solver", "direct"],
        &[
            "`out` holds another run",
            "settings.duration is 0.7, now 0.6",
            "settings.method is \"alm\", now \"penalty\"",
            "settings.solver is \"auto\", now \"direct\"",
        ],
    );
    refused("0.7", &["--overwrite"], &["cannot be used with"]);

    let history = folder.join("out/history.csv");
    let text = fs::read_to_string(&history).unwrap();
    let short: Vec<&str> = text.lines().take(30).collect();
    fs::write(&history, short.join("\n")).unwrap();
    refused(
        "0.7",
        &[],
        &["history.csv", "0.27 s as the last entry", "up to 0.4 s"],
    );
    fs::write(&history, text.replacen("time [s]", "time", 1)).unwrap();
    refused("0.7", &[], &["history.csv", "another header"]);
    fs::write(&history, &text).unwrap();
    let pvd = folder.join("out/contacts.pvd");
    let list = fs::read(&pvd).unwrap();
    fs::remove_file(&pvd).unwrap();
    refused("0.7", &[], &["contacts.pvd", "no entry"]);
    fs::write(&pvd, list).unwrap();

    let about = folder.join("out/run.json");
    let run_json = fs::read(&about).unwrap();
    fs::remove_file(&about).unwrap();
    refused("0.7", &[], &["already holds a run"]);
    fs::write(&about, run_json).unwrap();

    let scene = folder.join("funnel.toml");
    let text = fs::read_to_string(&scene).unwrap();
    fs::write(&scene, text.replacen("seed = 1", "seed = 7", 1)).unwrap();
    refused("0.7", &[], &["scene_hash is", "has changed"]);
    assert!(
        files(&folder.join("out")) == before,
        "something has changed"
    );
}

/// Fault: results do not depend on `threads`, but with another number the run was "another run", and a start "of another scene".
#[test]
fn a_run_and_a_start_go_on_with_other_threads() {
    let folder = prepare();
    let folder = folder.path();
    complete(
        folder,
        "whole",
        "0.2",
        &["--settle", "0.1", "--start", "a.start"],
    );
    complete(folder, "out", "0.1", &["--start", "a.start"]);
    let scene = folder.join("funnel.toml");
    let text = fs::read_to_string(&scene).unwrap();
    let threads = text.replacen("[simulation]", "[simulation]\nthreads = 2", 1);
    fs::write(&scene, threads).unwrap();
    let more = ["--resume", "--settle", "0.1", "--start", "a.start"];
    let told = complete(folder, "out", "0.15", &more);
    assert!(told.error.contains("start read from"), "{}", told.error);
    assert!(told.error.contains("resumes at 0.1 s"), "{}", told.error);
    complete(
        folder,
        "out",
        "0.2",
        &[&more[..], &["--threads", "3"]].concat(),
    );
    let history = |out: &str| fs::read(folder.join(out).join("history.csv")).unwrap();
    assert!(history("out") == history("whole"));
    let told = run(folder, "out", "0.2", &["--threads", "0"]);
    assert!(told.error.contains("1..=256"), "{}", told.error);
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_goes_on_and_two_runs_do_not_share_a_directory() {
    use crate::command::command;
    use std::process::{Command, Stdio};

    let folder = prepare();
    let folder = folder.path();
    complete(folder, "whole", "1.1", &[]);
    let arguments = ["run", "funnel.toml", "-o", "out", "--stop", "1.1"];
    let child = command(folder, &arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let began = std::time::Instant::now();
    while !folder.join("out/spheres_000005.vtu").exists() {
        assert!(began.elapsed().as_secs() < 120, "no frame 5");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let interrupt = |signal: &str| {
        let id = child.id().to_string();
        assert!(
            Command::new("kill")
                .args([signal, &id])
                .status()
                .unwrap()
                .success()
        );
    };
    // Held, so that it cannot come to its end before the other has met it.
    interrupt("-STOP");
    let second = run(folder, "out", "1.1", &["--resume"]);
    interrupt("-CONT");
    interrupt("-INT");
    assert_eq!(second.code, Some(2), "{}", second.error);
    assert!(
        second.error.contains("another run is writing"),
        "{}",
        second.error
    );
    let told: Said = child.wait_with_output().unwrap().into();
    assert_eq!(told.code, Some(130), "{}", told.error);

    let time = told.error.split("interrupted at ").nth(1).unwrap();
    let time = time.split(" s").next().unwrap();
    let told = complete(folder, "out", "1.1", &["--resume"]);
    assert!(
        told.error.contains(&format!("resumes at {time} s")),
        "{}",
        told.error
    );
    same(folder, "out", "whole");
}

#[test]
fn a_checkpoint_interval_is_a_time() {
    let folder = prepare();
    for wrong in ["-1", "nan", "soon"] {
        let told = run(
            folder.path(),
            "out",
            "0.1",
            &["--checkpoint-interval", wrong],
        );
        assert_eq!(told.code, Some(2));
        assert!(
            told.error.contains("--checkpoint-interval"),
            "{}",
            told.error
        );
    }
    assert!(!folder.path().join("out").exists());
    let help = done(folder.path(), &["run", "--help"]).out;
    assert!(help.contains("--resume"), "{help}");
}
