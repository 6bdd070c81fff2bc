//! The scene file as typed: one type per TOML table. SI units and degrees where a key says so; unknown keys
//! are refused. Only types are checked here; [`crate::scene::Scene::from_toml`] checks the rest.

mod boundaries;
mod cell;
mod clumps;
mod cohesion;
mod defaults;
mod driven;
mod frame;
mod parameters;
mod regions;
mod sensors;
mod spheres;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use super::values::{OneOrMany, Triple, Vector};
use crate::integrator::Integrator;
use crate::scene::{Accuracy, Method};
pub use crate::scene::{Exposed, Output};
use crate::solver::{Registers, SolverKind};
pub use boundaries::{
    Boundary, Cone, Constant, Cuboid, Cylinder, Face, Input, Motion, Plane, Rectangle, Sinusoid,
    Stl, Table, Terrain,
};
pub use cell::Cell;
pub use clumps::{Clump, Member};
pub use cohesion::{Adhesion, BondStrengths};
pub use driven::{Body, Joint, JointSpring, Limits, Servo};
pub use frame::{GravityMotion, GravityTable, RotatingFrame, Turning};
pub use parameters::Parameter;
pub use regions::{Region, Tube};
pub use sensors::{MassFlow, Probe, Sensor};
pub use spheres::{
    Lattice, Lock, LogNormal, MassTable, Normal, Packing, Sink, Size, Source, Spheres, Uniform,
};

/// A scene file: its top level.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TopLevel {
    /// Title of results and FMUs.
    #[serde(default)]
    #[schemars(extend("x-default" = "the name of the scene file without its ending"))]
    pub title: String,
    /// One line about the model, for FMUs.
    #[schemars(extend("x-default" = "what the solver computes, in one line"))]
    pub description: Option<String>,
    /// Who made the model, for FMUs.
    #[schemars(extend("x-default" = "none"))]
    pub author: Option<String>,
    /// Version of the model, for FMUs.
    #[schemars(extend("x-default" = "none"))]
    pub version: Option<String>,
    /// Copyright notice of the model, for FMUs.
    #[schemars(extend("x-default" = "none"))]
    pub copyright: Option<String>,
    /// Licence of the model, for FMUs.
    #[schemars(extend("x-default" = "none"))]
    pub license: Option<String>,
    /// The run and its numerics.
    pub simulation: Simulation,
    /// Materials of spheres and boundaries.
    #[serde(default)]
    pub material: Vec<Material>,
    /// How two materials touch.
    #[serde(default)]
    pub pair: Vec<Pair>,
    /// How materials touch unless a `[[pair]]` says otherwise.
    #[serde(default)]
    pub pair_default: PairDefault,
    /// Rigid grains of several spheres.
    #[serde(default)]
    pub clump: Vec<Clump>,
    /// Groups of spheres.
    #[serde(default)]
    pub spheres: Vec<Spheres>,
    /// Where spheres come from during the run.
    #[serde(default)]
    pub source: Vec<Source>,
    /// Where spheres go during the run.
    #[serde(default)]
    pub sink: Vec<Sink>,
    /// Rigid bodies that bound the spheres.
    #[serde(default)]
    pub boundary: Vec<Boundary>,
    /// Axes along which the scene is periodic.
    #[serde(default)]
    pub cell: Cell,
    /// Forces on spheres.
    #[serde(default)]
    pub load: Vec<Load>,
    /// Springs on spheres.
    #[serde(default)]
    pub spring: Vec<Spring>,
    /// What is measured.
    #[serde(default)]
    pub sensor: Vec<Sensor>,
    /// Spheres whose states are outputs.
    #[serde(default)]
    pub probe: Vec<Probe>,
    /// Numbers of the scene with a name, which commands and FMUs can set.
    #[serde(default)]
    pub parameter: Vec<Parameter>,
    /// Result files.
    #[serde(default)]
    pub output: Output,
    /// The FMU's variables.
    #[serde(default)]
    pub fmu: Exposed,
}

