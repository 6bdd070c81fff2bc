//! Row 14: a sphere that falls off an edge, a corner or a fixed sphere.
//!
//! ```text
//!        o   th     centre on a circle of radius L about the point (L = R) or the other centre (L = R + r);
//!       /           N = m g cos th - m v^2/L,  v = L th'
//!      *            frictionless:  v^2 = v0^2 + 2 g L (1 - cos th)      N = 0 at cos th = 2/3 + v0^2/(3 g L)
//!     ##            no slip:       v^2 = v0^2 + 10/7 g L (1 - cos th)   N = 0 at cos th = 10/17 + 7/17 v0^2/(g L)
//!    ####           F = 2/7 m g sin th; it slips from F = mu N on: 2 sin th = mu (17 cos th - 10)
//! ```
//! After that `L th'' = g sin th - mu N/m`: with `y = v^2/(g L)` as a function of th this is linear,
//!
//! ```text
//! dy/dth = 2 sin th - 2 mu (cos th - y),   y = C exp(2 mu th) + A cos th + B sin th,
//! A = (4 mu^2 - 2)/(1 + 4 mu^2),  B = -6 mu/(1 + 4 mu^2),  C from the no-slip speed where slip begins;  N = 0 at y = cos th
//! ```

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Shape};
use sphere_dda::scene::particles::Locks;

use crate::support::{Case, G, Run, close};

const RADIUS: f64 = 0.1;
/// Angle at the start \[rad\], with the speed that a fall from the top gives.
const START: f64 = 1e-3;
const DT: f64 = 1e-4;

/// What the sphere falls off.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Support {
    Edge,
    Corner,
    Sphere,
}

/// How it ended.
struct Fall {
    /// Angle at which the normal force vanishes \[rad\].
    leaves: f64,
    /// Angle at which the contact point begins to slip \[rad\].
    slips: f64,
    /// Energy lost on the way over `m g L`.
    lost: f64,
}

fn setup(support: Support, friction: f64) -> (Run, Vec3, f64) {
    let v = Vec3::new;
    let along = match support {
        Support::Corner => v(0.5f64.sqrt(), 0.5f64.sqrt(), 0.0),
        _ => Vec3::x(),
    };
    let length = match support {
        Support::Sphere => RADIUS + 0.25,
        _ => RADIUS,
    };
    // A frictionless sphere does not roll: its whole energy is in its speed.
    let share = if friction == 0.0 { 2.0 } else { 10.0 / 7.0 };
    let speed = (share * G * length * (1.0 - START.cos())).sqrt();
    let centre = (along * START.sin() + Vec3::z() * START.cos()) * length;
    let velocity = (along * START.cos() - Vec3::z() * START.sin()) * speed;
    let spin = if friction == 0.0 {
        Vec3::zeros()
    } else {
        Vec3::z().cross(&along) * (speed / RADIUS)
    };
    let case = Case::new(DT, friction, 0.0).tolerance(1e-8, 1e-8, 1e-8);
    let plate = |corner, u, w| Shape::from(Facets::rectangle(corner, u, w).expect("a plate"));
    let case = match support {
        Support::Edge => case.wall(vec![
            plate(v(-1.0, -1.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 2.0, 0.0)),
            plate(v(0.0, -1.0, -1.0), v(0.0, 0.0, 1.0), v(0.0, 2.0, 0.0)),
        ]),
        Support::Corner => case.wall(vec![
            Facets::cuboid(v(-1.0, -1.0, -1.0), Vec3::zeros())
                .expect("a box")
                .into(),
        ]),
        Support::Sphere => case.body(
            0.25,
            Vec3::zeros(),
            Vec3::zeros(),
            Vec3::zeros(),
            Locks {
                translation: [true; 3],
                rotation: [true; 3],
            },
        ),
    };
    let run = case
        .body(RADIUS, centre, velocity, spin, Locks::default())
        .start();
    (run, along, length)
}

