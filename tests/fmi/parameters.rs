//! Parameters of the scene as variables of the FMU: before initialization, between steps, in saved states.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::simulation::{Settle, Settled, Simulation};
use sphere_dda_fmu::model::{Model, ModelError};
use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::ScalarType;

use super::c::{ERROR, Instance, OK};
use super::{BOX, Scene, fmi};

const H: f64 = 0.01;

const PARAMETERS: &str = r#"
[[source]]
name = "rain"
material = "stone"
radius = 0.02
region = { box = { min = [-0.2, -0.2, 0.5], max = [0.2, 0.2, 0.6] } }
capacity = 12
rate = 20.0
[[parameter]]
name = "friction"
sets = "pair_default.friction"
min = 0.0
max = 1.0
[[parameter]]
name = "radius"
sets = "spheres.balls.radius"
description = "Radius of the balls"
min = 0.01
max = 0.05
[[parameter]]
name = "count"
sets = "spheres.balls.lattice.count[1]"
[[parameter]]
name = "down"
sets = "simulation.gravity[3]"
[[parameter]]
name = "rate"
sets = "source.rain.rate"
"#;

const GRAVITY: &str = "duration = 0.2\ngravity = [0.0, 0.0, -9.81]";

fn scene() -> Scene {
    Scene::new(&text(&[]))
}

/// The scene with `changes` to its text.
fn text(changes: &[(&str, &str)]) -> String {
    let mut text = BOX.replace("duration = 0.2", GRAVITY) + PARAMETERS;
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    text
}

/// All real outputs, bit for bit.
fn outputs(scene: &Scene, instance: &Instance) -> Vec<u64> {
    let entries = scene.model.table.entries(Version::Two);
    let real = |entry: &&sphere_dda_fmu::table::Entry<'_>| {
        let variable = entry.variable;
        let measured = matches!(variable.causality, Causality::Output | Causality::Local);
        measured && variable.scalar == ScalarType::Float64
    };
    let references: Vec<u32> = entries.iter().filter(real).map(|e| e.reference).collect();
    let mut values = vec![0.0; references.len()];
    assert_eq!(instance.get(&references, &mut values), OK);
    values.into_iter().map(f64::to_bits).collect()
}

fn advance(instance: &Instance, from: u32, to: u32) {
    for k in from..to {
        assert_eq!(
            instance.step(f64::from(k) * H, H),
            OK,
            "{:?}",
            instance.log()
        );
    }
}

#[test]
fn what_shapes_the_scene_is_fixed_and_the_rest_tunable() {
    let model = scene().model;
    let kind = |name: &str| {
        let entries = model.table.entries(Version::Two);
        let found = entries.iter().find(|e| e.name() == name).unwrap();
        let v = found.variable;
        (v.scalar, v.variability, v.unit, v.min, v.max)
    };
    let (real, whole) = (ScalarType::Float64, ScalarType::Int32);
    let (fixed, tunable) = (Variability::Fixed, Variability::Tunable);
    assert_eq!(
        kind("friction"),
        (real, tunable, None, Some(0.0), Some(1.0))
    );
    assert_eq!(
        kind("radius"),
        (real, fixed, Some("m"), Some(0.01), Some(0.05))
    );
    assert_eq!(kind("count"), (whole, fixed, None, None, None));
    assert_eq!(kind("down"), (real, tunable, Some("m/s2"), None, None));
    assert_eq!(kind("rate"), (real, tunable, Some("1/s"), None, None));
}

#[test]
fn values_before_initialization_give_the_bits_of_an_edited_scene() {
    for (name, value, change) in [
        ("friction", 0.1, ("friction = 0.3", "friction = 0.1")),
        ("radius", 0.045, ("radius = 0.05", "radius = 0.045")),
        ("down", -3.71, ("-9.81", "-3.71")),
        ("rate", 50.0, ("rate = 20.0", "rate = 50.0")),
    ] {
        let (scene, edited) = (scene(), Scene::new(&text(&[change])));
        let run = |scene: &Scene, set: Option<f64>, late: bool| {
            let instance = scene.instance();
            let reference = scene.reference(name);
            let set = || set.map_or(OK, |value| instance.set(reference, value));
            if late {
                assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
                // Outputs are known before it is set, and after it.
                let before = outputs(scene, &instance);
                assert_eq!(set(), OK);
                assert_eq!(instance.exit(), OK);
                assert!(
                    before != outputs(scene, &instance) || ["friction", "rate"].contains(&name)
                );
            } else {
                assert_eq!(set(), OK);
                instance.initialize();
            }
            advance(&instance, 0, 15);
            let read = instance.real(reference);
            (
                outputs(scene, &instance),
                read,
                instance.real(scene.reference("gravity[3]")),
            )
        };
        let expected = run(&edited, None, false);
        assert_ne!(run(&scene, None, false).0, expected.0, "{name}");
        assert_eq!(run(&scene, Some(value), false), expected, "{name}");
        assert_eq!(run(&scene, Some(value), true), expected, "{name}");
        assert_eq!(expected.1, value);
    }
}

