//! A scene as data: spheres, materials, boundaries with their motion, loads, sources, sensors, settings.
//!
//! [`crate::scene_file`] reads one; it never changes in a run.

pub(crate) mod accuracy;
pub mod body;
mod boundary;
pub mod clump;
mod command;
pub mod gravity;
pub(crate) mod line_of_sight;
pub mod materials;
pub(crate) mod motion;
mod parameters;
pub mod particles;
pub mod rotating_frame;

pub use accuracy::Accuracy;
pub use boundary::{Belt, Boundary};
pub use command::{Command, CommandDerivatives, InputKind};
pub use motion::Motion;
pub use parameters::Parameter;

use std::ops::Range;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contact::elasticity::Elasticity;
use crate::contact::forces::ContactForces;
use crate::contact::{ContactId, Partner};
use crate::geometry::region::{Primitive, Region};
use crate::integrator::Integrator;
use crate::scene::body::Body;
use crate::scene::clump::Clump;
use crate::scene::gravity::GravityMotion;
use crate::scene::materials::{Material, PairTable};
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::rotating_frame::RotatingFrame;
use crate::solver::{Registers, SolverKind, Tolerance};
use crate::spatial::cell::Cell;

/// How contact constraints are enforced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Augmented Lagrangian: overlap within the tolerance whatever the penalty.
    #[default]
    Alm,
    /// Contact springs of stiffness `penalty`: the original DDA.
    Penalty,
}

/// What holds unless a scene file says otherwise. Steps and duration, which a file chooses from its spheres or must give, are
/// those of small tests.
impl Default for Settings {
    fn default() -> Self {
        let accuracy = Accuracy::default();
        Self {
            gravity: Vec3::new(0.0, 0.0, -9.81),
            gravity_motion: GravityMotion::Fixed,
            rotating_frame: None,
            duration: 1.0,
            step: 1e-3,
            smallest_step: None,
            accuracy,
            rest_speed: 0.0,
            sweeps: None,
            communication_step: 1e-3,
            method: Method::default(),
            integrator: Integrator::default(),
            solver: SolverKind::default(),
            penalty: None,
            adapt_penalty: true,
            tolerance: accuracy.tolerance(),
            opening: accuracy.opening_of(accuracy.tolerance().gap),
            strict: false,
            max_initial_overlap: 0.05,
            threshold_velocity: 0.0,
            dynamic_coefficient: 1.0,
            max_iterations: 20_000,
            max_cuts: 10,
            threads: 1,
            registers: Registers::default(),
        }
    }
}

/// Everything a run needs but bodies and boundaries.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// Gravity \[m/s^2\], at t = 0 if it moves.
    pub gravity: Vec3,
    /// How gravity changes with time.
    pub gravity_motion: GravityMotion,
    /// The turning frame in which the scene is given and solved; `None`: an inertial one.
    pub rotating_frame: Option<RotatingFrame>,
    /// End time of a run \[s\].
    pub duration: f64,
    /// Largest internal time step \[s\].
    pub step: f64,
    /// Smallest internal step that is chosen for least total time \[s\]; what fails is cut below. `None`: all steps are as long
    /// as `step` allows.
    pub smallest_step: Option<f64>,
    /// What the scene asks for: `step`, `smallest_step`, `tolerance` and `opening` follow from it unless they are given.
    pub accuracy: Accuracy,
    /// Speed below which all centres, and surfaces where they touch, must be for spheres to fall asleep \[m/s\]; 0: never.
    pub rest_speed: f64,
    /// Most sweeps of a step, which is then as good as it is; `None`: until the tolerances are reached.
    pub sweeps: Option<usize>,
    /// Communication step of `run` and of the FMU's DefaultExperiment \[s\].
    pub communication_step: f64,
    /// Contact enforcement.
    pub method: Method,
    /// Time integration.
    pub integrator: Integrator,
    /// Solver.
    pub solver: SolverKind,
    /// Penalty number `P_n` \[N/m\]; `None`: chosen from mass and step. The penalty method needs it.
    pub penalty: Option<f64>,
    /// Whether the augmented-Lagrangian loop may change the penalty and sweep between its multiplier updates;
    /// `false` is exactly the paper's loop.
    pub adapt_penalty: bool,
    /// Tolerances of every step.
    pub tolerance: Tolerance,
    /// Largest gap over the smaller radius at which a contact may carry load \[-\].
    pub opening: f64,
    /// Whether a step that does not meet the tolerances ends the run; otherwise its best iterate is taken and counted.
    pub strict: bool,
    /// Initial overlap over the smaller radius that is removed by displacement before t = 0 \[-\].
    pub max_initial_overlap: f64,
    /// Approach speed below which an impact does not rebound \[m/s\]; the scheme's own bound is added.
    pub threshold_velocity: f64,
    /// Dynamic coefficient `k` of the Shi integrator: share of the velocity kept by the next step, 0..=1.
    pub dynamic_coefficient: f64,
    /// Most iterations a solver may spend on one problem (sweeps, or factorizations times 20).
    pub max_iterations: usize,
    /// How often a step may be halved before it is given up.
    pub max_cuts: u32,
    /// Threads; results are the same for any number.
    pub threads: usize,
    /// Vector registers of the sweeps.
    pub registers: Registers,
}

