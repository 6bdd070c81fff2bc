//! Variables of either version in one form: what the master asks about them.

mod version2;
mod version3;

use std::fmt;
use std::ops::RangeInclusive;

use sphere_dda_model_description::fmi2::Variability;
use sphere_dda_model_description::fmi3::{Causality, Kind};
use sphere_dda_model_description::units::BaseUnit;

use super::values::{Base, Value};

pub(super) use version2::quantities as quantities_2;
pub(super) use version3::quantities as quantities_3;

/// Most elements that the arrays of one FMU have together.
pub(super) const MAX_ELEMENTS: u64 = 5_000_000;

/// One value of an FMU, as calls name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    /// Value reference of the variable.
    pub(super) reference: u32,
    /// Number of the element, row by row; 0 of what is no array.
    pub(super) element: usize,
    /// Which get and set it takes.
    pub(super) call: Call,
}

/// Type of the elements in the C interface. FMI 2.0 has four of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Call {
    Float64,
    Float32,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Boolean,
    String,
    Binary,
}

impl Call {
    /// The type that the master has for the value.
    pub(super) fn base(self) -> Base {
        match self {
            Self::Float64 | Self::Float32 => Base::Real,
            Self::Boolean => Base::Boolean,
            Self::String => Base::String,
            Self::Binary => Base::Binary,
            _ => Base::Integer,
        }
    }

    /// The integers that it can hold; those of 64 bits as far as the master has them.
    pub(super) fn range(self) -> RangeInclusive<i64> {
        match self {
            Self::Int8 => i8::MIN.into()..=i8::MAX.into(),
            Self::UInt8 => 0..=u8::MAX.into(),
            Self::Int16 => i16::MIN.into()..=i16::MAX.into(),
            Self::UInt16 => 0..=u16::MAX.into(),
            Self::Int32 => i32::MIN.into()..=i32::MAX.into(),
            Self::UInt32 => 0..=u32::MAX.into(),
            Self::UInt64 => 0..=i64::MAX,
            _ => i64::MIN..=i64::MAX,
        }
    }

    fn of(kind: Kind) -> Option<Self> {
        Some(match kind {
            Kind::Float64 => Self::Float64,
            Kind::Float32 => Self::Float32,
            Kind::Int8 => Self::Int8,
            Kind::UInt8 => Self::UInt8,
            Kind::Int16 => Self::Int16,
            Kind::UInt16 => Self::UInt16,
            Kind::Int32 => Self::Int32,
            Kind::UInt32 => Self::UInt32,
            Kind::Int64 | Kind::Enumeration => Self::Int64,
            Kind::UInt64 => Self::UInt64,
            Kind::Boolean => Self::Boolean,
            Kind::String => Self::String,
            Kind::Binary => Self::Binary,
            Kind::Clock => return None,
        })
    }
}

impl fmt::Display for Call {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{self:?}")
    }
}

/// The unit of a real variable.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unit {
    pub(super) name: String,
    pub(super) base: Option<BaseUnit>,
}

/// A named set of named integers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Items {
    pub(super) name: String,
    pub(super) items: Vec<(String, i64)>,
}

/// A variable: one value, or an array of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quantity {
    pub(super) name: String,
    /// Other names.
    pub(super) aliases: Vec<String>,
    pub(super) reference: u32,
    pub(super) call: Call,
    /// Extents of an array, the slowest first; `None`: one value.
    pub(super) extents: Option<Vec<usize>>,
    pub(super) causality: Causality,
    pub(super) variability: Variability,
    pub(super) settable_at_start: bool,
    pub(super) unit: Option<Unit>,
    /// Of an enumeration.
    pub(super) items: Option<Items>,
    /// Start values, one for each element; empty if there are none.
    pub(super) start: Vec<Value>,
}

impl Quantity {
    /// Number of values.
    pub(super) fn elements(&self) -> usize {
        self.extents.iter().flatten().product()
    }

    pub(super) fn place(&self, element: usize) -> Place {
        Place {
            reference: self.reference,
            element,
            call: self.call,
        }
    }

    /// Name of an element, as variables of FMI 2.0 are named: indices count from 1.
    pub(super) fn element_name(&self, element: usize) -> String {
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
    pub(super) fn answers_to(&self, name: &str) -> Option<Option<usize>> {
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
    pub(super) fn type_name(&self) -> &'static str {
        match (self.call.base(), &self.items) {
            (Base::Integer, Some(_)) => "Enumeration",
            (Base::Real, _) => "Real",
            (Base::Integer, None) => "Integer",
            (Base::Boolean, _) => "Boolean",
            (Base::String, _) => "String",
            (Base::Binary, _) => "Binary",
        }
    }
}

/// Extents as text: `[3,4]`; empty for one value.
pub(super) fn shape(extents: Option<&[usize]>) -> String {
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
        let array = Quantity {
            name: "a.b".to_owned(),
            aliases: vec!["c".to_owned()],
            reference: 1,
            call: Call::Float64,
            extents: Some(vec![2, 3]),
            causality: Causality::Output,
            variability: Variability::Continuous,
            settable_at_start: false,
            unit: None,
            items: None,
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
        let one = Quantity {
            extents: None,
            ..array
        };
        assert_eq!((one.elements(), one.element_name(0)), (1, "a.b".to_owned()));
        assert_eq!(one.answers_to("a.b[1]"), None);
    }
}
