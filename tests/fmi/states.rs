//! Saved states: bit for bit, in another instance, another thread, another process; garbage is refused.

use std::process::Command;
use std::time::Instant;

use sphere_dda_fmu::runtime::life_cycle::LifeCycle;
use sphere_dda_fmu::runtime::state::SavedState;

use super::c::{ERROR, Instance, OK, WARNING};
use super::{Scene, box_scene};

const H: f64 = 0.01;

/// Steps `from..to`, with the floor and the wall in motion.
fn drive(scene: &Scene, instance: &Instance, from: u32, to: u32) {
    for k in from..to {
        let t = f64::from(k) * H;
        instance.set(
            scene.reference("boundary.floor.translation[3]"),
            2e-3 * (40.0 * t).sin(),
        );
        instance.set(scene.reference("boundary.wall.velocity[1]"), 0.2);
        assert_eq!(instance.step(t, H), OK, "{:?}", instance.log());
    }
}

#[test]
fn step_restore_step_gives_the_same_bytes() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    drive(&scene, &instance, 0, 8);
    let (saved, before) = (instance.state(), instance.bytes());
    drive(&scene, &instance, 8, 12);
    let once = instance.bytes();
    assert_ne!(once, before);
    assert_eq!(instance.restore(saved), OK);
    assert_eq!(instance.bytes(), before);
    drive(&scene, &instance, 8, 12);
    assert_eq!(instance.bytes(), once);
    // A state that is handed in again is overwritten, not leaked.
    let mut same = saved;
    assert_eq!(
        // SAFETY: a state of this library and a valid place.
        unsafe { (instance.f().fmi2GetFMUstate)(instance.handle, &raw mut same) },
        OK
    );
    assert_eq!(same, saved);
    instance.free(saved);
}

/// States live through later steps, several at once; each goes on as the run did, in whatever order they are restored.
#[test]
fn several_states_are_held_at_once() {
    let scene = box_scene();
    let (instance, other) = (scene.instance(), scene.instance());
    instance.initialize();
    let (mut kept, mut done) = (Vec::new(), 0);
    for at in [2, 5, 8] {
        drive(&scene, &instance, done, at);
        kept.push((at, instance.state(), instance.bytes()));
        done = at;
    }
    drive(&scene, &instance, done, 12);
    let end = instance.bytes();
    for k in [1, 0, 2, 1] {
        let (at, state, bytes) = &kept[k];
        assert_eq!(instance.serialized(*state), *bytes);
        for instance in [&instance, &other] {
            assert_eq!(instance.restore(*state), OK, "{:?}", instance.log());
            assert_eq!(instance.bytes(), *bytes);
            drive(&scene, instance, *at, 12);
            assert_eq!(instance.bytes(), end);
        }
    }
    // One that is freed takes nothing from the others.
    let (_, first, _) = kept.remove(0);
    instance.free(first);
    for (at, state, bytes) in kept {
        assert_eq!(instance.serialized(state), bytes);
        assert_eq!(instance.restore(state), OK);
        instance.free(state);
        drive(&scene, &instance, at, 12);
        assert_eq!(instance.bytes(), end);
    }
}

#[test]
fn every_stage_can_be_saved() {
    let scene = box_scene();
    let instance = scene.instance();
    let new = instance.bytes();
    assert_eq!(
        instance.set(scene.reference("boundary.floor.translation[3]"), -0.1),
        OK
    );
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    let initializing = instance.bytes();
    assert_eq!(instance.exit(), OK);
    drive(&scene, &instance, 0, 2);
    assert_eq!(instance.load(&initializing), OK);
    assert_eq!(instance.step(0.0, H), ERROR);
    assert_eq!(instance.exit(), OK);
    assert_eq!(
        instance.real(scene.reference("boundary.floor.position[3]")),
        -0.1
    );
    assert_eq!(instance.load(&new), OK);
    assert_eq!(instance.bytes(), new);
    instance.initialize();
    assert_eq!(
        instance.real(scene.reference("boundary.floor.position[3]")),
        0.0
    );
}

#[test]
fn parameters_travel_with_the_state() {
    let scene = box_scene();
    let (first, second) = (scene.instance(), scene.instance());
    assert_eq!(first.set(scene.reference("solver.step"), 5e-4), OK);
    assert_eq!(first.set(scene.reference("solver.tolerance.gap"), 1e-7), OK);
    first.initialize();
    drive(&scene, &first, 0, 6);
    // The second stands elsewhere, with other parameters.
    second.initialize();
    assert_eq!(second.load(&first.bytes()), OK, "{:?}", second.log());
    assert_eq!(second.real(scene.reference("solver.step")), 5e-4);
    drive(&scene, &first, 6, 9);
    drive(&scene, &second, 6, 9);
    assert_eq!(first.bytes(), second.bytes());
}

