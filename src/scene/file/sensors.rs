//! `[[sensor]]` and `[[probe]]`: what is measured.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Plane, Region, Vector};

/// `[[sensor]]`: exactly one of the measures.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Everything inside this region: mass, solid fraction, centre of mass, coordination number, stress, normal
    /// forces.
    pub region: Option<Region>,
    /// Force \[N\] and torque \[N m\] on the boundary of this name, averaged over the communication step.
    pub wrench: Option<String>,
    /// Cumulated mass \[kg\] and flow \[kg/s\] of centres through a plane or a polygon, along its normal.
    pub mass_flow: Option<MassFlow>,
}

/// What a mass flow passes through: a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MassFlow {
    /// The whole plane, counted along its normal.
    Plane(Plane),
    /// A convex plane polygon: corners \[m\] in order, counted along the normal they turn about (right hand).
    Polygon(Vec<Vector>),
}

/// `[[probe]]`: a sphere whose state is an output. Default: the first, the middle and the last sphere.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere.
    pub sphere: String,
}
