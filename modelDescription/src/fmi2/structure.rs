//! Model structure: which variables are outputs, derivatives, initial unknowns.
//!
//! Indices are those of the standard: the first variable has the index 1.

use std::collections::BTreeSet;

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_with_macros::apply;

use super::variables::{Causality, Initial, ScalarVariable};
use crate::lexical;
use crate::list::list_element;

list_element!(unknown_list, super::Unknown, "Unknown");

/// The element `ModelStructure`.
#[apply(
    crate = "serde_with_macros",
    Vec => #[serde(default, skip_serializing_if = "Vec::is_empty")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ModelStructure {
    /// Every variable with causality output.
    #[serde(rename = "Outputs", with = "unknown_list")]
    pub outputs: Vec<Unknown>,
    /// Exposed derivatives of continuous states; co-simulation need not expose any.
    #[serde(rename = "Derivatives", with = "unknown_list")]
    pub derivatives: Vec<Unknown>,
    /// Every variable that the initialization computes.
    #[serde(rename = "InitialUnknowns", with = "unknown_list")]
    pub initial_unknowns: Vec<Unknown>,
}

impl ModelStructure {
    /// The structure that follows from the variables when no state derivative is
    /// exposed: all outputs and all initial unknowns in the order of the
    /// variables, each depending on everything it can (no dependencies listed).
    pub fn from_variables(variables: &[ScalarVariable]) -> Self {
        let outputs = indexed(variables)
            .filter(|(_, variable)| variable.causality == Causality::Output)
            .map(|(index, _)| Unknown::new(index))
            .collect();
        let initial_unknowns = initial_unknowns(variables, &[])
            .into_iter()
            .map(Unknown::new)
            .collect();
        Self {
            outputs,
            derivatives: Vec::new(),
            initial_unknowns,
        }
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
    /// Index of the variable, from 1.
    #[serde(rename = "@index", with = "lexical")]
    pub index: u32,
    /// Indices of the variables it depends on, ascending. `None`: on everything it
    /// can; empty: on nothing.
    #[serde(rename = "@dependencies")]
    pub dependencies: Option<Vec<u32>>,
    /// How it depends on each of them.
    #[serde(rename = "@dependenciesKind", default, with = "kinds")]
    pub dependencies_kind: Option<Vec<DependencyKind>>,
}

impl Unknown {
    /// An unknown that depends on everything it can.
    pub fn new(index: u32) -> Self {
        Self {
            index,
            dependencies: None,
            dependencies_kind: None,
        }
    }

    /// Lists the dependencies: indices from 1, ascending.
    #[must_use]
    pub fn with_dependencies(mut self, dependencies: Vec<u32>) -> Self {
        self.dependencies = Some(dependencies);
        self
    }
}

/// How an unknown depends on a known variable `v`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DependencyKind {
    /// No particular structure, `f(v)`.
    Dependent,
    /// `c v` with a constant factor.
    Constant,
    /// `p v` with a factor that is fixed after initialization.
    Fixed,
    /// `p v` with a factor that changes with tunable parameters.
    Tunable,
    /// `d v` with a factor that changes at events.
    Discrete,
}

impl DependencyKind {
    pub(crate) const ALL: [Self; 5] = [
        Self::Dependent,
        Self::Constant,
        Self::Fixed,
        Self::Tunable,
        Self::Discrete,
    ];

    /// Name in XML.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Dependent => "dependent",
            Self::Constant => "constant",
            Self::Fixed => "fixed",
            Self::Tunable => "tunable",
            Self::Discrete => "discrete",
        }
    }
}

/// The list of kinds as an attribute.
mod kinds {
    use super::{DependencyKind, Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(
        kinds: &Option<Vec<DependencyKind>>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let names: Vec<&str> = kinds.iter().flatten().map(|kind| kind.name()).collect();
        serializer.serialize_str(&names.join(" "))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<Vec<DependencyKind>>, D::Error> {
        let text = String::deserialize(deserializer)?;
        let kind_of = |name: &str| {
            DependencyKind::ALL
                .into_iter()
                .find(|kind| kind.name() == name)
                .ok_or_else(|| {
                    serde::de::Error::custom(format!(
                        "found the kind `{name}`, expected dependent, constant, fixed, tunable or \
                         discrete"
                    ))
                })
        };
        text.split_ascii_whitespace()
            .map(kind_of)
            .collect::<Result<_, _>>()
            .map(Some)
    }
}

/// Variables with their indices from 1.
pub(super) fn indexed(
    variables: &[ScalarVariable],
) -> impl Iterator<Item = (u32, &ScalarVariable)> {
    (1..).zip(variables)
}

/// Variable of an index from 1.
pub(super) fn variable_at(variables: &[ScalarVariable], index: u32) -> Option<&ScalarVariable> {
    let position = usize::try_from(index).ok()?.checked_sub(1)?;
    variables.get(position)
}

/// Indices that `InitialUnknowns` must have, ascending: outputs and exposed states
/// and derivatives that are approximate or calculated, and all calculated
/// parameters (section 2.2.8).
pub(super) fn initial_unknowns(variables: &[ScalarVariable], derivatives: &[Unknown]) -> Vec<u32> {
    let mut exposed = exposed_states(variables, derivatives);
    exposed.extend(derivatives.iter().map(|unknown| unknown.index));
    indexed(variables)
        .filter(|(index, variable)| {
            let computed = matches!(
                variable.effective_initial(),
                Some(Initial::Approx | Initial::Calculated)
            );
            let listed = variable.causality == Causality::Output || exposed.contains(index);
            variable.causality == Causality::CalculatedParameter || (computed && listed)
        })
        .map(|(index, _)| index)
        .collect()
}

/// Indices of the continuous states whose derivatives are exposed.
pub(super) fn exposed_states(
    variables: &[ScalarVariable],
    derivatives: &[Unknown],
) -> BTreeSet<u32> {
    derivatives
        .iter()
        .filter_map(|unknown| variable_at(variables, unknown.index)?.derivative())
        .collect()
}