#[test]
fn values_between_steps_hold_from_the_next_step_on() {
    let scene = scene();
    let changes = [
        ("friction = 0.3", "friction = 0.9"),
        ("-9.81", "-20.0"),
        ("rate = 20.0", "rate = 60.0"),
    ];
    let other = Scene::new(&text(&changes)).model.scene;
    let mut library = Simulation::new(Arc::clone(&scene.model.scene)).unwrap();
    let instance = scene.instance();
    instance.initialize();
    advance(&instance, 0, 10);
    let before = outputs(&scene, &instance);
    for (name, value) in [("friction", 0.9), ("down", -20.0), ("rate", 60.0)] {
        assert_eq!(instance.set(scene.reference(name), value), OK);
    }
    assert_eq!(outputs(&scene, &instance), before);
    assert_eq!(instance.real(scene.reference("gravity[3]")), -20.0);
    advance(&instance, 10, 20);
    for k in 1..=10 {
        library.advance_to(f64::from(k) * H).unwrap();
    }
    library.tune(library.scene().tuned(&other).into());
    library.set_gravity(other.settings.gravity).unwrap();
    for k in 10..20 {
        library.advance_to(f64::from(k) * H + H).unwrap();
    }
    let emitted = |simulation: &Simulation| simulation.state().emitted[0];
    let own =
        sphere_dda::observe::quantities::values(&sphere_dda::observe::Observation::of(&library));
    let expected: Vec<f64> = own;
    let entries = scene.model.table.entries(Version::Two);
    for entry in entries
        .iter()
        .filter(|e| e.variable.causality == Causality::Output)
    {
        if entry.variable.scalar == ScalarType::Float64 {
            let rank = entry.variable.rank(entry.elements().start).unwrap();
            let found = instance.real(entry.reference);
            assert_eq!(
                found.to_bits(),
                expected[rank].to_bits(),
                "{}",
                entry.name()
            );
        }
    }
    // 0.1 s at 20 1/s, then 0.1 s at 60 1/s: the new rate does not count for the time before it.
    let one = scene.model.scene.particles.mass.last().unwrap();
    assert!(
        (emitted(&library) / one - 8.0).abs() < 1e-9,
        "{}",
        emitted(&library) / one
    );
}

#[test]
fn states_hold_the_values() {
    let scene = scene();
    let first = scene.instance();
    assert_eq!(first.set(scene.reference("radius"), 0.04), OK);
    first.initialize();
    advance(&first, 0, 5);
    assert_eq!(first.set(scene.reference("friction"), 0.7), OK);
    advance(&first, 5, 8);
    // Set, but not yet stepped with.
    assert_eq!(first.set(scene.reference("friction"), 0.2), OK);
    assert_eq!(first.set(scene.reference("down"), -5.0), OK);
    let bytes = first.bytes();
    advance(&first, 8, 12);
    // Another instance that stands elsewhere, and the same one rolled back.
    let second = scene.instance();
    second.initialize();
    assert_eq!(second.load(&bytes), OK, "{:?}", second.log());
    assert_eq!(second.bytes(), bytes);
    assert_eq!(second.real(scene.reference("radius")), 0.04);
    assert_eq!(second.real(scene.reference("friction")), 0.2);
    advance(&second, 8, 12);
    assert_eq!(second.bytes(), first.bytes());
    assert_eq!(first.load(&bytes), OK);
    advance(&first, 8, 12);
    assert_eq!(second.bytes(), first.bytes());
    // One that has the values of the state, but has not built their scene.
    let third = scene.instance();
    for (name, value) in [("radius", 0.04), ("friction", 0.2), ("down", -5.0)] {
        assert_eq!(third.set(scene.reference(name), value), OK);
    }
    assert_eq!(third.load(&bytes), OK);
    advance(&third, 8, 12);
    assert_eq!(third.bytes(), second.bytes());
    assert_eq!(first.reset(), OK);
    assert_eq!(first.real(scene.reference("radius")), 0.05);
}

