//! Model structure: which variables are outputs and which the initialization computes, by value reference.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use super::variables::{Causality, Variable};
use crate::fmi2::Initial;
use crate::lexical;

/// The element `ModelStructure`. Derivatives of states, clocked states and event indicators are skipped.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ModelStructure {
    /// Every variable with causality output.
    #[serde(rename = "Output", default)]
    pub outputs: Vec<Unknown>,
    /// Every variable that the initialization computes.
    #[serde(rename = "InitialUnknown", default)]
    pub initial_unknowns: Vec<Unknown>,
}

impl ModelStructure {
    /// The structure that follows from the variables: all outputs and all initial unknowns in the order of the
    /// variables, each depending on everything it can (no dependencies listed).
    pub fn from_variables(variables: &[Variable]) -> Self {
        let unknowns = |wanted: fn(&Variable) -> bool| {
            let references = variables.iter().filter(|variable| wanted(variable));
            references
                .map(|variable| Unknown::new(variable.value_reference))
                .collect()
        };
        Self {
            outputs: unknowns(|variable| variable.causality == Causality::Output),
            initial_unknowns: unknowns(is_initial_unknown),
        }
    }
}

/// Outputs that are approximate or calculated, and calculated parameters.
pub(super) fn is_initial_unknown(variable: &Variable) -> bool {
    let computed = matches!(
        variable.effective_initial(),
        Some(Initial::Approx | Initial::Calculated)
    );
    match variable.causality {
        Causality::Output => computed,
        Causality::CalculatedParameter => true,
        _ => false,
    }
}

/// A variable that the unit computes, and what it depends on.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<Vec<u32>> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unknown {
    /// Value reference of the variable.
    #[serde(rename = "@valueReference", with = "lexical")]
    pub value_reference: u32,
    /// Value references of the variables it depends on. `None`: on everything it can; empty: on nothing.
    #[serde(rename = "@dependencies")]
    pub dependencies: Option<Vec<u32>>,
    /// How it depends on each of them: as written, names separated by blanks.
    #[serde(rename = "@dependenciesKind")]
    pub dependencies_kind: Option<String>,
}

impl Unknown {
    /// An unknown that depends on everything it can.
    pub fn new(value_reference: u32) -> Self {
        Self {
            value_reference,
            dependencies: None,
            dependencies_kind: None,
        }
    }

    /// Lists the dependencies.
    #[must_use]
    pub fn with_dependencies(mut self, dependencies: Vec<u32>) -> Self {
        self.dependencies = Some(dependencies);
        self
    }
}
