//! The master: one FMU from start to stop, inputs from a table, outputs to a table.
//!
//! Communication points are `start + k step`, never accumulated, and the last is exactly `stop`. Before the step
//! from t the inputs have their values at t.

use std::ops::ControlFlow;

use thiserror::Error;

use super::values::{Value, check_settable_at_start, find, parse, set};
use super::{End, Fmu, ImportError, Instance, Message, Signals, Step, Table, VariableError};

/// Steps between start and stop if neither the caller nor the FMU says how long one is.
const DEFAULT_STEPS: f64 = 500.0;

/// Most steps of one simulation.
const MAX_STEPS: f64 = 1e12;

/// Part of a step by which the duration may miss a whole number of steps and still count as one.
const STEP_TOLERANCE: f64 = 1e-9;

/// Most attempts to come from one communication point to the next with an FMU that discards.
const MAX_ATTEMPTS: u32 = 12;

/// What to simulate. What is `None` is taken from the FMU's default experiment.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Start time \[s\]; 0 if the FMU does not tell either.
    pub start: Option<f64>,
    /// Stop time \[s\].
    pub stop: Option<f64>,
    /// Communication step \[s\]; 1/500 of the duration if the FMU does not tell either.
    pub step: Option<f64>,
    /// Relative tolerance, dimensionless; none if the FMU does not tell either.
    pub tolerance: Option<f64>,
    /// Inputs over time.
    pub inputs: Option<Signals>,
    /// Names of the variables to record; all outputs if `None`.
    pub outputs: Option<Vec<String>>,
    /// Values, as text, of parameters and other variables that can be set before the initialization.
    pub set: Vec<(String, String)>,
    /// Name of the instance; that of the model if `None`.
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
    /// The FMU has reached a communication point.
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
    /// The FMU has logged a message.
    Message(&'a Message),
    /// The FMU has logged more than could be kept.
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
    #[error("stop time: found none in the FMU, expected one: give a stop time")]
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
        "step: found {step} s for a duration of {duration} s, expected a whole part of it, since the FMU needs steps \
         of one length: give another step or stop time"
    )]
    Uneven {
        /// Step \[s\].
        step: f64,
        /// Duration \[s\].
        duration: f64,
    },
    /// A call failed after the FMU was instantiated.
    #[error("at time {time} s: {source}")]
    Call {
        /// The last communication point reached \[s\].
        time: f64,
        /// What failed.
        source: Box<ImportError>,
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
        "at time {time} s: fmi2DoStep: found a discarded step of {step} s, expected it done: {mend}"
    )]
    Discarded {
        /// Where the last attempt began \[s\].
        time: f64,
        /// How far it should have come \[s\].
        step: f64,
        /// What to do.
        mend: &'static str,
        /// What was recorded so far.
        table: Box<Table>,
    },
}

impl SimulateError {
    /// What was recorded before the error.
    pub fn table(&self) -> Option<&Table> {
        match self {
            Self::Call { table, .. } | Self::Nan { table, .. } | Self::Discarded { table, .. } => {
                Some(table)
            }
            _ => None,
        }
    }
}

/// Simulates `fmu` once. `observe` hears every [`Event`] and can end the simulation by breaking.
///
/// A discarded step is taken up again where the FMU says it came to, or with half the length if it came nowhere; if
/// the FMU cannot take such steps, or does not get on, that is an error.
///
/// # Errors
///
/// Every variant of [`SimulateError`]; those that happen after the start carry what was recorded.
pub fn simulate(
    fmu: &Fmu,
    options: &Options,
    mut observe: impl FnMut(Event<'_>) -> ControlFlow<()>,
) -> Result<Table, SimulateError> {
    let description = fmu.description();
    let grid = Grid::new(fmu, options)?;
    let mut table = Table::for_outputs(description, options.outputs.as_deref())?;
    let mut start_values = Vec::new();
    for (name, text) in &options.set {
        let variable = find(description, name)?;
        check_settable_at_start(variable)?;
        start_values.push((
            variable.value_reference,
            parse(description, variable, text)?,
        ));
    }
    let name = options.instance_name.as_deref();
    let name = name.unwrap_or(&description.model_name);
    let instance = fmu.instantiate(name, options.logging).map_err(Box::new)?;

    let mut run = Run {
        fmu,
        options,
        grid,
        instance,
        table: &mut table,
    };
    let result = run.drive(&start_values, &mut observe);
    // What it logged last belongs to the failure.
    let _ended = forward(&run.instance, &mut observe);
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
    Err(match halt {
        Halt::Call(source) => SimulateError::Call {
            time,
            source,
            table,
        },
        Halt::Nan(variable) => SimulateError::Nan {
            time,
            variable,
            table,
        },
        Halt::Discarded { time, step, mend } => SimulateError::Discarded {
            time,
            step,
            mend,
            table,
        },
    })
}

/// The communication points.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Grid {
    start: f64,
    stop: f64,
    step: f64,
    /// Number of steps.
    count: u64,
    /// All steps have the same length.
    even: bool,
}

