//! Driven bodies: boundaries moved by force, against closed forms of statics, impact and rigid-body motion.

use nalgebra::{Matrix3, UnitQuaternion};
use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, HalfSpace, Shape};
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Command;
use sphere_dda::scene::body::{Area, Joint, Servo};
use sphere_dda::scene::particles::Locks;
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, body, close};

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

fn lid(z: f64) -> Vec<Shape> {
    let plane = HalfSpace::new(Vec3::new(0.0, 0.0, z), -Vec3::z());
    vec![plane.expect("a plane").into()]
}

fn plate(low: [f64; 2], high: [f64; 2], z: f64) -> Vec<Shape> {
    let (u, v) = (
        Vec3::x() * (high[0] - low[0]),
        Vec3::y() * (high[1] - low[1]),
    );
    let plate = Facets::rectangle(Vec3::new(low[0], low[1], z), u, v);
    vec![plate.expect("a rectangle").into()]
}

/// A sphere that nothing moves.
fn anchored(case: Case, radius: f64, position: Vec3) -> Case {
    let locks = Locks {
        translation: [true; 3],
        rotation: [true; 3],
    };
    case.body(radius, position, Vec3::zeros(), Vec3::zeros(), locks)
}

/// A piston of mass M on a column of n spheres, pressed down by F: the k-th sphere from the top carries
/// `F + M g + k m g`, from t = 0 on.
#[test]
fn a_piston_presses_with_its_load_and_weight() {
    let (radius, n, force) = (0.1, 4, 37.0);
    for solver in SOLVERS {
        for ratio in [1e-3, 1.0, 1e3] {
            if ratio > 1.0 && solver == SolverKind::GaussSeidel {
                // Sweeps alone crawl under a heavy body.
                continue;
            }
            let sphere = 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * f64::powi(radius, 3);
            let mut piston = body(ratio * sphere, Vec3::zeros(), Vec3::zeros(), SLIDE);
            piston.force = Vec3::new(3.0, 0.0, -force);
            let mut case = Case::new(1e-3, 0.3, 0.5)
                .settings(|s| s.solver = solver)
                // A correction of the sphere's own impulse moves the piston M/m times less: the force needs that much more.
                .tolerance(1e-9, 1e-9, 1e-8 / f64::max(ratio, 1.0))
                .floor()
                .driven(lid(2.0 * radius * f64::from(n)), piston);
            for k in 0..n {
                let z = radius * f64::from(2 * k + 1);
                case = case.sphere(radius, Vec3::new(0.0, 0.0, z), Vec3::zeros());
            }
            let mut run = case.start();
            for _ in 0..20 {
                let pressed = force + ratio * sphere * G;
                close(run.force_on_boundary(1).z, pressed, 1e-6, 0.0);
                let weights = sphere * G * f64::from(n);
                close(-run.force_on_boundary(0).z, pressed + weights, 1e-6, 0.0);
                run.step();
            }
            let height = run.simulation.boundary_pose(1).translation;
            assert!(height.norm() < 1e-7 * radius, "{height:?}");
            assert!(run.simulation.boundary_twist(1).linear.norm() < 1e-5 * G * 1e-3 * n as f64);
        }
    }
}

