//! How to simulate, as the caller says it.

use crate::isolate::Isolation;

use super::input_table::InputTable;

/// Most steps of one simulation.
pub(super) const MAX_STEPS: f64 = 1e12;

/// When connected FMUs exchange values. The step from t to t + h follows the exchange.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Coupling {
    /// Every input has the value that its output had at t: the order of the FMUs does not matter.
    #[default]
    Jacobi,
    /// The FMUs step one after another; an input has the value at t + h of an output of an FMU that has stepped
    /// already, the value at t of the others. The order of the FMUs matters.
    GaussSeidel,
    /// The step is repeated from saved states until every input has the value that its output has at t + h. The FMUs
    /// step one after another in each try; all must be able to save and restore their state if there is a loop.
    Iterated,
}

/// When exchanged values agree, and how they are sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Iteration {
    /// Greatest change of a value from one iteration of a step to the next that counts as none, as a part of the greatest
    /// magnitude that the value has had; dimensionless, greater than 0.
    pub tolerance: f64,
    /// Most iterations of one step, at least 1.
    pub max_iterations: u32,
    /// Part of the difference by which the second iteration of the first step goes, in (0, 1].
    pub relaxation: f64,
    /// After the most iterations, go on with the one whose values changed least instead of ending with an error. Where a
    /// contact opens or closes within a step, what an FMU answers can jump past every value that would agree.
    pub accept_unconverged: bool,
}

impl Default for Iteration {
    /// Tolerance 1e-6, 30 iterations, relaxation 0.5, an error if they do not do.
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            max_iterations: 30,
            relaxation: 0.5,
            accept_unconverged: false,
        }
    }
}

/// How to simulate. What is `None` is taken from the FMUs' default experiments: from the first FMU that tells.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Start time \[s\]; 0 if the FMU does not tell either.
    pub start: Option<f64>,
    /// Stop time \[s\].
    pub stop: Option<f64>,
    /// Communication step \[s\]; 1/500 of the duration if the FMU does not tell either.
    pub step: Option<f64>,
    /// Relative tolerance for all, dimensionless; if `None`, each FMU gets its own, if it has one.
    pub tolerance: Option<f64>,
    /// When connected FMUs exchange values.
    pub coupling: Coupling,
    /// With [`Coupling::Jacobi`], let the FMUs step one after another on the thread of the caller instead of at the same time
    /// on threads of their own. The results are the same, bit for bit.
    pub sequential: bool,
    /// When [`Coupling::Iterated`] ends.
    pub iteration: Iteration,
    /// Inputs over time.
    pub inputs: Option<InputTable>,
    /// Names of the variables to record, `*` for any text and `?` for a letter; all outputs if `None`.
    pub outputs: Option<Vec<String>>,
    /// Values, as text, of parameters and other variables that can be set before the initialization.
    pub set: Vec<(String, String)>,
    /// Name of the instance of one FMU alone; that of the model if `None`. Of several each has that of its component.
    pub instance_name: Option<String>,
    /// Ask the FMU to log more than warnings and errors.
    pub logging: bool,
    /// Record NaN like any value instead of ending with an error.
    pub allow_nan: bool,
    /// Run each FMU in a process of its own; in this one if `None`.
    pub isolation: Option<Isolation>,
    /// Keep the last row of the table alone: the observer takes the others as they come.
    pub keep_last: bool,
}
