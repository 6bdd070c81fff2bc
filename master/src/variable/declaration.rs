//! A variable as a model description of either version declares it, and the places of its values.

use std::fmt;

use serde::{Deserialize, Serialize};
use sphere_dda_model_description::fmi2::Variability;
use sphere_dda_model_description::fmi3::Causality;
use sphere_dda_model_description::units::BaseUnit;

use crate::value::{ScalarType, Value, ValueType};

/// Most elements that the arrays of one FMU have together: a gigabyte of values.
pub(crate) const MAX_ELEMENTS: u64 = 125_000_000;

/// One value of an FMU, as calls name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) struct Place {
    /// Value reference of the variable.
    pub(crate) reference: u32,
    /// Number of the element, row by row; 0 of what is no array.
    pub(crate) element: usize,
    /// Which get and set it takes.
    pub(crate) scalar: ScalarType,
}

/// The unit of a real variable.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unit {
    pub(crate) name: String,
    pub(crate) base: Option<BaseUnit>,
}

impl fmt::Display for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.name)?;
        match self.base {
            Some(BaseUnit { factor, .. }) if factor != 1.0 => {
                write!(formatter, " (factor {factor} to SI)")
            }
            _ => Ok(()),
        }
    }
}

/// A named set of named integers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Items {
    pub(crate) name: String,
    pub(crate) items: Vec<(String, i64)>,
}

/// A variable: one value, or an array of them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Variable {
    pub(crate) name: String,
    /// Other names.
    pub(crate) aliases: Vec<String>,
    pub(crate) reference: u32,
    pub(crate) scalar: ScalarType,
    /// Extents of an array, the slowest first; `None`: one value.
    pub(crate) extents: Option<Vec<usize>>,
    pub(crate) causality: Causality,
    pub(crate) variability: Variability,
    pub(crate) settable_at_start: bool,
    pub(crate) unit: Option<Unit>,
    /// Of an enumeration.
    pub(crate) items: Option<Items>,
    /// Least and greatest number.
    pub(crate) range: [Option<f64>; 2],
    /// Start values, one for each element; empty if there are none.
    pub(crate) start: Vec<Value>,
}

impl Variable {
    /// Number of values.
    pub(crate) fn elements(&self) -> usize {
        self.extents.iter().flatten().product()
    }

    pub(crate) fn place(&self, element: usize) -> Place {
        Place {
            reference: self.reference,
            element,
            scalar: self.scalar,
        }
    }

    /// Name of an element, as variables of FMI 2.0 are named: indices count from 1.
    pub(crate) fn element_name(&self, element: usize) -> String {
        let Some(extents) = &self.extents else {
            return self.name.clone();
        };
        let mut indices = Vec::new();
        let mut rest = element;
        for &extent in extents.iter().rev() {
            indices.push((rest % extent.max(1) + 1).to_string());
            rest /= extent.max(1);
        }
        indices.reverse();
        format!("{}[{}]", self.name, indices.join(","))
    }

    /// Whether `name` is the variable (`None`) or one of its elements.
    pub(crate) fn answers_to(&self, name: &str) -> Option<Option<usize>> {
        let own = |name: &str| self.name == name || self.aliases.iter().any(|own| own == name);
        if own(name) {
            return Some(None);
        }
        let extents = self.extents.as_ref()?;
        let (array, indices) = name.strip_suffix(']')?.rsplit_once('[')?;
        if !own(array) {
            return None;
        }
        let indices: Vec<usize> = indices
            .split(',')
            .map(|index| index.trim().parse().ok())
            .collect::<Option<_>>()?;
        if indices.len() != extents.len() {
            return None;
        }
        let mut element = 0;
        for (&index, &extent) in indices.iter().zip(extents) {
            if index == 0 || index > extent {
                return None;
            }
            element = element * extent + (index - 1);
        }
        Some(Some(element))
    }

    /// Name of the type, for people.
    pub(crate) fn type_name(&self) -> &'static str {
        match (self.scalar.value_type(), &self.items) {
            (ValueType::Integer, Some(_)) => "Enumeration",
            (ValueType::Real, _) => "Real",
            (ValueType::Integer, None) => "Integer",
            (ValueType::Boolean, _) => "Boolean",
            (ValueType::String, _) => "String",
            (ValueType::Binary, _) => "Binary",
        }
    }
}

/// Extents as text: `[3,4]`; empty for one value.
pub(crate) fn shape(extents: Option<&[usize]>) -> String {
    let Some(extents) = extents else {
        return "one value".to_owned();
    };
    let texts: Vec<String> = extents.iter().map(usize::to_string).collect();
    format!("[{}]", texts.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_have_names_of_their_own() {
        let array = Variable {
            name: "a.b".to_owned(),
            aliases: vec!["c".to_owned()],
            reference: 1,
            scalar: ScalarType::Float64,
            extents: Some(vec![2, 3]),
            causality: Causality::Output,
            variability: Variability::Continuous,
            settable_at_start: false,
            unit: None,
            items: None,
            range: [None; 2],
            start: Vec::new(),
        };
        assert_eq!(array.elements(), 6);
        for element in 0..6 {
            let name = array.element_name(element);
            assert_eq!(array.answers_to(&name), Some(Some(element)), "{name}");
        }
        assert_eq!(array.element_name(5), "a.b[2,3]");
        assert_eq!(array.answers_to("c[2, 1]"), Some(Some(3)));
        assert_eq!(array.answers_to("a.b"), Some(None));
        for name in [
            "a.b[1]",
            "a.b[0,1]",
            "a.b[3,1]",
            "a.b[1,2,3]",
            "a.b[x,1]",
            "a",
            "a.b]",
        ] {
            assert_eq!(array.answers_to(name), None, "{name}");
        }
        let one = Variable {
            extents: None,
            ..array
        };
        assert_eq!((one.elements(), one.element_name(0)), (1, "a.b".to_owned()));
        assert_eq!(one.answers_to("a.b[1]"), None);
    }
}
