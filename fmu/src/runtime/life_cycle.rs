//! The life cycle of an instance, as both versions of the standard draw it.

use std::fmt;

/// Place in the life cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum LifeCycle {
    /// Made, nothing set up.
    Instantiated,
    /// Initialization mode.
    Initialization,
    /// Ready for a step.
    StepComplete,
    /// The last step was discarded; the state is that before it.
    StepFailed,
    /// Only reading, reset and restoring are left.
    Error,
    /// The end.
    Terminated,
    /// Between two internal steps of a step, while the importer is called; never saved.
    Intermediate,
}

impl fmt::Display for LifeCycle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Instantiated => "instantiated",
            Self::Initialization => "initialization mode",
            Self::StepComplete => "step complete",
            Self::StepFailed => "step failed",
            Self::Error => "error",
            Self::Terminated => "terminated",
            Self::Intermediate => "intermediate update mode",
        })
    }
}
