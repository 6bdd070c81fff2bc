//! Balls that roll on a floor which turns about the vertical at `W`.
//!
//! ```text
//!   m dv/dt = F,   I dw/dt = -R z x F        rolls:  v - R w x z = W x r
//!   dv/dt = 2/7 W x v                        so v turns at 2/7 W, wherever the ball is
//! ```
//! Every ball meets the floor with another velocity: the row of a contact that goes to another one is seen.

use nalgebra::Rotation3;
use sphere_dda::Vec3;
use sphere_dda::geometry::HalfSpace;
use sphere_dda::scene::Motion;
use sphere_dda::spatial::Twist;

use crate::support::Case;

const STEP: f64 = 1e-3;
const RADIUS: f64 = 0.01;
/// \[rad/s\]
const SPEED: f64 = 2.0;
/// Balls along an edge of the lattice: three pieces of contacts.
const SIDE: usize = 35;

#[test]
fn velocities_of_many_balls_turn_at_two_sevenths() {
    let turning = Vec3::z() * SPEED;
    let floor = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
    let motion = Motion::Constant(Twist {
        linear: Vec3::zeros(),
        angular: turning,
    });
    let mut case = Case::new(STEP, 0.5, 0.0)
        .tolerance(1e-6, 1e-6, 1e-6)
        .moving(vec![floor.into()], motion);
    let places: Vec<Vec3> = (0..SIDE * SIDE)
        .map(|k| {
            let along = |k: usize| 0.025 * (k as f64 - 0.5 * (SIDE - 1) as f64);
            Vec3::new(along(k % SIDE), along(k / SIDE), RADIUS)
        })
        .collect();
    for &place in &places {
        case = case.sphere(RADIUS, place, turning.cross(&place));
    }
    let mut run = case.start();
    run.steps(100);
    let angle = 2.0 / 7.0 * SPEED * run.simulation.time();
    let turned = Rotation3::from_axis_angle(&Vec3::z_axis(), angle);
    for (k, place) in places.iter().enumerate() {
        let (found, expected) = (run.velocity(k), turned * turning.cross(place));
        // The scheme is half a step behind.
        let late = 0.5 * STEP * SPEED * expected.norm();
        assert!(
            (found - expected).norm() < late + 1e-5,
            "ball {k}: {found} {expected}"
        );
        assert!((run.position(k).z - RADIUS).abs() < 1e-6 * RADIUS);
    }
}
