//! Rows 10 and 16, and Kane's objection: several impacts in one step, each by Newton's law.

use sphere_dda::Vec3;
use sphere_dda::geometry::Facets;
use sphere_dda::solver::SolverKind;

use crate::support::{Case, close};

const RADIUS: f64 = 0.1;
const SOLVERS: [SolverKind; 3] = [
    SolverKind::Auto,
    SolverKind::GaussSeidel,
    SolverKind::Direct,
];

/// Row 10, e = 1: a sphere with v0 against two in line that touch. Between the first two `u1' = +v0`, between the last two
/// `u2' >= 0` holds with a push: they stay together. With `v2' = v3' = x`, `v1' = x - v0` momentum gives x = 2/3 v0.
/// With gaps that take more than a step each impact is one of its own, and the last sphere takes all.
#[test]
fn three_spheres_in_line() {
    let (v0, dt) = (2.0, 1e-3);
    for solver in SOLVERS {
        for (gap, expected) in [
            (0.0, [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]),
            (3.0 * v0 * dt, [0.0, 0.0, 1.0]),
        ] {
            let mut case = Case::new(dt, 0.3, 1.0)
                .without_gravity()
                .tolerance(1e-13, 1e-13, 1e-13)
                .settings(|s| s.solver = solver);
            for k in 0..3 {
                let x = (2.0 * RADIUS + gap) * f64::from(k);
                let velocity = if k == 0 { v0 } else { 0.0 };
                case = case.sphere(
                    RADIUS,
                    Vec3::new(x, 0.0, 0.0),
                    Vec3::new(velocity, 0.0, 0.0),
                );
            }
            let mut run = case.start();
            run.steps(20);
            for (k, expected) in expected.into_iter().enumerate() {
                close(run.velocity(k).x, expected * v0, 1e-12, v0);
                assert!(run.velocity(k).yz().norm() < 1e-12);
            }
        }
    }
}

/// Kane's objection: Newton's law with friction can gain energy where a body is hit twice at once. A sphere flies with
/// `(-a, 0, -b)` into a right angle of floor (normal z) and wall (normal x) and touches both in the same step; both contacts
/// rebound with `f` and slip:
///
/// ```text
/// m (1 + f) a = W - mu N,   m (1 + f) b = N + mu W,   v' = f (a, 0, b)
/// I w = R mu (N - W)  =>  R w = (1 + f) s/2,  s = 5 mu (b - a)/(1 + mu),  I w^2/2 = m (R w)^2/5
/// ```
/// (F = -mu N along x opposes `a - R w > 0`, G = -mu W along z opposes `b + R w > 0`.) At `f = e = 1` that is `m s^2/5` too much.
/// With `q = s^2/10` the energy stays where `(1 - f^2) (a^2 + b^2) = (1 + f)^2 q`: `f = (a^2 + b^2 - q)/(a^2 + b^2 + q)`.
#[test]
fn newtons_law_with_friction_is_limited_in_a_corner() {
    let (mu, a, b) = (0.1, 1.0, 2.0);
    let s: f64 = 5.0 * mu * (b - a) / (1.0 + mu);
    assert!(a - s > 0.0 && b + s > 0.0, "both contacts slip");
    let (energy, q) = (a * a + b * b, s * s / 10.0);
    let f = (energy - q) / (energy + q);
    assert!(f < 0.992, "more than a rounding error");
    for solver in SOLVERS {
        // Both gaps close at the same fraction of the step.
        let run_up = 0.5e-3;
        let mut run = Case::new(1e-3, mu, 1.0)
            .without_gravity()
            .tolerance(1e-12, 1e-12, 1e-12)
            .settings(|s| s.solver = solver)
            .floor()
            .plane(Vec3::zeros(), Vec3::x())
            .sphere(
                RADIUS,
                Vec3::new(RADIUS + a * run_up, 0.0, RADIUS + b * run_up),
                Vec3::new(-a, 0.0, -b),
            )
            .start();
        let before = run.kinetic();
        run.steps(5);
        close(run.velocity(0).x, f * a, 1e-5, 0.0);
        close(run.velocity(0).z, f * b, 1e-5, 0.0);
        close(run.spin(0).y.abs() * RADIUS, 0.5 * (1.0 + f) * s, 1e-5, 0.0);
        close(run.kinetic() / before, 1.0, 1e-5, 0.0);
        assert!(run.kinetic() < before * (1.0 + 1e-9));
    }
}