#[test]
fn threads_do_not_see_each_other() {
    let run = || {
        let scene = box_scene();
        let instance = scene.instance();
        instance.initialize();
        drive(&scene, &instance, 0, 12);
        instance.bytes()
    };
    let alone = run();
    let threads: Vec<_> = (0..2).map(|_| std::thread::spawn(run)).collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap(), alone);
    }
}

/// Environment variable that makes this binary the second process; its value is the folder of the state.
const CHILD: &str = "SPHERE_DDA_TEST_STATE";

#[test]
fn another_process_continues_with_the_same_bytes() {
    let scene = box_scene();
    let instance = scene.instance();
    if let Ok(folder) = std::env::var(CHILD) {
        let folder = std::path::Path::new(&folder);
        assert_eq!(
            instance.load(&std::fs::read(folder.join("before")).unwrap()),
            OK
        );
        drive(&scene, &instance, 7, 12);
        std::fs::write(folder.join("after"), instance.bytes()).unwrap();
        return;
    }
    instance.initialize();
    drive(&scene, &instance, 0, 7);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("before"), instance.bytes()).unwrap();
    let child = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "states::another_process_continues_with_the_same_bytes",
        ])
        .env(CHILD, folder.path())
        .output()
        .unwrap();
    assert!(
        child.status.success(),
        "{}",
        String::from_utf8_lossy(&child.stdout)
    );
    drive(&scene, &instance, 7, 12);
    assert_eq!(
        std::fs::read(folder.path().join("after")).unwrap(),
        instance.bytes()
    );
}

#[test]
fn garbage_is_refused_and_changes_nothing() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    drive(&scene, &instance, 0, 5);
    let good = instance.bytes();
    let refuse = |bytes: &[u8], what: &str| {
        assert_eq!(instance.load(bytes), ERROR, "{what}");
        let lines = instance.log();
        assert!(
            lines.len() == 1 && lines[0].contains("state"),
            "{what}: {lines:?}"
        );
    };
    refuse(&[], "nothing");
    refuse(b"SDDAFMU\0", "magic only");
    refuse(&good[..good.len() - 1], "cut");
    refuse(&[&good[..], &[0]].concat(), "longer");
    for at in (0..good.len()).step_by(good.len() / 97) {
        let mut bad = good.clone();
        bad[at] ^= 0x10;
        refuse(&bad, &format!("byte {at}"));
    }
    let other = Scene::new(&super::BOX.replace("friction = 0.3", "friction = 0.2"));
    let foreign = other.instance();
    foreign.initialize();
    refuse(&foreign.bytes(), "another scene");
    assert_eq!(instance.bytes(), good);
}

/// Bytes that no instance writes: they would leave it in a state where hardly a call is allowed.
#[test]
fn a_state_that_cannot_be_saved_is_refused() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    drive(&scene, &instance, 0, 3);
    let good = instance.bytes();
    let mut saved = SavedState::decode(&good, &scene.model.guid).unwrap();
    for (stage, name) in [
        (LifeCycle::Error, "found error"),
        (LifeCycle::Intermediate, "found intermediate update mode"),
    ] {
        saved.run.stage = stage;
        assert_eq!(instance.load(&saved.encode().unwrap()), ERROR);
        let lines = instance.log();
        assert!(lines[0].contains("life cycle is"), "{name}: {lines:?}");
    }
    assert_eq!(instance.bytes(), good);
    drive(&scene, &instance, 3, 5);
}

#[test]
fn results_that_cannot_be_written_at_the_end_are_a_warning() {
    let scene = box_scene();
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().display().to_string();
    let start = |instance: &Instance| {
        let (directory, interval) = ("output.directory", "output.interval");
        assert_eq!(instance.set_string(scene.reference(directory), &place), OK);
        assert_eq!(instance.set(scene.reference(interval), H), OK);
        assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
        assert_eq!(instance.exit(), OK, "{:?}", instance.log());
        drive(&scene, instance, 0, 3);
        // Frames wait until the run cannot go back any more: most are written at the end.
        std::fs::remove_dir_all(folder.path().join("box")).unwrap();
    };
    let told = |instance: &Instance| {
        let lines = instance.log();
        let warned = lines
            .iter()
            .any(|line| line.starts_with("1 logStatusWarning") && line.contains("not written"));
        assert!(warned, "{lines:?}");
    };
    let instance = scene.instance();
    start(&instance);
    assert_eq!(instance.terminate(), WARNING);
    told(&instance);
    assert_eq!(instance.reset(), OK);
    start(&instance);
    assert_eq!(instance.reset(), WARNING);
    told(&instance);
}