/// Share of the largest overlap and opening left to the linear problem; the rest is for curvature and rounding.
const LINEAR_SHARE: f64 = 0.9;

/// Opening over the tolerance of overlaps that curvature may leave where a scene asks for contacts at zero gap.
const CURVATURE: f64 = 10.0;

/// Acceleration by which a contact below the reserve opens, over gravity.
const OPENED: f64 = 0.01;

impl Settings {
    /// Length \[m\] by which a contact that is to carry load may open within a step of `dt` \[s\].
    pub(crate) fn opened(&self, dt: f64) -> f64 {
        OPENED * self.gravity.norm() * dt * dt
    }

    /// Gap \[m\] at which a contact is to carry load that a step with this [`Self::opened`] finds at `gap` \[m\], `radius` \[m\] being
    /// the smaller one: its own between one and two reserves, so that what rests keeps its place and its forces. A narrower one opens
    /// little by little, which presses like a hundredth of the weight.
    #[inline]
    pub(crate) fn carried(&self, gap: f64, radius: f64, opened: f64) -> f64 {
        let reserve = self.reserve() * radius;
        let touching = gap.max(0.0);
        let opened = touching + opened;
        opened.min(reserve).max(touching).min(2.0 * reserve)
    }

    /// Overlap \[m\] that a step of `dt` \[s\] may leave of one that it finds at `gap` \[m\] beyond the tolerance: that is pushed out as fast
    /// as in one longest step. In a short step `overlap/dt` would be a shot.
    #[inline]
    pub(crate) fn left(&self, gap: f64, radius: f64, dt: f64) -> f64 {
        let beyond = -gap - self.tolerance.gap * radius;
        match beyond > 0.0 {
            true => beyond * (1.0 - dt / self.step).max(0.0),
            false => 0.0,
        }
    }

    /// Largest gap over the smaller radius at which surfaces touch \[-\]: what a step may leave open, and its own error.
    #[inline]
    pub(crate) fn closed(&self) -> f64 {
        (self.tolerance.gap + self.opening).max(1e-9)
    }

    /// Reserve `r` \[-\] by which loaded contacts keep away from overlaps, and from their largest opening. Gaps aimed at lie in
    /// `r..=2r`, those of a solution in `-l gap..=l opening`, `l` being [`LINEAR_SHARE`].
    #[inline]
    pub(crate) fn reserve(&self) -> f64 {
        match self.method {
            Method::Alm => LINEAR_SHARE / 3.0 * (self.opening - self.tolerance.gap).max(0.0),
            Method::Penalty => 0.0,
        }
    }

    /// Whether nothing acts on all spheres that changes with time or place.
    pub(crate) fn is_steady(&self) -> bool {
        self.gravity_motion == GravityMotion::default() && self.rotating_frame.is_none()
    }

    /// Largest opening of a loaded contact that a step may leave \[-\]: without a reserve what curvature does.
    pub(crate) fn widest(&self) -> f64 {
        match self.reserve() > 0.0 {
            true => self.opening,
            false => CURVATURE * self.tolerance.gap,
        }
    }

    /// Tolerances of the linear problem of a step that may use `share` of the reserve, 0..=1 \[-\].
    pub(crate) fn linear_tolerance(&self, share: f64) -> Tolerance {
        Tolerance {
            gap: LINEAR_SHARE * self.tolerance.gap + share * self.reserve(),
            ..self.tolerance
        }
    }
}

/// A force on a sphere at a point that moves with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PointLoad {
    /// Sphere index.
    pub sphere: usize,
    /// Point of the sphere, from its centre \[m\] in its own axes, those of the world where its orientation is zero.
    pub arm: Vec3,
    /// Force \[N\], world axes.
    pub force: Vec3,
}