fn fall(support: Support, friction: f64) -> Fall {
    let (mut run, along, length) = setup(support, friction);
    let falling = usize::from(support == Support::Sphere);
    let angle = |run: &Run| {
        let x = run.position(falling);
        x.dot(&along).atan2(x.z)
    };
    let energy = |run: &Run| {
        let (v, w) = (run.velocity(falling), run.spin(falling));
        0.5 * v.norm_squared() + 0.2 * (RADIUS * w).norm_squared() + G * run.position(falling).z
    };
    let start = energy(&run);
    let (mut slips, mut lost) = (f64::NAN, 0.0);
    let mut loaded: Vec<(f64, f64)> = Vec::new();
    loop {
        let before = angle(&run);
        run.step();
        assert!(run.simulation.time() < 3.0, "it never leaves");
        let force = run.normal_force().abs();
        if force == 0.0 {
            break;
        }
        // The force is that of the step: it belongs to the angle at the step's start.
        loaded.push((before, force));
        lost = (start - energy(&run)) / (G * length);
        let contact = run.simulation.contacts()[0];
        let friction_force = contact.force - contact.normal * contact.force.dot(&contact.normal);
        if slips.is_nan() && friction_force.norm() >= friction * force * (1.0 - 1e-9) {
            slips = before;
        }
    }
    let [.., (a, f), (b, g)] = loaded[..] else {
        panic!("two loaded steps");
    };
    let leaves = b + (b - a) * g / (f - g);
    let across = Vec3::z().cross(&along);
    assert!(
        run.position(falling).dot(&across).abs() < 1e-6 * RADIUS,
        "it falls straight"
    );
    Fall {
        leaves,
        slips,
        lost,
    }
}

/// Where `f` changes its sign between `low` and `high`.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).signum();
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if f(middle) * sign > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Angles at which it begins to slip, and at which it leaves \[rad\].
fn exact(mu: f64) -> (f64, f64) {
    let last = (10.0f64 / 17.0).acos();
    let slips = root(
        |th| 2.0 * th.sin() - mu * (17.0 * th.cos() - 10.0),
        0.0,
        last,
    );
    let a = (4.0 * mu * mu - 2.0) / (1.0 + 4.0 * mu * mu);
    let b = -6.0 * mu / (1.0 + 4.0 * mu * mu);
    let c = 10.0 / 7.0 * (1.0 - slips.cos()) - a * slips.cos() - b * slips.sin();
    let y = |th: f64| c * (2.0 * mu * (th - slips)).exp() + a * th.cos() + b * th.sin();
    (slips, root(|th| th.cos() - y(th), slips, last + 0.01))
}

/// Row 14 without friction: 48.190 degrees.
#[test]
fn a_frictionless_sphere_leaves_at_two_thirds() {
    let exact = (2.0f64 / 3.0).acos();
    close(exact.to_degrees(), 48.190, 1e-5, 0.0);
    for support in [Support::Edge, Support::Corner, Support::Sphere] {
        let found = fall(support, 0.0);
        close(found.leaves, exact, 1e-3, 0.0);
        assert!(found.lost.abs() < 1e-3, "{support:?} lost {:e}", found.lost);
    }
}

/// Row 14 with friction: it rolls, slips, leaves.
#[test]
fn a_rolling_sphere_slips_and_leaves() {
    let no_slip = (10.0f64 / 17.0).acos();
    close(no_slip.to_degrees(), 53.968, 1e-5, 0.0);
    for (mu, table) in [
        (0.5, 52.756),
        (1.0, 53.322),
        (10.0, 53.901),
        (100.0, 53.962),
    ] {
        let (slips, leaves) = exact(mu);
        close(leaves.to_degrees(), table, 4e-5, 0.0);
        for support in [Support::Edge, Support::Corner, Support::Sphere] {
            let found = fall(support, mu);
            close(found.leaves, leaves, 2e-4, 0.0);
            close(found.slips, slips, 1e-3, 0.0);
            // What slipping takes: its share of `m g L` for mu = .5 is 5e-4.
            assert!(
                (-1e-6..1e-3).contains(&found.lost),
                "{support:?} lost {:e}",
                found.lost
            );
        }
    }
}

/// The first problem of a step foresees by how much the gap of a sphere that goes round another opens beside its linear change:
/// `v^2 dt^2/2L`, of which the tolerance is left to the true geometry.
#[test]
fn a_step_foresees_how_a_curved_pair_opens() {
    let (radius, dt, gap) = (0.01, 1e-3, 1e-6);
    let held = Locks {
        translation: [true; 3],
        rotation: [true; 3],
    };
    let mut run = Case::new(dt, 0.0, 0.0)
        .tolerance(gap, gap, gap)
        .body(radius, Vec3::zeros(), Vec3::zeros(), Vec3::zeros(), held)
        .sphere(radius, Vec3::z() * (2.0 * radius), Vec3::x() * 0.3)
        .start();
    run.step();
    let (problem, _) = run.simulation.problem(dt).expect("a problem");
    let row = problem.rows.get(0);
    let kinematics = run.simulation.kinematics();
    let apart = (kinematics.position[1] - kinematics.position[0]).norm();
    let v = kinematics.velocity[1];
    let across = v - row.normal * v.dot(&row.normal);
    let opens = across.norm_squared() * dt * dt / (2.0 * apart);
    assert!(opens > 100.0 * gap * radius);
    let expected = apart - 2.0 * radius + opens - gap * radius;
    close(row.bias.dot(&row.normal) * dt, expected, 1e-6, 0.0);
}
