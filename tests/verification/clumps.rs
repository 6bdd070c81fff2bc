//! Clumps: rigid grains of several spheres, against the mechanics of rigid bodies.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{Matrix3, UnitQuaternion};
use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;
use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::{Energy, Momentum};
use sphere_dda::scene::clump::{Clump, ClumpShape};
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{PointLoad, Spring};

use crate::support::{Case, G, Run, close, order};

const DENSITY: f64 = 2500.0;

/// Members of these centres \[m\] and one radius \[m\], with the density of the spheres.
pub fn shape(centres: &[Vec3], radius: f64) -> ClumpShape {
    let radii = vec![radius; centres.len()];
    let (shape, _) = ClumpShape::new(centres, &radii, DENSITY, None, None).expect("a clump");
    shape
}

/// Two spheres, their centres `2 half` apart along `axis`.
fn dumbbell(axis: Vec3, half: f64, radius: f64) -> ClumpShape {
    shape(&[axis * -half, axis * half], radius)
}

/// Inertia of a clump about its centre in its own axes.
pub fn inertia(shape: &ClumpShape) -> Matrix3<f64> {
    let axes = shape.axes.to_rotation_matrix();
    axes * Matrix3::from_diagonal(&shape.moments) * axes.inverse()
}

pub fn upright(position: Vec3) -> (Vec3, UnitQuaternion<f64>) {
    (position, UnitQuaternion::identity())
}

impl Run {
    fn first_clump(&self) -> Clump {
        self.simulation.scene().clumps[0].clone()
    }

    /// Centre of mass \[m\] and rotation of the first clump.
    fn place(&self) -> (Vec3, UnitQuaternion<f64>) {
        self.first_clump().place(self.simulation.kinematics())
    }

    /// Reported velocity of the first clump's centre of mass \[m/s\].
    fn clump_velocity(&self) -> Vec3 {
        let clump = self.first_clump();
        let members = clump.members.clone().zip(&clump.shape.shares);
        members.map(|(i, share)| self.velocity(i) * *share).sum()
    }

    fn whole_momentum(&self) -> Momentum {
        Momentum::of(&Observation::of(&self.simulation))
    }
}

/// `K(m)` by the arithmetic-geometric mean.
fn elliptic_k(m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    while a - b > 1e-16 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    FRAC_PI_2 / a
}

/// A free clump of moments `A < B < C` turns by Euler's equations: its spin comes back to the same place in its own axes with the
/// period (Landau and Lifshitz, Mechanics, section 37; `2 E B < L^2`)
///
/// ```text
/// T = 4 K(m) sqrt(A B C / ((C - B)(L^2 - 2 E A))),  m = (B - A)(2 E C - L^2) / ((C - B)(L^2 - 2 E A))
/// ```
/// The angular momentum stays, the energy comes back, and the error of the period is of second order.
#[test]
fn a_free_top_turns_by_eulers_equations() {
    let moments = Vec3::new(1.0, 1.8, 2.4) * 1e-3;
    let radii = [0.05, 0.04, 0.03];
    let centres = [Vec3::zeros(), Vec3::x() * 0.06, Vec3::y() * 0.05];
    let given = Some(Matrix3::from_diagonal(&moments));
    let (top, _) = ClumpShape::new(&centres, &radii, DENSITY, Some(1.3), given).unwrap();
    let spin = Vec3::new(1.0, 2.5, 6.0);
    let l = moments.component_mul(&spin);
    let (square, twice) = (l.norm_squared(), l.dot(&spin));
    let [a, b, c] = moments.into();
    assert!(twice * b < square);
    let m = (b - a) * (twice * c - square) / ((c - b) * (square - twice * a));
    let period = 4.0 * elliptic_k(m) * (a * b * c / ((c - b) * (square - twice * a))).sqrt();
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let error = |dt: f64| {
            let mut run = Case::new(dt, 0.0, 0.0)
                .without_gravity()
                .settings(|s| s.integrator = integrator)
                .clump(&top, upright(Vec3::zeros()), Vec3::zeros(), spin)
                .start();
            let energy = run.whole_energy().kinetic();
            close(energy, 0.5 * twice, 1e-12, 0.0);
            let angular = run.whole_momentum().angular;
            close((angular - l).norm(), 0.0, 1.0, 1e-12 * l.norm());
            let along = |run: &Run| (run.place().1.inverse() * run.spin(0)).x;
            let (mut crossings, mut before) = (Vec::new(), along(&run));
            while crossings.len() < 3 {
                run.step();
                let now = along(&run);
                if before < 0.0 && now >= 0.0 {
                    crossings.push(run.simulation.time() - dt * now / (now - before));
                }
                before = now;
                let off = (run.whole_momentum().angular - l).norm();
                assert!(off < 1e-10 * l.norm(), "{off:e}");
                let off = run.whole_energy().kinetic() / energy - 1.0;
                assert!(off.abs() < 40.0 * dt * dt, "{off:e}");
            }
            close(
                crossings[2] - crossings[1],
                crossings[1] - crossings[0],
                1e-6,
                0.0,
            );
            (0.5 * (crossings[2] - crossings[0]) / period - 1.0).abs()
        };
        let [coarse, fine] = [2e-3, 1e-3].map(error);
        let found = order(coarse, fine, 2.0);
        assert!((1.9..2.1).contains(&found), "{integrator:?}: {found}");
        let finest = error(1e-4);
        assert!(finest < 1e-6, "{integrator:?}: {finest:e}");
    }
}

