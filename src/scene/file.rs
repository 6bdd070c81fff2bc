//! The scene file as typed: one type per TOML table. SI units and degrees where a key says so; unknown keys
//! are refused. Only types are checked here; [`super::Scene::from_toml`] checks the rest.

use serde::Deserialize;

pub use super::values::{OneOrMany, Triple, Vector};
use super::{Integrator, Method, SolverKind};

/// `[simulation]`: the run and its numerics.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Simulation {
    /// End time of a run \[s\], > 0. Required.
    pub duration: f64,
    /// Largest internal time step \[s\], > 0. Required.
    pub step: f64,
    /// Communication step of `run` and of the FMU's default experiment \[s\], > 0. Default: `step`.
    pub communication_step: Option<f64>,
    /// `"alm"` (default): overlap within the tolerance; `"penalty"`: contact springs of stiffness `penalty`.
    #[serde(default)]
    pub method: Method,
    /// `"moreau"` (default) or `"shi"`, the paper's constant acceleration.
    #[serde(default)]
    pub integrator: Integrator,
    /// `"auto"` (default), `"direct"` or `"gauss-seidel"`.
    #[serde(default)]
    pub solver: SolverKind,
    /// Penalty number \[N/m\], > 0. Default: chosen from mass and step; the penalty method needs it.
    pub penalty: Option<f64>,
    /// Whether the augmented-Lagrangian loop may change the penalty. Default: true.
    #[serde(default = "yes")]
    pub adapt_penalty: bool,
    /// Gravity \[m/s^2\]. Default: `[0, 0, -9.81]`.
    #[serde(default = "earth")]
    pub gravity: Vector,
    /// Initial overlap over the smaller radius that is removed before t = 0 \[-\], 0..=0.5. Default: 0.05.
    #[serde(default = "five_percent")]
    pub max_initial_overlap: f64,
    /// Approach speed below which an impact does not rebound \[m/s\], >= 0. Default: 0.
    #[serde(default)]
    pub threshold_velocity: f64,
    /// Share of the velocity that the next step keeps (integrator `shi`) \[-\], 0..=1. Default: 1.
    #[serde(default = "one")]
    pub dynamic_coefficient: f64,
    /// Most solver iterations in one step \[-\], >= 1. Default: 20000.
    #[serde(default = "iterations")]
    pub max_iterations: u32,
    /// How often a step may be halved, 0..=20. Default: 6.
    #[serde(default = "cuts")]
    pub max_cuts: u32,
    /// Tolerances.
    #[serde(default)]
    pub tolerance: Tolerance,
}

/// `[simulation.tolerance]`: dimensionless, each 1e-12..=1e-1, default 1e-6.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Tolerance {
    /// True overlap over the smaller radius of the pair \[-\].
    pub gap: f64,
    /// Slip of a sticking contact over the smaller radius \[-\].
    pub slip: f64,
    /// Force residual over the contact's force scale \[-\].
    pub force: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        let super::Tolerance { gap, slip, force } = super::Tolerance::default();
        Self { gap, slip, force }
    }
}

fn yes() -> bool {
    true
}

fn one() -> f64 {
    1.0
}

fn earth() -> Vector {
    Triple([0.0, 0.0, -9.81])
}

fn five_percent() -> f64 {
    0.05
}

fn iterations() -> u32 {
    20_000
}

fn cuts() -> u32 {
    6
}

/// `[[material]]`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name, unique. Required.
    pub name: String,
    /// Density \[kg/m^3\], > 0. Needed by materials of spheres only.
    pub density: Option<f64>,
}

/// `[pair_default]`: how materials touch unless a `[[pair]]` says otherwise.
#[derive(Debug, Clone, Copy, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairDefault {
    /// Friction coefficient \[-\], >= 0. Default: 0. Not together with `friction_angle`.
    pub friction: Option<f64>,
    /// Friction angle in degrees, 0..90; the coefficient is its tangent.
    pub friction_angle: Option<f64>,
    /// Coefficient of restitution \[-\], 0..=1. Default: 0.
    pub restitution: Option<f64>,
}

/// `[[pair]]`: how two materials touch; what is left out is taken from `[pair_default]`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pair {
    /// The two materials, in either order. Required.
    pub materials: Vec<String>,
    /// Friction coefficient \[-\], >= 0. Not together with `friction_angle`.
    pub friction: Option<f64>,
    /// Friction angle in degrees, 0..90.
    pub friction_angle: Option<f64>,
    /// Coefficient of restitution \[-\], 0..=1.
    pub restitution: Option<f64>,
}

