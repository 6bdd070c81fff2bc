//! Rolling and twisting resistance: a couple of at most `mu_r R* p_n` against rolling, `mu_t R* p_n` against twisting.
//!
//! ```text
//!    v ->  o  w = v/R      m a = -F                       rolls: a = R dw/dt
//!        ----- <- F        2/5 m R a = F R - mu_r R m g   so     a = -5/7 mu_r g, F = 5/7 mu_r m g
//! ```
//! On a boundary `R* = R`, between spheres `R* = R_A R_B / (R_A + R_B)`.

use sphere_dda::Vec3;
use sphere_dda::geometry::HalfSpace;
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Motion;
use sphere_dda::scene::body::Joint;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Method, PointLoad};
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, body, close};

const RADIUS: f64 = 0.1;
const STEP: f64 = 1e-3;

fn on_incline(angle: f64, friction: f64, rolling: f64) -> (Run, Vec3) {
    let normal = Vec3::new(angle.sin(), 0.0, angle.cos());
    let down = Vec3::new(angle.cos(), 0.0, -angle.sin());
    let run = Case::new(STEP, friction, 0.0)
        .resistance(rolling, 0.0)
        .tolerance(1e-6, 1e-8, 1e-8)
        .plane(Vec3::zeros(), normal)
        .sphere(RADIUS, normal * RADIUS, Vec3::zeros())
        .start();
    (run, down)
}

/// A ball stays on an incline iff `tan a <= mu_r` (and `mu`): the couple `m g sin a R` of its weight about the contact
/// meets `mu_r R m g cos a`. It does not creep. Beyond, it rolls at `5/7 g (sin a - mu_r cos a)`.
#[test]
fn a_ball_stays_up_to_the_threshold() {
    let rolling: f64 = 0.1;
    for (factor, stays) in [(0.99, true), (1.01, false)] {
        let angle = (factor * rolling).atan();
        let (mut run, down) = on_incline(angle, 0.5, rolling);
        let start = run.position(0);
        let mass = run.mass(0);
        for _ in 0..1000 {
            run.step();
            let t = run.simulation.time();
            let expected = if stays {
                0.0
            } else {
                5.0 / 7.0 * G * (angle.sin() - rolling * angle.cos())
            };
            close(run.velocity(0).dot(&down), expected * t, 1e-6, 1e-3);
            close(run.spin(0).y * RADIUS, expected * t, 1e-6, 1e-3);
            let couple = if stays {
                mass * G * angle.sin()
            } else {
                rolling * mass * G * angle.cos()
            };
            let contact = run.simulation.contacts()[0];
            close(contact.torque.y, -couple * RADIUS, 1e-6, 0.0);
        }
        let travelled = (run.position(0) - start).norm();
        assert_eq!(travelled < 1e-9 * RADIUS, stays, "{travelled:e} m");
    }
}

/// Where friction is too weak to overcome the resistance (`mu < mu_r`) the ball slides like a block.
#[test]
fn a_ball_that_cannot_roll_slides() {
    let (angle, friction) = (0.08f64.atan(), 0.05);
    let (mut run, down) = on_incline(angle, friction, 0.1);
    run.steps(500);
    let acceleration = G * (angle.sin() - friction * angle.cos());
    close(run.velocity(0).dot(&down), acceleration * 0.5, 1e-6, 0.0);
    assert!(run.spin(0).norm() < 1e-9);
}

fn rolling(speed: f64, resistance: f64) -> Case {
    let (centre, velocity) = (Vec3::z() * RADIUS, Vec3::x() * speed);
    let spin = Vec3::y() * (speed / RADIUS);
    Case::new(STEP, 0.5, 0.0)
        .resistance(resistance, 0.0)
        .tolerance(1e-6, 1e-8, 1e-8)
        .floor()
        .body(RADIUS, centre, velocity, spin, Locks::default())
}

