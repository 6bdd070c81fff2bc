//! `sphere-dda check`: exit codes and what it prints.

use std::path::Path;
use std::process::Output;

use crate::command::{command, example, funnel, said};

fn check(scene: &Path) -> Output {
    let arguments = ["check", scene.to_str().unwrap()];
    command(Path::new("."), &arguments).output().unwrap()
}

#[test]
fn good_scenes_are_summarised() {
    for name in ["funnel", "slopes", "feeder"] {
        let output = check(&example(name));
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0));
        for part in [
            "spheres",
            "mass",
            "extent",
            "initial overlaps",
            "suggested",
            "hash",
        ] {
            assert!(text.contains(part), "{name} lacks {part}:\n{text}");
        }
    }
}

#[test]
fn a_picture_shows_what_was_typed() {
    let folder = tempfile::tempdir().unwrap();
    let scene = example("hopper");
    let draw = |more: &[&str]| {
        let mut arguments = vec!["check", scene.to_str().unwrap(), "--picture"];
        arguments.extend(more);
        command(folder.path(), &arguments).output().unwrap()
    };
    let refused = |output: Output, part: &str| {
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(part), "{part} is not in\n{text}");
    };
    refused(
        draw(&["hopper.jpg"]),
        "found `hopper.jpg`, expected a name that ends with .png",
    );
    refused(
        draw(&["no/such/hopper.png"]),
        "cannot write `no/such/hopper.png`",
    );
    assert!(draw(&["hopper.png"]).status.success());
    let png = std::fs::read(folder.path().join("hopper.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
    refused(draw(&["hopper.png"]), "exists already");
    assert!(draw(&["hopper.png", "--overwrite"]).status.success());
}

#[test]
fn a_scene_without_title_makes_an_fmu_of_the_name_of_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let readme = include_str!("../../README.md");
    let (_, rest) = readme.split_once("## A scene\n\n```toml\n").unwrap();
    let (scene, _) = rest.split_once("```").unwrap();
    assert!(!scene.contains("title"));
    std::fs::write(folder.path().join("hopper.toml"), scene).unwrap();
    for arguments in [
        &["export", "hopper.toml"][..],
        &["inspect", "hopper.fmu"],
        // Its instance reads the scene from a file of another name.
        &[
            "simulate",
            "hopper.fmu",
            "--stop",
            "0.002",
            "-o",
            "outputs.csv",
        ],
    ] {
        let output = command(folder.path(), arguments).output().unwrap();
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments:?}: {text}");
    }
}

#[test]
fn bad_scenes_exit_with_2_and_every_problem() {
    let text = std::fs::read_to_string(example("funnel")).unwrap();
    let bad = text
        .replacen("step = 0.01", "step = 0", 1)
        .replacen("radius = 0.25", "radius = -0.25", 1)
        .replacen("r0 = 0.7", "r_0 = 0.7", 1);
    let scene = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad_funnel.toml");
    std::fs::write(&scene, bad).unwrap();
    let output = check(&scene);
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{text}");
    for part in [
        "simulation.step",
        "spheres[0].radius",
        "unknown key `r_0`",
        "r0",
    ] {
        assert!(text.contains(part), "{part} is not in\n{text}");
    }
    assert!(!text.contains("panicked"));
}

#[test]
fn a_missing_file_and_wrong_usage_exit_with_2() {
    let missing = check(Path::new("no/such/scene.toml"));
    assert_eq!(missing.status.code(), Some(2));
    assert!(
        String::from_utf8(missing.stderr)
            .unwrap()
            .contains("cannot read the file")
    );
    let usage = command(Path::new("."), &["chek"]).output().unwrap();
    assert_eq!(usage.status.code(), Some(2));
}

#[test]
fn json_has_no_summary_where_outputs_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = funnel(folder.path(), &[]);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, format!("{text}\n[fmu]\noutputs = [\"maxOverlp\"]\n")).unwrap();
    let told = said(folder.path(), &["check", "funnel.toml", "--json"]);
    assert_eq!(told.code, Some(2));
    assert!(told.out.contains("\"summary\":null"), "{}", told.out);
    assert!(
        told.out.contains("did you mean `maxOverlap`"),
        "{}",
        told.out
    );
}
