//! Other numbers of a scene from one step to the next.

use std::sync::Arc;

use crate::scene::{Motion, Scene};
use crate::simulation::Simulation;

impl Scene {
    /// This scene with all that a run takes between two steps from `other`, the same scene with other values of its tunable
    /// parameters: how materials touch, loads, sources' rates and speeds, loads and dampers of driven bodies. Settings stay;
    /// gravity is [`Simulation::set_gravity`]'s.
    #[must_use]
    pub fn tuned(&self, other: &Self) -> Self {
        let mut scene = self.clone();
        scene.pairs.clone_from(&other.pairs);
        scene.parameters.clone_from(&other.parameters);
        for (own, new) in scene.loads.iter_mut().zip(&other.loads) {
            own.force = new.force;
        }
        for (own, new) in scene.sources.iter_mut().zip(&other.sources) {
            (own.supply, own.twist) = (new.supply, new.twist);
        }
        for (own, new) in scene.boundaries.iter_mut().zip(&other.boundaries) {
            if let (Motion::Driven(own), Motion::Driven(new)) = (&mut own.motion, &new.motion) {
                (own.force, own.torque, own.damping) = (new.force, new.torque, new.damping);
                own.servo.clone_from(&new.servo);
            }
        }
        scene
    }
}

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
        self.replay = None;
        self.workspace.forget_scene();
        self.scene = scene;
    }
}
