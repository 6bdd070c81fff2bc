//! One variable: its name, type and start, and what it stands for.

use serde::Serialize;
use sphere_dda::scene::Command;
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

use super::enumeration::Enumeration;

/// A value of one of the four types of the C interface.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Binding {
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
    /// A measured quantity: its rank in [`sphere_dda::observe::quantities::values`].
    Output(usize),
}

/// Settings that an importer may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
    /// Most sweeps of an internal step; 0: as many as the tolerances need.
    Sweeps,
    /// Largest internal time step \[s\].
    Step,
    /// Which solver takes the step's problem: an item of [`Enumeration::SOLVER`].
    Solver,
}

/// Parts of a [`Command`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Input {
    /// Total translation \[m\].
    Translation,
    /// Total rotation vector \[rad\].
    Rotation,
    /// Velocity \[m/s\].
    Velocity,
    /// Angular velocity \[rad/s\].
    AngularVelocity,
    /// Force \[N\] on a driven body.
    Force,
    /// Torque \[N m\] on a driven body.
    Torque,
    /// Displacement, speed, angle, angular speed, force or torque of a slide or hinge.
    Scalar,
    /// Velocity of the surface against the boundary \[m/s\].
    SurfaceVelocity,
    /// Pressure of a servo wall \[Pa\].
    Pressure,
}

/// One variable.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    /// Unit, one that the exporter defines; `None`: a number without unit.
    pub unit: Option<&'static str>,
    /// Start value: of inputs and parameters.
    pub start: Option<Value>,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// The named values of an integer that has no others.
    pub choices: Option<&'static Enumeration>,
    /// One line for people.
    pub description: String,
    /// What it stands for.
    pub binding: Binding,
}

/// The component of a command that an input drives.
#[must_use]
pub fn component(command: &mut Command, input: Input, axis: usize) -> &mut f64 {
    match input {
        Input::Translation => &mut command.translation[axis],
        Input::Rotation => &mut command.rotation[axis],
        Input::Velocity => &mut command.velocity[axis],
        Input::AngularVelocity => &mut command.angular_velocity[axis],
        Input::Force => &mut command.force[axis],
        Input::Torque => &mut command.torque[axis],
        Input::Scalar => &mut command.scalar,
        Input::Pressure => &mut command.pressure,
        Input::SurfaceVelocity => &mut command.surface_velocity[axis],
    }
}
