//! Spheres that wait outside the scene, or have left it, do not show in the others.

use sphere_dda::error::StepError;
use sphere_dda::observe::Observation;
use sphere_dda::simulation::Simulation;

use crate::simulation;

/// Rods and balls rain on a plate that turns with its frame, and off it into a sink, where the ball that is first of all has been from the
/// start; another one hangs on a spring.
fn rain([rods, balls]: [usize; 2]) -> Simulation {
    simulation(&format!(
        r#"
[simulation]
duration = 1.0
step = 2e-3
rotating_frame = {{ axis = [0, 0, 1], speed = 0.5 }}
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.4
restitution = 0.3
rolling_friction = 0.05
[[clump]]
name = "rod"
members = [{{ position = [0, 0, 0], radius = 1 }}, {{ position = [1.2, 0, 0], radius = 1 }}]
[[spheres]]
name = "gone"
material = "stone"
radius = 0.02
positions = [[0, 0, -3.0]]
[[spheres]]
name = "held"
material = "stone"
radius = 0.02
positions = [[0, 0, 1.0]]
[[spring]]
sphere = "held"
stiffness = 1000.0
target = [0, 0, 1.0]
[[source]]
name = "rods"
material = "stone"
clump = "rod"
radius = 0.015
capacity = {rods}
rate = 30
seed = 3
region = {{ box = {{ min = [-0.1, -0.1, 0.2], max = [0.1, 0.1, 0.4] }} }}
[[source]]
name = "balls"
material = "stone"
radius = 0.02
capacity = {balls}
rate = 50
seed = 4
region = {{ box = {{ min = [-0.1, -0.1, 0.2], max = [0.1, 0.1, 0.4] }} }}
[[boundary]]
name = "plate"
material = "stone"
faces = [{{ rectangle = {{ corner = [-0.12, -0.12, 0], u = [0.24, 0, 0], v = [0, 0.24, 0] }} }}]
[[sink]]
name = "drain"
region = {{ beyond = {{ point = [0, 0, -0.2], normal = [0, 0, -1] }} }}
"#
    ))
}

/// More room in sources changes no bit of what is there.
#[test]
fn unused_capacity_changes_nothing() {
    let mut both = [rain([40, 60]), rain([90, 700])];
    for k in 1..=20 {
        let found = both.each_mut().map(|simulation| {
            simulation.advance_to(f64::from(k) * 0.05).unwrap();
            let observation = Observation::of(simulation);
            let now = &simulation.state().kinematics;
            let spheres = observation.present().map(|i| {
                let place = (now.position[i], now.orientation[i]);
                (place, now.velocity[i], now.spin[i])
            });
            let contacts = simulation.contacts();
            let forces = contacts.iter().map(|contact| contact.force);
            let state = simulation.state();
            let sums = (
                state.mean_wrenches.clone(),
                state.work,
                state.removed.clone(),
            );
            (
                spheres.collect::<Vec<_>>(),
                forces.collect::<Vec<_>>(),
                sums,
            )
        });
        assert!(found[0] == found[1], "at {}", both[0].time());
    }
    let simulation = &both[1];
    let (contacts, removed) = (simulation.contacts().len(), simulation.state().removed[0]);
    assert!(contacts > 15 && removed > 0.5, "{contacts} {removed}");
    // Their order is that of the scene: the second sphere is the one that is held.
    let held = simulation.state().kinematics.position[1];
    assert!((held.z - 1.0).abs() < 5e-3, "{held}");
    assert!(!simulation.state().kinematics.present[0]);
}

/// An error names a sphere by its number in the scene.
#[test]
fn errors_know_the_numbers_of_all() {
    let mut simulation = simulation(
        r#"
[simulation]
duration = 1.0
step = 0.01
strict = true
[[material]]
name = "stone"
density = 2500.0
[[spheres]]
name = "gone"
material = "stone"
radius = 0.1
positions = [[0, 0, -3], [1, 0, -3], [2, 0, -3]]
[[spheres]]
name = "pressed"
material = "stone"
radius = 0.1
positions = [[0, 0, 0.1]]
[[sink]]
name = "drain"
region = { beyond = { point = [0, 0, -1], normal = [0, 0, -1] } }
[[boundary]]
name = "floor"
material = "stone"
faces = [{ rectangle = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] } }]
[[boundary]]
name = "lid"
material = "stone"
faces = [{ rectangle = { corner = [-1, -1, 0.201], u = [0, 2, 0], v = [2, 0, 0] } }]
motion = { table = { time = [0.0, 1.0], translation = [[0, 0, 0], [0, 0, -0.01]] } }
"#,
    );
    let error = loop {
        if let Err(error) = simulation.advance(0.01) {
            break error;
        }
        assert!(simulation.time() < 0.2, "the lid went through the sphere");
    };
    let StepError::Pinched { sphere, .. } = error else {
        panic!("{error}");
    };
    assert_eq!(sphere, 3);
}
