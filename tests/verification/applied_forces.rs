//! Forces from outside at the centres of spheres: parabolas, drag that the caller computes, sleepers, the ledger.

use sphere_dda::Vec3;
use sphere_dda::error::StepError;
use sphere_dda::integrator::Integrator;

use crate::support::{Case, G, Run, close};

const R: f64 = 0.1;

/// Two spheres far apart.
fn two(dt: f64) -> Case {
    let one = |x: f64| (R, Vec3::new(x, 0.0, 50.0), Vec3::new(3.0, 1.0, 4.0));
    let [(r, a, v), (_, b, _)] = [one(0.0), one(5.0)];
    Case::new(dt, 0.3, 0.0).sphere(r, a, v).sphere(r, b, v)
}

/// `x = x0 + v0 t + (g + F/m) t^2/2` with work `F.(x - x0)`, at steps of any length; the other sphere computes the bits of a
/// run without forces.
#[test]
fn a_constant_force_makes_a_parabola() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let case = || two(1e-2).settings(|s| s.integrator = integrator);
        let (mut run, mut without) = (case().start(), case().start());
        let force = Vec3::new(2.0, -3.0, 40.0);
        run.simulation
            .apply_forces(&[force, Vec3::zeros()])
            .unwrap();
        run.simulation.place().unwrap();
        let (x0, v0) = (run.position(0), run.velocity(0));
        let start = run.energy();
        let a = force / run.mass(0) - Vec3::z() * G;
        for h in [0.01, 0.02, 0.005, 0.037].into_iter().cycle().take(40) {
            run.advance(h);
            without.advance(h);
            let t = run.simulation.time();
            let (x, v) = (x0 + v0 * t + a * (0.5 * t * t), v0 + a * t);
            for axis in 0..3 {
                close(run.position(0)[axis], x[axis], 1e-12, 50.0);
                close(run.velocity(0)[axis], v[axis], 1e-12, 10.0);
            }
            assert_eq!(run.position(1), without.position(1));
            assert_eq!(run.velocity(1), without.velocity(1));
        }
        let work = run.simulation.work();
        let done = force.dot(&(run.position(0) - x0));
        close(work.loads, done, 1e-12, 0.0);
        let scheme = work.numerical_work;
        close(run.energy() - start, done + scheme, 1e-11, 0.0);
        // Of second order in the step; zero with `moreau` but for steps that change their length.
        assert!(scheme.abs() < 1e-2 * done.abs(), "{scheme} of {done} J");
    }
}

/// Stokes drag `F = -c v` that the caller computes before every step: `v` falls behind the terminal velocity `m g/c` by `u`,
/// `u_(n+1) = (1 - 3/2 q) u_n + q/2 u_(n-1)` with `q = c dt/m`, the scheme of Adams and Bashforth; its solution is
/// `A r_1^n + B r_2^n` with the roots of `r^2 = (1 - 3/2 q) r + q/2`.
#[test]
fn drag_of_the_caller_is_the_closed_form_of_its_scheme() {
    let (dt, rate) = (1e-2, 3.0);
    let mut run = Case::new(dt, 0.0, 0.0)
        .sphere(R, Vec3::z() * 9.0, Vec3::zeros())
        .start();
    let (c, q) = (rate * run.mass(0), rate * dt);
    let terminal = -G / rate;
    let half = 0.5 * (1.0 - 1.5 * q);
    let root = (half * half + 0.5 * q).sqrt();
    let [r1, r2] = [half + root, half - root];
    // u_0 = -v_t, and the first step is Euler's: u_1 = (1 - q) u_0.
    let a = -terminal * (1.0 - q - r2) / (r1 - r2);
    let b = -terminal - a;
    for n in 1..=1000 {
        let drag = run.velocity(0) * -c;
        run.simulation.apply_forces(&[drag]).unwrap();
        run.step();
        let v = terminal + a * r1.powi(n) + b * r2.powi(n);
        close(run.velocity(0).z, v, 1e-12, terminal.abs());
    }
    close(run.velocity(0).z, terminal, 1e-12, 0.0);
}

/// The same against `v_t (1 - exp(-c t/m))`: four times nearer with half the step.
#[test]
fn drag_of_the_caller_converges_in_second_order() {
    let rate = 3.0;
    let error = |dt: f64| {
        let mut run = Case::new(dt, 0.0, 0.0)
            .sphere(R, Vec3::z() * 9.0, Vec3::zeros())
            .start();
        let c = rate * run.mass(0);
        while run.simulation.time() < 0.5 - 0.5 * dt {
            let drag = run.velocity(0) * -c;
            run.simulation.apply_forces(&[drag]).unwrap();
            run.step();
        }
        let exact = -G / rate * (1.0 - (-rate * 0.5_f64).exp());
        (run.velocity(0).z - exact).abs()
    };
    let ratio = error(1e-2) / error(5e-3);
    assert!((3.8..4.4).contains(&ratio), "{ratio}");
}

