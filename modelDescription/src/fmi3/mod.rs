//! The model description of FMI 3.0, for co-simulation.
//!
//! Rules are those of the standard, version 3.0.2: section 2.4. What FMI 2.0 has in the same form is shared with
//! [`crate::fmi2`]: units, log categories, the default experiment, variability and `initial`.
//!
//! Model exchange and scheduled execution are read as offered or not; what they are able to do is skipped. Type
//! definitions other than enumerations, and annotations, are skipped too.

mod description;
mod interfaces;
mod structure;
mod types;
mod validate;
mod variables;

pub use crate::fmi2::{DefaultExperiment, Initial, LogCategory, NamingConvention, Variability};
pub use description::{FMI_VERSION, ModelDescription};
pub use interfaces::{CoSimulation, OtherInterface};
pub use structure::{ModelStructure, Unknown};
pub use types::{EnumerationItem, EnumerationType};
pub use variables::{Alias, Causality, Dimension, StartValue, Variable};