/// Rolls out after `7 v0^2/(10 mu_r g)`, and then lies still; all its energy `7/10 m v0^2` is lost.
#[test]
fn a_ball_rolls_out() {
    let (speed, resistance) = (1.0, 0.05);
    let acceleration = 5.0 / 7.0 * resistance * G;
    let mut run = rolling(speed, resistance).start();
    let mass = run.mass(0);
    for _ in 0..3000 {
        run.step();
        let t = run.simulation.time();
        if t < speed / acceleration - STEP {
            close(run.velocity(0).x, speed - acceleration * t, 1e-9, speed);
            close(run.spin(0).y * RADIUS, run.velocity(0).x, 1e-9, speed);
            close(
                run.force_on_boundary(0).x,
                5.0 / 7.0 * resistance * mass * G,
                1e-6,
                0.0,
            );
            // About the origin: the couple and the weight ahead of it.
            let torque = run.simulation.wrench(0).torque.y;
            let lever = run.position(0).x - STEP * run.velocity(0).x;
            close(torque, mass * G * (resistance * RADIUS + lever), 1e-3, 0.0);
        } else if t > speed / acceleration + 2.0 * STEP {
            assert!(run.velocity(0).norm() < 1e-9 && run.spin(0).norm() * RADIUS < 1e-9);
        }
    }
    let distance = 0.7 * speed * speed / (resistance * G);
    close(distance, 1.427115, 1e-6, 0.0);
    close(run.position(0).x, distance, 1e-6, 0.0);
    // The ledger closes.
    let lost = 0.7 * mass * speed * speed;
    let work = run.simulation.work();
    close(work.dissipated() - work.numerical_work, lost, 1e-6, 0.0);
    close(work.dissipated(), lost, 1e-6, 0.0);
}

/// A ball that spins on the spot loses `5/2 mu_t g/R` of its spin a second and stops after `2 R w0/(5 mu_t g)`; the
/// floor feels the couple `mu_t R m g`. On a plate that turns it takes the plate's spin instead.
#[test]
fn a_spinning_ball_stops_or_takes_the_spin_of_its_plate() {
    let (twisting, spin) = (0.02, 4.0);
    let rate = 2.5 * twisting * G / RADIUS;
    for turning in [0.0, 1.5] {
        let mut case = Case::new(STEP, 0.5, 0.0)
            .resistance(0.3, twisting)
            .tolerance(1e-6, 1e-8, 1e-8)
            .floor()
            .body(
                RADIUS,
                Vec3::z() * RADIUS,
                Vec3::zeros(),
                Vec3::z() * spin,
                Locks::default(),
            );
        case.scene.boundaries[0].motion = Motion::Constant(Twist {
            angular: Vec3::z() * turning,
            ..Twist::default()
        });
        let mut run = case.start();
        let mass = run.mass(0);
        let time = (spin - turning) / rate;
        while run.simulation.time() < 1.1 {
            run.step();
            let t = run.simulation.time();
            if t < time - STEP {
                close(run.spin(0).z, spin - rate * t, 1e-9, spin);
                let couple = run.simulation.wrench(0).torque.z;
                close(couple, twisting * RADIUS * mass * G, 1e-9, 0.0);
            } else if t > time + 2.0 * STEP {
                close(run.spin(0).z, turning, 1e-9, 1.0);
            }
        }
        assert!(time < 1.0 && run.velocity(0).norm() < 1e-9);
    }
}