/// `[simulation]`: the run and its numerics.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Simulation {
    /// End time of a run \[s\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub duration: f64,
    /// How accurate the run is: `"fast"`, `"standard"` or `"reference"`. It sets tolerances and steps ([what each gives](accuracy.md)).
    #[serde(default)]
    pub accuracy: Accuracy,
    /// Largest internal time step \[s\]. Steps are chosen at most so long; a larger value than the accuracy allows changes nothing.
    #[schemars(extend("x-default" = "chosen from the accuracy, the radii and the largest gravity, or the loads without it", "exclusiveMinimum" = 0))]
    pub step: Option<f64>,
    /// Whether every internal step is as long as `step`, which is then required. The integrator `shi` and the penalty method do so
    /// whenever `step` is given.
    #[serde(default)]
    pub fixed_step: bool,
    /// Whether a step that does not meet the tolerances ends the run. Otherwise its best iterate is taken, counted in
    /// `solver.unconvergedSteps` and reported.
    #[serde(default = "defaults::strict")]
    pub strict: bool,
    /// Communication step of `run` and of the FMU's default experiment \[s\].
    #[schemars(extend("x-default" = "`step`, or a round number near the chosen one", "exclusiveMinimum" = 0))]
    pub communication_step: Option<f64>,
    /// How contact constraints are enforced: `"alm"` keeps the overlap within the tolerance, `"penalty"` puts contact
    /// springs of stiffness `penalty`.
    #[serde(default)]
    pub method: Method,
    /// Time integration: `"moreau"`, or `"shi"`, the paper's constant acceleration.
    #[serde(default)]
    pub integrator: Integrator,
    /// Solver of a step: `"auto"` takes Gauss-Seidel first, then Newton on what it leaves, then the direct solver.
    #[serde(default)]
    pub solver: SolverKind,
    /// Penalty number \[N/m\]: stiffness of the penalty method, start of the direct solver's loop. Gauss-Seidel and Newton do not use it.
    #[schemars(extend("x-default" = "chosen from mass and step; the penalty method needs it", "exclusiveMinimum" = 0))]
    pub penalty: Option<f64>,
    /// Whether the augmented-Lagrangian loop may change the penalty, sweep between its multiplier updates, and leave the rest to Newton; `false` with
    /// `solver = "direct"` is exactly the paper's loop, slow unless the penalty is large ([how slow](paper.md#augmentations-at-a-held-penalty)).
    #[serde(default = "defaults::adapt_penalty")]
    pub adapt_penalty: bool,
    /// Gravity \[m/s^2\]; at t = 0, if `gravity_motion` turns it.
    #[schemars(extend("x-default" = "[0, 0, -9.81]"))]
    pub gravity: Option<Vector>,
    /// How gravity changes with time.
    #[schemars(extend("x-default" = "it does not"))]
    pub gravity_motion: Option<GravityMotion>,
    /// The scene is given and solved in a frame that turns.
    #[schemars(extend("x-default" = "it does not turn"))]
    pub rotating_frame: Option<RotatingFrame>,
    /// Initial overlap over the smaller radius that is removed before t = 0 \[-\].
    #[serde(default = "defaults::max_initial_overlap")]
    #[schemars(extend("minimum" = 0, "maximum" = 0.5))]
    pub max_initial_overlap: f64,
    /// Approach speed below which an impact does not rebound \[m/s\].
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub threshold_velocity: f64,
    /// Fraction of the velocity carried over to the next step (integrator `shi`) \[-\].
    #[serde(default = "defaults::dynamic_coefficient")]
    #[schemars(extend("minimum" = 0, "maximum" = 1))]
    pub dynamic_coefficient: f64,
    /// Most solver iterations in one step \[-\].
    #[serde(default = "defaults::max_iterations")]
    #[schemars(extend("minimum" = 1))]
    pub max_iterations: u32,
    /// Smallest internal step that is chosen \[s\]; steps that fail are cut below it.
    #[schemars(extend("x-default" = "a part of the largest step that the accuracy sets", "exclusiveMinimum" = 0))]
    pub smallest_step: Option<f64>,
    /// Real-time mode: most Gauss-Seidel sweeps of a step, whose result is taken as it is; `maxOverlap` and the residuals report its error.
    #[schemars(extend("x-default" = "as many as the tolerances need", "minimum" = 1))]
    pub sweeps: Option<u32>,
    /// Speed of rest \[m/s\]: spheres fall asleep when for ten steps their centres, and surfaces where they touch, are slower and forces balance; they cost next to nothing until something hits them, the forces on them change or a boundary that they touch moves. 0: never.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub rest_speed: f64,
    /// How often a step may be halved; one that does not converge at most three times unless `strict` is set.
    #[serde(default = "defaults::max_cuts")]
    #[schemars(extend("minimum" = 0, "maximum" = 20))]
    pub max_cuts: u32,
    /// Threads that share the work of scenes of 1280 spheres and more; results are the same for any number, and runs go on with
    /// another one. `run --threads` is instead of it.
    #[serde(default = "defaults::threads")]
    #[schemars(extend("minimum" = 1, "maximum" = 256))]
    pub threads: u32,
    /// Vector registers of the sweeps: `"widest"` of the processor, `"avx2"`, or `"plain"`. All but `"plain"` give the same bits on processors that have AVX2 and FMA; `"plain"` is slower and gives its own on all.
    #[serde(default)]
    pub registers: Registers,
    /// Tolerances of a step.
    #[serde(default)]
    pub tolerance: Tolerance,
}

