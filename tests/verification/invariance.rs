//! Row 22: the answer does not depend on where the scene lies, how it is turned, how its spheres are numbered, or on the
//! penalty number.

use nalgebra::UnitQuaternion;
use sphere_dda::Vec3;
use sphere_dda::solver::SolverKind;

use crate::support::{Case, G, Run};

const RADIUS: f64 = 0.1;

/// A scene, seen from elsewhere: turned by `rotation`, moved by `shift`, spheres in another order.
#[derive(Clone)]
struct View {
    rotation: UnitQuaternion<f64>,
    shift: Vec3,
    /// `order[k]`: which sphere of the scene is sphere k here.
    order: Vec<usize>,
    penalty: f64,
    solver: SolverKind,
}

/// Sphere: radius, centre, velocity, spin.
type Ball = (f64, Vec3, Vec3, Vec3);
/// Point and normal.
type Wall = (Vec3, Vec3);

impl View {
    fn plain(count: usize) -> Self {
        Self {
            rotation: UnitQuaternion::identity(),
            shift: Vec3::zeros(),
            order: (0..count).collect(),
            penalty: 1e6,
            solver: SolverKind::Auto,
        }
    }

    /// Turned, moved by 1e4 R, in other orders, with the penalty from 1e4 to 1e8 N/m.
    fn others(count: usize) -> Vec<(&'static str, Self)> {
        let plain = Self::plain(count);
        let turn = UnitQuaternion::from_scaled_axis(Vec3::new(1.0, -0.7, 2.1));
        let reversed: Vec<usize> = (0..count).rev().collect();
        let dealt: Vec<usize> = (0..count).map(|k| (7 * k + 3) % count).collect();
        assert!((0..count).all(|k| dealt.contains(&k)), "a permutation");
        let mut views = vec![
            (
                "turned",
                Self {
                    rotation: turn,
                    ..plain.clone()
                },
            ),
            (
                "moved",
                Self {
                    shift: Vec3::new(-0.6, 0.0, 0.8) * (1e4 * RADIUS),
                    ..plain.clone()
                },
            ),
            (
                "reversed",
                Self {
                    order: reversed,
                    ..plain.clone()
                },
            ),
            (
                "dealt",
                Self {
                    order: dealt,
                    ..plain.clone()
                },
            ),
        ];
        for penalty in [1e4, 1e5, 1e7, 1e8] {
            let solver = SolverKind::Direct;
            views.push((
                "penalty",
                Self {
                    penalty,
                    solver,
                    ..plain.clone()
                },
            ));
        }
        views
    }

    fn run(&self, case: Case, balls: &[Ball], walls: &[Wall]) -> Run {
        let gravity = case.scene.settings.gravity;
        let mut case = case.settings(|s| {
            s.gravity = self.rotation * gravity;
            s.penalty = Some(self.penalty);
            s.solver = self.solver;
        });
        for (point, normal) in walls {
            case = case.plane(self.rotation * point + self.shift, self.rotation * normal);
        }
        for &k in &self.order {
            let (radius, x, v, w) = balls[k];
            case = case.body(
                radius,
                self.rotation * x + self.shift,
                self.rotation * v,
                self.rotation * w,
                Default::default(),
            );
        }
        case.start()
    }

    /// Position, velocity and spin of the scene's sphere `k`, seen from the scene.
    fn ball(&self, run: &Run, k: usize) -> [Vec3; 3] {
        let here = self.order.iter().position(|&i| i == k).expect("a sphere");
        let back = self.rotation.inverse();
        let state = run.simulation.kinematics();
        [
            back * (state.position[here] - self.shift),
            back * state.velocity[here],
            back * state.spin[here],
        ]
    }

    /// Force on each wall, seen from the scene.
    fn walls(&self, run: &Run, count: usize) -> Vec<Vec3> {
        (0..count)
            .map(|b| self.rotation.inverse() * run.force_on_boundary(b))
            .collect()
    }
}

/// (a) One step of a tree of ten contacts: a chain of nine spheres flies onto the floor with one end and is hit at the other by
/// a tenth; stick, slip and a contact that opens. A tree of rigid contacts has one solution only.
#[test]
fn one_step_of_ten_contacts() {
    let (dt, speed) = (1e-2, 2.0);
    let mut balls: Vec<Ball> = Vec::new();
    let mut x = Vec3::new(0.0, 0.0, RADIUS);
    for k in 0..10 {
        let bend = f64::from(k);
        let velocity = Vec3::new(0.3 * bend.sin(), 0.2 * bend.cos(), -1.0 - 0.1 * bend);
        let spin = Vec3::new(bend.cos(), 2.0 * bend.sin(), 1.0) * 3.0;
        balls.push((
            RADIUS,
            x,
            if k == 9 { velocity * speed } else { velocity },
            spin,
        ));
        x += Vec3::new((1.3 * bend).sin(), (1.3 * bend).cos(), 2.0).normalize() * (2.0 * RADIUS);
    }
    let walls = [(Vec3::zeros(), Vec3::z())];
    let one_step = |view: &View| {
        // Coordinates of 1e4 R carry a gap to 2e-12 R and no better.
        let case = Case::new(dt, 0.3, 0.4)
            .tolerance(1e-11, 1e-13, 1e-13)
            .settings(|s| s.max_iterations = 1_000_000);
        let mut run = view.run(case, &balls, &walls);
        run.step();
        run
    };
    let plain = View::plain(10);
    let expected = one_step(&plain);
    assert_eq!(expected.simulation.report().cuts, 0);
    let loaded = expected.simulation.contacts().len();
    assert!(loaded >= 8, "{loaded} of ten contacts are loaded");
    let force = plain.walls(&expected, 1)[0];
    for (name, view) in View::others(10) {
        let found = one_step(&view);
        assert_eq!(found.simulation.report().cuts, 0, "{name}");
        for k in 0..10 {
            let [a, b] = [(&plain, &expected), (&view, &found)].map(|(v, run)| v.ball(run, k));
            let error = (a[0] - b[0])
                .norm()
                .max(dt * (a[1] - b[1]).norm())
                .max(dt * RADIUS * (a[2] - b[2]).norm());
            assert!(
                error < 1e-11 * RADIUS,
                "{name} {}: sphere {k} is off by {error:e} m",
                view.penalty
            );
        }
        let off = (view.walls(&found, 1)[0] - force).norm() / force.norm();
        assert!(off < 1e-11, "{name} {}: force off by {off:e}", view.penalty);
    }
}

