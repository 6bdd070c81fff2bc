//! What the triangles of boundaries feel.
//!
//! ```text
//! sum of traction A = average force on the boundary        (in every step of every case: `support::Run::check_walls`)
//! sum of friction   = the ledger's friction, where nothing else rubs; impacts likewise
//! wear              = k F_n s   (Archard, J. Appl. Phys. 24, 1953, 981)
//! ```

use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::geometry::{Facets, Shape};
use sphere_dda::observe::Observation;
use sphere_dda::observe::walls::{Interval, Reading, Totals, readings};
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Motion, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::spatial::Twist;

use crate::support::{Case, G, Run, close, grid};

const RADIUS: f64 = 0.1;
const FRICTION: f64 = 0.3;
/// Wear coefficient \[1/Pa\].
const WEAR: f64 = 2e-11;
/// Length and width of a cell of the strip, two triangles \[m\].
const CELL: f64 = 0.2;

/// A flat strip of `n` cells along x from the origin, y from 0 to [`CELL`].
fn strip(n: u32) -> Vec<Shape> {
    let at = |i: u32, j: u32| Vec3::new(f64::from(i) * CELL, f64::from(j) * CELL, 0.0);
    vec![grid(n, 1, at).into()]
}

fn block(x: f64, y: f64, speed: f64) -> Case {
    let centre = Vec3::new(x, y, RADIUS);
    Case::new(1e-3, FRICTION, 0.0)
        .tolerance(1e-12, 1e-12, 1e-12)
        .body(
            RADIUS,
            centre,
            Vec3::x() * speed,
            Vec3::zeros(),
            Locks::ROTATIONS,
        )
}

fn felt(run: &Run) -> Vec<Reading> {
    readings(&Observation::of(&run.simulation), 0, Interval::Step)
}

fn totals(run: &Run) -> Totals {
    Totals::of(&Observation::of(&run.simulation), 0)
}

/// A block slides along a strip until it stops: `s = v_0^2/(2 mu g)`. It wears off `k m g s`, on each triangle the share of the path
/// over it, to the path of a step.
#[test]
fn a_block_wears_its_path() {
    let (speed, start, y) = (1.4, 0.037, 0.05);
    let mut run = block(start, y, speed).wall(strip(4)).felt(WEAR).start();
    let weight = run.mass(0) * G;
    while run.simulation.time() < 0.5 {
        run.step();
        let path = run.position(0).x - start;
        let totals = totals(&run);
        close(
            totals.wear,
            WEAR * weight * path,
            1e-12,
            1e-6 * WEAR * weight,
        );
        close(totals.friction, run.simulation.work().friction, 1e-13, 1e-9);
        assert_eq!(totals.impact, 0.0);
    }
    let path = run.position(0).x - start;
    close(path, speed * speed / (2.0 * FRICTION * G), 2e-3, 0.0);
    // Under the diagonal a cell's first triangle has x from y to its end, the other one all before.
    let end = start + path;
    for (t, triangle) in felt(&run).iter().enumerate() {
        let cell = (t / 2) as f64 * CELL;
        let span = match t % 2 {
            0 => (cell + y, cell + CELL),
            _ => (cell, cell + y),
        };
        let own = (span.1.min(end) - span.0.max(start)).max(0.0);
        let found = triangle.sums.wear / (WEAR * weight);
        assert!(
            (found - own).abs() <= 2.0 * speed * 1e-3,
            "triangle {t}: {found} m instead of {own} m"
        );
        close(
            triangle.sums.friction,
            found * FRICTION * weight,
            1e-9,
            1e-9,
        );
    }
}

/// A strip that runs under a block that is held: steps of a twentieth of a cell leave the same wear, to rounding, on all triangles that
/// it has passed over whole.
#[test]
fn a_moving_strip_wears_evenly() {
    let speed = CELL / 20.0 / 1e-3;
    let along = Motion::Constant(Twist {
        linear: Vec3::x() * -speed,
        angular: Vec3::zeros(),
    });
    // It starts half a step's path behind a border.
    let start = CELL + 0.5 * speed * 1e-3;
    let mut case = block(start, 0.5 * CELL, 0.0)
        .moving(strip(6), along)
        .felt(WEAR);
    case.scene.particles.locks[0].translation[0] = true;
    let mut run = case.start();
    let weight = run.mass(0) * G;
    run.steps(60);
    let path = speed * 0.06;
    close(totals(&run).wear, WEAR * weight * path, 1e-12, 0.0);
    close(totals(&run).friction, FRICTION * weight * path, 1e-12, 0.0);
    let triangles = felt(&run);
    for triangle in &triangles[2..8] {
        let own = WEAR * weight * CELL / 2.0;
        close(triangle.sums.wear, own, 1e-11, 0.0);
    }
    assert_eq!(triangles[0].sums.wear, 0.0);
    assert_eq!(triangles[8].sums.wear, 0.0);
}

