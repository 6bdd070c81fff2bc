//! Internal steps chosen for least total time, scenes that come to rest, and steps of a bounded number of sweeps.

use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::geometry::HalfSpace;
use sphere_dda::scene::{Command, InputKind, Motion};
use sphere_dda::simulation::Simulation;
use sphere_dda::spatial::{Twist, Wrench};

use crate::clumps::{inertia, shape, upright};
use crate::support::{Case, G, close};

const RADIUS: f64 = 0.01;

/// A heap of `n^3` spheres in a loose lattice, dropped into a box without a lid; the floor is the last boundary and can be moved.
fn heap(n: usize, step: f64) -> Case {
    let side = 2.4 * RADIUS * n as f64;
    let mut case = Case::new(step, 0.5, 0.0).tolerance(1e-5, 1e-5, 1e-1);
    for (k, direction) in [Vec3::x(), -Vec3::x(), Vec3::y(), -Vec3::y()]
        .into_iter()
        .enumerate()
    {
        let corner = if k % 2 == 0 { 0.0 } else { side };
        case = case.plane(Vec3::new(corner, corner, 0.0), direction);
    }
    for k in 0..n * n * n {
        let [x, y, z] = [k % n, k / n % n, k / n / n].map(|k| (k as f64 + 0.5) * 2.4 * RADIUS);
        let off = 0.1 * RADIUS * (1.7 * k as f64).sin();
        case = case.sphere(RADIUS, Vec3::new(x + off, y - off, z), Vec3::zeros());
    }
    let floor = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
    case.moving(vec![floor.into()], Motion::Input(InputKind::Twist))
}

/// Every step holds the tolerance whatever its length, the end is met exactly, and steps grow where little happens.
#[test]
fn chosen_steps_hold_the_tolerance() {
    let (smallest, step) = (1e-5, 4e-3);
    let mut case = heap(4, step);
    case.scene.settings.smallest_step = Some(smallest);
    let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
    let mut lengths = Vec::new();
    for k in 1..=100 {
        let end = f64::from(k) * 5e-3;
        let report = simulation.advance_to(end).expect("a step");
        assert!(report.max_overlap <= 1e-5, "{}", report.max_overlap);
        assert_eq!(simulation.time(), end);
        lengths.push(5e-3 / report.internal_steps as f64);
    }
    let [shortest, longest] = [f64::min, f64::max].map(|f| lengths.iter().copied().reduce(f));
    assert!(shortest >= Some(0.5 * smallest) && longest <= Some(step * (1.0 + 1e-9)));
    assert!(longest > shortest.map(|x| 1.5 * x), "{lengths:?}");
}

/// Grains whose compression is below the tolerance take no more sweeps than rigid ones, for the same openings are let pass; beside a
/// reserve, which springs do not have, up to twice as many.
#[test]
fn stiff_heaps_take_the_sweeps_of_rigid_ones() {
    let sweeps = |opening: f64, young: Option<f64>| {
        let mut case = heap(5, 2e-3).tolerance(1e-4, 7e-4, 1e-1);
        case.scene.settings.opening = opening;
        if let Some(young) = young {
            case = case.elastic(young, 0.25);
        }
        let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
        let report = simulation.advance_to(0.5).expect("a step");
        assert!(report.max_overlap <= 1e-4, "{}", report.max_overlap);
        assert!(report.max_opening <= 1e-3, "{}", report.max_opening);
        report.sweeps as f64
    };
    for (opening, most) in [(0.0, 1.0), (1e-3, 2.0)] {
        let [rigid, stiff] = [None, Some(70e9)].map(|young| sweeps(opening, young));
        assert!(stiff <= most * rigid, "{opening}: {stiff}, {rigid}");
    }
}

/// The length of the next step is part of the state: a run that is put back goes the same way.
#[test]
fn chosen_steps_are_part_of_the_state() {
    let mut case = heap(3, 2e-3);
    case.scene.settings.smallest_step = Some(1e-5);
    let scene = Arc::new(case.scene);
    let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
    simulation.advance_to(0.1).expect("a step");
    let saved = simulation.snapshot();
    simulation.advance_to(0.2).expect("a step");
    let mut other = Simulation::new(scene).expect("a start");
    other.restore(&saved).expect("its own state");
    other.advance_to(0.2).expect("a step");
    assert!(simulation.snapshot() == other.snapshot());
}

/// A spin about the vertical that nothing resists never ends: on a sphere that lies it does not keep a scene awake, unless it is fast,
/// and a sphere that slides or rolls is no sphere that lies.
#[test]
fn a_spin_that_no_contact_feels_does_not_keep_a_scene_awake() {
    let limit = 1e-3;
    let rests = |velocity: Vec3, spin: Vec3| {
        let mut case = Case::new(1e-3, 0.5, 0.0).floor();
        case = case.sphere(RADIUS, Vec3::new(0.0, 0.0, RADIUS), velocity);
        case.scene.initial.spin[0] = spin / RADIUS;
        case.scene.settings.rest_speed = limit;
        let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
        simulation.advance_to(0.015).expect("a step");
        simulation.velocity(0).angular == Vec3::zeros()
    };
    let zero = Vec3::zeros();
    assert!(rests(zero, Vec3::z() * 9.0 * limit));
    assert!(!rests(zero, Vec3::z() * 11.0 * limit));
    let rolling = Vec3::y() * 2.0 * limit;
    assert!(!rests(Vec3::x() * 2.0 * limit, rolling));
    assert!(!rests(zero, rolling * 4.0));
}