/// A constrained point: a spring from a point of a sphere to a fixed or driven target.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spring {
    /// Sphere index.
    pub sphere: usize,
    /// Point of the sphere, from its centre \[m\] in its own axes, those of the world where its orientation is zero.
    pub arm: Vec3,
    /// Stiffness `P_c` \[N/m\].
    pub stiffness: f64,
    /// Target at t = 0 \[m\].
    pub target: Vec3,
    /// Motion of the target (`translation` only); not [`crate::scene::Motion::Input`].
    pub motion: crate::scene::Motion,
}

/// What a named sensor measures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Measure {
    /// What is inside a region.
    Region(Primitive),
    /// Force \[N\] and torque \[N m\] on a boundary, averaged over the communication step.
    Wrench {
        /// Index of the boundary.
        boundary: usize,
    },
    /// Cumulated mass \[kg\] and mean flow \[kg/s\] of centres that cross a plane along its normal
    /// (crossings against it count negative).
    MassFlow {
        /// A point of the plane \[m\].
        point: Vec3,
        /// Unit normal.
        normal: Vec3,
        /// Corners \[m\] of the convex polygon that counts, turning about `normal`; empty: the whole plane.
        outline: Vec<Vec3>,
    },
}

/// How much a source emits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Supply {
    /// Spheres per second \[1/s\].
    Spheres(f64),
    /// Mass per second \[kg/s\].
    Mass(f64),
}

/// Emits spheres into a region, wherever there is room.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// Name.
    pub name: String,
    /// Indices of its spheres; they wait outside the scene at t = 0.
    pub spheres: std::ops::Range<usize>,
    /// Where they appear.
    pub region: Region,
    /// How much it emits.
    pub supply: Supply,
    /// Start of the emission \[s\].
    pub start: f64,
    /// End of the emission \[s\]; infinite: never.
    pub stop: f64,
    /// Velocity \[m/s\] and angular velocity \[rad/s\] of new spheres.
    pub twist: crate::spatial::Twist,
    /// Seed of the places.
    pub seed: u64,
}

/// Removes the spheres whose centre lies in a region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sink {
    /// Name.
    pub name: String,
    /// Where spheres are removed.
    pub region: Region,
    /// Index of the source that gets them; `None`: a source's spheres return to it, others leave for good.
    pub recycle: Option<usize>,
}

/// A named sensor. Every boundary's wrench and every probe are outputs without being named here.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sensor {
    /// Name, unique in the scene.
    pub name: String,
    /// What it measures.
    pub measure: Measure,
}

/// A sphere whose state is an output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Name in the outputs.
    pub name: String,
    /// Sphere index.
    pub sphere: usize,
    /// Whether the scene asks for it; the first, the middle and the last sphere are probed where it asks for none.
    pub asked: bool,
}

/// `[fmu]`: what importers see of the scene.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Exposed {
    /// Names of the variables that are outputs, `*` for any text and `?` for one letter; all others that are measured are `local`:
    /// recorded on demand, not to be connected. `["*"]` makes all of them outputs.
    #[schemars(extend("x-default" = "what the scene asks for, see [outputs](fmu.md#outputs)"))]
    pub outputs: Option<Vec<String>>,
    /// Rows of the arrays `contacts.*` of its FMU of FMI 3.0, outputs with all loaded contacts; 0: no such arrays.
    pub contacts: u32,
    /// Whether its FMU of FMI 3.0 has the input `spheres.appliedForce`: forces at the centres of all spheres \[N\].
    pub applied_forces: bool,
}

/// `[output]`: result files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Seconds between VTU frames \[s\]; 0: none.
    #[schemars(extend("minimum" = 0))]
    pub vtu_interval: f64,
    /// Seconds between rows of the CSV history \[s\]; 0: every communication step.
    #[schemars(extend("minimum" = 0))]
    pub csv_interval: f64,
    /// Write Float64 instead of Float32 arrays.
    pub float64: bool,
    /// Simulated seconds between checkpoints of `run` \[s\]; 0: only those every five minutes of wall time, on Ctrl-C and at
    /// the end.
    #[schemars(extend("minimum" = 0))]
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

/// What its author says of a scene, in words of their own; for FMUs.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct About {
    /// One line about the model.
    pub description: Option<String>,
    /// Who made it.
    pub author: Option<String>,
    /// Version of the model, not of this program.
    pub version: Option<String>,
    /// Copyright notice.
    pub copyright: Option<String>,
    /// Licence of the model, not of this program.
    pub license: Option<String>,
}

