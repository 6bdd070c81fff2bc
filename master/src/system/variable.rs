//! A variable of a system by its name: what may be set, and what a text stands for.

use sphere_dda_model_description::fmi2::Variability;
use sphere_dda_model_description::fmi3::Causality;
use thiserror::Error;

use crate::value::{Value, ValueType};
use crate::variable::{Place, Variable, shape};

/// A variable of a system, or one element of it.
#[derive(Debug, Clone)]
pub(crate) struct SystemVariable<'s> {
    /// Number of its component.
    pub(crate) component: usize,
    /// Its name in the system.
    pub(crate) name: String,
    pub(crate) declared: &'s Variable,
    /// The one of an array that is meant; `None`: all.
    pub(crate) element: Option<usize>,
}

impl SystemVariable<'_> {
    /// Whether all elements of an array are meant.
    pub(crate) fn is_array(&self) -> bool {
        self.extents().is_some()
    }

    /// Extents of what is meant; `None`: one value.
    pub(crate) fn extents(&self) -> Option<&[usize]> {
        match self.element {
            None => self.declared.extents.as_deref(),
            Some(_) => None,
        }
    }

    /// Place of the value, or of the first.
    pub(crate) fn place(&self) -> Place {
        self.declared.place(self.element.unwrap_or(0))
    }

    /// Places of all values that are meant.
    pub(crate) fn places(&self) -> Vec<Place> {
        match self.element {
            Some(element) => vec![self.declared.place(element)],
            None => (0..self.declared.elements())
                .map(|element| self.declared.place(element))
                .collect(),
        }
    }

    /// Names and places of all values that are meant.
    pub(crate) fn elements(&self) -> Vec<(String, Place)> {
        if !self.is_array() {
            return vec![(self.name.clone(), self.place())];
        }
        let own = self.declared.name.len();
        let places = self.places().into_iter();
        places
            .map(|place| {
                let name = self.declared.element_name(place.element);
                let indices = name.get(own..).unwrap_or_default();
                (format!("{}{indices}", self.name), place)
            })
            .collect()
    }

    /// Whether one value is meant.
    pub(crate) fn check_single(&self) -> Result<(), VariableError> {
        match self.extents() {
            None => Ok(()),
            extents => Err(VariableError::Array {
                name: self.name.clone(),
                shape: shape(extents),
                first: self.declared.element_name(0),
            }),
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
pub(crate) fn check_settable_at_start(variable: &SystemVariable<'_>) -> Result<(), VariableError> {
    settable_or(
        variable,
        variable.declared.settable_at_start,
        "a parameter, an input or another variable with a start value",
    )
}

/// Whether the variable can be set between steps.
pub(crate) fn check_settable_in_steps(variable: &SystemVariable<'_>) -> Result<(), VariableError> {
    let settable = match variable.declared.causality {
        Causality::Input => true,
        Causality::Parameter => variable.declared.variability == Variability::Tunable,
        _ => false,
    };
    settable_or(variable, settable, "an input or a tunable parameter")
}

fn settable_or(
    variable: &SystemVariable<'_>,
    settable: bool,
    expected: &'static str,
) -> Result<(), VariableError> {
    if settable {
        return Ok(());
    }
    Err(VariableError::NotSettable {
        name: variable.name.clone(),
        causality: variable.declared.causality,
        variability: variable.declared.variability,
        expected,
    })
}

/// The values that `text` stands for: one, or those of an array with blanks between them. Reals must be finite; an item
/// of an enumeration may be given by its name.
fn parse(variable: &SystemVariable<'_>, text: &str) -> Result<Vec<Value>, VariableError> {
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

/// The values that a text stands for where the variable gets them before the initialization: within its bounds.
pub(crate) fn parse_start(
    variable: &SystemVariable<'_>,
    text: &str,
) -> Result<Vec<Value>, VariableError> {
    check_settable_at_start(variable)?;
    let values = parse(variable, text)?;
    let [least, greatest] = variable.declared.range;
    let outside = |value: &Value| {
        let number = match value {
            Value::Real(number) => *number,
            Value::Integer(number) => *number as f64,
            _ => return false,
        };
        least.is_some_and(|least| number < least)
            || greatest.is_some_and(|greatest| number > greatest)
    };
    if !values.iter().any(outside) {
        return Ok(values);
    }
    Err(VariableError::Value {
        name: variable.name.clone(),
        found: text.to_owned(),
        expected: match (least, greatest) {
            (Some(least), Some(greatest)) => {
                format!("a number from {} to {}", short(least), short(greatest))
            }
            // The least positive number is how a model description says "not 0".
            (Some(least), None) if least == f64::MIN_POSITIVE => "a number > 0".to_owned(),
            (Some(least), None) => format!("a number >= {}", short(least)),
            (None, greatest) => format!("a number <= {}", short(greatest.unwrap_or(f64::INFINITY))),
        },
    })
}

/// A bound as a person writes it.
fn short(bound: f64) -> String {
    match (1e-3..1e6).contains(&bound.abs()) || bound == 0.0 {
        true => bound.to_string(),
        false => format!("{bound:e}"),
    }
}

/// As [`parse`], for one value.
pub(crate) fn parse_one(variable: &SystemVariable<'_>, text: &str) -> Result<Value, VariableError> {
    let declared = variable.declared;
    let trimmed = text.trim();
    let items = declared.items.iter().flat_map(|items| &items.items);
    let named = items.clone().find(|(name, _)| *name == trimmed);
    let value = match named {
        Some((_, value)) => Some(Value::Integer(*value)),
        None => Value::read(declared.scalar, text).filter(|value| match value {
            Value::Real(value) => value.is_finite(),
            Value::Integer(value) => declared.scalar.range().contains(&i128::from(*value)),
            _ => true,
        }),
    };
    value.ok_or_else(|| VariableError::Value {
        name: variable.name.clone(),
        found: text.to_owned(),
        expected: match declared.scalar.value_type() {
            ValueType::Real => "a finite number".to_owned(),
            ValueType::Integer if declared.items.is_some() => {
                let names: Vec<&str> = items.map(|(name, _)| &**name).collect();
                format!("an item of `{}`", names.join("`, `"))
            }
            ValueType::Integer => format!("an integer ({})", declared.scalar),
            ValueType::Boolean => "`true`, `false`, `1` or `0`".to_owned(),
            ValueType::String => "a text".to_owned(),
            ValueType::Binary => "an even number of hexadecimal digits".to_owned(),
        },
    })
}
