//! Contacts that give way: Hertz, Mindlin, springs; the tests of Chung and Ooi (Granular Matter 13, 2011) and statics.
//!
//! With `K = 4/3 E* sqrt(R*)` a pair of the reduced mass `m` that meets at the speed `v` without friction and losses has
//!
//! ```text
//! d_max = (5 m v^2/(4 K))^(2/5),    F_max = K d_max^(3/2),    T = 2 sqrt(pi) Gamma(7/5)/Gamma(9/10) d_max/v = 2.9432751 d_max/v
//! ```
//!
//! Where the surfaces slip through the whole of an impact, `v_t' = v_t - mu (1 + e) v_n`, `w' = w + 5/2 mu (1 + e) v_n/R`.

use sphere_dda::Vec3;
use sphere_dda::contact::elasticity::{Elastic, Elasticity};
use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Motion;
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, close, order};

/// `T v/d_max` of Hertz.
const DURATION: f64 = 2.943_275_1;

fn hertz(young: f64, poisson: f64, wall: bool, radius: f64) -> (f64, f64) {
    let half = (1.0 - poisson * poisson) / young;
    let (effective, reduced) = match wall {
        true => (1.0 / half, radius),
        false => (0.5 / half, 0.5 * radius),
    };
    (4.0 / 3.0 * effective * reduced.sqrt(), effective)
}

/// Largest normal force, time of contact, and speed along z of the first sphere afterwards.
fn collide(run: &mut Run, dt: f64) -> (f64, f64, f64) {
    let (mut most, mut steps) = (0.0_f64, 0);
    for _ in 0..100_000 {
        run.step();
        let force = run.normal_force();
        most = most.max(force);
        if force > 0.0 {
            steps += 1;
        } else if steps > 0 {
            break;
        }
    }
    (most, f64::from(steps) * dt, run.velocity(0).z)
}

/// Two spheres or one on a wall, at the relative speed `v`, in `count` steps of the contact's duration.
fn impact(
    (young, poisson, density): (f64, f64, f64),
    radius: f64,
    v: f64,
    wall: bool,
    count: f64,
    e: f64,
) -> (f64, f64, f64, [f64; 2]) {
    let mass = density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    let reduced = if wall { mass } else { 0.5 * mass };
    let (k, _) = hertz(young, poisson, wall, radius);
    let deepest = (1.25 * reduced * v * v / k).powf(0.4);
    let (force, time) = (k * deepest.powf(1.5), DURATION * deepest / v);
    let dt = time / count;
    let mut case = Case::new(dt, 0.0, e)
        .without_gravity()
        .elastic(young, poisson)
        .tolerance(1e-9, 1e-9, 1e-9);
    case.scene.materials[0].density = density;
    // Not at a multiple of the step.
    let apart = 0.37 * v * dt;
    case = match wall {
        true => case
            .floor()
            .sphere(radius, Vec3::z() * (radius + apart), -Vec3::z() * v),
        false => case
            .sphere(radius, Vec3::z() * (radius + apart), -Vec3::z() * (0.5 * v))
            .sphere(radius, -Vec3::z() * radius, Vec3::z() * (0.5 * v)),
    };
    for (m, r) in case
        .scene
        .particles
        .mass
        .iter_mut()
        .zip(&case.scene.particles.radius)
    {
        *m = density * 4.0 / 3.0 * std::f64::consts::PI * r.powi(3);
    }
    let mut run = case.start();
    let (most, lasted, after) = collide(&mut run, dt);
    (
        most / force,
        lasted / time,
        after / if wall { v } else { 0.5 * v },
        [dt, deepest],
    )
}

