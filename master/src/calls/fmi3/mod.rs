//! FMI 3.0: the table of functions, the calls for life, steps, events and values, and an instance as a participant.

mod abi;
mod events;
mod life;
mod participant;
mod values;

pub(crate) use abi::Functions;
pub(crate) use participant::Arrays;
