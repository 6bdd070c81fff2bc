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
    /// Everything inside this region, a box or a cylinder: mass \[kg\], count, solid fraction, centre of mass \[m\],
    /// coordination number, stress \[Pa\] (compression positive), largest and mean normal force \[N\].
    pub region: Option<Region>,
    /// Force \[N\] and torque \[N m\] on the boundary of this name about its reference point, averaged over the communication step.
    pub wrench: Option<String>,
    /// Mass \[kg\] that has passed a plane or a polygon along its normal since the start, and its flow \[kg/s\], the
    /// mean of the communication step. A sphere passes with its centre; against the normal it counts negative.
    pub mass_flow: Option<MassFlow>,
}

/// What a mass flow passes through: a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MassFlow {
    /// The whole plane.
    Plane(Plane),
    /// A convex plane polygon: three or more corners \[m\] in order; its normal is the one they turn about (right hand).
    /// Polygons that share an edge, corner for corner, miss no sphere and count none twice.
    Polygon(Vec<Vector>),
}

/// `[[probe]]`: a sphere whose state is an output. Without any the first, the middle and the last sphere are measured, and no outputs.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere.
    pub sphere: String,
}
