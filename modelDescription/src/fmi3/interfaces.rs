//! Interfaces that a unit offers, with their capabilities.

use serde::{Deserialize, Serialize};

use crate::lexical::{self, is_false, is_zero};

/// The co-simulation interface and what it is able to do.
///
/// Every flag is false and every number 0 if absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CoSimulation {
    /// Name of the shared library without suffix: a C identifier.
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
    /// A tool must be installed to run the unit.
    #[serde(
        rename = "@needsExecutionTool",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub needs_execution_tool: bool,
    /// A process can hold one instance only.
    #[serde(
        rename = "@canBeInstantiatedOnlyOncePerProcess",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub can_be_instantiated_only_once_per_process: bool,
    /// The state can be saved and restored.
    #[serde(
        rename = "@canGetAndSetFMUState",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub can_get_and_set_fmu_state: bool,
    /// The state can be turned into bytes and back.
    #[serde(
        rename = "@canSerializeFMUState",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub can_serialize_fmu_state: bool,
    /// Directional derivatives are available.
    #[serde(
        rename = "@providesDirectionalDerivatives",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub provides_directional_derivatives: bool,
    /// Adjoint derivatives are available.
    #[serde(
        rename = "@providesAdjointDerivatives",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub provides_adjoint_derivatives: bool,
    /// Dependencies are known for each element of an array.
    #[serde(
        rename = "@providesPerElementDependencies",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub provides_per_element_dependencies: bool,
    /// Communication steps need not all have one length.
    #[serde(
        rename = "@canHandleVariableCommunicationStepSize",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub can_handle_variable_communication_step_size: bool,
    /// Length of the internal steps, if all have one \[s\].
    #[serde(
        rename = "@fixedInternalStepSize",
        default,
        skip_serializing_if = "Option::is_none",
        with = "lexical::optional"
    )]
    pub fixed_internal_step_size: Option<f64>,
    /// Highest order of the time derivatives of outputs; 0 for none.
    #[serde(
        rename = "@maxOutputDerivativeOrder",
        default,
        skip_serializing_if = "is_zero",
        with = "lexical"
    )]
    pub max_output_derivative_order: u32,
    /// The importer is called within a step.
    #[serde(
        rename = "@providesIntermediateUpdate",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub provides_intermediate_update: bool,
    /// A step may end early without being asked to.
    #[serde(
        rename = "@mightReturnEarlyFromDoStep",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub might_return_early_from_do_step: bool,
    /// A step ends early if the importer asks for it when it is called within the step.
    #[serde(
        rename = "@canReturnEarlyAfterIntermediateUpdate",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub can_return_early_after_intermediate_update: bool,
    /// There is an event mode.
    #[serde(
        rename = "@hasEventMode",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
    pub has_event_mode: bool,
    /// Discrete states can be evaluated without an update.
    #[serde(
        rename = "@providesEvaluateDiscreteStates",
        default,
        skip_serializing_if = "is_false",
        with = "lexical"
    )]
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
