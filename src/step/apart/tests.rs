//! A step without those that take no part is that of all.

#![cfg(test)]

use std::path::Path;
use std::sync::Arc;

use super::*;
use crate::simulation::Simulation;
use crate::spatial::{SpatialVector, Wrench};
use crate::step::{Effort, StepInput, Workspace, stages, step};

/// Rods lie on a floor; one ball has left, the next one hangs on a spring.
const SCENE: &str = r#"
[simulation]
duration = 1.0
step = 2e-3
tolerance = { gap = 1e-9, slip = 1e-9, force = 1e-9, opening = 0 }
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.4
[[clump]]
name = "rod"
members = [{ position = [0, 0, 0], radius = 1 }, { position = [1.2, 0, 0], radius = 1 }]
[[spheres]]
name = "balls"
material = "stone"
radius = 0.02
positions = [[0, 0, -3.0], [0, 0, 1.0]]
[[spring]]
sphere = "balls[1]"
stiffness = 1000.0
target = [0, 0, 1.0]
[[source]]
name = "rods"
material = "stone"
clump = "rod"
radius = 0.015
capacity = 40
rate = 100
stop = 0.1
seed = 3
region = { box = { min = [-0.1, -0.1, 0.02], max = [0.1, 0.1, 0.1] } }
[[boundary]]
name = "floor"
material = "stone"
faces = [{ rectangle = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] } }]
[[sink]]
name = "drain"
region = { beyond = { point = [0, 0, -1], normal = [0, 0, -1] } }
"#;

const FRAME: &str = "rotating_frame = { axis = [0, 0, 1], speed = 0.2 }";

/// The simulation of a scene.
fn start(text: &str) -> Simulation {
    let loaded = Scene::from_toml("scene", text, Path::new(""));
    let loaded = loaded.unwrap_or_else(|error| panic!("{}", error.plain()));
    Simulation::new(Arc::new(loaded.scene)).expect("a start")
}

/// That scene, and more of its simulation.
fn at(time: f64, more: &str) -> Simulation {
    let text = SCENE.replace("[simulation]", &format!("[simulation]\n{more}"));
    let mut simulation = start(&text);
    simulation.advance_to(time).expect("steps");
    simulation
}

/// A step of the present ones alone is that of all. Returns the state before it and after.
fn same_as_among_all(simulation: &Simulation) -> [State; 2] {
    let (scene, start) = (simulation.scene(), simulation.state());
    let input = StepInput::still(start, 1e-3);
    let effort = Effort::default();
    let [mut alone, mut all] = [(); 2].map(|()| (start.clone(), Workspace::default()));
    step(scene, &mut alone.0, &mut alone.1, &input, effort).expect("a step");
    stages(scene, &mut all.0, &mut all.1, &input, effort).expect("a step");
    assert_eq!(alone.1.participants.number.len(), 1 + 2 * 10);
    let (alone, all) = (alone.0, all.0);
    let near = |a: &[SpatialVector], b: &[SpatialVector], tolerance: f64| {
        assert_eq!(a.len(), b.len());
        for (i, (a, b)) in a.iter().zip(b).enumerate() {
            let apart = a.plus(b, -1.0);
            let size = apart.linear.norm() + apart.angular.norm();
            assert!(size < tolerance, "{i}: {a:?}, {b:?}");
        }
    };
    let moving = |state: &State| -> Vec<SpatialVector> {
        let spheres = 0..state.kinematics.len();
        let velocity = |i| state.kinematics.spatial_velocity(i);
        spheres.map(velocity).collect()
    };
    near(&moving(&alone), &moving(&all), 1e-6);
    near(&alone.smooth, &all.smooth, 1e-3);
    near(&alone.external, &all.external, 1e-9);
    assert!(moving(&all) != moving(start));
    let places = alone
        .kinematics
        .position
        .iter()
        .zip(&all.kinematics.position);
    assert!(places.into_iter().all(|(a, b)| (a - b).norm() < 1e-9));
    assert_eq!((&alone.calm, &alone.ground), (&all.calm, &all.ground));
    let keys = |state: &State| -> Vec<_> { state.contacts.iter().map(|c| c.key).collect() };
    assert_eq!(keys(&alone), keys(&all));
    assert!(keys(&all).len() > 10);
    [start.clone(), all]
}

