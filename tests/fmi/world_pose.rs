//! A boundary placed by position and quaternion, through the C interface.

use super::c::{ERROR, Instance, OK};
use super::{BOX, Scene, assert_same_outputs};
use sphere_dda::simulation::Simulation;

fn placed() -> Scene {
    let point = "point_of_action = [0.1, -0.2, 0.0]\ninput = \"world_pose\"";
    Scene::new(&BOX.replacen("input = \"pose\"", point, 1))
}

fn give(scene: &Scene, instance: &Instance, name: &str, values: &[f64]) {
    for (k, value) in (1..).zip(values) {
        let reference = scene.reference(&format!("boundary.floor.{name}[{k}]"));
        assert_eq!(instance.set(reference, *value), OK);
    }
}

/// Start values are the scene's placement, and an instance that is told nothing gives the bytes of the library.
#[test]
fn a_world_pose_starts_as_in_the_scene() {
    let scene = placed();
    let instance = scene.instance();
    let start = scene.vector(&instance, "boundary.floor.targetPosition");
    assert_eq!(start, [0.1, -0.2, 0.0]);
    let orientation = scene.reference("boundary.floor.targetOrientation[1]");
    let start = [0, 1, 2, 3].map(|k| instance.real(orientation + k));
    assert_eq!(start, [1.0, 0.0, 0.0, 0.0]);
    instance.initialize();
    let mut simulation = Simulation::new(scene.model.scene.clone()).unwrap();
    assert_same_outputs(&scene, &instance, &simulation);
    for k in 0..3 {
        let t = f64::from(k) * 0.01;
        assert_eq!(instance.step(t, 0.01), OK, "{:?}", instance.log());
        simulation.advance_to(t + 0.01).unwrap();
        assert_same_outputs(&scene, &instance, &simulation);
    }
}

/// What is no rotation is refused by name, at the start and in a step; after it the instance goes on.
#[test]
fn quaternions_far_from_unit_length_are_refused() {
    let scene = placed();
    let told = |instance: &Instance, found: &str| {
        let lines = instance.log();
        let text = "boundary.floor.targetOrientation: found [";
        let named = |line: &String| line.contains(text) && line.contains(found);
        assert!(lines.iter().any(named), "{lines:#?}");
    };
    let instance = scene.instance();
    give(&scene, &instance, "targetOrientation", &[0.0; 4]);
    assert_eq!([instance.set_up(0.0, None), instance.enter()], [OK; 2]);
    assert_eq!(instance.exit(), ERROR);
    told(&instance, "of length 0.000, expected a unit quaternion");
    let instance = scene.instance();
    instance.initialize();
    let x = scene.reference("boundary.floor.targetOrientation[2]");
    for bad in [[0.5; 3], [0.98, 0.0, 0.0], [0.0, 1e30, 0.0]] {
        let quaternion = [bad[0], bad[1], bad[2], 0.0];
        give(&scene, &instance, "targetOrientation", &quaternion);
        assert_eq!(instance.step(0.0, 0.01), ERROR);
        told(&instance, "keep its sign from row to row");
    }
    // What is no number is refused as it is set.
    assert_eq!(instance.set(x, f64::NAN), ERROR);
    let lines = instance.log();
    let named = lines
        .iter()
        .any(|line| line.contains("targetOrientation[2]"));
    assert!(named, "{lines:#?}");
    // Single precision, an axis askew, and the other sign.
    let half = 0.5_f32.sqrt();
    let good = [-half, half * 0.002, 0.0, 0.0].map(f64::from);
    let longer = (good[0] * good[0] + good[1] * good[1]).sqrt() * 0.995;
    give(
        &scene,
        &instance,
        "targetOrientation",
        &good.map(|q| q / longer),
    );
    assert_eq!(instance.step(0.0, 0.01), OK, "{:?}", instance.log());
    let w = instance.real(scene.reference("boundary.floor.orientation[1]"));
    assert!((w.abs() - (0.002_f64.atan()).cos()).abs() < 1e-9, "{w}");
}
