//! Settling before t = 0.

use std::ops::ControlFlow;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Fastest, Pass, PassKind, Settle, SettleError, Settled, Simulation};

use crate::scene;

/// A hopper with `layers` of 5 x 5 spheres above its mouth, which a gate closes.
fn hopper(layers: u32) -> String {
    format!(
        r#"
[simulation]
duration = 1.0
step = 0.002
fixed_step = true
strict = true
tolerance = {{ gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }}
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

/// All passes together take the time that was given, however short, and progress never goes back.
#[test]
fn settling_takes_no_more_than_its_time() {
    let scene = scene(&hopper(1));
    for (time, until_rest) in [(0.005, false), (0.4, false), (0.05, true)] {
        let mut seen: Vec<(Pass, f64)> = Vec::new();
        let settled = Settled::new(&scene, Settle { time, until_rest }, |reached| {
            assert!(reached.speed >= 0.0 && reached.rest_speed > 0.0);
            seen.push((reached.pass, reached.time));
            ControlFlow::Continue(())
        })
        .unwrap();
        assert!(settled.time <= time * (1.0 + 1e-9), "{} s", settled.time);
        assert!(settled.time >= time * (1.0 - 1e-6), "{} s", settled.time);
        let forward = |w: &[(Pass, f64)]| w[0].1 <= w[1].1 && w[0].0.number <= w[1].0.number;
        assert!(seen.windows(2).all(forward), "{seen:?}");
        let kinds: Vec<PassKind> = seen.iter().map(|(pass, _)| pass.kind).collect();
        assert_eq!(kinds.first(), Some(&PassKind::Coarse));
        assert!(kinds.contains(&PassKind::Fine));
        assert!(settled.passes >= 2);
        assert_eq!(seen[0].0.to_string(), "pass 1 (coarse)");
    }
}

/// Grains in a tube on a flap that nothing but its hinge carries.
const FLAP: &str = r#"
[simulation]
duration = 1.0
step = 0.002
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[pair_default]
friction = 0.4
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "fill"
material = "grain"
radius = 0.02
lattice = { origin = [-0.045, -0.045, 0.05], count = [3, 3, 3], spacing = 0.045, jitter = 0.05 }
[[boundary]]
name = "tube"
material = "grain"
faces = [{ cylinder = { base = [0, 0, 0], radius = 0.1, height = 1.0 } }]
[[boundary]]
name = "flap"
material = "grain"
faces = [{ rectangle = { corner = [-0.12, -0.12, -0.001], u = [0.24, 0, 0], v = [0, 0.24, 0] } }]
point_of_action = [-0.12, 0.0, -0.001]
body = { mass = 1.0, centre = [0.0, 0.0, -0.001], joint = { hinge = [0, 1, 0] }, hold_while_settling = true }
"#;

/// A flap that falls open empties the tube before t = 0; one that is held opens from t = 0 on.
#[test]
fn a_held_flap_stays_shut_while_grains_settle() {
    let mut held = scene(FLAP);
    let settled = settle(&held, 10.0, true);
    assert!(settled.at_rest);
    assert!(settled.unbalanced < 1e-7, "{:e}", settled.unbalanced);
    held.start_from(&settled.start).unwrap();
    let mut simulation = Simulation::new(Arc::new(held)).unwrap();
    assert_eq!(simulation.boundary_pose(1).rotation_vector(), Vec3::zeros());
    assert_eq!(simulation.boundary_twist(1).angular, Vec3::zeros());
    assert!(simulation.kinematics().position.iter().all(|x| x.z > 0.0));
    simulation.advance_to(0.1).unwrap();
    let angle = simulation.boundary_pose(1).rotation_vector().y;
    assert!(angle > 0.01, "{angle} rad");

    let mut free = scene(&FLAP.replace(", hold_while_settling = true", ""));
    let settled = settle(&free, 0.2, false);
    free.start_from(&settled.start).unwrap();
    let simulation = Simulation::new(Arc::new(free)).unwrap();
    let angle = simulation.boundary_pose(1).rotation_vector().y;
    assert!(angle > 0.01, "{angle} rad");
}

/// Symptom: without gravity the unbalanced forces over the weight were infinite, and all 12 passes ran. Loads are the scale.
#[test]
fn a_press_without_gravity_settles_and_balances() {
    let mut pressed = scene(
        r#"
[simulation]
duration = 1.0
step = 0.002
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
gravity = [0, 0, 0]
[pair_default]
friction = 0.4
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "fill"
material = "grain"
radius = 0.02
lattice = { origin = [-0.045, -0.045, 0.02], count = [3, 3, 1], spacing = 0.045 }
[[boundary]]
name = "floor"
material = "grain"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[boundary]]
name = "press"
material = "grain"
faces = [{ plane = { point = [0, 0, 0.06], normal = [0, 0, -1] } }]
body = { mass = 1.0, joint = { slide = [0, 0, -1] }, force = [0, 0, -10], gravity = false }
"#,
    );
    let settled = settle(&pressed, 10.0, true);
    assert!(settled.at_rest);
    assert!(settled.unbalanced < 1e-7, "{:e}", settled.unbalanced);
    assert!(settled.passes <= 4, "{} passes", settled.passes);
    pressed.start_from(&settled.start).unwrap();
    let simulation = Simulation::new(Arc::new(pressed)).unwrap();
    let floor = simulation.wrench(0).force.z;
    assert!((floor + 10.0).abs() < 1e-5, "{floor} N");
}

/// Without any load there is nothing to settle.
#[test]
fn a_scene_without_loads_is_balanced_at_once() {
    let weightless = hopper(1).replace("step = 0.002", "step = 0.002\ngravity = [0, 0, 0]");
    let settled = settle(&scene(&weightless), 1.0, true);
    assert!(settled.at_rest);
    assert_eq!((settled.unbalanced, settled.passes), (0.0, 2));
}

/// Symptom: an error blamed a tolerance that the user cannot set, as if a run had failed.
#[test]
fn a_failure_says_that_the_scene_was_settling() {
    let squeezed = scene(
        r#"
[simulation]
duration = 1.0
step = 0.002
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "ball"
material = "grain"
radius = [0.02]
positions = [[0, 0, 0.01998]]
[[boundary]]
name = "floor"
material = "grain"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[boundary]]
name = "ceiling"
material = "grain"
faces = [{ plane = { point = [0, 0, 0.03992], normal = [0, 0, -1] } }]
"#,
    );
    let settle = Settle {
        time: 1.0,
        until_rest: true,
    };
    let error = Settled::new(&squeezed, settle, |_| ControlFlow::Continue(())).unwrap_err();
    assert!(matches!(error, SettleError::Step { .. }), "{error:?}");
    let text = error.to_string();
    assert!(
        text.starts_with("settling, pass 1 (coarse), 0.0000 s simulated: "),
        "{text}"
    );
}