/// Free fall with spin about a principal axis: the centre of mass on its parabola, constant spin, both integrators, steps of any
/// length.
#[test]
fn a_clump_falls_as_a_sphere_does() {
    for integrator in [Integrator::Moreau, Integrator::Shi] {
        let rod = dumbbell(Vec3::x(), 0.1, 0.08);
        let (x0, v0, spin) = (
            Vec3::new(1.0, 2.0, 50.0),
            Vec3::new(3.0, 1.0, 4.0),
            Vec3::z() * 5.0,
        );
        let mut run = Case::new(1e-2, 0.3, 0.0)
            .settings(|s| s.integrator = integrator)
            .clump(&rod, upright(x0), v0, spin)
            .start();
        for h in [0.01, 0.02, 0.005, 0.037, 0.01, 0.1]
            .into_iter()
            .cycle()
            .take(30)
        {
            run.advance(h);
            let t = run.simulation.time();
            let x = x0 + v0 * t - Vec3::z() * (0.5 * G * t * t);
            close((run.place().0 - x).norm(), 0.0, 1.0, 1e-11);
            close(
                (run.clump_velocity() - v0 + Vec3::z() * (G * t)).norm(),
                0.0,
                1.0,
                1e-11,
            );
            close((run.spin(1) - spin).norm(), 0.0, 1.0, 1e-11);
        }
        let expected = UnitQuaternion::from_scaled_axis(spin * run.simulation.time());
        assert!(run.place().1.angle_to(&expected) < 1e-11);
    }
}

/// A rod that falls with speed `v` on one end, its axis at an angle to the floor, with the end at `d` beside the centre:
///
/// ```text
/// frictionless    P = (1 + e) v / (1/m + d^2/J),  v' = P/m - v,  w' = P d / J
/// sticking, e = 0  the point of contact stops: P = (1/m - [r] J^-1 [r])^-1 (0, 0, v)
/// ```
#[test]
fn a_rod_falls_on_one_end() {
    let (half, radius, speed, angle) = (0.2, 0.05, 2.0, 0.5_f64);
    let rod = dumbbell(Vec3::x(), half, radius);
    let across = inertia(&rod)[(1, 1)];
    let turn = UnitQuaternion::from_axis_angle(&Vec3::y_axis(), angle);
    let (sin, cos) = angle.sin_cos();
    // Turned about y the end at +x goes down.
    let height = half * sin + radius;
    let start = |friction: f64, e: f64| {
        Case::new(1e-5, friction, e)
            .without_gravity()
            .tolerance(1e-9, 1e-9, 1e-9)
            .floor()
            .clump(
                &rod,
                (Vec3::z() * (height + 1e-7), turn),
                Vec3::z() * -speed,
                Vec3::zeros(),
            )
            .start()
    };
    for e in [0.0, 0.5, 1.0] {
        let mut run = start(0.0, e);
        run.steps(2);
        let d = half * cos;
        let p = (1.0 + e) * speed / (1.0 / rod.mass + d * d / across);
        close(run.clump_velocity().z, p / rod.mass - speed, 1e-4, 0.0);
        // The force acts at +d along x, so that it turns the rod about -y.
        close(run.spin(0).y, -d * p / across, 1e-4, 0.0);
        assert!(run.clump_velocity().x.abs() < 1e-9);
    }
    let mut run = start(10.0, 0.0);
    run.steps(2);
    let r = Vec3::new(half * cos, 0.0, -height);
    let turned = turn.to_rotation_matrix();
    let inverse = turned * inertia(&rod).try_inverse().unwrap() * turned.inverse();
    let cross = r.cross_matrix();
    let operator = Matrix3::identity() / rod.mass - cross * inverse * cross;
    let p = operator.try_inverse().unwrap() * Vec3::z() * speed;
    let v = p / rod.mass - Vec3::z() * speed;
    let w = inverse * r.cross(&p);
    close((run.clump_velocity() - v).norm(), 0.0, 1.0, 1e-4 * speed);
    close((run.spin(0) - w).norm(), 0.0, 1.0, 1e-4 * w.norm());
}

