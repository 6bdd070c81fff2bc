//! The model description of FMI 2.0.
//!
//! Sections and rules are those of the standard, version 2.0.5: the elements of
//! section 2.2, the table of causality, variability and initial of section
//! 2.2.7, the model structure of section 2.2.8.
//!
//! Attributes that the schema gives a default are written only where they differ
//! from it; `causality` and `variability` always are.

pub(crate) mod description;
mod interfaces;
mod structure;
mod types;
pub(crate) mod validate;
mod values;
mod variables;

pub use description::{
    DefaultExperiment, FMI_VERSION, LogCategory, ModelDescription, NamingConvention,
};
pub use interfaces::{CoSimulation, ModelExchange};
pub use structure::{DependencyKind, ModelStructure, Unknown};
pub use types::{
    EnumerationItem, EnumerationType, IntegerType, RealType, SimpleType, TypeDefinition,
};
pub use values::{
    BooleanVariable, EnumerationVariable, IntegerVariable, RealVariable, StringVariable,
    VariableType,
};
pub use variables::{Causality, Initial, ScalarVariable, Variability};
