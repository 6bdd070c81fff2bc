//! Fault 7. Symptom: the path of a ball depends on what collides 5 m away, and on the angle by which a scene is turned.
//! Cause: one step length for the whole scene, so that a cut elsewhere moves the time at which a ball is caught by up to a
//! step; `contact_row` judges an impact by thresholds (`approach < -threshold`, `excess + dt u_free < 0`) that rounding decides
//! where a scene stands on them.

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;

use crate::support::Case;

const R: f64 = 0.05;

/// A ball dropped on a floor with e = 0.5, and two others that collide and fall 5 m away: the same path with and without them.
#[test]
fn a_path_does_not_depend_on_what_happens_far_away() {
    let run = |others: bool| {
        let mut case = Case::new(2e-3).contact(0.3, 0.5).floor();
        let aside = Vec3::new(0.3, 0.0, 0.0);
        case = case.sphere(R, Vec3::z() * 0.2, aside, Vec3::zeros());
        if others {
            for side in [-1.0, 1.0] {
                let x = Vec3::new(5.0 + 0.3 * side, 0.013 * side, 0.4);
                case = case.sphere(R, x, Vec3::x() * (-300.0 * side), Vec3::zeros());
            }
        }
        let mut run = case.start();
        let mut path = Vec::new();
        for _ in 0..250 {
            run.step();
            path.push(run.position(0));
        }
        path
    };
    let (alone, beside) = (run(false), run(true));
    let off = alone.iter().zip(&beside).map(|(a, b)| (a - b).norm());
    let off = off.fold(0.0, f64::max) / R;
    assert!(off < 1e-7, "{off:e} R");
}

/// A ball that rests on a threshold of impact: four balls dropped as a stack that is sheared, e = 0.3, turned by odd angles
/// about odd axes together with gravity and floor: the same places in the scene's own axes.
#[test]
fn a_scene_turned_by_an_odd_angle_gives_the_same_answer() {
    let run = |turn: UnitQuaternion<f64>| {
        let mut case = Case::new(1e-3)
            .tolerance(1e-12)
            .contact(0.3, 0.3)
            .gravity(turn * Vec3::z() * -9.81)
            .plane(Vec3::zeros(), turn * Vec3::z());
        for k in 0..4 {
            let k = f64::from(k);
            let x = Vec3::new(0.02 * k * R, 0.01 * k * R, R + 2.1 * k * R + 0.1 * R);
            case = case.sphere(R, turn * x, Vec3::zeros(), Vec3::zeros());
        }
        let mut run = case.start();
        run.steps(87);
        (0..4)
            .map(|i| turn.inverse() * run.position(i))
            .collect::<Vec<_>>()
    };
    let expected = run(UnitQuaternion::identity());
    for k in 1..7 {
        let k = f64::from(k);
        let turn = UnitQuaternion::from_scaled_axis(Vec3::new(0.3 * k, -0.7, 0.11 * k * k));
        let found = run(turn);
        for (a, b) in expected.iter().zip(&found) {
            let off = (a - b).norm() / R;
            assert!(off < 1e-6, "turn {k}: {off:e} R");
        }
    }
}

/// Balls in contact at t = 0 that start with velocities of approach at the very bound below which nothing rebounds, `2 a dt`:
/// of the two answers one comes out, whatever the angle.
#[test]
fn no_threshold_has_a_cliff_that_rounding_decides() {
    let dt = 1e-3;
    let run = |turn: UnitQuaternion<f64>| {
        let gravity = 9.81;
        let v = 2.0 * gravity * dt;
        let case = Case::new(dt)
            .tolerance(1e-12)
            .contact(0.0, 0.9)
            .gravity(turn * Vec3::z() * -gravity)
            .plane(Vec3::zeros(), turn * Vec3::z())
            .sphere(
                R,
                turn * Vec3::z() * R,
                turn * Vec3::z() * -v,
                Vec3::zeros(),
            );
        let mut run = case.start();
        run.steps(3);
        (turn.inverse() * run.velocity(0)).z
    };
    let mut found = Vec::new();
    for k in 0..24 {
        let k = f64::from(k);
        let turn = UnitQuaternion::from_scaled_axis(Vec3::new(0.13 * k, -0.07 * k, 0.11 * k));
        found.push(run(turn));
    }
    let low = found.iter().copied().fold(f64::INFINITY, f64::min);
    let high = found.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!(high - low < 1e-9, "from {low} to {high} m/s");
}
