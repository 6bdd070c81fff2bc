//! Contacts that hold.
//!
//! ```text
//! cohesion   p_n >= -f_c,   |p_t| <= mu (p_n + f_c)        f_c = F,  2 pi W R* (DMT),  3/2 pi W R* (JKR)
//! bond       -p_n + 4 |m_b|/R_b <= f_t,   |p_t| + 2 |m_t|/R_b <= f_s + mu max(p_n, 0),   f = s pi R_b^2
//! ```

use sphere_dda::Vec3;
use sphere_dda::contact::cohesion::{Bond, Cohesion, Hold};
use sphere_dda::contact::elasticity::{Elastic, Elasticity};
use sphere_dda::scene::materials::Pair;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Motion, PointLoad};
use sphere_dda::spatial::Twist;
use std::f64::consts::PI;

use crate::support::{Case, G, Run, close, grid};

const RADIUS: f64 = 0.01;

fn case(friction: f64) -> Case {
    Case::new(1e-3, friction, 0.0).tolerance(1e-12, 1e-12, 1e-12)
}

fn mass() -> f64 {
    2500.0 * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

impl Case {
    fn pairs(mut self, change: impl Fn(Pair) -> Pair) -> Self {
        for (a, b) in [(0, 0), (0, 1), (1, 1)] {
            let pair = change(self.scene.pairs.get(a, b));
            self.scene.pairs.set(a, b, pair);
        }
        self
    }

    fn cohesive(self, force: f64) -> Self {
        let cohesion = Cohesion {
            force,
            ..Cohesion::default()
        };
        self.adhesive(cohesion)
    }

    fn adhesive(self, cohesion: Cohesion) -> Self {
        self.pairs(|pair| Pair {
            cohesion: Some(cohesion),
            ..pair
        })
    }

    /// Bonds that bear these forces \[N\].
    fn bonded(self, tension: f64, shear: f64) -> Self {
        let section = PI * RADIUS * RADIUS;
        let bond = Bond {
            normal_strength: tension / section,
            shear_strength: shear / section,
            reach: 0.0,
            young: None,
        };
        self.pairs(|pair| Pair {
            bond: Some(bond),
            ..pair
        })
    }

    fn pulled(mut self, sphere: usize, force: Vec3) -> Self {
        self.scene.loads.push(PointLoad {
            sphere,
            arm: Vec3::zeros(),
            force,
        });
        self
    }

    /// Under a ceiling at z = 0.
    fn ceiling(self) -> Self {
        self.plane(Vec3::zeros(), -Vec3::z())
    }

    fn still(self, position: Vec3) -> Self {
        self.sphere(RADIUS, position, Vec3::zeros())
    }
}

/// How many contacts hold.
fn holding(run: &Run) -> usize {
    let contacts = run.simulation.contacts();
    contacts.iter().filter(|c| c.hold != Hold::Loose).count()
}

/// A sphere hangs under a ceiling by its weight and a load: it holds 1e-9 below the pull-off force and parts 1e-9 above.
#[test]
fn pull_off_is_sharp() {
    let force = 3.0 * mass() * G;
    let hung = |share: f64| {
        let load = -Vec3::z() * (force * share - mass() * G);
        let case = case(0.3).cohesive(force).ceiling();
        case.still(-Vec3::z() * RADIUS).pulled(0, load).start()
    };
    let mut run = hung(1.0 - 1e-9);
    run.steps(300);
    assert_eq!(holding(&run), 1);
    close(run.normal_force(), -force * (1.0 - 1e-9), 1e-11, force);
    close(run.force_on_boundary(0).z, -force, 1e-8, force);
    assert!((run.position(0).z + RADIUS).abs() < 1e-12);
    let mut run = hung(1.0 + 1e-9);
    run.steps(300);
    assert_eq!(holding(&run), 0);
    assert!(run.position(0).z < -RADIUS - 1e-3);
}

/// Surface energies as pull-off forces, between two spheres of unlike radius: the lower one falls where it weighs more.
#[test]
fn surface_energies_are_pull_off_forces() {
    let reduced = RADIUS * 0.5 / 1.5;
    let laws = [
        (Cohesion::dmt as fn(f64) -> Cohesion, 2.0),
        (Cohesion::jkr, 1.5),
    ];
    for (law, factor) in laws {
        for (share, holds) in [(1.0 - 1e-9, 2), (1.0 + 1e-9, 1)] {
            let energy = mass() / 8.0 * G / (factor * PI * reduced * share);
            let run = case(0.0).adhesive(law(energy)).ceiling();
            let mut run = run.still(-Vec3::z() * RADIUS).sphere(
                0.5 * RADIUS,
                -Vec3::z() * 2.5 * RADIUS,
                Vec3::zeros(),
            );
            // The ceiling holds more: its reduced radius is the sphere's own.
            let more = Cohesion {
                force: 1.0,
                ..Cohesion::default()
            };
            let pair = Pair {
                cohesion: Some(more),
                ..run.scene.pairs.get(0, 1)
            };
            run.scene.pairs.set(0, 1, pair);
            let mut run = run.start();
            run.steps(300);
            assert_eq!(holding(&run), holds, "{factor} {share}");
        }
    }
}

/// A plate is pulled off a sphere that a spring holds: the spring bears `f_c - m g` in the last step that holds, to what it gets in
/// a step. Then the sphere swings freely about its rest.
#[test]
fn a_plate_leaves_a_sphere_at_the_pull_off_force() {
    let (force, stiffness, speed) = (2.0 * mass() * G, 50.0, 1e-3);
    let lift = Twist {
        linear: Vec3::z() * speed,
        angular: Vec3::zeros(),
    };
    let plate = sphere_dda::geometry::HalfSpace::new(Vec3::zeros(), -Vec3::z()).unwrap();
    let mut case = case(0.0)
        .cohesive(force)
        .moving(vec![plate.into()], Motion::Constant(lift))
        .still(-Vec3::z() * RADIUS);
    case.scene.springs.push(sphere_dda::scene::Spring {
        sphere: 0,
        arm: Vec3::zeros(),
        stiffness,
        target: -Vec3::z() * RADIUS,
        motion: Motion::Fixed,
    });
    let mut run = case.start();
    let mut last = 0.0;
    let mut steps = 0;
    while holding(&run) == 1 {
        last = -run.simulation.state().springs[0].z;
        run.step();
        steps += 1;
        assert!(steps < 10_000);
    }
    let increment = stiffness * speed * 1e-3;
    close(last, force - mass() * G, 2.0, increment);
    assert!(run.simulation.time() > 1.0);
}

/// Grains hang from a ceiling in a chain: each link bears the weight below it. Where gravity grows the top link parts, just above
/// its pull-off force, and the rest falls as one.
#[test]
fn a_chain_breaks_at_its_top() {
    const N: usize = 6;
    let force = 2.0 * N as f64 * mass() * G;
    let mut case = case(0.2).cohesive(force).ceiling();
    for k in 0..N {
        case = case.still(-Vec3::z() * (RADIUS * (2 * k + 1) as f64));
    }
    let mut run = case.start();
    run.steps(50);
    assert_eq!(holding(&run), N);
    for contact in run.simulation.contacts() {
        let below = match contact.key.partner {
            sphere_dda::contact::Partner::Sphere { index, .. } => N - index as usize,
            sphere_dda::contact::Partner::Boundary { .. } => N,
        };
        let weight = below as f64 * mass() * G;
        close(-contact.force.dot(&contact.normal), weight, 1e-9, weight);
    }
    let mut gravity = G;
    while holding(&run) == N {
        gravity *= 1.001;
        run.simulation.set_gravity(-Vec3::z() * gravity).unwrap();
        run.step();
        assert!(gravity < 3.0 * G);
    }
    close(gravity / (2.0 * G), 1.0, 3e-3, 1.0);
    run.steps(50);
    let contacts = run.simulation.contacts();
    assert_eq!(contacts.len(), N - 1);
    let boundary = |c: &sphere_dda::contact::Contact| {
        matches!(c.key.partner, sphere_dda::contact::Partner::Boundary { .. })
    };
    assert!(!contacts.iter().any(boundary));
    let length = run.position(0).z - run.position(N - 1).z;
    close(length, 2.0 * RADIUS * (N - 1) as f64, 1e-10, length);
}

/// A block on a slope slips at `tan a = mu (1 + f_c/(m g cos a))`.
#[test]
fn a_cohesive_block_slips_later() {
    let (mu, force) = (0.4, 1.5 * mass() * G);
    // m g sin a = mu (m g cos a + f_c), by Newton's method.
    let mut angle = 0.5_f64;
    for _ in 0..50 {
        let f = angle.sin() - mu * (angle.cos() + 1.5);
        angle -= f / (angle.cos() + mu * angle.sin());
    }
    for (share, slips) in [(1.0 - 1e-6, false), (1.0 + 1e-6, true)] {
        let a: f64 = angle * share;
        let normal = Vec3::new(a.sin(), 0.0, a.cos());
        let mut run = case(mu)
            .cohesive(force)
            .plane(Vec3::zeros(), normal)
            .body(
                RADIUS,
                normal * RADIUS,
                Vec3::zeros(),
                Vec3::zeros(),
                Locks::ROTATIONS,
            )
            .start();
        run.steps(200);
        let slid = (run.position(0) - normal * RADIUS).norm();
        let excess = G * (a.sin() - mu * (a.cos() + 1.5));
        match slips {
            false => assert!(slid < 1e-14, "{slid:e}"),
            true => close(slid, 0.5 * excess * 0.04, 2e-2, slid),
        }
    }
}

/// A block slides under a ceiling that bends from strip to strip, without friction: it holds on over the edges, whose features change.
#[test]
fn a_block_holds_on_from_triangle_to_triangle() {
    let bend = [0.0, 0.0, 0.02, 0.0, 0.02, 0.02];
    let at = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| f64::from(k) * 2.0 * RADIUS);
        Vec3::new(x, y, bend[i as usize] * RADIUS)
    };
    let place = Vec3::new(0.7 * RADIUS, 0.9 * RADIUS, -RADIUS);
    let mut run = case(0.0)
        .cohesive(20.0 * mass() * G)
        .wall(vec![grid(5, 1, at).into()])
        .body(
            RADIUS,
            place,
            Vec3::x() * 0.3,
            Vec3::zeros(),
            Locks::ROTATIONS,
        )
        .start();
    for _ in 0..200 {
        run.step();
        assert!(holding(&run) > 0, "{}", run.simulation.time());
    }
    close(run.position(0).x, place.x + 0.06, 1e-2, 0.06);
}