#[test]
fn what_cannot_be_set_is_refused_with_its_reason() {
    let scene = scene();
    let instance = scene.instance();
    let said = |part: &str| {
        let log = instance.log();
        assert!(
            log.iter().any(|line| line.contains(part)),
            "{part}: {log:?}"
        );
    };
    assert_eq!(instance.set(scene.reference("friction"), 1.5), ERROR);
    said("`friction` = 1.5, expected a number from 0 to 1");
    assert_eq!(instance.set(scene.reference("radius"), 0.06), ERROR);
    said("`radius` = 0.06, expected a number from 0.01 to 0.05");
    instance.initialize();
    assert_eq!(instance.set(scene.reference("radius"), 0.04), ERROR);
    said("`radius` cannot be set in state step complete: it is parameter, fixed");
    // What the scene refuses is refused as a whole, and the instance goes on.
    assert_eq!(instance.set(scene.reference("rate"), -1.0), ERROR);
    said("source[0].rate: found -1, expected a rate > 0 [1/s]");
    assert_eq!(instance.real(scene.reference("rate")), 20.0);
    advance(&instance, 0, 2);

    // Balls that overlap: the scene says so when the start is made.
    let narrow = Scene::new(&text(&[
        ("spacing = 0.11", "spacing = 0.09"),
        ("radius = 0.05\n", "radius = 0.04\n"),
    ]));
    let instance = narrow.instance();
    assert_eq!(instance.set(narrow.reference("radius"), 0.05), OK);
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    assert_eq!(instance.exit(), ERROR);
    let log = instance.log();
    assert!(log.iter().any(|line| line.contains("overlap")), "{log:?}");
}

#[test]
fn other_numbers_of_spheres_and_names_of_variables_make_no_model() {
    let model = scene().model;
    let mut values: Vec<f64> = model.scene.parameters.iter().map(|p| p.value).collect();
    let error = scene_error(&model, &{
        values[2] = 2.0;
        values.clone()
    });
    assert_eq!(
        error,
        "with count=2 the scene has room for 24 spheres, expected 30: the variables of an FMU are fixed; export the scene again with --set"
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text(&[("name = \"down\"", "name = \"mass\"")])).unwrap();
    let error = Model::read(&path, None).unwrap_err();
    assert!(matches!(&error, ModelError::Name(name) if name == "mass"));
    assert!(
        error.to_string().contains("give the parameter another one"),
        "{error}"
    );
}

fn scene_error(model: &Model, values: &[f64]) -> String {
    // The file is gone with its folder in other tests; here it must be there.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, &model.text).unwrap();
    let again = Model::read(&path, None).unwrap();
    assert_eq!(again.guid, model.guid);
    again.scene_with(values).unwrap_err().to_string()
}

/// The spheres have settled with the default values: what they rest by may change, not what they are.
#[test]
fn a_settled_start_stays_with_friction_and_refuses_another_radius() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text(&[])).unwrap();
    let scene = sphere_dda::scene::Scene::from_file(&path).unwrap().scene;
    let settle = Settle {
        time: 0.05,
        until_rest: false,
    };
    let settled = Settled::new(&scene, settle, |_| std::ops::ControlFlow::Continue(())).unwrap();
    std::fs::write(folder.path().join("start.state"), &settled.start).unwrap();
    let model = Model::of_resources(folder.path()).unwrap();
    let value = |name: &str, value: f64| -> Vec<f64> {
        let each = model.scene.parameters.iter();
        each.map(|p| if p.name == name { value } else { p.value })
            .collect()
    };
    let rough = model.scene_with(&value("friction", 0.9)).unwrap();
    assert_eq!(rough.initial, model.scene.initial);
    assert_ne!(rough.initial, scene.initial);
    assert_eq!(rough.initial_contacts, model.scene.initial_contacts);
    assert_ne!(rough.hash, model.scene.hash);
    let error = model.scene_with(&value("radius", 0.04)).unwrap_err();
    assert!(matches!(error, ModelError::Settled(_)), "{error}");
    assert!(
        error
            .to_string()
            .starts_with("with radius=0.04 the spheres that have settled"),
        "{error}"
    );
    let instance = fmi().instantiate("box", &model.guid, folder.path() as &Path);
    let entries = model.table.entries(Version::Two);
    let reference = entries
        .iter()
        .find(|e| e.name() == "radius")
        .unwrap()
        .reference;
    assert_eq!(instance.set(reference, 0.04), OK);
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    assert_eq!(instance.exit(), ERROR);
    assert!(
        instance.log().iter().any(|line| line.contains("--set")),
        "{:?}",
        instance.log()
    );
}
