//! `sphere-dda corpus` and `run --dump-failed`: contact problems in and out.

use std::fs;
use std::path::{Path, PathBuf};

use crate::command::{done, funnel, rows, said};

fn problems() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../studies/problems")
}

#[test]
fn problems_of_others_are_solved_by_every_solver() {
    let folder = tempfile::tempdir().unwrap();
    let problems = problems();
    let arguments = [
        "corpus",
        problems.to_str().unwrap(),
        "--solver",
        "all",
        "-o",
        "out",
    ];
    let told = done(folder.path(), &arguments);
    for part in [
        "auto            8 of 8 problems solved",
        "newton          8 of 8",
        "Rover1039",
    ] {
        assert!(told.out.contains(part), "{part} is not in\n{}", told.out);
    }
    let out = folder.path().join("out");
    assert_eq!(rows(&out.join("corpus.csv")), 4 * 8);
    // The local form is a problem again, with as many impulses.
    let local = out.join("Rover1039.dat");
    done(folder.path(), &["corpus", local.to_str().unwrap()]);
    let impulses = fs::read_to_string(out.join("Rover1039.newton.txt")).unwrap();
    assert_eq!(impulses.lines().count(), 4);
}

#[test]
fn what_is_not_read_or_not_solved_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("cut.dat"), "3\n1\n0\n3\n3\n3 3\n1 2 3\n").unwrap();
    let told = said(path, &["corpus", "cut.dat"]);
    assert_eq!(told.code, Some(2));
    assert!(
        told.error
            .contains("`cut.dat`, line 7: found 3 more words, expected 9 numbers"),
        "{}",
        told.error
    );
    // Beside problems it is told and passed over.
    fs::copy(problems().join("Rover11035.dat"), path.join("rover.dat")).unwrap();
    let told = done(path, &["corpus", "."]);
    assert!(
        told.error.contains("cut.dat") && told.out.contains("1 of 1 problem solved"),
        "{}",
        told.out
    );
    assert_eq!(
        said(path, &["corpus", "rover.dat", "--solver", "magic"]).code,
        Some(2)
    );
    assert_eq!(
        said(path, &["corpus", "rover.dat", "--tolerance", "0"]).code,
        Some(2)
    );
    let hard = problems().join("OneObject-i1028-138.hdf5.dat");
    let told = said(
        path,
        &[
            "corpus",
            hard.to_str().unwrap(),
            "--max-sweeps",
            "3",
            "--max-factorizations",
            "1",
        ],
    );
    assert_eq!(told.code, Some(1));
    assert!(
        told.error
            .contains("1 of 1 problem not solved to 1e-8: OneObject-i1028-138.hdf5"),
        "{}",
        told.error
    );
}

#[test]
fn steps_that_fail_are_written_and_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let changes = [("strict = true", "strict = false\nmax_iterations = 1")];
    let scene = funnel(path, &changes);
    let scene = scene.to_str().unwrap();
    let run = ["run", scene, "--stop", "0.4", "--dump-failed", "failed"];
    let told = done(path, &[&run[..], &["-o", "a"]].concat());
    assert!(
        told.error.contains("failed step") && told.error.contains("written to `failed`"),
        "{}",
        told.error
    );
    let files = fs::read_dir(path.join("failed")).unwrap().count();
    assert!((1..=100).contains(&files), "{files}");
    let text = fs::read_to_string(path.join("failed/step-0001.dat")).unwrap();
    for part in [
        "# scene ",
        "# internal step of ",
        "residual",
        " contacts; 0 eliminated",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let told = done(path, &["corpus", "failed"]);
    assert!(
        told.out
            .contains(&format!("auto            {files} of {files} problem")),
        "{}",
        told.out
    );
    // A second run adds its own files; the results are those of a run without.
    done(path, &[&run[..], &["-o", "b"]].concat());
    assert_eq!(
        fs::read_dir(path.join("failed")).unwrap().count(),
        2 * files
    );
    done(path, &["run", scene, "--stop", "0.4", "-o", "c"]);
    let history = |name: &str| fs::read(path.join(name).join("history.csv")).unwrap();
    assert_eq!(history("a"), history("c"));
    fs::write(path.join("file"), "").unwrap();
    let told = said(path, &["run", scene, "-o", "d", "--dump-failed", "file"]);
    assert_eq!(told.code, Some(2));
    assert!(
        told.error.contains("--dump-failed: cannot make `file`"),
        "{}",
        told.error
    );
}

/// Symptom: a file of an earlier run was overwritten where their numbers had a gap.
#[test]
fn files_of_earlier_runs_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let changes = [("strict = true", "strict = false\nmax_iterations = 1")];
    let scene = funnel(path, &changes);
    let scene = scene.to_str().unwrap();
    fs::create_dir(path.join("failed")).unwrap();
    let earlier = path.join("failed/step-0002.dat");
    fs::write(&earlier, "earlier").unwrap();
    let run = [
        "run",
        scene,
        "--stop",
        "0.4",
        "-o",
        "a",
        "--dump-failed",
        "failed",
    ];
    done(path, &run);
    assert_eq!(fs::read_to_string(earlier).unwrap(), "earlier");
    assert!(path.join("failed/step-0003.dat").exists());
}

/// Symptom: a run whose `--dump-failed` could not be written could not be resumed: its last checkpoint had the number of the
/// communication step before the time it held.
#[cfg(target_os = "linux")]
#[test]
fn a_run_goes_on_after_a_file_that_was_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let changes = [("strict = true", "strict = false\nmax_iterations = 1")];
    let scene = funnel(path, &changes);
    let run = ["run", scene.to_str().unwrap(), "--stop", "0.4", "-o"];
    // No file can be made there, whoever tries.
    let told = said(path, &[&run[..], &["a", "--dump-failed", "/proc"]].concat());
    assert_eq!(told.code, Some(2), "{}", told.error);
    let told = told.error;
    assert!(told.contains("cannot write `/proc/step-0001.dat"), "{told}");
    assert!(!told.contains("no step missed its tolerances"), "{told}");
    done(path, &[&run[..], &["a", "--resume"]].concat());
    done(path, &[&run[..], &["b"]].concat());
    let history = |name: &str| fs::read(path.join(name).join("history.csv")).unwrap();
    assert!(history("a") == history("b"));
}