/// `[[spheres]]`: a named group, placed by exactly one of `lattice`, `positions`, `csv`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spheres {
    /// Name of the group, unique. Required. Sphere k of it is `"name[k]"` elsewhere, counted from 0.
    pub name: String,
    /// Material. Required.
    pub material: String,
    /// Radius \[m\], > 0: one for all or a list. Required unless the CSV file has the column.
    pub radius: Option<OneOrMany<f64>>,
    /// Each radius is multiplied by 1 + `radius_jitter` U(-1, 1) \[-\], 0..1. Default: 0.
    #[serde(default)]
    pub radius_jitter: f64,
    /// Seed of both jitters. Default: 0.
    #[serde(default)]
    pub seed: u64,
    /// A regular lattice.
    pub lattice: Option<Lattice>,
    /// Centres \[m\].
    pub positions: Option<Vec<Vector>>,
    /// CSV file with columns x, y, z \[m\] and optionally radius \[m\], vx, vy, vz \[m/s\], wx, wy, wz \[rad/s\].
    pub csv: Option<String>,
    /// Initial velocity \[m/s\] of all. Default: zero, or the CSV file's.
    pub velocity: Option<Vector>,
    /// Initial angular velocity \[rad/s\] of all. Default: zero, or the CSV file's.
    pub spin: Option<Vector>,
    /// Held degrees of freedom, world axes, one or a list of them. Default: none.
    pub lock: Option<OneOrMany<Lock>>,
}

/// A held degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Lock {
    /// Translation along x.
    X,
    /// Translation along y.
    Y,
    /// Translation along z.
    Z,
    /// Rotation about x.
    Rx,
    /// Rotation about y.
    Ry,
    /// Rotation about z.
    Rz,
    /// All three translations.
    Translations,
    /// All three rotations: the sphere slides like a block.
    Rotations,
}

/// A lattice: centre (i, j, k) = `origin` + i s_x e_x + j s_y e_y + k s_z e_z, i fastest.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lattice {
    /// Centre of the first sphere \[m\]. Required.
    pub origin: Vector,
    /// Number of spheres along each axis, each >= 1. Required.
    pub count: Triple<u32>,
    /// Distance between centres \[m\], > 0: one or three. Required.
    pub spacing: OneOrMany<f64>,
    /// Each coordinate is moved by `jitter` spacing U(-1, 1) \[-\], 0..=0.5. Default: 0.
    #[serde(default)]
    pub jitter: f64,
    /// Directions of e_x and e_y; normalised, e_y made perpendicular to e_x, e_z = e_x x e_y.
    /// Default: world axes.
    pub axes: Option<Vec<Vector>>,
}

/// `[[boundary]]`: a named rigid body made of faces.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Boundary {
    /// Name, unique. Required.
    pub name: String,
    /// Material. Required.
    pub material: String,
    /// Its faces, at least one. Required.
    pub faces: Vec<Face>,
    /// Centre of rotation and reference of the torque \[m\]. Default: the origin.
    #[serde(default)]
    pub point_of_action: Vector,
    /// Contact stiffness \[N/m\], > 0. Default: rigid.
    pub stiffness: Option<f64>,
    /// Motion prescribed by the scene. Default: fixed.
    pub motion: Option<Motion>,
    /// Motion driven from outside: an input of the FMU. Not together with `motion`.
    pub input: Option<Input>,
}

/// One face of a boundary: a table with one key.
#[derive(Debug, Clone, Deserialize)]
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
}

/// A plane.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// A point of it \[m\]. Required.
    pub point: Vector,
    /// Normal, any length > 0. Required.
    pub normal: Vector,
}

/// A rectangle.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// A corner \[m\]. Required.
    pub corner: Vector,
    /// First edge from that corner \[m\]. Required.
    pub u: Vector,
    /// Second edge from that corner \[m\], perpendicular to `u`. Required.
    pub v: Vector,
}

/// An axis-parallel box.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cuboid {
    /// Lower corner \[m\]. Required.
    pub min: Vector,
    /// Upper corner \[m\], larger in every coordinate. Required.
    pub max: Vector,
}

/// The side of a cone or frustum.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Centre of the first end \[m\]. Required.
    pub base: Vector,
    /// Direction from the first end to the second, any length > 0. Default: `[0, 0, 1]`.
    #[serde(default = "up")]
    pub axis: Vector,
    /// Radius at the first end \[m\], >= 0. Required.
    pub r0: f64,
    /// Radius at the second end \[m\], >= 0; not both zero. Required.
    pub r1: f64,
    /// Distance of the ends \[m\], > 0. Required.
    pub height: f64,
}

/// A cylinder.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Centre of the first end \[m\]. Required.
    pub base: Vector,
    /// Direction from the first end to the second, any length > 0. Default: `[0, 0, 1]`.
    #[serde(default = "up")]
    pub axis: Vector,
    /// Radius \[m\], > 0. Required.
    pub radius: f64,
    /// Length \[m\], > 0. Required.
    pub height: f64,
    /// Whether discs close both ends. Default: false.
    #[serde(default)]
    pub closed: bool,
}

