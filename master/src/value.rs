//! Lists of values; one value and its type are those of model descriptions.

pub(crate) use sphere_dda_model_description::value::ScalarType;
pub use sphere_dda_model_description::value::{Value, ValueType};

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
    pub(crate) fn none(base: ValueType) -> Self {
        match base {
            ValueType::Real => Self::Real(Vec::new()),
            ValueType::Integer => Self::Integer(Vec::new()),
            ValueType::Boolean => Self::Boolean(Vec::new()),
            ValueType::String => Self::String(Vec::new()),
            ValueType::Binary => Self::Binary(Vec::new()),
        }
    }

    /// Appends a value, if it is of this type.
    pub(crate) fn extend(&mut self, value: Option<Value>) {
        match (self, value) {
            (Self::Real(list), Some(Value::Real(value))) => list.push(value),
            (Self::Integer(list), Some(Value::Integer(value))) => list.push(value),
            (Self::Boolean(list), Some(Value::Boolean(value))) => list.push(value),
            (Self::String(list), Some(Value::String(value))) => list.push(value),
            (Self::Binary(list), Some(Value::Binary(value))) => list.push(value),
            _ => {}
        }
    }

    /// Forgets all values.
    pub(crate) fn clear(&mut self) {
        match self {
            Self::Real(list) => list.clear(),
            Self::Integer(list) => list.clear(),
            Self::Boolean(list) => list.clear(),
            Self::String(list) => list.clear(),
            Self::Binary(list) => list.clear(),
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