impl Grid {
    fn new(fmu: &Fmu, options: &Options) -> Result<Self, SimulateError> {
        let default = fmu.description().default_experiment.unwrap_or_default();
        let start = options.start.or(default.start_time).unwrap_or(0.0);
        let stop = options.stop.or(default.stop_time);
        let stop = stop.ok_or(SimulateError::NoStop)?;
        let duration = stop - start;
        let step = options.step.or(default.step_size);
        let step = step.unwrap_or(if duration > 0.0 {
            duration / DEFAULT_STEPS
        } else {
            1.0
        });
        let ratio = duration / step;
        if !(ratio.is_finite() && step > 0.0 && duration >= 0.0 && ratio <= MAX_STEPS) {
            return Err(SimulateError::Times { start, stop, step });
        }
        let even = (ratio - ratio.round()).abs() <= STEP_TOLERANCE * ratio.max(1.0);
        if !even
            && !fmu
                .co_simulation()
                .can_handle_variable_communication_step_size
        {
            return Err(SimulateError::Uneven { step, duration });
        }
        let count = if even { ratio.round() } else { ratio.ceil() } as u64;
        Ok(Self {
            start,
            stop,
            step,
            count,
            even,
        })
    }

    /// The point after `k` steps \[s\].
    fn time(&self, k: u64) -> f64 {
        if k == self.count {
            return self.stop;
        }
        self.start + k as f64 * self.step
    }

    /// Length of the step after point `k` \[s\].
    fn length(&self, k: u64) -> f64 {
        if self.even || k + 1 < self.count {
            return self.step;
        }
        self.stop - self.time(k)
    }
}

/// Why a run does not go on.
enum Halt {
    Call(Box<ImportError>),
    Nan(String),
    Discarded {
        time: f64,
        step: f64,
        mend: &'static str,
    },
}

impl From<ImportError> for Halt {
    fn from(error: ImportError) -> Self {
        Self::Call(Box::new(error))
    }
}

struct Run<'a> {
    fmu: &'a Fmu,
    options: &'a Options,
    grid: Grid,
    instance: Instance,
    table: &'a mut Table,
}

impl Run<'_> {
    fn drive(
        &mut self,
        start_values: &[(u32, Value)],
        observe: &mut impl FnMut(Event<'_>) -> ControlFlow<()>,
    ) -> Result<End, Halt> {
        let grid = self.grid;
        let default = self.fmu.description().default_experiment;
        let tolerance = self.options.tolerance;
        let tolerance = tolerance.or(default.and_then(|default| default.tolerance));
        self.instance
            .setup_experiment(tolerance, grid.start, Some(grid.stop))?;
        set(&mut self.instance, start_values)?;
        self.instance.enter_initialization_mode()?;
        self.apply_inputs(grid.start)?;
        self.instance.exit_initialization_mode()?;
        self.record(grid.start)?;

        let mut end = End::Stop;
        for k in 0..=grid.count {
            let event = Event::Time {
                time: grid.time(k),
                step: k,
                steps: grid.count,
                table: self.table,
            };
            if forward(&self.instance, observe).is_break() || observe(event).is_break() {
                end = End::Interrupted;
                break;
            }
            if k == grid.count {
                break;
            }
            self.apply_inputs(grid.time(k))?;
            if let Some(time) = self.step(k)? {
                // The values at the time that the FMU came to are the last it has.
                if time > grid.time(k) {
                    self.record(time)?;
                }
                end = End::Terminated;
                break;
            }
            self.record(grid.time(k + 1))?;
        }
        self.instance.terminate()?;
        Ok(end)
    }

    fn apply_inputs(&mut self, time: f64) -> Result<(), Halt> {
        if let Some(inputs) = &self.options.inputs {
            set(&mut self.instance, &inputs.at(time))?;
        }
        Ok(())
    }

    fn record(&mut self, time: f64) -> Result<(), Halt> {
        self.table.record(time, &mut self.instance)?;
        match self.table.nan_in_last_row() {
            Some(variable) if !self.options.allow_nan => Err(Halt::Nan(variable.to_owned())),
            _ => Ok(()),
        }
    }

    /// From point `k` to the next. The time that the FMU came to, if it wants to end before.
    fn step(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        let variable = self
            .fmu
            .co_simulation()
            .can_handle_variable_communication_step_size;
        let target = self.grid.time(k + 1);
        let mut time = self.grid.time(k);
        let mut length = self.grid.length(k);
        let mut whole = true;
        for _ in 0..MAX_ATTEMPTS {
            let halt = |mend| Halt::Discarded {
                time,
                step: length,
                mend,
            };
            match self.instance.do_step(time, length, true)? {
                Step::Done if whole => return Ok(None),
                Step::Done => {
                    time += length;
                    length = target - time;
                }
                Step::Discarded {
                    last_successful_time,
                    terminated,
                } => {
                    let reached = last_successful_time.unwrap_or(time);
                    if terminated {
                        return Ok(Some(reached));
                    }
                    if !variable {
                        return Err(halt(
                            "the FMU needs steps of one length: give a shorter one",
                        ));
                    }
                    if reached > time && reached < target {
                        time = reached;
                        length = target - time;
                    } else {
                        length /= 2.0;
                    }
                }
            }
            // A sum of parts may miss the target by rounding.
            if length <= STEP_TOLERANCE * self.grid.step {
                return Ok(None);
            }
            whole = time + length >= target;
        }
        Err(Halt::Discarded {
            time,
            step: length,
            mend: "see what the FMU logged, or give a shorter step",
        })
    }
}

/// Hands the messages of the instance on.
fn forward(
    instance: &Instance,
    observe: &mut impl FnMut(Event<'_>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let (messages, lost) = instance.take_messages();
    for message in &messages {
        observe(Event::Message(message))?;
    }
    if lost > 0 {
        observe(Event::MessagesLost(lost))?;
    }
    ControlFlow::Continue(())
}
