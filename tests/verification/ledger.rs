//! The energy ledger: kinetic energy changes by the work of gravity and boundaries, less friction and impact, plus a residue
//! that is named, and that vanishes with dt.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, HalfSpace, Revolution, Shape};
use sphere_dda::scene::Motion;
use sphere_dda::scene::body::{Area, Joint, Servo, Spring};
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, body, close, grid, order};

const RADIUS: f64 = 0.1;

/// What the ledger leaves open of the change of energy since `start` \[J\].
fn open(run: &Run, start: f64) -> f64 {
    let work = run.simulation.work();
    run.energy() - start - work.boundaries + work.friction + work.impact - work.numerical_work
}

/// Row 11's sphere slides until it rolls: friction takes `1/2 m v0^2 - 7/10 m (5/7 v0)^2 = 1/7 m v0^2`, all else is nothing.
#[test]
fn friction_takes_a_seventh() {
    let (mu, v0) = (0.2, 2.0);
    let residue = |dt: f64| {
        let mut run = Case::new(dt, mu, 0.0)
            .tolerance(1e-6, 1e-9, 1e-9)
            .floor()
            .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS), Vec3::x() * v0)
            .start();
        let start = run.energy();
        while run.simulation.time() < 0.4 {
            run.step();
            assert!(open(&run, start).abs() < 1e-9 * start);
        }
        let scale = run.mass(0) * v0 * v0;
        close(run.simulation.work().friction, scale / 7.0, 1e-3, 0.0);
        assert_eq!(run.simulation.work().impact, 0.0);
        run.simulation.work().numerical_work.abs() / scale
    };
    // Only the step in which slip ends leaves something: less than (mu g dt)^2/v0^2 and its share of a step.
    assert!(residue(1e-3) < 1e-5);
}

/// An impact on a wall, zero gravity, frictionless: it takes `(1 - e^2) m u_n^2/2`, the residue is zero.
#[test]
fn an_impact_takes_its_share() {
    for e in [0.0, 0.4, 1.0] {
        let mut run = Case::new(1e-3, 0.0, e)
            .without_gravity()
            .tolerance(1e-12, 1e-12, 1e-12)
            .floor()
            .sphere(
                RADIUS,
                Vec3::new(0.0, 0.0, RADIUS + 0.0103),
                Vec3::new(1.0, 0.0, -3.0),
            )
            .start();
        let start = run.energy();
        run.steps(20);
        let work = *run.simulation.work();
        let scale = run.mass(0) * 9.0 / 2.0;
        // With e = 0 it lands on the wall within the step, as if it had arrived with its speed.
        if e > 0.0 {
            close(work.impact, (1.0 - e * e) * scale, 1e-9, scale);
            close(work.numerical_work, 0.0, 1e-12, scale);
        }
        assert!(open(&run, start).abs() < 1e-12 * scale);
        close(start - run.energy(), (1.0 - e * e) * scale, 1e-9, scale);
    }
}

/// A wall that moves with V towards a sphere at rest throws it to `(1 + e) V`: its work is `m (1 + e) V^2`, the impact's
/// loss `(1 - e^2) m V^2/2`, and the sphere has `m (1 + e)^2 V^2/2`.
#[test]
fn a_moving_wall_does_work() {
    let (e, speed) = (0.5, 2.0);
    let up = Motion::Constant(Twist {
        linear: Vec3::z() * speed,
        angular: Vec3::zeros(),
    });
    let plane = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
    let mut run = Case::new(1e-3, 0.3, e)
        .without_gravity()
        .tolerance(1e-12, 1e-12, 1e-12)
        .moving(vec![plane.into()], up)
        .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS + 0.0103), Vec3::zeros())
        .start();
    run.steps(20);
    let (work, scale) = (*run.simulation.work(), run.mass(0) * speed * speed);
    close(work.boundaries, (1.0 + e) * scale, 1e-9, 0.0);
    close(work.impact, 0.5 * (1.0 - e * e) * scale, 1e-9, 0.0);
    close(run.kinetic(), 0.5 * (1.0 + e).powi(2) * scale, 1e-9, 0.0);
    close(work.numerical_work, 0.0, 1e-12, scale);
}

