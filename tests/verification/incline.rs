//! Rows 4 and 5: a sphere on an incline.
//!
//! ```text
//!        o          m a = m g sin a - F        rolls: a = R dw/dt, so F = 2/7 m g sin a, a = 5/7 g sin a
//!       /           I dw/dt = F R              slips: F = mu m g cos a, a = g (sin a - mu cos a),
//!      / a          I = 2/5 m R^2                     R dw/dt = 5/2 mu g cos a
//! ```
//! It rolls iff `2/7 sin a <= mu cos a`, that is `tan a <= 3.5 mu`.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Geometry, HeightField};
use sphere_dda::scene::particles::Locks;

use crate::support::{Case, G, Run, close};

const RADIUS: f64 = 0.1;

fn on_incline(angle: f64, friction: f64, locks: Locks) -> (Run, Vec3) {
    let normal = Vec3::new(angle.sin(), 0.0, angle.cos());
    let down = Vec3::new(angle.cos(), 0.0, -angle.sin());
    let run = Case::new(1e-3, friction, 0.0)
        .tolerance(1e-6, 1e-8, 1e-8)
        .plane(Vec3::zeros(), normal)
        .body(RADIUS, normal * RADIUS, Vec3::zeros(), Vec3::zeros(), locks)
        .start();
    (run, down)
}

/// Row 4, both regimes: acceleration and friction force over one second.
#[test]
fn rolls_or_slips() {
    let angle = 30f64.to_radians();
    for (friction, acceleration, spin_rate) in
        [(0.5, 3.503571, 3.503571), (0.1, 4.055430, 2.123927)]
    {
        let rolling = friction == 0.5;
        let exact = if rolling {
            5.0 / 7.0 * G * angle.sin()
        } else {
            G * (angle.sin() - friction * angle.cos())
        };
        let exact_spin = if rolling {
            exact
        } else {
            2.5 * friction * G * angle.cos()
        };
        close(exact, acceleration, 1e-6, 0.0);
        close(exact_spin, spin_rate, 1e-6, 0.0);
        let force = if rolling {
            2.0 / 7.0 * G * angle.sin()
        } else {
            friction * G * angle.cos()
        };
        let (mut run, down) = on_incline(angle, friction, Locks::default());
        for _ in 0..1000 {
            run.step();
            let t = run.simulation.time();
            close(run.velocity(0).dot(&down), exact * t, 1e-6, 1e-3 * exact);
            close(
                run.spin(0).y * RADIUS,
                exact_spin * t,
                1e-6,
                1e-3 * exact_spin,
            );
            close(
                run.force_on_boundary(0).dot(&down),
                run.mass(0) * force,
                1e-6,
                0.0,
            );
        }
        let travelled =
            (run.position(0) - Vec3::new(angle.sin(), 0.0, angle.cos()) * RADIUS).dot(&down);
        close(travelled, 0.5 * exact, 1e-6, 0.0);
    }
}

/// Row 4: the threshold friction `tan a / 3.5 = 0.164957` at 30 degrees is bracketed within one percent.
#[test]
fn rolling_threshold() {
    let angle = 30f64.to_radians();
    let threshold = angle.tan() / 3.5;
    close(threshold, 0.164957, 1e-5, 0.0);
    for (factor, rolls) in [(0.99, false), (1.01, true)] {
        let (mut run, down) = on_incline(angle, threshold * factor, Locks::default());
        run.steps(500);
        let slip = run.velocity(0).dot(&down) - run.spin(0).y * RADIUS;
        assert_eq!(
            slip.abs() < 1e-7,
            rolls,
            "slip {slip:e} at {factor} of the threshold"
        );
    }
}

/// Row 5: a block-like sphere (rotations locked) slips iff `tan a > mu`, `s = g (sin a - mu cos a) t^2/2`.
#[test]
fn locked_rotations_slide_like_a_block() {
    let angle = 20f64.to_radians();
    let (mut run, down) = on_incline(angle, 1.01 * angle.tan(), Locks::ROTATIONS);
    run.steps(1000);
    assert!(run.velocity(0).norm() < 1e-7, "it sticks");

    let friction = 0.2;
    let acceleration: f64 = G * (angle.sin() - friction * angle.cos());
    let (mut run, down_slope) = on_incline(angle, friction, Locks::ROTATIONS);
    assert_eq!(down, down_slope);
    let start = run.position(0);
    for distance in [25.0, 250.0] {
        let t = (2.0 * distance / acceleration).sqrt();
        while run.simulation.time() < t {
            run.step();
        }
        let t = run.simulation.time();
        let travelled = (run.position(0) - start).dot(&down);
        close(travelled, 0.5 * acceleration * t * t, 1e-4, 0.0);
        assert_eq!(run.spin(0), Vec3::zeros());
    }
}

/// Row 4 on a height field: a plane grid of 2 x 60 squares is the plane, so the sphere crosses its joints, and runs
/// along those in the middle, without its velocity or spin noticing.
#[test]
fn rolls_over_a_plane_grid_without_noticing_the_joints() {
    let angle = 30f64.to_radians();
    let (mut plane, _) = on_incline(angle, 0.5, Locks::default());
    let mut grid = "ncols 61\nnrows 3\nxllcenter -1\nyllcenter -0.1\ncellsize 0.1\n".to_owned();
    let heights: Vec<String> = (0..61)
        .map(|i| (-angle.tan() * (0.1 * f64::from(i) - 1.0)).to_string())
        .collect();
    grid += &(heights.join(" ") + "\n").repeat(3);
    let field = HeightField::esri_ascii(grid.as_bytes()).expect("a grid");
    let facets = field.facets("grid", [1.0; 3], Vec3::zeros());
    let mut scene = plane.simulation.scene().as_ref().clone();
    scene.boundaries[0].geometry = Geometry::new(vec![facets.into()]).expect("a geometry");
    let mut terrain = Case { scene }.start();
    for _ in 0..1200 {
        plane.step();
        terrain.step();
        let slower = (plane.velocity(0) - terrain.velocity(0)).norm();
        let turned = (plane.spin(0) - terrain.spin(0)).norm() * RADIUS;
        assert!(slower < 1e-9 && turned < 1e-9, "{slower:e} {turned:e} m/s");
    }
    assert!(terrain.position(0).x > 2.0, "it crossed twenty joints");
}
