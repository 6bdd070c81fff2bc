//! The instances of a system between communication points: steps, and states to go back to.

use crate::calls::{Participant, SavedState, Step};
use crate::error::ImportError;
use crate::system::System;

use super::communication_points::{CommunicationPoints, STEP_TOLERANCE};
use super::exchange::Exchange;
use super::halt::Halt;

/// Most attempts to come from one communication point to the next with an FMU that discards.
const MAX_ATTEMPTS: u32 = 12;

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
        let mut fmus = self.system.fmus();
        let (Some(fmu), Some(instance)) = (fmus.nth(component), self.instances.get_mut(component))
        else {
            return Ok(None);
        };
        let variable = fmu.description().takes_any_step();
        let target = self.points.time(k + 1);
        let mut time = self.points.time(k);
        let mut length = self.points.length(k);
        let mut whole = true;
        let discarded = |time, step, mend| Halt::Discarded {
            component,
            time,
            step,
            mend,
        };
        for _ in 0..MAX_ATTEMPTS {
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
                        let least = STEP_TOLERANCE * self.points.step;
                        last.filter(|&last| last - time > least && last < target)
                    }
                    false => return Err(discarded(time, length, ONE_LENGTH)),
                },
            };
            match reached {
                Some(reached) => (time, length) = (reached, target - reached),
                None => length /= 2.0,
            }
            // A sum of parts may miss the target by rounding.
            if length <= STEP_TOLERANCE * self.points.step {
                return Ok(None);
            }
            whole = time + length >= target;
        }
        Err(discarded(time, length, NO_PROGRESS))
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