/// A plate thrown without anything in its way: `x0 + v0 t + (g + f/M) t^2/2` at the nodes, for steps of any length, and
/// a constant spin about a principal axis.
#[test]
fn a_free_plate_flies_as_thrown() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let mut thrown = body(
            3.0,
            Vec3::new(0.1, 0.0, 0.0),
            Vec3::new(1.0, 2.0, 3.0),
            Joint::Free,
        );
        thrown.twist.angular = Vec3::new(0.0, 0.0, 2.0);
        let v0 = Vec3::new(1.0, -2.0, 4.0);
        // The point of action at the origin goes round the centre of mass.
        thrown.twist.linear = v0 - thrown.twist.angular.cross(&thrown.centre);
        let mut run = anchored(Case::new(1e-2, 0.0, 0.0), 0.1, Vec3::x() * 50.0)
            .settings(|s| s.integrator = integrator)
            .driven(plate([0.0; 2], [1.0; 2], 0.0), thrown)
            .start();
        for h in [0.01, 0.007, 0.003, 0.01, 0.009].iter().cycle().take(100) {
            run.advance(*h);
            let t = run.simulation.time();
            let pose = run.simulation.boundary_pose(0);
            let centre = pose.apply(Vec3::zeros(), Vec3::new(0.1, 0.0, 0.0));
            let expected = Vec3::new(0.1, 0.0, 0.0) + v0 * t - Vec3::z() * (0.5 * G * t * t);
            assert!((centre - expected).norm() < 1e-12 * (1.0 + expected.norm()));
            let turned = UnitQuaternion::from_scaled_axis(Vec3::z() * (2.0 * t));
            assert!(pose.rotation.angle_to(&turned) < 1e-7);
            let twist = run.simulation.boundary_twist(0);
            let velocity = twist.linear + twist.angular.cross(&(centre - pose.translation));
            let fallen = v0 - Vec3::z() * (G * t);
            assert!((velocity - fallen).norm() < 1e-11, "{velocity:?}");
        }
    }
}

/// A damped piston under a constant force F: `v = F/c (1 - exp(-c t/M))` exactly, however stiff the damper.
#[test]
fn a_damper_slows_as_its_exponential() {
    for c in [1.0, 50.0, 1e7] {
        let mut piston = body(2.0, Vec3::zeros(), Vec3::zeros(), SLIDE);
        piston.force = Vec3::z() * 6.0;
        piston.damping[0] = c;
        piston.gravity = false;
        let mut run = anchored(Case::new(1e-2, 0.0, 0.0), 0.1, Vec3::x() * 50.0)
            .driven(lid(1.0), piston)
            .start();
        // The integrator's velocity is that of the half step.
        let half = |k: i32| (f64::from(k) - 0.5) * 1e-2;
        let exact = |t: f64| 6.0 / c * -(-c * t / 2.0).exp_m1();
        run.step();
        let mut first = run.simulation.state().bodies[0].velocity.linear.z;
        for k in 2..40 {
            run.step();
            let now = run.simulation.state().bodies[0].velocity.linear.z;
            let growth = (6.0 / c - now) - (6.0 / c - first) * (-c * 1e-2 / 2.0).exp();
            assert!(growth.abs() <= 1e-13 * 6.0 / c, "{c}: {growth:e}");
            first = now;
            if c < 10.0 {
                close(now, exact(half(k)), 1e-3, 0.0);
            }
        }
        let work = run.simulation.work();
        let kinetic = 0.5 * 2.0 * first * first;
        assert!(work.dampers < 0.0);
        close(work.loads + work.dampers, kinetic, 1e-2, work.loads);
    }
}

/// Swing: a box on a hinge, its centre of mass `d` below. `T = 4 K(sin(th0/2)) sqrt(I/(m g d))` with the moment `I` about the
/// hinge and the complete elliptic integral `K` (arithmetic-geometric mean); the error falls with dt^2.
#[test]
fn a_swing_has_its_period_at_any_amplitude() {
    let (mass, d, own) = (5.0, 0.7, 0.4);
    let inertia = own + mass * d * d;
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        for amplitude in [0.02f64, 2.0] {
            let (mut a, mut g) = (1.0, (0.5 * amplitude).cos());
            for _ in 0..8 {
                (a, g) = (0.5 * (a + g), f64::sqrt(a * g));
            }
            let period = std::f64::consts::TAU / a * (inertia / (mass * G * d)).sqrt();
            let error = |dt: f64| {
                let start = UnitQuaternion::from_scaled_axis(Vec3::y() * amplitude);
                let mut swing = body(mass, -Vec3::z() * d, Vec3::repeat(own), HINGE);
                swing.pose.rotation = start;
                let mut run = anchored(Case::new(dt, 0.0, 0.0), 0.1, Vec3::x() * 50.0)
                    .settings(|s| s.integrator = integrator)
                    .driven(plate([-0.1; 2], [0.1; 2], -d), swing)
                    .start();
                (measured_period(&mut run, dt) / period - 1.0).abs()
            };
            let errors = [4e-2, 2e-2, 1e-2].map(error);
            for pair in errors.windows(2) {
                let order = (pair[0] / pair[1]).log2();
                assert!(
                    (1.8..2.2).contains(&order),
                    "{integrator:?} {amplitude}: {errors:?}"
                );
            }
            assert!(errors[2] < 1e-3, "{errors:?}");
        }
    }
}

