//! The files of SSP 1.0 and 2.0: which FMUs run together, what feeds what, and with which parameters.
//!
//! Written with the prefixes `ssd`, `ssc` and `ssv`, which some readers take for part of the names; read with any.
//! Units, enumerations and connectors are written for other masters and not read: the FMUs tell them.

mod annotations;
mod document;
mod parameters;
mod structure;

pub(super) use parameters::{Content, Parameter, ParameterSet, Text};
pub(super) use structure::{
    Component, Connection, Connector, Element, Enumeration, Experiment, Item, ParameterBinding,
    Signal, Structure, System,
};
