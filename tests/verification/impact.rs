//! Rows 2, 3, 8 and 9: impacts.

use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Method;
use sphere_dda::solver::SolverKind;

use crate::support::{Case, G, close};

/// Row 2: a ball dropped from h = 1 m with restitution e. Peaks are `e^(2n) h`; for e = 0.5 it rests after
/// `sqrt(2 h/g) (1 + e)/(1 - e) = 1.35457 s`. Impacts are resolved at nodes: the error is of first order in
/// dt, shown by the mean over phases for two steps.
#[test]
fn bouncing_ball() {
    let e: f64 = 0.5;
    let peak_error = |dt: f64| -> f64 {
        let phases = 16;
        (0..phases)
            .map(|phase| {
                let drop = 1.0 + 4.0 * dt * phase as f64 / phases as f64;
                let mut run = Case::new(dt, 0.0, e)
                    .floor()
                    .sphere(0.1, Vec3::new(0.0, 0.0, 0.1 + drop), Vec3::zeros())
                    .start();
                let (mut peak, mut bounced) = (0.0f64, false);
                while run.simulation.time() < 1.1 * (2.0 * drop / G).sqrt() * (1.0 + e) {
                    run.step();
                    bounced |= run.velocity(0).z > 0.5;
                    if bounced {
                        peak = peak.max(run.position(0).z - 0.1);
                    }
                }
                (peak - e * e * drop).abs()
            })
            .sum::<f64>()
            / phases as f64
    };
    let (coarse, fine) = (peak_error(4e-3), peak_error(1e-3));
    let order = (coarse / fine).log(4.0);
    assert!(fine < 5e-3, "{fine}");
    assert!((order - 1.0).abs() < 0.35, "order {order}: {coarse} {fine}");

    let mut run = Case::new(1e-4, 0.0, e)
        .floor()
        .sphere(0.1, Vec3::new(0.0, 0.0, 1.1), Vec3::zeros())
        .start();
    let total = (2.0 / G).sqrt() * (1.0 + e) / (1.0 - e);
    close(total, 1.35457, 1e-5, 0.0);
    let mut last_motion = 0.0;
    for _ in 0..16000 {
        run.step();
        if run.position(0).z - 0.1 > 1e-4 {
            last_motion = run.simulation.time();
        }
    }
    close(last_motion, total, 2e-2, 0.0);
    assert!(run.velocity(0).norm() < 1e-9, "it rests");
    close(run.force_on_boundary(0).z, -run.mass(0) * G, 1e-9, 0.0);
}

/// Row 3: `shi` at a rigid wall without gravity. With `d = theta v dt` left to the wall the mean velocity of the
/// step is `-theta v`, so it leaves with `v' = 2 (-theta v) + v`: restitution `|1 - 2 theta|`.
#[test]
fn shi_rebounds_by_the_phase() {
    let (v, dt) = (2.0, 1e-2);
    for theta in [0.0, 0.1, 0.25, 0.5, 0.7, 0.9, 1.0] {
        let mut run = Case::new(dt, 0.0, 0.0)
            .without_gravity()
            .tolerance(1e-12, 1e-12, 1e-12)
            .settings(|s| {
                s.integrator = Integrator::Shi;
                s.solver = SolverKind::GaussSeidel;
            })
            .floor()
            .sphere(
                0.1,
                Vec3::new(0.0, 0.0, 0.1 + theta * v * dt),
                Vec3::new(0.0, 0.0, -v),
            )
            .start();
        run.step();
        let after = run.velocity(0).z;
        close(after.abs() / v, f64::abs(1.0 - 2.0 * theta), 1e-12, 1.0);
    }
}

/// Row 3, penalty spring of `dt sqrt(P/m) = 2`: one step in contact turns `v` into `-v/3`, whatever the phase.
///
/// The step solves `(2m/dt^2 + P) D = 2m v/dt - P g`. While g stays positive no spring acts; from the first
/// overlapping step on, with P dt^2 = 4 m: `6 D = 2 v dt - 4 g`, and a first contact with `g = 0` gives
/// `D = v dt/3`, `v' = 2/3 v - v = -v/3`.
#[test]
fn shi_penalty_restitution_is_one_third() {
    let (v, dt, radius) = (2.0, 1e-2, 0.1);
    let mass = 4.0 / 3.0 * std::f64::consts::PI * 2500.0 * radius * radius * radius;
    for phase in [0.0, 0.3, 0.5, 0.9] {
        let mut run = Case::new(dt, 0.0, 0.0)
            .without_gravity()
            .settings(|s| {
                s.integrator = Integrator::Shi;
                s.method = Method::Penalty;
                s.penalty = Some(4.0 * mass / (dt * dt));
                s.tolerance.force = 1e-13;
            })
            .floor()
            .sphere(
                radius,
                Vec3::new(0.0, 0.0, radius + phase * v * dt),
                Vec3::new(0.0, 0.0, -v),
            )
            .start();
        run.steps(20);
        close(run.velocity(0).z / v, 1.0 / 3.0, 1e-12, 1.0);
    }
}

