//! Sources, sinks and settling: mass that comes and goes is counted exactly, and a settled scene starts in equilibrium.
//! Start files keep that start.

mod capacity;
mod settling;
mod sources;
mod start_file;

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

/// The scene of a text.
fn scene(text: &str) -> Scene {
    Scene::from_toml("test", text, Path::new("."))
        .unwrap_or_else(|error| panic!("{}", error.plain()))
        .scene
}

/// A running scene.
fn simulation(text: &str) -> Simulation {
    Simulation::new(Arc::new(scene(text))).unwrap()
}
