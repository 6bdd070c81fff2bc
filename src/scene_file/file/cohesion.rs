//! What holds surfaces together.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a surface energy `W` becomes a pull-off force, with the reduced radius `R*`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Adhesion {
    /// Derjaguin, Muller and Toporov: `2 pi W R*`; small, hard grains.
    Dmt,
    /// Johnson, Kendall and Roberts: `1.5 pi W R*`; large, soft grains; with `young` its whole force curve, with a neck.
    Jkr,
}

/// Strengths of bonds, glue of the section `pi R_b^2`, `R_b` being the smaller radius.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BondStrengths {
    /// Tensile strength \[Pa\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub normal_strength: f64,
    /// Shear strength \[Pa\] of a bond that is not pressed.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub shear_strength: f64,
    /// Gap \[m\] up to which a bond joins at the start, beside all that touches.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub reach: f64,
    /// Young's modulus \[Pa\] of the glue where contacts give way; it is an elastic beam between the centres.
    #[schemars(extend("exclusiveMinimum" = 0, "x-default" = "that of the contact, or its `stiffness`"))]
    pub young: Option<f64>,
}
