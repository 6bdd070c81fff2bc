//! Time to a given true overlap: examples/bed for 1.0 s at tolerances of 1e-4, 1e-5 and 1e-6 of the radius.
//!
//! `cargo bench --bench bed [-- ROW...]` prints one line per row: CPU time of this process, steps, sweeps, the worst overlap
//! over every internal step, and what must not depend on either: floor force over weight, mean height of the highest
//! twentieth, kinetic energy.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::{Scene, Tolerance};
use sphere_dda::simulation::Simulation;

/// Tolerance \[-\] and step \[s\] of each row.
const ROWS: [(f64, f64); 4] = [(1e-4, 5e-4), (1e-5, 2.5e-4), (1e-6, 1e-4), (1e-6, 5e-5)];

fn main() {
    let wanted: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/bed/bed.toml");
    let scene = Scene::from_file(file)
        .expect("the example is a good scene")
        .scene;
    println!(
        "  gap      step     CPU s  steps  cuts  sweeps  a step  worst    force    floor/weight  height m  J/kg"
    );
    for (k, (gap, step)) in ROWS.into_iter().enumerate() {
        if wanted.is_empty() || wanted.contains(&k) {
            run(&scene, gap, step);
        }
    }
}

fn run(scene: &Scene, gap: f64, step: f64) {
    let mut scene = scene.clone();
    scene.settings.step = step;
    scene.settings.tolerance = Tolerance {
        gap,
        slip: gap,
        force: 0.1,
    };
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    let mut total = sphere_dda::simulation::StepReport::default();
    let start = cpu();
    for k in 1..=100 {
        let report = simulation.advance_to(0.01 * f64::from(k)).expect("a step");
        total.internal_steps += report.internal_steps;
        total.cuts += report.cuts;
        total.sweeps += report.sweeps;
        total.max_overlap = total.max_overlap.max(report.max_overlap);
        total.force_residual = total.force_residual.max(report.force_residual);
    }
    let time = cpu() - start;
    let particles = &simulation.scene().particles;
    let mass: f64 = particles.mass.iter().sum();
    let energy: f64 = (0..particles.len())
        .map(|i| {
            let v = simulation.velocity(i);
            0.5 * (particles.mass[i] * v.linear.norm_squared()
                + particles.inertia(i) * v.angular.norm_squared())
        })
        .sum();
    let mut heights: Vec<f64> = simulation
        .kinematics()
        .position
        .iter()
        .map(|x| x.z)
        .collect();
    heights.sort_by(|a, b| b.total_cmp(a));
    let top = &heights[..heights.len() / 20];
    println!(
        "  {gap:.0e}  {step:.1e}  {time:6.2}  {:5}  {:4}  {:6}  {:6.1}  {:.1e}  {:.1e}  {:12.4}  {:8.5}  {:.1e}",
        total.internal_steps,
        total.cuts,
        total.sweeps,
        total.sweeps as f64 / total.internal_steps as f64,
        total.max_overlap,
        total.force_residual,
        -simulation.mean_wrench(0).force.z / (mass * 9.81),
        top.iter().sum::<f64>() / top.len() as f64,
        energy / mass,
    );
}

/// Time this thread has run \[s\].
fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds: f64 = text
        .split(' ')
        .next()
        .and_then(|n| n.parse().ok())
        .unwrap_or(f64::NAN);
    nanoseconds * 1e-9
}
