//! The periodic cell.

use schemars::JsonSchema;
use serde::Deserialize;

/// `[cell]`: periodic along the axes named here. What leaves through a face comes in through the one opposite.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cell {
    /// Lower and upper face across x \[m\].
    #[schemars(extend("x-default" = "not periodic"))]
    pub x: Option<[f64; 2]>,
    /// Lower and upper face across y \[m\].
    #[schemars(extend("x-default" = "not periodic"))]
    pub y: Option<[f64; 2]>,
    /// Lower and upper face across z \[m\].
    #[schemars(extend("x-default" = "not periodic"))]
    pub z: Option<[f64; 2]>,
}
