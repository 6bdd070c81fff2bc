//! One run of the master, from the first call to the last.

use std::ops::ControlFlow;

use crate::calls::{InputValues, Participant};

use super::accelerate::QuasiNewton;
use super::components::Components;
use super::event::Event;
use super::exchange::Exchange;
use super::halt::Halt;
use super::iterate::{Outcome, iterate};
use super::options::{Coupling, Options};
use super::table::{End, NotConverged, Table};

/// A run, and what it records.
pub(super) struct Run<'a> {
    pub(super) options: &'a Options,
    pub(super) components: Components<'a>,
    pub(super) memory: QuasiNewton,
    pub(super) table: &'a mut Table,
}

impl Run<'_> {
    /// From the first call to the last.
    pub(super) fn drive(
        &mut self,
        start_values: &[InputValues],
        observe: &mut impl FnMut(Event<'_>) -> ControlFlow<()>,
    ) -> Result<End, Halt> {
        let points = self.components.points;
        self.initialize(start_values)?;
        self.record(points.start)?;

        let mut end = End::Stop;
        for k in 0..=points.count {
            let event = Event::Time {
                time: points.time(k),
                step: k,
                steps: points.count,
                table: self.table,
            };
            if forward(&self.components.instances, observe).is_break() || observe(event).is_break()
            {
                end = End::Interrupted;
                break;
            }
            if k == points.count {
                break;
            }
            if let Some(time) = self.advance(k)? {
                // One FMU alone has last values at the time that it came to; of several each is at another time.
                if self.components.instances.len() == 1 && time > points.time(k) {
                    self.record(time)?;
                }
                end = End::Terminated;
                break;
            }
            self.record(points.time(k + 1))?;
        }
        self.components.each(|_, instance| instance.finish())?;
        Ok(end)
    }

    fn initialize(&mut self, start_values: &[InputValues]) -> Result<(), Halt> {
        let (start, stop) = (self.components.points.start, self.components.points.stop);
        let fmus: Vec<_> = self.components.system.fmus().collect();
        let given = self.options.tolerance;
        let none = InputValues::new();
        self.components.each(|k, instance| {
            let default = fmus
                .get(k)
                .and_then(|fmu| fmu.description().experiment().tolerance);
            let values = start_values.get(k).unwrap_or(&none);
            instance.set_up(given.or(default), start, stop, values)
        })?;
        self.components
            .each(|_, instance| instance.enter_initialization())?;
        self.apply_inputs(start)?;
        self.components
            .exchange
            .settle(&mut self.components.instances)?;
        self.components
            .each(|_, instance| instance.exit_initialization())
    }

    /// From point `k` to the next. The time that an FMU came to, if it wants to end before.
    fn advance(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        self.apply_inputs(self.components.points.time(k))?;
        if self.options.coupling == Coupling::Iterated {
            return self.iterated(k);
        }
        let components = 0..self.components.instances.len();
        if self.options.coupling == Coupling::Jacobi {
            // All are read before the first is written: an input may show through to an output at once.
            let loads: Vec<InputValues> = components
                .clone()
                .map(|target| {
                    self.components
                        .exchange
                        .read(target, &mut self.components.instances)
                })
                .collect::<Result<_, _>>()?;
            for (target, load) in loads.iter().enumerate() {
                Exchange::write(target, load, &mut self.components.instances)?;
            }
            if !self.options.sequential {
                return self.components.step_at_once(k);
            }
        }
        for component in components {
            if self.options.coupling == Coupling::GaussSeidel {
                let load = self
                    .components
                    .exchange
                    .read(component, &mut self.components.instances)?;
                Exchange::write(component, &load, &mut self.components.instances)?;
            }
            let ended = self.components.step(component, k, true)?;
            if ended.is_some() {
                return Ok(ended);
            }
        }
        Ok(None)
    }

    fn apply_inputs(&mut self, time: f64) -> Result<(), Halt> {
        let Some(inputs) = &self.options.inputs else {
            return Ok(());
        };
        self.components
            .each(|k, instance| instance.set(&inputs.at(time, k)))
    }

    fn record(&mut self, time: f64) -> Result<(), Halt> {
        if self.options.keep_last {
            self.table.forget();
        }
        self.table.record(time, &mut self.components.instances)?;
        match self.table.nan_in_last_row() {
            Some(variable) if !self.options.allow_nan => Err(Halt::Nan(variable.to_owned())),
            _ => Ok(()),
        }
    }

    /// As [`advance`](Self::advance), in as many iterations as it takes.
    fn iterated(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        let settings = self.options.iteration;
        match iterate(&mut self.components, settings, &mut self.memory, k)? {
            Outcome::Ended(time) => Ok(Some(time)),
            Outcome::Done {
                iterations,
                left,
                ended,
            } => {
                self.table.iterations.push(iterations);
                self.table
                    .not_converged
                    .extend(left.map(|change| NotConverged {
                        time: self.components.points.time(k),
                        change,
                    }));
                Ok(ended)
            }
        }
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