/// Two spheres that turn about each other hold as long as `m w^2 R < f_c`.
#[test]
fn a_pair_turns_about_itself() {
    let rate: f64 = 20.0;
    let needed = mass() * rate * rate * RADIUS;
    for (share, holds) in [(1.01, 1), (0.99, 0)] {
        let mut run = case(0.3).without_gravity().cohesive(needed * share);
        for side in [-1.0, 1.0] {
            let (x, v) = (Vec3::x() * side * RADIUS, Vec3::y() * side * RADIUS * rate);
            run = run.body(RADIUS, x, v, Vec3::z() * rate, Locks::default());
        }
        let mut run = run.start();
        let spin = run.angular_momentum();
        run.steps(400);
        assert_eq!(holding(&run), holds, "{share}");
        if holds == 1 {
            assert!((run.angular_momentum() - spin).norm() < 1e-9 * spin.norm());
            close(-run.normal_force(), needed, 1e-3, needed);
            let turned = run.position(1) / RADIUS;
            let expected = rate * 0.4;
            let error = turned - Vec3::new(expected.cos(), expected.sin(), 0.0);
            assert!(error.norm() < 1e-3, "{:e}", error.norm());
        }
    }
}

/// Grains that nothing presses stay attached, and a grain that has not touched is not attracted.
#[test]
fn what_has_not_touched_does_not_hold() {
    let mut run = case(0.3)
        .without_gravity()
        .cohesive(1.0)
        .still(Vec3::zeros())
        .still(Vec3::x() * 2.0 * RADIUS)
        .still(-Vec3::x() * 2.001 * RADIUS)
        .start();
    run.steps(100);
    assert_eq!(holding(&run), 1);
    assert!((0..3).all(|i| run.velocity(i).norm() < 1e-15));
}

