//! Fault 8. Symptoms and causes stand at each test.

use std::f64::consts::FRAC_PI_2;
use std::ops::ControlFlow;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::formats::snapshot;
use sphere_dda::scene::{Command, Scene};
use sphere_dda::simulation::{Settle, Settled, Simulation};
use sphere_dda::state::State;

use crate::support::{Case, G, Run};

const R: f64 = 0.05;

/// Settling took up to twelve passes of `40 sqrt(R/g)` beyond the time asked for. Now all passes share the time.
#[test]
fn settling_takes_no_longer_than_asked_for() {
    let mut case = Case::new(1e-3).tolerance(1e-6).contact(0.3, 0.0).floor();
    for k in 0..3 {
        let x = Vec3::new(0.01 * f64::from(k), 0.0, R * f64::from(2 * k + 1));
        case = case.sphere(R, x, Vec3::zeros(), Vec3::zeros());
    }
    for time in [0.005, 0.05] {
        let settle = Settle {
            time,
            until_rest: false,
        };
        let settled =
            Settled::new(&case.scene(), settle, |_| ControlFlow::Continue(())).expect("it settles");
        assert!(
            settled.time <= time * (1.0 + 1e-9),
            "{} of {time} s",
            settled.time
        );
    }
}

/// A ball that slides on a tilted plane presses with `m g cos`, at t = 0 too, where gravity is set from outside. Cause:
/// `Assembly::resting` scales the speed of what rests by the gravity of the scene, here none, so that rounding of `n . u`
/// drops the contact.
#[test]
fn forces_at_the_start_are_of_the_gravity_in_force() {
    for tilt in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6_f64] {
        let n = Vec3::new(tilt.sin(), 0.0, tilt.cos());
        let along = Vec3::new(tilt.cos(), 0.0, -tilt.sin());
        let scene = Case::new(1e-3)
            .gravity(Vec3::zeros())
            .plane(Vec3::zeros(), n);
        let mut run = scene.sphere(R, n * R, along * 0.7, Vec3::zeros()).start();
        run.simulation.set_gravity(Vec3::z() * -G).expect("gravity");
        run.simulation.place().expect("a start");
        let force = -run.simulation.wrench(0).force.dot(&n);
        let expected = run.mass(0) * G * tilt.cos();
        assert!(
            (force / expected - 1.0).abs() < 1e-6,
            "tilt {tilt}: {force} of {expected} N"
        );
    }
}

/// The same where a point load presses and there is no gravity.
#[test]
fn forces_at_the_start_are_of_the_loads_too() {
    for tilt in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6_f64] {
        let n = Vec3::new(tilt.sin(), 0.0, tilt.cos());
        let along = Vec3::new(tilt.cos(), 0.0, -tilt.sin());
        let case = Case::new(1e-3)
            .gravity(Vec3::zeros())
            .plane(Vec3::zeros(), n);
        let load = "[[load]]\nsphere = \"s0\"\nforce = [0.0, 0.0, -5.0]\n";
        let run = case
            .sphere(R, n * R, along * 0.7, Vec3::zeros())
            .table(load)
            .start();
        let force = -run.simulation.wrench(0).force.dot(&n);
        let expected = 5.0 * tilt.cos();
        assert!(
            (force / expected - 1.0).abs() < 1e-6,
            "tilt {tilt}: {force} of {expected} N"
        );
    }
}

fn falling() -> (Scene, Simulation) {
    let scene = Case::new(1e-2)
        .sphere(R, Vec3::zeros(), Vec3::zeros(), Vec3::zeros())
        .scene();
    let mut simulation = Simulation::new(Arc::new(scene.clone())).expect("a start");
    for _ in 0..10 {
        simulation.advance(1e-2).expect("a step");
    }
    (scene, simulation)
}

/// A scene that starts from a snapshot in free fall starts with `v = -g t`. Cause: `Scene::start_from` takes the velocities of
/// the half step before, off by `g dt/2`, for those at the start.
#[test]
fn a_start_from_a_snapshot_has_its_velocities() {
    let (mut scene, before) = falling();
    scene
        .start_from(&before.snapshot())
        .expect("its own snapshot");
    let run = Run {
        simulation: Simulation::new(Arc::new(scene)).expect("a start"),
    };
    let (found, expected) = (run.velocity(0).z, before.velocity(0).linear.z);
    assert!((expected + G * 0.1).abs() < 1e-12);
    assert!(
        (found - expected).abs() < 1e-12,
        "{found}, expected {expected} m/s"
    );
}