/// `[simulation.tolerance]`: dimensionless tolerances of every step, instead of those of the `accuracy`.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Tolerance {
    /// True overlap over the smaller radius of the pair \[-\].
    #[schemars(extend("x-default" = "that of the accuracy", "minimum" = 1e-12, "maximum" = 1e-1))]
    pub gap: Option<f64>,
    /// Slip of a sticking contact over the smaller radius \[-\].
    #[schemars(extend("x-default" = "that of the accuracy, in scenes with bonds a hundredth of it", "minimum" = 1e-12, "maximum" = 1e-1))]
    pub slip: Option<f64>,
    /// Force residual over the contact's force scale \[-\].
    #[schemars(extend("x-default" = "that of the accuracy", "minimum" = 1e-12, "maximum" = 1e-1))]
    pub force: Option<f64>,
    /// Largest gap over the smaller radius at which a contact may carry load \[-\]: within it, what rests keeps its place and
    /// its forces. 0: contacts carry at zero gap only, which takes more sweeps.
    #[schemars(extend("x-default" = "10 times `gap`, at `fast` 4 times", "minimum" = 0, "maximum" = 1e-1))]
    pub opening: Option<f64>,
}

/// `[[material]]`. Of coefficients that both materials of a contact give, the smaller one counts; `[[pair]]` goes before
/// them, `[pair_default]` comes after.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name, unique.
    #[schemars(extend("pattern" = "^[A-Za-z_][A-Za-z0-9_]*$"))]
    pub name: String,
    /// Density \[kg/m^3\]. Needed by materials of spheres only.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub density: Option<f64>,
    /// Friction coefficient \[-\] with any material. Not together with `friction_angle`.
    #[schemars(extend("minimum" = 0))]
    pub friction: Option<f64>,
    /// Friction angle \[deg\].
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 90))]
    pub friction_angle: Option<f64>,
    /// Coefficient of restitution \[-\].
    #[schemars(extend("minimum" = 0, "maximum" = 1))]
    pub restitution: Option<f64>,
    /// Coefficient of rolling resistance \[-\]: its couple is at most this times the reduced radius times the
    /// normal force.
    #[schemars(extend("minimum" = 0))]
    pub rolling_friction: Option<f64>,
    /// Coefficient of twisting resistance \[-\]: its couple about the normal is at most this times the reduced radius
    /// times the normal force.
    #[schemars(extend("minimum" = 0))]
    pub twisting_friction: Option<f64>,
    /// Young's modulus \[Pa\]: contacts give way as elastic spheres do, by Hertz and Mindlin, and keep the `restitution`. A material
    /// without it is rigid.
    #[schemars(extend("exclusiveMinimum" = 0, "x-default" = "rigid"))]
    pub young: Option<f64>,
    /// Poisson's ratio \[-\] beside `young`.
    #[schemars(extend("minimum" = 0, "maximum" = 0.5, "x-default" = "`0.25`"))]
    pub poisson: Option<f64>,
    /// Contact stiffness \[N/m\]: contacts give way as a spring that keeps the `restitution`; across the normal 2/5 of it.
    #[schemars(extend("exclusiveMinimum" = 0, "x-default" = "rigid"))]
    pub stiffness: Option<f64>,
    /// Archard's wear coefficient \[1/Pa\] of boundaries with `wall_fields`: the volume worn off per normal force and sliding path.
    #[schemars(extend("minimum" = 0))]
    pub wear: Option<f64>,
}

/// `[pair_default]`: how materials touch unless a `[[pair]]` or their own `[[material]]`s say otherwise.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PairDefault {
    /// Friction coefficient \[-\]. Not together with `friction_angle`.
    #[schemars(extend("x-default" = "`0`", "minimum" = 0))]
    pub friction: Option<f64>,
    /// Friction angle \[deg\]; the coefficient is its tangent.
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 90))]
    pub friction_angle: Option<f64>,
    /// Coefficient of restitution \[-\].
    #[schemars(extend("x-default" = "`0`", "minimum" = 0, "maximum" = 1))]
    pub restitution: Option<f64>,
    /// Coefficient of rolling resistance \[-\]: its couple is at most this times the reduced radius times the
    /// normal force.
    #[schemars(extend("x-default" = "`0`", "minimum" = 0))]
    pub rolling_friction: Option<f64>,
    /// Coefficient of twisting resistance \[-\]: its couple about the normal is at most this times the reduced radius
    /// times the normal force.
    #[schemars(extend("x-default" = "`0`", "minimum" = 0))]
    pub twisting_friction: Option<f64>,
    /// Contact stiffness \[N/m\]: contacts give way as a spring that keeps the `restitution`; across the normal 2/5 of it.
    #[schemars(extend("exclusiveMinimum" = 0, "x-default" = "rigid"))]
    pub stiffness: Option<f64>,
    /// Archard's wear coefficient \[1/Pa\] of boundaries with `wall_fields`: the volume worn off per normal force and sliding path.
    #[schemars(extend("x-default" = "`0`", "minimum" = 0))]
    pub wear: Option<f64>,
    /// Pull-off force \[N\] of every contact: what has touched holds together until it is pulled with more than this.
    #[schemars(extend("minimum" = 0, "x-default" = "none"))]
    pub cohesion: Option<f64>,
    /// Surface energy (work of adhesion) \[J/m^2\], in place of `cohesion`: the pull-off force grows with the reduced radius.
    #[schemars(extend("minimum" = 0, "x-default" = "none"))]
    pub surface_energy: Option<f64>,
    /// How a surface energy becomes a force.
    #[schemars(extend("x-default" = "`\"dmt\"`"))]
    pub adhesion: Option<Adhesion>,
    /// Gap \[m\] up to which what holds together attracts with its pull-off force: length of a liquid bridge.
    #[schemars(extend("minimum" = 0, "x-default" = "as long as they touch"))]
    pub rupture_distance: Option<f64>,
    /// Bonds between all that touches at the start.
    #[schemars(extend("x-default" = "none"))]
    pub bond: Option<BondStrengths>,
}

