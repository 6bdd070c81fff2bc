//! A communication step that is taken again, with replicas to either side.

use super::Simulation;
use crate::Vec3;
use crate::contact::Load;
use crate::error::StepError;
use crate::simulation::impulse_totals::{Account, Before};
use crate::simulation::replay_record::Step;
use crate::simulation::trajectory::Course;
use crate::state::State;
use crate::step::{Beside, Effort, Scratch, step_beside};
use std::sync::Arc;

/// A simulation that takes the step of an [`Origin`] again.
pub(super) struct Companion {
    pub(super) simulation: Simulation,
    pub(super) course: Course,
    pub(super) account: Account,
}

impl Companion {
    pub(super) fn of(of: &Simulation, origin: &Step, course: Course) -> Self {
        let mut simulation = of.at(origin.state.clone());
        simulation.state.commands.clone_from(&course.commands);
        Self {
            simulation,
            course,
            account: origin.before.clone(),
        }
    }

    /// Sums up the internal step of `dt` \[s\] that has led to `target` \[s\].
    pub(super) fn book(&mut self, before: &Before, target: f64, dt: f64) {
        self.simulation.state.time = target;
        self.simulation.book(before, dt, &mut self.account);
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
            own.persisting[i] = other.persisting[i];
            if let (Some(own), Some(other)) = (own.external.get_mut(i), other.external.get(i)) {
                *own = *other;
            }
        }
        own.contacts.retain(|key| {
            let known = |other: &Load| other.key.cmp(key);
            other.contacts.binary_search_by(known).is_ok()
        });
        own.reserves.clone_from(&other.reserves);
        own.emitted.clone_from(&other.emitted);
        own.removed.clone_from(&other.removed);
    }
}

impl Simulation {
    /// A simulation of the same scene in another state.
    pub(super) fn at(&self, state: State) -> Self {
        Self {
            scene: Arc::clone(&self.scene),
            state,
            scratch: Scratch::default(),
            origin: None,
        }
    }

    /// Takes the step of `origin` again, and beside it `pairs`, which start from `origin` with other commands; `see` is called
    /// after every internal step, with the state before it.
    pub(super) fn replay(
        &self,
        origin: &Step,
        pairs: &mut [[Companion; 2]],
        mut see: impl FnMut(&State, &Self),
    ) -> Result<Self, StepError> {
        let scene = &self.scene;
        let mut again = Companion::of(self, origin, origin.course.clone());
        let effort = Effort {
            sweeps: None,
            accept: !scene.settings.strict,
            pass: !scene.settings.strict,
        };
        for &(target, dt) in &origin.taken {
            let earlier = again.simulation.state.clone();
            let start = earlier.time;
            let before = Before::of(scene, &earlier);
            let befores: Vec<[Before; 2]> = pairs
                .iter()
                .map(|pair| [0, 1].map(|k| Before::of(scene, &pair[k].simulation.state)))
                .collect();
            let integrator = scene.settings.integrator;
            let drive = again.course.drive(scene);
            let input = drive.step_input(integrator, start, (target, dt));
            let mut beside: Vec<[Beside; 2]> = pairs
                .iter_mut()
                .map(|pair| {
                    pair.each_mut().map(|companion| {
                        let drive = companion.course.drive(scene);
                        Beside {
                            input: drive.step_input(integrator, start, (target, dt)),
                            state: &mut companion.simulation.state,
                        }
                    })
                })
                .collect();
            let Simulation { state, scratch, .. } = &mut again.simulation;
            step_beside(scene, state, scratch, (&input, effort), &mut beside)
                .map_err(|failure| self.explain(failure, dt, 0))?;
            again.book(&before, target, dt);
            let position = again.simulation.state.kinematics.position.clone();
            again.simulation.exchange();
            for (pair, befores) in pairs.iter_mut().zip(&befores) {
                for (companion, before) in pair.iter_mut().zip(befores) {
                    companion.book(before, target, dt);
                    companion.adopt(&again.simulation.state, &position);
                }
            }
            see(&earlier, &again.simulation);
        }
        for companion in pairs.iter_mut().flatten() {
            companion.simulation.average(&companion.account);
        }
        again.simulation.average(&again.account);
        Ok(again.simulation)
    }
}
