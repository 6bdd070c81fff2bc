//! Time to a given true overlap: the bed at tolerances of 1e-4, 1e-5 and 1e-6 of the radius, other examples as they are.
//!
//! `cargo bench --bench scenes [-- ROW...]` prints one line per row, by default the rows of the bed: CPU time of this
//! thread, steps, sweeps, factorizations and the worst overlap over every internal step; for the bed also what must depend on
//! none of these: force on the floor over weight, mean height of the highest twentieth, kinetic energy. The row `features` is
//! the bed at `standard` as it is, then with one more thing each.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::Tolerance;
use sphere_dda::state::StepReport;

/// Tolerance \[-\] and step \[s\] of the rows of the bed.
const BED: [(f64, f64); 4] = [(1e-4, 5e-4), (1e-5, 2.5e-4), (1e-6, 1e-4), (1e-6, 5e-5)];
/// Rows that run as their scene says.
const EXAMPLES: [&str; 3] = ["funnel", "slopes", "feeder"];

/// What is added to the bed, or put in the place of a line of it.
const FEATURES: [(&str, &str, &str); 9] = [
    ("plain", "", ""),
    (
        "rolling",
        "friction = 0.5",
        "friction = 0.5\nrolling_friction = 0.05",
    ),
    (
        "twisting",
        "friction = 0.5",
        "friction = 0.5\nrolling_friction = 0.05\ntwisting_friction = 0.05",
    ),
    (
        "spring",
        "",
        "[[spring]]\nsphere = \"bed[500]\"\nstiffness = 1e3",
    ),
    (
        "elastic",
        "name = \"box\"",
        "name = \"box\"\nstiffness = 1e5",
    ),
    (
        "penalty",
        "accuracy = \"standard\"",
        "accuracy = \"standard\"\nmethod = \"penalty\"\npenalty = 1e5",
    ),
    (
        "stray",
        "",
        "[[spheres]]\nname = \"stray\"\nmaterial = \"glass\"\nradius = 0.01\npositions = [[0.0, 0.0, 5.0]]\nvelocity = [0.0, 0.0, 100.0]",
    ),
    (
        "slide",
        "name = \"box\"",
        "name = \"box\"\nbody = { mass = 5.0, inertia = [0.1, 0.1, 0.1], joint = { slide = [0.0, 0.0, 1.0] }, spring = { stiffness = 2e4 }, damping = 200.0 }",
    ),
    (
        "hinge",
        "name = \"box\"",
        "name = \"box\"\nbody = { mass = 5.0, inertia = [0.1, 0.1, 0.1], joint = { hinge = [0.0, 1.0, 0.0] }, spring = { stiffness = 2e3 }, damping = 20.0 }",
    ),
];

fn main() {
    let wanted: Vec<String> = std::env::args()
        .skip(1)
        .filter(|a| !a.starts_with('-'))
        .collect();
    println!(
        "row       gap    step     CPU s   steps  cuts  sweeps  a step  factors  worst    force"
    );
    for (k, (gap, step)) in BED.into_iter().enumerate() {
        let name = format!("bed{k}");
        if wanted.is_empty() || wanted.contains(&name) {
            let mut scene = load("dropped");
            scene.settings.step = step;
            scene.settings.tolerance = Tolerance {
                gap,
                slip: gap,
                force: 0.1,
            };
            rest(&run(&name, scene));
        }
    }
    for (name, line, text) in FEATURES {
        if wanted.iter().any(|a| a == "features") {
            run(name, bed_with(line, text));
        }
    }
    for name in EXAMPLES {
        if wanted.iter().any(|a| a == name) {
            run(name, load(name));
        }
    }
}

fn load(name: &str) -> Scene {
    let file = format!("examples/{name}/{name}.toml");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let loaded = Scene::from_file(file);
    loaded.expect("the example is a good scene").scene
}

/// The bed at `standard` with `text` in the place of `line`, or at its end.
fn bed_with(line: &str, text: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/dropped");
    let bed = std::fs::read_to_string(folder.join("dropped.toml")).expect("a file");
    let settings = ["step =", "fixed_step", "strict", "tolerance"];
    let kept = bed
        .lines()
        .filter(|l| !settings.iter().any(|s| l.starts_with(s)));
    let bed: Vec<&str> = kept.collect();
    let bed = bed.join("\n");
    let bed = bed.replace("duration = 1.0", "duration = 1.0\naccuracy = \"standard\"");
    let scene = match line {
        "" => format!("{bed}\n{text}\n"),
        _ => bed.replacen(line, text, 1),
    };
    let loaded = Scene::from_toml("bed", &scene, &folder);
    loaded.expect("a good scene").scene
}

/// Runs the scene to its end and prints its row.
fn run(name: &str, scene: Scene) -> Simulation {
    let settings = scene.settings.clone();
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    let mut total = StepReport::default();
    let points = (settings.duration / settings.communication_step).round() as usize;
    let start = cpu();
    for k in 1..=points {
        let end = settings.duration * k as f64 / points as f64;
        total.add(&simulation.advance_to(end).expect("a step"));
    }
    println!(
        "{name:8}  {:.0e}  {:.1e}  {:6.2}  {:6}  {:4}  {:6}  {:6.1}  {:7}  {:.1e}  {:.1e}",
        settings.tolerance.gap,
        settings.step,
        cpu() - start,
        total.internal_steps,
        total.cuts,
        total.sweeps,
        total.sweeps as f64 / total.internal_steps as f64,
        total.factorizations,
        total.max_overlap,
        total.force_residual,
    );
    simulation
}

/// What the bed is like at the end.
fn rest(simulation: &Simulation) {
    let particles = &simulation.scene().particles;
    let mass: f64 = particles.mass.iter().sum();
    let energy = |i: usize| {
        let v = simulation.velocity(i);
        let (linear, angular) = (v.linear.norm_squared(), v.angular.norm_squared());
        0.5 * (particles.mass[i] * linear + particles.inertia(i) * angular)
    };
    let energy: f64 = (0..particles.len()).map(energy).sum();
    let positions = simulation.kinematics().position.iter();
    let mut heights: Vec<f64> = positions.map(|x| x.z).collect();
    heights.sort_by(|a, b| b.total_cmp(a));
    let top = &heights[..heights.len() / 20];
    println!(
        "          floor/weight {:.4}, height {:.5} m, {:.1e} J/kg",
        -simulation.mean_wrench(0).force.z / (mass * simulation.gravity().norm()),
        top.iter().sum::<f64>() / top.len() as f64,
        energy / mass,
    );
}

/// Time this thread has run \[s\]; not a number where the system does not tell.
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let first = text.split(' ').next();
    first.and_then(|n| n.parse().ok()).unwrap_or(f64::NAN) * 1e-9
}
