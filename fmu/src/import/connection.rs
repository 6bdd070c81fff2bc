//! An output that feeds an input, and what the two must have in common.

use std::fmt;

use sphere_dda_model_description::fmi2::{
    BaseType, Causality, RealType, TypeDefinition, VariableType,
};
use sphere_dda_model_description::units::BaseUnit;
use thiserror::Error;

use super::VariableError;
use super::system::Variable;
use super::values::items_of;

/// An output that feeds an input: component and value reference of both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Connection {
    pub(super) source: (usize, u32),
    pub(super) target: (usize, u32),
    pub(super) base: BaseType,
}

/// Why an output cannot feed an input.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("connection `{from}` to `{to}`: {fault}")]
pub struct ConnectionError {
    /// Where the values come from.
    pub from: String,
    /// Where they go.
    pub to: String,
    /// What is wrong.
    pub fault: ConnectionFault,
}

/// What is wrong with a connection.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ConnectionFault {
    /// There is no such variable.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// A variable is at the wrong end.
    #[error(
        "`{name}` has causality {found:?}, expected {expected:?}: values go from an output to an input"
    )]
    Causality {
        /// The variable.
        name: String,
        /// Its causality.
        found: Causality,
        /// What belongs there.
        expected: Causality,
    },
    /// The types differ.
    #[error("found types {from} and {to}, expected one type")]
    Type {
        /// Type of the output.
        from: &'static str,
        /// Type of the input.
        to: &'static str,
    },
    /// The items of the enumerations differ.
    #[error("found enumerations of different items, {from} and {to}, expected the same")]
    Items {
        /// Those of the output.
        from: String,
        /// Those of the input.
        to: String,
    },
    /// The units differ.
    #[error("found units `{from}` and `{to}`, expected one unit: values are not converted")]
    Unit {
        /// Unit of the output.
        from: String,
        /// Unit of the input.
        to: String,
    },
    /// The input has another source already.
    #[error("the input is fed by `{0}` already, expected one source")]
    Taken(String),
}

/// How the types or units of two variables differ.
pub(super) fn mismatch(source: &Variable<'_>, target: &Variable<'_>) -> Option<ConnectionFault> {
    let kinds = (
        kind(&source.scalar.variable_type),
        kind(&target.scalar.variable_type),
    );
    if kinds.0 != kinds.1 {
        return Some(ConnectionFault::Type {
            from: kinds.0,
            to: kinds.1,
        });
    }
    let items = (items(source), items(target));
    if items.0 != items.1 {
        return Some(ConnectionFault::Items {
            from: items.0,
            to: items.1,
        });
    }
    let (from, to) = (Unit::of(source)?, Unit::of(target)?);
    (!from.is(&to)).then(|| ConnectionFault::Unit {
        from: from.to_string(),
        to: to.to_string(),
    })
}

fn kind(variable_type: &VariableType) -> &'static str {
    match variable_type {
        VariableType::Real(_) => "Real",
        VariableType::Integer(_) => "Integer",
        VariableType::Boolean(_) => "Boolean",
        VariableType::String(_) => "String",
        VariableType::Enumeration(_) => "Enumeration",
    }
}

/// Items of an enumeration as text; empty for other types.
fn items(variable: &Variable<'_>) -> String {
    let VariableType::Enumeration(enumeration) = &variable.scalar.variable_type else {
        return String::new();
    };
    let items = items_of(variable.description, &enumeration.declared_type);
    let items: Vec<String> = items
        .iter()
        .map(|(name, value)| format!("`{name}` = {value}"))
        .collect();
    items.join(", ")
}

/// The unit of a real variable.
struct Unit<'s> {
    name: &'s str,
    base: Option<BaseUnit>,
}

impl<'s> Unit<'s> {
    /// The variable's own or its type's; `None` if nobody gives one.
    fn of(variable: &Variable<'s>) -> Option<Self> {
        let VariableType::Real(real) = &variable.scalar.variable_type else {
            return None;
        };
        let description = variable.description;
        let of_type = || {
            let name = real.declared_type.as_ref()?;
            let known = description
                .type_definitions
                .iter()
                .find(|t| t.name == *name)?;
            match &known.definition {
                TypeDefinition::Real(RealType { unit, .. }) => unit.as_deref(),
                _ => None,
            }
        };
        let name = real.unit.as_deref().or_else(of_type)?;
        let mut units = description.unit_definitions.iter();
        let base = units
            .find(|unit| unit.name == name)
            .and_then(|unit| unit.base_unit);
        Some(Self { name, base })
    }

    /// The same meaning in SI units, or the same name where that is not told.
    fn is(&self, other: &Self) -> bool {
        match (&self.base, &other.base) {
            (Some(one), Some(other)) => one == other,
            _ => self.name == other.name,
        }
    }
}

impl fmt::Display for Unit<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name)?;
        match self.base {
            Some(BaseUnit { factor, .. }) if factor != 1.0 => {
                write!(formatter, " (factor {factor} to SI)")
            }
            _ => Ok(()),
        }
    }
}
