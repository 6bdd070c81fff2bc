//! Bonds between grains that give way, and bonds over gaps. Between centres that are `L` apart a bond is a beam,
//!
//! ```text
//! k_n = E A/L,   k_t = 2/5 k_n,   k_b = k_n R^2/4,   k_w = k_t R^2/2,      A = pi R^2
//! ```
//!
//! beside the contact, which presses alone.

use std::f64::consts::PI;

use sphere_dda::Vec3;
use sphere_dda::contact::cohesion::{Bond, Hold};
use sphere_dda::contact::elasticity::{Elastic, Elasticity};
use sphere_dda::scene::materials::Pair;
use sphere_dda::scene::particles::Locks;

use crate::scenes::held;
use crate::support::{Case, G, Run, close, order};

const RADIUS: f64 = 0.01;
const GLUE: f64 = 2e7;
/// Of the grains, which do not press where a bond is pulled.
const YOUNG: f64 = 1e8;

fn mass() -> f64 {
    2500.0 * 4.0 / 3.0 * PI * RADIUS.powi(3)
}

fn section() -> f64 {
    PI * RADIUS * RADIUS
}

/// Bonds that bear these forces \[N\] between spheres, and with walls.
fn case(
    step: f64,
    restitution: f64,
    elastic: bool,
    [tension, shear]: [f64; 2],
    reach: f64,
) -> Case {
    let bond = Bond {
        normal_strength: tension / section(),
        shear_strength: shear / section(),
        reach,
        young: Some(GLUE),
    };
    let material = Some(Elastic {
        young: YOUNG,
        poisson: 0.3,
    });
    let mut case = Case::new(step, 0.0, restitution).tolerance(1e-10, 1e-11, 1e-11);
    for (b, other) in [(0, material), (1, None)] {
        let elasticity = Elasticity::hertz([material, other]).filter(|_| elastic);
        let pair = Pair {
            bond: Some(bond),
            elasticity,
            ..case.scene.pairs.get(0, b)
        };
        case.scene.pairs.set(0, b, pair);
    }
    case
}

fn bonds(run: &Run) -> usize {
    held(run, Hold::is_bond)
}

/// A sphere on a wall whose normal is `normal`, at this gap.
fn beside(case: Case, normal: Vec3, gap: f64, locks: Locks) -> Case {
    case.plane(Vec3::zeros(), normal).body(
        RADIUS,
        normal * (RADIUS + gap),
        Vec3::zeros(),
        Vec3::zeros(),
        locks,
    )
}

/// Lets gravity grow in `count` steps: what rests at the start is loaded where it is, and what is loaded at once swings.
fn loaded(mut run: Run, count: u32) -> Run {
    for k in 1..=count {
        let gravity = -Vec3::z() * (G * f64::from(k) / f64::from(count));
        run.simulation.set_gravity(gravity).unwrap();
        run.step();
    }
    run
}