/// Time between the first and the fifth downward passage of the lowest point, over two.
fn measured_period(run: &mut Run, dt: f64) -> f64 {
    let angle = |run: &Run| run.simulation.boundary_pose(0).rotation_vector().y;
    let speed = |run: &Run| run.simulation.boundary_twist(0).angular.y;
    let mut passages = Vec::new();
    while passages.len() < 5 {
        let (a, va, t) = (angle(run), speed(run), run.simulation.time());
        run.advance(dt);
        let (b, vb) = (angle(run), speed(run));
        if a * b < 0.0 && (a - b).abs() < 1.0 {
            // Root of the cubic through both angles and speeds, by bisection.
            let cubic = |s: f64| {
                let (h, m) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
                a + (b - a) * h + dt * (va * s * (1.0 - s) * (1.0 - s) + vb * m)
            };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if cubic(middle) * a > 0.0 {
                    low = middle
                } else {
                    high = middle
                }
            }
            passages.push(t + low * dt);
        }
    }
    (passages[4] - passages[0]) / 2.0
}

/// Symmetric top without forces, moments (A, A, C): it precesses about its angular momentum with |L|/A while it turns about
/// its axis with `w_3 (A - C)/A`: `Q(t) = exp(L t/A) Q_0 exp(e_3 w_3 (1 - C/A) t)`. Momentum to rounding, attitude to dt^2.
#[test]
fn a_free_top_precesses_and_keeps_its_momentum() {
    let (a, c) = (2.0, 3.5);
    let spin = Vec3::new(1.0, 0.5, 4.0);
    let momentum = Vec3::new(a * spin.x, a * spin.y, c * spin.z);
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let error = |dt: f64| {
            let mut top = body(1.0, Vec3::zeros(), Vec3::new(a, a, c), Joint::Free);
            top.twist.angular = spin;
            let mut run = anchored(Case::new(dt, 0.0, 0.0), 0.1, Vec3::x() * 50.0)
                .settings(|s| s.integrator = integrator)
                .without_gravity()
                .driven(plate([-0.1; 2], [0.1; 2], 0.0), top)
                .start();
            for _ in 0..(2.0 / dt).round() as usize {
                run.step();
                let kept = run.simulation.state().bodies[0].momentum.angular;
                assert!((kept - momentum).norm() <= 1e-12 * momentum.norm());
            }
            let t = run.simulation.time();
            let own = UnitQuaternion::from_scaled_axis(Vec3::z() * (spin.z * (1.0 - c / a) * t));
            let exact = UnitQuaternion::from_scaled_axis(momentum * (t / a)) * own;
            let pose = run.simulation.boundary_pose(0);
            (pose.rotation.inverse() * exact).scaled_axis().norm()
        };
        let errors = [2e-2, 1e-2, 5e-3].map(error);
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((1.8..2.2).contains(&order), "{integrator:?}: {errors:?}");
        }
    }
}

