//! `[[parameter]]`: numbers of the scene with a name.

use schemars::JsonSchema;
use serde::Deserialize;

use super::OneOrMany;

/// `[[parameter]]`: a number of the scene with a name, which `--set` and importers of the FMU can set.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Parameter {
    /// Name, unique, also among the variables of the FMU.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// One line about it.
    #[schemars(extend("x-default" = "which keys it sets"))]
    pub description: Option<String>,
    /// Path of the key that it sets, or a list of paths: `"material.grain.friction"`, `"pair[grain,glass].friction"`,
    /// `"boundary.gate.faces[1].plane.point[3]"`, `"simulation.gravity[3]"`.
    pub sets: OneOrMany<String>,
    /// Unit; only that of the keys it sets is accepted.
    #[schemars(extend("x-default" = "that of the keys it sets"))]
    pub unit: Option<String>,
    /// Smallest value.
    #[schemars(extend("x-default" = "none"))]
    pub min: Option<f64>,
    /// Largest value.
    #[schemars(extend("x-default" = "none"))]
    pub max: Option<f64>,
    /// Value unless another is set; it goes before what stands at `sets`.
    #[schemars(extend("x-default" = "what stands at `sets`"))]
    pub default: Option<f64>,
}
