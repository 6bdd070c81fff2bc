//! How long the next internal step is, and whether there is anything left to step.
//!
//! Between `smallest_step` and `step` the internal step follows the sweeps of the steps before: a step costs as much beside its sweeps as
//! [`EVEN`] of them, and sweeps grow faster than the step, so that simulated time is cheapest where both shares are about even. The
//! sweeps of a step are part of the state, times are not: the same steps on every machine.
//!
//! A scene in which nothing has moved faster than `rest_speed` for [`CALM`] steps comes to rest: velocities are zero and forces
//! stay until something changes from outside.

use serde::{Deserialize, Serialize};

use super::Simulation;
use crate::drive::Drive;
use crate::gravity::GravityMotion;
use crate::motion::Twist;
use crate::problem::Dof6;
use crate::scene::{Scene, Settings};
use crate::state::State;
use crate::step::StepOutcome;

/// Sweeps that cost as much as all else in a step (measured on `examples/dropped`).
const EVEN: f64 = 32.0;
/// Largest relative change of the step from one to the next.
const CHANGE: [f64; 2] = [0.8, 1.15];
/// Steps without motion after which a scene rests.
const CALM: u32 = 10;

/// What the steps so far say about the next.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Pace {
    /// Internal step wanted next \[s\].
    pub step: f64,
    /// Steps in a row without motion.
    pub calm: u32,
}

impl Pace {
    /// At the start of a run.
    pub(super) fn of(settings: &Settings) -> Self {
        Self {
            step: settings.step,
            calm: 0,
        }
    }

    /// After a step.
    pub(super) fn learn(&mut self, settings: &Settings, outcome: &StepOutcome) {
        if let Some(smallest) = settings.smallest_step {
            let sweeps = outcome.solver.sweeps.max(1) as f64;
            let change = (EVEN / sweeps).powf(0.25).clamp(CHANGE[0], CHANGE[1]);
            self.step = (self.step * change).clamp(smallest, settings.step);
        }
    }

    /// After a step that had to be halved.
    pub(super) fn cut(&mut self, settings: &Settings) {
        if let Some(smallest) = settings.smallest_step {
            self.step = (0.5 * self.step).clamp(smallest, settings.step);
        }
    }
}

impl Simulation {
    /// Counts a step without motion, or starts anew.
    pub(super) fn count_calm(&mut self) {
        let limit = self.scene.settings.rest_speed;
        if limit == 0.0 {
            return;
        }
        let radius = &self.scene.particles.radius;
        let moves = (0..radius.len()).any(|i| {
            let velocity = self.velocity(i);
            velocity.linear.norm() > limit || velocity.angular.norm() * radius[i] > limit
        });
        let pace = &mut self.state.pace;
        pace.calm = if moves { 0 } else { CALM.min(pace.calm + 1) };
    }

    /// Takes the step to `target` \[s\] at rest, if the scene rests and nothing from outside moves it until then.
    pub(super) fn rest_to(&mut self, scene: &Scene, drive: &Drive, target: f64) -> bool {
        if self.state.pace.calm < CALM || !self.is_left_alone(scene, drive, target) {
            return false;
        }
        if self.state.pace.calm == CALM {
            self.stop();
            self.state.pace.calm += 1;
        }
        self.state.last_step = target - self.state.time;
        self.state.time = target;
        self.state.report.include(&StepOutcome::default());
        true
    }

    fn is_left_alone(&self, scene: &Scene, drive: &Drive, target: f64) -> bool {
        let state = &self.state;
        let still = |b: usize| {
            let surface = scene.boundaries[b].surface_velocity(&state.poses[b], &state.commands[b]);
            surface.norm_squared() == 0.0
        };
        scene.settings.gravity_motion == GravityMotion::default()
            && scene.settings.rotating_frame.is_none()
            && scene.springs.is_empty()
            && scene.driven().next().is_none()
            && state
                .reserves
                .iter()
                .all(|reserve| reserve.waiting.is_empty())
            && (0..scene.boundaries.len()).all(still)
            && drive.poses(target) == state.poses
    }

    /// Takes all motion out; what it carried is booked as the scheme's.
    fn stop(&mut self) {
        let particles = &self.scene.particles;
        let kinetic = (0..particles.len()).map(|i| {
            let v = self.velocity(i);
            particles.kinetic_energy(i, &v.linear, &v.angular)
        });
        self.state.work.residue -= kinetic.sum::<f64>();
        self.state.kinematics.stop();
        self.state.persisting.fill(Dof6::ZERO);
        self.state.twists.fill(Twist::default());
        let State {
            wrenches,
            persisting_wrenches,
            ..
        } = &mut self.state;
        persisting_wrenches.clone_from(wrenches);
    }
}
