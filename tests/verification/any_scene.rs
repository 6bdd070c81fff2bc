//! Scenes that nobody has tuned: container, tool, sizes, law of contact and settings of each are drawn at random.
//!
//! In every communication step momentum balances and no overlap exceeds the tolerance, unless a sphere is squeezed and the report
//! says so. A saved state goes on with the same bits, in the same simulation and in a new one.

use std::path::Path;
use std::sync::Arc;

use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use crate::support::Run;

const SCENES: u64 = 64;
/// Communication steps \[s\], how many, and after how many the state is saved for as many as are [`KEPT`].
const STEP: f64 = 0.01;
const STEPS: usize = 60;
const SAVED: usize = 40;
const KEPT: usize = 4;
/// Largest error of momentum over the impulses of a step.
const ROUNDING: f64 = 1e-11;

/// One of `choices`, as a text.
fn one<T: ToString>(rng: &mut ChaCha8Rng, choices: &[T]) -> String {
    choices.choose(rng).map(T::to_string).unwrap_or_default()
}

/// The scene of a seed: grains of about 6 mm packed into a container 80 mm wide, and what stirs, presses, pushes or shakes them.
fn text(seed: u64) -> String {
    let rng = &mut ChaCha8Rng::seed_from_u64(seed);
    let accuracy = one(rng, &["fast", "standard", "standard"]);
    let rest_speed = one(rng, &["0.0", "0.002", "0.01"]);
    let young = one(rng, &["", "", "young = 5e6"]);
    let friction = one(rng, &[0.1, 0.3, 0.5, 0.9]);
    let rolling = one(rng, &[0.0, 0.0, 0.05, 0.2]);
    let restitution = one(rng, &[0.0, 0.3, 0.8]);
    let cohesion = one(rng, &["", "", "cohesion = 0.05"]);
    let container = one(
        rng,
        &[
            "box = { min = [-0.04, -0.04, 0.0], max = [0.04, 0.04, 1.0] }",
            "cylinder = { base = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1.0], radius = 0.045, height = 1.0, closed = true }",
            "cone = { base = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1.0], r0 = 0.03, r1 = 0.13, height = 1.0 } }, { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }",
        ],
    );
    let shaken = "motion = { sinusoid = { translation = [0.001, 0.0, 0.003], frequency = 20.0 } }";
    let motion = one(rng, &["", "", shaken]);
    let tool = one(
        rng,
        &[
            "",
            "faces = [{ box = { min = [-0.03, -0.003, 0.02], max = [0.03, 0.003, 0.05] } }]\nmotion = { constant = { angular_velocity = [0.0, 0.0, 6.0] } }",
            "faces = [{ box = { min = [-0.03, -0.03, 0.7], max = [0.03, 0.03, 0.71] } }]\nbody = { mass = 0.05, joint = { slide = [0.0, 0.0, 1.0] } }",
            "faces = [{ box = { min = [-0.015, -0.015, 0.7], max = [0.015, 0.015, 0.73] } }]\nbody = { mass = 0.2, inertia = [3e-5, 3e-5, 3e-5], centre = [0.0, 0.0, 0.715] }",
        ],
    );
    let tool = match tool.as_str() {
        "" => String::new(),
        tool => format!("[[boundary]]\nname = \"tool\"\nmaterial = \"wall\"\n{tool}\n"),
    };
    let size = one(
        rng,
        &[
            "radius = 0.006",
            "size = { uniform = { min = 0.004, max = 0.008 } }",
            "size = { log_normal = { median = 0.004, sigma = 0.4, min = 0.002, max = 0.01 } }",
            "clump = \"rod\"\nradius = 0.006",
        ],
    );
    let count = rng.random_range(40..110);
    format!(
        r#"
[simulation]
duration = 1.0
communication_step = {STEP:?}
accuracy = "{accuracy}"
rest_speed = {rest_speed}
[[material]]
name = "grain"
density = 2500.0
{young}
[[material]]
name = "wall"
[pair_default]
friction = {friction}
rolling_friction = {rolling}
restitution = {restitution}
{cohesion}
[[clump]]
name = "rod"
members = [{{ position = [0, 0, 0], radius = 1 }}, {{ position = [1.2, 0, 0], radius = 1 }}, {{ position = [2.4, 0, 0], radius = 0.8 }}]
[[spheres]]
name = "grains"
material = "grain"
seed = {seed}
{size}
packing = {{ region = {{ box = {{ min = [-0.024, -0.024, 0.06], max = [0.024, 0.024, 0.69] }} }}, count = {count} }}
[[boundary]]
name = "container"
material = "wall"
faces = [{{ {container} }}]
{motion}
{tool}
"#
    )
}

/// Takes communication step `k` of the scene of `seed`, and checks it.
fn take(run: &mut Run, k: usize, seed: u64) {
    let end = STEP * k as f64;
    let communication = run.simulation.begin(end).expect("a step");
    let before = run.momentum();
    run.simulation.finish(communication).expect("a step");
    let simulation = &run.simulation;
    let boundaries = 0..simulation.scene().boundaries.len();
    let walls: Vec3 = boundaries.map(|b| -simulation.mean_wrench(b).force).sum();
    let body_force = simulation.mean_body_force();
    let pressed: f64 = simulation.contacts().iter().map(|c| c.force.norm()).sum();
    let scale = STEP * (body_force.norm() + pressed) + before.norm();
    let error = (run.momentum() - before - (body_force + walls) * STEP).norm();
    let at = format!("scene {seed} at {:.2} s", simulation.time());
    assert!(error < ROUNDING * scale, "{at}: {error:e} of {scale:e} N s");
    let (report, tolerance) = (simulation.report(), &simulation.scene().settings.tolerance);
    if report.squeezed.is_none() {
        assert_eq!(report.unconverged_steps, 0, "{at}");
        let overlap = report.max_overlap;
        assert!(overlap <= tolerance.gap, "{at}: overlap {overlap:e} R");
    }
}

#[test]
fn every_scene_balances_and_goes_on_from_a_saved_state() {
    for seed in 0..SCENES {
        let loaded = Scene::from_toml("scene", &text(seed), Path::new(""));
        let loaded = loaded.unwrap_or_else(|error| panic!("{}", error.plain()));
        let scene = Arc::new(loaded.scene);
        let new = || Simulation::new(scene.clone()).expect("a start");
        let mut run = Run { simulation: new() };
        let (mut saved, mut after) = (Vec::new(), Vec::new());
        for k in 1..=STEPS {
            take(&mut run, k, seed);
            match k {
                SAVED => saved = run.simulation.snapshot(),
                _ if k == SAVED + KEPT => after = run.simulation.snapshot(),
                _ => {}
            }
        }
        for mut simulation in [run.simulation, new()] {
            simulation.restore(&saved).expect("a state of this scene");
            for k in SAVED + 1..=SAVED + KEPT {
                simulation.advance_to(STEP * k as f64).expect("a step");
            }
            assert!(simulation.snapshot() == after, "scene {seed}");
        }
    }
}