/// Row 16: twenty spheres in a closed box, e = 1, no friction, 1 % of the volume. An impact between two bodies keeps
/// the energy whatever its normal is, so it stays within 1e-10 in every step in which no sphere has two loaded
/// contacts; the other steps are few, and may change it.
#[test]
fn a_gas_keeps_its_energy() {
    let (side, radius, count) = (1.0, 0.05, 20);
    let wall = Facets::cuboid(Vec3::zeros(), Vec3::repeat(side)).expect("a box");
    let mut case = Case::new(2e-3, 0.0, 1.0)
        .without_gravity()
        .tolerance(1e-9, 1e-9, 1e-12)
        .wall(vec![wall.into()]);
    for k in 0..count {
        // A lattice, with directions that repeat only after all spheres.
        let cell = Vec3::new(f64::from(k % 3), f64::from(k / 3 % 3), f64::from(k / 9));
        let turn = f64::from(k) * 2.4;
        let up = f64::from(2 * k + 1) / f64::from(count) - 1.0;
        let flat = (1.0 - up * up).sqrt();
        case = case.sphere(
            radius,
            cell * 0.3 + Vec3::repeat(0.2),
            Vec3::new(flat * turn.cos(), flat * turn.sin(), up) * 2.0,
        );
    }
    let fraction = f64::from(count) * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    assert!(fraction < 0.02);
    let mut run = case.start();
    let (mut impacts, mut multiple, mut change) = (0, 0, 0.0f64);
    for _ in 0..5000 {
        let before = run.kinetic();
        run.step();
        let mut touched: Vec<u32> = Vec::new();
        for contact in run.simulation.contacts() {
            touched.push(contact.key.sphere);
            if let sphere_dda::contact::Partner::Sphere { index: j, .. } = contact.key.partner {
                touched.push(j);
            }
        }
        impacts += run.simulation.contacts().len();
        touched.sort_unstable();
        let relative = run.kinetic() / before - 1.0;
        if touched.windows(2).any(|w| w[0] == w[1]) {
            multiple += 1;
            change += relative;
        } else {
            assert!(
                relative.abs() < 1e-10,
                "{relative:e} at {} s",
                run.simulation.time()
            );
        }
    }
    // Seen with `--nocapture`.
    println!(
        "{impacts} impacts; {multiple} steps with a sphere hit twice changed the energy by {change:e}"
    );
    assert!(impacts > 500, "{impacts}");
    assert!(multiple < 50, "{multiple}");
}

/// Two spheres that touch fill the room between two walls, and one comes towards the other with `v0`: by Newton's law they part with
/// `e v0`, for which there is no room. Their rebound is given up, and both stand still. One that hits a wall beside them rebounds with
/// `e v0` all the same.
#[test]
fn rebounds_without_room_are_given_up() {
    let (v0, e) = (2.0, 0.8);
    let [low, high] = [-RADIUS, 3.0 * RADIUS].map(|x| Vec3::new(x, 0.0, 0.0));
    for solver in [SolverKind::Auto, SolverKind::GaussSeidel] {
        let case = Case::new(1e-3, 0.3, e)
            .without_gravity()
            .tolerance(1e-10, 1e-10, 1e-6)
            .settings(|s| s.solver = solver)
            .plane(low, Vec3::x())
            .plane(high, -Vec3::x())
            .sphere(RADIUS, Vec3::zeros(), Vec3::x() * v0)
            .sphere(RADIUS, Vec3::x() * (2.0 * RADIUS), Vec3::zeros())
            .sphere(RADIUS, Vec3::y(), Vec3::x() * -v0);
        let mut run = case.start();
        run.steps(1);
        for k in 0..2 {
            close(run.velocity(k).norm(), 0.0, 1e-6, v0);
        }
        close(run.velocity(2).x, e * v0, 1e-9, v0);
    }
}