/// Buoyancy in rest: the floor carries `m g - F` from t = 0 on.
#[test]
fn a_floor_carries_what_is_left_of_the_weight() {
    let mut run = Case::new(1e-3, 0.5, 0.0)
        .floor()
        .sphere(R, Vec3::z() * R, Vec3::zeros())
        .start();
    let weight = run.mass(0) * G;
    run.simulation
        .apply_forces(&[Vec3::z() * (0.4 * weight)])
        .unwrap();
    run.simulation.place().unwrap();
    close(-run.force_on_boundary(0).z, 0.6 * weight, 1e-6, 0.0);
    run.steps(5);
    close(-run.force_on_boundary(0).z, 0.6 * weight, 1e-6, 0.0);
    let applied = run.simulation.mean_body_force().z;
    close(applied, -0.6 * weight, 1e-12, 0.0);
}

fn asleep() -> Run {
    let mut run = Case::new(1e-3, 0.5, 0.0)
        .settings(|s| s.rest_speed = 1e-3)
        .floor()
        .sphere(R, Vec3::z() * R, Vec3::zeros())
        .sphere(R, Vec3::new(1.0, 0.0, R), Vec3::zeros())
        .start();
    run.steps(40);
    assert_eq!(run.simulation.report().sweeps, 0, "both sleep");
    run
}

/// A sphere at rest that is lifted by twice its weight rises with g; the one beside it sleeps on, and forces that stay what they
/// were wake none.
#[test]
fn a_force_wakes_what_it_acts_on() {
    let mut run = asleep();
    let (x0, up) = (run.position(0), Vec3::z() * (2.0 * run.mass(0) * G));
    let beside = run.position(1);
    let t0 = run.simulation.time();
    for _ in 0..50 {
        run.simulation.apply_forces(&[up, Vec3::zeros()]).unwrap();
        run.step();
    }
    let t = run.simulation.time() - t0;
    // The force acts from half a step ago.
    let rise = 0.5 * G * t * (t + 1e-3);
    close(run.position(0).z - x0.z, rise, 1e-2, 0.0);
    assert_eq!(run.position(1), beside);
    let mut run = asleep();
    run.simulation.apply_forces(&[Vec3::zeros(); 2]).unwrap();
    run.step();
    assert_eq!(run.simulation.report().sweeps, 0);
}

/// A force that changes between two internal steps acts from there on, and derivatives know where: the power of the last one.
#[test]
fn forces_can_change_within_a_communication_step() {
    let mut run = two(1e-2).start();
    let force = Vec3::x() * 100.0;
    let before = run.momentum();
    let mut step = run.simulation.begin(0.03).unwrap();
    run.simulation.internal_step(&mut step).unwrap();
    run.simulation
        .apply_forces(&[force, Vec3::zeros()])
        .unwrap();
    run.simulation.internal_step(&mut step).unwrap();
    run.simulation
        .apply_forces(&[force * 3.0, Vec3::zeros()])
        .unwrap();
    run.simulation.finish(step).unwrap();
    let gained = (run.momentum() - before).x;
    close(gained, 1e-2 * force.x * (1.0 + 3.0), 1e-12, 0.0);
    let work = run
        .simulation
        .time_derivatives_of(|s| vec![s.work().loads])
        .unwrap();
    let (v, m) = (run.velocity(0).x, run.mass(0));
    // The mean velocity of the last step: half a step before its end.
    let power = 3.0 * force.x * (v - 0.5e-2 * 3.0 * force.x / m);
    close(work[0], power, 1e-9, 0.0);
}

/// They are part of the state: a restored run goes on with them.
#[test]
fn forces_are_part_of_the_state() {
    let mut run = two(1e-2).start();
    run.simulation
        .apply_forces(&[Vec3::x() * 7.0, Vec3::zeros()])
        .unwrap();
    run.steps(3);
    let saved = run.simulation.snapshot();
    run.steps(5);
    let (x, v) = (run.position(0), run.velocity(0));
    let mut again = two(1e-2).start();
    again.simulation.restore(&saved).unwrap();
    again.steps(5);
    assert_eq!((again.position(0), again.velocity(0)), (x, v));
}

#[test]
fn forces_that_cannot_be_computed_with_are_refused() {
    let mut run = two(1e-2).start();
    let before = run.simulation.snapshot();
    for forces in [
        vec![],
        vec![Vec3::zeros(); 3],
        vec![Vec3::zeros(), Vec3::x() * f64::NAN],
        vec![Vec3::x() * 1e31, Vec3::zeros()],
    ] {
        let refused = run.simulation.apply_forces(&forces);
        assert!(
            matches!(refused, Err(StepError::Argument { what: "forces", .. })),
            "{refused:?}"
        );
        assert_eq!(run.simulation.snapshot(), before);
    }
}