/// A bridge attracts up to its rupture distance: a grain leaves at the speed `v` with `m v^2/2 > f_c s`, and loses that energy.
#[test]
fn a_bridge_takes_its_energy() {
    let (force, distance) = (0.05, 1e-3);
    let cohesion = Cohesion {
        force,
        rupture_distance: distance,
        ..Cohesion::default()
    };
    let needed = (2.0 * force * distance / mass()).sqrt();
    for share in [0.9, 1.2] {
        let mut case = Case::new(2e-5, 0.0, 0.0)
            .tolerance(1e-9, 1e-12, 1e-12)
            .without_gravity()
            .adhesive(cohesion)
            .floor();
        // It starts attached and is struck off by a short load.
        let steps = 10.0;
        let push = mass() * needed * share / (steps * 2e-5) + force;
        case = case.still(Vec3::z() * RADIUS).pulled(0, Vec3::z() * push);
        let mut run = case.start();
        run.steps(10);
        let mut scene = (**run.simulation.scene()).clone();
        scene.loads[0].force = Vec3::zeros();
        run.simulation.tune(std::sync::Arc::new(scene));
        // Its reported velocity is that of the load for another half step.
        run.steps(2);
        let start = run.kinetic() + force * (run.position(0).z - RADIUS);
        run.steps(2200);
        match share > 1.0 {
            true => {
                let left = start - force * distance;
                close(run.kinetic(), left, 2e-2, left);
                assert_eq!(holding(&run), 0);
                close(
                    -run.simulation.work().contacts,
                    force * distance,
                    2e-2,
                    force * distance,
                );
            }
            false => {
                assert_eq!(holding(&run), 1);
                assert!(run.position(0).z < RADIUS + 1e-9);
            }
        }
    }
}

