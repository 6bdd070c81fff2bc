//! The variable table: names, references, types, units, start values and what each variable means.
//!
//! One table is built from a [`Scene`]. The XML of the model description and the dispatch of every get and set
//! come from it, so they cannot disagree. Its outputs are the solver's own list of what is measured,
//! [`sphere_dda::observe::quantities`]. Names of the scene are identifiers, so they need no quotes. The value reference of a
//! variable is its rank in the table, from 0.
//!
//! # When a command holds
//!
//! Pose, slide and hinge inputs are total displacements from the scene's placement: the boundary moves linearly
//! (a rotation by its logarithm) from where it is to the commanded pose and reaches it at the end of the
//! communication step. Speeds, forces and torques are held over the step. The start values mean "as in the scene": zero,
//! and for a belt or a servo wall the scene's surface velocity or pressure.

mod arrays;
mod parameters;
mod rows;

use serde::Serialize;
use sphere_dda::motion::Command;
use sphere_dda::observe::quantities::{Kind, quantities};
use sphere_dda::scene::Scene;
use sphere_dda_model_description::fmi2::{BaseType, Causality, Variability};

pub use arrays::{Array, Arrays, Field, Source};
pub use parameters::{Choices, Parameters};
use rows::{Row, Rows};

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
pub enum Meaning {
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
    /// Which solver takes the step's problem: an item of [`Choices::SOLVER`].
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
    pub choices: Option<&'static Choices>,
    /// One line for people.
    pub description: String,
    /// What it stands for.
    pub meaning: Meaning,
}

/// The variables of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Table {
    variables: Vec<Variable>,
}

impl Table {
    /// Builds the table: time, parameters, inputs of driven boundaries, then everything that is measured.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let mut rows = Rows::default();
        rows.push(
            Row::real("time", Some("s"), "Simulated time"),
            Causality::Independent,
            Meaning::Time,
        );
        rows.parameters(scene);
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            let prefix = format!("boundary.{}", boundary.name);
            if let Some(kind) = boundary.motion.input() {
                rows.inputs(&prefix, b, kind);
            }
            if let Some(belt) = boundary.belt.filter(|belt| belt.input) {
                rows.belt(&prefix, b, belt.velocity);
            }
            if let Some(pressure) = boundary.motion.pressure_input() {
                rows.servo(&prefix, b, pressure);
            }
        }
        for (rank, quantity) in quantities(scene).into_iter().enumerate() {
            let row = match quantity.kind {
                Kind::Real => Row::real(quantity.name, quantity.unit, quantity.description),
                Kind::Count => Row::count(quantity.name, quantity.description),
            };
            rows.push(row, Causality::Output, Meaning::Output(rank));
        }
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
        Input::Force => &mut command.force[axis],
        Input::Torque => &mut command.torque[axis],
        Input::Scalar => &mut command.scalar,
        Input::Pressure => &mut command.pressure,
        Input::SurfaceVelocity => &mut command.surface_velocity[axis],
    }
}
