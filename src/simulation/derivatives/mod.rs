//! Derivatives of what is measured, at the end of a communication step: by time ([`Simulation::time_derivatives`]) and by the commands
//! held over that step ([`Simulation::directional_derivatives`]); at the start of a run by the commands that place its boundaries.
//!
//! A step costs nothing for them: it only leaves its start behind, [`Origin`], and is taken again when a derivative is asked
//! for. Steps are deterministic, so this is the same step, bit for bit. Within a step there are no
//! derivatives.

mod drift;
mod sensitivity;

pub use sensitivity::Direction;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Simulation;
use super::march::{Account, Before, Course};
use crate::Vec3;
use crate::contact::Load;
use crate::error::{SnapshotError, StepError};
use crate::spatial::Pose;
use crate::state::State;
use crate::step::{Beside, Effort, Scratch, step_beside};

/// Where a state came from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Origin {
    /// The start of a run: from this state, before overlaps were removed and forces solved.
    Start(State),
    /// A communication step.
    Step(Step),
}

/// Everything to take a communication step again. Where commands changed within it, from the internal step at which they last
/// did.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Step {
    pub(super) state: State,
    /// Start of the communication step \[s\].
    pub(super) start: f64,
    pub(super) course: Course,
    /// What had been summed up before `state`.
    pub(super) before: Account,
    /// Ends of the internal steps from `state` on \[s\].
    pub(super) taken: Vec<(f64, f64)>,
}

impl Origin {
    fn state(&self) -> &State {
        match self {
            Self::Start(state) => state,
            Self::Step(step) => &step.state,
        }
    }

    /// Its state, for the memory.
    pub(super) fn into_state(self) -> State {
        match self {
            Self::Start(state) => state,
            Self::Step(step) => step.state,
        }
    }

    fn fits(&self, boundaries: usize) -> bool {
        match self {
            Self::Start(_) => true,
            Self::Step(step) => step.course.fits(boundaries) && step.before.fits(boundaries),
        }
    }
}

impl Simulation {
    /// Where the present state came from: with [`Self::snapshot`] a state that keeps its derivatives. `None` after
    /// [`Self::restore`], within a communication step, and after one that was given up or that [`Self::advance_to`] has failed to take.
    #[must_use]
    pub fn origin(&self) -> Option<&Origin> {
        self.origin.as_deref()
    }

    /// [`Self::origin`], which derivatives cannot do without.
    fn came_from(&self) -> Result<&Origin, StepError> {
        self.origin().ok_or_else(|| StepError::Argument {
            what: "derivatives",
            found: "a state that was restored, or that no whole step has led to".to_owned(),
            expected: "a communication step before them",
        })
    }

    /// [`Self::restore`], with the [`Self::origin`] that the state had.
    ///
    /// # Errors
    /// As [`Self::restore`].
    pub fn resume(&mut self, blob: &[u8], origin: Option<Origin>) -> Result<(), SnapshotError> {
        if let Some(origin) = &origin {
            self.check_counts(origin.state())?;
            if !origin.fits(self.scene.boundaries.len()) {
                return Err(SnapshotError::Format(
                    "its last step has another number of boundaries than the scene",
                ));
            }
        }
        self.restore(blob)?;
        self.origin = origin.map(Box::new);
        Ok(())
    }

    /// A simulation of the same scene in another state.
    fn at(&self, state: State) -> Self {
        Self {
            scene: Arc::clone(&self.scene),
            state,
            scratch: Scratch::default(),
            origin: None,
        }
    }

    /// Takes the step of `origin` again, and beside it `pairs`, which start from `origin` with other commands; `see` is called
    /// after every internal step, with the state before it.
    fn replay(
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
            let poses = again.prepare(start, target);
            let mut beside: Vec<[Beside; 2]> = pairs
                .iter_mut()
                .map(|pair| {
                    pair.each_mut().map(|companion| Beside {
                        poses: companion.prepare(start, target),
                        state: &mut companion.simulation.state,
                    })
                })
                .collect();
            let Simulation { state, scratch, .. } = &mut again.simulation;
            step_beside(scene, state, scratch, (dt, poses, effort), &mut beside)
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

/// A simulation that takes the step of an [`Origin`] again.
struct Companion {
    simulation: Simulation,
    course: Course,
    account: Account,
}

impl Companion {
    fn of(of: &Simulation, origin: &Step, course: Course) -> Self {
        let mut simulation = of.at(origin.state.clone());
        simulation.state.commands.clone_from(&course.commands);
        Self {
            simulation,
            course,
            account: origin.before.clone(),
        }
    }

    /// Commands for an internal step from `start` to `target` \[s\], and the poses at its end.
    fn prepare(&mut self, start: f64, target: f64) -> Vec<Pose> {
        let scene = &self.simulation.scene;
        let drive = self.course.drive(scene);
        let commands = drive.commands(scene.settings.integrator, start, target - start);
        let poses = drive.poses(target);
        if let Some(commands) = commands {
            self.simulation.state.commands = commands;
        }
        poses
    }

    /// Sums up the internal step of `dt` \[s\] that has led to `target` \[s\].
    fn book(&mut self, before: &Before, target: f64, dt: f64) {
        self.simulation.state.time = target;
        self.simulation.book(before, dt, &mut self.account);
        let commands = &mut self.simulation.state.commands;
        commands.clone_from(&self.course.commands);
    }

    /// Lets spheres come and go as in `other`, whose spheres were at `position` before that.
    fn adopt(&mut self, other: &State, position: &[Vec3]) {
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
