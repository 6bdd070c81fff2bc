//! Calls of other people's libraries, of FMI 2.0 and 3.0: the one room with unsafe code.

mod fmi2;
mod fmi3;
mod instance;
mod library;
mod logger;
mod participant;
mod state;
mod watch;

pub use fmi2::Instance2;
pub use participant::Step;
pub use state::SavedState;
pub use watch::Message;

pub(crate) use fmi2::Functions as Fmi2;
pub(crate) use fmi3::{Arrays, Functions as Fmi3};
pub(crate) use instance::{Instance, TAIL};
pub(crate) use library::Library;
pub(crate) use logger::Log;
pub(crate) use participant::{InputValues, Participant};
pub(crate) use watch::{CallEvent, Watch};
