//! Parameters: numbers of a scene with a name of their own, which a command line or an importer sets, and what of them a run can
//! take between steps.

use serde::{Deserialize, Serialize};

use crate::scene::{Motion, Scene};

/// A number of the scene with a name of its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// Name, unique in the scene.
    pub name: String,
    /// What it is, one line.
    pub description: String,
    /// Unit of the keys that it sets, as the scene's reference writes it; `-`: none.
    pub unit: String,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// Its value in this scene.
    pub value: f64,
    /// Whether values are whole numbers.
    pub is_integer: bool,
    /// Whether a run takes another value between two steps.
    pub is_tunable: bool,
}

impl Scene {
    /// This scene with all that a run takes between two steps from `other`, the same scene with other values of its tunable
    /// parameters: how materials touch, loads, sources' rates and speeds, loads and dampers of driven bodies. Settings stay;
    /// gravity is [`crate::simulation::Simulation::set_gravity`]'s.
    #[must_use]
    pub fn tuned(&self, other: &Self) -> Self {
        let mut scene = self.clone();
        scene.pairs.clone_from(&other.pairs);
        scene.parameters.clone_from(&other.parameters);
        for (own, new) in scene.loads.iter_mut().zip(&other.loads) {
            own.force = new.force;
        }
        for (own, new) in scene.sources.iter_mut().zip(&other.sources) {
            (own.supply, own.twist) = (new.supply, new.twist);
        }
        for (own, new) in scene.boundaries.iter_mut().zip(&other.boundaries) {
            if let (Motion::Driven(own), Motion::Driven(new)) = (&mut own.motion, &new.motion) {
                (own.force, own.torque, own.damping) = (new.force, new.torque, new.damping);
                own.servo.clone_from(&new.servo);
            }
        }
        scene
    }
}
