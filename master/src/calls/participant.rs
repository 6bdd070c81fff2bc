//! What the master needs of an instance, whichever version of the standard it speaks.

use serde::{Deserialize, Serialize};

use crate::error::ImportError;
use crate::value::Value;
use crate::variable::Place;

use super::state::SavedState;
use super::watch::Message;

/// Values for the inputs of one instance.
pub(crate) type InputValues = Vec<(Place, Value)>;

/// What became of a step.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Step {
    /// The step is done.
    Done,
    /// The step is not done, or in part only.
    Discarded {
        /// Time up to which it is done \[s\]; `None` if the FMU does not tell.
        last_successful_time: Option<f64>,
        /// The FMU wants to end the simulation.
        terminated: bool,
    },
}

/// An instance in a simulation. One thread at a time calls it, not always the same.
pub(crate) trait Participant: Send {
    /// Start and stop \[s\] and tolerance; then start values, all in one call for each type.
    fn set_up(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: &InputValues,
    ) -> Result<(), ImportError>;

    fn enter_initialization(&mut self) -> Result<(), ImportError>;

    fn exit_initialization(&mut self) -> Result<(), ImportError>;

    /// The values in these places, in this order, with one call for each type.
    fn get(&mut self, places: &[Place]) -> Result<Vec<Value>, ImportError>;

    /// Sets values of any types, with one call for each type.
    fn set(&mut self, values: &InputValues) -> Result<(), ImportError>;

    /// From `time` by `step` \[s\]; `no_rollback` tells that no state saved before will be restored.
    fn step(&mut self, time: f64, step: f64, no_rollback: bool) -> Result<Step, ImportError>;

    fn save(&mut self) -> Result<SavedState, ImportError>;

    fn restore(&mut self, state: &SavedState) -> Result<(), ImportError>;

    fn free(&mut self, state: SavedState) -> Result<(), ImportError>;

    fn finish(&mut self) -> Result<(), ImportError>;

    /// Frees the instance, as dropping it does, where that can fail: nothing is called after it.
    fn close(&mut self) -> Result<(), ImportError> {
        Ok(())
    }

    /// Messages since the last call, and how many more there were than could be kept.
    fn messages(&self) -> (Vec<Message>, usize);
}
