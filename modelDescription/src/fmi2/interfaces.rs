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
    u32 => #[serde(default, skip_serializing_if = "is_zero", with = "lexical")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct CoSimulation {
    /// Name of the shared library without suffix: a C identifier.
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
    /// A tool must be installed to run the unit.
    #[serde(rename = "@needsExecutionTool")]
    pub needs_execution_tool: bool,
    /// Communication steps need not all have one length.
    #[serde(rename = "@canHandleVariableCommunicationStepSize")]
    pub can_handle_variable_communication_step_size: bool,
    /// Time derivatives of inputs can be set.
    #[serde(rename = "@canInterpolateInputs")]
    pub can_interpolate_inputs: bool,
    /// Highest order of the time derivatives of outputs; 0 for none.
    #[serde(rename = "@maxOutputDerivativeOrder")]
    pub max_output_derivative_order: u32,
    /// A step may return before it is done. The standard spells it this way.
    #[serde(rename = "@canRunAsynchronuously")]
    pub can_run_asynchronuously: bool,
    /// A process can hold one instance only.
    #[serde(rename = "@canBeInstantiatedOnlyOncePerProcess")]
    pub can_be_instantiated_only_once_per_process: bool,
    /// The unit does not use the importer's memory functions.
    #[serde(rename = "@canNotUseMemoryManagementFunctions")]
    pub can_not_use_memory_management_functions: bool,
    /// The state can be saved and restored.
    #[serde(rename = "@canGetAndSetFMUstate")]
    pub can_get_and_set_fmu_state: bool,
    /// The state can be turned into bytes and back.
    #[serde(rename = "@canSerializeFMUstate")]
    pub can_serialize_fmu_state: bool,
    /// Directional derivatives are available at communication points.
    #[serde(rename = "@providesDirectionalDerivative")]
    pub provides_directional_derivative: bool,
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

/// The model exchange interface: that it is offered, not what it is able to do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ModelExchange {
    /// Name of the shared library without suffix: a C identifier.
    #[serde(rename = "@modelIdentifier")]
    pub model_identifier: String,
}
