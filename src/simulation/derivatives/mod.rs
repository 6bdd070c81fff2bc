//! Derivatives of what is measured, at the end of a communication step: by time ([`Simulation::rates`]) and by the commands
//! held over that step (`sensitivity`).
//!
//! A step costs nothing for them: it only leaves its start behind, [`Origin`], and is taken again when a derivative is asked
//! for. Steps are deterministic, so this is the same step, bit for bit.

mod drift;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Simulation;
use super::march::{Account, Before, Course};
use crate::error::{SnapshotError, StepError};
use crate::state::State;
use crate::step::{Scratch, step};

/// Where the last communication step came from: everything to take it again. Where commands changed within the step, the
/// internal step at which they last did.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    pub(super) state: State,
    /// Start of the communication step \[s\].
    pub(super) start: f64,
    pub(super) course: Course,
    /// What had been summed up before `state`.
    pub(super) before: Account,
    /// Ends of the internal steps from `state` on \[s\].
    pub(super) taken: Vec<f64>,
}

impl Simulation {
    /// Where the last communication step came from: with [`Self::snapshot`] a state that keeps its derivatives. `None` before
    /// the first step.
    #[must_use]
    pub fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// [`Self::restore`], with the [`Self::origin`] that the state had.
    ///
    /// # Errors
    /// As [`Self::restore`].
    pub fn resume(&mut self, blob: &[u8], origin: Option<Origin>) -> Result<(), SnapshotError> {
        if let Some(origin) = &origin {
            self.check_counts(&origin.state)?;
            let boundaries = self.scene.boundaries.len();
            if !origin.course.fits(boundaries) || !origin.before.fits(boundaries) {
                return Err(SnapshotError::Format(
                    "its last step has another number of boundaries than the scene",
                ));
            }
        }
        self.restore(blob)?;
        self.origin = origin.map(Box::new);
        Ok(())
    }

    /// A simulation of the same scene in another state.
    fn at(&self, state: State) -> Self {
        Self {
            scene: Arc::clone(&self.scene),
            state,
            scratch: Scratch::default(),
            origin: None,
        }
    }

    /// Takes the step of `origin` again; `see` is called after every internal step, with the state before it.
    fn replay(
        &self,
        origin: &Origin,
        mut see: impl FnMut(&State, &Self),
    ) -> Result<Self, StepError> {
        let scene = &self.scene;
        let mut again = self.at(origin.state.clone());
        let drive = origin.course.drive(scene);
        let mut account = origin.before.clone();
        for &target in &origin.taken {
            let earlier = again.state.clone();
            let (before, start) = (Before::of(&earlier), earlier.time);
            let dt = target - start;
            let integrator = scene.settings.integrator;
            if let Some(commands) = drive.commands(integrator, start, dt) {
                again.state.commands = commands;
            }
            let Simulation { state, scratch, .. } = &mut again;
            step(scene, state, scratch, dt, drive.poses(target))
                .map_err(|failure| self.explain(failure, dt, 0))?;
            again.state.time = target;
            again.book(&before, dt, &mut account);
            again.exchange();
            again.state.commands.clone_from(&origin.course.commands);
            see(&earlier, &again);
        }
        again.average(origin.start, &account);
        Ok(again)
    }
}
