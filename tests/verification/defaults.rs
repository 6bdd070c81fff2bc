//! What a scene gets that sets no key of the solver: steps that are chosen, forces that stand still, no step that ends a run.

use std::ops::ControlFlow;
use std::sync::Arc;

use sphere_dda::scene::{Accuracy, Scene};
use sphere_dda::simulation::{Settle, Settled, Simulation};

/// Grains in a box whose floor is a boundary of its own, with more keys of `[simulation]` and more tables.
fn grains(count: usize, keys: &str, tables: &str) -> Scene {
    let text = format!(
        r#"
[simulation]
duration = 1.0
communication_step = 0.01
{keys}
[[material]]
name = "grain"
density = 2500
[pair_default]
friction = 0.4
[[spheres]]
name = "fill"
material = "grain"
radius = 0.01
radius_jitter = 0.1
packing = {{ region = {{ box = {{ min = [0, 0, 0], max = [0.1, 0.1, 0.2] }} }}, count = {count} }}
[[boundary]]
name = "walls"
material = "grain"
faces = [{{ box = {{ min = [0, 0, -0.05], max = [0.1, 0.1, 0.5] }} }}]
[[boundary]]
name = "floor"
material = "grain"
faces = [{{ rectangle = {{ corner = [-0.1, -0.1, 0], u = [0.3, 0, 0], v = [0, 0.3, 0] }} }}]
input = {{ slide = [0, 0, 1] }}
{tables}
"#
    );
    Scene::from_toml("grains", &text, std::path::Path::new(""))
        .unwrap()
        .scene
}

/// Kinetic energy of all grains \[J\].
fn kinetic_energy(simulation: &Simulation) -> f64 {
    let particles = &simulation.scene().particles;
    let of = |i: usize| {
        let v = simulation.velocity(i);
        particles.kinetic_energy(i, &v.linear, &v.angular)
    };
    (0..particles.len()).map(of).sum()
}

/// `scene` settled until it rests.
fn settled(mut scene: Scene) -> Scene {
    let settle = Settle {
        time: 20.0,
        until_rest: true,
    };
    let settled = Settled::new(&scene, settle, |_| ControlFlow::Continue(())).unwrap();
    assert!(settled.at_rest);
    scene.start_from(&settled.start).unwrap();
    scene
}

/// Symptom: loaded contacts that a step left open by less than the tolerance were closed by the next one, so that forces on a
/// gate at rest wandered by a quarter in half a second and kinetic energy grew.
#[test]
fn forces_at_rest_stand_still_at_every_accuracy() {
    for accuracy in Accuracy::ALL {
        let keys = format!("accuracy = \"{}\"", accuracy.name());
        let mut simulation = Simulation::new(Arc::new(settled(grains(150, &keys, "")))).unwrap();
        let mut forces = Vec::new();
        let mut energies = Vec::new();
        for k in 1..=200 {
            let report = simulation.advance_to(0.01 * f64::from(k)).unwrap();
            assert_eq!(report.unconverged_steps, 0);
            forces.push(simulation.mean_wrench(1).force.z);
            energies.push(kinetic_energy(&simulation));
        }
        let mean = forces.iter().sum::<f64>() / 200.0;
        let off = forces.iter().map(|f| (f / mean - 1.0).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 0.01, "{}: {off} of {mean} N", accuracy.name());
        let largest = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
        // A hundred-millionth of what lifts all grains by a radius: what the force tolerance leaves.
        let rounding = 1e-8 * mean.abs() * 0.01;
        assert!(
            largest(&energies[150..]) <= largest(&energies[..50]).max(rounding),
            "{}: {:e} J after {:e} J",
            accuracy.name(),
            largest(&energies[150..]),
            largest(&energies[..50])
        );
    }
}

/// Symptom: 500 grains in a box, nothing set but a step, ended at 0.17 s after 31 s of CPU time; steps of 2 ms cost thirty
/// times as much as those of 1 ms. Sweeps are pinned by their order of magnitude.
#[test]
fn any_bound_of_the_step_will_do() {
    let run = |keys: &str| {
        let scene = Arc::new(grains(150, keys, ""));
        let gap = scene.settings.tolerance.gap;
        let mut simulation = Simulation::new(scene).unwrap();
        let mut sweeps = 0;
        for k in 1..=30 {
            let report = simulation.advance_to(0.01 * f64::from(k)).unwrap();
            assert!(report.max_overlap <= gap, "{keys}: {}", report.max_overlap);
            assert_eq!(report.unconverged_steps, 0, "{keys}");
            sweeps += report.sweeps;
        }
        sweeps
    };
    let free = run("");
    for step in ["3e-3", "1e-2", "0.2", "10.0"] {
        assert_eq!(run(&format!("step = {step}")), free, "{step} s");
    }
    assert!(run("step = 1e-4") < 20 * free);
    assert!(run("accuracy = \"fast\"") < free);
}

