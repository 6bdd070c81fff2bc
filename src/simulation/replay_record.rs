//! Where a state came from, so that its last communication step can be taken again.

use super::impulse_totals::ImpulseTotals;
use super::trajectory::Trajectory;
use crate::spatial::Wrench;
use crate::state::SharedState;
use serde::{Deserialize, Serialize};

/// Where a state came from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum ReplayRecord {
    /// The start of a run: from this state, before overlaps were removed and forces solved.
    Start(SharedState),
    /// A communication step.
    Step(Box<Step>),
}

/// Everything to take a communication step again. Where commands changed within it, from the internal step at which they last
/// did.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Step {
    pub(super) state: SharedState,
    /// Start of the communication step \[s\].
    pub(super) start: f64,
    pub(super) trajectory: Trajectory,
    /// Averages of the communication step before, `[B]`: those of `state` may be of the same one.
    pub(super) averages: Vec<Wrench>,
    /// What had been summed up before `state`.
    pub(super) before: ImpulseTotals,
    /// Ends of the internal steps from `state` on \[s\].
    pub(super) taken: Vec<(f64, f64)>,
}

impl ReplayRecord {
    pub(super) fn state(&self) -> &SharedState {
        match self {
            Self::Start(state) => state,
            Self::Step(step) => &step.state,
        }
    }

    /// Its state, for the memory.
    pub(super) fn into_state(self) -> SharedState {
        match self {
            Self::Start(state) => state,
            Self::Step(step) => step.state,
        }
    }

    pub(super) fn fits(&self, boundaries: usize) -> bool {
        match self {
            Self::Start(_) => true,
            Self::Step(step) => {
                step.trajectory.fits(boundaries)
                    && step.before.fits(boundaries)
                    && step.averages.len() == boundaries
            }
        }
    }
}
