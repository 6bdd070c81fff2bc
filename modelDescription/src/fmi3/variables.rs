//! Variables: scalars and arrays of one type.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::fmi2::{self, Initial, Variability};
use crate::lexical::{self, Lexical};
use crate::value::{ScalarType, scalar_types};

/// The XML elements: one for each type.
macro_rules! elements {
    ($($scalar:ident),*) => {
        #[derive(Serialize, Deserialize)]
        enum Element {
            $($scalar(Variable)),*
        }

        impl From<&Variable> for Element {
            fn from(variable: &Variable) -> Self {
                match variable.scalar {
                    $(ScalarType::$scalar => Self::$scalar(variable.clone())),*
                }
            }
        }

        impl From<Element> for Variable {
            fn from(element: Element) -> Self {
                match element {
                    $(Element::$scalar(variable) => Self { scalar: ScalarType::$scalar, ..variable }),*
                }
            }
        }
    };
}
scalar_types!(elements);

/// Reads and writes the children of `ModelVariables`.
pub(super) mod list {
    use serde::{Deserialize, Serialize};

    use crate::fmi3::variables::{Element, Variable};
    use serde::{Deserializer, Serializer};

    #[derive(Serialize, Deserialize)]
    struct Elements {
        #[serde(rename = "$value", default)]
        items: Vec<Element>,
    }

    pub(crate) fn serialize<S: Serializer>(
        variables: &[Variable],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        let items = variables.iter().map(Element::from).collect();
        Elements { items }.serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<Variable>, D::Error> {
        let read = Elements::deserialize(deserializer)?;
        Ok(read.items.into_iter().map(Variable::from).collect())
    }
}

/// A variable: one value, or an array of them, row by row.
///
/// Numbers of all fifteen types are kept as they are written, so that none is narrowed; [`validate`] judges them.
///
/// [`validate`]: super::ModelDescription::validate
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<Vec<u32>> => #[serde(default, with = "lexical::optional")],
    bool => #[serde(default, skip_serializing_if = "lexical::is_false", with = "lexical")],
    Option<u32> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Variable {
    /// Type of the elements.
    #[serde(skip)]
    pub scalar: ScalarType,
    /// Name, unique in the description.
    #[serde(rename = "@name")]
    pub name: String,
    /// Handle of the variable, unique in the description.
    #[serde(rename = "@valueReference", with = "lexical")]
    pub value_reference: u32,
    /// What the values mean.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Who provides the values; [`Causality::Local`] if absent.
    #[serde(rename = "@causality", default)]
    pub causality: Causality,
    /// When the values can change; `None` leaves it to type and causality: see
    /// [`effective_variability`](Self::effective_variability).
    #[serde(rename = "@variability")]
    pub variability: Option<Variability>,
    /// Clocks, by value reference, at whose ticks the values change.
    #[serde(rename = "@clocks")]
    pub clocks: Option<Vec<u32>>,
    /// Whether the variable can be read, or an input set, in intermediate update mode.
    #[serde(rename = "@intermediateUpdate")]
    pub intermediate_update: bool,
    /// Name of a type definition.
    #[serde(rename = "@declaredType")]
    pub declared_type: Option<String>,
    /// How the values are initialized; `None` leaves it to causality and variability: see
    /// [`effective_initial`](Self::effective_initial).
    #[serde(rename = "@initial")]
    pub initial: Option<Initial>,
    /// Physical quantity.
    #[serde(rename = "@quantity")]
    pub quantity: Option<String>,
    /// Name of a unit.
    #[serde(rename = "@unit")]
    pub unit: Option<String>,
    /// Name of a display unit of the unit.
    #[serde(rename = "@displayUnit")]
    pub display_unit: Option<String>,
    /// Least value.
    #[serde(rename = "@min")]
    pub min: Option<String>,
    /// Greatest value.
    #[serde(rename = "@max")]
    pub max: Option<String>,
    /// Typical magnitude.
    #[serde(rename = "@nominal")]
    pub nominal: Option<String>,
    /// Values before the initialization, separated by blanks; texts and binaries have [`starts`](Self::starts).
    #[serde(rename = "@start")]
    pub start: Option<String>,
    /// Media type of a binary; `application/octet-stream` if absent.
    #[serde(rename = "@mimeType")]
    pub mime_type: Option<String>,
    /// Most bytes of a binary.
    #[serde(rename = "@maxSize")]
    pub max_size: Option<u32>,
    /// Extents of an array, the slowest first; empty: one value.
    #[serde(rename = "Dimension", default)]
    pub dimensions: Vec<Dimension>,
    /// Start values of texts and binaries.
    #[serde(rename = "Start", default)]
    pub starts: Vec<StartValue>,
    /// Other names.
    #[serde(rename = "Alias", default)]
    pub aliases: Vec<Alias>,
}

impl Variable {
    /// A scalar without start value.
    pub fn new(
        scalar: ScalarType,
        name: impl Into<String>,
        value_reference: u32,
        causality: Causality,
        variability: Variability,
    ) -> Self {
        Self {
            scalar,
            name: name.into(),
            value_reference,
            causality,
            variability: Some(variability),
            ..Self::default()
        }
    }

