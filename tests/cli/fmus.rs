//! From the scene to an FMU and back through the interface of FMI.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda_fmu::runtime::state::SavedState;
use sphere_dda_master::{Fmu, Step};

use crate::command::{done, example, frames, funnel, rows, said};

#[test]
fn an_exported_scene_is_inspected_and_simulated() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = example("funnel");
    let exported = done(folder, &["export", scene.to_str().unwrap(), "-o", "x.fmu"]);
    assert!(exported.out.contains("x.fmu: "), "{}", exported.out);

    let inspected = done(folder, &["inspect", "x.fmu", "--validate"]).out;
    for part in [
        "guid",
        "boundary.funnel.force[3]",
        "sensor.discharge.mass",
        "maxOverlap",
        "output.directory",
    ] {
        assert!(inspected.contains(part), "{part} is not in\n{inspected}");
    }

    let scene = scene.to_str().unwrap();
    done(folder, &["export", scene, "--fmi", "3", "-o", "three.fmu"]);
    let inspected = done(folder, &["inspect", "three.fmu", "--validate"]).out;
    for part in [
        "FMI 3.0",
        "call the importer within a step",
        "Float64[200][3]",
    ] {
        assert!(inspected.contains(part), "{part} is not in\n{inspected}");
    }

    let simulate = [
        "simulate",
        "x.fmu",
        "--stop",
        "0.5",
        "-o",
        "outputs.csv",
        "--set",
        "output.directory=here",
    ];
    done(folder, &simulate);
    assert_eq!(rows(&folder.join("outputs.csv")), 51);
    let results = fs::read_dir(folder.join("here"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap()
        .path();
    assert_eq!(frames(&results.join("spheres.pvd")), 6);

    let again = said(folder, &simulate);
    assert_eq!(again.code, Some(2));
    assert!(
        again.error.contains("outputs.csv` exists already"),
        "{}",
        again.error
    );
    let printed = done(
        folder,
        &[
            "simulate", "x.fmu", "--stop", "0.02", "--record", "time", "--record", "mass",
        ],
    );
    assert!(
        printed.out.starts_with("time,time,mass\n0.0,0"),
        "{}",
        printed.out
    );
    assert_eq!(printed.out.lines().count(), 4);
    // Wildcards name local variables too, but no binary ones.
    let all = ["simulate", "x.fmu", "--stop", "0.01", "--record"];
    let header = |pattern: &str| {
        let printed = done(folder, &[&all[..], &[pattern]].concat());
        printed.out.lines().next().unwrap().to_owned()
    };
    assert_eq!(header("solver.?uts"), "time,solver.cuts");
    assert!(header("*").contains(",kineticEnergy,"));
    let unknown = said(folder, &[&all[..], &["solver.*x"]].concat());
    assert!(unknown.error.contains("`solver.*x`"), "{}", unknown.error);
}

#[test]
fn an_fmu_is_replaced_only_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let scene = funnel(folder.path(), &[]);
    let export = ["export", scene.to_str().unwrap()];
    done(folder.path(), &export);
    let first = fs::read(folder.path().join("funnel.fmu")).unwrap();
    let refused = said(folder.path(), &export);
    assert_eq!(refused.code, Some(2));
    assert!(refused.error.contains("--overwrite"), "{}", refused.error);
    done(folder.path(), &[&export[..], &["--overwrite"]].concat());
    assert_eq!(fs::read(folder.path().join("funnel.fmu")).unwrap(), first);
}

#[test]
fn a_library_of_other_sources_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = funnel(folder.path(), &[]);
    fs::write(folder.path().join("old.so"), "library of build 0.0.1+old").unwrap();
    let export = ["export", scene.to_str().unwrap(), "--library", "old.so"];
    let refused = said(folder.path(), &export);
    assert_eq!(refused.code, Some(2), "{}", refused.error);
    for part in ["old.so` is not of build 0.", "run `cargo build --release"] {
        assert!(
            refused.error.contains(part),
            "{part} is not in\n{}",
            refused.error
        );
    }
    assert!(!folder.path().join("funnel.fmu").exists());
}

