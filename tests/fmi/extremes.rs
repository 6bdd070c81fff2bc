//! Numbers that no machine has: refused with a message, never taken with NaN behind.

use sphere_dda_fmu::version::Version;
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::ScalarType;

use crate::c::{DISCARD, ERROR, Instance, OK, WARNING};
use crate::feedthrough::{driven, driven_text};
use crate::{Scene, box_scene};

const H: f64 = 1e-2;

/// References of real variables of a kind, with their names.
fn reals(scene: &Scene, wanted: impl Fn(Causality, Variability) -> bool) -> Vec<(u32, String)> {
    let entries = scene.model.table.entries(Version::Two);
    let kind = entries.iter().filter(|entry| {
        let variable = entry.variable;
        variable.scalar == ScalarType::Float64 && wanted(variable.causality, variable.variability)
    });
    kind.map(|entry| (entry.reference, entry.name())).collect()
}

fn inputs(scene: &Scene) -> Vec<(u32, String)> {
    reals(scene, |causality, variability| {
        causality == Causality::Input || variability == Variability::Tunable
    })
}

/// All that is measured are numbers.
fn assert_finite(scene: &Scene, instance: &Instance, what: &str) {
    for (reference, name) in reals(scene, |causality, _| {
        matches!(causality, Causality::Output | Causality::Local)
    }) {
        let value = instance.real(reference);
        assert!(value.is_finite(), "{what}: {name} = {value}");
    }
}

#[test]
fn inputs_beyond_all_bounds_are_refused() {
    let scene = driven();
    let instance = scene.instance();
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    let refused = || {
        for (reference, name) in inputs(&scene) {
            for value in [1.1e30, -1e160, f64::MAX] {
                assert_eq!(instance.set(reference, value), ERROR, "{name} = {value}");
                let lines = instance.log();
                assert!(lines[0].contains("from -1e30 to 1e30"), "{lines:?}");
            }
        }
    };
    refused();
    assert_eq!(instance.exit(), OK, "{:?}", instance.log());
    refused();
    for (reference, name) in inputs(&scene)
        .into_iter()
        .filter(|(_, name)| !name.starts_with("gravity"))
    {
        for (order, value) in [(1, 1e200), (2, -1e31)] {
            // SAFETY: one value each.
            let status = unsafe {
                (instance.f().fmi2SetRealInputDerivatives)(
                    instance.handle,
                    &raw const reference,
                    1,
                    &raw const order,
                    &raw const value,
                )
            };
            assert_eq!(status, ERROR, "{name}, order {order}");
            let lines = instance.log();
            assert!(lines[0].contains("from -1e30 to 1e30"), "{lines:?}");
        }
    }
    assert_eq!(instance.step(0.0, H), OK);
    assert_finite(&scene, &instance, "after refusals");
}

#[test]
fn what_is_just_within_the_bounds_gives_no_nan() {
    // Most of these steps cannot converge: they need not be tried for long.
    let text = driven_text().replace(
        "strict = true",
        "strict = true\nmax_iterations = 20\nmax_cuts = 1",
    );
    let scene = Scene::new(&text);
    for (reference, name) in inputs(&scene) {
        for value in [1e30, -1e30, 1e20, -1e12] {
            for before_start in [true, false] {
                let instance = scene.instance();
                let what = format!("{name} = {value}, {before_start}");
                assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
                if before_start {
                    assert_eq!(instance.set(reference, value), OK, "{what}");
                }
                if instance.exit() != OK {
                    continue;
                }
                assert_finite(&scene, &instance, &what);
                assert_eq!(instance.set(reference, value), OK, "{what}");
                let mut t = 0.0;
                for _ in 0..5 {
                    let status = instance.step(t, H);
                    assert!([OK, WARNING, DISCARD, ERROR].contains(&status));
                    if [DISCARD, ERROR].contains(&status) {
                        break;
                    }
                    t += H;
                    assert_finite(&scene, &instance, &what);
                }
            }
        }
    }
}

#[test]
fn a_step_of_too_many_internal_steps_is_refused_with_their_number() {
    let scene = box_scene();
    let instance = scene.instance();
    instance.initialize();
    let before = instance.bytes();
    for h in [1e9, 1e300] {
        let began = std::time::Instant::now();
        assert_eq!(instance.step(0.0, h), ERROR);
        assert!(began.elapsed().as_secs() < 1);
        let lines = instance.log();
        assert!(lines[0].contains("internal steps of 0.001 s"), "{lines:?}");
        assert!(lines[0].contains("at most 1e7"), "{lines:?}");
    }
    assert!(instance.log().is_empty());
    assert_eq!(instance.bytes(), before);
    assert_eq!(instance.step(0.0, H), OK);
}

/// The load is within the bounds, what it does to so light a body is not.
#[test]
fn a_body_that_flies_off_discards_the_step() {
    let text = driven_text()
        .replace(
            "inertia = [0.001, 0.001, 0.002]",
            "inertia = [1e-200, 1e-200, 1e-200]",
        )
        .replace("mass = 0.4", "mass = 1e-200");
    let scene = Scene::new(&text);
    let instance = scene.instance();
    instance.initialize();
    let before = instance.bytes();
    let torque = scene.reference("boundary.flap.appliedTorque");
    assert_eq!(instance.set(torque, 1e30), OK);
    let status = instance.step(0.0, H);
    let lines = instance.log();
    assert_eq!(status, DISCARD, "{lines:?}");
    assert!(
        lines[0].contains("boundary `flap` has a non-finite"),
        "{lines:?}"
    );
    assert_finite(&scene, &instance, "after the discard");
    assert_eq!(instance.load(&before), OK);
    assert_eq!(instance.step(0.0, H), OK, "{:?}", instance.log());
}
