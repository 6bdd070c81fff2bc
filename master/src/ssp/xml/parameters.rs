//! Values of parameters: a file of its own, or within the structure.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::units::{BaseUnit, Unit};
use sphere_dda_model_description::xml;

use super::document::{SSC, SSP_VERSION, SSV, read};

/// The root of a `.ssv`.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct ParameterSet {
    #[serde(rename = "@xmlns:ssv", skip_deserializing)]
    ssv: &'static str,
    #[serde(rename = "@xmlns:ssc", skip_deserializing)]
    ssc: &'static str,
    #[serde(rename = "@version", default)]
    version: String,
    #[serde(rename = "@name", default)]
    name: String,
    #[serde(rename = "@generationTool")]
    generation_tool: Option<String>,
    #[serde(rename = "ssv:Parameters", alias = "Parameters")]
    parameters: Parameters,
    #[serde(rename = "ssv:Units", skip_deserializing)]
    units: Option<Units>,
}

impl ParameterSet {
    /// Values with the units they are in.
    pub(in crate::ssp) fn new(
        name: &str,
        tool: &str,
        parameters: Vec<Parameter>,
        units: &[Unit],
    ) -> Self {
        Self {
            ssv: SSV,
            ssc: SSC,
            version: SSP_VERSION.to_owned(),
            name: name.to_owned(),
            generation_tool: Some(tool.to_owned()),
            parameters: Parameters { items: parameters },
            units: Units::of(units),
        }
    }

    /// The parameters, in the order of the document.
    pub(in crate::ssp) fn parameters(&self) -> &[Parameter] {
        &self.parameters.items
    }

    /// Reads a `.ssv`.
    ///
    /// # Errors
    /// Every variant of [`Error`] that is about reading.
    pub(in crate::ssp) fn from_xml(text: &str) -> Result<Self, Error> {
        read(text, "ParameterSet")
    }

    /// The text of a `.ssv`.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub(in crate::ssp) fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, "ssv:ParameterSet")
    }
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Parameters {
    #[serde(rename = "ssv:Parameter", alias = "Parameter", default)]
    items: Vec<Parameter>,
}

/// A parameter and its value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Parameter {
    /// Its name.
    #[serde(rename = "@name")]
    pub(in crate::ssp) name: String,
    #[serde(rename = "$value", default)]
    contents: Vec<Content>,
}

impl Parameter {
    /// A parameter of one value.
    pub(in crate::ssp) fn new(name: String, value: Content) -> Self {
        let contents = vec![value];
        Self { name, contents }
    }

    /// Text and unit of the value; `None` if it has none of a type that is known.
    pub(in crate::ssp) fn value(&self) -> Option<(&str, Option<&str>)> {
        self.contents.iter().find_map(|content| match content {
            Content::Real(own)
            | Content::Integer(own)
            | Content::Boolean(own)
            | Content::String(own)
            | Content::Enumeration(own)
            | Content::Binary(own) => Some((&*own.value, own.unit.as_deref())),
            Content::Other => None,
        })
    }
}

/// Type and value of a parameter, or what stands beside it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) enum Content {
    #[serde(rename = "ssv:Real", alias = "Real")]
    Real(Text),
    #[serde(rename = "ssv:Integer", alias = "Integer")]
    Integer(Text),
    #[serde(rename = "ssv:Boolean", alias = "Boolean")]
    Boolean(Text),
    #[serde(rename = "ssv:String", alias = "String")]
    String(Text),
    #[serde(rename = "ssv:Enumeration", alias = "Enumeration")]
    Enumeration(Text),
    #[serde(rename = "ssv:Binary", alias = "Binary")]
    Binary(Text),
    #[serde(other)]
    Other,
}

/// A value as it is written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Text {
    #[serde(rename = "@value", default)]
    pub(in crate::ssp) value: String,
    #[serde(rename = "@unit", skip_serializing_if = "Option::is_none")]
    pub(in crate::ssp) unit: Option<String>,
}

impl From<String> for Text {
    fn from(value: String) -> Self {
        Self { value, unit: None }
    }
}

/// Units by name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(in crate::ssp) struct Units {
    #[serde(rename = "ssc:Unit")]
    units: Vec<PlainUnit>,
}

/// A unit without display units, which SSP does not know.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct PlainUnit {
    #[serde(rename = "@name")]
    name: String,
    #[serde(rename = "ssc:BaseUnit")]
    base: BaseUnit,
}

impl Units {
    pub(in crate::ssp) fn of(units: &[Unit]) -> Option<Self> {
        let plain = |unit: &Unit| PlainUnit {
            name: unit.name.clone(),
            base: unit.base_unit.unwrap_or(BaseUnit::DIMENSIONLESS),
        };
        let units: Vec<PlainUnit> = units.iter().map(plain).collect();
        (!units.is_empty()).then_some(Self { units })
    }
}
