//! `[[boundary]]`: faces and motion.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{Body, OneOrMany, Vector};

/// `[[boundary]]`: a named rigid body made of faces.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Boundary {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Material.
    pub material: String,
    /// Its faces, at least one.
    #[schemars(extend("minItems" = 1))]
    pub faces: Vec<Face>,
    /// Reference point \[m\]: centre of rotation, reference of the torque.
    #[serde(default)]
    pub point_of_action: Vector,
    /// Contact stiffness \[N/m\]: a spring without a damper, from which spheres rebound whatever `restitution` is.
    #[schemars(extend("x-default" = "rigid", "exclusiveMinimum" = 0))]
    pub stiffness: Option<f64>,
    /// Motion prescribed by the scene.
    #[schemars(extend("x-default" = "fixed"))]
    pub motion: Option<Motion>,
    /// Motion driven from outside: an input of the FMU. Not together with `motion`.
    pub input: Option<Input>,
    /// Velocity of its surface along its faces \[m/s\], as that of a belt, in the boundary's own axes: each contact feels the
    /// part across its normal.
    #[schemars(extend("x-default" = "zero"))]
    pub surface_velocity: Option<Vector>,
    /// Whether the surface velocity is an input of the FMU, `surface_velocity` then being its start.
    #[serde(default)]
    pub surface_input: bool,
    /// Whether each of its triangles keeps what it feels: pressure, shear, energies of friction and impacts, wear. Not with
    /// `plane` faces, which have no triangles.
    #[serde(default)]
    pub wall_fields: bool,
    /// Mass and joint of a boundary that forces move. Not together with `motion`; of the inputs only `load`.
    #[schemars(extend("x-default" = "none"))]
    pub body: Option<Body>,
}

/// One face of a boundary: a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Face {
    /// Half-space: solid on the side the normal leaves.
    Plane(Plane),
    /// Rectangle: a corner and two perpendicular edges.
    Rectangle(Rectangle),
    /// Triangle: three corners \[m\].
    Triangle(Vec<Vector>),
    /// Convex plane polygon: corners \[m\] in order.
    Polygon(Vec<Vector>),
    /// The six faces of a box; spheres may be inside or outside.
    Box(Cuboid),
    /// Side of a cone or frustum, open at both ends.
    Cone(Cone),
    /// Side of a cylinder, with or without its discs.
    Cylinder(Cylinder),
    /// Triangle mesh from a file.
    Stl(Stl),
    /// Height field from an ESRI ASCII grid.
    Terrain(Terrain),
}

/// A plane.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A point of it \[m\].
    pub point: Vector,
    /// Normal, any length > 0.
    pub normal: Vector,
}

/// A rectangle.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// A corner \[m\].
    pub corner: Vector,
    /// First edge from that corner \[m\].
    pub u: Vector,
    /// Second edge from that corner \[m\], perpendicular to `u`.
    pub v: Vector,
}

/// An axis-parallel box.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cuboid {
    /// Lower corner \[m\].
    pub min: Vector,
    /// Upper corner \[m\], larger in every coordinate.
    pub max: Vector,
}

/// The side of a cone or frustum.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Centre of the first end \[m\].
    pub base: Vector,
    /// Direction from the first end to the second, any length > 0.
    #[serde(default = "super::defaults::up")]
    pub axis: Vector,
    /// Radius at the first end \[m\].
    #[schemars(extend("minimum" = 0))]
    pub r0: f64,
    /// Radius at the second end \[m\]; not both zero.
    #[schemars(extend("minimum" = 0))]
    pub r1: f64,
    /// Distance of the ends \[m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
}

/// A cylinder.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
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
    /// Whether discs close both ends.
    #[serde(default)]
    pub closed: bool,
}

/// A triangle mesh in an STL file, ASCII or binary.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stl {
    /// File beside or below the scene file.
    pub file: String,
    /// Factor on the file's coordinates.
    #[serde(default = "super::defaults::one")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub scale: f64,
    /// Unit of the file's coordinates, like `"mm"` or `"in"`; `scale` counts on top of it.
    #[schemars(extend("x-default" = "`\"m\"`"))]
    pub unit: Option<String>,
    /// Translation after scaling \[m\].
    #[serde(default)]
    pub translate: Vector,
}

/// A height field in an ESRI ASCII grid (`.asc`): its values are heights at the cell centres; each square of four
/// neighbouring centres is two triangles. Squares with a corner without data are left out. Give it a boundary of its own.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Terrain {
    /// File beside or below the scene file.
    pub file: String,
    /// Factor on the file's coordinates and heights: one, or three for x, y and height.
    #[serde(default = "super::defaults::one_for_all")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub scale: OneOrMany<f64>,
    /// Translation after scaling \[m\]; map coordinates are large, so bring them near zero.
    #[serde(default)]
    pub translate: Vector,
}

/// A prescribed motion, counted from the scene: a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Motion {
    /// Constant velocity.
    Constant(Constant),
    /// A sin(2 pi f t + phase) - A sin(phase).
    Sinusoid(Sinusoid),
    /// Piecewise linear in time.
    Table(Table),
}

/// Constant velocity.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Constant {
    /// Velocity \[m/s\].
    #[serde(default)]
    pub velocity: Vector,
    /// Angular velocity \[rad/s\] about the reference point.
    #[serde(default)]
    pub angular_velocity: Vector,
}

/// Harmonic motion.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sinusoid {
    /// Amplitude of the translation \[m\].
    #[serde(default)]
    pub translation: Vector,
    /// Amplitude of the rotation vector \[rad\].
    #[serde(default)]
    pub rotation: Vector,
    /// Frequency \[Hz\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub frequency: f64,
    /// Phase \[rad\].
    #[serde(default)]
    pub phase: f64,
}

/// Motion by a time table, held constant outside: either `csv`, or `time` with `translation` or `rotation`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Times \[s\], strictly increasing.
    pub time: Option<Vec<f64>>,
    /// Translations \[m\], one per time.
    #[schemars(extend("x-default" = "zero"))]
    pub translation: Option<Vec<Vector>>,
    /// Rotation vectors \[rad\], one per time.
    #[schemars(extend("x-default" = "zero"))]
    pub rotation: Option<Vec<Vector>>,
    /// CSV file with columns time \[s\], x, y, z \[m\] and optionally rx, ry, rz \[rad\].
    pub csv: Option<String>,
}

/// What drives a boundary from outside. Zero means "as in the scene", but for `world_pose`.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Input {
    /// Total translation \[m\] and rotation vector \[rad\].
    Pose,
    /// Position \[m\] of the reference point and orientation as a quaternion w, x, y, z, in the world: what MultiBody
    /// frames and most tools for rigid bodies have. It starts as in the scene: `point_of_action` and 1, 0, 0, 0.
    WorldPose,
    /// Pose and twist together.
    Motion,
    /// Velocity \[m/s\] and angular velocity \[rad/s\].
    Twist,
    /// Displacement \[m\] along this axis, any length > 0.
    Slide(Vector),
    /// Speed \[m/s\] along this axis.
    SlideSpeed(Vector),
    /// Angle \[rad\] about this axis through the reference point.
    Hinge(Vector),
    /// Angular speed \[rad/s\] about this axis.
    HingeSpeed(Vector),
    /// Force \[N\] and torque \[N m\] on the boundary's `body`.
    Load,
}