/// Chung and Ooi, tests 1 and 2: two spheres of glass and of limestone, a sphere of aluminium and of magnesium on a plane.
#[test]
fn an_impact_has_the_force_and_duration_of_hertz() {
    let cases = [
        ((4.8e10, 0.2, 2800.0), 0.01, 10.0, false),
        ((2.0e10, 0.25, 2500.0), 0.01, 10.0, false),
        ((7.0e10, 0.3, 2699.0), 0.1, 0.2, true),
        ((4.0e10, 0.35, 1800.0), 0.1, 0.2, true),
    ];
    for (material, radius, v, wall) in cases {
        let (force, time, after, _) = impact(material, radius, v, wall, 200.0, 1.0);
        close(force, 1.0, 1e-3, 0.0);
        close(time, 1.0, 0.01, 0.0);
        close(after, 1.0, 1e-3, 0.0);
        // Second order: a step twice as long misses speed and force by four times as much at most.
        let off = |count: f64| {
            let shifts = [count, count + 0.25, count + 0.5, count + 0.75];
            let speeds =
                shifts.map(|count| (impact(material, radius, v, wall, count, 1.0).2 - 1.0).abs());
            speeds.into_iter().fold(0.0, f64::max)
        };
        let (coarse, fine) = (off(25.0), off(100.0));
        assert!(fine < 1e-3 && fine < coarse / 8.0, "{coarse:e} {fine:e}");
    }
}

/// Chung and Ooi, test 3: aluminium oxide on a plane at 3.9 m/s, whatever the coefficient of restitution, from steps that resolve the
/// contact of 1e-5 s well to ones a hundred times longer, where Newton's law stands in.
#[test]
fn the_coefficient_of_restitution_holds_at_any_step() {
    let material = (3.8e11, 0.23, 4000.0);
    for e in [0.0, 0.2, 0.4, 0.6, 0.8, 1.0] {
        for (count, most) in [
            (400.0, 0.002_f64),
            (100.0, 0.01),
            (20.0, 0.03),
            (3.0, 1e-9),
            (0.01, 1e-9),
        ] {
            let (_, _, after, _) = impact(material, 0.0025, 3.9, true, count, e);
            // The strongest damper leaves a hundredth.
            let least = if count > 10.0 { 0.01 } else { 0.0 };
            assert!(
                (after - e.max(least)).abs() < most,
                "{after} for {e} in {count} steps"
            );
        }
    }
}

/// A sphere of aluminium oxide that meets a plane at the angle `angle` \[deg\] from its normal, or with the spin `spin` about y:
/// speed along x and spin about y afterwards.
fn oblique(dt: f64, (friction, e): (f64, f64), v: Vec3, spin: f64) -> [f64; 2] {
    let radius = 0.0025;
    let mut case = Case::new(dt, friction, e)
        .without_gravity()
        .elastic(3.8e11, 0.23)
        .tolerance(1e-10, 1e-10, 1e-10)
        .floor()
        .sphere(radius, Vec3::z() * (radius + 0.4 * dt * v.z.abs()), v);
    case.scene.initial.spin[0] = Vec3::y() * spin;
    let mut run = case.start();
    collide(&mut run, dt);
    [run.velocity(0).x, run.spin(0).y]
}

/// Chung and Ooi, tests 4 and 5, where the surfaces slip all the time: speed and spin after an oblique impact, and of a sphere that
/// spins.
#[test]
fn an_impact_that_slips_has_the_impulse_of_friction() {
    let (friction, e, speed, radius) = (0.092, 0.98, 3.9, 0.0025);
    for angle in [50.0_f64, 65.0, 80.0] {
        let (s, c) = angle.to_radians().sin_cos();
        let v = Vec3::new(speed * s, 0.0, -speed * c);
        let [vx, wy] = oblique(2e-8, (friction, e), v, 0.0);
        let taken = friction * (1.0 + e) * speed * c;
        close(vx, v.x - taken, 2e-3, 0.0);
        close(wy, 2.5 * taken / radius, 1e-2, 0.0);
    }
    let (friction, e, v) = (0.1, 0.5, 0.2);
    for spin in [-400.0, -1000.0] {
        let [vx, wy] = oblique(2e-8, (friction, e), -Vec3::z() * v, spin);
        let taken = friction * (1.0 + e) * v;
        close(vx, -taken, 1e-2, 0.0);
        close(wy, spin + 2.5 * taken / radius, 1e-2, 0.0);
    }
}

