//! Parameters: numbers of a scene with a name of their own, which a command line or an importer sets.

use serde::{Deserialize, Serialize};

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
