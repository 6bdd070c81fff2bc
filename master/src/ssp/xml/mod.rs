//! The files of SSP 1.0: which FMUs run together, what feeds what, and with which parameters.
//!
//! Written with the prefixes `ssd`, `ssc` and `ssv`, which some readers take for part of the names; read with any.

pub(super) mod read;
pub(super) mod write;

mod names;