/// The same law by tiny explicit steps: Hertz's force, and a shear force that grows by `k_t u_t dt`, shrinks with `k_t` and is cut at
/// `mu F`.
fn reference(v: Vec3, friction: f64) -> [f64; 2] {
    let (young, poisson, radius, density) = (3.8e11, 0.23, 0.0025, 2500.0);
    let mass = density * 4.0 / 3.0 * std::f64::consts::PI * f64::powi(radius, 3);
    let inertia = 0.4 * mass * radius * radius;
    let (k, _) = hertz(young, poisson, true, radius);
    let across = young / (2.0 * (2.0 - poisson) * (1.0 + poisson)) * 8.0 * f64::sqrt(radius);
    let (mut x, mut vz, mut vx, mut w, mut shear, mut last) =
        (0.0_f64, v.z, v.x, 0.0, 0.0_f64, 0.0_f64);
    let dt = 1e-10;
    loop {
        let force = k * x.max(0.0).powf(1.5);
        let stiffness = across * x.max(0.0).sqrt();
        if last > stiffness {
            shear *= stiffness / last;
        }
        last = stiffness;
        shear -= stiffness * (vx - w * radius) * dt;
        shear = shear.clamp(-friction * force, friction * force);
        vz += force / mass * dt;
        vx += shear / mass * dt;
        w -= shear * radius / inertia * dt;
        x -= vz * dt;
        if x < 0.0 {
            return [vx, w];
        }
    }
}

/// Chung and Ooi, test 4, where the surfaces stick: tangential rebound and spin by Mindlin's stiffness, within 1 % of the law
/// integrated otherwise, and the nearer the shorter the step.
#[test]
fn an_impact_that_sticks_rebounds_across_the_normal() {
    let (friction, speed) = (0.092, 3.9);
    for angle in [2.0_f64, 10.0, 20.0] {
        let (s, c) = angle.to_radians().sin_cos();
        let v = Vec3::new(speed * s, 0.0, -speed * c);
        let expected = reference(v, friction);
        let off = |dt: f64| {
            let found = oblique(dt, (friction, 1.0), v, 0.0);
            let scale = [v.x, v.x / 0.0025];
            (0..2)
                .map(|k| (found[k] - expected[k]).abs() / scale[k])
                .fold(0.0, f64::max)
        };
        let (coarse, fine) = (off(1e-7), off(2e-8));
        assert!(fine < 0.01, "{angle} deg: {coarse:e} {fine:e}");
        assert!(
            fine < coarse || fine < 1e-3,
            "{angle} deg: {coarse:e} {fine:e}"
        );
    }
}

/// The elasticity of spheres on each other and on the wall, and the compression of such a contact under a force [N].
type Law<'a> = &'a dyn Fn(bool) -> Option<Elasticity>;
type Compression<'a> = &'a dyn Fn(f64, bool) -> f64;

/// A stack of glass at a step of 1 ms: each contact is compressed as its load says, by Hertz and by a spring. `strength` is that of
/// glass over what it is here.
fn stack(n: usize, law: impl Fn(bool) -> Option<Elasticity>, solver: SolverKind) -> Run {
    let radius = 0.005;
    let mut case = Case::new(1e-3, 0.3, 0.0)
        .settings(|s| s.solver = solver)
        .tolerance(1e-11, 1e-11, 1e-9)
        .floor();
    case = case
        .giving_way(0, 0, law(false))
        .giving_way(0, 1, law(true));
    for k in 0..n {
        let z = radius * (2 * k + 1) as f64;
        case = case.sphere(radius, Vec3::new(0.0, 0.0, z), Vec3::zeros());
    }
    let mut run = case.start();
    run.steps(400);
    run
}

#[test]
fn a_stack_is_compressed_by_its_weight_at_a_step_of_a_millisecond() {
    let (n, radius) = (5, 0.005);
    let glass = Elastic {
        young: 70e9,
        poisson: 0.25,
    };
    let by_hertz = |wall: bool| Elasticity::hertz([Some(glass), (!wall).then_some(glass)]);
    let by_springs = |_: bool| Some(Elasticity::linear(2e3));
    let of_hertz =
        |force: f64, wall: bool| (force / hertz(70e9, 0.25, wall, radius).0).powf(2.0 / 3.0);
    let of_springs = |force: f64, _: bool| force / 2e3;
    let laws: [(Law, Compression); 2] = [(&by_hertz, &of_hertz), (&by_springs, &of_springs)];
    for (law, compression) in laws {
        for solver in [
            SolverKind::Auto,
            SolverKind::Direct,
            SolverKind::GaussSeidel,
        ] {
            let run = stack(n, law, solver);
            let weight = run.mass(0) * G;
            let mut z = 0.0;
            for k in 0..n {
                let load = weight * (n - k) as f64;
                z += radius * if k == 0 { 1.0 } else { 2.0 } - compression(load, k == 0);
                let off = run.position(k).z - z;
                assert!(off.abs() < 1e-3 * compression(weight, false), "{off:e}");
                assert!(run.velocity(k).norm() < 1e-7, "{}", run.velocity(k));
            }
            close(run.force_on_boundary(0).z, -weight * n as f64, 1e-6, 0.0);
            let report = run.simulation.report();
            assert!(report.max_overlap <= 1e-11, "{:e}", report.max_overlap);
            let deepest = compression(weight * n as f64, true)
                .max(compression(weight * (n - 1) as f64, false));
            close(report.max_compression, deepest / radius, 1e-3, 0.0);
        }
    }
}

