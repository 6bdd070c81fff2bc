//! Rows 11, 12 and 13: sliding becomes rolling, spin becomes speed, rolling to and fro in a trough and in a bowl.

use std::f64::consts::TAU;

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Revolution, Shape};

use crate::support::{Case, G, close, grid};

const RADIUS: f64 = 0.1;

/// Row 11: a sphere set down with speed v0 and no spin. Friction `mu m g` slows the centre and spins it up:
///
/// ```text
/// v = v0 - mu g t,  R w = 5/2 mu g t;  they meet at t_s = 2 v0/(7 mu g), x_s = v0 t_s - mu g t_s^2/2 = 12 v0^2/(49 mu g)
/// ```
/// and it rolls on with `v_f = 5/7 v0`.
#[test]
fn sliding_becomes_rolling() {
    let (mu, v0, dt) = (0.2, 2.0, 1e-4);
    for direction in [0.0f64, 25.0, 90.0, 200.0] {
        let along = Vec3::new(
            direction.to_radians().cos(),
            direction.to_radians().sin(),
            0.0,
        );
        let mut run = Case::new(dt, mu, 0.0)
            .tolerance(1e-6, 1e-8, 1e-8)
            .floor()
            .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS), along * v0)
            .start();
        let slip = |run: &crate::support::Run| {
            run.velocity(0) + run.spin(0).cross(&Vec3::new(0.0, 0.0, -RADIUS))
        };
        while slip(&run).norm() > 1e-6 {
            run.step();
        }
        let (time, place) = (2.0 * v0 / (7.0 * mu * G), 12.0 * v0 * v0 / (49.0 * mu * G));
        close(time, 0.291248, 2e-6, 0.0);
        close(place, 0.499282, 2e-6, 0.0);
        close(run.simulation.time(), time, 1e-3, 0.0);
        close(run.position(0).dot(&along), place, 1e-3, 0.0);
        run.steps(500);
        close(run.velocity(0).dot(&along), 5.0 / 7.0 * v0, 1e-6, 0.0);
        assert!(slip(&run).norm() < 1e-6);
    }
}

/// Row 12: dropped with spin w0 about a horizontal axis. The contact's force passes through the contact point, so
/// `I w + m R v` (about the line of contact points) keeps its value `I w0` through every bounce; rolling in the end,
/// `v = R w`, it is `7/5 m R v`: `v_f = 2/7 R w0`.
#[test]
fn spin_becomes_speed_however_many_bounces() {
    for (restitution, mu) in [(0.0, 0.3), (0.5, 0.05), (0.8, 0.1), (0.8, 1.0)] {
        let spin = 30.0;
        let mut run = Case::new(1e-3, mu, restitution)
            .tolerance(1e-10, 1e-10, 1e-10)
            .floor()
            .body(
                RADIUS,
                Vec3::new(0.0, 0.0, RADIUS + 0.3),
                Vec3::zeros(),
                Vec3::new(0.0, spin, 0.0),
                Default::default(),
            )
            .start();
        run.steps(4000);
        close(run.velocity(0).x, 2.0 / 7.0 * RADIUS * spin, 1e-9, 0.0);
        close(run.spin(0).y, 2.0 / 7.0 * spin, 1e-9, 0.0);
        close(run.velocity(0).norm(), 2.0 / 7.0 * RADIUS * spin, 1e-9, 0.0);
    }
}

/// Radius of the sphere in trough and bowl \[m\].
const SMALL: f64 = 0.01;
/// Inner radius of trough and bowl \[m\].
const HOLLOW: f64 = 1.0;
/// Angle of a facet \[rad\]: twenty-five of them from the lowest point to the turning point.
const FACET: f64 = 8e-4;
/// Facets on either side of the lowest point.
const HALF: u32 = 29;

/// Row 13: a sphere that rolls at the bottom of a trough of radius R_b, its centre on a circle of radius
/// `L = R_b - R`. With `v = L th'` and `R w = v` the energy is `7/10 m v^2 + m g L (1 - cos th)`: a pendulum of
/// `T = 2 pi sqrt(7 L/(5 g))` (amplitude .02 rad: longer by `th^2/16 = 2.5e-5`). A facet of `d` rad turns the path by d
/// at each joint and takes `d^2` of the energy there.
#[test]
fn rolls_to_and_fro_in_a_trough_and_in_a_bowl() {
    let axis = Vec3::new(0.0, 1.0, 0.0);
    let centre = Vec3::new(0.0, 0.0, HOLLOW);
    let trough: Shape = Revolution::cylinder(centre - axis, axis, HOLLOW, 2.0)
        .expect("a trough")
        .into();
    // The facets touch the circle from outside in their middles, so that the sphere starts on it.
    let on_circle = |k: u32| (f64::from(k) - f64::from(HALF) - 0.5) * FACET;
    let outer = HOLLOW / (0.5 * FACET).cos();
    let prism: Facets = grid(2 * HALF + 1, 1, |i, j| {
        let angle = on_circle(i);
        centre
            + Vec3::new(
                outer * angle.sin(),
                0.6 * f64::from(j) - 0.3,
                -outer * angle.cos(),
            )
    });
    // A patch of a sphere, square in two angles.
    let bowl: Facets = grid(2 * HALF + 1, 2 * HALF + 1, |i, j| {
        let (a, b) = (on_circle(i), on_circle(j));
        centre + Vec3::new(a.tan(), b.tan(), -1.0).normalize() * outer
    });
    let length = HOLLOW - SMALL;
    let period = TAU * (7.0 * length / (5.0 * G)).sqrt();
    for (name, shape, direction, tolerance) in [
        ("trough", trough, 0.0f64, 1e-3),
        ("prism", prism.into(), 0.0, 1e-3),
        ("bowl", bowl.clone().into(), 0.0, 1e-3),
        ("bowl, slanting", bowl.into(), 33.0, 1e-3),
    ] {
        let along = Vec3::new(
            direction.to_radians().cos(),
            direction.to_radians().sin(),
            0.0,
        );
        let start = 0.02f64;
        let mut run = Case::new(1e-3, 0.5, 0.0)
            .wall(vec![shape])
            .sphere(
                SMALL,
                centre + (along * start.sin() - Vec3::z() * start.cos()) * length,
                Vec3::zeros(),
            )
            .start();
        let mut crossings = Vec::new();
        let mut before = run.position(0).dot(&along);
        while crossings.len() < 3 {
            run.step();
            let now = run.position(0).dot(&along);
            if before * now <= 0.0 {
                crossings.push(run.simulation.time() - 1e-3 * now / (now - before));
            }
            before = now;
            assert!(run.simulation.time() < 2.0 * period, "{name}");
        }
        let found = crossings[2] - crossings[0];
        let error = (found / period - 1.0).abs();
        assert!(
            error <= tolerance,
            "{name}: period {found}, expected {period}, error {error:e}"
        );
    }
}
