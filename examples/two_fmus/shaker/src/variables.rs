//! The table of variables: XML, get and set come from it.

use sphere_dda_model_description::fmi2::{Causality, Variability};

/// Number of variables.
pub const COUNT: usize = 11;

/// Value reference of the force from outside \[N\].
pub const FORCE: usize = 0;
/// Value reference of the position \[m\].
pub const POSITION: usize = 1;
/// Value reference of the velocity \[m/s\].
pub const VELOCITY: usize = 2;
/// Value reference of the acceleration \[m/s^2\].
pub const ACCELERATION: usize = 3;
/// Value reference of the impulse of the force since the start \[kg.m/s\].
pub const IMPULSE: usize = 4;
/// Value reference of the mass \[kg\], the first of the parameters.
pub const MASS: usize = 5;
/// Value reference of the stiffness \[N/m\].
pub const STIFFNESS: usize = 6;
/// Value reference of the damping \[N.s/m\].
pub const DAMPING: usize = 7;
/// Value reference of the amplitude \[m\].
pub const AMPLITUDE: usize = 8;
/// Value reference of the frequency \[Hz\].
pub const FREQUENCY: usize = 9;
/// Value reference of the support \[N\].
pub const SUPPORT: usize = 10;

/// One variable, a real; its place in [`TABLE`] is its value reference.
#[derive(Debug, Clone, Copy)]
pub struct Variable {
    /// Name.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Value before anything is set; `None` if it is computed.
    pub start: Option<f64>,
    /// Causality.
    pub causality: Causality,
    /// Smallest value, and whether it is itself allowed.
    pub least: Option<(f64, bool)>,
    /// For people.
    pub description: &'static str,
}

const fn output(
    name: &'static str,
    unit: &'static str,
    start: Option<f64>,
    description: &'static str,
) -> Variable {
    Variable {
        name,
        unit,
        start,
        causality: Causality::Output,
        least: None,
        description,
    }
}

const fn parameter(
    name: &'static str,
    unit: &'static str,
    start: f64,
    zero_allowed: bool,
    description: &'static str,
) -> Variable {
    Variable {
        name,
        unit,
        start: Some(start),
        causality: Causality::Parameter,
        least: Some((0.0, zero_allowed)),
        description,
    }
}

/// All variables.
pub const TABLE: [Variable; COUNT] = [
    Variable {
        name: "force",
        unit: "N",
        start: Some(0.0),
        causality: Causality::Input,
        least: None,
        description: "Force on the mass, held over the communication step",
    },
    output(
        "position",
        "m",
        Some(0.0),
        "Position of the mass; 0: spring without force, foot at rest",
    ),
    output("velocity", "m/s", Some(0.0), "Velocity of the mass"),
    output("acceleration", "m/s2", None, "Acceleration of the mass"),
    output(
        "impulse",
        "kg.m/s",
        None,
        "Impulse that the force has given to the mass since the start",
    ),
    parameter("mass", "kg", 2.0, false, "Mass"),
    parameter(
        "stiffness",
        "N/m",
        8000.0,
        true,
        "Stiffness of the spring between mass and foot",
    ),
    parameter("damping", "N.s/m", 20.0, true, "Damping to the ground"),
    parameter(
        "amplitude",
        "m",
        1e-3,
        true,
        "Amplitude of the foot: A sin(2 pi f t)",
    ),
    parameter("frequency", "Hz", 8.0, true, "Frequency of the foot"),
    Variable {
        name: "support",
        unit: "N",
        start: Some(0.0),
        causality: Causality::Parameter,
        least: None,
        description: "Constant force on the mass, as of an air spring that carries a load at rest",
    },
];

impl Variable {
    /// Its variability: parameters are fixed.
    #[must_use]
    pub fn variability(&self) -> Variability {
        match self.causality {
            Causality::Parameter => Variability::Fixed,
            _ => Variability::Continuous,
        }
    }
}
