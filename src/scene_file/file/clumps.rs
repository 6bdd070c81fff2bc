//! `[[clump]]`: rigid grains of several spheres.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{OneOrMany, Vector};

/// `[[clump]]`: a rigid grain of 2 to 20 spheres, which groups of spheres place by its name: its `members`, or spheres that are fitted to
/// the closed mesh of an `stl` file. Volume and inertia are those of the union of the members or of the mesh.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Clump {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Its spheres, in axes of its own; they may overlap, but none may lie inside another.
    #[schemars(extend("minItems" = 2, "maxItems" = 20, "x-default" = "those fitted to `stl`"))]
    pub members: Option<Vec<Member>>,
    /// STL file of its surface, closed, beside or below the scene file.
    #[schemars(extend("x-default" = "none"))]
    pub stl: Option<String>,
    /// Unit of the coordinates in `stl`, like `"mm"`.
    #[schemars(extend("x-default" = "`\"m\"`"))]
    pub unit: Option<String>,
    /// Number of spheres fitted to `stl`.
    #[schemars(extend("minimum" = 2, "maximum" = 20, "x-default" = "required with `stl`"))]
    pub spheres: Option<i64>,
    /// Whether frames show the surface of `stl` as well (`clumps_*.vtu`): each frame has the whole mesh once for each clump.
    #[schemars(extend("x-default" = "`false`"))]
    pub surface: Option<bool>,
    /// Mass \[kg\].
    #[schemars(extend("x-default" = "density of the group's material times the volume", "exclusiveMinimum" = 0))]
    pub mass: Option<f64>,
    /// Inertia about the centre of mass in its own axes \[kg m^2\]: `[Ixx, Iyy, Izz]`, or three rows of three.
    #[schemars(extend("x-default" = "that of the union or the mesh with this mass"))]
    pub inertia: Option<Vec<OneOrMany<f64>>>,
}

/// A sphere of a clump.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Member {
    /// Centre \[m\].
    pub position: Vector,
    /// Radius \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}
