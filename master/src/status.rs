//! What calls answer, and where an instance is in its life.

use std::ffi::c_int;
use std::fmt;

use serde::{Deserialize, Serialize};

/// A status as it arrives: perhaps none of the standard.
pub(crate) type RawStatus = c_int;

/// What a function of the interface says about its work: `fmi2Status`, `fmi3Status`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Status {
    /// All well.
    Ok,
    /// Not quite right, but the simulation can go on.
    Warning,
    /// The call was refused, or a step was done in part only; nothing is broken.
    Discard,
    /// This instance cannot go on; it can be reset, restored or freed.
    Error,
    /// All instances of the FMU are beyond repair; none may be called again, not even to free it.
    Fatal,
    /// A step is still under way.
    Pending,
}

impl Status {
    pub(crate) fn from_raw(raw: RawStatus) -> Option<Self> {
        Some(match raw {
            0 => Self::Ok,
            1 => Self::Warning,
            2 => Self::Discard,
            3 => Self::Error,
            4 => Self::Fatal,
            5 => Self::Pending,
            _ => return None,
        })
    }
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Ok => "OK",
            Self::Warning => "Warning",
            Self::Discard => "Discard",
            Self::Error => "Error",
            Self::Fatal => "Fatal",
            Self::Pending => "Pending",
        })
    }
}

/// Where an instance is in its life: section 4.2.4 of FMI 2.0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made, not yet initialized.
    Instantiated,
    /// In initialization mode.
    Initialization,
    /// At a communication point.
    Stepping,
    /// In event mode, of FMI 3.0.
    Event,
    /// After a step that was discarded.
    Discarded,
    /// After a call that returned `Error`.
    Failed,
    /// Terminated.
    Terminated,
    /// After a call of any instance of the FMU that returned `Fatal`.
    Dead,
}

impl fmt::Display for Phase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Instantiated => "instantiated",
            Self::Initialization => "in initialization mode",
            Self::Stepping => "at a communication point",
            Self::Event => "in event mode",
            Self::Discarded => "after a discarded step",
            Self::Failed => "after an error",
            Self::Terminated => "terminated",
            Self::Dead => "beyond repair",
        })
    }
}