/// A ball that spins on a turntable (moment of inertia `J`, free about the vertical) drags it along with the couple
/// `mu_t R m g` until both turn at `I w0/(I + J)`: the angular momentum about the axis stays.
#[test]
fn a_turntable_is_dragged_along() {
    let (twisting, spin, moment) = (0.02, 4.0, 0.02);
    let hinge = Joint::Hinge { axis: Vec3::z() };
    for solver in [
        SolverKind::Auto,
        SolverKind::Direct,
        SolverKind::GaussSeidel,
    ] {
        let top = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
        let mut run = Case::new(STEP, 0.5, 0.0)
            .resistance(0.0, twisting)
            .tolerance(1e-6, 1e-8, 1e-8)
            .settings(|s| s.solver = solver)
            .driven(
                vec![top.into()],
                body(5.0, Vec3::zeros(), Vec3::repeat(moment), hinge),
            )
            .body(
                RADIUS,
                Vec3::z() * RADIUS,
                Vec3::zeros(),
                Vec3::z() * spin,
                Locks::default(),
            )
            .start();
        let couple = twisting * RADIUS * run.mass(0) * G;
        let inertia = 0.4 * run.mass(0) * RADIUS * RADIUS;
        let common = inertia * spin / (inertia + moment);
        let time = (spin - common) * inertia / couple;
        while run.simulation.time() < 2.0 * time {
            run.simulation.advance(STEP).unwrap();
            let t = run.simulation.time();
            let turning = run.simulation.boundary_twist(0).angular.z;
            if t < time - STEP {
                close(run.spin(0).z, spin - couple / inertia * t, 1e-8, spin);
                close(turning, couple / moment * t, 1e-8, spin);
            } else if t > time + 2.0 * STEP {
                close(run.spin(0).z, common, 1e-8, spin);
                close(turning, common, 1e-8, spin);
            }
        }
        // The energy of the relative spin is lost, to the square of what half a step takes of it (3.6e-6 at most); nothing
        // is left for dampers.
        let reduced = inertia * moment / (inertia + moment);
        let work = run.simulation.work();
        close(work.dissipated(), 0.5 * reduced * spin * spin, 3.6e-6, 0.0);
        close(work.dampers, 0.0, 1e-9, work.dissipated());
    }
}

/// Two spheres that meet head-on without friction, `p_n = m_A m_B/(m_A + m_B) v`: spin across the normal and along it
/// changes by `mu R* p_n / I` each, or until both turn alike; the sum `I_A w_A + I_B w_B` stays.
#[test]
fn spheres_exchange_spin() {
    let (ra, rb, speed) = (0.1, 0.15, 2.0);
    let (roll, twist) = (Vec3::z(), Vec3::x());
    for (resistance, limited) in [(0.02, true), (50.0, false)] {
        let spins = [roll * 30.0 + twist * 20.0, roll * -10.0];
        let mut run = Case::new(STEP, 0.0, 0.0)
            .without_gravity()
            .resistance(resistance, 0.5 * resistance)
            .tolerance(1e-9, 1e-12, 1e-12)
            .body(
                ra,
                Vec3::x() * -(ra + 5e-4),
                Vec3::x() * speed,
                spins[0],
                Locks::default(),
            )
            .body(
                rb,
                Vec3::x() * (rb + 5e-4),
                Vec3::zeros(),
                spins[1],
                Locks::default(),
            )
            .start();
        let particles = &run.simulation.scene().particles;
        let [ma, mb] = [0, 1].map(|i| particles.mass[i]);
        let [ia, ib] = [0, 1].map(|i| particles.inertia(i));
        let impulse = ma * mb / (ma + mb) * speed * resistance * ra * rb / (ra + rb);
        let expected = if limited {
            let couple = roll * impulse + twist * (0.5 * impulse);
            [spins[0] - couple / ia, spins[1] + couple / ib]
        } else {
            [(spins[0] * ia + spins[1] * ib) / (ia + ib); 2]
        };
        run.steps(5);
        for (i, expected) in expected.iter().enumerate() {
            let error = (run.spin(i) - expected).norm();
            assert!(error < 1e-7, "{:?} {expected:?}", run.spin(i));
        }
        let total = run.spin(0) * ia + run.spin(1) * ib - spins[0] * ia - spins[1] * ib;
        assert!(total.norm() < 1e-12 * (ia + ib) * 30.0);
        close((run.velocity(0) - run.velocity(1)).norm(), 0.0, 1e-9, speed);
    }
}

