//! The instances of a system between communication points: steps, and states to go back to.

use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;

use crate::calls::{Participant, SavedState, Step};
use crate::error::ImportError;
use crate::system::System;

use super::communication_points::{CommunicationPoints, STEP_TOLERANCE};
use super::exchange::Exchange;
use super::halt::Halt;

/// Most attempts in a row of an FMU that discards without coming on: by less than a step halved so often.
const MAX_ATTEMPTS: i32 = 12;

/// Most components that step at the same time; others follow as soon as one is done.
const MAX_THREADS: usize = 64;

const ONE_LENGTH: &str = "the FMU needs steps of one length: give a shorter one";
const NO_PROGRESS: &str = "see what the FMU logged, or give a shorter step";

/// The instances, what connects them, and when they meet.
pub(super) struct Components<'a> {
    pub(super) system: &'a System<'a>,
    pub(super) points: CommunicationPoints,
    pub(super) exchange: Exchange,
    pub(super) instances: Vec<Box<dyn Participant>>,
}

impl Components<'_> {
    /// Calls something of every instance, in their order.
    pub(super) fn each(
        &mut self,
        mut call: impl FnMut(usize, &mut dyn Participant) -> Result<(), ImportError>,
    ) -> Result<(), Halt> {
        for (k, instance) in self.instances.iter_mut().enumerate() {
            call(k, &mut **instance).map_err(Halt::at(k))?;
        }
        Ok(())
    }

    /// One component from point `k` to the next. The time that it came to, if it wants to end before.
    pub(super) fn step(
        &mut self,
        component: usize,
        k: u64,
        no_rollback: bool,
    ) -> Result<Option<f64>, Halt> {
        let Some(instance) = self.instances.get_mut(component) else {
            return Ok(None);
        };
        let (system, points) = (self.system, &self.points);
        step(system, points, component, &mut **instance, k, no_rollback)
    }

    /// All components from point `k` to the next at the same time, on threads that live as long as the step. The error of
    /// the first that fails, else the time that the first came to that wants to end before.
    pub(super) fn step_at_once(&mut self, k: u64) -> Result<Option<f64>, Halt> {
        let (system, points) = (self.system, &self.points);
        let count = self.instances.len();
        let waiting = Mutex::new(self.instances.iter_mut().enumerate());
        let work = || {
            let mut done = Vec::new();
            loop {
                let mut next = waiting.lock().unwrap_or_else(PoisonError::into_inner);
                let Some((component, instance)) = next.next() else {
                    return done;
                };
                drop(next);
                let ended = step(system, points, component, &mut **instance, k, true);
                done.push((component, ended));
            }
        };
        let mut results = thread::scope(|scope| {
            // With as many threads as the system gives: those that are there do the work.
            let start = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
            let threads: Vec<_> = (1..count.min(MAX_THREADS)).map_while(start).collect();
            let mut results = work();
            for thread in threads {
                let done = thread.join();
                results.extend(done.unwrap_or_else(|panic| resume_unwind(panic)));
            }
            results
        });
        results.sort_by_key(|(component, _)| *component);
        let ended = results.into_iter().map(|(_, ended)| ended);
        let ended = ended.collect::<Result<Vec<_>, _>>()?;
        Ok(ended.into_iter().flatten().next())
    }

    /// The states of all, in their order.
    pub(super) fn save(&mut self) -> Result<Vec<SavedState>, Halt> {
        let mut states = Vec::new();
        self.each(|_, instance| {
            states.push(instance.save()?);
            Ok(())
        })?;
        Ok(states)
    }

    /// Back to the states of [`save`](Self::save); nothing if there are none.
    pub(super) fn restore(&mut self, states: &[SavedState]) -> Result<(), Halt> {
        let pairs = self.instances.iter_mut().zip(states).enumerate();
        for (k, (instance, state)) in pairs {
            instance.restore(state).map_err(Halt::at(k))?;
        }
        Ok(())
    }

    /// Frees the states of [`save`](Self::save).
    pub(super) fn release(&mut self, states: Vec<SavedState>) -> Result<(), Halt> {
        let pairs = self.instances.iter_mut().zip(states).enumerate();
        for (k, (instance, state)) in pairs {
            instance.free(state).map_err(Halt::at(k))?;
        }
        Ok(())
    }
}

/// One component from point `k` to the next. The time that it came to, if it wants to end before.
fn step(
    system: &System<'_>,
    points: &CommunicationPoints,
    component: usize,
    instance: &mut dyn Participant,
    k: u64,
    no_rollback: bool,
) -> Result<Option<f64>, Halt> {
    let Some(fmu) = system.fmus().nth(component) else {
        return Ok(None);
    };
    let variable = fmu.description().takes_any_step();
    let target = points.time(k + 1);
    let mut time = points.time(k);
    let mut length = points.length(k);
    let mut whole = true;
    let discarded = |time, step, mend| Halt::Discarded {
        component,
        time,
        step,
        mend,
    };
    let progress = length * 0.5_f64.powi(MAX_ATTEMPTS);
    let mut attempts = 0;
    while attempts < MAX_ATTEMPTS {
        attempts += 1;
        let step = instance.step(time, length, no_rollback);
        let reached = match step.map_err(Halt::at(component))? {
            Step::Done if whole => return Ok(None),
            Step::Done => Some(time + length),
            Step::Discarded {
                last_successful_time: last,
                terminated,
            } => match terminated {
                true => return Ok(Some(last.unwrap_or(time))),
                // Its clock may differ from ours by rounding: then it came nowhere.
                false if variable => {
                    let least = STEP_TOLERANCE * points.step;
                    last.filter(|&last| last - time > least && last < target)
                }
                false => return Err(discarded(time, length, ONE_LENGTH)),
            },
        };
        match reached {
            Some(reached) => {
                if reached - time >= progress {
                    attempts = 0;
                }
                (time, length) = (reached, target - reached);
            }
            None => length /= 2.0,
        }
        // A sum of parts may miss the target by rounding.
        if length <= STEP_TOLERANCE * points.step {
            return Ok(None);
        }
        whole = time + length >= target;
    }
    Err(discarded(time, length, NO_PROGRESS))
}