/// A dumbbell rolls down an incline about its axis, `a = g sin(alpha) / (1 + J/(m R^2))`, where what two spheres share lies near
/// the axis: their union turns less easily than they would apart.
#[test]
fn a_dumbbell_rolls() {
    let (radius, alpha) = (0.1, 0.3_f64);
    let rod = dumbbell(Vec3::y(), 0.06, radius);
    let axial = inertia(&rod)[(1, 1)];
    let share = axial / (rod.mass * radius * radius);
    assert!(share > 0.42, "{share}");
    let mut run = Case::new(1e-3, 0.6, 0.0)
        .tolerance(1e-8, 1e-8, 1e-8)
        .settings(|s| s.gravity = Vec3::new(alpha.sin(), 0.0, -alpha.cos()) * G)
        .floor()
        .clump(
            &rod,
            upright(Vec3::z() * radius),
            Vec3::zeros(),
            Vec3::zeros(),
        )
        .start();
    run.steps(400);
    let t = run.simulation.time();
    let acceleration = G * alpha.sin() / (1.0 + share);
    close(run.clump_velocity().x, acceleration * t, 1e-6, 0.0);
    close(run.place().0.x, 0.5 * acceleration * t * t, 1e-6, 0.0);
    close(run.spin(0).y, acceleration * t / radius, 1e-6, 0.0);
    assert!(run.spin(0).xz().norm() < 1e-6);
}

/// A clump whose centre of mass lies `h` below that of the sphere of radius `R` on which it rolls rocks with
///
/// ```text
/// w^2 = m g h / (J + m (R - h)^2)        small angles
/// ```
/// It has large members on one side that do not reach the floor. Energy stays.
#[test]
fn a_clump_rocks() {
    let (radius, side) = (0.1, 0.05);
    let centres = [
        Vec3::zeros(),
        Vec3::new(0.0, 0.09, -0.04),
        Vec3::new(0.0, -0.09, -0.04),
    ];
    let radii = [radius, side, side];
    let (clump, centre) = ClumpShape::new(&centres, &radii, DENSITY, None, None).unwrap();
    let h = -centre.z;
    let rate = clump.mass * G * h;
    let rate = (rate / (inertia(&clump)[(1, 1)] + clump.mass * (radius - h).powi(2))).sqrt();
    let turn = UnitQuaternion::from_axis_angle(&Vec3::y_axis(), 0.02);
    let error = |dt: f64| {
        let start = Vec3::z() * radius + turn * centre;
        let mut run = Case::new(dt, 1.0, 0.0)
            .tolerance(1e-9, 1e-9, 1e-9)
            .floor()
            .clump(&clump, (start, turn), Vec3::zeros(), Vec3::zeros())
            .start();
        let energy = |run: &Run| run.whole_energy().kinetic() + run.whole_energy().potential();
        let began = energy(&run);
        let scale = clump.mass * G * h * 0.5 * 0.02_f64.powi(2);
        let (mut crossings, mut before) = (Vec::new(), run.spin(0).y);
        while crossings.len() < 3 {
            run.step();
            let now = run.spin(0).y;
            if before < 0.0 && now >= 0.0 {
                crossings.push(run.simulation.time() - dt * now / (now - before));
            }
            before = now;
            close(energy(&run), began, 0.02, scale - began.abs());
        }
        (0.5 * (crossings[2] - crossings[0]) * rate / TAU - 1.0).abs()
    };
    // The amplitude of 0.02 takes some 1e-4 of itself.
    let found = error(5e-4);
    assert!(found < 1e-4, "{found:e}");
}

