//! Where spheres come from before t = 0: packings, size distributions, files.

mod files;
mod packings;
mod regions;

use std::path::Path;

use sphere_dda::scene::Scene;
use sphere_dda::scene_file::{Loaded, SceneError};

/// A scene with one material and the given tables.
fn scene(tables: &str, folder: &Path) -> Result<Loaded, SceneError> {
    let text = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-3\n[[material]]\nname = \"rock\"\ndensity = 2500.0\n{tables}"
    );
    Scene::from_toml("scene.toml", &text, folder)
}

/// The same without files of its own.
fn load(tables: &str) -> Result<Loaded, SceneError> {
    scene(tables, Path::new(""))
}

/// Or what is wrong with it.
fn good(tables: &str) -> Scene {
    load(tables)
        .unwrap_or_else(|e| panic!("{}", e.plain()))
        .scene
}

/// A group `[[spheres]]` with the given keys.
fn group(name: &str, keys: &str) -> String {
    format!("[[spheres]]\nname = \"{name}\"\nmaterial = \"rock\"\n{keys}\n")
}