/// (b) Few bodies without chaos over one second: three spheres that slide, roll and bounce on two walls, each for itself.
#[test]
fn one_second_of_few_bodies() {
    let balls: [Ball; 3] = [
        (
            RADIUS,
            Vec3::new(0.3, 0.0, RADIUS),
            Vec3::new(1.0, 0.5, 0.0),
            Vec3::zeros(),
        ),
        (
            RADIUS,
            Vec3::new(0.3, 1.0, 0.35),
            Vec3::new(0.4, 0.0, 0.0),
            Vec3::new(5.0, 3.0, 2.0),
        ),
        (
            2.0 * RADIUS,
            Vec3::new(0.5, 2.0, 0.2),
            Vec3::new(-1.2, 0.3, 0.0),
            Vec3::zeros(),
        ),
    ];
    let walls = [(Vec3::zeros(), Vec3::z()), (Vec3::zeros(), Vec3::x())];
    let second = |view: &View| {
        let case = Case::new(1e-3, 0.25, 0.6).tolerance(1e-11, 1e-11, 1e-11);
        let mut run = view.run(case, &balls, &walls);
        run.steps(1000);
        run
    };
    let plain = View::plain(3);
    let expected = second(&plain);
    for (name, view) in View::others(3) {
        let found = second(&view);
        for k in 0..3 {
            let [a, b] = [(&plain, &expected), (&view, &found)].map(|(v, run)| v.ball(run, k));
            let error = (a[0] - b[0])
                .norm()
                .max((a[1] - b[1]).norm())
                .max(RADIUS * (a[2] - b[2]).norm());
            assert!(
                error < 1e-9,
                "{name} {}: sphere {k} is off by {error:e}",
                view.penalty
            );
        }
    }
}

/// (c) A pile of twenty falls into a corner of three walls: overlap and momentum as always; centre of mass and floor force from
/// every view within the scatter of five seeds, and the floor carries the weight at rest.
#[test]
fn a_pile_from_every_view() {
    let balls = |seed: usize| -> Vec<Ball> {
        (0..20)
            .map(|k| {
                let jitter = |a: f64| 0.2 * RADIUS * ((k + 20 * seed) as f64 * a).sin();
                let cell = Vec3::new((k % 2) as f64, (k / 2 % 2) as f64, (k / 4) as f64);
                let x = cell * (2.5 * RADIUS) + Vec3::repeat(1.5 * RADIUS);
                let off = Vec3::new(jitter(12.9), jitter(78.2), jitter(37.7));
                (RADIUS, x + off, Vec3::zeros(), Vec3::zeros())
            })
            .collect()
    };
    let side = 6.0 * RADIUS;
    let walls = [
        (Vec3::zeros(), Vec3::z()),
        (Vec3::zeros(), Vec3::x()),
        (Vec3::zeros(), Vec3::y()),
        (Vec3::x() * side, -Vec3::x()),
        (Vec3::y() * side, -Vec3::y()),
    ];
    let settled = |view: &View, seed: usize| {
        let case = Case::new(2e-3, 0.4, 0.0);
        let mut run = view.run(case, &balls(seed), &walls);
        run.steps(500);
        let (mut floor, mean) = (0.0, 100);
        for _ in 0..mean {
            run.step();
            floor -= view.walls(&run, 5)[0].z / f64::from(mean);
        }
        let height = (0..20).map(|k| view.ball(&run, k)[0].z).sum::<f64>() / 20.0;
        let weight = 20.0 * run.mass(0) * G;
        (height, floor / weight)
    };
    let seeds: Vec<(f64, f64)> = (0..5).map(|seed| settled(&View::plain(20), seed)).collect();
    let range = |of: fn(&(f64, f64)) -> f64| {
        let values = seeds.iter().map(of);
        (
            values.clone().fold(f64::INFINITY, f64::min),
            values.fold(0.0, f64::max),
        )
    };
    let ((low, high), (light, heavy)) = (range(|s| s.0), range(|s| s.1));
    let (scatter, sway) = (high - low, heavy - light);
    for (name, view) in View::others(20) {
        let (height, floor) = settled(&view, 0);
        assert!(
            height > low - scatter && height < high + scatter,
            "{name} {}: {height}",
            view.penalty
        );
        assert!(
            floor > light - sway && floor < heavy + sway,
            "{name} {}: {floor}",
            view.penalty
        );
    }
}