/// A tetrahedron of four spheres on three fixed ones, its lower members leaning inwards: each carries a third of the weight along the
/// vertical, `N = m g / (3 n_z)`. At the start and after a while.
#[test]
fn a_tetrahedron_rests_on_three_spheres() {
    let (r, wide, support) = (0.05, 0.06, 0.08);
    let at = |k: f64, wide: f64| {
        let angle = TAU * k / 3.0;
        Vec3::new(angle.cos(), angle.sin(), 0.0) * wide
    };
    let centres = [
        at(0.0, wide),
        at(1.0, wide),
        at(2.0, wide),
        Vec3::z() * 0.08,
    ];
    let (tetra, centre) = ClumpShape::new(&centres, &[r; 4], DENSITY, None, None).unwrap();
    // The fixed spheres stand farther out: the line of centres has the length of both radii.
    let far = 0.11;
    let down = f64::sqrt((r + support) * (r + support) - (far - wide) * (far - wide));
    let mut case = Case::new(1e-3, 0.0, 0.0).tolerance(1e-9, 1e-9, 1e-9).clump(
        &tetra,
        upright(centre),
        Vec3::zeros(),
        Vec3::zeros(),
    );
    let fixed = Locks {
        translation: [true; 3],
        rotation: [true; 3],
    };
    for k in 0..3 {
        let place = at(f64::from(k), far) - Vec3::z() * down;
        case = case.body(support, place, Vec3::zeros(), Vec3::zeros(), fixed);
    }
    let mut run = case.start();
    let expected = tetra.mass * G * (r + support) / (3.0 * down);
    for time in 0..4 {
        let contacts = run.simulation.contacts();
        assert_eq!(contacts.len(), 3);
        for contact in contacts.iter() {
            close(contact.force.dot(&contact.normal), expected, 1e-6, 0.0);
        }
        assert!(run.clump_velocity().norm() < 1e-8, "{time}");
        run.steps(50);
    }
}

/// Two clumps that meet with spin and friction: linear momentum to 1e-9 in every step (as `step` checks), angular momentum to
/// 1e-9 without friction (with it, arms end at surfaces that are a gap apart), and less energy.
#[test]
fn momentum_stays_in_a_collision_of_two_clumps() {
    for (friction, restitution) in [(0.0, 0.8), (0.4, 0.3)] {
        let rod = dumbbell(Vec3::x(), 0.1, 0.06);
        let wheel = shape(
            &[
                Vec3::zeros(),
                Vec3::x() * 0.08,
                Vec3::y() * 0.09,
                Vec3::z() * 0.07,
            ],
            0.06,
        );
        let mut run = Case::new(1e-4, friction, restitution)
            .without_gravity()
            .tolerance(1e-8, 1e-8, 1e-8)
            .clump(
                &rod,
                upright(Vec3::x() * -0.3),
                Vec3::x() * 2.0,
                Vec3::new(1.0, 8.0, 3.0),
            )
            .clump(
                &wheel,
                upright(Vec3::new(0.1, 0.05, 0.02)),
                Vec3::x() * -1.0,
                Vec3::new(-4.0, 2.0, 6.0),
            )
            .start();
        let (before, energy) = (run.whole_momentum(), run.whole_energy().kinetic());
        let mut touched = false;
        for _ in 0..2000 {
            run.step();
            touched |= !run.simulation.contacts().is_empty();
            let now = run.whole_momentum();
            let off = (now.linear - before.linear).norm() / before.linear.norm();
            assert!(off < 1e-9, "{off:e}");
            let off = (now.angular - before.angular).norm() / before.angular.norm();
            let bound = if friction > 0.0 { 1e-4 } else { 1e-9 };
            assert!(off < bound, "{off:e}");
        }
        assert!(touched);
        let after = run.whole_energy().kinetic();
        assert!(
            after < 0.99 * energy && after > 0.1 * energy,
            "{after} of {energy}"
        );
        let work = run.simulation.work();
        let open = after - energy + work.friction + work.impact - work.numerical_work;
        assert!(open.abs() < 1e-9 * energy, "{open:e} of {energy:e}");
        assert!(
            work.numerical_work.abs() < 1e-2 * energy,
            "{} of {energy}",
            work.numerical_work
        );
    }
}