/// The stiffer, the nearer to rigid spheres: Hertz's compression falls with `E^(-2/3)`.
#[test]
fn stiff_spheres_tend_to_rigid_ones() {
    let top = |young: Option<f64>| {
        let law = |wall: bool| {
            let ball = young.map(|young| Elastic {
                young,
                poisson: 0.25,
            });
            Elasticity::hertz([ball, ball.filter(|_| !wall)])
        };
        stack(3, law, SolverKind::Auto).position(2).z
    };
    let rigid = top(None);
    let off: Vec<f64> = [1e7, 1e9, 1e11]
        .map(|young| rigid - top(Some(young)))
        .into();
    for pair in off.windows(2) {
        let slope = order(pair[0], pair[1], 100.0);
        assert!((slope - 2.0 / 3.0).abs() < 0.02, "{slope}: {off:?}");
    }
}

/// A sphere between two plates that approach: no rigid answer, Hertz's `F = K (h/2)^(3/2)` where they give way alike.
#[test]
fn a_squeezed_sphere_answers_with_hertz() {
    let (radius, speed, young) = (0.01, 1e-3, 1e9);
    let mut case = Case::new(1e-3, 0.3, 0.0)
        .without_gravity()
        .elastic(young, 0.3)
        .tolerance(1e-10, 1e-10, 1e-8)
        .floor()
        .plane(Vec3::z() * (2.0 * radius), -Vec3::z())
        .sphere(radius, Vec3::z() * radius, Vec3::zeros());
    case.scene.boundaries[1].motion = Motion::Constant(Twist {
        linear: -Vec3::z() * speed,
        angular: Vec3::zeros(),
    });
    let mut run = case.start();
    let (k, _) = hertz(young, 0.3, true, radius);
    for _ in 0..5 {
        run.steps(20);
        let squeezed = speed * run.simulation.time();
        let force = k * (0.5 * squeezed).powf(1.5);
        close(run.force_on_boundary(1).z, force, 1e-3, 0.0);
        close(run.force_on_boundary(0).z, -force, 1e-3, 0.0);
    }
}

/// Sixteen spheres pressed into a box: more contacts than statics determines. However they start, the forces are the same.
#[test]
fn forces_of_a_hyperstatic_packing_are_unique() {
    let (radius, n) = (0.01, 4);
    let rest = |shake: f64| {
        let side = 2.0 * radius * f64::from(n) - 1e-4;
        let mut case = Case::new(1e-3, 0.0, 0.0)
            .settings(|s| s.gravity = Vec3::new(0.0, 3.0, -9.0))
            .elastic(5e7, 0.3)
            .tolerance(1e-12, 1e-12, 1e-10)
            .floor()
            .plane(Vec3::zeros(), Vec3::y())
            .plane(Vec3::new(0.0, side, 0.0), -Vec3::y())
            .plane(Vec3::new(-radius, 0.0, 0.0), Vec3::x())
            .plane(Vec3::new(radius, 0.0, 0.0), -Vec3::x());
        for j in 0..n {
            for k in 0..n {
                let at = |i: u32| radius * f64::from(2 * i + 1);
                let off = shake * f64::from((7 * j + 3 * k) % 5);
                let place = Vec3::new(
                    0.0,
                    at(j) * side / (2.0 * radius * f64::from(n)),
                    at(k) + off,
                );
                case = case.sphere(radius, place, Vec3::zeros());
            }
        }
        let mut run = case.start();
        run.steps(3000);
        run
    };
    let [a, b] = [0.0, 2e-6].map(rest);
    let most = a
        .simulation
        .contacts()
        .iter()
        .map(|c| c.force.norm())
        .fold(0.0, f64::max);
    let (one, other) = (a.simulation.contacts(), b.simulation.contacts());
    assert_eq!(one.len(), other.len());
    assert!(
        one.len() > 2 * (n * n) as usize,
        "{} contacts of {}",
        one.len(),
        n * n
    );
    for (one, other) in one.iter().zip(&other) {
        assert_eq!(one.key, other.key);
        let off = (one.force - other.force).norm() / most;
        assert!(off < 1e-6, "{:?}: {off:e}", one.key);
    }
}

