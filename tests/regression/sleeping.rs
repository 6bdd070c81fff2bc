//! Fault 1. Symptom: with `rest_speed` a ball in the air stops and hangs there for ever; a scene with any moving boundary never
//! sleeps; what sleeping takes out of the motion has no force. Cause: `Simulation::is_at_rest` judges speeds alone, of the
//! scene as a whole, and `stop` takes the momentum away without a wrench.

use sphere_dda::Vec3;

use crate::support::{Case, G};

const R: f64 = 0.05;

/// `z = z_0 - g t^2/2`, whatever the step: no force balances the weight.
#[test]
#[ignore = "fault 1, not mended yet"]
fn a_ball_in_the_air_falls_at_any_step() {
    let case = Case::new(1e-5).set("rest_speed = 1e-3").floor();
    let mut run = case
        .sphere(R, Vec3::z() * 0.5, Vec3::zeros(), Vec3::zeros())
        .start();
    run.until(2e-3);
    let fallen = 0.5 - run.position(0).z;
    let expected = 0.5 * G * run.simulation.time().powi(2);
    assert!(
        (fallen / expected - 1.0).abs() < 1e-2,
        "{fallen:e} of {expected:e} m"
    );
}

/// Thrown up with v, it is back at its height with -v after 2 v/g.
#[test]
#[ignore = "fault 1, not mended yet"]
fn a_ball_turns_round_at_the_top_of_its_flight() {
    let v = 0.02;
    let case = Case::new(1e-5).set("rest_speed = 1e-3").floor();
    let mut run = case
        .sphere(R, Vec3::z() * 0.5, Vec3::z() * v, Vec3::zeros())
        .start();
    run.until(2.0 * v / G);
    let now = run.velocity(0).z;
    assert!((now + v).abs() < 1e-2 * v, "{now} m/s");
}

/// Where loads balance, a contact that carries them lets the scene sleep: no sweeps.
#[test]
fn a_ball_on_a_floor_sleeps() {
    let case = Case::new(1e-3)
        .set("rest_speed = 1e-3")
        .contact(0.5, 0.0)
        .floor();
    let mut run = case
        .sphere(R, Vec3::z() * R, Vec3::zeros(), Vec3::zeros())
        .start();
    run.steps(30);
    run.step();
    assert_eq!(run.simulation.report().sweeps, 0);
    let force = -run.simulation.wrench(0).force.z;
    assert!((force / (run.mass(0) * G) - 1.0).abs() < 1e-6, "{force} N");
}

/// A running conveyor that touches nothing of the heap does not keep it awake: sweeps go on for what moves alone, here nothing.
#[test]
#[ignore = "fault 1, not mended yet"]
fn a_heap_beside_a_running_belt_sleeps() {
    let belt = "rectangle = { corner = [5.0, 0.0, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }";
    let mut case = Case::new(1e-3)
        .set("rest_speed = 1e-3")
        .contact(0.5, 0.0)
        .floor();
    case = case.boundary(belt, "surface_velocity = [1.0, 0.0, 0.0]");
    for k in 0..3 {
        let x = Vec3::z() * (R * f64::from(2 * k + 1));
        case = case.sphere(R, x, Vec3::zeros(), Vec3::zeros());
    }
    let mut run = case.start();
    run.steps(30);
    run.step();
    assert_eq!(run.simulation.report().sweeps, 0);
}

/// `m (v_1 - v_0)` is the impulse of all forces, of those that stop a ball for good too: a ball that creeps over a smooth
/// floor creeps on, or the floor is booked with its momentum.
#[test]
#[ignore = "fault 1, not mended yet"]
fn sleep_takes_no_momentum_without_a_force() {
    let v = 5e-4;
    let case = Case::new(1e-3).set("rest_speed = 1e-3").floor();
    let mut run = case
        .sphere(R, Vec3::z() * R, Vec3::x() * v, Vec3::zeros())
        .start();
    let (mass, mut impulse) = (run.mass(0), 0.0);
    let before = run.velocity(0).x;
    for _ in 0..50 {
        run.step();
        impulse -= run.simulation.mean_wrench(0).force.x * 1e-3;
    }
    let change = mass * (run.velocity(0).x - before);
    assert!(
        (change - impulse).abs() < 1e-6 * mass * v,
        "{change:e} against {impulse:e} N s"
    );
}