/// Search on a shadow of an instance: a state goes to and fro while the first one writes.
#[test]
fn a_state_is_restored_at_once_while_its_folder_is_written_to() {
    let scene = box_scene();
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().display().to_string();
    let first = scene.instance();
    let directory = scene.reference("output.directory");
    assert_eq!(first.set_string(directory, &place), OK);
    first.initialize();
    drive(&scene, &first, 0, 2);
    let (state, shadow) = (first.bytes(), scene.instance());
    let began = Instant::now();
    for _ in 0..5 {
        assert_eq!(shadow.load(&state), OK, "{:?}", shadow.log());
    }
    let took = began.elapsed();
    assert!(took.as_millis() < 500, "{took:?}");
    let lines = shadow.log();
    assert_eq!(lines.len(), 1, "{lines:?}");
    assert!(lines[0].starts_with("1 logStatusWarning") && lines[0].contains("no results"));
    drive(&scene, &shadow, 2, 3);
    drive(&scene, &first, 2, 3);
    assert_eq!(first.terminate(), OK);
}

#[test]
fn results_follow_a_rollback() {
    let scene = box_scene();
    let folder = tempfile::tempdir().unwrap();
    let start = |instance: &Instance| {
        let place = folder.path().display().to_string();
        assert_eq!(
            instance.set_string(scene.reference("output.directory"), &place),
            OK
        );
        assert_eq!(instance.string(scene.reference("output.directory")), place);
        assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
        instance.exit()
    };
    let times = || -> Vec<f64> {
        let text = std::fs::read_to_string(folder.path().join("box/history.csv")).unwrap();
        text.lines()
            .skip(1)
            .map(|line| line.split(',').next().unwrap().parse().unwrap())
            .collect()
    };
    let instance = scene.instance();
    assert_eq!(start(&instance), OK, "{:?}", instance.log());
    drive(&scene, &instance, 0, 3);
    let state = instance.state();
    drive(&scene, &instance, 3, 6);
    assert_eq!(instance.restore(state), OK);
    instance.free(state);
    assert_eq!(instance.terminate(), OK);
    assert_eq!(times(), [0.0, 0.01, 0.02, 0.03]);
    // Another instance of that name may not overwrite, the same one may after a reset.
    let other = scene.instance();
    assert_eq!(start(&other), ERROR);
    assert!(other.log()[0].contains("already holds a run"));
    assert_eq!(instance.reset(), OK);
    assert_eq!(start(&instance), OK, "{:?}", instance.log());
    assert_eq!(instance.terminate(), OK);
    assert_eq!(times(), [0.0]);
}

#[test]
fn results_go_on_in_another_instance_that_takes_the_state() {
    let scene = box_scene();
    let folder = tempfile::tempdir().unwrap();
    let start = |instance: &Instance, place: &str, overwrite: bool| {
        let place = folder.path().join(place).display().to_string();
        let (directory, may) = ("output.directory", "output.overwrite");
        assert_eq!(instance.set_string(scene.reference(directory), &place), OK);
        if overwrite {
            assert_eq!(instance.set_boolean(scene.reference(may), true), OK);
        }
        assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
        assert_eq!(instance.exit(), OK);
    };
    let history = |place: &str| {
        std::fs::read_to_string(folder.path().join(place).join("box/history.csv")).unwrap()
    };
    let whole = scene.instance();
    start(&whole, "whole", false);
    drive(&scene, &whole, 0, 9);
    assert_eq!(whole.terminate(), OK);

    for (place, overwrite, further) in [
        ("ended", false, 0),
        ("further", true, 3),
        ("kept", false, 3),
    ] {
        let first = scene.instance();
        start(&first, place, overwrite);
        drive(&scene, &first, 0, 5);
        let state = first.bytes();
        drive(&scene, &first, 5, 5 + further);
        assert_eq!(first.terminate(), OK);
        let left = history(place);

        let second = scene.instance();
        assert_eq!(second.load(&state), OK);
        let log = second.log();
        drive(&scene, &second, 5, 9);
        assert_eq!(second.terminate(), OK);
        if place == "kept" {
            assert_eq!(history(place), left, "what is later stays");
            assert!(
                log.iter().any(|line| line.contains("later than 0.05 s")),
                "{log:?}"
            );
        } else {
            assert_eq!(history(place), history("whole"), "{place}: {log:?}");
        }
    }
}