/// A floor that rises against a lid squeezes what is between: there is no rigid answer, and the run goes on all the same.
#[test]
fn a_squeezed_sphere_does_not_end_the_run() {
    let lid = "[[boundary]]\nname = \"lid\"\nmaterial = \"grain\"\n\
        faces = [{ plane = { point = [0, 0, 0.03], normal = [0, 0, -1] } }]";
    let squeeze = |keys: &str| {
        let mut simulation = Simulation::new(Arc::new(grains(6, keys, lid))).unwrap();
        let mut unconverged = 0;
        for k in 1..=100 {
            let command = sphere_dda::scene::Command {
                scalar: 1.5e-4 * f64::from(k),
                ..simulation.state().commands[1]
            };
            simulation.command(1, command).unwrap();
            unconverged += simulation
                .advance_to(0.01 * f64::from(k))?
                .unconverged_steps;
        }
        Ok::<_, sphere_dda::error::StepError>((unconverged, simulation))
    };
    let (unconverged, simulation) = squeeze("").unwrap();
    let force = simulation.mean_wrench(1).force.z;
    assert!(force.is_finite() && force < 0.0, "{force} N");
    let overlap = simulation.state().report.max_overlap;
    assert!(
        unconverged > 0 && overlap < 0.5,
        "{unconverged} steps, {overlap}"
    );
    assert!(squeeze("strict = true").is_err());
}

/// Symptom: a remainder of 1e-9 s, as masters make them by rounding, put out forces of 1e5 N on a bed of 5 N; and the step after
/// it took the noise of its forces into the half step, which moved those of 106 grains by 5 %.
#[test]
fn a_remainder_of_a_step_is_no_shock() {
    let cases = [97, 100, 106].map(|count| (count, Arc::new(settled(grains(count, "", "")))));
    let remainders = cases
        .iter()
        .flat_map(|case| [1e-5, 1e-7, 1e-9].map(|r| (case, r)));
    for ((count, scene), remainder) in remainders {
        let mut simulation = Simulation::new(Arc::clone(scene)).unwrap();
        simulation.advance(0.01).unwrap();
        let before = simulation.mean_wrench(1).force.z;
        simulation.advance(remainder).unwrap();
        let during = simulation.mean_wrench(1).force.z;
        simulation.advance(0.01).unwrap();
        let after = simulation.mean_wrench(1).force.z;
        for force in [during, after] {
            assert!(
                (force / before - 1.0).abs() < 0.01,
                "{count} grains, {remainder} s: {force} N, {before} N"
            );
        }
    }
}

/// Masters differ by rounding in what they call a step of 1 ms: that decides no trajectory.
#[test]
fn lengths_that_differ_by_rounding_give_the_same_bits() {
    let run = |rounding: f64| {
        let mut simulation = Simulation::new(Arc::new(grains(60, "", ""))).unwrap();
        for _ in 0..40 {
            simulation.advance(0.01 * (1.0 + rounding)).unwrap();
        }
        simulation.state().kinematics.position.clone()
    };
    assert_eq!(run(0.0), run(3e-12));
    assert_ne!(run(0.0), run(1e-4));
}

/// Symptom: without gravity every contact that a load elsewhere presses counted as an impact in every step, and grains under a
/// lid showed speeds of `F dt / 2 m` at rest.
#[test]
fn grains_pressed_without_gravity_come_to_rest() {
    let lid = "[[boundary]]\nname = \"lid\"\nmaterial = \"grain\"\n\
        faces = [{ plane = { point = [0, 0, 0.21], normal = [0, 0, -1] } }]\n\
        body = { mass = 0.5, joint = { slide = [0, 0, 1] }, force = [0, 0, -50] }";
    let scene = settled(grains(150, "gravity = [0, 0, 0]", lid));
    let mut simulation = Simulation::new(Arc::new(scene)).unwrap();
    simulation.advance_to(0.2).unwrap();
    let energy = kinetic_energy(&simulation);
    assert!(energy < 1e-7 * 50.0 * 0.01, "{energy:e} J");
    let force = simulation.mean_wrench(2).force.z;
    assert!((force / 50.0 - 1.0).abs() < 1e-2, "{force} N");
}

/// Symptom: where a table of gravity began at zero, steps were as long as a fall without gravity takes, 5e-2 s. Cause: the fall
/// that chooses steps had the gravity of t = 0.
#[test]
fn steps_follow_the_largest_gravity_of_a_table() {
    let table = |gravity: &str| {
        format!("gravity_motion = {{ table = {{ time = [0, 1, 1.001], gravity = {gravity} }} }}")
    };
    let steps = |keys: &str| {
        let settings = grains(5, keys, "").settings;
        (settings.step, settings.smallest_step)
    };
    let fixed = steps("");
    assert_eq!(
        steps(&table("[[0, 0, 0], [0, 0, 0], [0, 0, -9.81]]")),
        fixed
    );
    assert_eq!(
        steps(&table("[[0, 0, -1], [9.81, 0, 0], [0, 0, 0]]")),
        fixed
    );
}

/// Without gravity the loads move the spheres: with a force of its weight on a sphere steps are those of its fall.
#[test]
fn without_gravity_steps_follow_the_loads() {
    let step = |keys: &str, tables: &str| grains(1, keys, tables).settings.step;
    let weight = 9.81 * grains(1, "", "").particles.mass[0];
    let load = format!("[[load]]\nsphere = \"fill[0]\"\nforce = [{weight}, 0, 0]\n");
    let (fallen, pushed) = (step("", ""), step("gravity = [0, 0, 0]", &load));
    assert!((pushed / fallen - 1.0).abs() < 1e-12, "{pushed} {fallen}");
    let press = format!(
        "[[boundary]]\nname = \"press\"\nmaterial = \"grain\"\n\
         faces = [{{ plane = {{ point = [0, 0, 1], normal = [0, 0, -1] }} }}]\n\
         body = {{ mass = 2.0, joint = {{ slide = [0, 0, -1] }}, force = [0, 0, {}], gravity = false }}\n",
        -2.0 * 9.81
    );
    let pressed = step("gravity = [0, 0, 0]", &press);
    assert!((pressed / fallen - 1.0).abs() < 1e-12, "{pressed} {fallen}");
}