/// A belt under a block that is held: the shape stays, all is felt where the block is, `mu m g V t` and `k m g V t`.
#[test]
fn a_belt_wears_where_it_is_touched() {
    let speed = 0.7;
    let mut case = block(0.15, 0.02, 0.0)
        .wall(strip(1))
        .belt(Vec3::x() * speed)
        .felt(WEAR);
    case.scene.particles.locks[0].translation[0] = true;
    let mut run = case.start();
    let weight = run.mass(0) * G;
    for _ in 0..100 {
        run.step();
        let path = speed * run.simulation.time();
        let [first, second] = felt(&run)[..] else {
            panic!("two triangles");
        };
        close(first.sums.friction, FRICTION * weight * path, 1e-12, 0.0);
        close(first.sums.wear, WEAR * weight * path, 1e-12, 0.0);
        close(first.load.normal, weight, 1e-12, 0.0);
        close(first.load.shear.x, -FRICTION * weight, 1e-12, 0.0);
        assert_eq!(first.load.shear.z, 0.0);
        assert_eq!(second.sums, Default::default());
    }
}

/// Spheres at rest in a heap on a floor of two rectangles: pressures times areas are the weight, and nothing wears.
#[test]
fn what_rests_presses_with_its_weight() {
    let mut case = Case::new(1e-3, 0.5, 0.0).tolerance(1e-9, 1e-9, 1e-9);
    for (i, j) in [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)] {
        let x = Vec3::new(f64::from(i), f64::from(j), 0.5) * (2.0 * RADIUS);
        case = case.sphere(RADIUS, x, Vec3::zeros());
    }
    let top = Vec3::new(1.0, 1.0, 1.0 + 2.0_f64.sqrt()) * RADIUS;
    case = case.sphere(RADIUS, top, Vec3::zeros());
    let mut run = case.wall(strip(3)).felt(WEAR).start();
    let weight: f64 = (0..7).map(|i| run.mass(i) * G).sum();
    for _ in 0..200 {
        let triangles = felt(&run);
        let normal: f64 = triangles.iter().map(|t| t.load.normal).sum();
        let force: Vec3 = triangles.iter().map(|t| t.load.force).sum();
        close(normal, weight, 1e-8, 0.0);
        assert!(
            (force + Vec3::z() * weight).norm() < 1e-8 * weight,
            "{force:?}"
        );
        run.step();
    }
    let rubbed = totals(&run);
    assert!(rubbed.wear <= 1e-8 * WEAR * weight * RADIUS, "{rubbed:?}");
    assert!(rubbed.friction.abs() <= 1e-8 * weight * RADIUS);
}

/// A sphere that sleeps presses on: steps in which nothing moves count as others do (`support::Run::check_walls`).
#[test]
fn what_sleeps_presses_on() {
    let mut run = Case::new(1e-3, 0.5, 0.0)
        .settings(|s| s.rest_speed = 1e-2)
        .wall(strip(1))
        .felt(WEAR)
        .sphere(RADIUS, Vec3::new(0.15, 0.03, RADIUS), Vec3::zeros())
        .start();
    let weight = run.mass(0) * G;
    run.steps(60);
    close(felt(&run)[0].load.normal, weight, 1e-6, 0.0);
}

/// One impact on one triangle, without gravity: `(1 - e^2) m u_n^2/2` on it, nothing on the other.
#[test]
fn an_impact_is_felt_where_it_is() {
    for e in [0.4, 0.9] {
        let mut run = Case::new(1e-3, 0.2, e)
            .without_gravity()
            .tolerance(1e-12, 1e-12, 1e-12)
            .wall(strip(1))
            .felt(WEAR)
            .sphere(
                RADIUS,
                Vec3::new(0.15, 0.03, RADIUS + 0.0103),
                Vec3::new(0.5, 0.0, -3.0),
            )
            .start();
        run.steps(20);
        let scale = run.mass(0) * 9.0 / 2.0;
        let [first, second] = felt(&run)[..] else {
            panic!("two triangles");
        };
        close(first.sums.impact, (1.0 - e * e) * scale, 1e-9, 0.0);
        close(first.sums.impact, run.simulation.work().impact, 1e-14, 0.0);
        close(
            first.sums.friction,
            run.simulation.work().friction,
            1e-14,
            0.0,
        );
        assert!(first.sums.friction > 0.0 && first.sums.wear > 0.0);
        assert_eq!(second.sums, Default::default());
    }
}

