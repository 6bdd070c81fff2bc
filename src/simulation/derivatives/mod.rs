//! Derivatives of what is measured, at the end of a communication step: by time ([`Simulation::time_derivatives`]) and by the commands
//! held over that step ([`Simulation::directional_derivatives`]); at the start of a run by the commands that place its boundaries.
//!
//! A step costs nothing for them: it only leaves its start behind, [`ReplayRecord`], and is taken again when a derivative is asked
//! for. Steps are deterministic, so this is the same step, bit for bit. Within a step there are no
//! derivatives.

mod backward_difference;
mod replay;
mod sensitivity;

pub use sensitivity::Direction;

use std::sync::Arc;

use super::Simulation;
use crate::error::{SnapshotError, StepError};
use crate::simulation::ReplayRecord;

impl Simulation {
    /// Where the present state came from: with [`Self::snapshot`] a state that keeps its derivatives. `None` after
    /// [`Self::restore`], within a communication step, and after one that was given up or that [`Self::advance_to`] has failed to take.
    #[must_use]
    pub fn replay_record(&self) -> Option<&ReplayRecord> {
        self.replay.as_deref()
    }

    /// [`Self::replay_record`], which derivatives cannot do without.
    fn came_from(&self) -> Result<&ReplayRecord, StepError> {
        self.replay_record().ok_or_else(|| StepError::Argument {
            what: "derivatives",
            found: "a state that was restored, or that no whole step has led to".to_owned(),
            expected: "a communication step before them",
        })
    }

    /// [`Self::restore`], with the [`Self::replay_record`] that the state had.
    ///
    /// # Errors
    /// As [`Self::restore`].
    pub fn resume(
        &mut self,
        blob: &[u8],
        replay: Option<ReplayRecord>,
    ) -> Result<(), SnapshotError> {
        if let Some(replay) = &replay {
            self.check_counts(replay.state())?;
            if !replay.fits(self.scene.boundaries.len()) {
                return Err(SnapshotError::Format(
                    "its last step has another number of boundaries than the scene",
                ));
            }
        }
        self.restore(blob)?;
        self.replay = replay.map(Arc::new);
        Ok(())
    }
}
