//! Settling before t = 0.

use std::ops::ControlFlow;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Settle, Settled, Simulation};

use crate::scene;

/// A hopper with `layers` of 5 x 5 spheres above its mouth, which a gate closes.
fn hopper(layers: u32) -> String {
    format!(
        r#"
[simulation]
duration = 1.0
step = 0.002
[pair_default]
friction = 0.4
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "fill"
material = "grain"
radius = 0.02
radius_jitter = 0.1
seed = 7
lattice = {{ origin = [-0.1, -0.1, 0.15], count = [5, 5, {layers}], spacing = 0.05, jitter = 0.05 }}
[[boundary]]
name = "hopper"
material = "grain"
faces = [{{ cone = {{ base = [0, 0, 0], r0 = 0.06, r1 = 0.3, height = 0.3 }} }}, {{ cylinder = {{ base = [0, 0, 0.3], radius = 0.3, height = 1.0 }} }}]
[[boundary]]
name = "gate"
material = "grain"
faces = [{{ rectangle = {{ corner = [-0.1, -0.1, -0.001], u = [0.2, 0, 0], v = [0, 0.2, 0] }} }}]
motion = {{ sinusoid = {{ translation = [1.0, 0, 0], frequency = 1.0 }} }}
"#
    )
}

fn settle(scene: &Scene, time: f64, until_rest: bool) -> Settled {
    let settle = Settle { time, until_rest };
    Settled::new(scene, settle, |_| ControlFlow::Continue(())).unwrap()
}

/// Force of the spheres on all boundaries \[N\] and their weight \[N\].
fn balance(simulation: &Simulation) -> (Vec3, Vec3) {
    let scene = simulation.scene();
    let wrenches = (0..scene.boundaries.len()).map(|b| simulation.wrench(b).force);
    let mass: f64 = scene.particles.mass.iter().sum();
    (wrenches.sum(), simulation.gravity() * mass)
}

#[test]
fn a_settled_scene_starts_in_equilibrium() {
    let still = hopper(4).replace("translation = [1.0, 0, 0]", "translation = [0, 0, 0]");
    let mut scene = scene(&still);
    let settled = settle(&scene, 10.0, true);
    assert!(settled.at_rest && settled.time < 5.0, "{} s", settled.time);
    let hash = scene.hash.clone();
    scene.start_from(&settled.start).unwrap();
    assert_ne!(scene.hash, hash, "states of the two must not be mixed up");

    let mut simulation = Simulation::new(Arc::new(scene)).unwrap();
    assert_eq!(simulation.time(), 0.0);
    let (force, weight) = balance(&simulation);
    assert!(
        (force - weight).norm() < 1e-6 * weight.norm(),
        "{force} {weight}"
    );
    // And stays in it.
    simulation.advance_to(0.002).unwrap();
    let fastest = (0..simulation.kinematics().len())
        .map(|i| simulation.velocity(i).linear.norm())
        .fold(0.0, f64::max);
    assert!(fastest < 1e-3, "{fastest}");
}

#[test]
fn settling_holds_boundaries_and_is_the_same_twice() {
    let scene = scene(&hopper(1));
    let settled = settle(&scene, 0.4, false);
    assert_eq!(settled, settle(&scene, 0.4, false));
    let mut started = scene.clone();
    started.start_from(&settled.start).unwrap();
    let simulation = Simulation::new(Arc::new(started)).unwrap();
    // The gate, which would have moved by half a metre, kept the spheres in.
    assert!(simulation.kinematics().position.iter().all(|x| x.z > 0.0));
    assert!(
        simulation
            .kinematics()
            .velocity
            .iter()
            .all(|v| v.norm() < 0.02)
    );
}

#[test]
fn a_start_of_another_scene_is_refused() {
    let settled = settle(&scene(&hopper(1)), 0.01, false);
    let mut other = scene(&hopper(2));
    let before = other.clone();
    let error = other.start_from(&settled.start).unwrap_err();
    assert!(error.to_string().contains("scene"), "{error}");
    assert_eq!(other, before);
}
