//! Scalar variables: what an importer can set and get.

use serde::{Deserialize, Serialize};

use super::types::exactly_one;
use super::values::{
    BooleanVariable, EnumerationVariable, IntegerVariable, RealVariable, StringVariable,
    VariableType,
};
use crate::lexical;

/// A variable of one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Read")]
pub struct ScalarVariable {
    /// Name, unique in the description.
    #[serde(rename = "@name")]
    pub name: String,
    /// Handle of the value. Variables of one
    /// type of the C interface with one handle always
    /// have the same value.
    #[serde(rename = "@valueReference", with = "lexical")]
    pub value_reference: u32,
    /// What the value means.
    #[serde(rename = "@description", skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Who provides the value; [`Causality::Local`] if absent.
    #[serde(rename = "@causality")]
    pub causality: Causality,
    /// When the value can change; [`Variability::Continuous`] if absent.
    #[serde(rename = "@variability")]
    pub variability: Variability,
    /// How the value is initialized. `None` leaves it to causality and
    /// variability: see [`effective_initial`](Self::effective_initial).
    #[serde(rename = "@initial", skip_serializing_if = "Option::is_none")]
    pub initial: Option<Initial>,
    /// Type of the value and what belongs to it.
    #[serde(rename = "$value")]
    pub variable_type: VariableType,
}

impl ScalarVariable {
    /// A variable without description whose `initial` follows from causality and
    /// variability.
    pub fn new(
        name: impl Into<String>,
        value_reference: u32,
        causality: Causality,
        variability: Variability,
        variable_type: impl Into<VariableType>,
    ) -> Self {
        Self {
            name: name.into(),
            value_reference,
            description: None,
            causality,
            variability,
            initial: None,
            variable_type: variable_type.into(),
        }
    }

    /// Sets the description.
    #[must_use]
    pub fn with_description(mut self, description: impl Into<String>) -> Self {
        self.description = Some(description.into());
        self
    }

    /// Sets how the value is initialized.
    #[must_use]
    pub fn with_initial(mut self, initial: Initial) -> Self {
        self.initial = Some(initial);
        self
    }

    /// How the value is initialized: as stated, else the default for causality and
    /// variability. `None` for inputs, the independent variable and illegal
    /// combinations.
    pub fn effective_initial(&self) -> Option<Initial> {
        let default = || {
            let legal = self.causality.legal_initial(self.variability)?;
            legal.first().copied()
        };
        self.initial.or_else(default)
    }

    /// Whether a start value is given.
    pub fn has_start(&self) -> bool {
        match &self.variable_type {
            VariableType::Real(real) => real.start.is_some(),
            VariableType::Integer(integer) => integer.start.is_some(),
            VariableType::Boolean(boolean) => boolean.start.is_some(),
            VariableType::String(string) => string.start.is_some(),
            VariableType::Enumeration(enumeration) => enumeration.start.is_some(),
        }
    }

    /// Index, from 1, of the variable of which this one is the time derivative.
    pub fn derivative(&self) -> Option<u32> {
        match &self.variable_type {
            VariableType::Real(real) => real.derivative,
            _ => None,
        }
    }
}

/// Who provides a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Causality {
    /// The importer, before or between steps.
    Parameter,
    /// The unit, from parameters.
    CalculatedParameter,
    /// The importer, in a connection.
    Input,
    /// The unit, for use in a connection.
    Output,
    /// The unit, for inspection.
    #[default]
    Local,
    /// The variable of which all others are functions: time.
    Independent,
}

impl Causality {
    /// The table of section 2.2.7: the legal values of `initial` for this causality
    /// with the given variability, the default first.
    ///
    /// Empty if `initial` must not be given; `None` if the combination is illegal.
    pub fn legal_initial(self, variability: Variability) -> Option<&'static [Initial]> {
        use Causality as C;
        use Variability as V;

        // Named as in the standard.
        const A: Option<&[Initial]> = Some(&[Initial::Exact]);
        const B: Option<&[Initial]> = Some(&[Initial::Calculated, Initial::Approx]);
        const C: Option<&[Initial]> = Some(&[Initial::Calculated, Initial::Exact, Initial::Approx]);
        const D: Option<&[Initial]> = Some(&[]);
        const E: Option<&[Initial]> = Some(&[]);

        match (variability, self) {
            (V::Constant, C::Output | C::Local) => A,
            (V::Fixed | V::Tunable, C::Parameter) => A,
            (V::Fixed | V::Tunable, C::CalculatedParameter | C::Local) => B,
            (V::Discrete | V::Continuous, C::Output | C::Local) => C,
            (V::Discrete | V::Continuous, C::Input) => D,
            (V::Continuous, C::Independent) => E,
            _ => None,
        }
    }

    /// Name in XML.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::CalculatedParameter => "calculatedParameter",
            Self::Input => "input",
            Self::Output => "output",
            Self::Local => "local",
            Self::Independent => "independent",
        }
    }
}

/// When a value can change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Variability {
    /// Never.
    Constant,
    /// Until the end of the initialization.
    Fixed,
    /// Between steps, when a tunable parameter changes.
    Tunable,
    /// At communication points.
    Discrete,
    /// Always; real variables only.
    #[default]
    Continuous,
}

impl Variability {
    /// All, in the order of the standard.
    pub(crate) const ALL: [Self; 5] = [
        Self::Constant,
        Self::Fixed,
        Self::Tunable,
        Self::Discrete,
        Self::Continuous,
    ];

    /// Name in XML.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Fixed => "fixed",
            Self::Tunable => "tunable",
            Self::Discrete => "discrete",
            Self::Continuous => "continuous",
        }
    }
}

/// How a value is initialized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Initial {
    /// With the start value.
    Exact,
    /// By an iteration that begins with the start value.
    Approx,
    /// From other variables; there is no start value.
    Calculated,
}

impl Initial {
    /// Name in XML.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Approx => "approx",
            Self::Calculated => "calculated",
        }
    }
}

/// The element as it is read: naming every choice lets annotations and unknown
/// elements pass.
#[derive(Deserialize)]
struct Read {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "@valueReference", with = "lexical")]
    value_reference: u32,
    #[serde(rename = "@description", default)]
    description: Option<String>,
    #[serde(rename = "@causality", default)]
    causality: Causality,
    #[serde(rename = "@variability", default)]
    variability: Variability,
    #[serde(rename = "@initial", default)]
    initial: Option<Initial>,
    #[serde(rename = "Real", default)]
    real: Option<RealVariable>,
    #[serde(rename = "Integer", default)]
    integer: Option<IntegerVariable>,
    #[serde(rename = "Boolean", default)]
    boolean: Option<BooleanVariable>,
    #[serde(rename = "String", default)]
    string: Option<StringVariable>,
    #[serde(rename = "Enumeration", default)]
    enumeration: Option<EnumerationVariable>,
}

impl TryFrom<Read> for ScalarVariable {
    type Error = String;

    fn try_from(read: Read) -> Result<Self, String> {
        let choices = [
            read.real.map(VariableType::Real),
            read.integer.map(VariableType::Integer),
            read.boolean.map(VariableType::Boolean),
            read.string.map(VariableType::String),
            read.enumeration.map(VariableType::Enumeration),
        ];
        Ok(Self {
            variable_type: exactly_one(choices, "ScalarVariable", &read.name)?,
            name: read.name,
            value_reference: read.value_reference,
            description: read.description,
            causality: read.causality,
            variability: read.variability,
            initial: read.initial,
        })
    }
}