/// A pyramid of four triangles, its side through the origin 1 m long, tip at the height 0.2 m.
fn pyramid() -> Vec<Shape> {
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let vertices = vec![
        corner(-0.5, -0.5),
        corner(0.5, -0.5),
        corner(0.5, 0.5),
        corner(-0.5, 0.5),
        Vec3::z() * 0.2,
    ];
    let sides = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    vec![Facets::mesh("pyramid", vertices, sides).into()]
}

/// On an edge two triangles share an impact, on a tip all four.
#[test]
fn edges_and_tips_are_shared() {
    // Half way up the edge between the first two sides, and over the tip.
    for (x, shares) in [
        (Vec3::new(0.25, -0.25, 0.1), [0.5, 0.5, 0.0, 0.0]),
        (Vec3::z() * 0.2, [0.25; 4]),
    ] {
        let mut run = Case::new(1e-3, 0.0, 0.5)
            .without_gravity()
            .wall(pyramid())
            .felt(WEAR)
            .sphere(RADIUS, x + Vec3::z() * (RADIUS + 0.0203), Vec3::z() * -3.0)
            .start();
        run.steps(30);
        let all = run.simulation.work().impact;
        assert!(all > 0.0);
        for (triangle, share) in felt(&run).iter().zip(shares) {
            close(triangle.sums.impact, share * all, 1e-12, all);
        }
    }
}

/// A sphere that rolls out in a turning drum, with chosen steps and resistance: all of the ledger's losses are the drum's.
#[test]
fn a_drum_feels_all_that_is_lost() {
    let mut run = Case::new(1e-3, 0.4, 0.3)
        .resistance(0.05, 0.02)
        .settings(|s| s.smallest_step = Some(1e-4))
        .drum(0.5, 3.0)
        .felt(WEAR)
        .sphere(RADIUS, Vec3::new(0.1, 0.0, -0.2), Vec3::new(0.3, 0.2, 0.0))
        .start();
    for _ in 0..500 {
        run.advance(2e-3);
        let (own, all) = (totals(&run), run.simulation.work());
        close(own.friction, all.friction, 1e-12, 0.0);
        close(own.impact, all.impact, 1e-12, 0.0);
    }
    assert!(run.simulation.work().friction > 0.0 && run.simulation.work().impact > 0.0);
    let worn = felt(&run).iter().filter(|t| t.sums.wear > 0.0).count();
    assert!(worn > 10, "{worn} triangles");
}

/// A spring under a boundary: its damper's losses are impacts, also where the contact opens.
#[test]
fn dampers_are_felt() {
    let mut case = Case::new(1e-4, 0.0, 0.5).wall(strip(2)).felt(WEAR);
    case.scene.boundaries[0].stiffness = Some(1e5);
    let mut run = case
        .sphere(RADIUS, Vec3::new(0.2, 0.1, 0.12), Vec3::z() * -1.0)
        .start();
    run.steps(3000);
    let all = run.simulation.work();
    assert!(all.impact > 0.0);
    close(totals(&run).impact, all.impact, 1e-12, 0.0);
}

/// Means over the interval of frames, and over the communication step.
#[test]
fn means_are_over_their_intervals() {
    let mut case = block(0.15, 0.02, 0.0).wall(strip(1)).felt(WEAR);
    case.scene.initial.position[0].z += 0.02;
    case.scene.output.vtu_interval = 0.05;
    let mut run = case.start();
    let (mut impulse, mut since) = (0.0, 0.0);
    for k in 0..120 {
        if k % 50 == 0 {
            (impulse, since) = (0.0, run.simulation.time());
        }
        run.step();
        let state = Observation::of(&run.simulation);
        impulse -= state.boundaries[0].mean_wrench.force.z * 1e-3;
        let mean = |interval| readings(&state, 0, interval)[0].load.normal;
        close(
            mean(Interval::Frame) * (state.time - since),
            impulse,
            1e-12,
            0.0,
        );
        let now = -state.boundaries[0].mean_wrench.force.z;
        close(mean(Interval::Step), now, 1e-12, 0.0);
    }
}

