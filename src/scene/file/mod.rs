//! The scene file as typed: one type per TOML table. SI units and degrees where a key says so; unknown keys
//! are refused. Only types are checked here; [`super::Scene::from_toml`] checks the rest.

mod boundaries;
mod regions;
mod sensors;
mod spheres;

use serde::Deserialize;

pub use super::values::{OneOrMany, Triple, Vector};
use super::{Integrator, Method, SolverKind};
pub use boundaries::{
    Boundary, Cone, Constant, Cuboid, Cylinder, Face, Input, Motion, Plane, Rectangle, Sinusoid,
    Stl, Table, Terrain,
};
pub use regions::{Region, Tube};
pub use sensors::{MassFlow, Probe, Sensor};
pub use spheres::{
    Lattice, Lock, LogNormal, MassTable, Normal, Packing, Sink, Size, Source, Spheres, Uniform,
};

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

fn one_for_all() -> OneOrMany<f64> {
    OneOrMany::One(1.0)
}

fn up() -> Vector {
    Triple([0.0, 0.0, 1.0])
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
    /// Seconds between checkpoints of `run` \[s\], >= 0; 0: none. Default: 0.
    pub checkpoint_interval: f64,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            vtu_interval: 0.1,
            csv_interval: 0.0,
            float64: false,
            checkpoint_interval: 0.0,
        }
    }
}