/// A validated scene: every index in range, every number finite, units SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Title, one line.
    pub title: String,
    /// What its author says of it.
    pub about: About,
    /// SHA-256 of the scene text and the files it names, 64 hexadecimal digits.
    pub hash: String,
    /// Settings of the run.
    pub settings: Settings,
    /// Materials.
    pub materials: Vec<Material>,
    /// Friction and restitution of each pair of materials.
    pub pairs: PairTable,
    /// The spheres.
    pub particles: Particles,
    /// Clumps, by ascending spheres.
    pub clumps: Vec<Clump>,
    /// Their placement and velocity at t = 0.
    pub initial: Kinematics,
    /// Contacts whose forces at t = 0 are known, in canonical order: where their solution starts from.
    pub initial_contacts: ContactForces,
    /// The periodic cell; without periodic axes unless the scene has some.
    pub cell: Cell,
    /// Boundaries.
    pub boundaries: Vec<Boundary>,
    /// Point loads.
    pub loads: Vec<PointLoad>,
    /// Constrained points.
    pub springs: Vec<Spring>,
    /// Sources of spheres.
    pub sources: Vec<Source>,
    /// Sinks of spheres.
    pub sinks: Vec<Sink>,
    /// Sensors.
    pub sensors: Vec<Sensor>,
    /// Probed spheres.
    pub probes: Vec<Probe>,
    /// Numbers with a name.
    pub parameters: Vec<Parameter>,
    /// Result files.
    pub output: Output,
    /// What importers of its FMU see.
    pub exposed: Exposed,
}

impl Scene {
    /// The spheres that move as one with sphere `i`: those of its clump, or it alone.
    #[must_use]
    pub fn grain(&self, i: usize) -> Range<usize> {
        match self.particles.clump(i) {
            Some(clump) => self.clumps[clump].members.clone(),
            None => i..i + 1,
        }
    }

    /// The materials that touch in a contact.
    #[inline]
    pub(crate) fn touching(&self, key: ContactId) -> [u16; 2] {
        let material = &self.particles.material;
        let of_b = match key.partner {
            Partner::Sphere { index, .. } => material[index as usize],
            Partner::Boundary { boundary, .. } => self.boundaries[usize::from(boundary)].material,
        };
        [material[key.sphere as usize], of_b]
    }

    /// How a contact gives way, if it does: by the penalty method, the `stiffness` of its boundary, or its materials.
    pub(crate) fn elasticity(&self, key: ContactId) -> Option<Elasticity> {
        if let (Method::Penalty, Some(penalty)) = (self.settings.method, self.settings.penalty) {
            return Some(Elasticity::linear(penalty));
        }
        if let Partner::Boundary { boundary, .. } = key.partner
            && let Some(stiffness) = self.boundaries[usize::from(boundary)].stiffness
        {
            let shear = f64::INFINITY;
            return Some(Elasticity::Linear { stiffness, shear });
        }
        let [a, b] = self.touching(key);
        self.pairs.get(a, b).elasticity
    }

    /// Largest gap \[m\] over which bridges, necks and bonds hold spheres of at most `largest` \[m\] radius.
    pub(crate) fn holding_distance(&self, largest: f64) -> f64 {
        if !self.pairs.coheres() {
            return 0.0;
        }
        let walls = self.boundaries.iter().filter_map(|b| b.stiffness);
        let walls = walls.map(Elasticity::linear);
        self.pairs.holding_distance(largest, walls)
    }

    /// The driven bodies and the index of their boundary, ascending.
    pub fn driven(&self) -> impl Iterator<Item = (usize, &Body)> {
        let boundaries = self.boundaries.iter().enumerate();
        boundaries.filter_map(|(b, boundary)| match &boundary.motion {
            Motion::Driven(body) => Some((b, &**body)),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An overlap of 0.1 R beyond the tolerance goes within a longest step; a tenth of that takes a tenth of it.
    #[test]
    fn overlaps_go_at_the_pace_of_a_longest_step() {
        let settings = Settings {
            step: 1e-3,
            ..Settings::default()
        };
        let (radius, tolerance) = (0.5, settings.tolerance.gap);
        let found = -(0.1 + tolerance) * radius;
        for (dt, left) in [(1e-3, 0.0), (1e-4, 0.045), (2e-3, 0.0)] {
            assert!((settings.left(found, radius, dt) - left).abs() < 1e-12);
        }
        assert_eq!(settings.left(-tolerance * radius, radius, 1e-4), 0.0);
        assert_eq!(settings.left(0.1, radius, 1e-4), 0.0);
    }
}
