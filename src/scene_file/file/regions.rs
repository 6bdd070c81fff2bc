//! Regions of space: filled, emptied or measured.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Cuboid, Plane, Stl, Vector};

/// A region of space, fixed in the world: a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Region {
    /// An axis-parallel box.
    Box(Cuboid),
    /// A solid cylinder.
    Cylinder(Tube),
    /// The inside of a closed triangle mesh. Not for sensors.
    Mesh(Stl),
    /// Everything on the side of a plane that its normal points to. For sinks only.
    Beyond(Plane),
    /// Everything outside an axis-parallel box: what has left the scene. For sinks only.
    Outside(Cuboid),
}

/// A solid cylinder.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tube {
    /// Centre of the first end \[m\].
    pub base: Vector,
    /// Direction from the first end to the second, any length > 0.
    #[serde(default = "super::defaults::up")]
    pub axis: Vector,
    /// Radius \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Length \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
}
