//! The variable table: names, references, types, units, start values and what each variable means.
//!
//! One table is built from a [`Scene`]. The XML of the model description and the dispatch of every get and set
//! come from it, so they cannot disagree. Names of the scene are identifiers, so they need no quotes. The value reference of a variable is its rank in the table, from 0.
//!
//! # When a command holds
//!
//! Pose, slide and hinge inputs are total displacements from the scene's placement: the boundary moves linearly
//! (a rotation by its logarithm) from where it is to the commanded pose and reaches it at the end of the
//! communication step. Speeds are held over the step. Zero always means "as in the scene".

mod outputs;
mod parameters;
mod rows;

use sphere_dda::motion::{Command, Motion};
use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

pub use parameters::Parameters;
use rows::{Row, Rows};

/// A value of one of the four types of the C interface.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A real number, in the variable's unit.
    Real(f64),
    /// An integer.
    Integer(i32),
    /// A truth value.
    Boolean(bool),
    /// A text.
    String(String),
}

impl Value {
    /// The type in the C interface.
    #[must_use]
    pub fn base(&self) -> BaseType {
        match self {
            Self::Real(_) => BaseType::Real,
            Self::Integer(_) => BaseType::Integer,
            Self::Boolean(_) => BaseType::Boolean,
            Self::String(_) => BaseType::String,
        }
    }
}

/// What a variable stands for: the getter, and for inputs and parameters the setter.
/// `axis` counts components from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Time at the last communication point \[s\].
    Time,
    /// A setting of the run.
    Parameter(Parameter),
    /// A component of the command of a driven boundary.
    Input {
        /// Index of the boundary.
        boundary: usize,
        /// Which part of the command.
        input: Input,
        /// Component.
        axis: usize,
    },
    /// A quantity of a boundary.
    Boundary {
        /// Index of the boundary.
        boundary: usize,
        /// Which one.
        output: BoundaryOutput,
        /// Component.
        axis: usize,
    },
    /// A quantity of a probed sphere.
    Probe {
        /// Index of the probe.
        probe: usize,
        /// Which one.
        output: ProbeOutput,
        /// Component.
        axis: usize,
    },
    /// A reading of a sensor.
    Sensor {
        /// Index of the sensor.
        sensor: usize,
        /// Which one.
        output: SensorOutput,
    },
    /// A quantity of the whole scene.
    Global {
        /// Which one.
        output: GlobalOutput,
        /// Component.
        axis: usize,
    },
}

/// Settings that an importer may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// A component of gravity \[m/s^2\]; tunable.
    Gravity(usize),
    /// Where result files go; empty: nowhere.
    OutputDirectory,
    /// Whether an earlier run in that place may be replaced.
    OutputOverwrite,
    /// Time between VTU frames \[s\].
    OutputInterval,
    /// Tolerance of the gap \[-\].
    ToleranceGap,
    /// Tolerance of the slip \[-\].
    ToleranceSlip,
    /// Tolerance of the force \[-\].
    ToleranceForce,
    /// Largest internal time step \[s\].
    Step,
}

/// Parts of a [`Command`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// Total translation \[m\].
    Translation,
    /// Total rotation vector \[rad\].
    Rotation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Displacement, speed, angle or angular speed of a slide or hinge.
    Scalar,
}

/// Outputs of a boundary; the sign of a wrench is that of the spheres acting on the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BoundaryOutput {
    /// Force over the last internal step \[N\].
    Force,
    /// Torque about the point of action over the last internal step \[N m\].
    Torque,
    /// Force averaged over the communication step \[N\].
    AverageForce,
    /// Torque averaged over the communication step \[N m\].
    AverageTorque,
    /// Point of action \[m\].
    Position,
    /// Orientation, quaternion w, x, y, z.
    Orientation,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest normal force of one contact \[N\].
    MaxNormalForce,
    /// Power of the spheres on the boundary \[W\].
    Power,
}

/// Outputs of a probed sphere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProbeOutput {
    /// Centre \[m\].
    Position,
    /// Orientation, quaternion w, x, y, z.
    Orientation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Sum of the contact forces on it \[N\].
    ContactForce,
    /// Torque of the contact forces about its centre \[N m\].
    ContactTorque,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest normal force of one contact \[N\].
    MaxNormalForce,
}

