//! Stops and springs of slides and hinges, alone and together with contacts.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, HalfSpace, Shape};
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Method;
use sphere_dda::scene::body::{Joint, Spring};
use sphere_dda::scene::particles::Locks;
use sphere_dda::solver::SolverKind;

use crate::support::{Case, G, Run, body, close, order};

const SLIDE: Joint = Joint::Slide {
    axis: Vec3::new(0.0, 0.0, 1.0),
};
const HINGE: Joint = Joint::Hinge {
    axis: Vec3::new(0.0, 1.0, 0.0),
};
const SOLVERS: [SolverKind; 3] = [
    SolverKind::Auto,
    SolverKind::Direct,
    SolverKind::GaussSeidel,
];
const RADIUS: f64 = 0.1;

/// A scene needs a sphere: this one takes no part.
fn bystander(case: Case) -> Case {
    let locks = Locks {
        translation: [true; 3],
        rotation: [true; 3],
    };
    case.body(
        RADIUS,
        Vec3::x() * 50.0,
        Vec3::zeros(),
        Vec3::zeros(),
        locks,
    )
}

fn ceiling(z: f64) -> Vec<Shape> {
    let plane = HalfSpace::new(Vec3::new(0.0, 0.0, z), -Vec3::z());
    vec![plane.expect("a plane").into()]
}

fn tray(z: f64) -> Vec<Shape> {
    let low = Vec3::new(-0.5, -0.5, z);
    let plate = Facets::rectangle(low, Vec3::x(), Vec3::y());
    vec![plate.expect("a rectangle").into()]
}

/// A piston that falls on its stop stays there: the stop carries weight and load. Under `shi`, which rebounds, it starts
/// there, and the mean of two steps' forces is meant, which alternate as those of any contact at rest.
#[test]
fn a_piston_lands_on_its_stop() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        for solver in SOLVERS {
            let way = match integrator {
                Integrator::Moreau => 0.0123,
                Integrator::Shi => 0.0,
            };
            let (mass, load) = (2.0, 37.0);
            let mut piston = body(mass, Vec3::zeros(), Vec3::zeros(), SLIDE);
            piston.force = Vec3::new(3.0, 0.0, -load);
            piston.limits = [Some(-way), Some(0.5)];
            let mut run = bystander(Case::new(1e-3, 0.3, 0.5))
                .settings(|s| {
                    s.integrator = integrator;
                    s.solver = solver;
                })
                .tolerance(1e-9, 1e-9, 1e-9)
                .driven(ceiling(1.0), piston)
                .start();
            let fall = (2.0 * way / (G + load / mass)).sqrt();
            let mut last = 0.0;
            while run.simulation.time() < 0.3 {
                run.step();
                let joint = run.simulation.joint(0);
                if integrator == Integrator::Shi && run.simulation.time() > 3e-3 {
                    close(0.5 * (joint.force + last), mass * G + load, 1e-6, 0.0);
                }
                last = joint.force;
                assert!(
                    joint.joint_position >= -way - 1e-9 * RADIUS,
                    "{}",
                    joint.joint_position
                );
                if integrator == Integrator::Moreau && run.simulation.time() > fall + 3e-3 {
                    close(joint.force, mass * G + load, 1e-6, 0.0);
                    assert!((joint.joint_position + way).abs() < 1e-9);
                    assert!(run.simulation.boundary_twist(0).linear.norm() < 1e-6);
                }
            }
        }
    }
}

/// The penalty method's stop is a spring: the piston comes to rest `(m g + load)/P` beyond it.
#[test]
fn a_stop_under_penalty_gives_by_its_load() {
    let (mass, load, penalty, way) = (2.0, 37.0, 1e6, 0.0123);
    let mut piston = body(mass, Vec3::zeros(), Vec3::zeros(), SLIDE);
    piston.force = Vec3::z() * -load;
    piston.limits = [Some(-way), None];
    let mut run = bystander(Case::new(1e-3, 0.3, 0.0))
        .settings(|s| {
            s.method = Method::Penalty;
            s.penalty = Some(penalty);
        })
        .driven(ceiling(1.0), piston)
        .start();
    run.steps(600);
    let joint = run.simulation.joint(0);
    close(joint.force, mass * G + load, 1e-6, 0.0);
    close(
        -way - joint.joint_position,
        (mass * G + load) / penalty,
        1e-6,
        0.0,
    );
}

/// A tray lifts a sphere against its upper stop: sphere and tray feel `load - (M + m) g` there, and the sphere its weight.
#[test]
fn a_tray_that_carries_a_sphere_is_stopped_with_it() {
    for solver in SOLVERS {
        let (mass, load, way) = (2.0, 400.0, 0.01);
        let mut lift = body(mass, Vec3::zeros(), Vec3::zeros(), SLIDE);
        lift.force = Vec3::z() * load;
        lift.limits = [None, Some(way)];
        let mut run = Case::new(1e-3, 0.3, 0.0)
            .settings(|s| s.solver = solver)
            .tolerance(1e-9, 1e-9, 1e-9)
            .driven(tray(0.0), lift)
            .sphere(RADIUS, Vec3::z() * RADIUS, Vec3::zeros())
            .start();
        let m = run.mass(0);
        // Before the stop both rise with one acceleration.
        run.step();
        let rise = (load - (mass + m) * G) / (mass + m);
        close(-run.force_on_boundary(0).z, m * (G + rise), 1e-6, 0.0);
        assert_eq!(run.simulation.joint(0).force, 0.0);
        while run.simulation.time() < 0.6 {
            run.step();
            assert!(run.simulation.joint(0).joint_position <= way + 1e-9 * RADIUS);
        }
        let joint = run.simulation.joint(0);
        close(joint.force, (mass + m) * G - load, 1e-6, 0.0);
        close(-run.force_on_boundary(0).z, m * G, 1e-6, 0.0);
    }
}

