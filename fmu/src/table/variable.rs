//! One variable: its name, type, shape and start, and what it stands for.

use std::ops::Range;

use serde::Serialize;
use sphere_dda_model_description::fmi2::{Causality, Variability};
use sphere_dda_model_description::value::{ScalarType, Value};

use super::binding::Binding;
use super::enumeration::Enumeration;

/// One variable, a number or an array.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Variable {
    /// Structured name, unique.
    pub name: String,
    /// The boundary that it belongs to, and its name there.
    pub boundary: Option<(usize, &'static str)>,
    /// Type of the elements.
    pub scalar: ScalarType,
    /// Extents, the slowest first; empty: one value.
    pub dims: Vec<usize>,
    /// Letters of the components of a vector, which end the descriptions of its elements.
    pub components: &'static [&'static str],
    /// Who provides the values.
    pub causality: Causality,
    /// When they may change.
    pub variability: Variability,
    /// Unit, one that the exporter defines; `None`: numbers without unit.
    pub unit: Option<&'static str>,
    /// Start values of inputs and parameters, one for each element.
    pub start: Vec<Value>,
    /// Smallest allowed value.
    pub min: Option<f64>,
    /// Largest allowed value.
    pub max: Option<f64>,
    /// The items of an enumeration.
    pub choices: Option<&'static Enumeration>,
    /// One line for people.
    pub description: String,
    /// What it stands for.
    pub binding: Binding,
}

impl Variable {
    /// One value without unit and bounds.
    pub(super) fn new(
        name: impl Into<String>,
        scalar: ScalarType,
        causality: Causality,
        binding: Binding,
        description: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            boundary: None,
            scalar,
            dims: Vec::new(),
            components: &[],
            causality,
            variability: match causality {
                Causality::Parameter | Causality::CalculatedParameter => Variability::Fixed,
                _ if scalar.is_float() => Variability::Continuous,
                _ => Variability::Discrete,
            },
            unit: None,
            start: Vec::new(),
            min: None,
            max: None,
            choices: None,
            description: description.into(),
            binding,
        }
    }

    /// The same with the components of a vector; none: one value.
    pub(super) fn vector(mut self, components: &'static [&'static str]) -> Self {
        self.components = components;
        self.dims = (!components.is_empty())
            .then_some(components.len())
            .into_iter()
            .collect();
        self
    }

    /// Number of elements.
    #[must_use]
    pub fn count(&self) -> usize {
        self.dims.iter().product()
    }

    /// Whether its values are known from initialization mode on only.
    #[must_use]
    pub fn is_computed(&self) -> bool {
        !matches!(
            self.binding,
            Binding::Time
                | Binding::Parameter(_)
                | Binding::SceneParameter(_)
                | Binding::Input { .. }
                | Binding::AppliedForces
        )
    }

    /// Whether it can be read and, if it is an input, set between two internal steps: `intermediateUpdate` of FMI 3.0.
    #[must_use]
    pub fn is_intermediate(&self) -> bool {
        matches!(
            self.causality,
            Causality::Input | Causality::Output | Causality::Local
        )
    }

    /// Place of an element in the list of what is measured.
    #[must_use]
    pub fn rank(&self, element: usize) -> Option<usize> {
        match &self.binding {
            Binding::Output(first) => Some(first + element),
            Binding::Boundaries(firsts) => {
                let width = self.count() / firsts.len();
                Some(firsts[element / width] + element % width)
            }
            _ => None,
        }
    }

    /// Name of an element of a vector, which counts from 1, or of the one value.
    #[must_use]
    pub fn element(&self, element: usize) -> String {
        let index = (!self.dims.is_empty()).then_some(element);
        indexed(&self.name, index)
    }
}

/// A variable as a version of the standard has it: FMI 3.0 whole, FMI 2.0 each element of a vector by itself.
#[derive(Debug, Clone, Copy)]
pub struct Entry<'t> {
    /// Value reference.
    pub reference: u32,
    /// Rank of the variable in the table.
    pub row: usize,
    /// The variable.
    pub variable: &'t Variable,
    /// The element, if it stands for one only.
    pub index: Option<usize>,
}

impl Entry<'_> {
    /// The elements of the variable that it stands for.
    #[must_use]
    pub fn elements(&self) -> Range<usize> {
        self.index
            .map_or(0..self.variable.count(), |index| index..index + 1)
    }

    /// Structured name.
    #[must_use]
    pub fn name(&self) -> String {
        indexed(&self.variable.name, self.index)
    }

    /// Index of its boundary, and its name without that of the boundary.
    #[must_use]
    pub fn member(&self) -> Option<(usize, String)> {
        let (boundary, field) = self.variable.boundary?;
        Some((boundary, indexed(field, self.index)))
    }

    /// One line for people; of an element it ends with the letter of the component.
    #[must_use]
    pub fn description(&self) -> String {
        let text = &self.variable.description;
        let components = self.variable.components;
        match self.index.and_then(|index| components.get(index)) {
            Some(letter) => format!("{text}; {letter}"),
            None => text.clone(),
        }
    }

    /// Start values of its elements; none: the variable is no input and no parameter.
    #[must_use]
    pub fn start(&self) -> &[Value] {
        self.variable.start.get(self.elements()).unwrap_or_default()
    }
}

fn indexed(name: &str, index: Option<usize>) -> String {
    match index {
        Some(index) => format!("{name}[{}]", index + 1),
        None => name.to_owned(),
    }
}
