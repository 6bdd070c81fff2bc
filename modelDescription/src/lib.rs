//! Model descriptions of functional mock-up units: write, read, validate.
//!
//! A functional mock-up unit tells its importer what it is in one file,
//! `modelDescription.xml`. This crate holds that file as typed data and knows
//! nothing of any solver.
//!
//! | module     | holds                                                        | serves       |
//! |------------|--------------------------------------------------------------|--------------|
//! | [`fmi2`]   | the FMI 2.0 description, its XML form and its rules           | FMI 2.0      |
//! | [`terminals`]| groups of variables and the icon, its XML form and its rules | FMI 2.0.4, 3.0 |
//! | [`fmi3`]   | the FMI 3.0 description: arrays, aliases, intermediate update | FMI 3.0      |
//! | [`references`]| files about a model, experiments to check it: drafts        | FMI-LS-REF   |
//! | [`units`]  | units as exponents of the SI base units, display units        | any version  |
//! | [`names`]  | the grammar of structured variable names, C identifiers       | any version  |
//! | [`value`]  | values and their types                                       | any version  |
//! | [`xml`], [`lexical`] | texts of any such file to typed data and back       | any version  |
//! | [`Finding`]| one broken rule: where, what was found, what was expected     | any version  |
//! | [`Error`]  | why a text could not be read or a description not be written  | any version  |
//!
//! Reading is tolerant of what the schema does not name (vendor annotations,
//! unknown elements and attributes are skipped) and strict about what it does:
//! a missing required attribute or a value of the wrong type is an [`Error`].
//! Everything that needs more than one attribute to judge is left to
//! [`fmi2::ModelDescription::validate`], which reports all problems at once.
//!
//! # Example
//!
//! ```
//! use sphere_dda_model_description::fmi2::{
//!     Causality, CoSimulation, ModelDescription, RealVariable, ScalarVariable, Variability,
//! };
//! use sphere_dda_model_description::units::{BaseUnit, Unit};
//!
//! let mut model = ModelDescription::new("Hopper", "{1c}", CoSimulation::new("hopper"))
//!     .with_variables(vec![
//!         ScalarVariable::new(
//!             "gate.velocity[1]",
//!             0,
//!             Causality::Input,
//!             Variability::Continuous,
//!             RealVariable::with_unit("m/s").with_start(0.0),
//!         ),
//!         ScalarVariable::new(
//!             "gate.force[1]",
//!             1,
//!             Causality::Output,
//!             Variability::Continuous,
//!             RealVariable::with_unit("N"),
//!         ),
//!     ]);
//! model.unit_definitions = vec![
//!     Unit::new("m/s", BaseUnit { m: 1, s: -1, ..BaseUnit::DIMENSIONLESS }),
//!     Unit::new("N", BaseUnit { kg: 1, m: 1, s: -2, ..BaseUnit::DIMENSIONLESS }),
//! ];
//!
//! assert_eq!(model.validate(), []);
//! let xml = model.to_xml()?;
//! assert_eq!(ModelDescription::from_xml(&xml)?, model);
//! # Ok::<(), sphere_dda_model_description::Error>(())
//! ```

mod finding;
pub mod fmi2;
pub mod fmi3;
pub mod lexical;
mod list;
pub mod names;
pub mod references;
pub mod terminals;
pub mod units;
pub mod value;
pub mod xml;

pub use finding::{Finding, Rule, Severity};
pub use xml::{Error, MAX_ATTRIBUTES, MAX_BYTES, MAX_DEPTH};
