//! What falls into a groove: it rebounds by Newton's law, or friction locks it.

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;
use sphere_dda::geometry::HalfSpace;
use sphere_dda::scene::Motion;
use sphere_dda::scene::clump::ClumpShape;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, close};

const RADIUS: f64 = 0.1;
const STEP: f64 = 1e-3;
const RESTITUTION: f64 = 0.4;
const SPEED: f64 = 0.5;
/// Of the walls against the vertical: what touches both is locked where friction is more than its tangent, 0.268.
const HALF_ANGLE: f64 = 15.0;

/// A sphere that hits both walls of a groove in the first step at [`SPEED`] against it; or a rod of two, one at each wall, `tilt`ed so many
/// degrees. The groove moves with `velocity`.
fn falls(friction: f64, tilt: Option<f64>, velocity: Vec3) -> Run {
    let (across, up) = HALF_ANGLE.to_radians().sin_cos();
    let normals = [Vec3::new(up, 0.0, across), Vec3::new(-up, 0.0, across)];
    let walls = normals.map(|n| HalfSpace::new(Vec3::zeros(), n).expect("a plane").into());
    let motion = Motion::Constant(Twist {
        linear: velocity,
        angular: Vec3::zeros(),
    });
    let case = Case::new(STEP, friction, RESTITUTION)
        .tolerance(1e-9, 1e-9, 1e-9)
        .moving(walls.to_vec(), motion);
    let end = tilt.map_or(Vec3::zeros(), |tilt| {
        let (z, x) = tilt.to_radians().sin_cos();
        Vec3::new(x, 0.0, z) * (0.5 * RADIUS)
    });
    // Less than the gap that a step at this speed closes.
    let distance = RADIUS + 0.1 * SPEED * STEP;
    let place = Vec3::new(end.z * across / up, 0.0, (distance + end.x * up) / across);
    let falling = velocity - Vec3::z() * SPEED;
    match tilt {
        None => case.sphere(RADIUS, place, falling),
        Some(_) => {
            let rod = ClumpShape::new(&[-end, end], &[RADIUS; 2], 2500.0, None, None);
            let (rod, _) = rod.expect("a clump");
            let upright = (place, UnitQuaternion::identity());
            case.clump(&rod, upright, falling, Vec3::zeros())
        }
    }
    .start()
}

/// The line between the contacts is 15 degrees off both normals. With a friction of 0.2 it lies outside the cones, and what falls
/// parts by Newton's law: `v' = e v`. With 0.3 it lies within both, no forces part it from both walls, and it stops: `v' = 0`.
#[test]
fn a_groove_lets_rebound_what_friction_does_not_lock() {
    for tilt in [None, Some(0.0)] {
        let up = Vec3::new(0.2, 0.0, 0.3);
        for velocity in [Vec3::zeros(), up, -up] {
            for (friction, share) in [(0.2, RESTITUTION), (0.3, 0.0)] {
                let mut run = falls(friction, tilt, velocity);
                run.step();
                let report = run.simulation.report();
                assert_eq!((report.unconverged_steps, report.cuts), (0, 0));
                assert!(report.sweeps < 100, "{} sweeps", report.sweeps);
                let after = run.velocity(0) - velocity;
                let error = (after.z - share * SPEED).abs();
                assert!(error < G * STEP, "{after} with friction {friction}");
                assert!(after.xy().norm() < 1e-6, "{after}");
                assert!(run.spin(0).norm() < 1e-6, "{}", run.spin(0));
            }
        }
    }
}

/// A rod at 40 degrees touches with a line that is 28 degrees off one of the normals: it is not locked, and turns off its higher end.
#[test]
fn a_tilted_rod_is_not_locked() {
    let mut run = falls(0.3, Some(40.0), Vec3::zeros());
    run.step();
    assert_eq!(run.simulation.report().unconverged_steps, 0);
    assert!(run.spin(0).norm() > 0.1, "{}", run.spin(0));
}

/// A ball between two walls that it does not touch at once rebounds from one after the other.
#[test]
fn a_slot_wider_than_the_ball_lets_it_rebound() {
    let slack = 2.0 * RESTITUTION * SPEED * STEP;
    let walls = [Vec3::x(), -Vec3::x()].map(|n| {
        let point = -n * (RADIUS + 0.5 * slack);
        HalfSpace::new(point, n).expect("a plane").into()
    });
    let mut run = Case::new(STEP, 0.3, RESTITUTION)
        .without_gravity()
        .wall(walls.to_vec())
        .sphere(RADIUS, Vec3::zeros(), Vec3::x() * SPEED)
        .start();
    for share in [-RESTITUTION, RESTITUTION * RESTITUTION] {
        let before = run.velocity(0).x;
        while run.velocity(0).x == before {
            run.step();
        }
        close(run.velocity(0).x, share * SPEED, 1e-9, 0.0);
    }
}

/// What it has locked the groove carries.
#[test]
fn what_is_locked_stays() {
    for tilt in [None, Some(0.0)] {
        let mut run = falls(0.3, tilt, Vec3::zeros());
        let mut sweeps = 0;
        for _ in 0..100 {
            run.step();
            assert_eq!(run.simulation.report().unconverged_steps, 0);
            sweeps += run.simulation.report().sweeps;
        }
        assert!(sweeps < 100 * 20, "{sweeps} sweeps");
        assert!(run.velocity(0).norm() < 1e-6, "{}", run.velocity(0));
        let spheres = run.simulation.scene().particles.len();
        let weight: f64 = (0..spheres).map(|i| run.mass(i) * G).sum();
        close(-run.force_on_boundary(0).z, weight, 1e-6, 0.0);
    }
}
