//! Settling, pass after pass.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::fastest::Mover;
use super::start_loads::StartLoads;
use super::{Pass, PassKind, SettleError, SettleProgress};
use crate::error::StepError;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::simulation::Simulation;
use crate::solver::Tolerance;
use crate::spatial::SpatialVector;

/// Time in which velocities fall to 1/e in the first pass and in the others, over the time that counts as rest.
const COARSE_DAMPING: f64 = 20.0;
const FINE_DAMPING: f64 = 2.0;

/// Where settling stands.
pub(super) struct Progress<W> {
    watch: W,
    /// The pass under way.
    pub(super) pass: Pass,
    /// Time simulated in all passes \[s\].
    pub(super) time: f64,
    limit: f64,
    /// As the scene has them.
    tolerance: Tolerance,
}

/// What a pass has come to.
pub(super) struct Reached {
    pub(super) simulation: Simulation,
    /// Largest speed at its end \[m/s\].
    pub(super) speed: f64,
    /// What has it; `None`: nothing moves.
    pub(super) mover: Option<Mover>,
    pub(super) rest_speed: f64,
    /// Whether who watches has ended it.
    pub(super) ended: bool,
}

impl<W: FnMut(&SettleProgress<'_>) -> ControlFlow<()>> Progress<W> {
    /// Before the first pass over `scene`, all of which take at most `limit` \[s\].
    pub(super) fn new(scene: &Scene, limit: f64, watch: W) -> Self {
        Self {
            watch,
            pass: Pass {
                number: 0,
                kind: PassKind::Coarse,
            },
            time: 0.0,
            limit,
            tolerance: scene.settings.tolerance,
        }
    }

    /// Whether no time is left but rounding.
    pub(super) fn is_over(&self) -> bool {
        self.limit - self.time <= 1e-9 * self.limit
    }

    /// The start of the next pass, in `scene`, with overlaps up to `overlap` \[radii\] that its steps take out.
    pub(super) fn begin(
        &mut self,
        mut scene: Scene,
        kind: PassKind,
        overlap: f64,
    ) -> Result<Simulation, SettleError> {
        self.pass = Pass {
            number: self.pass.number + 1,
            kind,
        };
        let gap = scene.settings.tolerance.gap;
        scene.settings.tolerance.gap = gap.max(overlap);
        let mut began = Simulation::new(Arc::new(scene)).map_err(|error| self.failed(error))?;
        if overlap > gap {
            Arc::make_mut(&mut began.scene).settings.tolerance.gap = gap;
        }
        Ok(began)
    }

    /// Runs the pass for `length` \[s\] or the time that is left, or until rest.
    pub(super) fn run(
        &mut self,
        mut simulation: Simulation,
        load: &StartLoads,
        length: f64,
        until_rest: bool,
    ) -> Result<Reached, SettleError> {
        let before = self.time;
        let length = length.min(self.limit - before);
        let rest_speed = load.rest_speed(&simulation.scene);
        let damping = match self.pass.kind {
            PassKind::Coarse => COARSE_DAMPING,
            PassKind::Fine | PassKind::Balance => FINE_DAMPING,
        };
        let step = simulation.scene.settings.communication_step;
        let mut moved_at = 0.0;
        let mut k = 0_u32;
        loop {
            self.time = before + simulation.time();
            let (speed, mover) = simulation.fastest();
            if speed > rest_speed {
                moved_at = simulation.time();
            }
            let at_rest = simulation.time() - moved_at >= load.pause;
            let over = simulation.time() >= length || (until_rest && at_rest);
            let ended = !over
                && (self.watch)(&SettleProgress {
                    pass: self.pass,
                    time: self.time,
                    speed,
                    rest_speed,
                    simulation: &simulation,
                })
                .is_break();
            if over || ended {
                return Ok(Reached {
                    simulation,
                    speed,
                    mover,
                    rest_speed,
                    ended,
                });
            }
            k += 1;
            let end = f64::from(k) * step;
            // Of a whole step its own length: rounding would change the paths.
            let (end, taken) = match end <= length {
                true => (end, step),
                false => (length, length - simulation.time()),
            };
            simulation
                .advance_to(end)
                .map_err(|error| self.failed(error.later(before)))?;
            simulation.slow((-taken / (damping * load.pause)).exp());
        }
    }

    /// `scene` from where `reached` is, without velocities: its forces at rest.
    pub(super) fn stop(
        &self,
        reached: &Simulation,
        scene: &Scene,
    ) -> Result<Simulation, SettleError> {
        let mut start = scene.clone();
        reached.stopped(&mut start);
        Simulation::new(Arc::new(start)).map_err(|error| self.failed(error))
    }

    fn failed(&self, source: StepError) -> SettleError {
        SettleError::Step {
            pass: self.pass,
            time: self.time,
            tolerance: self.tolerance,
            source: Box::new(source),
        }
    }
}

impl Simulation {
    /// Lets `scene` start with the spheres and driven bodies where they are, without velocities, and with their contacts.
    pub(super) fn stopped(&self, scene: &mut Scene) {
        scene.initial.clone_from(&self.state.kinematics);
        scene.initial.stop();
        scene.initial_contacts.clone_from(&self.state.contacts);
        let driven = self.scene.driven().map(|(b, _)| b);
        scene.start_bodies(&self.state.poses, driven.zip(&self.state.bodies));
    }

    /// Multiplies every velocity by `share`.
    fn slow(&mut self, share: f64) {
        let Kinematics { velocity, spin, .. } = &mut self.state.kinematics;
        for v in velocity.iter_mut().chain(spin) {
            *v *= share;
        }
        for body in &mut self.state.bodies {
            body.momentum = SpatialVector::ZERO.plus(&body.momentum, share);
            body.velocity = SpatialVector::ZERO.plus(&body.velocity, share);
        }
    }
}