/// Kinetic energy, what contacts have stored and what was lost add up, and nothing is stored in the end.
#[test]
fn stored_energy_has_its_own_account() {
    for e in [1.0, 0.7] {
        let case = Case::new(2e-6, 0.3, e)
            .without_gravity()
            .elastic(1e8, 0.3)
            .tolerance(1e-9, 1e-9, 1e-9)
            .floor()
            .sphere(0.01, Vec3::z() * 0.0101, Vec3::new(0.4, 0.1, -1.0));
        let mut run = case.start();
        let before = run.kinetic();
        let (mut stored, mut numerical) = (0.0_f64, 0.0_f64);
        while run.velocity(0).z < 0.0 || run.position(0).z < 0.0101 {
            run.step();
            let work = *run.simulation.work();
            let sum =
                run.kinetic() - work.contacts + work.friction + work.impact - work.numerical_work;
            close(sum, before, 1e-9, 0.0);
            stored = stored.max(-work.contacts);
            numerical = numerical.max(work.numerical_work.abs());
            // The shear force is one of the start of the step, kinetic energy of its end.
            assert!(
                work.friction > -1e-2 * before,
                "{:e}",
                work.friction / before
            );
        }
        let work = run.simulation.work();
        assert!(
            stored > 0.5 * before && numerical < 5e-3 * before,
            "{stored:e} {numerical:e} {before:e}"
        );
        assert!(work.contacts.abs() < 1e-9 * before, "{:e}", work.contacts);
        let normal = 0.5 * run.mass(0);
        close(work.impact, normal * (1.0 - e * e), 0.01, 0.02 * before);
    }
}

/// Steps of a hundred contacts' durations are stable: a bed of glass falls, comes to rest and keeps its weight.
#[test]
fn stiff_beds_come_to_rest_at_long_steps() {
    let radius = 0.005;
    for (integrator, share) in [(Integrator::Moreau, 1e-5), (Integrator::Shi, 1e-4)] {
        let mut case = Case::new(1e-3, 0.4, 0.3)
            .settings(|s| (s.integrator, s.strict) = (integrator, false))
            .elastic(70e9, 0.25)
            // A lone sphere would roll for ever.
            .resistance(0.02, 0.02)
            .tolerance(1e-6, 1e-6, 1e-4)
            .floor()
            .plane(-Vec3::x() * 0.02, Vec3::x())
            .plane(Vec3::x() * 0.02, -Vec3::x())
            .plane(-Vec3::y() * 0.02, Vec3::y())
            .plane(Vec3::y() * 0.02, -Vec3::y());
        for k in 0..48_u32 {
            let jitter = 1e-4 * f64::from(k * 7 % 11);
            let at = |i: u32| 0.0105 * (f64::from(i) - 1.0) + jitter;
            let place = Vec3::new(at(k % 3), at(k / 3 % 3), 0.006 + 0.011 * f64::from(k / 9));
            case = case.sphere(radius, place, Vec3::zeros());
        }
        let mut run = case.start();
        run.steps(2000);
        let weight = 48.0 * run.mass(0) * G;
        let wrenches = run.simulation.state().mean_wrenches.iter();
        let carried: f64 = wrenches.map(|wrench| -wrench.force.z).sum();
        assert!(
            (carried / weight - 1.0).abs() < 1e-2,
            "{integrator:?}: {}",
            carried / weight
        );
        assert!(
            run.kinetic() < share * weight * radius,
            "{integrator:?}: {:e}",
            run.kinetic()
        );
    }
}
