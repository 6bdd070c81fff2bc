//! The periodic cell.

use schemars::JsonSchema;
use serde::Deserialize;

/// `[cell]`: periodic along the axes named here. What leaves through a face comes in through the one opposite.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cell {
    /// Lower and upper face across x \[m\].
    #[schemars(extend("x-default" = "not periodic", "minItems" = 2, "maxItems" = 2))]
    pub x: Option<Vec<f64>>,
    /// Lower and upper face across y \[m\].
    #[schemars(extend("x-default" = "not periodic", "minItems" = 2, "maxItems" = 2))]
    pub y: Option<Vec<f64>>,
    /// Lower and upper face across z \[m\].
    #[schemars(extend("x-default" = "not periodic", "minItems" = 2, "maxItems" = 2))]
    pub z: Option<Vec<f64>>,
}
