//! FMI 2.0: the table of functions, the calls for life, steps and values, and an instance as a participant.

mod abi;
mod life;
mod participant;
mod values;

pub(crate) use abi::Functions;

/// An instance of an FMU of FMI 2.0.
pub type Instance2 = super::instance::Instance<Functions>;
