//! Belts: boundaries whose surface runs along their shape at `V`.
//!
//! ```text
//!      o  w        m dv/dt = mu m g             v = mu g t
//!    ==>==>==>     I dw/dt = mu m g R           R w = 5/2 mu g t, backwards
//!        V         slip V - v - R w = 0   at    t_s = 2 V/(7 mu g), v = 2/7 V, R w = 5/7 V
//! ```
//! From there on it rolls on the spot it has reached in speed. The belt has then done `mu m g V t_s = 2/7 m V^2` of work, of
//! which `1/2 m v^2 + 1/2 I w^2 = 1/7 m V^2` is the sphere's and the other half is lost in friction.

use std::f64::consts::FRAC_PI_2;

use sphere_dda::Vec3;
use sphere_dda::scene::Belt;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Command, Motion};

use crate::support::{Case, G, close};

const RADIUS: f64 = 0.1;
const SPEED: f64 = 1.4;
const FRICTION: f64 = 0.3;

fn on_floor(locks: Locks) -> Case {
    let centre = Vec3::z() * RADIUS;
    Case::new(1e-3, FRICTION, 0.0)
        .tolerance(1e-6, 1e-8, 1e-8)
        .floor()
        .body(RADIUS, centre, Vec3::zeros(), Vec3::zeros(), locks)
}

/// Acceleration while it slips, the force on the belt, the speed at which it rolls, and the ledger of work.
#[test]
fn a_sphere_on_a_belt_slips_then_rolls() {
    let mut run = on_floor(Locks::default()).belt(Vec3::x() * SPEED).start();
    let mass = run.mass(0);
    let sliding = 2.0 * SPEED / (7.0 * FRICTION * G);
    close(sliding, 0.135916, 1e-5, 0.0);
    for _ in 0..300 {
        run.step();
        let t = run.simulation.time();
        assert!((run.position(0).z - RADIUS).abs() < 1e-7);
        // Velocities are reported half a step ahead of those that the last force has made.
        if t < sliding - 1e-3 {
            close(run.velocity(0).x, FRICTION * G * t, 1e-9, 0.0);
            close(run.spin(0).y * RADIUS, -2.5 * FRICTION * G * t, 1e-9, 0.0);
            close(run.force_on_boundary(0).x, -mass * FRICTION * G, 1e-9, 0.0);
        } else if t > sliding + 2e-3 {
            close(run.velocity(0).x, 2.0 / 7.0 * SPEED, 1e-7, 0.0);
            close(run.spin(0).y * RADIUS, -5.0 / 7.0 * SPEED, 1e-7, 0.0);
            assert!(run.force_on_boundary(0).x.abs() < 1e-6 * mass * G);
        }
    }
    let work = run.simulation.work();
    // The steps' impulses also bring the first half-step velocity to zero: half a step more of friction on the belt.
    let half = 0.5 * 1e-3 * FRICTION * G;
    let given = mass * SPEED * (2.0 / 7.0 * SPEED + half);
    let gained = mass * SPEED * SPEED / 7.0;
    close(work.boundaries, given, 1e-7, 0.0);
    close(
        given - work.dissipated() + work.numerical_work,
        gained,
        1e-7,
        0.0,
    );
    // Half of what the belt gives is lost by slip, to the square of half a step's slip: (7/4 mu g dt/V)^2 = 1.4e-5 at most.
    close(work.dissipated(), gained, 1.4e-5, 0.0);
}

/// Without rotation it takes the belt's speed after `V/(mu g)`, and lies on it from then on.
#[test]
fn a_block_takes_the_speed_of_the_belt() {
    let mut run = on_floor(Locks::ROTATIONS).belt(Vec3::x() * SPEED).start();
    let sliding = SPEED / (FRICTION * G);
    run.steps((sliding / 1e-3) as usize);
    let t = run.simulation.time();
    close(run.velocity(0).x, FRICTION * G * t, 1e-9, 0.0);
    run.steps(200);
    close(run.velocity(0).x, SPEED, 1e-9, 0.0);
    // While it slipped the belt ran twice as far as the block.
    let t = run.simulation.time();
    close(run.position(0).x, SPEED * (t - 0.5 * sliding), 1e-5, 0.0);
}

/// Up a slope of angle `a` a belt carries a block iff `mu > tan a`; else the block slips down at
/// `g (sin a - mu cos a)`, as on a fixed slope.
#[test]
fn a_belt_carries_up_what_does_not_slip() {
    let angle = 20f64.to_radians();
    let normal = Vec3::new(-angle.sin(), 0.0, angle.cos());
    let up = Vec3::new(angle.cos(), 0.0, angle.sin());
    for (factor, carried) in [(1.02, true), (0.98, false)] {
        let friction = factor * angle.tan();
        let mut run = Case::new(1e-3, friction, 0.0)
            .tolerance(1e-6, 1e-8, 1e-8)
            .plane(Vec3::zeros(), normal)
            .belt(up * 0.05)
            .body(
                RADIUS,
                normal * RADIUS,
                Vec3::zeros(),
                Vec3::zeros(),
                Locks::ROTATIONS,
            )
            .start();
        run.steps(1000);
        let expected = if carried {
            0.05
        } else {
            G * (friction * angle.cos() - angle.sin())
        };
        close(run.velocity(0).dot(&up), expected, 1e-6, 0.0);
    }
}

/// The velocity is counted in the boundary's own axes, turned by a quarter here, and what of it stands on the
/// surface moves nothing.
#[test]
fn a_belt_turns_with_its_boundary_and_keeps_its_shape() {
    let mut case = on_floor(Locks::ROTATIONS).belt(Vec3::new(SPEED, 0.0, 5.0));
    case.scene.boundaries[0].motion = Motion::Table {
        time: vec![0.0],
        translation: vec![Vec3::zeros()],
        rotation: vec![Vec3::z() * FRAC_PI_2],
    };
    let mut run = case.start();
    for _ in 0..600 {
        run.step();
        assert!((run.position(0).z - RADIUS).abs() < 1e-7);
    }
    let error = (run.velocity(0) - Vec3::y() * SPEED).norm();
    assert!(error < 1e-9, "{:?}", run.velocity(0));
    // Only friction works: the belt does not lift.
    let half = 0.5 * 1e-3 * FRICTION * G;
    let given = run.mass(0) * SPEED * (SPEED + half);
    close(run.simulation.work().boundaries, given, 1e-6, 0.0);
}

/// A belt driven from outside starts with the scene's speed, takes every command at once, and its speed is part of the
/// state.
#[test]
fn a_driven_belt_is_commanded_and_saved() {
    let mut case = on_floor(Locks::ROTATIONS);
    case.scene.boundaries[0].belt = Some(Belt {
        velocity: Vec3::x() * SPEED,
        input: true,
    });
    let mut run = case.start();
    run.steps(600);
    close(run.velocity(0).x, SPEED, 1e-9, 0.0);
    let command = Command {
        surface_velocity: Vec3::y() * 0.1,
        ..Command::default()
    };
    run.simulation.command(0, command).unwrap();
    let saved = run.simulation.snapshot();
    let after = |run: &mut crate::support::Run| {
        run.steps(600);
        (run.velocity(0), run.simulation.snapshot())
    };
    let (velocity, first) = after(&mut run);
    assert!((velocity - Vec3::y() * 0.1).norm() < 1e-9, "{velocity:?}");
    run.simulation.restore(&saved).unwrap();
    assert!(after(&mut run).1 == first, "the command is in the state");
}
