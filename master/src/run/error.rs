//! Why a simulation was not made, or did not reach its end.

use thiserror::Error;

use crate::error::ImportError;
use crate::system::VariableError;

use super::options::MAX_STEPS;
use super::table::Table;

/// Why a simulation was not made, or did not reach its end.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// The FMU cannot be loaded or instantiated.
    #[error("{}{source}", prefix(.component))]
    Import {
        /// Name of the FMU, if there are several.
        component: Option<String>,
        /// Why; told by the message above.
        source: Box<ImportError>,
    },
    /// Variables to set or to record that are not there, or not so: all of them.
    #[error("{}", list(.0))]
    Variables(Vec<VariableError>),
    /// Nobody says when to stop.
    #[error("stop time: found none in a model description, expected one: give a stop time")]
    NoStop,
    /// The times make no simulation.
    #[error(
        "times: found start {start} s, stop {stop} s and step {step} s, expected finite times, stop not before start, \
         a step greater than 0 and at most {MAX_STEPS:e} steps"
    )]
    Times {
        /// Start \[s\].
        start: f64,
        /// Stop \[s\].
        stop: f64,
        /// Step \[s\].
        step: f64,
    },
    /// The FMU needs steps of one length, and the duration is not a multiple of it.
    #[error(
        "step: found {step} s for a duration of {duration} s, expected a whole part of it, since an FMU needs steps \
         of one length: give another step or stop time"
    )]
    Uneven {
        /// Step \[s\].
        step: f64,
        /// Duration \[s\].
        duration: f64,
    },
    /// The numbers of an iteration make none.
    #[error(
        "iteration: found tolerance {tolerance}, at most {max_iterations} iterations and relaxation {relaxation}, expected \
         a finite tolerance greater than 0, at least 1 iteration and a relaxation greater than 0 and at most 1"
    )]
    Iteration {
        /// Tolerance, dimensionless.
        tolerance: f64,
        /// Most iterations of a step.
        max_iterations: u32,
        /// Relaxation, dimensionless.
        relaxation: f64,
    },
    /// Steps cannot be repeated.
    #[error(
        "FMU `{component}`: found no canGetAndSetFMUstate in its model description, expected it: iterated coupling \
         repeats steps; use another coupling"
    )]
    NoStates {
        /// Name of the FMU.
        component: String,
    },
    /// The values that FMUs exchange did not come to agree.
    #[error(
        "at time {time} s: {} changes by {change:.1e} of its greatest value after {max_iterations} iterations of the step, \
         expected at most {tolerance:e}: allow more iterations or a larger tolerance, give a shorter step, or let the run go on",
        .variable.as_ref().map_or("a value that is no real number".to_owned(), |name| format!("`{name}`"))
    )]
    NotConverged {
        /// The communication point before the step \[s\].
        time: f64,
        /// Name of the output that changes most.
        variable: Option<String>,
        /// Its change, as a part of its greatest magnitude.
        change: f64,
        /// Most iterations of a step.
        max_iterations: u32,
        /// What was asked for.
        tolerance: f64,
        /// What was recorded so far.
        table: Box<Table>,
    },
    /// A call failed after the FMU was instantiated.
    #[error("at time {time} s: {}{failure}", prefix(.component))]
    Call {
        /// The last communication point reached \[s\].
        time: f64,
        /// Name of the FMU, if there are several.
        component: Option<String>,
        /// What failed; told by the message above, so not once more as its source.
        failure: Box<ImportError>,
        /// What was recorded so far.
        table: Box<Table>,
    },
    /// An output is not a number.
    #[error(
        "at time {time} s: variable `{variable}`: found NaN, expected a number: see what the FMU logged, or allow it"
    )]
    Nan {
        /// The communication point \[s\].
        time: f64,
        /// Name of the first such variable.
        variable: String,
        /// What was recorded so far, the NaN in the last row.
        table: Box<Table>,
    },
    /// The FMU discarded a step again and again.
    #[error(
        "at time {time} s: {}{function}: found a discarded step of {step} s, expected it done: {mend}",
        prefix(.component)
    )]
    Discarded {
        /// Where the last attempt began \[s\].
        time: f64,
        /// Name of the FMU, if there are several.
        component: Option<String>,
        /// Function of its version that takes steps.
        function: &'static str,
        /// How far it should have come \[s\].
        step: f64,
        /// What to do.
        mend: &'static str,
        /// What was recorded so far.
        table: Box<Table>,
    },
}

fn list(errors: &[VariableError]) -> String {
    let lines: Vec<String> = errors.iter().map(VariableError::to_string).collect();
    lines.join("\n")
}

fn prefix(component: &Option<String>) -> String {
    component.iter().map(|name| format!("{name}: ")).collect()
}

impl SimulateError {
    /// What was recorded before the error.
    pub fn table(&self) -> Option<&Table> {
        match self {
            Self::Call { table, .. }
            | Self::Nan { table, .. }
            | Self::NotConverged { table, .. }
            | Self::Discarded { table, .. } => Some(table),
            _ => None,
        }
    }
}
