//! What the steps so far say about the next.

use serde::{Deserialize, Serialize};

/// What the steps so far say about the next.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct StepControl {
    /// Internal step wanted next \[s\].
    pub step: f64,
    /// Steps that are still taken as they are if they do not converge.
    pub(crate) accepting: u32,
    /// Whether the last change made steps shorter.
    pub(crate) shorter: bool,
    /// Steps of this length, the time they took \[s\], and their cost in sweeps.
    pub(crate) taken: u32,
    pub(crate) time: f64,
    pub(crate) cost: f64,
    /// Cost of simulated time with the length before \[sweeps/s\]; 0 at first.
    pub(crate) rate: f64,
}