/// A flap, its centre of mass `d` from the hinge, falls to its stop at 0.7 rad, which carries `m g d cos 0.7`.
#[test]
fn a_flap_rests_at_its_angle() {
    for solver in SOLVERS {
        let (mass, d, stop) = (1.5, 0.2, 0.7f64);
        let mut flap = body(mass, Vec3::x() * d, Vec3::repeat(0.02), HINGE);
        flap.limits = [Some(-0.1), Some(stop)];
        let mut run = bystander(Case::new(1e-3, 0.0, 0.0))
            .settings(|s| s.solver = solver)
            .tolerance(1e-9, 1e-9, 1e-9)
            .driven(tray(0.0), flap)
            .start();
        run.steps(600);
        let joint = run.simulation.joint(0);
        close(joint.joint_position, stop, 1e-9, 0.0);
        close(joint.force, -mass * G * d * stop.cos(), 1e-6, 0.0);
        assert!(run.simulation.boundary_twist(0).angular.norm() < 1e-6);
    }
}

/// Angles count whole turns: a wheel stops at 10 rad, and what it had is an impact's loss.
#[test]
fn a_wheel_turns_up_to_its_stop() {
    let (moment, spin, stop) = (0.02, 7.0, 10.0);
    let mut wheel = body(1.5, Vec3::zeros(), Vec3::repeat(moment), HINGE);
    wheel.twist.angular = Vec3::y() * spin;
    wheel.limits = [None, Some(stop)];
    let mut run = bystander(Case::new(1e-3, 0.0, 0.0))
        .without_gravity()
        .driven(tray(0.0), wheel)
        .start();
    let start = run.whole_energy().kinetic();
    for k in 1..2000 {
        run.step();
        let joint = run.simulation.joint(0);
        let expected = f64::min(spin * 1e-3 * f64::from(k), stop);
        assert!(
            (joint.joint_position - expected).abs() < 1e-9,
            "{}",
            joint.joint_position
        );
    }
    close(start, 0.5 * moment * spin * spin, 1e-12, 0.0);
    assert!(run.whole_energy().kinetic() < 1e-12 * start);
    let work = run.simulation.work();
    close(work.impact - work.numerical_work, start, 1e-9, 0.0);
    assert!(work.impact > 0.4 * start);
}

/// A mass on its joint's spring. A step is linear in the stretch, `x'' = tr x' - det x`, as for a constrained point
/// (row 17), with `a = w dt`, `w^2 = k/m` or `k/I`:
///
/// ```text
/// moreau  tr = 2/(1 + a^2),        det = 1/(1 + a^2)
/// shi     tr = (4 - a^2)/(2 + a^2), det = 2/(2 + a^2)
/// ```
/// so the period `2 pi dt/acos(tr/(2 sqrt det))` tends to `2 pi/w` in second order, the amplitude's loss in first.
#[test]
fn a_spring_has_its_period() {
    let (mass, moment, rest) = (2.0, 0.03, 0.05);
    for (joint, inertia, stiffness) in [(SLIDE, mass, 800.0), (HINGE, moment, 12.0)] {
        for integrator in [Integrator::Moreau, Integrator::Shi] {
            let errors = [4e-3, 2e-3, 1e-3].map(|dt| {
                let mut swing = body(mass, Vec3::zeros(), Vec3::repeat(moment), joint);
                swing.spring = Some(Spring { stiffness, rest });
                let mut run = bystander(Case::new(dt, 0.0, 0.0))
                    .without_gravity()
                    .settings(|s| s.integrator = integrator)
                    .tolerance(1e-12, 1e-12, 1e-12)
                    .driven(tray(0.0), swing)
                    .start();
                let stretch = |run: &Run| run.simulation.joint(0).joint_position - rest;
                let mut x = vec![stretch(&run)];
                for _ in 0..40 {
                    run.step();
                    x.push(stretch(&run));
                    let force = run.simulation.joint(0).force;
                    close(force, -stiffness * stretch(&run), 1e-9, stiffness * rest);
                }
                let a = (stiffness / inertia).sqrt() * dt;
                let (trace, det) = match integrator {
                    Integrator::Moreau => (2.0 / (1.0 + a * a), 1.0 / (1.0 + a * a)),
                    Integrator::Shi => ((4.0 - a * a) / (2.0 + a * a), 2.0 / (2.0 + a * a)),
                };
                for k in 1..39 {
                    close(x[k + 2], trace * x[k + 1] - det * x[k], 1e-9, rest);
                }
                // Trace and determinant as measured.
                let (p, q, r, s) = (x[1], x[2], x[3], x[4]);
                let (trace, det) = (
                    (q * r - p * s) / (q * q - p * r),
                    (r * r - q * s) / (q * q - p * r),
                );
                let period = a / (trace / (2.0 * det.sqrt())).acos();
                [(period - 1.0).abs(), 1.0 - det.sqrt().powf(1.0 / a)]
            });
            let [[coarse, _], [fine, loss], [finest, less]] = errors;
            assert!((order(coarse, fine, 2.0) - 2.0).abs() < 0.1, "{errors:?}");
            assert!((order(fine, finest, 2.0) - 2.0).abs() < 0.1, "{errors:?}");
            assert!((order(loss, less, 2.0) - 1.0).abs() < 0.1, "{errors:?}");
        }
    }
}