/// Outputs of a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SensorOutput {
    /// Mass in a box, or cumulated mass through a plane \[kg\].
    Mass,
    /// Mass flow through a plane, mean over the communication step \[kg/s\].
    Rate,
}

/// Outputs of the whole scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GlobalOutput {
    /// Total mass of the spheres \[kg\].
    Mass,
    /// Momentum of the spheres, half-step velocities \[kg m/s\].
    Momentum,
    /// Angular momentum about the origin, half-step velocities \[kg m^2/s\].
    AngularMomentum,
    /// Kinetic energy \[J\].
    KineticEnergy,
    /// Potential energy of gravity and springs \[J\].
    PotentialEnergy,
    /// Energy lost in contacts since the start \[J\].
    DissipatedEnergy,
    /// Work of moving boundaries on the spheres since the start \[J\].
    BoundaryWork,
    /// Work of point loads since the start \[J\].
    LoadWork,
    /// Work of constrained springs since the start \[J\].
    SpringWork,
    /// Number of loaded contacts.
    ContactCount,
    /// Largest true overlap over radius of the communication step \[-\].
    MaxOverlap,
    /// Internal steps of the communication step.
    InternalSteps,
    /// Of those, how many came from halving.
    Cuts,
    /// Gauss-Seidel sweeps of the communication step.
    Sweeps,
    /// Augmented-Lagrangian iterations of the communication step.
    Augmentations,
    /// Factorizations of the communication step.
    Factorizations,
    /// Gap residual \[-\].
    GapResidual,
    /// Slip residual \[-\].
    SlipResidual,
    /// Force residual \[-\].
    ForceResidual,
    /// Internal step that is advised at the present speeds \[s\].
    RecommendedStep,
}

/// One variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Structured name, unique.
    pub name: String,
    /// Value reference: rank in the table.
    pub reference: u32,
    /// Type in the C interface.
    pub base: BaseType,
    /// Who provides the value.
    pub causality: Causality,
    /// When it may change.
    pub variability: Variability,
    /// Unit, a name of [`crate::description::units`]; `None`: a number without unit.
    pub unit: Option<&'static str>,
    /// Start value: of inputs and parameters.
    pub start: Option<Value>,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// One line for people.
    pub description: String,
    /// What it stands for.
    pub quantity: Quantity,
}

/// The variables of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    variables: Vec<Variable>,
}

impl Table {
    /// Builds the table: time, parameters, then inputs and outputs of boundaries, probes, sensors and the whole.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut rows = Rows::default();
        rows.push(
            Row::real("time", Some("s"), "Simulated time"),
            Causality::Independent,
            Quantity::Time,
        );
        rows.parameters(scene);
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            let prefix = format!("boundary.{}", boundary.name);
            if let Motion::Input(kind) = boundary.motion {
                rows.inputs(&prefix, b, kind);
            }
            rows.boundary(&prefix, b);
        }
        for (p, probe) in scene.probes.iter().enumerate() {
            rows.probe(&format!("probe.{}", probe.name), p);
        }
        for (s, sensor) in scene.sensors.iter().enumerate() {
            rows.sensor(&format!("sensor.{}", sensor.name), s, &sensor.measure);
        }
        rows.globals();
        Self {
            variables: rows.variables,
        }
    }

    /// All variables, by reference.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The variable with a value reference.
    #[must_use]
    pub fn get(&self, reference: u32) -> Option<&Variable> {
        self.variables.get(usize::try_from(reference).ok()?)
    }
}

/// The component of a command that an input drives.
#[must_use]
pub fn component(command: &mut Command, input: Input, axis: usize) -> &mut f64 {
    match input {
        Input::Translation => &mut command.translation[axis],
        Input::Rotation => &mut command.rotation[axis],
        Input::Velocity => &mut command.velocity[axis],
        Input::AngularVelocity => &mut command.angular_velocity[axis],
        Input::Scalar => &mut command.scalar,
    }
}
