//! Other numbers of a scene from one step to the next.

use std::sync::Arc;

use crate::scene::Scene;
use crate::simulation::Simulation;
use crate::step::Workspace;

impl Simulation {
    /// Goes on with `scene`, which is this one [`Scene::tuned`]: no sphere moves, those asleep wake, sources have their new rate
    /// from now on. There are no derivatives of the last step any more.
    pub fn tune(&mut self, scene: Arc<Scene>) {
        let time = self.state.time;
        let sources = self.scene.sources.iter().zip(&scene.sources);
        for (reserve, (old, new)) in self.state.reserves.iter_mut().zip(sources) {
            // What has been due so far was due at the old rate.
            reserve.spent += new.due(time) - old.due(time);
        }
        self.state.wake();
        self.workspace = Workspace::default();
        self.replay = None;
        self.scene = scene;
    }
}
