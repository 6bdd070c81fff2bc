//! Fault 4. Symptom: a ball on the rim of a round hole, or in a cone whose outlet is smaller than it, is thrown out at many
//! metres a second with e = 0, or the step fails with "gap NaN". Cause: on a ring around the ball the closest point is that of
//! the centre's own azimuth (`Revolution::closest_points`) and jumps to the other side where the centre crosses the axis; only
//! pieces that face the centre get further points (`push_ribs`), corners none, and a point that is followed
//! (`corner_touch`, `face_touch`) jumps with the azimuth, so that re-linearisation does not end.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Geometry, Revolution};

use crate::support::{Case, G};

const R: f64 = 0.05;

/// A ball that falls into a ring never has more energy than at the start (e = 0: only losses), and ends on the axis at
/// `height`.
fn falls_into(face: &str, start: Vec3, height: f64, friction: f64, step: f64) {
    let case = Case::new(step).tolerance(1e-6).contact(friction, 0.0);
    let mut run = case
        .boundary(face, "")
        .sphere(R, start, Vec3::zeros(), Vec3::zeros())
        .start();
    let (mass, before) = (run.mass(0), run.total());
    while run.simulation.time() < 1.0 {
        run.step();
        let gain = (run.total() - before) / (mass * G * R);
        assert!(
            gain < 1e-3,
            "energy rises by {gain} m g R at {} s",
            run.simulation.time()
        );
    }
    let x = run.position(0);
    assert!(
        (x.z - height).abs() < 0.02 * R,
        "it ends at {x:?}, not at {height}"
    );
    assert!(x.xy().norm() < 0.05 * R, "it ends at {x:?}");
}

const RIM: &str = "cylinder = { base = [0.0, 0.0, -0.2], radius = 0.03, height = 0.2 }";
const CONE: &str = "cone = { base = [0.0, 0.0, 0.0], r0 = 0.02, r1 = 0.2, height = 0.18 }";

/// On the rim of radius a the centre rests at `sqrt(R^2 - a^2)` above it.
#[test]
fn a_ball_comes_to_rest_on_the_rim_of_a_hole() {
    for (friction, step) in [(0.3, 1e-3), (0.0, 1e-3), (0.3, 1e-4)] {
        falls_into(RIM, Vec3::new(1e-3, 0.0, 0.042), 0.04, friction, step);
    }
}

/// In a cone of 45 degrees with the outlet a the centre rests at `sqrt(2) R - a`.
#[test]
fn a_ball_comes_to_rest_in_a_cone_that_it_plugs() {
    let height = 2.0_f64.sqrt() * R - 0.02;
    falls_into(CONE, Vec3::new(2e-3, 0.0, height + 2e-3), height, 0.5, 1e-3);
}

/// Exactly on the axis.
#[test]
fn a_ball_on_the_axis_rests_in_a_cone_and_on_a_rim() {
    let height = 2.0_f64.sqrt() * R - 0.02;
    falls_into(CONE, Vec3::z() * (height + 1e-3), height, 0.5, 1e-3);
    falls_into(RIM, Vec3::z() * 0.041, 0.04, 0.5, 1e-3);
}

/// Contact along a circle: whatever the direction across the axis, a contact point pushes against it. The points of a ball that
/// touches the ring all round are therefore around the axis, no 180 degrees of which are empty.
#[test]
fn contact_points_of_a_ball_in_a_ring_hold_it_all_round() {
    let rim = Revolution::cylinder(-Vec3::z() * 0.2, Vec3::z(), 0.03, 0.2).expect("a pipe");
    let cone = Revolution::frustum(Vec3::zeros(), Vec3::z(), 0.02, 0.2, 0.18).expect("a cone");
    let height = 2.0_f64.sqrt() * R - 0.02;
    for (name, shape, z) in [("rim", rim, 0.04), ("cone", cone, height)] {
        let geometry = Geometry::new(vec![shape.into()]).expect("a geometry");
        for off in [0.0, 1e-12, 1e-6, 1e-4 * R] {
            let mut points = Vec::new();
            let centre = Vec3::new(off, 0.3 * off, z - 1e-6 * R);
            geometry.closest_points(centre, R, 0.01 * R, &mut points);
            for k in 0..36 {
                let angle = f64::from(k).to_radians() * 10.0;
                let towards = Vec3::new(angle.cos(), angle.sin(), 0.0);
                let holds = points.iter().any(|p| p.normal.dot(&towards) < -1e-3);
                assert!(
                    holds,
                    "{name} at {off:e}: {} points, none against {angle}",
                    points.len()
                );
            }
            assert!(
                points
                    .iter()
                    .all(|p| p.gap.is_finite() && p.normal.norm().is_finite())
            );
        }
    }
}

/// 75 balls of 20 mm over an outlet of 16 mm: the first one plugs it, the others come to rest above; every step converges and
/// no energy is made.
#[test]
fn a_hopper_is_plugged_and_stays_so() {
    let case = Case::new(1e-3).tolerance(1e-4).contact(0.3, 0.0).spheres(
        "radius = 0.01\nseed = 1\nlattice = { origin = [-0.05, -0.05, 0.1], count = [5, 5, 3], spacing = 0.025, jitter = 0.05 }",
    );
    let cone = "cone = { base = [0.0, 0.0, 0.0], r0 = 0.008, r1 = 0.2, height = 0.192 }";
    let mut run = case.boundary(cone, "").start();
    let (before, mass) = (run.total(), run.mass(0));
    while run.simulation.time() < 1.0 {
        run.step();
        let gain = (run.total() - before) / (mass * G * 0.01);
        assert!(
            gain < 1e-2,
            "energy rises by {gain} m g R at {} s",
            run.simulation.time()
        );
    }
    let through = (0..75).filter(|&i| run.position(i).z < 0.0).count();
    assert_eq!(through, 0);
}