/// Bouncing and rolling to rest under gravity: the ledger closes to rounding in every step, and time stepping adds or takes
/// next to nothing, although impacts happen at nodes.
#[test]
fn the_ledger_closes_while_a_sphere_bounces_to_rest() {
    for phase in 0..8 {
        let drop = 0.3 + 2e-3 * f64::from(phase);
        let mut run = Case::new(1e-3, 0.2, 0.6)
            .floor()
            .sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS + drop), Vec3::x())
            .start();
        let start = run.energy();
        let scale = run.mass(0) * G * drop;
        while run.simulation.time() < 2.0 {
            run.step();
            assert!(open(&run, start).abs() < 1e-9 * start);
            let residue = run.simulation.work().numerical_work / scale;
            assert!(
                residue.abs() < 2e-2,
                "{residue:e} at {} s",
                run.simulation.time()
            );
        }
        let work = run.simulation.work();
        assert!(
            work.numerical_work.abs() < 1e-3 * scale,
            "{:e}",
            work.numerical_work / scale
        );
        assert!(work.impact > 0.5 * scale && work.friction > 0.0);
    }
}

/// A frictionless sphere swings in a trough: normals turn within the step and gaps are re-linearised. The residue is all the
/// change of energy there is, and of second order in dt.
#[test]
fn the_residue_on_a_curved_path_is_of_second_order() {
    let (hollow, axis, start) = (1.0, Vec3::new(0.0, 1.0, 0.0), 60f64.to_radians());
    let residue = |dt: f64| {
        let trough = Revolution::cylinder(-axis, axis, hollow, 2.0).expect("a trough");
        let x = Vec3::new(start.sin(), 0.0, -start.cos()) * (hollow - RADIUS);
        let mut run = Case::new(dt, 0.0, 0.0)
            .tolerance(1e-11, 1e-11, 1e-11)
            .wall(vec![trough.into()])
            .sphere(RADIUS, x, Vec3::zeros())
            .start();
        let start = run.energy();
        let mut worst = 0.0f64;
        while run.simulation.time() < 2.0 {
            run.step();
            assert!(open(&run, start).abs() < 1e-9 * start.abs());
            worst = worst.max(run.simulation.work().numerical_work.abs());
        }
        worst / (run.mass(0) * G * hollow)
    };
    let (coarse, fine) = (residue(4e-3), residue(1e-3));
    let found = order(coarse, fine, 4.0);
    assert!(
        (found - 2.0).abs() < 0.3,
        "order {found}: {coarse:e} {fine:e}"
    );
}

/// What the ledger leaves open of the change of the energy of spheres and driven bodies; springs do work.
fn open_with_bodies(run: &Run, start: f64) -> f64 {
    let (work, energy) = (run.simulation.work(), run.whole_energy());
    let gained = work.boundaries
        + work.loads
        + work.dampers
        + work.springs
        + work.contacts
        + work.numerical_work;
    energy.kinetic() + energy.gravity - start - gained + work.friction + work.impact
}

/// A loaded piston on a spring with a damper falls on a sphere, which it drives down to where the spring's stop holds it up again:
/// the ledger closes in every step.
#[test]
fn the_ledger_closes_with_a_piston() {
    let axis = Vec3::z();
    let mut piston = body(1.5, Vec3::zeros(), Vec3::zeros(), Joint::Slide { axis });
    piston.force = Vec3::z() * -90.0;
    piston.damping[0] = 2.0;
    piston.spring = Some(Spring {
        stiffness: 900.0,
        rest: 0.02,
    });
    piston.limits = [Some(-0.095), Some(0.03)];
    let lid = HalfSpace::new(Vec3::z() * 0.3, -Vec3::z()).expect("a plane");
    let mut run = Case::new(1e-3, 0.2, 0.6)
        .floor()
        .driven(vec![lid.into()], piston)
        .sphere(RADIUS, Vec3::z() * 0.13, Vec3::x())
        .start();
    let start = run.whole_energy();
    let start = start.kinetic() + start.gravity;
    let mut touched = false;
    for _ in 0..1000 {
        run.step();
        touched |= run.force_on_boundary(1).z > 0.0;
        let left = open_with_bodies(&run, start);
        assert!(left.abs() < 1e-9 * start, "{left:e}");
    }
    let work = run.simulation.work();
    assert!(touched && work.impact > 0.0 && work.dampers < 0.0 && work.springs != 0.0);
}

fn plate(low: Vec3, u: Vec3, v: Vec3) -> Vec<Shape> {
    vec![Facets::rectangle(low, u, v).expect("a face").into()]
}

