//! What the master needs of an instance, whichever version of the standard it speaks.

use super::exchange::Load;
use super::quantity::Place;
use super::values::Value;
use super::{ImportError, Message, SavedState, Step};

/// An instance in a simulation.
pub(super) trait Participant {
    /// Start and stop \[s\] and tolerance; then start values, all in one call for each type.
    fn set_up(
        &mut self,
        tolerance: Option<f64>,
        start: f64,
        stop: f64,
        values: &Load,
    ) -> Result<(), ImportError>;

    fn enter_initialization(&mut self) -> Result<(), ImportError>;

    fn exit_initialization(&mut self) -> Result<(), ImportError>;

    /// The values in these places, in this order, with one call for each type.
    fn get(&mut self, places: &[Place]) -> Result<Vec<Value>, ImportError>;

    /// Sets values of any types, with one call for each type.
    fn set(&mut self, values: &Load) -> Result<(), ImportError>;

    /// From `time` by `step` \[s\]; `no_rollback` tells that no state saved before will be restored.
    fn step(&mut self, time: f64, step: f64, no_rollback: bool) -> Result<Step, ImportError>;

    fn save(&mut self) -> Result<SavedState, ImportError>;

    fn restore(&mut self, state: &SavedState) -> Result<(), ImportError>;

    fn free(&mut self, state: SavedState) -> Result<(), ImportError>;

    fn finish(&mut self) -> Result<(), ImportError>;

    /// Messages since the last call, and how many more there were than could be kept.
    fn messages(&self) -> (Vec<Message>, usize);
}