/// Grains rub and roll on steel alone.
const HEAD: &str = r#"
[simulation]
duration = 1.0
communication_step = 5e-3
rest_speed = 1e-2
[[material]]
name = "grain"
density = 2500.0
[[material]]
name = "steel"
[[pair]]
materials = ["grain", "grain"]
restitution = 0.2
[[pair]]
materials = ["grain", "steel"]
friction = 0.4
rolling_friction = 0.03
twisting_friction = 0.01
restitution = 0.3
wear = 1e-11
"#;
/// Grains in a box that is shaken, or not.
const PAN: &str = r#"
[[spheres]]
name = "bed"
material = "grain"
radius = 0.03
packing = { region = { box = { min = [-0.25, -0.25, 0.05], max = [0.25, 0.25, 0.3] } }, count = 60 }
[[boundary]]
name = "pan"
material = "steel"
wall_fields = true
faces = [{ box = { min = [-0.3, -0.3, 0.0], max = [0.3, 0.3, 0.8] } }]
"#;
const SHAKEN: &str = "motion = { sinusoid = { translation = [0.02, 0.0, 0.01], rotation = [0.0, 0.1, 0.0], frequency = 6.0 } }";
/// Grains fall through a turning hopper onto a flap that gives way.
const HOPPER: &str = r#"
[[source]]
name = "feed"
material = "grain"
radius = 0.025
capacity = 40
seed = 3
rate = 60.0
region = { box = { min = [-0.1, -0.1, 0.5], max = [0.1, 0.1, 0.6] } }
velocity = [0.0, 0.0, -1.0]
[[sink]]
name = "out"
region = { box = { min = [-3.0, -3.0, -3.0], max = [3.0, 3.0, -0.4] } }
[[boundary]]
name = "hopper"
material = "steel"
wall_fields = true
faces = [
  { cone = { base = [0.0, 0.0, 0.0], r0 = 0.1, r1 = 0.35, height = 0.4 } },
  { cylinder = { base = [0.0, 0.0, 0.4], radius = 0.35, height = 0.4 } },
]
motion = { constant = { angular_velocity = [0.0, 0.0, 4.0] } }
[[boundary]]
name = "flap"
material = "steel"
wall_fields = true
point_of_action = [0.0, 0.0, -0.1]
faces = [{ rectangle = { corner = [-0.3, -0.3, -0.1], u = [0.6, 0.0, 0.0], v = [0.0, 0.6, 0.0] } }]
body = { mass = 3.0, inertia = [0.2, 0.2, 0.4], centre = [0.0, 0.0, -0.1], joint = { hinge = [0.0, 1.0, 0.0] }, angular_damping = 0.1 }
"#;

/// Three scenes with all else on: tractions and losses add up, and what a step began with comes back bit for bit.
#[test]
fn all_else_on_the_sums_hold() {
    let scenes = [[PAN, SHAKEN], [PAN, ""], [HOPPER, ""]];
    for (number, parts) in scenes.iter().enumerate() {
        let text = format!("{HEAD}{}{}", parts[0], parts[1]);
        let loaded = Scene::from_toml("scene", &text, Path::new(""));
        let scene = loaded
            .unwrap_or_else(|error| panic!("{}", error.plain()))
            .scene;
        let boundaries = scene.boundaries.len();
        let mut run = Run {
            simulation: Simulation::new(Arc::new(scene)).expect("it starts"),
        };
        for k in 0..100 {
            let before = run.simulation.snapshot();
            run.simulation.advance(5e-3).expect("a step");
            run.check_walls();
            if k % 20 == 0 {
                let after = run.simulation.snapshot();
                run.simulation.restore(&before).expect("a restored state");
                run.simulation.advance(5e-3).expect("a step");
                assert!(
                    run.simulation.snapshot() == after,
                    "scene {number}, step {k}"
                );
            }
        }
        let state = Observation::of(&run.simulation);
        let friction: f64 = (0..boundaries)
            .map(|b| Totals::of(&state, b).friction)
            .sum();
        // What grains exchange along their normals has, from sweeps in single precision, a rounding across them.
        close(friction, state.work.friction, 1e-7, 0.0);
        assert!(friction > 0.0);
        let wear: f64 = (0..boundaries).map(|b| Totals::of(&state, b).wear).sum();
        assert!(wear > 0.0);
    }
}