#[test]
fn the_present_ones_do_as_they_do_among_all() {
    let [_, after] = same_as_among_all(&at(0.4, FRAME));
    assert!(!after.external.is_empty());
    let [before, after] = same_as_among_all(&at(0.4, "rest_speed = 0.2"));
    assert!(after.calm.iter().any(|&steps| steps > 1) && after.calm != before.calm);
}

/// Lists of neighbours number the spheres that take part: they end with others.
#[test]
fn others_have_neighbours_of_their_own() {
    let simulation = at(0.4, "");
    let scene = simulation.scene();
    let mut state = State::clone(simulation.state());
    let mut participants = Participants::default();
    let mut neighbors = NeighborList::default();
    let count = |neighbors: &NeighborList| neighbors.pairs.len();
    let mut look = |state: &State, neighbors: &mut NeighborList| {
        neighbors.pairs = vec![(0, 1)];
        let input = StepInput::still(state, 1e-3);
        let apart = participants.apart(scene, (state, &input), neighbors, Depth::FIRST);
        assert!(apart.is_some());
    };
    look(&state, &mut neighbors);
    assert_eq!(count(&neighbors), 0);
    look(&state, &mut neighbors);
    assert_eq!(count(&neighbors), 1);
    // The last rod comes in the place of the first.
    let spheres = state.kinematics.len();
    state.kinematics.present[2..4].fill(false);
    state.kinematics.present[spheres - 2..].fill(true);
    look(&state, &mut neighbors);
    assert_eq!(count(&neighbors), 0);
}

/// Balls at these places \[m\] on a floor, which may fall asleep.
fn balls(positions: &[[f64; 3]]) -> Simulation {
    let text = format!(
        r#"
[simulation]
duration = 1.0
step = 1e-3
tolerance = {{ gap = 1e-6, slip = 1e-6, force = 1e-4, opening = 0 }}
rest_speed = 0.01
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.5
[[spheres]]
name = "balls"
material = "stone"
radius = 0.01
positions = {positions:?}
[[boundary]]
name = "floor"
material = "stone"
faces = [{{ plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }} }}]
point_of_action = [0.3, -0.2, 0.1]
"#
    );
    start(&text)
}

/// A ridge of balls: two rows on the floor and one in the groove between them. The last ball is above its middle.
fn ridge() -> Vec<[f64; 3]> {
    let (count, radius, apart) = (80, 0.01, 0.0206);
    let x = |k: f64| apart * (k - 0.5 * f64::from(count));
    let rows = (0..count).map(f64::from).flat_map(|k| {
        [
            [x(k), -0.5 * apart, radius],
            [x(k), 0.5 * apart, radius],
            [x(k + 0.5), 0.0, radius + 0.01371],
        ]
    });
    let rows = rows.take(3 * count as usize - 1);
    rows.chain([[0.003, 0.001, 1.0]]).collect()
}

