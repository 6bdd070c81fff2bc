//! The model description of either version, and what the master asks of it.

use sphere_dda_model_description::Error as XmlError;
use sphere_dda_model_description::fmi2::DefaultExperiment;
use sphere_dda_model_description::{fmi2, fmi3};

/// The model description of an FMU.
#[derive(Debug, Clone, PartialEq)]
#[allow(
    clippy::large_enum_variant,
    reason = "there is one for each FMU, and it is never moved about"
)]
pub enum Description {
    /// Of FMI 2.0.
    Two(fmi2::ModelDescription),
    /// Of FMI 3.0.
    Three(fmi3::ModelDescription),
}

/// The co-simulation interface, as far as both versions have it.
struct Interface<'a> {
    model_identifier: &'a str,
    only_one_instance: bool,
    variable_step: bool,
    states: bool,
    events: bool,
}

impl Description {
    /// Reads the text of a description of either version.
    pub(crate) fn from_xml(text: &str) -> Result<Self, XmlError> {
        match fmi2::ModelDescription::from_xml(text) {
            Ok(description) => Ok(Self::Two(description)),
            Err(XmlError::Version { found, .. }) if found.trim().starts_with('3') => {
                fmi3::ModelDescription::from_xml(text).map(Self::Three)
            }
            Err(error) => Err(error),
        }
    }

    /// That of FMI 2.0, if it is one.
    pub fn version_2(&self) -> Option<&fmi2::ModelDescription> {
        match self {
            Self::Two(description) => Some(description),
            Self::Three(_) => None,
        }
    }

    /// That of FMI 3.0, if it is one.
    pub fn version_3(&self) -> Option<&fmi3::ModelDescription> {
        match self {
            Self::Two(_) => None,
            Self::Three(description) => Some(description),
        }
    }

    /// Name of the model.
    pub fn model_name(&self) -> &str {
        match self {
            Self::Two(description) => &description.model_name,
            Self::Three(description) => &description.model_name,
        }
    }

    /// What ties the description to its library: the guid or instantiation token.
    pub fn token(&self) -> &str {
        match self {
            Self::Two(description) => &description.guid,
            Self::Three(description) => &description.instantiation_token,
        }
    }

    /// Whether a tool whose name begins with `name` has made it, as it says itself.
    pub(crate) fn is_of(&self, name: &str) -> bool {
        let tool = match self {
            Self::Two(description) => &description.generation_tool,
            Self::Three(description) => &description.generation_tool,
        };
        tool.as_deref().is_some_and(|tool| tool.starts_with(name))
    }

    /// The suggested experiment.
    pub fn experiment(&self) -> DefaultExperiment {
        match self {
            Self::Two(description) => description.default_experiment,
            Self::Three(description) => description.default_experiment,
        }
        .unwrap_or_default()
    }

    fn co_simulation(&self) -> Option<Interface<'_>> {
        match self {
            Self::Two(description) => description.co_simulation.as_ref().map(|own| Interface {
                model_identifier: &own.model_identifier,
                only_one_instance: own.can_be_instantiated_only_once_per_process,
                variable_step: own.can_handle_variable_communication_step_size,
                states: own.can_get_and_set_fmu_state,
                events: false,
            }),
            Self::Three(description) => description.co_simulation.as_ref().map(|own| Interface {
                model_identifier: &own.model_identifier,
                only_one_instance: own.can_be_instantiated_only_once_per_process,
                variable_step: own.can_handle_variable_communication_step_size,
                states: own.can_get_and_set_fmu_state,
                events: own.has_event_mode,
            }),
        }
    }

    /// Whether co-simulation is offered.
    pub fn offers_co_simulation(&self) -> bool {
        self.co_simulation().is_some()
    }

    /// Name of the library for co-simulation; empty if that is not offered.
    pub fn model_identifier(&self) -> &str {
        self.co_simulation().map_or("", |own| own.model_identifier)
    }

    pub(crate) fn only_one_instance(&self) -> bool {
        self.co_simulation()
            .is_some_and(|own| own.only_one_instance)
    }

    /// Whether communication steps may differ in length.
    pub fn takes_any_step(&self) -> bool {
        self.co_simulation().is_some_and(|own| own.variable_step)
    }

    /// Whether the importer can handle its events.
    pub(crate) fn has_event_mode(&self) -> bool {
        self.co_simulation().is_some_and(|own| own.events)
    }

    /// Whether the state can be saved and restored.
    pub fn has_states(&self) -> bool {
        self.co_simulation().is_some_and(|own| own.states)
    }
}
