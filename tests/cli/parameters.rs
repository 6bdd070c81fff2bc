//! `--set`: the parameters of a scene, by the same names for every verb.

use std::fs;
use std::path::Path;

use crate::command::{done, said};

const SCENE: &str = r#"
title = "Chute"
[simulation]
duration = 0.05
step = 1e-3
communication_step = 0.01
[[material]]
name = "grain"
density = 2500
friction = 0.3
[[spheres]]
name = "fill"
material = "grain"
radius = 0.02
lattice = { origin = [0.0, 0.0, 0.021], count = [3, 3, 1], spacing = 0.045 }
velocity = [1.0, 0.0, 0.0]
[[boundary]]
name = "floor"
material = "grain"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[parameter]]
name = "friction"
sets = "material.grain.friction"
min = 0
max = 1
[[parameter]]
name = "radius"
sets = "spheres.fill.radius"
unit = "m"
[[parameter]]
name = "count"
sets = "spheres.fill.lattice.count[1]"
min = 1
[fmu]
outputs = ["*"]
"#;

fn put(folder: &Path, name: &str, changes: &[(&str, &str)]) {
    let mut text = SCENE.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    fs::write(folder.join(name), text).unwrap();
}

const EDITS: [(&str, &str); 2] = [
    ("friction = 0.3", "friction = 0.45"),
    ("radius = 0.02", "radius = 0.018"),
];
const SET: [&str; 4] = ["--set", "friction=0.45", "--set", "radius=0.018"];

#[test]
fn a_run_with_values_has_the_bits_of_an_edited_scene() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    put(folder, "scene.toml", &[]);
    put(folder, "edited.toml", &EDITS);
    let count = [EDITS[0], EDITS[1], ("count = [3,", "count = [5,")];
    put(folder, "more.toml", &count);
    let history = |scene: &str, set: &[&str]| {
        let first = ["run", scene, "-o", "out", "--overwrite"];
        done(folder, &[&first, set].concat());
        fs::read_to_string(folder.join("out/history.csv")).unwrap()
    };
    let edited = history("edited.toml", &[]);
    assert_eq!(history("scene.toml", &SET), edited);
    assert_ne!(history("scene.toml", &[]), edited);
    // A count goes with the others: the run has more spheres.
    let more = history("more.toml", &[]);
    assert_eq!(
        history("scene.toml", &[&SET[..], &["--set", "count=5"]].concat()),
        more
    );
    // What was begun with a value goes on with this value only.
    let goes_on = |set: &[&str]| {
        let first = ["run", "scene.toml", "-o", "out", "--resume"];
        said(folder, &[&first, set].concat())
    };
    history("scene.toml", &SET);
    assert_eq!(goes_on(&SET).code, Some(0));
    let other = goes_on(&["--set", "friction=0.5"]);
    assert_ne!(other.code, Some(0), "{}", other.error);
}

#[test]
fn an_fmu_of_either_version_with_values_has_the_bits_of_an_edited_scene() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    put(folder, "scene.toml", &[]);
    put(folder, "edited.toml", &EDITS);
    for fmi in ["2", "3"] {
        let simulate = |scene: &str, export: &[&str], set: &[&str]| {
            let first = ["export", scene, "-o", "x.fmu", "--fmi", fmi, "--overwrite"];
            done(folder, &[&first, export].concat());
            let first = ["simulate", "x.fmu", "-o", "out.csv", "--overwrite"];
            done(folder, &[&first, set].concat());
            fs::read_to_string(folder.join("out.csv")).unwrap()
        };
        let edited = simulate("edited.toml", &[], &[]);
        assert_ne!(simulate("scene.toml", &[], &[]), edited);
        assert_eq!(simulate("scene.toml", &[], &SET), edited);
        // Other defaults, and one set on top of another.
        assert_eq!(simulate("scene.toml", &SET, &[]), edited);
        assert_eq!(
            simulate("scene.toml", &["--set", "friction=0.1"], &SET),
            edited
        );
        let shown = done(folder, &["inspect", "x.fmu"]).out;
        assert!(shown.contains("friction"), "{shown}");
        let refused = said(folder, &["simulate", "x.fmu", "--set", "count=4"]);
        assert_eq!(refused.code, Some(1));
        assert!(
            refused.error.contains("with count=4 friction=0.1")
                || refused.error.contains("count=4"),
            "{}",
            refused.error
        );
        assert!(
            refused.error.contains("12 spheres, expected 9"),
            "{}",
            refused.error
        );
        let wrong = [
            "--set",
            "friction=1.5",
            "--set",
            "count=0",
            "--set",
            "radus=1",
        ];
        let refused = said(folder, &[&["simulate", "x.fmu"][..], &wrong].concat());
        assert_eq!(refused.code, Some(2), "{}", refused.error);
        for part in [
            "`friction`: found \"1.5\", expected a number from 0 to 1",
            "`count`: found \"0\", expected a number >= 1",
            "found `radus`, expected a name in the model description: did you mean `radius`?",
        ] {
            assert!(refused.error.contains(part), "{}", refused.error);
        }
    }
}

#[test]
fn every_verb_takes_the_same_names_and_tells_all_that_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    put(folder, "scene.toml", &[]);
    let checked = done(folder, &["check", "scene.toml", "--set", "count=6"]);
    assert!(checked.out.contains("18"), "{}", checked.out);
    done(folder, &["view", "scene.toml", "--set", "count=6"]);
    let wrong = [
        "--set",
        "frction=1",
        "--set",
        "friction=2",
        "--set",
        "count=1.5",
    ];
    for verb in [
        &["check", "scene.toml"][..],
        &["run", "scene.toml", "-o", "out"],
        &["view", "scene.toml", "--overwrite"],
        &["export", "scene.toml"],
    ] {
        let refused = said(folder, &[verb, &wrong].concat());
        assert_eq!(refused.code, Some(2), "{verb:?}");
        for part in [
            "unknown parameter `frction`",
            "did you mean `friction`?",
            "found `friction` = 2, expected a number from 0 to 1",
            "found `count` = 1.5, expected a whole number",
        ] {
            assert!(refused.error.contains(part), "{verb:?}: {}", refused.error);
        }
    }
    let typed = said(folder, &["check", "scene.toml", "--set", "friction=rough"]);
    assert_eq!(typed.code, Some(2));
    assert!(
        typed.error.contains("found `rough`, expected NAME=NUMBER"),
        "{}",
        typed.error
    );
    let export = said(
        folder,
        &["export", "scene.toml", "--set", "bed.friction=0.4"],
    );
    assert!(
        export
            .error
            .contains("found `bed.friction`, expected the name of a parameter"),
        "{}",
        export.error
    );
}
