//! The master: FMUs from start to stop, inputs from a table, outputs to a table, values from FMU to FMU.

use std::ops::ControlFlow;

use thiserror::Error;

use super::exchange::{Exchange, Load};
use super::grid::{Grid, MAX_STEPS};
use super::iterate::{Iteration, Memory};
use super::run::{Halt, Run, forward};
use super::system::System;
use super::values::{check_settable_at_start, parse};
use super::{ImportError, Message, Signals, Table, VariableError};

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
    /// When [`Coupling::Iterated`] ends.
    pub iteration: Iteration,
    /// Inputs over time.
    pub inputs: Option<Signals>,
    /// Names of the variables to record; all outputs if `None`.
    pub outputs: Option<Vec<String>>,
    /// Values, as text, of parameters and other variables that can be set before the initialization.
    pub set: Vec<(String, String)>,
    /// Name of the instance of one FMU alone; that of the model if `None`. Of several each has that of its component.
    pub instance_name: Option<String>,
    /// Ask the FMU to log more than warnings and errors.
    pub logging: bool,
    /// Record NaN like any value instead of ending with an error.
    pub allow_nan: bool,
}

/// What happens during a simulation.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Event<'a> {
    /// The FMUs have reached a communication point.
    Time {
        /// The point \[s\].
        time: f64,
        /// Number of the step that led to it; 0 at the start.
        step: u64,
        /// Number of all steps.
        steps: u64,
        /// What has been recorded, this point included.
        table: &'a Table,
    },
    /// An FMU has logged a message.
    Message(&'a Message),
    /// An FMU has logged more than could be kept.
    MessagesLost(usize),
}

/// Why a simulation was not made, or did not reach its end.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// The FMU cannot be loaded or instantiated.
    #[error(transparent)]
    Import(#[from] Box<ImportError>),
    /// A variable to set or to record is not there, or not so.
    #[error(transparent)]
    Variable(#[from] VariableError),
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
        "iteration: found tolerance {tolerance}, limit {limit} and relaxation {relaxation}, expected a finite tolerance \
         greater than 0, a limit of at least 1 and a relaxation greater than 0 and at most 1"
    )]
    Iteration {
        /// Tolerance, dimensionless.
        tolerance: f64,
        /// Most tries.
        limit: u32,
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
        "at time {time} s: {} changes by {change:.1e} of its greatest value after {limit} tries of the step, expected at \
         most {tolerance:e}: allow more tries or a larger tolerance, give a shorter step, or let the run go on",
        .variable.as_ref().map_or("a value that is no real number".to_owned(), |name| format!("`{name}`"))
    )]
    Apart {
        /// The communication point before the step \[s\].
        time: f64,
        /// Name of the output that changes most.
        variable: Option<String>,
        /// Its change, as a part of its greatest magnitude.
        change: f64,
        /// Most tries of a step.
        limit: u32,
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
        "at time {time} s: {}fmi2DoStep: found a discarded step of {step} s, expected it done: {mend}",
        prefix(.component)
    )]
    Discarded {
        /// Where the last attempt began \[s\].
        time: f64,
        /// Name of the FMU, if there are several.
        component: Option<String>,
        /// How far it should have come \[s\].
        step: f64,
        /// What to do.
        mend: &'static str,
        /// What was recorded so far.
        table: Box<Table>,
    },
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
            | Self::Apart { table, .. }
            | Self::Discarded { table, .. } => Some(table),
            _ => None,
        }
    }
}

/// Simulates the FMUs of a system once, from start to stop. `observe` hears every [`Event`] and can end the simulation
/// by breaking.
///
/// The FMUs enter initialization mode together; there inputs get their values at the start, connected ones those of
/// their outputs. Before the step from t, inputs of the table get their values at t, connected ones as
/// [`Coupling`] says; then the FMUs step in their order.
///
/// A discarded step is taken up again where the FMU says it came to, or with half the length if it came nowhere; if
/// the FMU cannot take such steps, or does not get on, that is an error. Inputs do not change meanwhile.
///
/// # Errors
///
/// Every variant of [`SimulateError`]; those that happen after the start carry what was recorded.
pub fn simulate(
    system: &System<'_>,
    options: &Options,
    mut observe: impl FnMut(Event<'_>) -> ControlFlow<()>,
) -> Result<Table, SimulateError> {
    let grid = Grid::new(system, options)?;
    let mut table = Table::for_outputs(system, options.outputs.as_deref())?;
    let mut start_values = vec![Load::new(); system.fmus().len()];
    for (name, text) in &options.set {
        let variable = system.find(name)?;
        check_settable_at_start(&variable)?;
        system.check_free(&variable)?;
        let values = parse(&variable, text)?;
        if let Some(load) = start_values.get_mut(variable.component) {
            load.extend(variable.places().into_iter().zip(values));
        }
    }
    let mut instances = Vec::new();
    for (k, fmu) in system.fmus().enumerate() {
        let own = options.instance_name.as_deref();
        let own = own.unwrap_or(fmu.description().model_name());
        let name = system.component_name(k).unwrap_or(own);
        instances.push(fmu.participant(name, options.logging).map_err(Box::new)?);
    }

    let exchange = Exchange::new(system, options.allow_nan);
    check_iteration(system, options, &exchange)?;
    let mut run = Run {
        system,
        options,
        grid,
        exchange,
        memory: Memory::default(),
        instances,
        table: &mut table,
    };
    let result = run.drive(&start_values, &mut observe);
    // What they logged last belongs to the failure.
    let _ended = forward(&run.instances, &mut observe);
    drop(run);
    let time = table.time.last().copied().unwrap_or(grid.start);
    let halt = match result {
        Ok(end) => {
            table.end = end;
            return Ok(table);
        }
        Err(halt) => halt,
    };
    let table = Box::new(table);
    let named = |component| system.component_name(component).map(str::to_owned);
    Err(match halt {
        Halt::Call(component, failure) => SimulateError::Call {
            time,
            component: named(component),
            failure,
            table,
        },
        Halt::Nan(variable) => SimulateError::Nan {
            time,
            variable,
            table,
        },
        Halt::Apart { variable, change } => SimulateError::Apart {
            time,
            variable,
            change,
            limit: options.iteration.limit,
            tolerance: options.iteration.tolerance,
            table,
        },
        Halt::Discarded {
            component,
            time,
            step,
            mend,
        } => SimulateError::Discarded {
            time,
            component: named(component),
            step,
            mend,
            table,
        },
    })
}

/// Whether the numbers make sense, and all steps can be repeated.
fn check_iteration(
    system: &System<'_>,
    options: &Options,
    exchange: &Exchange,
) -> Result<(), SimulateError> {
    let Iteration {
        tolerance,
        limit,
        relaxation,
        ..
    } = options.iteration;
    let sound = tolerance.is_finite() && tolerance > 0.0 && limit > 0;
    if !(sound && relaxation > 0.0 && relaxation <= 1.0) {
        return Err(SimulateError::Iteration {
            tolerance,
            limit,
            relaxation,
        });
    }
    if options.coupling != Coupling::Iterated || !exchange.has_loops() {
        return Ok(());
    }
    let mut fmus = system.fmus().enumerate();
    match fmus.find(|(_, fmu)| !fmu.description().has_states()) {
        None => Ok(()),
        Some((k, fmu)) => Err(SimulateError::NoStates {
            component: system
                .component_name(k)
                .unwrap_or(fmu.description().model_name())
                .to_owned(),
        }),
    }
}
