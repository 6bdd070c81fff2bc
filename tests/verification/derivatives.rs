//! Derivatives of a communication step by the commands held over it: closed forms, and central differences of the whole
//! simulation, which is put back, given another command and stepped again.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::motion::Command;
use sphere_dda::observe::Observation;
use sphere_dda::observe::quantities::{quantities, values};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{Direction, Simulation};

use crate::support::G;

const HEAD: &str = r#"
[simulation]
duration = 1.0
step = 1e-3
[simulation.tolerance]
gap = 1e-12
slip = 1e-12
force = 1e-12
[[material]]
name = "glass"
density = 2500.0
friction = 0.3
"#;

const BALL: &str = r#"
[[spheres]]
name = "ball"
material = "glass"
radius = [0.1]
positions = [[0.0, 0.0, 0.1]]
[[probe]]
name = "ball"
sphere = "ball"
"#;

const FLOOR: &str = r#"
[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

fn simulation(parts: &[&str]) -> Simulation {
    let text = parts.concat();
    let loaded = Scene::from_toml("derivatives.toml", &text, Path::new("."));
    let scene = loaded.unwrap_or_else(|e| panic!("{}", e.plain())).scene;
    Simulation::new(Arc::new(scene)).unwrap()
}

/// What is measured, by name.
fn measured(simulation: &Simulation) -> BTreeMap<String, f64> {
    named(simulation, values(&Observation::of(simulation)))
}

fn named(simulation: &Simulation, values: Vec<f64>) -> BTreeMap<String, f64> {
    let names = quantities(simulation.scene()).into_iter().map(|q| q.name);
    names.zip(values).collect()
}

fn derivative(simulation: &Simulation, boundary: usize, change: Command) -> BTreeMap<String, f64> {
    let direction = Direction { boundary, change };
    let mut columns = simulation.sensitivities(&[direction]).unwrap();
    named(simulation, columns.remove(0))
}

/// A direction of each kind.
fn velocity(axis: usize) -> Command {
    Command {
        velocity: Vec3::ith(axis, 1.0),
        ..Command::default()
    }
}

/// A ball on a floor that has moved at a constant speed for a while. `h = 2 dt`, so the last wrench is that of the second step.
fn moving(friction: &str, speed: f64, steps: u32) -> Simulation {
    let head = HEAD.replace("friction = 0.3", friction);
    let mut simulation = simulation(&[&head, BALL, FLOOR, "input = \"twist\""]);
    let command = Command {
        velocity: Vec3::new(speed, 0.0, 0.0),
        ..Command::default()
    };
    simulation.command(0, command).unwrap();
    for _ in 0..steps {
        simulation.advance(2e-3).unwrap();
    }
    simulation
}

/// Slip: the force `mu m g` across the normal turns with the direction of slip, `dF_y = mu m g dv_y / v_slip`; that on the floor
/// has the other sign. Along the slip nothing changes.
#[test]
fn friction_of_a_slipping_ball_turns_with_the_floor() {
    let simulation = moving("friction = 0.3", 2.0, 1);
    let mass = simulation.scene().particles.mass[0];
    let across = derivative(&simulation, 0, velocity(1));
    let along = derivative(&simulation, 0, velocity(0));
    // From rest the surface of the ball gains 3.5 mu g dt a step, the half step at t = 0 half of that; dF/dv_y adds up:
    // w_y after a step is w_y = 1 - (3.5 mu g dt / slip) w_y ...
    let (gain, dt) = (3.5 * 0.3 * G, 1e-3);
    println!("{:?}", across.iter().filter(|(k, _)| k.contains("orce")).collect::<Vec<_>>());
    println!("{:?}", along.iter().filter(|(k, _)| k.contains("orce")).collect::<Vec<_>>());
    println!("{mass} {} {}", 0.3 * mass * G / 2.0, gain * dt);
}
