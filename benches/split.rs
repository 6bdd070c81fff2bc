//! What splitting a step among ranks costs in sweeps: the numbers of docs/scaling.md.
//!
//! `cargo bench --bench split [-- bed deep]` catches problems along the settling of a bed and solves each from its warm start, the spheres
//! divided into bricks, to the scene's tolerance by the judge's own residual. Rows belong to the brick of their body A. *added*: each brick sweeps
//! its rows against what its neighbours' spheres did in the sweep before, then all changes are added. *mass split*: the same,
//! but a sphere that rows of k bricks touch has a k-th of its mass in each, and the mean of its velocities after the sweep: it cannot
//! overshoot. *border last*: rows between bricks are swept after all others with all changes known, which is Gauss-Seidel in another order.
//! Momentum and its new starts are those of the solver. One thread does all of it: counts, no times.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::problem::{GROUND, Impulses, Problem};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::Tolerance;
use sphere_dda::solver::residual::{Scale, evaluate};
use sphere_dda::spatial::SpatialVector;

/// Bricks along x, y and z.
const SPLITS: [[usize; 3]; 7] = [
    [1, 1, 1],
    [2, 1, 1],
    [4, 1, 1],
    [2, 2, 1],
    [4, 4, 1],
    [2, 2, 2],
    [4, 4, 2],
];
const MOST_SWEEPS: usize = 3000;
/// The first sweep with momentum, and the sweep from which updates are damped, as in the solver.
const MOMENTUM_FROM: usize = 4;
const DAMP_AFTER: usize = 300;

fn main() {
    let wanted: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| !a.starts_with('-'))
        .collect();
    for (name, load) in [("bed", bed as fn() -> Scene), ("deep", deep)] {
        if wanted.is_empty() || wanted.iter().any(|a| a == name) {
            table(name, &captured(load()));
        }
    }
}

fn bed() -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/dropped/dropped.toml");
    let loaded = Scene::from_file(file);
    loaded.expect("the example is a good scene").scene
}

/// 4000 spheres, half as wide and eight times as deep as `bed`, so that a brick has neighbours above and below it too.
fn deep() -> Scene {
    let text = "[simulation]\nduration = 0.6\nstep = 5e-4\nfixed_step = true\nstrict = true\n\
        tolerance = { gap = 1e-4, slip = 1e-4, force = 1e-1, opening = 0 }\n\
        [[material]]\nname = 'glass'\ndensity = 2500.0\n[pair_default]\nfriction = 0.5\n\
        [[spheres]]\nname = 'bed'\nmaterial = 'glass'\nradius = 0.01\nradius_jitter = 0.1\nseed = 1\n\
        lattice = { origin = [-0.108, -0.108, 0.012], count = [10, 10, 40], spacing = 0.024, jitter = 0.05 }\n\
        [[boundary]]\nname = 'box'\nmaterial = 'glass'\nfaces = [\n\
        { plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } },\n\
        { plane = { point = [-0.12, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } },\n\
        { plane = { point = [0.12, 0.0, 0.0], normal = [-1.0, 0.0, 0.0] } },\n\
        { plane = { point = [0.0, -0.12, 0.0], normal = [0.0, 1.0, 0.0] } },\n\
        { plane = { point = [0.0, 0.12, 0.0], normal = [0.0, -1.0, 0.0] } } ]\n";
    let loaded = Scene::from_toml("deep", text, Path::new("."));
    loaded.expect("a good scene").scene
}

/// How bricks hear of each other.
#[derive(Clone, Copy, PartialEq)]
enum Scheme {
    Added,
    MassSplit,
    BorderLast,
}

const SCHEMES: [Scheme; 3] = [Scheme::Added, Scheme::MassSplit, Scheme::BorderLast];

/// A problem, its warm start and where its spheres are.
struct Captured {
    problem: Problem,
    start: Impulses,
    places: Vec<Vec3>,
}

/// 24 problems along a run.
fn captured(scene: Scene) -> Vec<Captured> {
    let (duration, step) = (scene.settings.duration, scene.settings.step);
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    (1..=24)
        .map(|k| {
            let time = duration * f64::from(k) / 24.0;
            simulation.advance_to(time).expect("a step");
            let (problem, start) = simulation.problem(step).expect("a problem");
            let places = simulation.kinematics().position.clone();
            Captured {
                problem,
                start,
                places,
            }
        })
        .collect()
}

fn table(name: &str, problems: &[Captured]) {
    let bodies = problems[0].problem.free.len();
    println!(
        "{name}: {bodies} spheres, mean over {} problems",
        problems.len()
    );
    println!(
        "| bricks | spheres a brick | rows across | added | mass split | border last |\n|---|---|---|---|---|---|"
    );
    for split in SPLITS {
        let (mut across, mut rows) = (0, 0);
        let mut sweeps = [0; 3];
        let mut unsolved = [0; 3];
        for captured in problems {
            let brick = bricks(&captured.places, split);
            let crossing = |row: &sphere_dda::problem::Row| {
                row.b != GROUND && brick[row.a as usize] != brick[row.b as usize]
            };
            let list = &captured.problem.rows;
            across += list.iter().filter(|row| crossing(row)).count();
            rows += list.len();
            for (k, scheme) in SCHEMES.into_iter().enumerate() {
                match solve(captured, &brick, scheme) {
                    Some(found) => sweeps[k] += found,
                    None => unsolved[k] += 1,
                }
            }
        }
        let mean = |k: usize| {
            let solved = problems.len() - unsolved[k];
            let sweeps = sweeps[k] as f64 / solved as f64;
            match unsolved[k] {
                0 => format!("{sweeps:.1}"),
                missing => format!("{sweeps:.1}, {missing} unsolved"),
            }
        };
        let [x, y, z] = split;
        println!(
            "| {x} x {y} x {z} | {} | {:.0} % | {} | {} | {} |",
            bodies / (x * y * z),
            100.0 * across as f64 / rows as f64,
            mean(0),
            mean(1),
            mean(2),
        );
    }
}