/// Row 3: under gravity a resting sphere's force alternates, `m (g -+ 2 v0/dt)`: with `D = 0` held by the wall the
/// velocity flips sign every step, `v' = -v`, and the force is `m (g - 2 v/dt)`, v the velocity before the step.
#[test]
fn shi_chatters_at_rest() {
    let (dt, v0) = (1e-2, -0.01);
    let mut run = Case::new(dt, 0.0, 0.0)
        .tolerance(1e-12, 1e-12, 1e-12)
        .settings(|s| s.integrator = Integrator::Shi)
        .floor()
        .sphere(0.1, Vec3::new(0.0, 0.0, 0.1), Vec3::new(0.0, 0.0, v0))
        .start();
    for k in 0..20 {
        run.step();
        let before = if k % 2 == 0 { v0 } else { -v0 };
        close(run.velocity(0).z, -before, 1e-9, 0.0);
        close(
            -run.force_on_boundary(0).z,
            run.mass(0) * (G - 2.0 * before / dt),
            1e-9,
            0.0,
        );
    }
}

/// Row 8: head-on pair, Newton's restitution and momentum: `v1' = ((m1 - e m2) v1 + (1 + e) m2 v2)/(m1 + m2)`.
#[test]
fn head_on_pair() {
    for e in [0.0, 0.3, 1.0] {
        let (r1, r2, v1, v2) = (0.1, 0.2, 3.0, -1.0);
        let mut run = Case::new(1e-3, 0.4, e)
            .without_gravity()
            .tolerance(1e-13, 1e-13, 1e-13)
            .sphere(r1, Vec3::new(-0.5, 0.0, 0.0), Vec3::new(v1, 0.0, 0.0))
            .sphere(r2, Vec3::new(0.5, 0.0, 0.0), Vec3::new(v2, 0.0, 0.0))
            .start();
        let (m1, m2) = (run.mass(0), run.mass(1));
        let before = m1 * v1 + m2 * v2;
        for _ in 0..300 {
            run.step();
            let now = m1 * run.velocity(0).x + m2 * run.velocity(1).x;
            close(now, before, 1e-13, m1 * v1);
        }
        close(
            run.velocity(0).x,
            ((m1 - e * m2) * v1 + (1.0 + e) * m2 * v2) / (m1 + m2),
            1e-12,
            v1,
        );
        close(
            run.velocity(1).x,
            ((m2 - e * m1) * v2 + (1.0 + e) * m1 * v1) / (m1 + m2),
            1e-12,
            v1,
        );
    }
}

/// Row 9: oblique impact on a wall, no gravity, angle th from the normal: `u_n = v cos th`, `u_t = v sin th`.
/// The impulse `(1 + e) m u_n` allows a tangential one of at most mu times that; stopping the surface needs
/// `2/7 m u_t`. So it sticks iff `u_t/u_n <= 3.5 mu (1 + e)`; slipping takes `mu (1 + e) u_n` off the centre and
/// `3.5 mu (1 + e) u_n` off the surface, and gives `w = 2.5 mu (1 + e) u_n / R`; sticking leaves 5/7 of u_t.
#[test]
fn oblique_impact() {
    let (mu, radius, v) = (0.2f64, 0.1, 4.0);
    for e in [0.0, 0.5, 1.0] {
        for degrees in [5.0, 20.0, 34.0, 36.0, 50.0, 55.0, 60.0, 80.0f64] {
            let th = degrees.to_radians();
            let (un, ut) = (v * th.cos(), v * th.sin());
            let mut run = Case::new(1e-3, mu, e)
                .without_gravity()
                .tolerance(1e-12, 1e-12, 1e-12)
                .floor()
                .sphere(radius, Vec3::new(0.0, 0.0, 0.1503), Vec3::new(ut, 0.0, -un))
                .start();
            while run.velocity(0).z < -1e-9 && run.simulation.time() < 0.3 {
                run.step();
            }
            run.steps(5);
            let sticks = ut / un <= 3.5 * mu * (1.0 + e);
            let (vx, rw) = (run.velocity(0).x, run.spin(0).y * radius);
            close(run.velocity(0).z, e * un, 1e-9, v);
            if sticks {
                close(vx, 5.0 / 7.0 * ut, 1e-9, v);
                close(vx - rw, 0.0, 1e-9, v);
            } else {
                close(vx / ut, 1.0 - mu * (1.0 + e) / th.tan(), 1e-9, 1.0);
                close(rw, 2.5 * mu * (1.0 + e) * un, 1e-9, v);
                close(vx - rw, ut - 3.5 * mu * (1.0 + e) * un, 1e-9, v);
            }
        }
    }
}