/// A contact that joins while the step is solved (sphere 1 knocks sphere 0, which nothing moved before, onto the wall)
/// stands before that of sphere 2, whose resistance stays its own: pressed by `f` it loses `5/2 mu_t f dt/(m R)` of its spin.
#[test]
fn a_late_contact_leaves_resistances_with_their_contacts() {
    let (twisting, press, spin) = (0.02, 50.0, 4.0);
    let mut case = Case::new(STEP, 0.0, 0.0)
        .without_gravity()
        .resistance(0.0, twisting)
        .tolerance(1e-6, 1e-8, 1e-8)
        .plane(Vec3::x() * (-1.005 * RADIUS), Vec3::x())
        .floor()
        .sphere(RADIUS, Vec3::z(), Vec3::zeros())
        .sphere(
            RADIUS,
            Vec3::new(2.0 * RADIUS + 1e-6, 0.0, 1.0),
            Vec3::x() * -2.0,
        )
        .body(
            RADIUS,
            Vec3::new(1.0, 0.0, RADIUS),
            Vec3::zeros(),
            Vec3::z() * spin,
            Locks::default(),
        );
    case.scene.loads.push(PointLoad {
        sphere: 2,
        arm: Vec3::zeros(),
        force: Vec3::z() * -press,
    });
    let mut run = case.start();
    run.simulation.advance(STEP).unwrap();
    let contacts = run.simulation.contacts();
    let spheres: Vec<u32> = contacts.iter().map(|contact| contact.key.sphere).collect();
    assert_eq!(spheres, [0, 0, 2], "the wall stopped sphere 0");
    let couple = twisting * RADIUS * press;
    close(contacts[2].torque.z, -couple, 1e-9, 0.0);
    let lost = couple / (0.4 * run.mass(2) * RADIUS * RADIUS) * STEP;
    close(run.spin(2).z, spin - lost, 1e-9, 0.0);
}

/// A pile falls together: friction, impacts and resistance take energy in every step and give none; at the end it rests.
#[test]
fn a_pile_only_loses_energy() {
    for solver in [SolverKind::Auto, SolverKind::Direct] {
        let mut case = Case::new(STEP, 0.4, 0.0)
            .resistance(0.4, 0.05)
            .settings(|s| s.solver = solver)
            .floor();
        for k in 0..12 {
            let turn = 2.4 * f64::from(k);
            let centre = Vec3::new(
                0.08 * turn.cos(),
                0.08 * turn.sin(),
                0.11 + 0.09 * f64::from(k),
            );
            let spin = Vec3::new(turn.sin(), 0.3, turn.cos()) * 20.0;
            case = case.body(
                0.05 + 0.002 * f64::from(k % 5),
                centre,
                Vec3::zeros(),
                spin,
                Locks::default(),
            );
        }
        let mut run = case.start();
        let weight: f64 = (0..12).map(|i| run.mass(i) * G).sum();
        let mut lost = 0.0;
        for _ in 0..1500 {
            run.step();
            let work = run.simulation.work();
            // What the tolerance lets a sticking contact slip, under the whole weight.
            let slack = 1e-6 * 0.05 * weight;
            let gained = lost - work.dissipated();
            assert!(gained <= slack, "{gained:e} J of {slack:e} J");
            lost = work.dissipated();
        }
        let fastest = (0..12).map(|i| run.velocity(i).norm()).fold(0.0, f64::max);
        assert!(fastest < 1e-3, "{fastest} m/s");
    }
}

/// Contact springs and the paper's integrator carry resistance too: the ball rolls out within the springs' and the
/// step's error. `shi` reverses what is left of the speed in the last step, as it does with all friction.
#[test]
fn springs_and_the_papers_integrator_resist() {
    let (speed, resistance) = (1.0, 0.1);
    let distance = 0.7 * speed * speed / (resistance * G);
    for method in [Method::Alm, Method::Penalty] {
        for integrator in [Integrator::Moreau, Integrator::Shi] {
            let case = rolling(speed, resistance).settings(|s| {
                s.method = method;
                s.integrator = integrator;
                s.penalty = Some(1e6);
            });
            let mut run = case.start();
            run.steps(1600);
            close(run.position(0).x, distance, 1e-2, 0.0);
            assert!(
                run.velocity(0).x.abs() < 1e-2,
                "{method:?} {integrator:?} {:?}",
                run.velocity(0)
            );
        }
    }
}
