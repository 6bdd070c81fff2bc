//! Orders in dt of both integrators, of what angular momentum leaves over, and the bound of energy.

use sphere_dda::Vec3;
use sphere_dda::geometry::Revolution;
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Motion;
use sphere_dda::scene::Spring;

use crate::support::{Case, G, order};

const RADIUS: f64 = 0.1;

/// A frictionless sphere swings in a trough from 60 degrees: the pendulum `L th'' = -g sin th`, by fourth-order Runge-Kutta.
fn pendulum(length: f64, start: f64, time: f64) -> f64 {
    let steps = 20_000;
    let h = time / f64::from(steps);
    let rate = |[th, w]: [f64; 2]| [w, -G / length * th.sin()];
    let mut s = [start, 0.0];
    let add = |s: [f64; 2], k: [f64; 2], h: f64| [s[0] + h * k[0], s[1] + h * k[1]];
    for _ in 0..steps {
        let k1 = rate(s);
        let k2 = rate(add(s, k1, 0.5 * h));
        let k3 = rate(add(s, k2, 0.5 * h));
        let k4 = rate(add(s, k3, h));
        s = [0, 1].map(|i| s[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    s[0]
}

/// On a curved path both integrators turn the velocity once a step and are judged at the same time against the pendulum:
/// `moreau` is of second order (a leapfrog held on the circle), `shi` of first at best, for the wall's reaction sets the
/// end of its constant acceleration, and its chatter along the normal stays.
#[test]
fn order_on_a_curved_path() {
    let (hollow, axis, start) = (1.0, Vec3::new(0.0, 1.0, 0.0), 60f64.to_radians());
    let length = hollow - RADIUS;
    for (integrator, expected) in [(Integrator::Moreau, 2.0), (Integrator::Shi, 1.0)] {
        let error = |dt: f64| {
            let trough = Revolution::cylinder(-axis, axis, hollow, 2.0).expect("a trough");
            let mut run = Case::new(dt, 0.0, 0.0)
                .settings(|s| s.integrator = integrator)
                .tolerance(1e-11, 1e-11, 1e-11)
                .wall(vec![trough.into()])
                .sphere(
                    RADIUS,
                    Vec3::new(start.sin(), 0.0, -start.cos()) * length,
                    Vec3::zeros(),
                )
                .start();
            let mut worst = 0.0f64;
            for k in 1..=4 {
                let end = 0.4 * f64::from(k);
                while run.simulation.time() < end - 0.5 * dt {
                    run.step();
                }
                let x = run.position(0);
                worst = worst.max((x.x.atan2(-x.z) - pendulum(length, start, end)).abs());
            }
            worst
        };
        let errors = [8e-3, 4e-3, 2e-3, 1e-3].map(error);
        let orders: Vec<f64> = errors.windows(2).map(|e| order(e[0], e[1], 2.0)).collect();
        println!("{integrator:?}: errors {errors:?}, orders {orders:?}");
        assert!(
            orders.iter().all(|o| (o - expected).abs() < 0.25),
            "{integrator:?}: {orders:?}"
        );
    }
}

/// A spring is implicit in both integrators: first order, against `x = x0 cos w t`.
#[test]
fn order_on_a_spring() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let error = |dt: f64| {
            let (stiffness, x0, end) = (200.0, 0.05, 0.8);
            let mut case = Case::new(dt, 0.0, 0.0)
                .without_gravity()
                .settings(|s| s.integrator = integrator)
                .tolerance(1e-12, 1e-12, 1e-12)
                .sphere(0.05, Vec3::new(x0, 0.0, 0.0), Vec3::zeros());
            case.scene.springs.push(Spring {
                sphere: 0,
                arm: Vec3::zeros(),
                stiffness,
                target: Vec3::zeros(),
                motion: Motion::Fixed,
            });
            let mut run = case.start();
            let w = (stiffness / run.mass(0)).sqrt();
            let mut worst = 0.0f64;
            while run.simulation.time() < end - 0.5 * dt {
                run.step();
                let exact = x0 * (w * run.simulation.time()).cos();
                worst = worst.max((run.position(0).x - exact).abs());
            }
            worst
        };
        let (coarse, fine) = (error(4e-4), error(2e-4));
        let found = order(coarse, fine, 2.0);
        assert!(
            (found - 1.0).abs() < 0.1,
            "{integrator:?}: order {found}, {coarse} {fine}"
        );
    }
}

/// Two spheres that collide with friction while a gap of up to `v dt` is left between their two contact points: friction
/// takes the couple `gap x friction` out of the angular momentum. Mean over the phases: of first order in dt. Linear momentum
/// closes in every step (`Run::step`).
#[test]
fn angular_momentum_is_left_over_in_first_order() {
    let residue = |dt: f64| {
        let phases = 32;
        let offset = 0.7 * RADIUS;
        (0..phases)
            .map(|phase| {
                let back = dt * f64::from(phase) / f64::from(phases);
                let mut run = Case::new(dt, 0.3, 0.5)
                    .without_gravity()
                    .sphere(
                        RADIUS,
                        Vec3::new(-0.3 - 2.0 * back, 0.0, offset),
                        Vec3::x() * 2.0,
                    )
                    .sphere(RADIUS, Vec3::zeros(), Vec3::zeros())
                    .start();
                let before = run.angular_momentum();
                while run.simulation.time() < 0.2 {
                    run.step();
                }
                assert!(run.velocity(1).norm() > 0.5, "they met");
                (run.angular_momentum() - before).norm() / before.norm()
            })
            .sum::<f64>()
            / f64::from(phases)
    };
    let (coarse, fine) = (residue(4e-3), residue(1e-3));
    let found = order(coarse, fine, 4.0);
    println!("angular momentum left over: {coarse:e} at 4 ms, {fine:e} at 1 ms");
    assert!((found - 1.0).abs() < 0.2, "order {found}: {coarse} {fine}");
    assert!(fine < 1e-2);
}

/// A passive scene with e = 0: five spheres fall into a bowl and come to rest with friction. Its energy never exceeds the
/// initial one by more than `sum m (g dt)^2/8` (contacts closed slowly) and `sum m (tol R/dt)^2/2` (overlaps within the tolerance
/// put right in a step), over 1e5 steps.
#[test]
fn energy_without_restitution_is_bounded() {
    let (dt, tolerance) = (5e-4, 1e-6);
    let v = Vec3::new;
    let profile = [[0.0, 0.0], [0.1, 0.0], [0.5, 0.4]];
    let mut case = Case::new(dt, 0.1, 0.0)
        .tolerance(tolerance, tolerance, tolerance)
        .wall(vec![
            Revolution::new(Vec3::zeros(), Vec3::z(), &profile)
                .expect("a bowl")
                .into(),
        ]);
    for (x, velocity) in [
        (v(0.2, 0.0, 0.45), v(0.0, 0.5, 0.0)),
        (v(-0.2, 0.05, 0.5), v(0.0, -0.5, 0.0)),
        (v(0.0, 0.2, 0.6), v(0.5, 0.0, 0.0)),
        (v(0.0, -0.2, 0.7), v(-0.3, 0.0, 0.0)),
        (v(0.0, 0.0, 0.9), v(0.0, 0.0, 0.0)),
    ] {
        case = case.sphere(0.07, x, velocity);
    }
    let mut run = case.start();
    let start = run.energy();
    let each = (G * dt).powi(2) / 8.0 + (tolerance * 0.07 / dt).powi(2) / 2.0;
    let bound: f64 = (0..5).map(|i| run.mass(i) * each).sum();
    let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..100_000 {
        run.step();
        let gain = run.energy() - start;
        highest = highest.max(gain);
        lowest = lowest.min(gain);
        assert!(
            gain <= bound,
            "{gain:e} J, bound {bound:e} J, at {} s",
            run.simulation.time()
        );
    }
    println!("energy from {lowest} to {highest:e} J over the start; bound {bound:e} J");
    assert!(lowest < -0.1 * start, "it fell");
}