/// A ball that falls on a ridge, hits and comes to rest does as among all.
#[test]
fn what_sleeps_far_away_takes_no_part() {
    let mut simulation = balls(&ridge());
    simulation.advance_to(0.2).expect("steps");
    let mut state = State::clone(simulation.state());
    let scene = simulation.scene();
    let spheres = scene.particles.len();
    let asleep = state.calm.iter().filter(|&&calm| calm == ASLEEP);
    assert_eq!(asleep.count(), spheres - 1);
    let effort = Effort {
        accept: true,
        ..Effort::default()
    };
    // It goes on from just above.
    let ball = spheres - 1;
    state.kinematics.position[ball].z = 0.045;
    state.kinematics.velocity[ball].z = -0.1;
    let mut workspace = Workspace::default();
    let (mut fewest, mut left_out) = (spheres, 0);
    for _ in 0..150 {
        let input = StepInput::still(&state, 1e-3);
        let mut among_all = (state.clone(), Workspace::default());
        stages(scene, &mut among_all.0, &mut among_all.1, &input, effort).expect("a step");
        step(scene, &mut state, &mut workspace, &input, effort).expect("a step");
        let number = workspace.participants.number.len();
        left_out += usize::from(number > 0);
        fewest = fewest.min(if number > 0 { number } else { spheres });
        same(scene, &state, &among_all.0);
        state.time += 1e-3;
    }
    // In the air, at the impact and after it.
    let few = fewest < spheres / 8 && left_out > 60;
    assert!(few, "{fewest} of {spheres}, {left_out}");
}

/// Two states that a step has left are one, as far as a solver tells.
fn same(scene: &Scene, one: &State, other: &State) {
    let time = one.time;
    let weight = scene.settings.gravity.norm() * scene.particles.mass[0];
    let near = |what: &str, (one, other): (&[Vec3], &[Vec3]), tolerance: f64| {
        assert_eq!(one.len(), other.len(), "{what} at {time}");
        for (i, (a, b)) in one.iter().zip(other).enumerate() {
            assert!((a - b).norm() < tolerance, "{what} {i}: {a}, {b} at {time}");
        }
    };
    let [a, b] = [one, other].map(|state| &state.kinematics);
    near("velocity", (&a.velocity, &b.velocity), 1e-5);
    near("spin", (&a.spin, &b.spin), 1e-3);
    near("position", (&a.position, &b.position), 1e-8);
    assert_eq!(one.asleep(), other.asleep(), "at {time}");
    let forces = |all: &[Wrench]| -> Vec<Vec3> { all.iter().map(|wrench| wrench.force).collect() };
    let torques =
        |all: &[Wrench]| -> Vec<Vec3> { all.iter().map(|wrench| wrench.torque).collect() };
    for (a, b) in [
        (&one.wrenches, &other.wrenches),
        (&one.smooth_wrenches, &other.smooth_wrenches),
    ] {
        near("force", (&forces(a), &forces(b)), 1e-3 * weight);
        near("torque", (&torques(a), &torques(b)), 1e-4 * weight);
    }
    near(
        "weight",
        (&[one.body_force], &[other.body_force]),
        1e-6 * weight,
    );
    let keys = |state: &State| -> Vec<_> { state.contacts.iter().map(|load| load.key).collect() };
    assert!(one.contacts.fits() && keys(one).is_sorted());
    assert_eq!(keys(one), keys(other), "at {time}");
    let loads =
        |state: &State| -> Vec<_> { state.contacts.iter().map(|load| load.force).collect() };
    near("load", (&loads(one), &loads(other)), 1e-3 * weight);
}

/// One that lies on what takes no part falls asleep on the boundary of that.
#[test]
fn the_top_of_a_tower_sleeps_on_the_floor() {
    let place = |k: i32| [0.0, 0.0, 0.01 * f64::from(2 * k + 1)];
    let places: Vec<_> = (0..20).map(place).collect();
    let mut simulation = balls(&places);
    simulation.advance_to(0.05).expect("steps");
    let mut state = State::clone(simulation.state());
    assert_eq!(state.calm, [ASLEEP; 20]);
    state.calm[19] = 0;
    let mut workspace = Workspace::default();
    let mut steps = 0;
    while state.calm[19] != ASLEEP {
        let input = StepInput::still(&state, 1e-3);
        let scene = simulation.scene();
        step(scene, &mut state, &mut workspace, &input, Effort::default()).expect("a step");
        let number = &workspace.participants.number;
        assert!((2..10).contains(&number.len()) && number[0] > 0);
        state.time += 1e-3;
        steps += 1;
        assert!(steps < 15);
    }
}
