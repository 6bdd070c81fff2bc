//! A communication step that is taken again, with replicas to either side.

use super::Simulation;
use crate::Vec3;
use crate::contact::ContactForce;
use crate::error::StepError;
use crate::simulation::impulse_totals::{Before, ImpulseTotals};
use crate::simulation::replay_record::Step;
use crate::simulation::trajectory::Trajectory;
use crate::state::{SharedState, State};
use crate::step::{Effort, Replica, Workspace, start_with_replicas, step_with_replicas};
use std::sync::Arc;

/// A simulation that takes the step of a [`ReplayRecord`] again.
pub(super) struct ReplayedSimulation {
    pub(super) simulation: Simulation,
    pub(super) trajectory: Trajectory,
    pub(super) totals: ImpulseTotals,
}

impl ReplayedSimulation {
    pub(super) fn of(of: &Simulation, replay: &Step, trajectory: Trajectory) -> Self {
        let mut simulation = of.at(replay.state.clone());
        simulation.state.commands.clone_from(&trajectory.commands);
        Self {
            simulation,
            trajectory,
            totals: replay.before.clone(),
        }
    }

    /// Sums up the internal step of `dt` \[s\] that has led to `target` \[s\].
    pub(super) fn book(&mut self, before: &Before, target: f64, dt: f64) {
        self.simulation.state.time = target;
        self.simulation.book(before, dt, &mut self.totals);
    }

    /// Lets spheres come and go as in `other`, whose spheres were at `position` before that.
    pub(super) fn adopt(&mut self, other: &State, position: &[Vec3]) {
        let scene = &self.simulation.scene;
        if scene.sources.is_empty() && scene.sinks.is_empty() {
            return;
        }
        let own = &mut self.simulation.state;
        for (i, before) in position.iter().enumerate() {
            let now = &other.kinematics;
            if now.position[i] == *before && now.present[i] == own.kinematics.present[i] {
                continue;
            }
            own.kinematics.present[i] = now.present[i];
            own.kinematics.position[i] = now.position[i];
            own.kinematics.orientation[i] = now.orientation[i];
            own.kinematics.velocity[i] = now.velocity[i];
            own.kinematics.spin[i] = now.spin[i];
            own.smooth[i] = other.smooth[i];
            if let (Some(own), Some(other)) = (own.external.get_mut(i), other.external.get(i)) {
                *own = *other;
            }
        }
        own.contacts.retain(|key| {
            let known = |other: &ContactForce| other.key.cmp(key);
            other.contacts.binary_search_by(known).is_ok()
        });
        own.reserves.clone_from(&other.reserves);
        own.emitted.clone_from(&other.emitted);
        own.removed.clone_from(&other.removed);
    }
}

impl Simulation {
    /// A simulation of the same scene in another state.
    pub(super) fn at(&self, state: SharedState) -> Self {
        Self {
            scene: Arc::clone(&self.scene),
            state,
            workspace: Workspace::default(),
            replay: None,
        }
    }

    /// Starts the run from `state` again, and with it `pairs` of states to either side.
    pub(super) fn start_again(
        &self,
        state: &State,
        pairs: &mut [[&mut State; 2]],
    ) -> Result<(), StepError> {
        let scene = &self.scene;
        let (mut state, mut workspace) = (state.clone(), Workspace::default());
        start_with_replicas(scene, &mut state, &mut workspace, pairs)
            .map_err(|failure| self.explain(failure, scene.settings.step, 0))?;
        for state in pairs.iter_mut().flatten() {
            state.mean_wrenches.clone_from(&state.wrenches);
        }
        Ok(())
    }

    /// Takes the step of `replay` again, and with it `pairs`, which start from `replay` with other commands; `see` is called
    /// after every internal step, with the state before it.
    pub(super) fn replay(
        &self,
        replay: &Step,
        pairs: &mut [[ReplayedSimulation; 2]],
        mut see: impl FnMut(&SharedState, &Self),
    ) -> Result<Self, StepError> {
        let scene = &self.scene;
        let mut again = ReplayedSimulation::of(self, replay, replay.trajectory.clone());
        let effort = Effort {
            sweeps: None,
            accept: !scene.settings.strict,
            pass: !scene.settings.strict,
        };
        for &(target, dt) in &replay.taken {
            let earlier = again.simulation.state.clone();
            let start = earlier.time;
            let before = Before::of(scene, &earlier);
            let befores: Vec<[Before; 2]> = pairs
                .iter()
                .map(|pair| [0, 1].map(|k| Before::of(scene, &pair[k].simulation.state)))
                .collect();
            let integrator = scene.settings.integrator;
            let paths = again.trajectory.paths(scene);
            let input = paths.step_input(integrator, start, (target, dt));
            let mut replica: Vec<[Replica; 2]> = pairs
                .iter_mut()
                .map(|pair| {
                    pair.each_mut().map(|replica| {
                        let paths = replica.trajectory.paths(scene);
                        Replica {
                            input: paths.step_input(integrator, start, (target, dt)),
                            state: &mut replica.simulation.state,
                        }
                    })
                })
                .collect();
            let Simulation {
                state, workspace, ..
            } = &mut again.simulation;
            step_with_replicas(scene, state, workspace, (&input, effort), &mut replica)
                .map_err(|failure| self.explain(failure, dt, 0))?;
            again.book(&before, target, dt);
            let position = again.simulation.state.kinematics.position.clone();
            again.simulation.exchange();
            for (pair, befores) in pairs.iter_mut().zip(&befores) {
                for (replica, before) in pair.iter_mut().zip(befores) {
                    replica.book(before, target, dt);
                    replica.adopt(&again.simulation.state, &position);
                }
            }
            see(&earlier, &again.simulation);
        }
        for replica in pairs.iter_mut().flatten() {
            replica.simulation.average(&replica.totals);
        }
        again.simulation.average(&again.totals);
        Ok(again.simulation)
    }
}