/// Steady rolling is a balance of forces: it ends once gravity would have brought a hundred times its speed, however short the steps are.
#[test]
fn a_sphere_that_rolls_more_slowly_than_at_rest_falls_asleep() {
    let (step, speed) = (5e-4, 5e-3);
    let mut case = Case::new(step, 0.5, 0.0).floor();
    case = case.sphere(RADIUS, Vec3::z() * RADIUS, Vec3::x() * speed);
    case.scene.initial.spin[0] = Vec3::y() * (speed / RADIUS);
    case.scene.settings.rest_speed = 2.0 * speed;
    let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
    let wanted = speed / (1e-2 * G);
    while simulation.velocity(0).linear != Vec3::zeros() {
        assert!(simulation.time() < 2.0 * wanted, "it rolls on");
        simulation.advance(step).expect("a step");
    }
    // Every tenth step it is asked.
    let late = simulation.time() - wanted;
    assert!((0.0..11.0 * step).contains(&late), "{late} s");
}

/// A clump glides and turns on a smooth floor more slowly than at rest, until it sleeps. The floor is booked with what it had:
///
/// ```text
/// P = m v,   L_z = m (x v_y - y v_x) + J_zz w        about the floor's point of action
/// ```
#[test]
fn a_clump_that_falls_asleep_leaves_its_momentum_to_the_floor() {
    let (step, speed, spin) = (5e-4, 5e-3, 0.2);
    let corners = [[0.0, 0.0], [0.03, 0.0], [0.0, 0.02]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let shape = shape(&corners, RADIUS);
    let place = upright(Vec3::new(0.02, 0.05, RADIUS));
    let velocity = Vec3::new(speed, -0.5 * speed, 0.0);
    let case = Case::new(step, 0.0, 0.0).floor();
    let mut case = case.clump(&shape, place, velocity, Vec3::z() * spin);
    case.scene.settings.rest_speed = 4.0 * speed;
    let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
    let momentum = velocity * shape.mass;
    let about = place.0.cross(&momentum).z + inertia(&shape)[(2, 2)] * spin;
    let (mut booked, mut moves) = (Vec3::zeros(), true);
    // The step after the last that moves books it.
    while moves {
        assert!(simulation.time() < 3.0, "it never sleeps");
        moves = simulation.velocity(0) != Twist::default();
        simulation.advance(step).expect("a step");
        let Wrench { force, torque } = simulation.mean_wrench(0);
        booked += Vec3::new(force.x, force.y, torque.z) * step;
    }
    for (booked, had) in booked.iter().zip([momentum.x, momentum.y, about]) {
        close(*booked, had, 1e-6, 0.0);
    }
}

/// A heap comes to rest: no sweeps, no motion, forces that carry its weight; a floor that moves away wakes it, and the spheres
/// fall with gravity.
#[test]
fn a_scene_at_rest_costs_nothing_and_wakes() {
    // Without resistance spheres roll on for ever.
    let mut case = heap(3, 1e-3)
        .tolerance(1e-5, 1e-5, 1e-6)
        .resistance(0.1, 0.1);
    case.scene.settings.rest_speed = 1e-5;
    let weight = case.scene.particles.mass.iter().sum::<f64>() * G;
    let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
    let floor = 4;
    let mut end = 0.0;
    let mut at_rest = |simulation: &mut Simulation| {
        end += 0.01;
        let sweeps = simulation.advance_to(end).expect("a step").sweeps;
        sweeps == 0 && (0..27).all(|i| simulation.velocity(i).linear == Vec3::zeros())
    };
    assert!(
        (0..1000).any(|_| at_rest(&mut simulation)),
        "it never rests"
    );
    let before = simulation.kinematics().position.clone();
    assert!((0..10).all(|_| at_rest(&mut simulation)));
    assert_eq!(simulation.kinematics().position, before);
    assert!((0..27).all(|i| simulation.velocity(i).linear == Vec3::zeros()));
    let carried = (0..=floor).map(|b| -simulation.mean_wrench(b).force.z);
    close(carried.sum(), weight, 1e-4, 0.0);
    let kinetic = |simulation: &Simulation| {
        let mass = &simulation.scene().particles.mass;
        (0..27)
            .map(|i| 0.5 * mass[i] * simulation.velocity(i).linear.norm_squared())
            .sum::<f64>()
    };
    assert_eq!(kinetic(&simulation), 0.0);

    let away = Command {
        velocity: Vec3::new(0.0, 0.0, -1.0),
        ..Command::default()
    };
    simulation.command(floor, away).expect("an input");
    let start = simulation.time();
    simulation.advance_to(start + 0.02).expect("a step");
    // Side walls rub on those that touch them: the fastest falls freely.
    let fastest = (0..27)
        .map(|i| -simulation.velocity(i).linear.z)
        .fold(0.0, f64::max);
    // The floor's force ends with the half step in which it leaves.
    assert!((fastest - G * 0.02).abs() <= 0.51 * G * 1e-3, "{fastest}");
}

/// With bounded sweeps a step never fails and never takes more of them; more sweeps leave smaller residuals.
#[test]
fn bounded_sweeps_bound_the_work_and_tell_the_error() {
    let worst = |sweeps: usize| {
        let mut case = heap(4, 1e-3).tolerance(1e-12, 1e-12, 1e-12);
        case.scene.settings.sweeps = Some(sweeps);
        let mut simulation = Simulation::new(Arc::new(case.scene)).expect("a start");
        let mut last = 0.0;
        for k in 1..=400 {
            let report = simulation.advance_to(1e-3 * f64::from(k)).expect("a step");
            assert!(report.sweeps <= sweeps as u64 * report.internal_steps);
            last = report.max_overlap;
            assert!(report.gap_residual.is_finite());
        }
        last
    };
    let [few, many] = [5, 50].map(worst);
    assert!(few > 0.0 && many < 0.2 * few, "{few:e} {many:e}");
}
