//! Variables by name, and their values as text.

use std::fmt;

use sphere_dda_model_description::fmi2::{
    BaseType, Causality, Initial, ModelDescription, TypeDefinition, Variability, VariableType,
};
use thiserror::Error;

use super::system::Variable;
use super::{ImportError, Instance};

/// A value of one of the four types of the interface; enumerations are integers.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// `fmi2Real`, in the unit of the variable.
    Real(f64),
    /// `fmi2Integer`.
    Integer(i32),
    /// `fmi2Boolean`.
    Boolean(bool),
    /// `fmi2String`.
    String(String),
}

impl fmt::Display for Value {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // The shortest text that reads back to the same bits.
            Self::Real(value) => write!(formatter, "{value:?}"),
            Self::Integer(value) => write!(formatter, "{value}"),
            Self::Boolean(value) => write!(formatter, "{value}"),
            Self::String(value) => formatter.write_str(value),
        }
    }
}

/// Why a name or a text does not fit the variables of an FMU.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum VariableError {
    /// No variable has the name.
    #[error("variable: found `{name}`, expected {expected}{}", did_you_mean(.similar))]
    Unknown {
        /// The name.
        name: String,
        /// What a name looks like.
        expected: &'static str,
        /// Names like it, the most similar first.
        similar: Vec<String>,
    },
    /// The variable cannot be set there.
    #[error(
        "variable `{name}`: found a variable of causality {causality:?} and variability {variability:?}, expected {expected}"
    )]
    NotSettable {
        /// The name.
        name: String,
        /// Its causality.
        causality: Causality,
        /// Its variability.
        variability: Variability,
        /// What can be set.
        expected: &'static str,
    },
    /// The variable has its values from an output.
    #[error(
        "variable `{name}`: found an input that `{source_name}` feeds, expected one that nothing feeds: set it in one way"
    )]
    Connected {
        /// The name.
        name: String,
        /// The output that feeds it.
        source_name: String,
    },
    /// The text is not a value of the type of the variable.
    #[error("variable `{name}`: found {found:?}, expected {expected}")]
    Value {
        /// The name of the variable.
        name: String,
        /// The text.
        found: String,
        /// What the type allows.
        expected: String,
    },
}

fn did_you_mean(similar: &[String]) -> String {
    match similar {
        [] => String::new(),
        names => format!(": did you mean `{}`?", names.join("` or `")),
    }
}

/// Whether the variable can be set before the initialization: section 2.2.7 of the standard.
pub(super) fn check_settable_at_start(variable: &Variable<'_>) -> Result<(), VariableError> {
    let settable = match variable.scalar.causality {
        Causality::Independent => false,
        Causality::Input => true,
        _ => {
            variable.scalar.variability != Variability::Constant
                && matches!(
                    variable.scalar.effective_initial(),
                    Some(Initial::Exact | Initial::Approx)
                )
        }
    };
    settable_or(
        variable,
        settable,
        "a parameter, an input or another variable with a start value",
    )
}

/// Whether the variable can be set between steps.
pub(super) fn check_settable_in_steps(variable: &Variable<'_>) -> Result<(), VariableError> {
    let settable = match variable.scalar.causality {
        Causality::Input => true,
        Causality::Parameter => variable.scalar.variability == Variability::Tunable,
        _ => false,
    };
    settable_or(variable, settable, "an input or a tunable parameter")
}

fn settable_or(
    variable: &Variable<'_>,
    settable: bool,
    expected: &'static str,
) -> Result<(), VariableError> {
    if settable {
        return Ok(());
    }
    Err(VariableError::NotSettable {
        name: variable.name.clone(),
        causality: variable.scalar.causality,
        variability: variable.scalar.variability,
        expected,
    })
}

/// The value that `text` stands for. Reals must be finite; an item of an enumeration may be given by its name.
pub(super) fn parse(variable: &Variable<'_>, text: &str) -> Result<Value, VariableError> {
    let trimmed = text.trim();
    let (value, expected) = match &variable.scalar.variable_type {
        VariableType::Real(_) => (
            trimmed
                .parse()
                .ok()
                .filter(|value: &f64| value.is_finite())
                .map(Value::Real),
            "a finite number".to_owned(),
        ),
        VariableType::Integer(_) => (
            trimmed.parse().ok().map(Value::Integer),
            "an integer of 32 bits".to_owned(),
        ),
        VariableType::Boolean(_) => (
            match trimmed {
                "true" | "1" => Some(Value::Boolean(true)),
                "false" | "0" => Some(Value::Boolean(false)),
                _ => None,
            },
            "`true`, `false`, `1` or `0`".to_owned(),
        ),
        VariableType::String(_) => (Some(Value::String(text.to_owned())), String::new()),
        VariableType::Enumeration(enumeration) => {
            let items = items_of(variable.description, &enumeration.declared_type);
            let named = items.iter().find(|(name, _)| *name == trimmed);
            let value = named.map_or_else(|| trimmed.parse().ok(), |(_, value)| Some(*value));
            let names: Vec<&str> = items.iter().map(|(name, _)| *name).collect();
            (
                value.map(Value::Integer),
                format!("an item of `{}`", names.join("`, `")),
            )
        }
    };
    value.ok_or_else(|| VariableError::Value {
        name: variable.name.clone(),
        found: text.to_owned(),
        expected,
    })
}