/// A point load on a member turns and moves its clump, `v = F t/m`, `w = J^-1 (r x F) t` after a short time; a spring on it holds it
/// where `k x = m g`.
#[test]
fn loads_and_springs_on_members_act_on_their_clumps() {
    let rod = dumbbell(Vec3::x(), 0.1, 0.06);
    let mut case = Case::new(1e-4, 0.0, 0.0).without_gravity().clump(
        &rod,
        upright(Vec3::zeros()),
        Vec3::zeros(),
        Vec3::zeros(),
    );
    let force = Vec3::new(0.0, 3.0, 1.0);
    case.scene.loads.push(PointLoad {
        sphere: 1,
        arm: Vec3::x() * 0.02,
        force,
    });
    let mut run = case.start();
    run.steps(10);
    let t = run.simulation.time();
    let spin = inertia(&rod).try_inverse().unwrap() * (Vec3::x() * 0.12).cross(&force) * t;
    close(
        (run.clump_velocity() - force * (t / rod.mass)).norm(),
        0.0,
        1.0,
        1e-9,
    );
    close((run.spin(0) - spin).norm(), 0.0, 1.0, 1e-4 * spin.norm());
    let mut case =
        Case::new(1e-3, 0.0, 0.0).clump(&rod, upright(Vec3::zeros()), Vec3::zeros(), Vec3::zeros());
    let stiffness = 1e4;
    for (sphere, way) in [(0, 0.1), (1, -0.1)] {
        let stretch = Vec3::z() * (0.5 * rod.mass * G / stiffness);
        case.scene.springs.push(Spring {
            sphere,
            arm: Vec3::zeros(),
            stiffness,
            target: Vec3::x() * -way + stretch,
            motion: sphere_dda::scene::Motion::Fixed,
        });
    }
    let mut run = case.start();
    run.steps(200);
    assert!(run.place().0.norm() < 1e-9, "{:e}", run.place().0.norm());
    let open = Energy::of(&Observation::of(&run.simulation)).kinetic();
    assert!(open < 1e-12 * rod.mass * G, "{open:e}");
}

/// Grains that give way: a dumbbell of steel rests on a floor with Hertz's compression under half its weight, and bounces with its
/// coefficient of restitution where its centre is above the contact.
#[test]
fn clumps_give_way_as_spheres_do() {
    let (radius, young, poisson) = (0.02, 1e7, 0.25);
    let rod = dumbbell(Vec3::x(), 0.05, radius);
    let mut run = Case::new(1e-3, 0.3, 0.5)
        .elastic(young, poisson)
        .tolerance(1e-6, 1e-6, 1e-6)
        .floor()
        .clump(
            &rod,
            upright(Vec3::z() * radius),
            Vec3::zeros(),
            Vec3::zeros(),
        )
        .start();
    run.steps(1000);
    let modulus = young / (1.0 - poisson * poisson);
    let load = 0.5 * rod.mass * G;
    let depth = (0.75 * load / (modulus * radius.sqrt())).powf(2.0 / 3.0);
    close(radius - run.place().0.z, depth, 1e-2, 0.0);
    // Upright, so that it does not turn: the springs of an impact that steps resolve.
    let upended = UnitQuaternion::from_axis_angle(&Vec3::y_axis(), FRAC_PI_2);
    let mut run = Case::new(1e-5, 0.0, 0.5)
        .elastic(young, poisson)
        .without_gravity()
        .tolerance(1e-6, 1e-6, 1e-6)
        .floor()
        .clump(
            &rod,
            (Vec3::z() * (0.05 + radius + 1e-5), upended),
            Vec3::z() * -0.5,
            Vec3::zeros(),
        )
        .start();
    run.steps(2000);
    close(run.clump_velocity().z, 0.25, 2e-2, 0.0);
}

/// An elastic rod that falls on one end leaves the floor as the rigid one does, with the mass of the place where it touches,
/// `1/m* = 1/m + d^2/J`, in its damper: the stiffer it is, the less it turns meanwhile.
#[test]
fn a_stiff_rod_rebounds_on_one_end_as_a_rigid_one_does() {
    let (half, radius, speed, e) = (0.05, 0.02, 0.5, 0.5);
    let rod = dumbbell(Vec3::x(), half, radius);
    let turn = UnitQuaternion::from_axis_angle(&Vec3::y_axis(), 0.5);
    let (sin, cos) = 0.5_f64.sin_cos();
    let d = half * cos;
    let across = inertia(&rod)[(1, 1)];
    let p = (1.0 + e) * speed / (1.0 / rod.mass + d * d / across);
    let error = |young: f64| {
        // A duration of the contact has some 200 steps.
        let dt = 2e-6 * (1e9 / young).powf(0.4);
        let start = Vec3::z() * (half * sin + radius + 0.1 * speed * dt);
        let mut run = Case::new(dt, 0.0, e)
            .elastic(young, 0.25)
            .without_gravity()
            .tolerance(1e-8, 1e-8, 1e-8)
            .floor()
            .clump(&rod, (start, turn), Vec3::z() * -speed, Vec3::zeros())
            .start();
        run.steps(5);
        assert!(!run.simulation.contacts().is_empty());
        while !run.simulation.contacts().is_empty() {
            run.step();
        }
        let found = [run.clump_velocity().z, run.spin(0).y];
        let expected = [p / rod.mass - speed, -d * p / across];
        (found[0] - expected[0]).abs() / speed
    };
    let [soft, stiff] = [1e7, 1e11].map(error);
    assert!(stiff < 5e-4 && soft > 20.0 * stiff, "{soft:e} {stiff:e}");
}