#[test]
fn the_demo_runs_anywhere_and_replaces_only_its_own_output() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let demo = ["demo", "--stop", "0.3"];
    for _ in 0..2 {
        let told = done(folder, &demo);
        for part in [
            "discharged      0 kg of 19897 kg",
            "worst overlap",
            "wall time",
            "than real time",
            "view.py",
            "view.html",
            "meshio",
        ] {
            assert!(told.out.contains(part), "{part} is not in\n{}", told.out);
        }
        let output = folder.join("demo-output");
        assert_eq!(frames(&output.join("results/spheres.pvd")), 4);
        assert_eq!(rows(&output.join("outputs.csv")), 31);
        assert!(output.join("funnel.fmu").is_file());
        let page = fs::read_to_string(output.join("view.html")).unwrap();
        assert!(page.trim_end().ends_with("</html>"));
    }
    let mine = folder.join("mine");
    fs::create_dir(&mine).unwrap();
    fs::write(mine.join("outputs.csv"), "mine").unwrap();
    let refused = said(folder, &["demo", "--stop", "0.3", "-o", "mine"]);
    assert_eq!(refused.code, Some(2));
    assert!(
        refused.error.contains("holds other files"),
        "{}",
        refused.error
    );
    assert_eq!(
        fs::read_to_string(mine.join("outputs.csv")).unwrap(),
        "mine"
    );
    assert_eq!(fs::read_dir(&mine).unwrap().count(), 1);
}

/// It said `NaN kg of NaN kg`, and that the page has no results instead of what the FMU said.
#[test]
fn a_demo_that_fails_at_its_start_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let demo = ["demo", "--stop", "0.01"];
    done(folder, &demo);
    let results = folder.join("demo-output/results");
    fs::remove_dir_all(&results).unwrap();
    fs::write(&results, "mine").unwrap();
    let refused = said(folder, &demo);
    assert_eq!(refused.code, Some(1), "{}", refused.error);
    let expected = "found status Error, expected OK; the FMU says";
    assert!(refused.error.contains(expected), "{}", refused.error);
    assert!(!refused.out.contains("NaN"), "{}", refused.out);
}

/// The FMU's steps are the library's: the same bytes after each of them.
fn same_bytes(scene: &Path, steps: u32) {
    let folder = tempfile::tempdir().unwrap();
    done(
        folder.path(),
        &["export", scene.to_str().unwrap(), "-o", "x.fmu"],
    );
    let fmu = Fmu::open(folder.path().join("x.fmu")).unwrap();
    let guid = fmu.description().token().to_owned();
    let mut instance = fmu.instantiate("same", false).unwrap();
    instance.setup_experiment(None, 0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    instance.exit_initialization_mode().unwrap();

    let scene = Arc::new(Scene::from_file(scene).unwrap().scene);
    let h = scene.settings.communication_step;
    let mut simulation = Simulation::new(scene).unwrap();
    for step in 0..=steps {
        let saved = instance.save_state().unwrap();
        let bytes = instance.serialize_state(&saved).unwrap();
        instance.free_state(saved).unwrap();
        let inside = SavedState::decode(&bytes, &guid).unwrap().snapshot.unwrap();
        assert!(
            inside == simulation.snapshot(),
            "they differ after {step} steps"
        );
        let point = f64::from(step) * h;
        assert_eq!(instance.do_step(point, h, true).unwrap(), Step::Done);
        simulation.advance_to(point + h).unwrap();
    }
    instance.terminate().unwrap();
}

#[test]
fn the_fmu_of_the_funnel_gives_the_bytes_of_the_library() {
    same_bytes(&example("funnel"), 100);
}

#[test]
fn the_fmu_of_the_feeder_gives_the_bytes_of_the_library() {
    same_bytes(&example("feeder"), 20);
}

#[test]
fn probes_read_through_the_fmu_are_the_positions_of_the_library() {
    let folder = tempfile::tempdir().unwrap();
    let probe = "[[probe]]\nname = \"one\"\nsphere = \"upper[44]\"\n\n[output]";
    let scene = funnel(folder.path(), &[("[output]", probe)]);
    done(folder.path(), &["export", scene.to_str().unwrap()]);
    let arguments = [
        "simulate",
        "funnel.fmu",
        "--stop",
        "1",
        "-o",
        "o.csv",
        "--record",
        "probe.one.position[3]",
    ];
    done(folder.path(), &arguments);

    let scene = Arc::new(Scene::from_file(&scene).unwrap().scene);
    let (h, sphere) = (scene.settings.communication_step, scene.probes[0].sphere);
    let mut simulation = Simulation::new(scene).unwrap();
    let table = fs::read_to_string(folder.path().join("o.csv")).unwrap();
    for (k, line) in table.lines().skip(1).enumerate() {
        if k > 0 {
            simulation.advance_to((k - 1) as f64 * h + h).unwrap();
        }
        let read: f64 = line.split(',').next_back().unwrap().parse().unwrap();
        let position = simulation.kinematics().position[sphere].z;
        assert_eq!(read.to_bits(), position.to_bits(), "after {k} steps");
    }
    assert_eq!(table.lines().count(), 102);
}

/// A shot that would fly past a ball in one step: the solver discards the step, half of it will do.
const SHOT: &str = r#"
title = "Shot"
[simulation]
duration = 0.05
step = 1e-2
fixed_step = true
strict = true
max_cuts = 0
communication_step = 1e-2
gravity = [0.0, 0.0, 0.0]
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.3
[[spheres]]
name = "target"
material = "stone"
radius = 0.05
positions = [[0.0, 0.0, 0.0]]
[[spheres]]
name = "shot"
material = "stone"
radius = 0.05
positions = [[-0.55, 0.09, 0.0]]
velocity = [50.0, 0.0, 0.0]
"#;

#[test]
fn a_discarded_step_is_taken_in_two_halves() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("shot.toml"), SHOT).unwrap();
    let whole = said(folder, &["run", "shot.toml", "-o", "run"]);
    assert_eq!(whole.code, Some(1), "{}", whole.error);
    assert!(whole.error.contains("pass or miss"), "{}", whole.error);
    for version in ["2", "3"] {
        let export = ["export", "shot.toml", "--fmi", version, "--overwrite"];
        done(folder, &export);
        let record = ["--record", "time", "--record", "probe.first.velocity[1]"];
        let told = done(
            folder,
            &[&["simulate", "shot.fmu", "--stop", "0.05"], &record[..]].concat(),
        );
        let last: Vec<f64> = told
            .out
            .lines()
            .last()
            .unwrap()
            .split(',')
            .map(|number| number.parse().unwrap())
            .collect();
        assert_eq!(told.out.lines().count(), 7, "{}", told.out);
        assert_eq!(last[1], 0.05);
        assert!(last[2] > 5.0, "the target was not hit: {last:?}");
        assert!(told.error.contains("pass or miss"), "{}", told.error);
    }
}

