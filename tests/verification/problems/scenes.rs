//! The scenes in which the problems are caught, and how.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Motion;
use sphere_dda::scene::body::Joint;
use sphere_dda::scene::particles::Locks;
use sphere_dda::scene::{Method, Scene};
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;
use sphere_dda::spatial::Twist;

use super::{Captured, params, replay};
use crate::driven::pile;
use crate::support::{Case, G};

/// Every how many steps one is looked at.
const STRIDE: usize = 8;

/// One reference problem.
pub(super) struct Reference {
    pub(super) name: &'static str,
    /// Where it is caught; none: a part of a step that was kept when it failed.
    pub(super) scene: Option<fn() -> Hunt>,
    /// Penalty the direct solver starts from \[N/m\]; none: the scene's default. Infinite: the penalty method, whose springs
    /// are in the rows.
    pub(super) penalty: Option<f64>,
}

/// A scene and the steps among which the hardest is looked for.
pub(super) struct Hunt {
    scene: Scene,
    /// First step looked at and the one after the last.
    steps: [usize; 2],
    /// Without the impulses of the step before.
    cold: bool,
    /// Gravity turns about y by this angle a step \[rad\].
    tilt: f64,
}

impl Hunt {
    fn new(case: Case, steps: [usize; 2]) -> Self {
        Self {
            scene: case.scene,
            steps,
            cold: false,
            tilt: 0.0,
        }
    }
}

/// All of them, in the order of the table.
pub(super) fn all() -> Vec<Reference> {
    let caught = |name, scene: fn() -> Hunt| Reference {
        name,
        scene: Some(scene),
        penalty: None,
    };
    let with = |reference: Reference, penalty| Reference {
        penalty: Some(penalty),
        ..reference
    };
    let kept = |name| Reference {
        name,
        scene: None,
        penalty: None,
    };
    vec![
        caught("stack", || stack(Method::Alm)),
        with(
            caught("stack_on_springs", || stack(Method::Penalty)),
            f64::INFINITY,
        ),
        caught("heavy_on_light", heavy_on_light),
        caught("silo", silo),
        caught("heap", || heap(0.0)),
        caught("heap_resists_rolling", || heap(0.05)),
        caught("bed", bed),
        caught("plate", || Hunt::new(pile(Joint::Free, 100.0), [60, 260])),
        caught("light_plate", || {
            Hunt::new(pile(Joint::Free, 1.0), [60, 260])
        }),
        caught("pressed", pressed),
        caught("servo", servo),
        with(caught("smooth_pile_soft_penalty", smooth_pile), 1e4),
        kept("hopper_12"),
        kept("hopper_16"),
    ]
}

/// Fifty spheres on each other, forces unknown: each sweep carries them one sphere on.
fn stack(method: Method) -> Hunt {
    let mut case = Case::new(1e-3, 0.5, 0.0).floor().settings(|s| {
        s.method = method;
        s.penalty = (method == Method::Penalty).then_some(1e9);
    });
    for k in 0..50 {
        let z = 0.1 + 0.2 * f64::from(k);
        case = case.sphere(0.1, Vec3::z() * z, Vec3::zeros());
    }
    Hunt {
        cold: true,
        ..Hunt::new(case, [2, 3])
    }
}

/// Walls round a square of this side about the z axis, and a floor.
fn box_of(case: Case, side: f64) -> Case {
    let mut case = case.floor();
    for outwards in [Vec3::x(), -Vec3::x(), Vec3::y(), -Vec3::y()] {
        case = case.plane(outwards * (0.5 * side), -outwards);
    }
    case
}

/// Uneven numbers in -1..1 that are the same everywhere.
fn wobble(k: i32, n: i32) -> f64 {
    (f64::from(k * n) * 1.7).sin()
}

/// A sphere of a thousand times their mass falls on a layer of fifty.
fn heavy_on_light() -> Hunt {
    let mut case = box_of(Case::new(1e-3, 0.4, 0.0), 1.1);
    for k in 0..50 {
        let (i, j, layer) = (k % 5, k / 5 % 5, k / 25);
        let z = 0.055 + 0.11 * f64::from(layer);
        let x = Vec3::new(f64::from(i) - 2.0, f64::from(j) - 2.0, 0.0) * 0.11;
        let off = Vec3::new(wobble(k, 3), wobble(k, 7), 0.0) * 0.004;
        case = case.sphere(0.05, x + off + Vec3::z() * z, Vec3::zeros());
    }
    let heavy = Vec3::new(0.01, 0.02, 0.75);
    case = case.sphere(0.5, heavy, Vec3::zeros());
    Hunt::new(case, [100, 300])
}

/// A conical silo whose mouth is two spheres wide: friction bridges it.
fn silo() -> Hunt {
    let text = r#"
[simulation]
duration = 2.0
step = 1e-3
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[[material]]
name = "grain"
density = 2500.0
[pair_default]
friction = 0.7
[[spheres]]
name = "fill"
material = "grain"
seed = 3
size = { uniform = { min = 0.045, max = 0.055 } }
packing = { region = { cylinder = { base = [0.0, 0.0, 0.35], radius = 0.4, height = 0.7 } }, count = 200 }
[[boundary]]
name = "silo"
material = "grain"
faces = [
    { cone = { base = [0.0, 0.0, 0.0], r0 = 0.1, r1 = 0.4, height = 0.3 } },
    { cylinder = { base = [0.0, 0.0, 0.3], radius = 0.4, height = 1.2 } },
]
"#;
    let loaded = Scene::from_toml("silo.toml", text, Path::new("."));
    let scene = loaded.unwrap_or_else(|e| panic!("{}", e.plain())).scene;
    Hunt {
        scene,
        steps: [150, 330],
        cold: false,
        tilt: 0.0,
    }
}

