//! A communication step in pieces: the importer is called between internal steps.

use sphere_dda::error::StepError;

use super::step_in_progress::StepInProgress;
use super::{Instance, Measured, Step, command};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;

/// What became of an internal step.
#[derive(Debug, Clone, PartialEq)]
pub enum Progress {
    /// It was taken; `last`: the end of the communication step is reached.
    Taken {
        /// Whether it was the last.
        last: bool,
    },
    /// The communication step is discarded; the instance stands at its beginning.
    Discarded(StepError),
}

impl Instance {
    /// Begins the step from `point` to `point + h` \[s\], which [`Self::internal_step`] takes.
    ///
    /// # Errors
    /// Those of [`Self::do_step`] that are found before the first internal step.
    pub fn begin_step(&mut self, point: f64, h: f64) -> Result<(), Refusal> {
        let end = self.check_step(point, h)?;
        let start = self.run.start;
        let commands = self.run.commands.clone();
        let rates = self.run.rates.clone();
        let forces = self.run.forces.clone();
        let communication = self.commanded()?.begin(end - start)?;
        self.step = Some(StepInProgress {
            communication,
            point,
            h,
            end,
            commands,
            rates,
            forces,
        });
        Ok(())
    }

    /// Takes the next internal step; the instance is in intermediate update mode after it.
    ///
    /// # Errors
    /// As [`Self::do_step`]: the instance stands at the beginning of the communication step.
    pub fn internal_step(&mut self) -> Result<Progress, Refusal> {
        let (Some(mut step), Some(simulation)) = (self.step.take(), &mut self.simulation) else {
            return Err(self.no_step());
        };
        self.measured = Measured::default();
        let taken = match command(simulation, &self.run) {
            Ok(()) => simulation.internal_step(&mut step.communication),
            Err(refused) => {
                simulation.put_back(&mut step.communication);
                Err(refused)
            }
        };
        match taken {
            Ok(()) => {
                let last = step.communication.is_done();
                self.run.time = if last {
                    step.end
                } else {
                    self.run.start + simulation.time()
                };
                self.run.stage = LifeCycle::Intermediate;
                self.step = Some(step);
                Ok(Progress::Taken { last })
            }
            Err(error) => {
                self.run.stage = LifeCycle::StepComplete;
                self.run.time = step.point;
                (self.run.commands, self.run.rates) = (step.commands, step.rates);
                self.run.forces = step.forces;
                match self.concluded(Err(error), step.h, step.end)? {
                    Step::Discarded(error) => Ok(Progress::Discarded(error)),
                    Step::Complete => Err(self.no_step()),
                }
            }
        }
    }

    /// Ends the step where the last internal step has ended. With `final_past` the importer promises not to go back
    /// before the beginning of the step.
    ///
    /// # Errors
    /// [`Refusal::Argument`] if no step is under way.
    pub fn end_step(&mut self, final_past: bool) -> Result<(), Refusal> {
        let Some(step) = self.step.take() else {
            return Err(self.no_step());
        };
        if let Some(simulation) = &mut self.simulation {
            simulation.end(step.communication);
        }
        self.concluded(Ok(()), step.h, self.run.time)?;
        if final_past {
            self.recorder.commit(step.point - self.run.start);
        }
        Ok(())
    }

    fn no_step(&self) -> Refusal {
        Refusal::Stage {
            found: self.run.stage,
            expected: "a step in progress".to_owned(),
        }
    }
}
