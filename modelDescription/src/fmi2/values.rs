//! What belongs to a variable because of its type: unit, bounds, start value.

use serde::{Deserialize, Serialize};

use crate::lexical;
use crate::value::ScalarType;

/// Type of a value and what belongs to it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum VariableType {
    /// A real number.
    Real(RealVariable),
    /// An integer of 32 bits.
    Integer(IntegerVariable),
    /// A truth value.
    Boolean(BooleanVariable),
    /// A text.
    String(StringVariable),
    /// An item of an enumeration.
    Enumeration(EnumerationVariable),
}

impl VariableType {
    /// The type of the value.
    pub fn scalar(&self) -> ScalarType {
        match self {
            Self::Real(_) => ScalarType::Float64,
            Self::Integer(_) => ScalarType::Int32,
            Self::Boolean(_) => ScalarType::Boolean,
            Self::String(_) => ScalarType::String,
            Self::Enumeration(_) => ScalarType::Enumeration,
        }
    }
}

/// What belongs to a real variable. All values are in `unit`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RealVariable {
    /// Name of a type definition that gives defaults.
    #[serde(
        rename = "@declaredType",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub declared_type: Option<String>,
    /// Physical quantity, for example `Force`.
    #[serde(rename = "@quantity", default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// Name of a unit definition; `None` for a number without unit.
    #[serde(rename = "@unit", default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Name of a display unit of that unit.
    #[serde(
        rename = "@displayUnit",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub display_unit: Option<String>,
    /// Offsets of units do not apply, as for a difference of temperatures.
    #[serde(
        rename = "@relativeQuantity",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub relative_quantity: Option<bool>,
    /// Least value.
    #[serde(
        rename = "@min",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub min: Option<f64>,
    /// Greatest value.
    #[serde(
        rename = "@max",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub max: Option<f64>,
    /// Typical size, greater than 0; importers take 1 if absent.
    #[serde(
        rename = "@nominal",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub nominal: Option<f64>,
    /// The value grows far beyond `nominal`, as the angle of a turning shaft.
    #[serde(
        rename = "@unbounded",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub unbounded: Option<bool>,
    /// Value before the initialization.
    #[serde(
        rename = "@start",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub start: Option<f64>,
    /// Index, from 1, of the variable of which this is the time derivative.
    #[serde(
        rename = "@derivative",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub derivative: Option<u32>,
    /// For states of model exchange: whether an event may set the state anew.
    #[serde(
        rename = "@reinit",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub reinit: Option<bool>,
}

impl RealVariable {
    /// A number without unit, or with that of a declared type.
    pub fn new() -> Self {
        Self::default()
    }

    /// A number in a unit.
    pub fn with_unit(unit: impl Into<String>) -> Self {
        Self {
            unit: Some(unit.into()),
            ..Self::default()
        }
    }

    /// Sets the start value, in the unit.
    #[must_use]
    pub fn with_start(mut self, start: f64) -> Self {
        self.start = Some(start);
        self
    }

    /// Sets the least value, in the unit.
    #[must_use]
    pub fn with_min(mut self, min: f64) -> Self {
        self.min = Some(min);
        self
    }

    /// Sets the greatest value, in the unit.
    #[must_use]
    pub fn with_max(mut self, max: f64) -> Self {
        self.max = Some(max);
        self
    }

    /// Sets the typical size, in the unit.
    #[must_use]
    pub fn with_nominal(mut self, nominal: f64) -> Self {
        self.nominal = Some(nominal);
        self
    }

    /// Sets the display unit, one of the unit.
    #[must_use]
    pub fn with_display_unit(mut self, display_unit: impl Into<String>) -> Self {
        self.display_unit = Some(display_unit.into());
        self
    }

    /// Sets the physical quantity.
    #[must_use]
    pub fn with_quantity(mut self, quantity: impl Into<String>) -> Self {
        self.quantity = Some(quantity.into());
        self
    }