/// A heap that the solver may not iterate on, with more keys of `[simulation]`.
fn heap(more: &str) -> String {
    let head = SHOT.split("[[spheres]]").next().unwrap();
    let iterations = format!("max_cuts = 0\nmax_iterations = 1\n{more}");
    let head = head
        .replace("gravity = [0.0, 0.0, 0.0]", "")
        .replace("max_cuts = 0", &iterations);
    let heap = r#"
        [[spheres]]
        name = "heap"
        material = "stone"
        radius = 0.05
        seed = 4
        lattice = { origin = [2.0, -0.2, 0.06], count = [3, 3, 2], spacing = 0.11, jitter = 0.02 }
        [[boundary]]
        name = "floor"
        material = "stone"
        faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
    "#;
    head + heap
}

/// The FMU's clock is a sum of steps and differs from the master's by rounding where the step is discarded.
#[test]
fn a_step_that_is_discarded_late_in_a_run_is_halved() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(
        folder.join("heap.toml"),
        heap("tolerance = { opening = 0 }"),
    )
    .unwrap();
    for version in ["2", "3"] {
        let export = ["export", "heap.toml", "--fmi", version, "--overwrite"];
        done(folder, &export);
        let told = done(folder, &["simulate", "heap.fmu", "--stop", "0.1"]);
        assert!(
            told.error.contains("t = 0.060000000000000005 s"),
            "{}",
            told.error
        );
        assert_eq!(told.out.lines().count(), 12);
    }
}

#[test]
fn a_step_that_no_length_helps_is_told_by_the_function_of_its_version() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let sharp = "tolerance = { gap = 1e-12, slip = 1e-12, force = 1e-12, opening = 0 }";
    fs::write(folder.join("heap.toml"), heap(sharp)).unwrap();
    for (version, function) in [("2", "fmi2DoStep"), ("3", "fmi3DoStep")] {
        let export = ["export", "heap.toml", "--fmi", version, "--overwrite"];
        done(folder, &export);
        let told = said(folder, &["simulate", "heap.fmu", "--stop", "1"]);
        assert_eq!(told.code, Some(1), "{}", told.error);
        let words = told.error.split_whitespace().collect::<Vec<_>>().join(" ");
        let part = format!("{function}: found a discarded step");
        assert!(words.contains(&part), "{words}");
    }
}
