//! Type definitions: defaults that several variables share.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::lexical;
use crate::value::ScalarType;

/// A named type.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Read")]
pub struct SimpleType {
    /// Name, unique among types and variables.
    #[serde(rename = "@name")]
    pub name: String,
    /// What the type is for.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Base type and defaults.
    #[serde(rename = "$value")]
    pub definition: TypeDefinition,
}

impl SimpleType {
    /// An enumeration of the items `(name, value, description)`.
    pub fn enumeration<'a>(
        name: impl Into<String>,
        items: impl IntoIterator<Item = (&'a str, i32, &'a str)>,
    ) -> Self {
        let items = items
            .into_iter()
            .map(|(name, value, description)| EnumerationItem {
                name: name.to_owned(),
                value,
                description: Some(description.to_owned()),
            })
            .collect();
        Self {
            name: name.into(),
            description: None,
            definition: TypeDefinition::Enumeration(EnumerationType {
                quantity: None,
                items,
            }),
        }
    }
}

/// Base type and defaults of a [`SimpleType`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum TypeDefinition {
    /// Real numbers.
    Real(RealType),
    /// Integers of 32 bits.
    Integer(IntegerType),
    /// Truth values.
    Boolean,
    /// Texts.
    String,
    /// Named integers.
    Enumeration(EnumerationType),
}

impl TypeDefinition {
    /// The type of the values.
    pub(crate) fn scalar(&self) -> ScalarType {
        match self {
            Self::Real(_) => ScalarType::Float64,
            Self::Integer(_) => ScalarType::Int32,
            Self::Boolean => ScalarType::Boolean,
            Self::String => ScalarType::String,
            Self::Enumeration(_) => ScalarType::Enumeration,
        }
    }
}

/// Defaults of real variables.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<bool> => #[serde(default, with = "lexical::optional")],
    Option<f64> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RealType {
    /// Physical quantity, for example `Force`.
    #[serde(rename = "@quantity")]
    pub quantity: Option<String>,
    /// Name of a unit definition.
    #[serde(rename = "@unit")]
    pub unit: Option<String>,
    /// Name of a display unit of that unit.
    #[serde(rename = "@displayUnit")]
    pub display_unit: Option<String>,
    /// Offsets of units do not apply, as for a difference of temperatures.
    #[serde(rename = "@relativeQuantity")]
    pub relative_quantity: Option<bool>,
    /// Least value, in `unit`.
    #[serde(rename = "@min")]
    pub min: Option<f64>,
    /// Greatest value, in `unit`.
    #[serde(rename = "@max")]
    pub max: Option<f64>,
    /// Typical size, in `unit`, greater than 0; importers take 1 if absent.
    #[serde(rename = "@nominal")]
    pub nominal: Option<f64>,
    /// The value grows far beyond `nominal`, as the angle of a turning shaft.
    #[serde(rename = "@unbounded")]
    pub unbounded: Option<bool>,
}

/// Defaults of integer variables.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<i32> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct IntegerType {
    /// Physical quantity.
    #[serde(rename = "@quantity")]
    pub quantity: Option<String>,
    /// Least value.
    #[serde(rename = "@min")]
    pub min: Option<i32>,
    /// Greatest value.
    #[serde(rename = "@max")]
    pub max: Option<i32>,
}

/// Items of an enumeration.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct EnumerationType {
    /// Physical quantity.
    #[serde(rename = "@quantity", default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// The items, at least one.
    #[serde(rename = "Item", default)]
    pub items: Vec<EnumerationItem>,
}

/// One named value of an enumeration.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct EnumerationItem {
    /// Name, unique in the enumeration.
    #[serde(rename = "@name")]
    pub name: String,
    /// Value, unique in the enumeration.
    #[serde(rename = "@value", with = "lexical")]
    pub value: i32,
    /// What it means.
    #[serde(rename = "@description")]
    pub description: Option<String>,
}

/// The element as it is read: naming every choice lets unknown elements pass.
#[derive(Deserialize)]
struct Read {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@description", default)]
    description: Option<String>,
    #[serde(rename = "Real", default)]
    real: Option<RealType>,
    #[serde(rename = "Integer", default)]
    integer: Option<IntegerType>,
    #[serde(rename = "Boolean", default)]
    boolean: Option<Empty>,
    #[serde(rename = "String", default)]
    string: Option<Empty>,
    #[serde(rename = "Enumeration", default)]
    enumeration: Option<EnumerationType>,
}

/// An element of which nothing is read.
#[derive(Deserialize)]
struct Empty {}

impl TryFrom<Read> for SimpleType {
    type Error = String;

    fn try_from(read: Read) -> Result<Self, String> {
        let choices = [
            read.real.map(TypeDefinition::Real),
            read.integer.map(TypeDefinition::Integer),
            read.boolean.map(|Empty {}| TypeDefinition::Boolean),
            read.string.map(|Empty {}| TypeDefinition::String),
            read.enumeration.map(TypeDefinition::Enumeration),
        ];
        Ok(Self {
            definition: exactly_one(choices, "SimpleType", &read.name)?,
            name: read.name,
            description: read.description,
        })
    }
}

/// The one choice that is there.
pub(super) fn exactly_one<T, const N: usize>(
    choices: [Option<T>; N],
    element: &str,
    name: &str,
) -> Result<T, String> {
    let mut present: Vec<T> = choices.into_iter().flatten().collect();
    match (present.pop(), present.is_empty()) {
        (Some(choice), true) => Ok(choice),
        (choice, _) => Err(format!(
            "{element} `{name}`: found {} of the elements Real, Integer, Boolean, String and \
             Enumeration, expected exactly one",
            present.len() + usize::from(choice.is_some())
        )),
    }
}
