//! An output that feeds an input, and what the two must have in common.

use sphere_dda_model_description::fmi3::Causality;
use thiserror::Error;

use crate::variable::{Items, Place, shape};

use super::variable::{SystemVariable, VariableError};

/// An output that feeds an input, one value: component and place of both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Connection {
    pub(crate) source: (usize, Place),
    pub(crate) target: (usize, Place),
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
    /// The extents of arrays differ.
    #[error("found {from} and {to}, expected arrays of the same extents, or one value each")]
    Shape {
        /// Extents of the output.
        from: String,
        /// Extents of the input.
        to: String,
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

/// How the types, shapes or units of two variables differ.
pub(crate) fn mismatch(
    source: &SystemVariable<'_>,
    target: &SystemVariable<'_>,
) -> Option<ConnectionFault> {
    let types = (source.declared.type_name(), target.declared.type_name());
    if types.0 != types.1 {
        return Some(ConnectionFault::Type {
            from: types.0,
            to: types.1,
        });
    }
    if source.extents() != target.extents() {
        return Some(ConnectionFault::Shape {
            from: shape(source.extents()),
            to: shape(target.extents()),
        });
    }
    let items = (&source.declared.items, &target.declared.items);
    if let (Some(from), Some(to)) = items
        && from.items != to.items
    {
        return Some(ConnectionFault::Items {
            from: list(from),
            to: list(to),
        });
    }
    let (from, to) = (
        source.declared.unit.as_ref()?,
        target.declared.unit.as_ref()?,
    );
    // The same meaning in SI units, or the same name where that is not told.
    let same = match (&from.base, &to.base) {
        (Some(one), Some(other)) => one == other,
        _ => from.name == to.name,
    };
    (!same).then(|| ConnectionFault::Unit {
        from: from.to_string(),
        to: to.to_string(),
    })
}

/// Items of an enumeration as text.
fn list(items: &Items) -> String {
    let items: Vec<String> = items
        .items
        .iter()
        .map(|(name, value)| format!("`{name}` = {value}"))
        .collect();
    items.join(", ")
}