/// A sphere of mass m strikes a free plate (mass M, moments J) at `r` from its centre with speed v, restitution e, without
/// friction: impulse `P = (1 + e) v / (1/m + 1/M + (r x n).J^-1 (r x n))`; it leaves with `v - P/m`, the plate with `P/M`
/// and `w = J^-1 (r x n) P`.
#[test]
fn an_off_centre_impact_turns_a_plate() {
    let (mass, v, e) = (4.0, 3.0, 0.6);
    let moments = Vec3::new(0.3, 0.5, 0.7);
    let r = Vec3::new(0.2, -0.15, 0.0);
    for solver in SOLVERS {
        let mut free = body(mass, Vec3::zeros(), moments, Joint::Free);
        // A turned frame: the axes of inertia are not those of the world.
        free.axes = UnitQuaternion::from_scaled_axis(Vec3::new(0.3, -0.5, 0.2));
        let turn = free.axes.to_rotation_matrix();
        let inertia = turn * Matrix3::from_diagonal(&moments) * turn.inverse();
        let mut run = Case::new(1e-3, 0.0, e)
            .settings(|s| s.solver = solver)
            .tolerance(1e-12, 1e-12, 1e-12)
            .without_gravity()
            .driven(plate([-0.5; 2], [0.5; 2], 0.0), free)
            .sphere(0.1, r + Vec3::z() * 0.1005, -Vec3::z() * v)
            .start();
        run.step();
        let m = run.mass(0);
        let arm = r.cross(&-Vec3::z());
        let turned = inertia.try_inverse().expect("regular") * arm;
        let p = (1.0 + e) * v / (1.0 / m + 1.0 / mass + arm.dot(&turned));
        close(run.velocity(0).z, -v + p / m, 1e-12, v);
        // At the end of the step the plate has turned: the half-step velocity is the one right after the impact.
        let after = run.simulation.state().bodies[0].velocity;
        let linear = after.linear + Vec3::z() * (p / mass);
        let angular = after.angular - turned * p;
        assert!(linear.norm() < 1e-12 * v, "{solver:?}: {linear:e}");
        assert!(angular.norm() < 1e-12 * p, "{solver:?}: {angular:e}");
    }
}

/// Straight above a free plate's centre of mass the contact lies as on a sphere: the plate is a driven body all the same, and
/// what the sphere does to it is in the ledger, `loss = (1 - e^2) mu v^2/2` with the reduced mass `mu`, and no residue.
#[test]
fn an_impact_above_the_centre_of_a_plate_balances() {
    let (mass, v, e) = (4.0, 3.0, 0.6);
    let free = body(mass, -Vec3::z() * 0.2, Vec3::repeat(0.3), Joint::Free);
    let mut run = Case::new(1e-3, 0.0, e)
        .tolerance(1e-12, 1e-12, 1e-12)
        .without_gravity()
        .driven(plate([-0.5; 2], [0.5; 2], 0.0), free)
        .sphere(0.1, Vec3::z() * 0.1005, -Vec3::z() * v)
        .start();
    run.step();
    let m = run.mass(0);
    let energy = 0.5 * m * mass / (m + mass) * v * v;
    let work = run.simulation.work();
    close(work.impact, (1.0 - e * e) * energy, 1e-12, energy);
    close(work.numerical_work, 0.0, 1e-12, energy);
}

/// A plate that falls on three fixed spheres of different size ends on their common tangent plane, `n.c_i + R_i = h` for
/// all three, and its contacts carry its weight without torque about its centre.
#[test]
fn a_plate_tilts_until_three_spheres_carry_it() {
    let spheres = [
        (0.10, Vec3::new(-0.4, -0.3, 0.10)),
        (0.11, Vec3::new(0.5, -0.2, 0.11)),
        (0.12, Vec3::new(0.0, 0.5, 0.12)),
    ];
    let centre = Vec3::new(0.05, 0.02, 0.2405);
    let mut case = Case::new(1e-3, 0.5, 0.0);
    let moments = Vec3::new(0.4, 0.5, 0.9);
    case = case.driven(
        plate([-1.0; 2], [1.0; 2], centre.z),
        body(5.0, centre, moments, Joint::Free),
    );
    for (radius, position) in spheres {
        case = anchored(case, radius, position);
    }
    let mut run = case.start();
    run.steps(600);
    let pose = run.simulation.boundary_pose(0);
    let n = pose.rotation * Vec3::z();
    let h = n.dot(&pose.apply(Vec3::zeros(), centre));
    for (radius, position) in spheres {
        assert!((n.dot(&position) + radius - h).abs() < 1e-6 * radius);
    }
    let wrench = run.simulation.wrench(0);
    assert!((wrench.force - Vec3::z() * (5.0 * G)).norm() < 1e-5 * 5.0 * G);
    let arm = pose.apply(Vec3::zeros(), centre) - pose.translation;
    let torque = wrench.torque - arm.cross(&wrench.force);
    assert!(torque.norm() < 1e-5 * 5.0 * G, "{torque:?}");
    assert!(run.simulation.boundary_twist(0).angular.norm() < 1e-6);
}