    /// Makes it the time derivative of the variable with this index, from 1.
    #[must_use]
    pub fn with_derivative(mut self, index: u32) -> Self {
        self.derivative = Some(index);
        self
    }
}

/// What belongs to an integer variable.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct IntegerVariable {
    /// Name of a type definition that gives defaults.
    #[serde(
        rename = "@declaredType",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub declared_type: Option<String>,
    /// Physical quantity.
    #[serde(rename = "@quantity", default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// Least value.
    #[serde(
        rename = "@min",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub min: Option<i32>,
    /// Greatest value.
    #[serde(
        rename = "@max",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub max: Option<i32>,
    /// Value before the initialization.
    #[serde(
        rename = "@start",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub start: Option<i32>,
}

impl IntegerVariable {
    /// An integer without start value and bounds.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the start value.
    #[must_use]
    pub fn with_start(mut self, start: i32) -> Self {
        self.start = Some(start);
        self
    }

    /// Sets the least value.
    #[must_use]
    pub fn with_min(mut self, min: i32) -> Self {
        self.min = Some(min);
        self
    }

    /// Sets the greatest value.
    #[must_use]
    pub fn with_max(mut self, max: i32) -> Self {
        self.max = Some(max);
        self
    }
}

/// What belongs to a Boolean variable.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct BooleanVariable {
    /// Name of a type definition.
    #[serde(
        rename = "@declaredType",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub declared_type: Option<String>,
    /// Value before the initialization.
    #[serde(
        rename = "@start",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub start: Option<bool>,
}

impl BooleanVariable {
    /// A truth value without start value.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the start value.
    #[must_use]
    pub fn with_start(mut self, start: bool) -> Self {
        self.start = Some(start);
        self
    }
}

/// What belongs to a text variable.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct StringVariable {
    /// Name of a type definition.
    #[serde(
        rename = "@declaredType",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub declared_type: Option<String>,
    /// Value before the initialization; the empty text is one.
    #[serde(rename = "@start", default, skip_serializing_if = "Option::is_none")]
    pub start: Option<String>,
}

impl StringVariable {
    /// A text without start value.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the start value.
    #[must_use]
    pub fn with_start(mut self, start: impl Into<String>) -> Self {
        self.start = Some(start.into());
        self
    }
}

/// What belongs to an enumeration variable.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct EnumerationVariable {
    /// Name of the type definition that has the items.
    #[serde(rename = "@declaredType")]
    pub declared_type: String,
    /// Physical quantity.
    #[serde(rename = "@quantity", default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// Least value.
    #[serde(
        rename = "@min",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub min: Option<i32>,
    /// Greatest value.
    #[serde(
        rename = "@max",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub max: Option<i32>,
    /// Value before the initialization: that of an item.
    #[serde(
        rename = "@start",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub start: Option<i32>,
}

impl EnumerationVariable {
    /// An item of the enumeration of this name.
    pub fn new(declared_type: impl Into<String>) -> Self {
        Self {
            declared_type: declared_type.into(),
            quantity: None,
            min: None,
            max: None,
            start: None,
        }
    }

    /// Sets the start value: that of an item.
    #[must_use]
    pub fn with_start(mut self, start: i32) -> Self {
        self.start = Some(start);
        self
    }
}

impl From<RealVariable> for VariableType {
    fn from(variable: RealVariable) -> Self {
        Self::Real(variable)
    }
}

impl From<IntegerVariable> for VariableType {
    fn from(variable: IntegerVariable) -> Self {
        Self::Integer(variable)
    }
}

impl From<BooleanVariable> for VariableType {
    fn from(variable: BooleanVariable) -> Self {
        Self::Boolean(variable)
    }
}

impl From<StringVariable> for VariableType {
    fn from(variable: StringVariable) -> Self {
        Self::String(variable)
    }
}

impl From<EnumerationVariable> for VariableType {
    fn from(variable: EnumerationVariable) -> Self {
        Self::Enumeration(variable)
    }
}
