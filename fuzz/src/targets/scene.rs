//! Texts of scenes. Small ones that are taken make two steps.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use super::Target;

/// Most spheres of a scene that is stepped.
const SMALL: usize = 200;
/// Longest step tried \[s\].
const STEP: f64 = 1e-3;

pub(super) struct Scenes;

impl Target for Scenes {
    fn name(&self) -> &'static str {
        "scene"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        [
            include_str!("corpus/machine.toml"),
            include_str!("corpus/flow.toml"),
            include_str!("../../../examples/funnel/funnel.toml"),
            include_str!("../../../examples/drum/drum.toml"),
            include_str!("../../../examples/two_fmus/bed.toml"),
            include_str!("../../../examples/shear/shear.toml"),
            include_str!("../../../examples/gate/gate.toml"),
        ]
        .map(|text| text.as_bytes().to_vec())
        .into()
    }

    fn attempt(&self, input: &[u8]) -> bool {
        takes(&String::from_utf8_lossy(input), Path::new("no-such-folder"))
    }
}

/// Whether the scene is taken; then it begins, and if it is small goes on for two steps.
pub(super) fn takes(text: &str, folder: &Path) -> bool {
    let loaded = match Scene::from_toml("scene.toml", text, folder) {
        Ok(loaded) => loaded,
        Err(error) => {
            assert!(!error.problems.is_empty() && !error.plain().is_empty());
            return false;
        }
    };
    if loaded.scene.particles.len() > SMALL {
        return true;
    }
    let step = loaded.scene.settings.step.min(STEP);
    let Ok(mut simulation) = Simulation::new(Arc::new(loaded.scene)) else {
        return true;
    };
    for _ in 0..2 {
        if simulation.advance(step).is_err() {
            break;
        }
    }
    let kinematics = simulation.kinematics();
    let places = kinematics.position.iter().flat_map(|x| x.iter());
    assert!(
        places.into_iter().all(|x| x.is_finite()),
        "a place is not finite"
    );
    true
}