type Pull = (&'static str, Vec3, Locks, fn(f64, f64) -> [f64; 2]);

/// Tension, shear and bending by the weight of a sphere at a gap: strengths over it.
const PULLS: [Pull; 3] = [
    ("tension", Vec3::new(0.0, 0.0, -1.0), FREE, |_, _| {
        [1.0, 9.0]
    }),
    (
        "shear",
        Vec3::new(1.0, 0.0, 0.0),
        Locks::ROTATIONS,
        |_, _| [9.0, 1.0],
    ),
    ("bending", Vec3::new(1.0, 0.0, 0.0), FREE, |radius, gap| {
        [4.0 * (radius + gap) / radius, 9.0]
    }),
];
const FREE: Locks = Locks {
    translation: [false; 3],
    rotation: [false; 3],
};

/// A bond of grains that give way, or over a gap, or both, holds at 99 % and breaks at 101 % of its strength under a weight.
#[test]
fn elastic_bonds_and_bonds_over_gaps_break_at_their_strength() {
    let weight = mass() * G;
    for (elastic, gap) in [(true, 0.0), (false, 1e-3), (true, 1e-3)] {
        for (name, normal, locks, strengths) in PULLS {
            for (share, whole) in [(1.01, true), (0.99, false)] {
                let strengths = strengths(RADIUS, gap).map(|s| s * share * weight);
                let case = case(1e-3, 0.1, elastic, strengths, 1.0001 * gap);
                let run = beside(case.without_gravity(), normal, gap, locks).start();
                let mut run = loaded(run, 50);
                run.steps(100);
                let broken = run.simulation.state().broken_bonds;
                let told = format!("{name} {share} {elastic} {gap}");
                assert_eq!(
                    (bonds(&run), broken),
                    (usize::from(whole), u64::from(!whole)),
                    "{told}"
                );
                let moved = (run.position(0) - normal * (RADIUS + gap)).norm();
                // The softest is bent by m g L^2/k_b.
                let bound = if elastic { 1e-5 } else { 1e-12 };
                assert_eq!(moved < bound, whole, "{told}: {moved:e}");
            }
        }
    }
}

/// Under a load that grows slowly the bond breaks at its strength also where steps resolve its spring.
#[test]
fn a_resolved_bond_breaks_at_its_strength() {
    let weight = mass() * G;
    for (_, normal, locks, strengths) in PULLS {
        let case = case(
            2e-6,
            0.05,
            true,
            strengths(RADIUS, 0.0).map(|s| s * weight),
            0.0,
        );
        let mut run = beside(case.without_gravity(), normal, 0.0, locks).start();
        let mut share: f64 = 0.0;
        while bonds(&run) == 1 {
            share += 2e-4 * (1.05 - share);
            run.simulation
                .set_gravity(-Vec3::z() * (share * G))
                .unwrap();
            run.step();
            assert!(share < 1.04);
        }
        close(share, 1.0, 3e-3, 1.0);
    }
}

/// What a bond gives under a weight: `F L/(E A)`, `F L/(2/5 E A)`, and bent by `M` about the wall `M L/(E I)`.
#[test]
fn a_bond_is_a_beam() {
    let (weight, gap) = (mass() * G, 1e-3);
    let length = RADIUS + gap;
    let stiffness = GLUE * section() / length;
    for (name, normal, locks, _) in PULLS {
        let case = case(1e-3, 0.1, true, [1e3, 1e3], 2.0 * gap);
        let mut run = loaded(
            beside(case.without_gravity(), normal, gap, locks).start(),
            50,
        );
        run.steps(400);
        let sunk = normal * (RADIUS + gap) - run.position(0);
        let expected = match name {
            "tension" => weight / stiffness,
            "shear" => weight / (0.4 * stiffness),
            // Sheared at the wall, and turned there.
            _ => {
                let turned = weight * length / (0.25 * stiffness * RADIUS * RADIUS);
                weight / (0.4 * stiffness) + turned * length
            }
        };
        close(sunk.z, expected, 1e-4, expected);
    }
}

/// A pair that a bond joins over a gap swings along its line with `w^2 = 2 k_n/m`, of second order, and its energy stays: nothing is lost
/// by friction or impacts.
#[test]
fn a_bonded_pair_swings() {
    let gap = 1e-3;
    let stiffness = GLUE * section() / (2.0 * RADIUS + gap);
    let rate = (2.0 * stiffness / mass()).sqrt();
    let speed = 1e-3;
    let error = |count: f64| {
        let step = 2.0 * PI / rate / count;
        let mut case = case(step, 1.0, true, [1e3, 1e3], 2.0 * gap).without_gravity();
        for side in [-1.0, 1.0] {
            let x = Vec3::x() * side * (RADIUS + 0.5 * gap);
            case = case.sphere(RADIUS, x, Vec3::x() * side * speed);
        }
        let mut run = case.start();
        let start = run.kinetic();
        let mut worst = 0.0_f64;
        for _ in 0..(5.25 * count) as usize {
            run.step();
            let work = run.simulation.work();
            assert!(work.friction.abs() + work.impact.abs() < 1e-12 * start);
            let whole = run.kinetic() - work.contacts - work.numerical_work;
            close(whole, start, 1e-9, start);
            worst = worst.max(work.numerical_work.abs() / start);
        }
        let time = run.simulation.time();
        let stretched = run.position(1).x - run.position(0).x - 2.0 * RADIUS - gap;
        let exact = 2.0 * speed / rate * (rate * time).sin();
        ((stretched - exact).abs() * rate / speed, worst)
    };
    let [coarse, fine] = [40.0, 80.0].map(error);
    assert!(order(coarse.0, fine.0, 2.0) > 1.9, "{coarse:?} {fine:?}");
    assert!(fine.0 < 3e-3, "{fine:?}");
    assert!(order(coarse.1, fine.1, 2.0) > 1.5, "{coarse:?} {fine:?}");
}

/// A pair that is twisted turns by a half about an axis across its bond: the couple turns with it, so that the energy which the scheme
/// misses falls with the step. `w^2 = 2 k_w/J = k_n/m` is the rate of twisting.
#[test]
fn the_couple_of_a_bond_turns_with_it() {
    let stiffness = GLUE * section() / (2.0 * RADIUS);
    let rate = (stiffness / mass()).sqrt();
    let turn = 0.1 * rate;
    let twisting = 0.4 * mass() * (RADIUS * turn).powi(2);
    let missed = |count: f64| {
        let step = 2.0 * PI / rate / count;
        let mut case = case(step, 1.0, true, [1e4, 1e4], 0.0).without_gravity();
        for side in [-1.0, 1.0] {
            let x = Vec3::x() * side * RADIUS;
            let spin = Vec3::new(side * turn, 0.0, turn);
            case = case.body(
                RADIUS,
                x,
                Vec3::z().cross(&x) * turn,
                spin,
                Locks::default(),
            );
        }
        let mut run = case.start();
        let mut worst = 0.0_f64;
        for _ in 0..(0.5 / 0.1 * count) as usize {
            run.step();
            let work = run.simulation.work();
            assert!(work.friction.abs() + work.impact.abs() < 1e-9 * twisting);
            worst = worst.max(work.numerical_work.abs() / twisting);
        }
        assert_eq!(bonds(&run), 1);
        worst
    };
    let [coarse, fine] = [160.0, 320.0].map(missed);
    assert!(order(coarse, fine, 2.0) > 0.9, "{coarse:e} {fine:e}");
    assert!(fine < 5e-2, "{fine:e}");
}

/// A pair over a gap turns about itself, is bent and sheared, and keeps its angular momentum; its energy is kinetic, stored, or the
/// scheme's.
#[test]
fn a_bonded_pair_over_a_gap_keeps_its_angular_momentum() {
    for elastic in [true, false] {
        let gap = 2e-3;
        let mut case = case(1e-5, 1.0, elastic, [1e3, 1e3], gap).without_gravity();
        for side in [-1.0, 1.0] {
            let x = Vec3::x() * side * (RADIUS + 0.5 * gap);
            let v = Vec3::y() * side * 0.1;
            // One turns faster than the pair: the bond is bent and twisted.
            let spin = Vec3::new(1.0, 0.0, 9.0) * (1.0 + side);
            case = case.body(RADIUS, x, v, spin, Locks::default());
        }
        let mut run = case.start();
        run.step();
        let (momentum, energy) = (run.angular_momentum(), run.kinetic());
        let mut largest = 0.0_f64;
        for _ in 0..3000 {
            run.step();
            let work = run.simulation.work();
            largest = largest.max(-work.contacts);
        }
        let drift = (run.angular_momentum() - momentum).norm() / momentum.norm();
        assert!(
            drift < if elastic { 1e-5 } else { 1e-4 },
            "{elastic}: {drift:e}"
        );
        assert_eq!(bonds(&run), 1);
        if elastic {
            let work = run.simulation.work();
            assert!(work.friction.abs() < 1e-9 * energy, "{:e}", work.friction);
            assert!(largest > 1e-3 * energy, "{largest:e} of {energy:e}");
            let scheme = work.numerical_work.abs() / energy;
            assert!(scheme < 2e-2, "{scheme:e}");
        }
    }
}

/// A bond that breaks loses what it has stored, `f_t^2/(2 k_n)`, as an impact's loss: nothing is left in the contacts' account.
#[test]
fn a_broken_bond_loses_what_it_stored() {
    let (tension, gap) = (5.0 * mass() * G, 1e-3);
    let stiffness = GLUE * section() / (RADIUS + gap);
    let case = case(2e-6, 1.0, true, [tension, 9.0 * tension], gap).without_gravity();
    let case = beside(case, -Vec3::z(), gap, Locks::default());
    let mut run = case.start();
    while bonds(&run) == 1 {
        let gravity = run.simulation.gravity() - Vec3::z() * 2e-3;
        run.simulation.set_gravity(gravity).unwrap();
        run.step();
        assert!(gravity.norm() < 8.0 * G);
    }
    let work = run.simulation.work();
    let stored = tension * tension / (2.0 * stiffness);
    close(work.impact, stored, 2e-2, stored);
    assert!(work.contacts.abs() < 1e-9 * stored && work.friction.abs() < 1e-9 * stored);
}

/// A bond joins what is within its reach at the start and nothing else, whatever comes nearer later.
#[test]
fn a_bond_joins_what_is_within_its_reach() {
    for elastic in [true, false] {
        let case = case(1e-3, 0.1, elastic, [1e3, 1e3], 1e-3).without_gravity();
        // Of the force these stiff springs leave more than 1e-11 to rounding.
        let case = case.tolerance(1e-10, 1e-11, 1e-9);
        let mut case = case.sphere(RADIUS, Vec3::zeros(), Vec3::zeros());
        for (direction, gap) in [(Vec3::x(), 1e-3), (Vec3::y(), 1.001e-3), (Vec3::z(), 0.0)] {
            let x = direction * (2.0 * RADIUS + gap);
            case = case.sphere(RADIUS, x, -direction * 1e-2);
        }
        let mut run = case.start();
        assert_eq!(bonds(&run), 2);
        run.steps(200);
        assert_eq!(bonds(&run), 2);
        let rests: Vec<f64> = run
            .simulation
            .contacts()
            .iter()
            .filter_map(|c| match c.hold {
                Hold::Bonded { rest } => Some(rest),
                _ => None,
            })
            .collect();
        close(rests[0], 1e-3, 1e-9, 1.0);
    }
}

/// A cantilever of `N` grains, bonded to a wall and to each other over gaps, elastic or rigid: as an elastic one it sinks at its end by
/// the sum over its bonds, `F_k/k_t` and `M_k (x_end - x_k)/k_b`; it breaks at its root.
#[test]
fn a_beam_over_gaps_bends_and_breaks_at_its_root() {
    const N: usize = 4;
    let (weight, gap) = (mass() * G, 5e-4);
    let place = |k: usize| (RADIUS + gap) + k as f64 * (2.0 * RADIUS + gap);
    // About the wall.
    let root: f64 = (0..N).map(|k| weight * place(k)).sum();
    for elastic in [true, false] {
        for (share, whole) in [(1.01, true), (0.99, false)] {
            let strength = 4.0 * root / RADIUS * share;
            let mut case = case(2e-3, 0.1, elastic, [strength, 9.0 * strength], gap);
            case = case.plane(Vec3::zeros(), Vec3::x());
            for k in 0..N {
                case = case.sphere(RADIUS, Vec3::x() * place(k), Vec3::zeros());
            }
            let mut run = loaded(case.without_gravity().start(), 400);
            run.steps(if whole { 400 } else { 60 });
            let broken = run.simulation.state().broken_bonds;
            assert_eq!(
                (bonds(&run), broken > 0),
                (if whole { N } else { bonds(&run) }, !whole),
                "{elastic} {share}"
            );
            let sunk = -run.position(N - 1).z;
            if !whole {
                let contacts = run.simulation.contacts();
                let wall = |c: &sphere_dda::contact::Contact| {
                    matches!(c.key.partner, sphere_dda::contact::Partner::Boundary { .. })
                };
                assert!(
                    !contacts.iter().any(|c| wall(c) && c.hold.is_bond()),
                    "{elastic}"
                );
                assert!(sunk > 1e-3);
                continue;
            }
            let mut expected = 0.0;
            for k in 0..N {
                let length = if k == 0 {
                    RADIUS + gap
                } else {
                    2.0 * RADIUS + gap
                };
                let stiffness = GLUE * section() / length;
                // A bond acts in its middle, with a wall at the wall.
                let at = if k == 0 { 0.0 } else { place(k) - 0.5 * length };
                let force = weight * (N - k) as f64;
                let moment: f64 = (k..N).map(|i| weight * (place(i) - at)).sum();
                let turned = moment / (0.25 * stiffness * RADIUS * RADIUS);
                expected += force / (0.4 * stiffness) + turned * (place(N - 1) - at);
            }
            match elastic {
                true => close(sunk, expected, 2e-3, expected),
                false => assert!(sunk.abs() < 1e-9, "{sunk:e}"),
            }
        }
    }
}
