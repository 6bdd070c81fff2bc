//! Time to a given true overlap: the bed at tolerances of 1e-4, 1e-5 and 1e-6 of the radius, other examples as they are.
//!
//! `cargo bench --bench scenes [-- ROW...]` prints one line per row, by default the rows of the bed: CPU time of this
//! thread, steps, sweeps, factorizations and the worst overlap over every internal step; for the bed also what must depend on
//! none of these: force on the floor over weight, mean height of the highest twentieth, kinetic energy. The row `features` is
//! the bed at `standard` as it is, then with one more thing each: sums of several beds, for sweeps of one bed change by a tenth
//! with the last bit of its gravity, each the least of three runs in turns. Its rows end with the CPU time over that of plain ones.

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
/// Beds of each feature, and how often each runs: its least time counts.
const BEDS: usize = 7;
const ROUNDS: usize = 3;

/// What is added to the bed, or put in the place of a line of it.
const FEATURES: [(&str, &str, &str); 10] = [
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
        "grains",
        "name = \"glass\"",
        "name = \"glass\"\nyoung = 5e6",
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
            let tolerances = (gap, step);
            let (cost, simulation) = run(scene);
            println!("{}", row(&name, tolerances, &cost));
            rest(&simulation);
        }
    }
    if wanted.iter().any(|a| a == "features") {
        features();
    }
    for name in EXAMPLES {
        if wanted.iter().any(|a| a == name) {
            let scene = load(name);
            let tolerances = (scene.settings.tolerance.gap, scene.settings.step);
            println!("{}", row(name, tolerances, &run(scene).0));
        }
    }
}

/// Beds with one more thing each, all of one gravity before the next.
fn features() {
    let mut costs: [Cost; FEATURES.len()] = Default::default();
    let mut tolerances = (0.0, 0.0);
    for bed in 0..BEDS {
        let mut own: [Cost; FEATURES.len()] = Default::default();
        own.iter_mut().for_each(|own| own.cpu = f64::INFINITY);
        for _ in 0..ROUNDS {
            for (own, (_, line, text)) in own.iter_mut().zip(FEATURES) {
                let mut scene = bed_with(line, text);
                scene.settings.gravity *= 1.0 + 1e-9 * bed as f64;
                tolerances = (scene.settings.tolerance.gap, scene.settings.step);
                let Cost { cpu, steps } = run(scene).0;
                *own = Cost {
                    cpu: own.cpu.min(cpu),
                    steps,
                };
            }
        }
        for (cost, own) in costs.iter_mut().zip(own) {
            cost.cpu += own.cpu;
            cost.steps.add(&own.steps);
        }
    }
    for ((name, ..), cost) in FEATURES.iter().zip(&costs) {
        let over = cost.cpu / costs[0].cpu;
        println!("{}  {over:.2}", row(name, tolerances, cost));
    }
}

/// What runs cost.
#[derive(Default)]
struct Cost {
    /// \[s\]
    cpu: f64,
    steps: StepReport,
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

/// Runs the scene to its end.
fn run(scene: Scene) -> (Cost, Simulation) {
    let settings = scene.settings.clone();
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    let mut steps = StepReport::default();
    let points = (settings.duration / settings.communication_step).round() as usize;
    let start = cpu();
    for k in 1..=points {
        let end = settings.duration * k as f64 / points as f64;
        steps.add(&simulation.advance_to(end).expect("a step"));
    }
    let cpu = cpu() - start;
    (Cost { cpu, steps }, simulation)
}

/// The row of runs with a tolerance \[-\] and a longest step \[s\].
fn row(name: &str, (gap, step): (f64, f64), Cost { cpu, steps }: &Cost) -> String {
    format!(
        "{name:8}  {gap:.0e}  {step:.1e}  {cpu:6.2}  {:6}  {:4}  {:6}  {:6.1}  {:7}  {:.1e}  {:.1e}",
        steps.internal_steps,
        steps.cuts,
        steps.sweeps,
        steps.sweeps as f64 / steps.internal_steps as f64,
        steps.factorizations,
        steps.max_overlap,
        steps.force_residual,
    )
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
