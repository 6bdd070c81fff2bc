//! The root element of a description.

use super::{
    CoSimulation, DefaultExperiment, EnumerationType, LogCategory, ModelStructure,
    NamingConvention, OtherInterface, Variable, variables,
};
use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::list::list_element;
use crate::units::Unit;
use crate::xml::{self, Error};

/// The value of `fmiVersion` that is read and written, also for 3.0.1 and 3.0.2.
pub const FMI_VERSION: &str = "3.0";

/// Name of the root element.
pub(crate) const ROOT: &str = "fmiModelDescription";

list_element!(unit_list, crate::units::Unit, "Unit");
list_element!(type_list, super::EnumerationType, "EnumerationType");
list_element!(category_list, crate::fmi2::LogCategory, "Category");

/// The root element `fmiModelDescription`.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Vec<Unit> => #[serde(default, skip_serializing_if = "Vec::is_empty")],
    Vec<EnumerationType> => #[serde(default, skip_serializing_if = "Vec::is_empty")],
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
    #[serde(rename = "@instantiationToken")]
    pub instantiation_token: String,
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
    pub model_exchange: Option<OtherInterface>,
    /// The co-simulation interface, if offered.
    #[serde(rename = "CoSimulation")]
    pub co_simulation: Option<CoSimulation>,
    /// The scheduled execution interface, if offered.
    #[serde(rename = "ScheduledExecution")]
    pub scheduled_execution: Option<OtherInterface>,
    /// Units that variables refer to.
    #[serde(rename = "UnitDefinitions", with = "unit_list")]
    pub unit_definitions: Vec<Unit>,
    /// Enumerations that variables refer to.
    #[serde(rename = "TypeDefinitions", with = "type_list")]
    pub type_definitions: Vec<EnumerationType>,
    /// Categories of log messages.
    #[serde(rename = "LogCategories", with = "category_list")]
    pub log_categories: Vec<LogCategory>,
    /// Suggested experiment.
    #[serde(rename = "DefaultExperiment")]
    pub default_experiment: Option<DefaultExperiment>,
    /// The variables.
    #[serde(rename = "ModelVariables", with = "variables::list")]
    pub model_variables: Vec<Variable>,
    /// Outputs and initial unknowns.
    #[serde(rename = "ModelStructure")]
    pub model_structure: ModelStructure,
}

impl ModelDescription {
    /// A co-simulation description with structured names and nothing else in it.
    pub fn new(
        model_name: impl Into<String>,
        instantiation_token: impl Into<String>,
        co_simulation: CoSimulation,
    ) -> Self {
        Self {
            fmi_version: FMI_VERSION.to_owned(),
            model_name: model_name.into(),
            instantiation_token: instantiation_token.into(),
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
            scheduled_execution: None,
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
    pub fn with_variables(mut self, variables: Vec<Variable>) -> Self {
        self.model_structure = ModelStructure::from_variables(&variables);
        self.model_variables = variables;
        self
    }

    /// Reads a description; see [`crate::fmi2::ModelDescription::from_xml`].
    ///
    /// # Errors
    ///
    /// Every variant of [`Error`] but [`Error::Character`] and [`Error::Write`].
    pub fn from_xml(text: &str) -> Result<Self, Error> {
        xml::read(text, ROOT, FMI_VERSION)
    }

    /// Writes the description, in the order of the schema. The same description always gives the same bytes. Nothing is
    /// validated.
    ///
    /// # Errors
    ///
    /// [`Error::Character`] if a text holds a character that XML 1.0 does not allow, [`Error::Write`] if the serializer
    /// fails.
    pub fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, ROOT)
    }
}