/// A tray on a hinge along y carries a sphere at `a` from it and rests on a fixed sphere at `b`: that one pushes up with
/// `(m a + M c) g / b`, with the tray's centre of mass at `c`.
#[test]
fn a_tray_on_a_hinge_is_a_lever() {
    let (a, b, c, mass) = (0.8, 0.5, 0.6, 7.0);
    for solver in SOLVERS {
        let tray = body(mass, Vec3::x() * c, Vec3::repeat(0.2), HINGE);
        let case = Case::new(1e-3, 0.4, 0.0)
            .settings(|s| s.solver = solver)
            .tolerance(1e-8, 1e-8, 1e-8)
            .driven(plate([0.1, -0.4], [1.0, 0.4], 0.0), tray)
            .sphere(0.1, Vec3::new(a, 0.0, 0.1), Vec3::zeros());
        let mut run = anchored(case, 0.1, Vec3::new(b, 0.0, -0.1)).start();
        let load = (run.mass(0) * a + mass * c) * G / b;
        for _ in 0..50 {
            let mut contacts = run.simulation.contacts().into_iter();
            let support = contacts.find(|k| k.key.sphere == 1);
            close(-support.expect("the support").force.z, load, 1e-6, 0.0);
            let torque = run.simulation.wrench(0).torque.y
                + Vec3::new(c, 0.0, 0.0).cross(&(Vec3::z() * -mass * G)).y;
            assert!(torque.abs() < 1e-6 * load, "{torque:e}");
            run.step();
        }
        assert!(run.simulation.boundary_pose(0).rotation.angle() < 1e-7);
    }
}

/// A servo wall presses with `pressure x area`: constant, or the product of the distances between two pairs of walls.
#[test]
fn a_servo_wall_presses_with_pressure_times_area() {
    let mut first = 0.0;
    for area in [Area::Constant(0.06), Area::Between([[1, 2], [3, 4]])] {
        let mut piston = body(0.5, Vec3::zeros(), Vec3::zeros(), SLIDE);
        piston.damping[0] = 100.0;
        piston.servo = Some(Servo {
            pressure: -500.0,
            area,
            input: false,
        });
        let mut case = Case::new(1e-3, 0.3, 0.0)
            .tolerance(1e-9, 1e-9, 1e-8)
            .floor();
        for (k, side) in [Vec3::x() * 0.1, Vec3::y() * 0.15].into_iter().enumerate() {
            for sign in [-1.0, 1.0] {
                case = case.plane(side * sign, -side * sign);
                case.scene.boundaries[1 + 2 * k + usize::from(sign > 0.0)].point_of_action =
                    side * sign;
            }
        }
        let mut run = case
            .driven(lid(0.2), piston)
            .sphere(0.1, Vec3::new(0.0, 0.0, 0.1), Vec3::zeros())
            .start();
        run.steps(5);
        let force = run.force_on_boundary(5).z;
        close(force, 500.0 * 0.06 + 0.5 * G, 1e-6, 0.0);
        first = f64::max(first, force);
    }
    assert!(first > 0.0);
}