/// Names and values of the items of an enumeration.
pub(super) fn items_of<'a>(
    description: &'a ModelDescription,
    declared_type: &str,
) -> Vec<(&'a str, i32)> {
    let definition = description
        .type_definitions
        .iter()
        .find(|definition| definition.name == declared_type);
    match definition.map(|definition| &definition.definition) {
        Some(TypeDefinition::Enumeration(enumeration)) => enumeration
            .items
            .iter()
            .map(|item| (&*item.name, item.value))
            .collect(),
        _ => Vec::new(),
    }
}

/// Values of one type each, one after another in time.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Of `fmi2Real`, in the unit of the variable.
    Real(Vec<f64>),
    /// Of `fmi2Integer`.
    Integer(Vec<i32>),
    /// Of `fmi2Boolean`.
    Boolean(Vec<bool>),
    /// Of `fmi2String`.
    String(Vec<String>),
}

impl Values {
    /// No values of this type.
    pub(super) fn none(base: BaseType) -> Self {
        match base {
            BaseType::Real => Self::Real(Vec::new()),
            BaseType::Integer => Self::Integer(Vec::new()),
            BaseType::Boolean => Self::Boolean(Vec::new()),
            BaseType::String => Self::String(Vec::new()),
        }
    }

    /// Their type.
    pub(super) fn base(&self) -> BaseType {
        match self {
            Self::Real(_) => BaseType::Real,
            Self::Integer(_) => BaseType::Integer,
            Self::Boolean(_) => BaseType::Boolean,
            Self::String(_) => BaseType::String,
        }
    }

    /// Appends a value, if it is of this type.
    pub(super) fn extend(&mut self, value: Option<Value>) {
        match (self, value) {
            (Self::Real(list), Some(Value::Real(value))) => list.push(value),
            (Self::Integer(list), Some(Value::Integer(value))) => list.push(value),
            (Self::Boolean(list), Some(Value::Boolean(value))) => list.push(value),
            (Self::String(list), Some(Value::String(value))) => list.push(value),
            _ => {}
        }
    }

    /// The value at `index`.
    pub fn get(&self, index: usize) -> Option<Value> {
        match self {
            Self::Real(list) => list.get(index).copied().map(Value::Real),
            Self::Integer(list) => list.get(index).copied().map(Value::Integer),
            Self::Boolean(list) => list.get(index).copied().map(Value::Boolean),
            Self::String(list) => list.get(index).cloned().map(Value::String),
        }
    }
}

/// The values of variables of one type.
pub(super) fn get(
    instance: &mut Instance,
    base: BaseType,
    references: &[u32],
) -> Result<Values, ImportError> {
    Ok(match base {
        BaseType::Real => Values::Real(instance.get_real(references)?),
        BaseType::Integer => Values::Integer(instance.get_integer(references)?),
        BaseType::Boolean => Values::Boolean(instance.get_boolean(references)?),
        BaseType::String => Values::String(instance.get_string(references)?),
    })
}

/// Sets values of any types, with one call for each type.
pub(super) fn set(instance: &mut Instance, values: &[(u32, Value)]) -> Result<(), ImportError> {
    let (mut real, mut integer, mut boolean, mut string) =
        (Lists::new(), Lists::new(), Lists::new(), Lists::new());
    for (reference, value) in values {
        match value {
            Value::Real(value) => real.push(*reference, *value),
            Value::Integer(value) => integer.push(*reference, *value),
            Value::Boolean(value) => boolean.push(*reference, *value),
            Value::String(value) => string.push(*reference, &**value),
        }
    }
    instance.set_real(&real.references, &real.values)?;
    instance.set_integer(&integer.references, &integer.values)?;
    instance.set_boolean(&boolean.references, &boolean.values)?;
    instance.set_string(&string.references, &string.values)
}

/// References and values side by side, as the interface wants them.
struct Lists<T> {
    references: Vec<u32>,
    values: Vec<T>,
}

impl<T> Lists<T> {
    fn new() -> Self {
        Self {
            references: Vec::new(),
            values: Vec::new(),
        }
    }

    fn push(&mut self, reference: u32, value: T) {
        self.references.push(reference);
        self.values.push(value);
    }
}
