//! The variable table: names, references, types, units, start values and what each variable means.
//!
//! One table is built from a [scene](sphere_dda::scene::Scene). The XML of the model description and the dispatch of every get and set
//! come from it, so they cannot disagree. Its outputs are the solver's own list of what is measured,
//! [`sphere_dda::observe::quantities`]. Names of the scene are identifiers, so they need no quotes. The value reference of a
//! variable is its rank in the table, from 0.
//!
//! # When a command holds
//!
//! Pose, slide and hinge inputs are total displacements from the scene's placement: the boundary moves linearly
//! (a rotation by its logarithm) from where it is to the commanded pose and reaches it at the end of the
//! communication step. Speeds, forces and torques are held over the step. The start values mean "as in the scene": zero,
//! and for a belt or a servo wall the scene's surface velocity or pressure.

mod arrays;
mod enumeration;
mod parameters;
mod rows;
mod scalars;
mod variable;

pub use arrays::{Array, Arrays, Field, Source};
pub use enumeration::Enumeration;
pub use parameters::Parameters;
pub use scalars::Table;
pub use variable::{Binding, Input, Parameter, Value, Variable, component};
