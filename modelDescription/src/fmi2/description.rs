//! The root element of a description, and what stands directly in it.

use super::{CoSimulation, ModelExchange, ModelStructure, ScalarVariable, SimpleType};
use crate::list::list_element;
use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::lexical;
use crate::units::Unit;
use crate::xml::{self, Error};

/// The one value of `fmiVersion` that FMI 2.0 allows, also for 2.0.1 to 2.0.5.
pub const FMI_VERSION: &str = "2.0";

/// Name of the root element.
pub(crate) const ROOT: &str = "fmiModelDescription";

list_element!(unit_list, crate::units::Unit, "Unit");
list_element!(type_list, super::SimpleType, "SimpleType");
list_element!(category_list, super::LogCategory, "Category");
list_element!(variable_list, super::ScalarVariable, "ScalarVariable");

/// The root element `fmiModelDescription`.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Vec<Unit> => #[serde(default, skip_serializing_if = "Vec::is_empty")],
    Vec<SimpleType> => #[serde(default, skip_serializing_if = "Vec::is_empty")],
    Vec<LogCategory> => #[serde(default, skip_serializing_if = "Vec::is_empty")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModelDescription {
    /// Version of the standard: [`FMI_VERSION`].
    #[serde(rename = "@fmiVersion")]
    pub fmi_version: String,
    /// Name of the model, for people.
    #[serde(rename = "@modelName")]
    pub model_name: String,
    /// Fingerprint that ties this description to its shared library.
    #[serde(rename = "@guid")]
    pub guid: String,
    /// One line about the model.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Who made the model.
    #[serde(rename = "@author")]
    pub author: Option<String>,
    /// Version of the model.
    #[serde(rename = "@version")]
    pub version: Option<String>,
    /// Copyright notice.
    #[serde(rename = "@copyright")]
    pub copyright: Option<String>,
    /// License of the model.
    #[serde(rename = "@license")]
    pub license: Option<String>,
    /// Tool that wrote the description.
    #[serde(rename = "@generationTool")]
    pub generation_tool: Option<String>,
    /// When it was written: `2009-12-08T14:33:22Z`.
    #[serde(rename = "@generationDateAndTime")]
    pub generation_date_and_time: Option<String>,
    /// Form of the variable names; [`NamingConvention::Flat`] if absent.
    #[serde(rename = "@variableNamingConvention", default)]
    pub variable_naming_convention: NamingConvention,
    /// The model exchange interface, if offered.
    #[serde(rename = "ModelExchange")]
    pub model_exchange: Option<ModelExchange>,
    /// The co-simulation interface, if offered.
    #[serde(rename = "CoSimulation")]
    pub co_simulation: Option<CoSimulation>,
    /// Units that variables and types refer to.
    #[serde(rename = "UnitDefinitions", with = "unit_list")]
    pub unit_definitions: Vec<Unit>,
    /// Types that variables refer to.
    #[serde(rename = "TypeDefinitions", with = "type_list")]
    pub type_definitions: Vec<SimpleType>,
    /// Categories of log messages.
    #[serde(rename = "LogCategories", with = "category_list")]
    pub log_categories: Vec<LogCategory>,
    /// Suggested experiment.
    #[serde(rename = "DefaultExperiment")]
    pub default_experiment: Option<DefaultExperiment>,
    /// The variables; the first has the index 1.
    #[serde(rename = "ModelVariables", with = "variable_list")]
    pub model_variables: Vec<ScalarVariable>,
    /// Outputs, derivatives and initial unknowns.
    #[serde(rename = "ModelStructure")]
    pub model_structure: ModelStructure,
}

impl ModelDescription {
    /// A co-simulation description with structured names and nothing else in it.
    pub fn new(
        model_name: impl Into<String>,
        guid: impl Into<String>,
        co_simulation: CoSimulation,
    ) -> Self {
        Self {
            fmi_version: FMI_VERSION.to_owned(),
            model_name: model_name.into(),
            guid: guid.into(),
            description: None,
            author: None,
            version: None,
            copyright: None,
            license: None,
            generation_tool: None,
            generation_date_and_time: None,
            variable_naming_convention: NamingConvention::Structured,
            model_exchange: None,
            co_simulation: Some(co_simulation),
            unit_definitions: Vec::new(),
            type_definitions: Vec::new(),
            log_categories: Vec::new(),
            default_experiment: None,
            model_variables: Vec::new(),
            model_structure: ModelStructure::default(),
        }
    }

    /// Sets the variables and the model structure that follows from them; see
    /// [`ModelStructure::from_variables`].
    #[must_use]
    pub fn with_variables(mut self, variables: Vec<ScalarVariable>) -> Self {
        self.model_structure = ModelStructure::from_variables(&variables);
        self.model_variables = variables;
        self
    }

    /// Reads a description; a byte order mark in front is allowed.
    ///
    /// Elements and attributes beyond the schema are skipped. FMI 2.0 has no
    /// namespaces: prefixes of names are not looked at. The result is what
    /// stands there, not necessarily valid: ask [`validate`](Self::validate).
    ///
    /// # Errors
    ///
    /// Every variant of [`Error`] but [`Error::Character`] and [`Error::Write`].
    pub fn from_xml(text: &str) -> Result<Self, Error> {
        xml::read(text, ROOT, FMI_VERSION)
    }

    /// Writes the description: UTF-8, indented, elements and attributes in the
    /// order of the schema, real numbers as the shortest text that reads back to
    /// the same value. The same description always gives the same bytes.
    ///
    /// Nothing is validated.
    ///
    /// # Errors
    ///
    /// [`Error::Character`] if a text holds a character that XML 1.0 does not
    /// allow, [`Error::Write`] if the serializer fails.
    pub fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, ROOT)
    }
}

/// Form of the names of variables and types.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum NamingConvention {
    /// Any text without line feed, carriage return and tab.
    #[default]
    Flat,
    /// Hierarchical names; see [`crate::names`].
    Structured,
}

/// A category of log messages.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct LogCategory {
    /// Name, as the logger passes it; for example `logStatusError`.
    #[serde(rename = "@name")]
    pub name: String,
    /// What is logged under it.
    #[serde(rename = "@description")]
    pub description: Option<String>,
}

impl LogCategory {
    /// A category with its description.
    pub fn new(name: impl Into<String>, description: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            description: Some(description.into()),
        }
    }
}

/// Suggested experiment. Times are in the unit of the independent variable, `[s]`
/// unless the description defines another.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<f64> => #[serde(default, with = "lexical::optional")],
)]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct DefaultExperiment {
    /// Start; importers take 0 if absent.
    #[serde(rename = "@startTime")]
    pub start_time: Option<f64>,
    /// Stop.
    #[serde(rename = "@stopTime")]
    pub stop_time: Option<f64>,
    /// Relative tolerance, dimensionless.
    #[serde(rename = "@tolerance")]
    pub tolerance: Option<f64>,
    /// Preferred length of a communication step.
    #[serde(rename = "@stepSize")]
    pub step_size: Option<f64>,
}
