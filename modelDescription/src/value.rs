//! Values of variables and their types, the same for both versions.

use std::fmt;
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

/// Hands the list of all types to a macro.
macro_rules! scalar_types {
    ($macro:ident) => {
        $macro!(
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
            Enumeration,
            Clock
        );
    };
}
pub(crate) use scalar_types;

macro_rules! define {
    ($($name:ident),*) => {
        /// Type of the elements of a variable: the name of its XML element in FMI 3.0.
        ///
        /// FMI 2.0 has `Float64` (its Real), `Int32` (its Integer), `Boolean`, `String` and `Enumeration`.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
        #[allow(missing_docs, reason = "the names say it")]
        pub enum ScalarType {
            #[default]
            $($name),*
        }
    };
}
scalar_types!(define);

impl ScalarType {
    /// Whether the values are real numbers: only they can be continuous and have units.
    pub fn is_float(self) -> bool {
        matches!(self, Self::Float64 | Self::Float32)
    }

    /// Which [`Value`] holds an element; the state of a clock is a truth value.
    pub fn value_type(self) -> ValueType {
        match self {
            Self::Float64 | Self::Float32 => ValueType::Real,
            Self::Boolean | Self::Clock => ValueType::Boolean,
            Self::String => ValueType::String,
            Self::Binary => ValueType::Binary,
            _ => ValueType::Integer,
        }
    }

    /// The integers that it can hold.
    pub fn range(self) -> RangeInclusive<i128> {
        match self {
            Self::Int8 => i8::MIN.into()..=i8::MAX.into(),
            Self::UInt8 => 0..=u8::MAX.into(),
            Self::Int16 => i16::MIN.into()..=i16::MAX.into(),
            Self::UInt16 => 0..=u16::MAX.into(),
            Self::Int32 => i32::MIN.into()..=i32::MAX.into(),
            Self::UInt32 => 0..=u32::MAX.into(),
            Self::UInt64 => 0..=u64::MAX.into(),
            _ => i64::MIN.into()..=i64::MAX.into(),
        }
    }

    /// Name of the type in FMI 2.0.
    pub fn name_2(self) -> String {
        match self {
            Self::Float64 => "Real".to_owned(),
            Self::Int32 => "Integer".to_owned(),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for ScalarType {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{self:?}")
    }
}

/// Kinds of [`Value`].
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

/// A value; enumerations are integers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
    pub fn read(scalar: ScalarType, text: &str) -> Option<Self> {
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