/// Derjaguin, Muller and Toporov: `F = K d^1.5 - f_c` on a floor, at rest under several loads, to 1 %; pulled by more than `f_c` it parts.
#[test]
fn dmt_is_hertz_less_the_pull_off_force() {
    let (young, poisson, energy) = (5e6, 0.3, 0.5);
    let pull_off = 2.0 * PI * energy * RADIUS;
    let hertz = 4.0 / 3.0 * young / (1.0 - poisson * poisson) * RADIUS.sqrt();
    for pull in [-2.0, 0.0, 0.5, 0.95, 1.05] {
        let material = Some(Elastic { young, poisson });
        let mut run = Case::new(2e-4, 0.0, 0.1)
            .tolerance(1e-9, 1e-12, 1e-12)
            .without_gravity()
            .giving_way(0, 1, Elasticity::hertz([material, None]))
            .adhesive(Cohesion::dmt(energy))
            .floor()
            .still(Vec3::z() * RADIUS)
            .pulled(0, Vec3::z() * pull * pull_off)
            .start();
        run.steps(3000);
        if pull > 1.0 {
            assert_eq!(holding(&run), 0);
            continue;
        }
        let overlap = RADIUS - run.position(0).z;
        let expected = ((1.0 - pull) * pull_off / hertz).powf(2.0 / 3.0);
        close(overlap, expected, 1e-2, expected);
        close(-run.normal_force(), pull * pull_off, 1e-2, pull_off);
    }
}