/// Spheres are taken from a snapshot of any scene if their numbers agree; `check` panicked where velocities were missing.
#[test]
fn spheres_of_a_snapshot_are_checked_for_their_lengths() {
    let case = Case::new(1e-3).floor();
    let run = case
        .sphere(R, Vec3::z() * R, Vec3::zeros(), Vec3::zeros())
        .start();
    let scene = run.simulation.scene();
    let state = run.simulation.state();
    let blob = |change: fn(&mut State)| {
        let mut state = state.clone();
        change(&mut state);
        let radius = &scene.particles.radius;
        snapshot::take(&scene.hash, radius, &state.kinematics, &state)
    };
    assert!(snapshot::spheres(&blob(|_| ())).is_ok());
    let changes: [fn(&mut State); 4] = [
        |s| s.kinematics.velocity.clear(),
        |s| s.kinematics.spin.clear(),
        |s| s.kinematics.orientation.clear(),
        |s| s.kinematics.present.push(true),
    ];
    for change in changes {
        assert!(snapshot::spheres(&blob(change)).is_err());
    }
}

/// A snapshot with a fitting checksum whose numbers of things do not fit the scene is refused, and never a panic later.
/// Cause: `Simulation::check_counts` looks at three of some twenty lengths.
#[test]
fn a_snapshot_is_checked_for_all_its_lengths() {
    let load = "[[spring]]\nsphere = \"s0\"\nstiffness = 10.0\n";
    let case = Case::new(1e-3)
        .floor()
        .sphere(R, Vec3::z() * R, Vec3::zeros(), Vec3::zeros());
    let mut simulation = case.table(load).start().simulation;
    simulation.advance(1e-3).expect("a step");
    type Change = (&'static str, fn(&mut State));
    let changes: [Change; 16] = [
        ("smooth", |s| s.smooth.clear()),
        ("velocity", |s| s.kinematics.velocity.clear()),
        ("spin", |s| s.kinematics.spin.clear()),
        ("orientation", |s| s.kinematics.orientation.clear()),
        ("present", |s| s.kinematics.present.clear()),
        ("springs", |s| s.springs.clear()),
        ("twists", |s| s.twists.clear()),
        ("commands", |s| s.commands.clear()),
        ("wrenches", |s| s.wrenches.clear()),
        ("smooth_wrenches", |s| s.smooth_wrenches.clear()),
        ("mean_wrenches", |s| s.mean_wrenches.clear()),
        ("owed", |s| s.owed.clear()),
        ("reserves", |s| s.reserves.push(Default::default())),
        ("emitted", |s| s.emitted.push(0.0)),
        ("removed", |s| s.removed.push(0.0)),
        ("passed", |s| s.passed.push(0.0)),
    ];
    let mut taken = Vec::new();
    for (name, change) in changes {
        let mut state = simulation.state().clone();
        change(&mut state);
        let radius = &simulation.scene().particles.radius;
        let blob = snapshot::take(&simulation.scene().hash, radius, &state.kinematics, &state);
        let mut other = Simulation::new(Arc::clone(simulation.scene())).expect("a start");
        if other.restore(&blob).is_ok() {
            taken.push(name);
        }
    }
    assert!(taken.is_empty(), "restored with wrong lengths of {taken:?}");
}

/// A plane that turns by a right angle in a step about a point far from the ball sweeps it with hundreds of its radii a step:
/// such a command is refused, as a translation by as much is. Cause: `check_jump` judges a boundary without bounds by its
/// reference point alone.
#[test]
fn a_plane_that_turns_by_a_right_angle_is_refused() {
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    for angle in [FRAC_PI_2, -FRAC_PI_2] {
        let case = Case::new(1e-3).boundary(face, "input = \"pose\"");
        let mut run = case
            .sphere(R, Vec3::new(5.0, 0.0, 0.5), Vec3::zeros(), Vec3::zeros())
            .start();
        let command = Command {
            rotation: Vec3::y() * angle,
            ..Command::default()
        };
        run.simulation.command(0, command).expect("a command");
        let taken = run.simulation.advance(1e-3);
        assert!(
            taken.is_err(),
            "turned by {angle}, the ball is at {:?}",
            run.position(0)
        );
    }
}

/// How exactly a stop holds does not depend on a grain elsewhere. Cause: the row of a stop has the radius of the scene's
/// smallest sphere, over which its gap is judged.
#[test]
fn a_stop_is_as_exact_with_a_grain_elsewhere() {
    let radius = |grain: bool| {
        let face =
            "rectangle = { corner = [0.0, 0.0, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }";
        let body =
            "body = { mass = 10.0, joint = { slide = [0.0, 0.0, 1.0] }, limits = { lower = 0.0 } }";
        let case = Case::new(1e-3).boundary(face, body);
        let mut case = case.sphere(R, Vec3::new(0.5, 0.5, R), Vec3::zeros(), Vec3::zeros());
        if grain {
            case = case.sphere(1e-4, Vec3::x() * -3.0, Vec3::zeros(), Vec3::zeros());
        }
        let mut simulation = case.start().simulation;
        simulation.advance(1e-3).expect("a step");
        let (problem, _) = simulation.problem(1e-3).expect("a problem");
        problem
            .rows
            .iter()
            .last()
            .expect("the row of the stop")
            .radius
    };
    let [without, with] = [false, true].map(radius);
    assert!(
        (with / without - 1.0).abs() < 1e-12,
        "{without} m, with a grain {with} m"
    );
}
