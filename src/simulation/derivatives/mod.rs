//! Derivatives of what is measured, at the end of a communication step: by time ([`Simulation::time_derivatives`]) and by the commands
//! held over that step ([`Simulation::directional_derivatives`]); at the start of a run by the commands that place its boundaries.
//!
//! A step costs nothing for them: it only leaves its start behind, [`Origin`], and is taken again when a derivative is asked
//! for. Steps are deterministic, so this is the same step, bit for bit. Within a step there are no
//! derivatives.

mod drift;
mod replay;
mod sensitivity;

pub use sensitivity::Direction;

use super::Simulation;
use crate::error::{SnapshotError, StepError};
use crate::simulation::Origin;

impl Simulation {
    /// Where the present state came from: with [`Self::snapshot`] a state that keeps its derivatives. `None` after
    /// [`Self::restore`], within a communication step, and after one that was given up or that [`Self::advance_to`] has failed to take.
    #[must_use]
    pub fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// [`Self::origin`], which derivatives cannot do without.
    fn came_from(&self) -> Result<&Origin, StepError> {
        self.origin().ok_or_else(|| StepError::Argument {
            what: "derivatives",
            found: "a state that was restored, or that no whole step has led to".to_owned(),
            expected: "a communication step before them",
        })
    }

    /// [`Self::restore`], with the [`Self::origin`] that the state had.
    ///
    /// # Errors
    /// As [`Self::restore`].
    pub fn resume(&mut self, blob: &[u8], origin: Option<Origin>) -> Result<(), SnapshotError> {
        if let Some(origin) = &origin {
            self.check_counts(origin.state())?;
            if !origin.fits(self.scene.boundaries.len()) {
                return Err(SnapshotError::Format(
                    "its last step has another number of boundaries than the scene",
                ));
            }
        }
        self.restore(blob)?;
        self.origin = origin.map(Box::new);
        Ok(())
    }
}