/// A bond between a sphere and a wall holds at 99 % and breaks at 101 % of its strength: in tension, in shear, by bending (the
/// weight of a sphere beside a wall, 4 m g), by twisting is left to the law's own test.
#[test]
fn bonds_break_at_their_strength() {
    let weight = mass() * G;
    let (down, aside) = (-Vec3::z() * RADIUS, Vec3::x() * RADIUS);
    type Cases = [(&'static str, Vec3, Locks, f64, [f64; 2]); 3];
    let cases: Cases = [
        ("tension", -Vec3::z(), Locks::default(), 1.0, [1.0, 3.0]),
        ("shear", Vec3::x(), Locks::ROTATIONS, 1.0, [9.0, 1.0]),
        ("bending", Vec3::x(), Locks::default(), 1.0, [4.0, 9.0]),
    ];
    for (name, normal, locks, _, strength) in cases {
        for (share, whole) in [(1.01, true), (0.99, false)] {
            let [tension, shear] = strength.map(|s| s * weight * share);
            let place = if normal.x > 0.0 { aside } else { down };
            let mut run = case(0.0)
                .bonded(tension, shear)
                .plane(Vec3::zeros(), normal)
                .body(RADIUS, place, Vec3::zeros(), Vec3::zeros(), locks)
                .start();
            run.steps(100);
            assert_eq!(holding(&run) == 1, whole, "{name} {share}");
            assert_eq!(run.simulation.state().broken_bonds == 0, whole);
            let moved = (run.position(0) - place).norm();
            assert_eq!(moved < 1e-12, whole, "{name} {share}: {moved:e}");
        }
    }
}

/// A beam of bonded grains cantilevers from a wall: its bonds bear the bending moment of the weight beyond them, and it falls as one when
/// its root breaks, not a bond elsewhere.
#[test]
fn a_bonded_beam_breaks_at_its_root() {
    const N: usize = 5;
    let weight = mass() * G;
    // At the wall the moment is sum m g R (2 k + 1) = m g R N^2.
    let root = 4.0 * weight * (N * N) as f64;
    for (share, whole) in [(1.01, true), (0.99, false)] {
        let mut case = case(0.3)
            .bonded(root * share, root)
            .plane(Vec3::zeros(), Vec3::x());
        for k in 0..N {
            case = case.still(Vec3::x() * (RADIUS * (2 * k + 1) as f64));
        }
        let mut run = case.start();
        run.steps(40);
        let places: Vec<Vec3> = (0..N).map(|i| run.position(i)).collect();
        let sag = places.iter().map(|x| x.z.abs()).fold(0.0, f64::max);
        if whole {
            assert_eq!(holding(&run), N);
            assert!(sag < 1e-10, "{sag:e}");
            for contact in run.simulation.contacts() {
                if let sphere_dda::contact::Partner::Sphere { index, .. } = contact.key.partner {
                    // Beyond the contact between k - 1 and k.
                    let beyond = (N - index as usize) as f64;
                    let moment = weight * RADIUS * beyond * beyond;
                    close(contact.torque.norm(), moment, 1e-6, moment);
                }
            }
        } else {
            assert_eq!(run.simulation.state().broken_bonds, 1);
            assert_eq!(holding(&run), N - 1);
            assert!(sag > 1e-3);
        }
    }
}

/// Bonds that are broken do not mend when their grains touch again.
#[test]
fn a_broken_bond_stays_broken() {
    let weight = mass() * G;
    let mut run = case(0.0)
        .bonded(0.5 * weight, weight)
        .ceiling()
        .plane(-Vec3::z() * 2.01 * RADIUS, Vec3::z())
        .still(-Vec3::z() * RADIUS)
        .start();
    run.steps(100);
    assert_eq!(run.simulation.state().broken_bonds, 1);
    run.simulation.set_gravity(Vec3::z() * G).unwrap();
    run.steps(100);
    assert_eq!(holding(&run), 0);
    run.simulation.set_gravity(-Vec3::z() * G).unwrap();
    run.steps(100);
    close(run.position(0).z, -1.01 * RADIUS, 1e-9, RADIUS);
}

/// A glued bar on two supports rests: half of its weight on each, however strong the glue is. Errors of forces are a share of what the
/// glue carries, and the bar does not bend by the sum of what its grains turn by in each step.
#[test]
fn a_strong_bar_rests_on_two_supports() {
    for (r, strength) in [(0.01, 1e9), (0.01, 1e7), (0.001, 1e7)] {
        let support = |name: &str, x: f64| {
            let (low, high) = (x - r, x + r);
            format!(
                "[[boundary]]\nname = \"{name}\"\nmaterial = \"wall\"\nfaces = [{{ box = {{ min = [{low}, -{r}, -{r}], max = [{high}, {r}, 0.0] }} }}]\n"
            )
        };
        let text = format!(
            r#"
[simulation]
duration = 1.0
communication_step = 0.01
[pair_default]
friction = 0.5
[[pair]]
materials = ["grain", "grain"]
bond = {{ normal_strength = {strength:e}, shear_strength = {strength:e} }}
[[spheres]]
name = "bar"
material = "grain"
radius = {r}
lattice = {{ origin = [0.0, 0.0, {r}], count = [20, 1, 1], spacing = {} }}
{}{}
"#,
            2.0 * r,
            support("left", 0.0),
            support("right", 38.0 * r)
        );
        let mut run = crate::scenes::start(&crate::scenes::scene(&text));
        let half = 10.0 * run.mass(0) * G;
        let mut mean = [0.0; 2];
        while run.simulation.time() < 1.0 - 1e-9 {
            run.advance(0.01);
            assert_eq!(run.simulation.report().unconverged_steps, 0);
            for (b, mean) in mean.iter_mut().enumerate() {
                let borne = -run.simulation.mean_wrench(b).force.z;
                close(borne, half, 0.05, 0.0);
                *mean += borne / 100.0;
            }
        }
        mean.iter().for_each(|&mean| close(mean, half, 2e-3, 0.0));
        // A gap that errs by 1e-6 R works against what holds it: so much, and not what would hold the whole strength.
        let worked = run.simulation.work().contacts.abs();
        assert!(worked < 10.0 * run.mass(0) * G * r, "{worked:e} J");
        let sag = r - run.position(10).z;
        assert!(sag.abs() < 0.05 * r, "{} R", sag / r);
        assert_eq!(run.simulation.state().broken_bonds, 0);
    }
}
