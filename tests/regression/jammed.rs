//! Fault: a stirrer that jammed two grains against a wall carried torques of hundreds of newton metres for 10 ms, in place of two,
//! and steps took all sweeps and factorizations that there are. Cause: such a chain has no rigid solution where friction keeps it from
//! buckling, and only single grains between two boundaries gave way.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

/// An upright plate that turns in a bed of 500 grains, two diameters from the walls.
fn stirred(seed: u32) -> Scene {
    let text = format!(
        r#"
[simulation]
duration = 1.0
communication_step = 0.01
[[material]]
name = "grain"
density = 2500.0
[pair_default]
friction = 0.5
[[spheres]]
name = "bed"
material = "grain"
seed = {seed}
size = {{ uniform = {{ min = 0.008, max = 0.012 }} }}
packing = {{ region = {{ box = {{ min = [-0.12, -0.12, 0.0], max = [0.12, 0.12, 0.5] }} }}, count = 500 }}
[[boundary]]
name = "box"
material = "grain"
faces = [
    {{ plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }} }},
    {{ plane = {{ point = [-0.12, 0, 0], normal = [1, 0, 0] }} }},
    {{ plane = {{ point = [0.12, 0, 0], normal = [-1, 0, 0] }} }},
    {{ plane = {{ point = [0, -0.12, 0], normal = [0, 1, 0] }} }},
    {{ plane = {{ point = [0, 0.12, 0], normal = [0, -1, 0] }} }},
]
[[boundary]]
name = "stirrer"
material = "grain"
faces = [{{ box = {{ min = [-0.005, -0.08, 0.05], max = [0.005, 0.08, 0.3] }} }}]
motion = {{ table = {{ time = [0.0, 0.4, 1.0], rotation = [[0, 0, 0], [0, 0, 0], [0, 0, 1.8]] }} }}
"#
    );
    let loaded = Scene::from_toml("stirred", &text, Path::new("."));
    loaded.expect("a good scene").scene
}

/// Sweeps are pinned by their order of magnitude.
#[test]
fn a_stirrer_that_jams_grains_keeps_its_torque() {
    for seed in [9, 12] {
        let mut simulation = Simulation::new(Arc::new(stirred(seed))).expect("it starts");
        for _ in 0..100 {
            let report = simulation.advance(1e-2).expect("a step");
            let torque = simulation.mean_wrench(1).torque.z.abs();
            assert!(torque < 20.0, "seed {seed}: {torque} N m");
            assert!(
                report.sweeps < 8000,
                "seed {seed}: {} sweeps",
                report.sweeps
            );
            assert!(report.max_overlap < 0.1, "{}", report.max_overlap);
        }
    }
}
