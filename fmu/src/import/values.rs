//! Variables by name, and their values as text.

use std::fmt;

use sphere_dda_model_description::fmi2::Variability;
use sphere_dda_model_description::fmi3::Causality;
use thiserror::Error;

use super::quantity::Call;
use super::system::Variable;

/// The types that values have here; the interfaces have them in several sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Base {
    /// Real numbers.
    Real,
    /// Integers, also those that stand for items of enumerations.
    Integer,
    /// Truth values.
    Boolean,
    /// Texts.
    String,
    /// Bytes.
    Binary,
}

/// A value; enumerations are integers.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A real number, in the unit of the variable.
    Real(f64),
    /// An integer.
    Integer(i64),
    /// A truth value.
    Boolean(bool),
    /// A text.
    String(String),
    /// Bytes.
    Binary(Vec<u8>),
}

impl Value {
    /// The value of a text, as model descriptions and users write it; bytes are hexadecimal digits.
    pub(super) fn read(call: Call, text: &str) -> Option<Self> {
        let trimmed = text.trim();
        Some(match call.base() {
            Base::Real => Self::Real(trimmed.parse().ok()?),
            Base::Integer => Self::Integer(trimmed.parse().ok()?),
            Base::Boolean => Self::Boolean(match trimmed {
                "true" | "1" => true,
                "false" | "0" => false,
                _ => return None,
            }),
            Base::String => Self::String(text.to_owned()),
            Base::Binary => Self::Binary(bytes(trimmed)?),
        })
    }
}

fn bytes(digits: &str) -> Option<Vec<u8>> {
    let digits: Option<Vec<u8>> = digits
        .chars()
        .map(|digit| digit.to_digit(16).map(|value| value as u8))
        .collect();
    let digits = digits?;
    let pairs = digits.chunks(2);
    pairs
        .map(|pair| match pair {
            [high, low] => Some(16 * high + low),
            _ => None,
        })
        .collect()
}

impl fmt::Display for Value {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // The shortest text that reads back to the same bits.
            Self::Real(value) => write!(formatter, "{value:?}"),
            Self::Integer(value) => write!(formatter, "{value}"),
            Self::Boolean(value) => write!(formatter, "{value}"),
            Self::String(value) => formatter.write_str(value),
            Self::Binary(bytes) => bytes
                .iter()
                .try_for_each(|byte| write!(formatter, "{byte:02x}")),
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
    /// A whole array where only one value will do.
    #[error(
        "variable `{name}`: found an array of {shape}, expected one value: name an element, such as `{first}`"
    )]
    Array {
        /// The name.
        name: String,
        /// Its extents.
        shape: String,
        /// Name of its first element.
        first: String,
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

/// Whether the variable can be set before the initialization.
pub(super) fn check_settable_at_start(variable: &Variable<'_>) -> Result<(), VariableError> {
    settable_or(
        variable,
        variable.quantity.settable_at_start,
        "a parameter, an input or another variable with a start value",
    )
}

/// Whether the variable can be set between steps.
pub(super) fn check_settable_in_steps(variable: &Variable<'_>) -> Result<(), VariableError> {
    let settable = match variable.quantity.causality {
        Causality::Input => true,
        Causality::Parameter => variable.quantity.variability == Variability::Tunable,
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
        causality: variable.quantity.causality,
        variability: variable.quantity.variability,
        expected,
    })
}

/// The values that `text` stands for: one, or those of an array with blanks between them. Reals must be finite; an item
/// of an enumeration may be given by its name.
pub(super) fn parse(variable: &Variable<'_>, text: &str) -> Result<Vec<Value>, VariableError> {
    let count = variable.places().len();
    if !variable.is_array() {
        return Ok(vec![parse_one(variable, text)?]);
    }
    let texts: Vec<&str> = text.split_whitespace().collect();
    if texts.len() != count {
        return Err(VariableError::Value {
            name: variable.name.clone(),
            found: text.to_owned(),
            expected: format!("{count} values separated by blanks, row by row"),
        });
    }
    texts.iter().map(|text| parse_one(variable, text)).collect()
}

/// As [`parse`], for one value.
pub(super) fn parse_one(variable: &Variable<'_>, text: &str) -> Result<Value, VariableError> {
    let quantity = variable.quantity;
    let trimmed = text.trim();
    let items = quantity.items.iter().flat_map(|items| &items.items);
    let named = items.clone().find(|(name, _)| *name == trimmed);
    let value = match named {
        Some((_, value)) => Some(Value::Integer(*value)),
        None => Value::read(quantity.call, text).filter(|value| match value {
            Value::Real(value) => value.is_finite(),
            Value::Integer(value) => quantity.call.range().contains(value),
            _ => true,
        }),
    };
    value.ok_or_else(|| VariableError::Value {
        name: variable.name.clone(),
        found: text.to_owned(),
        expected: match quantity.call.base() {
            Base::Real => "a finite number".to_owned(),
            Base::Integer if quantity.items.is_some() => {
                let names: Vec<&str> = items.map(|(name, _)| &**name).collect();
                format!("an item of `{}`", names.join("`, `"))
            }
            Base::Integer => format!("an integer ({})", quantity.call),
            Base::Boolean => "`true`, `false`, `1` or `0`".to_owned(),
            Base::String => "a text".to_owned(),
            Base::Binary => "an even number of hexadecimal digits".to_owned(),
        },
    })
}

/// Values of one type each, one after another in time.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Real numbers, in the unit of the variable.
    Real(Vec<f64>),
    /// Integers.
    Integer(Vec<i64>),
    /// Truth values.
    Boolean(Vec<bool>),
    /// Texts.
    String(Vec<String>),
    /// Bytes.
    Binary(Vec<Vec<u8>>),
}

impl Values {
    /// No values of this type.
    pub(super) fn none(base: Base) -> Self {
        match base {
            Base::Real => Self::Real(Vec::new()),
            Base::Integer => Self::Integer(Vec::new()),
            Base::Boolean => Self::Boolean(Vec::new()),
            Base::String => Self::String(Vec::new()),
            Base::Binary => Self::Binary(Vec::new()),
        }
    }

    /// Appends a value, if it is of this type.
    pub(super) fn extend(&mut self, value: Option<Value>) {
        match (self, value) {
            (Self::Real(list), Some(Value::Real(value))) => list.push(value),
            (Self::Integer(list), Some(Value::Integer(value))) => list.push(value),
            (Self::Boolean(list), Some(Value::Boolean(value))) => list.push(value),
            (Self::String(list), Some(Value::String(value))) => list.push(value),
            (Self::Binary(list), Some(Value::Binary(value))) => list.push(value),
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
            Self::Binary(list) => list.get(index).cloned().map(Value::Binary),
        }
    }
}
