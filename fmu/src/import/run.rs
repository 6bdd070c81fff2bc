//! One run of the master, call by call.

use std::ops::ControlFlow;

use super::exchange::{Broken, Exchange, Load};
use super::grid::{Grid, STEP_TOLERANCE};
use super::iterate::Memory;
use super::participant::Participant;
use super::simulate::{Coupling, Event, Options};
use super::system::System;
use super::{End, ImportError, Step, Table};

/// Most attempts to come from one communication point to the next with an FMU that discards.
const MAX_ATTEMPTS: u32 = 12;

/// Why a run does not go on.
pub(super) enum Halt {
    /// A call of this component failed.
    Call(usize, Box<ImportError>),
    Nan(String),
    /// The exchanged values did not agree: the one that changed most, and by which part.
    Apart {
        variable: Option<String>,
        change: f64,
    },
    Discarded {
        component: usize,
        time: f64,
        step: f64,
        mend: &'static str,
    },
}

impl From<Broken> for Halt {
    fn from(broken: Broken) -> Self {
        match broken {
            Broken::Call(component, error) => Self::Call(component, error),
            Broken::Nan(variable) => Self::Nan(variable),
        }
    }
}

pub(super) struct Run<'a> {
    pub(super) system: &'a System<'a>,
    pub(super) options: &'a Options,
    pub(super) grid: Grid,
    pub(super) exchange: Exchange,
    pub(super) instances: Vec<Box<dyn Participant>>,
    pub(super) table: &'a mut Table,
    pub(super) memory: Memory,
}

impl Run<'_> {
    /// From the first call to the last.
    pub(super) fn drive(
        &mut self,
        start_values: &[Load],
        observe: &mut impl FnMut(Event<'_>) -> ControlFlow<()>,
    ) -> Result<End, Halt> {
        let grid = self.grid;
        self.initialize(start_values)?;
        self.record(grid.start)?;

        let mut end = End::Stop;
        for k in 0..=grid.count {
            let event = Event::Time {
                time: grid.time(k),
                step: k,
                steps: grid.count,
                table: self.table,
            };
            if forward(&self.instances, observe).is_break() || observe(event).is_break() {
                end = End::Interrupted;
                break;
            }
            if k == grid.count {
                break;
            }
            if let Some(time) = self.advance(k)? {
                // One FMU alone has last values at the time that it came to; of several each is at another time.
                if self.instances.len() == 1 && time > grid.time(k) {
                    self.record(time)?;
                }
                end = End::Terminated;
                break;
            }
            self.record(grid.time(k + 1))?;
        }
        self.each(|_, instance| instance.finish())?;
        Ok(end)
    }

    fn initialize(&mut self, start_values: &[Load]) -> Result<(), Halt> {
        let (start, stop) = (self.grid.start, self.grid.stop);
        let fmus: Vec<_> = self.system.fmus().collect();
        let given = self.options.tolerance;
        let none = Load::new();
        self.each(|k, instance| {
            let default = fmus
                .get(k)
                .and_then(|fmu| fmu.description().experiment().tolerance);
            let values = start_values.get(k).unwrap_or(&none);
            instance.set_up(given.or(default), start, stop, values)
        })?;
        self.each(|_, instance| instance.enter_initialization())?;
        self.apply_inputs(start)?;
        self.exchange.settle(&mut self.instances)?;
        self.each(|_, instance| instance.exit_initialization())
    }

    /// From point `k` to the next. The time that an FMU came to, if it wants to end before.
    fn advance(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        self.apply_inputs(self.grid.time(k))?;
        if self.options.coupling == Coupling::Iterated {
            return self.iterate(k);
        }
        let components = 0..self.instances.len();
        if self.options.coupling == Coupling::Jacobi {
            // All are read before the first is written: an input may show through to an output at once.
            let loads: Vec<Load> = components
                .clone()
                .map(|target| self.exchange.read(target, &mut self.instances))
                .collect::<Result<_, _>>()?;
            for (target, load) in loads.iter().enumerate() {
                Exchange::write(target, load, &mut self.instances)?;
            }
        }
        for component in components {
            if self.options.coupling == Coupling::GaussSeidel {
                let load = self.exchange.read(component, &mut self.instances)?;
                Exchange::write(component, &load, &mut self.instances)?;
            }
            let ended = self.step(component, k, true)?;
            if ended.is_some() {
                return Ok(ended);
            }
        }
        Ok(None)
    }

    /// Calls something of every instance, in their order.
    fn each(
        &mut self,
        mut call: impl FnMut(usize, &mut dyn Participant) -> Result<(), ImportError>,
    ) -> Result<(), Halt> {
        for (k, instance) in self.instances.iter_mut().enumerate() {
            call(k, &mut **instance).map_err(Broken::at(k))?;
        }
        Ok(())
    }

    fn apply_inputs(&mut self, time: f64) -> Result<(), Halt> {
        let Some(inputs) = &self.options.inputs else {
            return Ok(());
        };
        self.each(|k, instance| instance.set(&inputs.at(time, k)))
    }

    fn record(&mut self, time: f64) -> Result<(), Halt> {
        self.table.record(time, &mut self.instances)?;
        match self.table.nan_in_last_row() {
            Some(variable) if !self.options.allow_nan => Err(Halt::Nan(variable.to_owned())),
            _ => Ok(()),
        }
    }

    /// One component from point `k` to the next. The time that it came to, if it wants to end before.
    pub(super) fn step(
        &mut self,
        component: usize,
        k: u64,
        no_rollback: bool,
    ) -> Result<Option<f64>, Halt> {
        let mut fmus = self.system.fmus();
        let (Some(fmu), Some(instance)) = (fmus.nth(component), self.instances.get_mut(component))
        else {
            return Ok(None);
        };
        let variable = fmu.description().takes_any_step();
        let target = self.grid.time(k + 1);
        let mut time = self.grid.time(k);
        let mut length = self.grid.length(k);
        let mut whole = true;
        for _ in 0..MAX_ATTEMPTS {
            let halt = |mend| Halt::Discarded {
                component,
                time,
                step: length,
                mend,
            };
            let step = instance
                .step(time, length, no_rollback)
                .map_err(Broken::at(component))?;
            match step {
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
            component,
            time,
            step: length,
            mend: "see what the FMU logged, or give a shorter step",
        })
    }
}

/// Hands the messages of the instances on.
pub(super) fn forward(
    instances: &[Box<dyn Participant>],
    observe: &mut impl FnMut(Event<'_>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    for instance in instances {
        let (messages, lost) = instance.messages();
        for message in &messages {
            observe(Event::Message(message))?;
        }
        if lost > 0 {
            observe(Event::MessagesLost(lost))?;
        }
    }
    ControlFlow::Continue(())
}