/// Symptom: a hinge that settled beyond half a turn started a whole turn short, and its spring, wound by 2 pi, threw it back.
/// Cause: a start had the pose alone, in which whole turns are lost.
#[test]
fn a_hinge_keeps_its_whole_turns_when_it_settles() {
    let mut wound = scene(
        r#"
[simulation]
duration = 1.0
communication_step = 0.01
[[material]]
name = "grain"
density = 2500
[[spheres]]
name = "one"
material = "grain"
radius = 0.01
positions = [[5, 5, 0.01]]
[[boundary]]
name = "floor"
material = "grain"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
[[boundary]]
name = "arm"
material = "grain"
faces = [{ box = { min = [0.0, -0.05, 0.95], max = [0.3, 0.05, 1.0] } }]
point_of_action = [0, 0, 1]
[boundary.body]
mass = 1.0
inertia = [0.01, 0.01, 0.01]
centre = [0, 0, 1]
joint = { hinge = [0, 1, 0] }
spring = { stiffness = 2.0, rest = 4.0 }
limits = { lower = -0.5, upper = 6.0 }
angular_damping = 0.2
gravity = false
"#,
    );
    let settled = settle(&wound, 20.0, true);
    wound.start_from(&settled.start).unwrap();
    let mut simulation = Simulation::new(Arc::new(wound)).unwrap();
    let angle = simulation.joint(1).joint_position;
    assert!((angle - 4.0).abs() < 1e-3, "{angle} rad at the start");
    simulation.advance_to(0.1).unwrap();
    let joint = simulation.joint(1);
    assert!((joint.joint_position - 4.0).abs() < 1e-3, "{joint:?}");
    assert!(joint.force.abs() < 1e-2, "{joint:?}");
}

/// Fault: a scene through whose hole a sphere falls for ever did not come to rest, and nothing said which sphere, and where it was.
#[test]
fn the_sphere_that_falls_out_of_the_scene_is_named() {
    let text = hopper(1).replace("translation = [1.0, 0, 0]", "translation = [0, 0, 0]");
    let spheres = "[[spheres]]\nname = \"out\"\nmaterial = \"grain\"\nradius = 0.02\npositions = [[1, 0, 0.1]]\n[[boundary]]";
    let leaky = scene(&text.replacen("[[boundary]]", spheres, 1));
    let settled = settle(&leaky, 1.0, true);
    assert!(!settled.at_rest);
    let Some(Fastest::Sphere {
        index,
        position,
        lost,
    }) = settled.fastest.clone()
    else {
        panic!("{:?}", settled.fastest);
    };
    assert_eq!((index, lost), (25, true));
    assert!(position.z < -0.1, "{position}");
    let told = settled
        .fastest
        .map(|fastest| fastest.to_string())
        .unwrap_or_default();
    assert!(told.contains("sphere 25 at (1.0000, 0.0000, -"), "{told}");
    assert!(told.contains("nothing below it"), "{told}");
}