/// A light plate on a pile of a hundred times its mass, as light as one of the spheres: no added-mass limit. It comes to
/// rest with the pile and its contacts carry its weight, to what the gap tolerance leaves of it.
#[test]
fn a_light_plate_rests_on_a_heavy_pile() {
    for joint in [SLIDE, Joint::Free] {
        // Without resistance a free plate rolls to and fro on its spheres for ever.
        let case = pile(joint, 1.0).resistance(0.1, 0.1);
        let mut run = case.tolerance(1e-6, 1e-4, 1e-3).start();
        // The lattice collapses for some seconds, how many hangs on rounding: the first tenth of a second at rest counts.
        let (mut moved, mut impulse) = (f64::INFINITY, 0.0);
        let mut poses = [run.simulation.boundary_pose(5); 2];
        for _ in 0..80 {
            poses[0] = run.simulation.boundary_pose(5);
            impulse = 0.0;
            for _ in 0..100 {
                run.step();
                impulse += 1e-3 * run.simulation.mean_wrench(5).force.z;
            }
            poses[1] = run.simulation.boundary_pose(5);
            moved = (poses[1].translation - poses[0].translation).norm();
            if moved < 1e-4 * 0.05 {
                break;
            }
        }
        let [before, after] = poses;
        assert!(moved < 1e-4 * 0.05, "{joint:?}: {moved:e}");
        assert!(before.rotation.angle_to(&after.rotation) < 1e-2);
        close(impulse, 0.1 * run.mass(0) * G, 1e-2, 0.0);
    }
}

/// A hundred spheres in a box and a plate of `ratio` sphere masses above them.
pub fn pile(joint: Joint, ratio: f64) -> Case {
    let radius = 0.05;
    let mut case = Case::new(1e-3, 0.3, 0.0).floor();
    for (point, normal) in [
        (Vec3::x() * -0.3, Vec3::x()),
        (Vec3::x() * 0.3, -Vec3::x()),
        (Vec3::y() * -0.3, Vec3::y()),
        (Vec3::y() * 0.3, -Vec3::y()),
    ] {
        case = case.plane(point, normal);
    }
    let mass = ratio * 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * f64::powi(radius, 3);
    let z = 0.47;
    let moments = Vec3::new(0.03, 0.03, 0.06) * mass;
    case = case.driven(
        plate([-0.29; 2], [0.29; 2], z),
        body(mass, Vec3::z() * z, moments, joint),
    );
    for k in 0..100 {
        let (i, j, layer) = (k % 5, k / 5 % 5, k / 25);
        let wobble = |n: i32| 0.004 * (f64::from(k * n) * 1.7).sin();
        let x = 0.11 * f64::from(i) - 0.22 + wobble(3);
        let y = 0.11 * f64::from(j) - 0.22 + wobble(7);
        let z = 0.055 + 0.11 * f64::from(layer);
        case = case.sphere(radius, Vec3::new(x, y, z), Vec3::zeros());
    }
    case
}

/// A body's state is part of the snapshot: a run goes on bit for bit, commands included.
#[test]
fn a_restored_run_goes_on_bit_for_bit() {
    let mut case = pile(Joint::Free, 10.0);
    if let sphere_dda::scene::Motion::Driven(body) = &mut case.scene.boundaries[5].motion {
        body.input = true;
    }
    let mut run = case.start();
    let push = Command {
        force: Vec3::new(0.5, 0.0, -20.0),
        torque: Vec3::new(0.0, 0.3, 0.0),
        ..Command::default()
    };
    run.simulation.command(5, push).expect("an input");
    run.steps(60);
    let blob = run.simulation.snapshot();
    let end = |simulation: &mut Simulation| {
        for _ in 0..20 {
            simulation.advance(1e-3).expect("the step converges");
        }
        simulation.snapshot()
    };
    let first = end(&mut run.simulation);
    run.simulation.restore(&blob).expect("its own snapshot");
    assert!(end(&mut run.simulation) == first);
    let twist: Twist = run.simulation.boundary_twist(5);
    assert!(twist.linear.norm() > 0.0);
}
