//! States kept in memory.

use std::sync::Arc;

use super::{ReplayRecord, Simulation};
use crate::scene::Scene;
use crate::state::SharedState;
use crate::step::Workspace;

/// The state of a simulation, kept in memory: it shares what no step has changed since, so that keeping and restoring it copies
/// nothing. As bytes it is [`Self::snapshot`] and [`Self::replay_record`].
#[derive(Debug, Clone)]
pub struct Saved {
    scene: Arc<Scene>,
    state: SharedState,
    replay: Option<Arc<ReplayRecord>>,
}

impl Saved {
    /// The simulation in this state.
    #[must_use]
    pub fn to_simulation(&self) -> Simulation {
        Simulation {
            scene: Arc::clone(&self.scene),
            state: self.state.clone(),
            workspace: Workspace::default(),
            replay: self.replay.clone(),
        }
    }

    /// As [`Simulation::snapshot`].
    #[must_use]
    pub fn snapshot(&self) -> Vec<u8> {
        self.to_simulation().snapshot()
    }

    /// As [`Simulation::replay_record`].
    #[must_use]
    pub fn replay_record(&self) -> Option<&ReplayRecord> {
        self.replay.as_deref()
    }
}

impl Simulation {
    /// The present state, with the scene and [`Self::replay_record`], for [`Self::load`].
    #[must_use]
    pub fn save(&self) -> Saved {
        Saved {
            scene: Arc::clone(&self.scene),
            state: self.state.clone(),
            replay: self.replay.clone(),
        }
    }

    /// Goes back to what [`Self::save`] gave, of this or another simulation: its scene, its state. The continuation is the same,
    /// bit for bit.
    pub fn load(&mut self, saved: &Saved) {
        if !Arc::ptr_eq(&self.scene, &saved.scene) {
            *self = saved.to_simulation();
            return;
        }
        self.state = saved.state.clone();
        self.replay.clone_from(&saved.replay);
    }
}
