//! Rest and lasting contact: no chatter at any step size, no false bounce in a loop or on a shaken wall.

use std::f64::consts::TAU;

use sphere_dda::Vec3;
use sphere_dda::geometry::{HalfSpace, Revolution};
use sphere_dda::scene::Motion;

use crate::support::{Case, G, close};

const RADIUS: f64 = 0.1;

/// At rest the force of a floor is m g in every step, whatever the step and the restitution: a sphere, and three in a
/// stack, stay where they are and carry their loads.
#[test]
fn resting_contacts_do_not_chatter_at_any_step() {
    for dt in [1e-5, 1e-4, 1e-3, 1e-2, 1e-1] {
        for restitution in [0.0, 0.8, 1.0] {
            let mut case = Case::new(dt, 0.3, restitution)
                .tolerance(1e-9, 1e-9, 1e-10)
                .floor();
            for k in 0..3 {
                let z = RADIUS * f64::from(2 * k + 1);
                case = case.sphere(RADIUS, Vec3::new(0.0, 0.0, z), Vec3::zeros());
            }
            let mut run = case.start();
            for _ in 0..200 {
                run.step();
                let weight = run.mass(0) * G;
                for contact in run.simulation.contacts() {
                    let above = 3.0 - (contact.point.z / (2.0 * RADIUS)).round();
                    let force = contact.force.dot(&contact.normal);
                    close(force, above * weight, 1e-6, 0.0);
                }
                for k in 0..3 {
                    let speed = run.velocity(k).norm();
                    assert!(speed < 1e-6 * G * dt, "{speed:e} m/s at dt = {dt} s");
                    close(run.position(k).z, RADIUS * (2 * k + 1) as f64, 1e-8, 0.0);
                }
            }
        }
    }
}

/// Dropped from h with e = 0.5 it bounces, and then lies still: the speed below which it does not bounce any more follows
/// the step (2 g dt), so that the last bounces are no endless chatter.
#[test]
fn bounces_end_in_rest_at_any_step() {
    for (dt, steps) in [(1e-4, 20000), (1e-3, 2000), (1e-2, 300), (1e-1, 60)] {
        let drop = if dt < 0.05 { 0.2 } else { 2.0 };
        let mut run = Case::new(dt, 0.3, 0.5)
            .floor()
            .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS + drop), Vec3::zeros())
            .start();
        run.steps(steps);
        for _ in 0..20 {
            run.step();
            close(run.normal_force(), run.mass(0) * G, 1e-6, 0.0);
            assert!(
                run.velocity(0).norm() < 1e-6 * G * dt,
                "dt = {dt}: {:?}",
                run.velocity(0)
            );
            close(run.position(0).z, RADIUS, 2e-6, 0.0);
        }
    }
}

/// A frictionless sphere runs round a loop, its centre on a circle of radius L, with `v^2 = 5 g L` at the top: the wall
/// presses with `m (v^2/L + g cos th)`, th from the lowest point, never less than `4 m g`. Within a step the path turns away
/// from its tangent by `v^2 dt/L`: an approach, but no impact, although e = .8.
#[test]
fn a_loop_at_five_g_is_no_string_of_bounces() {
    let (hollow, axis) = (1.0, Vec3::new(0.0, 1.0, 0.0));
    let length = hollow - RADIUS;
    let speed = |th: f64| (5.0 * G * length + 2.0 * G * length * (1.0 + th.cos())).sqrt();
    for restitution in [0.0, 0.8] {
        let mut run = Case::new(1e-3, 0.0, restitution)
            .wall(vec![
                Revolution::cylinder(-axis, axis, hollow, 2.0)
                    .expect("a loop")
                    .into(),
            ])
            .sphere(RADIUS, Vec3::new(0.0, 0.0, -length), Vec3::x() * speed(0.0))
            .start();
        let (mut turns, mut before) = (0, 0.0);
        while turns < 3 {
            run.step();
            let x = run.position(0);
            let th = x.x.atan2(-x.z);
            turns += i32::from(before < 0.0 && th >= 0.0);
            before = th;
            close(run.velocity(0).norm(), speed(th), 2e-3, 0.0);
            let press = run.mass(0) * (speed(th).powi(2) / length + G * th.cos());
            close(run.normal_force(), press, 2e-2, 0.0);
            close(x.norm(), length, 1e-6 * RADIUS / length, 0.0);
        }
    }
}

/// A floor shaken by `A (1 - cos w t)`, `A w^2 = 4 g`: it presses the sphere with `m (g + 4 g cos w t)` until
/// `cos w t = -1/4`, throws it with `A w sin w t`, and meets it again where the parabola cuts the cosine; only there it bounces,
/// with .8 of the speed of approach.
#[test]
fn a_wall_shaken_at_four_g_throws_once_and_bounces_once() {
    let (frequency, e) = (20.0, 0.8);
    let w = TAU * frequency;
    let amplitude = 4.0 * G / (w * w);
    let floor = |t: f64| {
        (
            amplitude * (1.0 - (w * t).cos()),
            amplitude * w * (w * t).sin(),
        )
    };
    let thrown = (-0.25f64).acos() / w;
    let flight = |t: f64| {
        let ((z, v), s) = (floor(thrown), t - thrown);
        (z + v * s - 0.5 * G * s * s, v - G * s)
    };
    // First meeting after the throw, by bisection.
    let (mut low, mut high) = (thrown + 1e-3, thrown + 1e-3);
    while flight(high).0 > floor(high).0 {
        high += 1e-4;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if flight(middle).0 > floor(middle).0 {
            low = middle
        } else {
            high = middle
        }
    }
    let meets = low;
    let approach = flight(meets).1 - floor(meets).1;
    assert!(
        meets - thrown > 0.01 && approach < -0.3,
        "a real throw: {meets} {approach}"
    );

    let dt = 2e-5;
    let motion = Motion::Sinusoid {
        translation: Vec3::z() * amplitude,
        rotation: Vec3::zeros(),
        frequency,
        phase: -0.25 * TAU,
    };
    let plane = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
    let mut run = Case::new(dt, 0.0, e)
        .moving(vec![plane.into()], motion)
        .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS), Vec3::zeros())
        .start();
    let (mut landed, mut left) = (None, None);
    while run.simulation.time() < meets + 20.0 * dt {
        let start = run.simulation.time();
        run.step();
        let force = run.normal_force();
        let (end, middle) = (start + dt, start + 0.5 * dt);
        if start == 0.0 {
            // Half of the first step's acceleration of the floor is missing in the forces at rest.
            continue;
        } else if end < thrown - 2.0 * dt {
            let exact = run.mass(0) * (G + 4.0 * G * (w * middle).cos());
            close(force, exact, 2e-2, run.mass(0) * G);
            assert!(
                left.is_none() && force > 0.0,
                "it lies on the floor at {end}"
            );
        } else if force == 0.0 && left.is_none() {
            left = Some(end);
        } else if force > 0.0 && left.is_some() {
            landed.get_or_insert(end);
        }
    }
    close(left.expect("a throw"), thrown, 5e-3, 0.0);
    close(landed.expect("a landing"), meets, 5e-3, 0.0);
    let rebound = floor(meets).1 - e * approach;
    close(run.velocity(0).z + G * 10.0 * dt, rebound, 1e-2, 0.0);
}