/// A triangle mesh in an STL file, ASCII or binary.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stl {
    /// File beside or below the scene file. Required.
    pub file: String,
    /// Factor on the file's coordinates, > 0: 0.001 for millimetres. Default: 1.
    #[serde(default = "one")]
    pub scale: f64,
    /// Translation after scaling \[m\]. Default: zero.
    #[serde(default)]
    pub translate: Vector,
}

fn up() -> Vector {
    Triple([0.0, 0.0, 1.0])
}

/// A prescribed motion, counted from the scene: a table with one key.
#[derive(Debug, Clone, Deserialize)]
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
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Constant {
    /// Velocity \[m/s\]. Default: zero.
    #[serde(default)]
    pub velocity: Vector,
    /// Angular velocity \[rad/s\] about the point of action. Default: zero.
    #[serde(default)]
    pub angular_velocity: Vector,
}

/// Harmonic motion.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sinusoid {
    /// Amplitude of the translation \[m\]. Default: zero.
    #[serde(default)]
    pub translation: Vector,
    /// Amplitude of the rotation vector \[rad\]. Default: zero.
    #[serde(default)]
    pub rotation: Vector,
    /// Frequency \[Hz\], > 0. Required.
    pub frequency: f64,
    /// Phase \[rad\]. Default: 0.
    #[serde(default)]
    pub phase: f64,
}

/// Motion by a time table, held constant outside: either `csv`, or `time` with `translation` or `rotation`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Times \[s\], strictly increasing.
    pub time: Option<Vec<f64>>,
    /// Translations \[m\], one per time. Default: zero.
    pub translation: Option<Vec<Vector>>,
    /// Rotation vectors \[rad\], one per time. Default: zero.
    pub rotation: Option<Vec<Vector>>,
    /// CSV file with columns time \[s\], x, y, z \[m\] and optionally rx, ry, rz \[rad\].
    pub csv: Option<String>,
}

/// What drives a boundary from outside. Zero always means "as in the scene".
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Input {
    /// Total translation \[m\] and rotation vector \[rad\].
    Pose,
    /// Pose and twist together.
    Motion,
    /// Velocity \[m/s\] and angular velocity \[rad/s\].
    Twist,
    /// Displacement \[m\] along this axis, any length > 0.
    Slide(Vector),
    /// Speed \[m/s\] along this axis.
    SlideSpeed(Vector),
    /// Angle \[rad\] about this axis through the point of action.
    Hinge(Vector),
    /// Angular speed \[rad/s\] about this axis.
    HingeSpeed(Vector),
}

/// `[[load]]`: a force on a sphere at a point that moves with it.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere. Required.
    pub sphere: String,
    /// Force \[N\], world axes. Required.
    pub force: Vector,
    /// Point of the sphere, from its centre, at t = 0 \[m\]. Default: the centre.
    #[serde(default)]
    pub point: Vector,
}

/// `[[spring]]`: a constrained point, a spring from a point of a sphere to a target.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere. Required.
    pub sphere: String,
    /// Stiffness \[N/m\], > 0. Required.
    pub stiffness: f64,
    /// Point of the sphere, from its centre, at t = 0 \[m\]. Default: the centre.
    #[serde(default)]
    pub point: Vector,
    /// Target \[m\]. Default: where the point is at t = 0.
    pub target: Option<Vector>,
    /// Motion of the target; translations only. Default: fixed.
    pub motion: Option<Motion>,
}

/// `[[sensor]]`: exactly one of the measures.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// Name, unique. Required.
    pub name: String,
    /// Mass \[kg\] of the spheres with their centre in this box.
    pub mass_in_box: Option<Cuboid>,
    /// Force \[N\] and torque \[N m\] on the boundary of this name, averaged over the communication step.
    pub wrench: Option<String>,
    /// Cumulated mass \[kg\] and flow \[kg/s\] of centres through this plane, along its normal.
    pub mass_flow: Option<Plane>,
}

/// `[[probe]]`: a sphere whose state is an output. Default: the first, the middle and the last sphere.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name, unique. Required.
    pub name: String,
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere. Required.
    pub sphere: String,
}

/// `[output]`: result files.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Seconds between VTU frames \[s\], >= 0; 0: none. Default: 0.1.
    pub vtu_interval: f64,
    /// Seconds between rows of the CSV history \[s\], >= 0; 0: every communication step. Default: 0.
    pub csv_interval: f64,
    /// Write Float64 instead of Float32 arrays. Default: false.
    pub float64: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            vtu_interval: 0.1,
            csv_interval: 0.0,
            float64: false,
        }
    }
}
