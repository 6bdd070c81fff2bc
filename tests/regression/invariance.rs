//! Kinds of check: the same scene turned by an odd angle, moved, mirrored and at another scale gives the same answer without
//! dimensions; what rests does not drift; the ledger of energy closes.

use nalgebra::{Matrix3, Rotation3};
use sphere_dda::Vec3;

use crate::support::{Case, G};

/// A map of the scene: lengths by `scale`, then `turn` (a rotation, or one with a reflection), then `shift` in radii.
#[derive(Clone, Copy)]
struct View {
    scale: f64,
    turn: Matrix3<f64>,
    shift: Vec3,
}

const PLAIN: f64 = 0.05;

/// Five balls thrown at each other and into a corner of two planes, with friction, e = 0.4 and spin; no dimensions in the
/// answer: places over the radius after a time in `sqrt(R/g)`.
fn thrown(view: &View) -> Vec<Vec3> {
    let r = PLAIN * view.scale;
    // Times go with the root of lengths where gravity stays.
    let clock = view.scale.sqrt();
    let handed = view.turn.determinant().signum();
    let place = |x: Vec3| view.turn * x * r + view.shift * r;
    let mut case = Case::new(1e-3 * clock).tolerance(1e-10).contact(0.3, 0.4);
    case = case.gravity(view.turn * Vec3::z() * -G);
    case = case.plane(place(Vec3::zeros()), view.turn * Vec3::z());
    case = case.plane(
        place(Vec3::x() * -4.0),
        view.turn * Vec3::new(1.0, 0.1, 0.2).normalize(),
    );
    let speed = (G * r).sqrt();
    for k in 0..5 {
        let k = f64::from(k);
        let x = Vec3::new(2.3 * k - 2.0, 0.4 * (2.0 * k).sin(), 1.2 + 0.3 * k);
        let v = Vec3::new(-0.6 - 0.4 * k, 0.2 * k.cos(), -0.3 * k.sin()) * speed;
        let w = Vec3::new(k.sin(), k.cos(), 0.5) * (speed / r);
        // A spin is a pseudo vector.
        case = case.sphere(r, place(x), view.turn * v, view.turn * w * handed);
    }
    let mut run = case.start();
    run.steps(150);
    let back = view.turn.transpose();
    (0..5)
        .map(|i| back * (run.position(i) / r - view.shift))
        .collect()
}

fn same(view: View, bound: f64) {
    let plain = View {
        scale: 1.0,
        turn: Matrix3::identity(),
        shift: Vec3::zeros(),
    };
    let off = thrown(&plain)
        .iter()
        .zip(&thrown(&view))
        .map(|(a, b)| (a - b).norm())
        .fold(0.0, f64::max);
    assert!(off < bound, "{off:e} R");
}

fn turned() -> Matrix3<f64> {
    *Rotation3::from_scaled_axis(Vec3::new(0.7, -1.3, 0.4)).matrix()
}

#[test]
fn a_scene_turned_by_an_odd_angle() {
    same(
        View {
            scale: 1.0,
            turn: turned(),
            shift: Vec3::zeros(),
        },
        1e-6,
    );
}

#[test]
fn a_scene_moved_by_a_thousand_radii() {
    same(
        View {
            scale: 1.0,
            turn: Matrix3::identity(),
            shift: Vec3::new(600.0, -800.0, 30.0),
        },
        1e-6,
    );
}

#[test]
fn a_scene_mirrored() {
    let mirror = Matrix3::from_diagonal(&Vec3::new(1.0, -1.0, 1.0));
    same(
        View {
            scale: 1.0,
            turn: turned() * mirror,
            shift: Vec3::zeros(),
        },
        1e-6,
    );
}

/// Radii from a micrometre to ten metres.
#[test]
fn a_scene_of_any_size() {
    for r in [1e-6, 1e-3, 1.0, 10.0] {
        same(
            View {
                scale: r / PLAIN,
                turn: Matrix3::identity(),
                shift: Vec3::zeros(),
            },
            1e-6,
        );
    }
}

/// A pile of four at rest does not creep: 1e-6 R in `count` steps.
fn rests(count: usize) {
    let (r, d) = (PLAIN, 2.0 * PLAIN);
    let mut case = Case::new(1e-3).tolerance(1e-8).contact(0.6, 0.0).floor();
    let third = |k: f64| {
        Vec3::new(
            (2.094395102393195 * k).cos(),
            (2.094395102393195 * k).sin(),
            0.0,
        )
    };
    for k in 0..3 {
        let x = third(f64::from(k)) * (d / 3.0_f64.sqrt()) + Vec3::z() * r;
        case = case.sphere(r, x, Vec3::zeros(), Vec3::zeros());
    }
    let top = Vec3::z() * (r + d * (2.0_f64 / 3.0).sqrt());
    let mut run = case.sphere(r, top, Vec3::zeros(), Vec3::zeros()).start();
    let start: Vec<Vec3> = (0..4).map(|i| run.position(i)).collect();
    run.steps(count);
    for (i, from) in start.iter().enumerate() {
        let crept = (run.position(i) - from).norm() / r;
        assert!(crept < 1e-6, "sphere {i} has moved by {crept:e} R");
        assert!(run.velocity(i).norm() < 1e-8, "{:?} m/s", run.velocity(i));
    }
}

#[test]
fn a_pile_at_rest_does_not_drift() {
    rests(5_000);
}

#[test]
#[ignore = "takes minutes"]
fn a_pile_at_rest_does_not_drift_in_a_million_steps() {
    rests(1_000_000);
}

/// Kinetic and potential energy change by all that is booked, at every step, on contact springs too: the ledger closes to
/// rounding by its last account, the work of the scheme, and a bounce on a spring leaves that beneath 2 % of the energy.
#[test]
fn the_ledger_closes_with_compliant_contacts() {
    let face = "plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }";
    let case = Case::new(1e-5)
        .contact(0.4, 0.6)
        .boundary(face, "stiffness = 1e5");
    let mut run = case
        .sphere(
            PLAIN,
            Vec3::z() * (PLAIN + 1e-3),
            Vec3::new(0.5, 0.0, -1.0),
            Vec3::zeros(),
        )
        .start();
    let before = run.total();
    run.until(0.04);
    let work = *run.simulation.work();
    let balance = run.total() - before + work.dissipated() - work.boundaries - work.numerical_work;
    assert!(balance.abs() < 1e-9 * before, "{balance:e} J");
    assert!(
        work.numerical_work.abs() < 0.02 * before,
        "{} of the energy",
        work.numerical_work / before
    );
}
