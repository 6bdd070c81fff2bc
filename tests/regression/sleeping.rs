//! Fault 1. Symptom: with `rest_speed` a ball in the air stopped and hung there for ever; a scene with any moving boundary never
//! slept; what sleeping took out of the motion had no force. Cause: speeds alone were judged, of the scene as a whole, and the
//! momentum was taken away without a wrench.

use sphere_dda::Vec3;
use sphere_dda::scene::Command;

use crate::support::{Case, G, Run};

const R: f64 = 0.05;

/// `z = z_0 - g t^2/2`, whatever the step: no force balances the weight.
#[test]
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

/// Three balls on each other, and one that falls on them from `height` above; two more stand apart.
fn struck(rest: f64, restitution: f64) -> Run {
    let mut case = Case::new(1e-3)
        .tolerance(1e-10)
        .set(&format!("rest_speed = {rest:?}"))
        .contact(0.5, restitution)
        .floor();
    for (x, z) in [
        (0.0, 1.0),
        (0.0, 3.0),
        (0.0, 5.0),
        (4.0, 1.0),
        (4.0, 3.0),
        (0.0, 8.0),
    ] {
        case = case.sphere(
            R,
            Vec3::new(x * R, 0.0, z * R),
            Vec3::zeros(),
            Vec3::zeros(),
        );
    }
    case.start()
}

/// A ball that falls on a pile asleep finds it as it would find it awake; what it does not touch sleeps on.
#[test]
fn a_ball_that_falls_on_a_pile_asleep_wakes_it() {
    for restitution in [0.0, 0.5] {
        let [mut with, mut without] = [1e-3, 0.0].map(|rest| struck(rest, restitution));
        let mut slept = false;
        while with.simulation.time() < 0.15 {
            with.step();
            without.step();
            slept |= (0..5).all(|i| with.velocity(i) == Vec3::zeros()) && with.velocity(5).z < 0.0;
            for i in 0..6 {
                let apart = (with.position(i) - without.position(i)).norm();
                assert!(
                    apart < 1e-6 * R,
                    "ball {i} at {} s: {apart:e} m",
                    with.simulation.time()
                );
            }
            let [a, b] = [&with, &without].map(|run| run.simulation.wrench(0).force.z);
            assert!((a - b).abs() < 1e-4 * b.abs(), "{a} and {b} N");
        }
        assert!(slept, "the pile did not sleep");
        assert!(
            (3..5).all(|i| with.velocity(i) == Vec3::zeros()),
            "what stands apart woke"
        );
    }
}

/// A floor that begins to move takes along what sleeps on it: by friction, `x = mu g t^2/2` while it slips.
#[test]
fn a_belt_that_starts_wakes_what_lies_on_it() {
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    let case = Case::new(1e-3)
        .set("rest_speed = 1e-3")
        .contact(0.2, 0.0)
        .boundary(face, "input = \"twist\"")
        .spheres("radius = 0.05\nlock = \"rotations\"\npositions = [[0.0, 0.0, 0.05]]");
    let mut run = case.start();
    run.steps(40);
    assert_eq!(run.simulation.report().sweeps, 0);
    let command = Command {
        velocity: Vec3::x() * 2.0,
        ..Command::default()
    };
    run.simulation.command(0, command).expect("a command");
    run.steps(200);
    let (found, t) = (run.position(0).x, 0.2);
    let expected = 0.5 * 0.2 * G * t * t;
    assert!(
        (found / expected - 1.0).abs() < 0.01,
        "{found} of {expected} m"
    );
}