    /// Sets the extents of an array.
    #[must_use]
    pub fn with_dimensions(mut self, extents: &[u64]) -> Self {
        self.dimensions = extents.iter().map(|&extent| extent.into()).collect();
        self
    }

    /// Sets real start values, one for each element.
    #[must_use]
    pub fn with_reals(mut self, values: &[f64]) -> Self {
        let texts: Vec<String> = values.iter().map(f64::print).collect();
        self.start = Some(texts.join(" "));
        self
    }

    /// Number of elements; `None` if a dimension is named by a variable, or the number is too large.
    pub fn elements(&self) -> Option<u64> {
        let mut extents = self.dimensions.iter().map(|dimension| dimension.start);
        extents.try_fold(1_u64, |product, extent| product.checked_mul(extent?))
    }

    /// When the values can change: as stated, else the default of the standard.
    pub fn effective_variability(&self) -> Variability {
        self.variability.unwrap_or(match self.causality {
            Causality::Parameter
            | Causality::CalculatedParameter
            | Causality::StructuralParameter => Variability::Fixed,
            _ if self.scalar.is_float() => Variability::Continuous,
            _ => Variability::Discrete,
        })
    }

    /// How the values are initialized: as stated, else the default. `None` for the independent variable and illegal
    /// combinations.
    pub fn effective_initial(&self) -> Option<Initial> {
        let legal = self
            .causality
            .legal_initial(self.effective_variability())
            .unwrap_or_default();
        self.initial.or_else(|| legal.first().copied())
    }

    /// Number of start values given.
    pub fn start_count(&self) -> usize {
        if matches!(self.scalar, ScalarType::String | ScalarType::Binary) {
            return self.starts.len();
        }
        let texts = self.start.iter();
        texts.flat_map(|text| text.split_ascii_whitespace()).count()
    }
}

/// Extent of an array in one direction: a number or the value of a variable.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<u64> => #[serde(default, with = "lexical::optional")],
    Option<u32> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Dimension {
    /// The number.
    #[serde(rename = "@start")]
    pub start: Option<u64>,
    /// Value reference of the variable.
    #[serde(rename = "@valueReference")]
    pub value_reference: Option<u32>,
}

impl From<u64> for Dimension {
    fn from(extent: u64) -> Self {
        Self {
            start: Some(extent),
            value_reference: None,
        }
    }
}

/// A start value of a text or binary variable.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct StartValue {
    /// The text; of a binary its bytes as hexadecimal digits.
    #[serde(rename = "@value", default)]
    pub value: String,
}

/// Another name of a variable.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Alias {
    /// The name, unique in the description.
    #[serde(rename = "@name")]
    pub name: String,
    /// What it means.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Name of a display unit of the variable's unit.
    #[serde(rename = "@displayUnit")]
    pub display_unit: Option<String>,
}

/// Who provides a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Causality {
    /// The importer, in configuration mode: the size of arrays.
    StructuralParameter,
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

impl From<fmi2::Causality> for Causality {
    fn from(causality: fmi2::Causality) -> Self {
        match causality {
            fmi2::Causality::Parameter => Self::Parameter,
            fmi2::Causality::CalculatedParameter => Self::CalculatedParameter,
            fmi2::Causality::Input => Self::Input,
            fmi2::Causality::Output => Self::Output,
            fmi2::Causality::Local => Self::Local,
            fmi2::Causality::Independent => Self::Independent,
        }
    }
}

impl Causality {
    /// The table of section 2.4.7.4: the legal values of `initial` for this causality with the given variability, the
    /// default first. Empty if `initial` must not be given; `None` if the combination is illegal.
    pub fn legal_initial(self, variability: Variability) -> Option<&'static [Initial]> {
        use Causality as C;
        use Variability as V;

        const EXACT: Option<&[Initial]> = Some(&[Initial::Exact]);
        const COMPUTED: Option<&[Initial]> = Some(&[Initial::Calculated, Initial::Approx]);
        const ANY: Option<&[Initial]> =
            Some(&[Initial::Calculated, Initial::Exact, Initial::Approx]);

        match (variability, self) {
            (V::Constant, C::Output | C::Local) => EXACT,
            (V::Fixed | V::Tunable, C::Parameter | C::StructuralParameter) => EXACT,
            (V::Fixed | V::Tunable, C::CalculatedParameter | C::Local) => COMPUTED,
            (V::Discrete | V::Continuous, C::Output | C::Local) => ANY,
            (V::Discrete | V::Continuous, C::Input) => EXACT,
            (V::Continuous, C::Independent) => Some(&[]),
            _ => None,
        }
    }
}
