//! Interfaces that a unit offers, with their capabilities.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::lexical::{self, is_false, is_zero};

/// The co-simulation interface and what it is able to do.
///
/// Every flag is false and every number 0 if absent.
#[apply(
    crate = "serde_with_macros",
    bool => #[serde(default, skip_serializing_if = "is_false", with = "lexical")],
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Option<f64> => #[serde(default, with = "lexical::optional")],
    u32 => #[serde(default, skip_serializing_if = "is_zero", with = "lexical")],
)]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CoSimulation {
    /// Name of the shared library without suffix: a C identifier.
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
    /// A tool must be installed to run the unit.
    #[serde(rename = "@needsExecutionTool")]
    pub needs_execution_tool: bool,
    /// A process can hold one instance only.
    #[serde(rename = "@canBeInstantiatedOnlyOncePerProcess")]
    pub can_be_instantiated_only_once_per_process: bool,
    /// The state can be saved and restored.
    #[serde(rename = "@canGetAndSetFMUState")]
    pub can_get_and_set_fmu_state: bool,
    /// The state can be turned into bytes and back.
    #[serde(rename = "@canSerializeFMUState")]
    pub can_serialize_fmu_state: bool,
    /// Directional derivatives are available.
    #[serde(rename = "@providesDirectionalDerivatives")]
    pub provides_directional_derivatives: bool,
    /// Adjoint derivatives are available.
    #[serde(rename = "@providesAdjointDerivatives")]
    pub provides_adjoint_derivatives: bool,
    /// Dependencies are known for each element of an array.
    #[serde(rename = "@providesPerElementDependencies")]
    pub provides_per_element_dependencies: bool,
    /// Communication steps need not all have one length.
    #[serde(rename = "@canHandleVariableCommunicationStepSize")]
    pub can_handle_variable_communication_step_size: bool,
    /// Length of the internal steps, if all have one \[s\].
    #[serde(rename = "@fixedInternalStepSize")]
    pub fixed_internal_step_size: Option<f64>,
    /// Highest order of the time derivatives of outputs; 0 for none.
    #[serde(rename = "@maxOutputDerivativeOrder")]
    pub max_output_derivative_order: u32,
    /// The importer is called within a step.
    #[serde(rename = "@providesIntermediateUpdate")]
    pub provides_intermediate_update: bool,
    /// A step may end early without being asked to.
    #[serde(rename = "@mightReturnEarlyFromDoStep")]
    pub might_return_early_from_do_step: bool,
    /// A step ends early if the importer asks for it when it is called within the step.
    #[serde(rename = "@canReturnEarlyAfterIntermediateUpdate")]
    pub can_return_early_after_intermediate_update: bool,
    /// There is an event mode.
    #[serde(rename = "@hasEventMode")]
    pub has_event_mode: bool,
    /// Discrete states can be evaluated without an update.
    #[serde(rename = "@providesEvaluateDiscreteStates")]
    pub provides_evaluate_discrete_states: bool,
}

impl CoSimulation {
    /// An interface that can do nothing beyond what every one must.
    pub fn new(model_identifier: impl Into<String>) -> Self {
        Self {
            model_identifier: model_identifier.into(),
            ..Self::default()
        }
    }
}

/// An interface of another kind: that it is offered, not what it is able to do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct OtherInterface {
    /// Name of the shared library without suffix: a C identifier.
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
}