/// A pyramid of spheres on a layer that is held; the ground tilts until the heap slides.
fn heap(rolling: f64) -> Hunt {
    let mut case = Case::new(1e-3, 0.3, 0.0).resistance(rolling, 0.5 * rolling);
    let held = Locks {
        translation: [true; 3],
        rotation: [true; 3],
    };
    for layer in 0..6 {
        let n = 6 - layer;
        for k in 0..n * n {
            let shift = 0.5 * f64::from(n - 1);
            let (i, j) = (f64::from(k % n) - shift, f64::from(k / n) - shift);
            let z = f64::from(layer) * 0.5f64.sqrt();
            let locks = if layer == 0 { held } else { Locks::default() };
            let x = Vec3::new(i, j, z) * 0.1;
            case = case.body(0.05, x, Vec3::zeros(), Vec3::zeros(), locks);
        }
    }
    Hunt {
        tilt: 2e-3,
        ..Hunt::new(case, [0, 320])
    }
}

/// An example, looked at in these steps.
fn example(name: &str, steps: [usize; 2]) -> Hunt {
    let path = format!("{}/examples/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let loaded = Scene::from_file(path).unwrap_or_else(|e| panic!("{}", e.plain()));
    Hunt {
        scene: loaded.scene,
        steps,
        cold: false,
        tilt: 0.0,
    }
}

/// The thousand spheres of `examples/dropped` while they fall on each other.
fn bed() -> Hunt {
    example("dropped/dropped", [200, 320])
}

/// The start of `examples/triaxial`: servo walls close in on spheres that nothing else acts on.
fn servo() -> Hunt {
    example("triaxial/triaxial", [0, 100])
}

/// Spheres in a box under a lid with a stiffness, which presses them with many times their weight.
fn pressed() -> Hunt {
    let mut case = box_of(Case::new(1e-3, 0.4, 0.0), 0.4);
    for k in 0..27 {
        let (i, j, layer) = (k % 3, k / 3 % 3, k / 9);
        let x = Vec3::new(f64::from(i) - 1.0, f64::from(j) - 1.0, 0.0) * 0.13;
        let off = Vec3::new(wobble(k, 3), wobble(k, 7), 0.0) * 0.005;
        let z = 0.065 + 0.11 * f64::from(layer);
        case = case.sphere(0.06, x + off + Vec3::z() * z, Vec3::zeros());
    }
    let mut case = case.plane(Vec3::z() * 0.42, -Vec3::z());
    let lid = case.scene.boundaries.last_mut().expect("a lid");
    lid.stiffness = Some(1e6);
    lid.motion = Motion::Constant(Twist {
        linear: Vec3::z() * -0.2,
        angular: Vec3::zeros(),
    });
    Hunt::new(case, [200, 440])
}

/// Twenty spheres without friction settle in a box; the direct solver starts from a penalty far below `m/dt^2`.
fn smooth_pile() -> Hunt {
    let mut case = box_of(Case::new(2e-3, 0.0, 0.0), 0.6);
    for k in 0..20 {
        let cell = Vec3::new(f64::from(k % 2), f64::from(k / 2 % 2), f64::from(k / 4));
        let off = Vec3::new(wobble(k, 3), wobble(k, 5), wobble(k, 7)) * 0.02;
        let x = cell * 0.25 + Vec3::new(-0.15, -0.15, 0.15) + off;
        case = case.sphere(0.1, x, Vec3::zeros());
    }
    Hunt::new(case, [50, 400])
}

/// The step of the scene that costs Gauss-Seidel most sweeps; of those it does not solve the one that is furthest off.
pub(super) fn hardest(reference: &Reference, hunt: fn() -> Hunt) -> (Captured, usize, usize) {
    let Hunt {
        mut scene,
        steps,
        cold,
        tilt,
    } = hunt();
    scene.settings.solver = SolverKind::Auto;
    let dt = scene.settings.step;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("the scene starts");
    let mut hardest: Option<(f64, Captured, usize, usize)> = None;
    for step in 0..steps[1] {
        if tilt != 0.0 {
            let angle = tilt * step as f64;
            let gravity = Vec3::new(angle.sin(), 0.0, -angle.cos()) * G;
            simulation.set_gravity(gravity).expect("a gravity");
        }
        if step >= steps[0] && (step - steps[0]).is_multiple_of(STRIDE) {
            let mut captured = simulation.problem(dt).expect("a problem");
            if cold {
                captured.1.fill(Vec3::zeros());
            }
            let kind = SolverKind::GaussSeidel;
            let params = params(&captured.0, kind, 4000, reference.penalty);
            let (report, found) = replay(&captured, &params);
            let hardness = report.sweeps as f64 + found.gap.max(found.slip).min(0.5);
            if hardest.as_ref().is_none_or(|(h, ..)| hardness > *h) {
                hardest = Some((hardness, captured, step, report.sweeps));
            }
        }
        let stopped = simulation.advance(dt);
        // What the scene itself cannot solve is the problem wanted.
        if stopped.is_err() {
            break;
        }
    }
    let (_, captured, step, sweeps) = hardest.expect("steps");
    (captured, step, sweeps)
}
