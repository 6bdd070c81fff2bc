//! Values of parameters: a file of its own, or within the structure.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::lexical;
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

/// What follows the name of a parameter, text and unit of a value.
pub(in crate::ssp) type ElementValue<'v> = (String, &'v str, Option<&'v str>);

impl Parameter {
    /// A parameter of one value.
    pub(in crate::ssp) fn new(name: String, value: Content) -> Self {
        let contents = vec![value];
        Self { name, contents }
    }

    /// What follows the name, text and unit of each of its values. Numbers of an array are one text, separated by blanks; its
    /// texts are one by one, each with its indices.
    ///
    /// # Errors
    /// What is wrong with them.
    pub(in crate::ssp) fn values(&self) -> Result<Vec<ElementValue<'_>>, String> {
        let value = self.contents.iter().find_map(|content| match content {
            Content::Real(own)
            | Content::Integer(own)
            | Content::Boolean(own)
            | Content::String(own)
            | Content::Enumeration(own)
            | Content::Binary(own) => Some(own),
            Content::Dimension(_) | Content::Other => None,
        });
        let Some(value) = value else {
            return Err("found no value, expected one of a type that SSP knows".to_owned());
        };
        let unit = value.unit.as_deref();
        if let [first, ..] = &*value.items
            && !value.value.is_empty()
        {
            return Err(format!(
                "found the attribute value {:?} and an element Value {:?}, expected one of them",
                value.value, first.value
            ));
        }
        let extents = self.contents.iter().filter_map(|content| match content {
            Content::Dimension(own) => Some(own.size),
            _ => None,
        });
        let mut extents: Vec<u64> = extents.collect();
        let count = value.items.len();
        match count {
            0 => return Ok(vec![(String::new(), &value.value, unit)]),
            1 if extents.is_empty() => {}
            _ if extents.is_empty() => extents.push(count as u64),
            _ => {}
        }
        let fits =
            extents.iter().try_fold(1_u64, |all, &n| all.checked_mul(n)) == Some(count as u64);
        if !fits {
            return Err(format!(
                "found {count} values for the dimensions {extents:?}, expected one for each element"
            ));
        }
        let items = value.items.iter().enumerate();
        Ok(items
            .map(|(k, item)| (indices(k as u64, &extents), &*item.value, unit))
            .collect())
    }
}

/// Indices of the element of this number, row by row, as FMI writes them; nothing of a single value.
fn indices(mut element: u64, extents: &[u64]) -> String {
    let mut texts = Vec::new();
    for extent in extents.iter().rev() {
        texts.push((element % extent + 1).to_string());
        element /= extent;
    }
    texts.reverse();
    match texts.is_empty() {
        true => String::new(),
        false => format!("[{}]", texts.join(",")),
    }
}

/// Type and value of a parameter, or what stands beside it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) enum Content {
    #[serde(
        rename = "ssv:Real",
        alias = "Real",
        alias = "Float64",
        alias = "Float32"
    )]
    Real(Text),
    #[serde(
        rename = "ssv:Integer",
        alias = "Integer",
        alias = "Int8",
        alias = "UInt8",
        alias = "Int16",
        alias = "UInt16",
        alias = "Int32",
        alias = "UInt32",
        alias = "Int64",
        alias = "UInt64"
    )]
    Integer(Text),
    #[serde(rename = "ssv:Boolean", alias = "Boolean")]
    Boolean(Text),
    #[serde(rename = "ssv:String", alias = "String")]
    String(Text),
    #[serde(rename = "ssv:Enumeration", alias = "Enumeration")]
    Enumeration(Text),
    #[serde(rename = "ssv:Binary", alias = "Binary")]
    Binary(Text),
    #[serde(rename = "Dimension", skip_serializing)]
    Dimension(Extent),
    #[serde(other)]
    Other,
}

/// Extent of an array in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub(in crate::ssp) struct Extent {
    #[serde(rename = "@size", with = "lexical")]
    size: u64,
}

/// One of several texts.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub(in crate::ssp) struct Item {
    #[serde(rename = "@value")]
    value: String,
}

/// A value as it is written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::ssp) struct Text {
    #[serde(rename = "@value", default)]
    value: String,
    #[serde(rename = "@unit", skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
    #[serde(rename = "Value", default, skip_serializing)]
    items: Vec<Item>,
}

impl Text {
    /// One value.
    pub(in crate::ssp) fn new(value: String, unit: Option<String>) -> Self {
        let items = Vec::new();
        Self { value, unit, items }
    }
}

impl From<String> for Text {
    fn from(value: String) -> Self {
        Self::new(value, None)
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
