//! The master: FMUs from start to stop, inputs from a table, outputs to a table, values from FMU to FMU.

use std::ops::ControlFlow;

use crate::calls::{InputValues, Participant};
use crate::fmu::Fmu;
use crate::isolate;
use crate::open::Description;
use crate::system::{System, SystemVariable, VariableError, parse_start};

use super::accelerate::QuasiNewton;
use super::communication_points::CommunicationPoints;
use super::components::Components;
use super::drive::{Run, forward};
use super::error::SimulateError;
use super::event::Event;
use super::exchange::Exchange;
use super::halt::Halt;
use super::options::{Coupling, Iteration, Options};
use super::table::Table;
use crate::value::Value;

/// Simulates the FMUs of a system once, from start to stop. `observe` hears every [`Event`] and can end the simulation
/// by breaking.
///
/// The FMUs enter initialization mode together; there inputs get their values at the start, connected ones those of
/// their outputs. Before the step from t, inputs of the table get their values at t, connected ones as
/// [`Coupling`] says; then the FMUs step: with [`Coupling::Jacobi`] at the same time, each on a thread that lives as long as
/// the step, else in their order on the thread of the caller.
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
    let points = CommunicationPoints::new(system, options)?;
    let (mut table, start_values) = match (
        Table::for_outputs(system, options.outputs.as_deref()),
        start_values(system, options),
    ) {
        (Ok(table), Ok(start_values)) => (table, start_values),
        (table, start_values) => {
            let faults = [start_values.err(), table.err()].into_iter().flatten();
            return Err(SimulateError::Variables(faults.flatten().collect()));
        }
    };
    let instances = instantiate(system, options)?;
    let exchange = Exchange::new(system, options.allow_nan);
    check_iteration(system, options, &exchange)?;
    let mut run = Run {
        options,
        components: Components {
            system,
            points,
            exchange,
            instances,
        },
        memory: QuasiNewton::default(),
        table: &mut table,
    };
    let driven = run.drive(&start_values, &mut observe);
    let result = driven.and_then(|end| run.components.each(|_, fmu| fmu.close()).map(|()| end));
    // What they logged last belongs to the failure.
    let _ended = forward(&run.components.instances, &mut observe);
    drop(run);
    match result {
        Ok(end) => Ok(Table { end, ..table }),
        Err(halt) => {
            let time = table.time.last().copied().unwrap_or(points.start);
            Err(halted(halt, system, options, time, table))
        }
    }
}

/// What each component gets before it is initialized; or all that is wrong with it.
fn start_values(
    system: &System<'_>,
    options: &Options,
) -> Result<Vec<InputValues>, Vec<VariableError>> {
    let mut start_values = vec![InputValues::new(); system.fmus().len()];
    let mut faults = Vec::new();
    for (name, text) in &options.set {
        match start_value(system, name, text) {
            Ok((variable, values)) => {
                if let Some(load) = start_values.get_mut(variable.component) {
                    load.extend(variable.places().into_iter().zip(values));
                }
            }
            Err(fault) => faults.push(fault),
        }
    }
    match faults.is_empty() {
        true => Ok(start_values),
        false => Err(faults),
    }
}

fn start_value<'f>(
    system: &System<'f>,
    name: &str,
    text: &str,
) -> Result<(SystemVariable<'f>, Vec<Value>), VariableError> {
    let variable = system.find(name)?;
    system.check_free(&variable)?;
    let values = parse_start(&variable, text)?;
    Ok((variable, values))
}

/// An instance of every component, in their order.
fn instantiate(
    system: &System<'_>,
    options: &Options,
) -> Result<Vec<Box<dyn Participant>>, SimulateError> {
    let fmus = system.fmus().enumerate();
    let instance = |(k, fmu): (usize, &Fmu)| {
        let own = options.instance_name.as_deref();
        let own = own.unwrap_or(fmu.description().model_name());
        let name = system.component_name(k).unwrap_or(own);
        match &options.isolation {
            Some(isolation) => isolate::participant(isolation, fmu, name, options.logging),
            None => fmu.participant(name, options.logging),
        }
        .map_err(|source| SimulateError::Import {
            component: system.component_name(k).map(str::to_owned),
            source: Box::new(source),
        })
    };
    fmus.map(instance).collect()
}

/// Why there is no more than `table`, which ends at `time`, in the words of the caller.
fn halted(
    halt: Halt,
    system: &System<'_>,
    options: &Options,
    time: f64,
    table: Table,
) -> SimulateError {
    let table = Box::new(table);
    let named = |component| system.component_name(component).map(str::to_owned);
    match halt {
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
        Halt::NotConverged { variable, change } => SimulateError::NotConverged {
            time,
            variable,
            change,
            max_iterations: options.iteration.max_iterations,
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
            function: match system.fmus().nth(component).map(Fmu::description) {
                Some(Description::Three(_)) => "fmi3DoStep",
                _ => "fmi2DoStep",
            },
            step,
            mend,
            table,
        },
    }
}

/// Whether the numbers make sense, and all steps can be repeated.
fn check_iteration(
    system: &System<'_>,
    options: &Options,
    exchange: &Exchange,
) -> Result<(), SimulateError> {
    let Iteration {
        tolerance,
        max_iterations,
        relaxation,
        ..
    } = options.iteration;
    let sound = tolerance.is_finite() && tolerance > 0.0 && max_iterations > 0;
    if !(sound && relaxation > 0.0 && relaxation <= 1.0) {
        return Err(SimulateError::Iteration {
            tolerance,
            max_iterations,
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
