//! Values, their types, and how they read as text.

use std::fmt;
use std::ops::RangeInclusive;

use sphere_dda_model_description::fmi3::Kind;

/// The types that values have here; the interfaces have them in several sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ValueType {
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

/// Type of the elements in the C interface. FMI 2.0 has four of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum ScalarType {
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

impl ScalarType {
    /// The type that the master has for the value.
    pub(crate) fn value_type(self) -> ValueType {
        match self {
            Self::Float64 | Self::Float32 => ValueType::Real,
            Self::Boolean => ValueType::Boolean,
            Self::String => ValueType::String,
            Self::Binary => ValueType::Binary,
            _ => ValueType::Integer,
        }
    }

    /// The integers that it can hold; those of 64 bits as far as the master has them.
    pub(crate) fn range(self) -> RangeInclusive<i64> {
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

    pub(crate) fn of(kind: Kind) -> Option<Self> {
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

impl fmt::Display for ScalarType {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{self:?}")
    }
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
    pub(crate) fn read(scalar: ScalarType, text: &str) -> Option<Self> {
        let trimmed = text.trim();
        Some(match scalar.value_type() {
            ValueType::Real => Self::Real(trimmed.parse().ok()?),
            ValueType::Integer => Self::Integer(trimmed.parse().ok()?),
            ValueType::Boolean => Self::Boolean(match trimmed {
                "true" | "1" => true,
                "false" | "0" => false,
                _ => return None,
            }),
            ValueType::String => Self::String(text.to_owned()),
            ValueType::Binary => Self::Binary(bytes(trimmed)?),
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
