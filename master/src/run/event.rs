//! What a caller hears of a simulation while it runs.

use crate::calls::Message;

use super::table::Table;

/// What happens during a simulation.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Event<'a> {
    /// The FMUs have reached a communication point.
    Time {
        /// The point \[s\].
        time: f64,
        /// Number of the step that led to it; 0 at the start.
        step: u64,
        /// Number of all steps.
        steps: u64,
        /// What has been recorded, this point included.
        table: &'a Table,
    },
    /// An FMU has logged a message.
    Message(&'a Message),
    /// An FMU has logged more than could be kept.
    MessagesLost(usize),
}