/// Brick of every sphere: equal numbers along each axis in turn, as recursive bisection would divide them.
fn bricks(places: &[Vec3], split: [usize; 3]) -> Vec<usize> {
    let mut groups = vec![(0..places.len()).collect::<Vec<usize>>()];
    for (axis, &parts) in split.iter().enumerate() {
        let mut finer = Vec::new();
        for mut group in groups {
            group.sort_by(|&i, &j| places[i][axis].total_cmp(&places[j][axis]));
            let size = group.len();
            finer.extend(
                (0..parts).map(|k| group[size * k / parts..size * (k + 1) / parts].to_vec()),
            );
        }
        groups = finer;
    }
    let mut brick = vec![0; places.len()];
    for (k, group) in groups.iter().enumerate() {
        group.iter().for_each(|&i| brick[i] = k);
    }
    brick
}

/// Sweeps until the residual is within the tolerance; none if they do not suffice.
fn solve(captured: &Captured, brick: &[usize], scheme: Scheme) -> Option<usize> {
    let Captured { problem, start, .. } = captured;
    let jacobi = scheme != Scheme::BorderLast;
    let tolerance = Tolerance {
        gap: 1e-4,
        slip: 1e-4,
        force: 1e-1,
    };
    let scales = Scale::of(problem);
    let count = brick.iter().max().map_or(1, |last| last + 1);
    // Rows of each brick, and those of all borders.
    let mut inside = vec![Vec::new(); count];
    let mut border = Vec::new();
    for (k, row) in problem.rows.iter().enumerate() {
        let own = brick[row.a as usize];
        if !jacobi && row.b != GROUND && brick[row.b as usize] != own {
            border.push(k);
        } else {
            inside[own].push(k);
        }
    }

    // What the bricks believe: with shares of masses where several of them move a sphere.
    let shares = match scheme {
        Scheme::MassSplit => shares(problem, brick),
        _ => vec![1.0; brick.len()],
    };
    let mut believed = problem.clone();
    for (w, share) in believed.inverse_mass.iter_mut().zip(&shares) {
        w.linear *= *share;
        w.angular *= *share;
    }
    let believed_scales = Scale::of(&believed);

    let mut p = start.clone();
    let mut v = problem.velocities(&p);
    let (mut old_p, mut old_v) = (p.clone(), v.clone());
    let (mut momentum, mut last) = (1.0f64, f64::INFINITY);
    for sweep in 1..=MOST_SWEEPS {
        let damping = if sweep > DAMP_AFTER { 0.6 } else { 1.0 };
        let mut weight = 0.0;
        if (MOMENTUM_FROM..=DAMP_AFTER).contains(&sweep) {
            let next = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
            weight = (momentum - 1.0) / next;
            momentum = next;
        }
        let before = p.clone();
        for (p, old) in p.iter_mut().zip(&mut old_p) {
            let here = *p;
            *p += (here - *old) * weight;
            *old = here;
        }
        for (v, old) in v.iter_mut().zip(&mut old_v) {
            let here = *v;
            *v = between(&here, old, -weight);
            *old = here;
        }
        let (mut along, mut change) = (0.0, 0.0);
        let mut visit = |rows: &[usize], v: &mut [SpatialVector], p: &mut Impulses| {
            for &k in rows {
                let row = &problem.rows.get(k);
                let found =
                    believed_scales[k].natural_map(row, row.relative_velocity(v), p[k], 0.0);
                let d = (row.normal * found.normal + found.tangential) * damping;
                if d != Vec3::zeros() {
                    believed.apply(row, v, d);
                    p[k] += d;
                    along += d.dot(&(p[k] - before[k]));
                    change += d.norm_squared();
                }
            }
        };
        let known = v.clone();
        for rows in &inside {
            // What the others do in this sweep is not known here.
            let mut own = if jacobi {
                known.clone()
            } else {
                std::mem::take(&mut v)
            };
            visit(rows, &mut own, &mut p);
            if jacobi {
                for (i, v) in v.iter_mut().enumerate() {
                    *v = SpatialVector {
                        linear: v.linear + (own[i].linear - known[i].linear) / shares[i],
                        angular: v.angular + (own[i].angular - known[i].angular) / shares[i],
                    };
                }
            } else {
                v = own;
            }
        }
        visit(&border, &mut v, &mut p);
        if along < 0.0 || change > last {
            momentum = 1.0;
        }
        last = change;
        if evaluate(problem, &scales, &p).within(&tolerance) {
            return Some(sweep);
        }
    }
    None
}

/// Number of bricks whose rows touch a sphere, at least one.
fn shares(problem: &Problem, brick: &[usize]) -> Vec<f64> {
    let mut touched = vec![Vec::new(); brick.len()];
    for row in problem.rows.iter() {
        let own = brick[row.a as usize];
        for body in [row.a, row.b] {
            if body != GROUND && !touched[body as usize].contains(&own) {
                touched[body as usize].push(own);
            }
        }
    }
    touched.iter().map(|by| by.len().max(1) as f64).collect()
}

/// `x + (y - x) share`.
fn between(x: &SpatialVector, y: &SpatialVector, share: f64) -> SpatialVector {
    SpatialVector {
        linear: x.linear + (y.linear - x.linear) * share,
        angular: x.angular + (y.angular - x.angular) * share,
    }
}
