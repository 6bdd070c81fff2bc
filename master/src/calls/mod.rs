//! Calls of other people's libraries, of FMI 2.0 and 3.0: the one room with unsafe code.

mod fmi2;
mod fmi3;
mod instance;
mod library;
mod logger;
mod participant;
mod state;

pub use fmi2::Instance2;
pub use logger::Message;
pub use participant::Step;
pub use state::SavedState;

pub(crate) use fmi2::Functions as Fmi2;
pub(crate) use fmi3::{Arrays, Functions as Fmi3};
pub(crate) use instance::Instance;
pub(crate) use library::Library;
pub(crate) use participant::{InputValues, Participant};