/// Row 9 in space: planes, velocities and spins of any direction, both solvers, and one percent below and above the
/// threshold. With the surface velocity `u_t = v_t - w x n R` the impulse is `(1 + e) m u_n` along n and `-J u_t/|u_t|`
/// across it, `J = min(mu (1 + e) m u_n, 2/7 m |u_t|)`; it changes w by `-R n x (impulse)/I`. The spin about n stays.
#[test]
fn oblique_impacts_in_space() {
    let (radius, speed) = (0.1, 3.0);
    let mut sticking = 0;
    for k in 0..24 {
        let turn = |a: f64, b: f64| {
            let up = (a * f64::from(k) + b).sin();
            let around = 2.4 * f64::from(k) + b;
            Vec3::new(around.cos(), around.sin(), 0.0) * (1.0 - up * up).sqrt() + Vec3::z() * up
        };
        let (mu, e) = (0.1 + 0.05 * f64::from(k % 5), 0.25 * f64::from(k % 4));
        let n = turn(0.7, 0.2);
        let across = n.cross(&turn(1.1, 0.9)).normalize();
        // Every third case is at 99 % or 101 % of the threshold tan th = 3.5 mu (1 + e), without spin.
        let threshold = 3.5 * mu * (1.0 + e);
        let (ratio, spin) = match k % 6 {
            0 => (0.99 * threshold, Vec3::zeros()),
            3 => (1.01 * threshold, Vec3::zeros()),
            _ => (0.2 + 0.1 * f64::from(k), turn(0.3, 0.5) * 20.0),
        };
        let velocity = (across * ratio - n).normalize() * speed;
        let u_n = -velocity.dot(&n);
        let u_t = velocity + n * u_n - spin.cross(&n) * radius;
        let sticks = u_t.norm() <= threshold * u_n;
        sticking += i32::from(sticks);
        let push = (mu * (1.0 + e) * u_n).min(u_t.norm() / 3.5);
        let impulse = n * ((1.0 + e) * u_n) - u_t.normalize() * push;
        let spun = spin - n.cross(&impulse) * (2.5 / radius);
        for solver in [SolverKind::GaussSeidel, SolverKind::Direct] {
            let mut run = Case::new(1e-3, mu, e)
                .without_gravity()
                .tolerance(1e-13, 1e-13, 1e-13)
                .settings(|s| s.solver = solver)
                .plane(Vec3::zeros(), n)
                .body(
                    radius,
                    n * (radius + 0.0103 * u_n),
                    velocity,
                    spin,
                    Default::default(),
                )
                .start();
            run.steps(20);
            let (v, w) = (run.velocity(0), run.spin(0));
            assert!(
                (v - velocity - impulse).norm() < 1e-9 * speed,
                "case {k} {solver:?}: {v:?}"
            );
            assert!(
                (w - spun).norm() * radius < 1e-9 * speed,
                "case {k} {solver:?}: {w:?}"
            );
            let slip = v - n * v.dot(&n) - w.cross(&n) * radius;
            assert_eq!(
                slip.norm() < 1e-9 * speed,
                sticks,
                "case {k}: slip {slip:?}"
            );
            if sticks && spin == Vec3::zeros() {
                let tangential = |v: Vec3| (v - n * v.dot(&n)).norm();
                close(tangential(v) / tangential(velocity), 5.0 / 7.0, 1e-9, 0.0);
            }
        }
    }
    assert!((4..20).contains(&sticking), "{sticking} stick");
}