/// `[[pair]]`: how two materials touch; what is left out is taken from their `[[material]]`s, then from `[pair_default]`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pair {
    /// The two materials, in either order.
    #[schemars(extend("minItems" = 2, "maxItems" = 2))]
    pub materials: Vec<String>,
    /// Friction coefficient \[-\]. Not together with `friction_angle`.
    #[schemars(extend("minimum" = 0))]
    pub friction: Option<f64>,
    /// Friction angle \[deg\].
    #[schemars(extend("minimum" = 0, "exclusiveMaximum" = 90))]
    pub friction_angle: Option<f64>,
    /// Coefficient of restitution \[-\].
    #[schemars(extend("minimum" = 0, "maximum" = 1))]
    pub restitution: Option<f64>,
    /// Coefficient of rolling resistance \[-\]: its couple is at most this times the reduced radius times the
    /// normal force.
    #[schemars(extend("minimum" = 0))]
    pub rolling_friction: Option<f64>,
    /// Coefficient of twisting resistance \[-\]: its couple about the normal is at most this times the reduced radius
    /// times the normal force.
    #[schemars(extend("minimum" = 0))]
    pub twisting_friction: Option<f64>,
    /// Contact stiffness \[N/m\]: contacts give way as a spring that keeps the `restitution`; across the normal 2/5 of it.
    #[schemars(extend("exclusiveMinimum" = 0, "x-default" = "what the materials and `[pair_default]` say"))]
    pub stiffness: Option<f64>,
    /// Archard's wear coefficient \[1/Pa\] of boundaries with `wall_fields`: the volume worn off per normal force and sliding path.
    #[schemars(extend("minimum" = 0))]
    pub wear: Option<f64>,
    /// Pull-off force \[N\] of every contact: what has touched holds together until it is pulled with more than this.
    #[schemars(extend("minimum" = 0, "x-default" = "that of `[pair_default]`"))]
    pub cohesion: Option<f64>,
    /// Surface energy (work of adhesion) \[J/m^2\], in place of `cohesion`: the pull-off force grows with the reduced radius.
    #[schemars(extend("minimum" = 0, "x-default" = "that of `[pair_default]`"))]
    pub surface_energy: Option<f64>,
    /// How a surface energy becomes a force.
    #[schemars(extend("x-default" = "`\"dmt\"`"))]
    pub adhesion: Option<Adhesion>,
    /// Gap \[m\] up to which what holds together attracts with its pull-off force: length of a liquid bridge.
    #[schemars(extend("minimum" = 0, "x-default" = "that of `[pair_default]`"))]
    pub rupture_distance: Option<f64>,
    /// Bonds between all that touches at the start.
    #[schemars(extend("x-default" = "that of `[pair_default]`"))]
    pub bond: Option<BondStrengths>,
}

/// `[[load]]`: a force on a sphere at a point that moves with it.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere.
    pub sphere: String,
    /// Force \[N\], world axes.
    pub force: Vector,
    /// Point of the sphere, from its centre, at t = 0, world axes \[m\].
    #[serde(default)]
    pub point: Vector,
}

/// `[[spring]]`: a constrained point, a spring from a point of a sphere to a target.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// The sphere: `"group[k]"`, or `"group"` if the group is one sphere.
    pub sphere: String,
    /// Stiffness \[N/m\].
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Point of the sphere, from its centre, at t = 0, world axes \[m\].
    #[serde(default)]
    pub point: Vector,
    /// Target \[m\].
    #[schemars(extend("x-default" = "where the point is at t = 0"))]
    pub target: Option<Vector>,
    /// Motion of the target, a point: translations only.
    #[schemars(extend("x-default" = "fixed"))]
    pub motion: Option<Motion>,
}