/// Runs `case`: the ledger closes in every step, and what it calls a residue is small.
fn closes(case: Case) -> Run {
    let mut run = case.start();
    let start = run.whole_energy();
    let start = start.kinetic() + start.gravity;
    let mut scale = 0.0f64;
    for _ in 0..600 {
        run.step();
        scale = scale.max(start.abs() + run.simulation.work().loads.abs());
        let left = open_with_bodies(&run, start);
        assert!(left.abs() < 1e-9 * scale, "{left:e} of {scale:e}");
    }
    let work = run.simulation.work();
    assert!(work.impact > 0.0 && work.loads > 0.0 && work.friction > 0.0);
    assert!(
        work.numerical_work.abs() < 0.02 * scale,
        "{:e}",
        work.numerical_work
    );
    run
}

/// A free plate with a load off its centre falls on three spheres and tilts.
#[test]
fn the_ledger_closes_with_a_free_plate() {
    let moments = Vec3::new(0.05, 0.06, 0.1);
    let mut body = body(1.5, Vec3::z() * 0.3, moments, Joint::Free);
    body.force = Vec3::new(1.0, 0.0, -20.0);
    let low = Vec3::new(-0.5, -0.5, 0.3);
    let mut case = Case::new(1e-3, 0.3, 0.2)
        .floor()
        .driven(plate(low, Vec3::x(), Vec3::y()), body);
    for k in 0..3 {
        let angle = 2.1 * f64::from(k);
        let place = Vec3::new(0.3 * angle.cos(), 0.3 * angle.sin(), RADIUS);
        case = case.sphere(RADIUS, place, Vec3::zeros());
    }
    closes(case);
}

/// A servo wall presses two spheres against a wall: its work is pressure times area times way.
#[test]
fn the_ledger_closes_with_a_servo_wall() {
    let (pressure, area, axis) = (300.0, 0.5, Vec3::x());
    let mut wall = body(1.0, Vec3::zeros(), Vec3::zeros(), Joint::Slide { axis });
    wall.servo = Some(Servo {
        pressure,
        area: Area::Constant(area),
        input: false,
    });
    wall.damping[0] = 5.0;
    let low = Vec3::new(0.0, -0.5, -0.5);
    let mut case = Case::new(1e-3, 0.3, 0.2)
        .without_gravity()
        .plane(axis * 0.6, -axis)
        .driven(plate(low, Vec3::y(), Vec3::z()), wall);
    for k in 0..2 {
        let place = Vec3::new(0.13, 0.04, 0.0) + Vec3::new(0.24, -0.06, 0.0) * f64::from(k);
        case = case.sphere(RADIUS, place, Vec3::zeros());
    }
    let run = closes(case);
    // Work counts mean velocities of steps, half a step behind the way, from rest at t = 0 to rest: of mass 1 kg, half a
    // step before t = 0, `-f dt/2` but for the damper's `c dt/m` of it.
    let (dt, force) = (1e-3, pressure * area);
    assert!(run.simulation.boundary_twist(1).linear.norm() < 1e-9);
    let way = run.simulation.joint(1).joint_position - 0.5 * dt * (0.5 * dt * force);
    close(run.simulation.work().loads, force * way, 1e-6, 0.0);
}

/// A frictionless sphere in a bucket that swings on a hinge: no force but weight does work, and the residue is of second order.
#[test]
fn the_residue_in_a_swinging_bucket_is_of_second_order() {
    let residue = |dt: f64| {
        let trough = grid(64, 1, |i, j| {
            let angle = (f64::from(i) / 64.0 - 0.5) * std::f64::consts::PI;
            let y = f64::from(j) - 0.5;
            Vec3::new(angle.sin(), y, -angle.cos())
        });
        let mut bucket = body(
            20.0,
            Vec3::z() * -0.9,
            Vec3::repeat(2.0),
            Joint::Hinge { axis: Vec3::y() },
        );
        bucket.twist.angular = Vec3::y() * 0.8;
        let mut run = Case::new(dt, 0.0, 0.0)
            .tolerance(1e-11, 1e-11, 1e-11)
            .driven(vec![trough.into()], bucket)
            .sphere(RADIUS, Vec3::z() * (RADIUS - 0.999), Vec3::zeros())
            .start();
        let start = run.whole_energy();
        let start = start.kinetic() + start.gravity;
        let mut worst = 0.0f64;
        while run.simulation.time() < 1.0 {
            run.step();
            let left = open_with_bodies(&run, start);
            assert!(left.abs() < 1e-9 * start.abs(), "{left:e}");
            worst = worst.max(run.simulation.work().numerical_work.abs());
        }
        worst / start.abs()
    };
    let (coarse, fine) = (residue(4e-3), residue(1e-3));
    let found = order(coarse, fine, 4.0);
    assert!(
        (found - 2.0).abs() < 0.3,
        "order {found}: {coarse:e} {fine:e}"
    );
}
