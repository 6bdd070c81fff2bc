//! Forces from outside on the spheres: drag, magnets, whatever the caller computes.

use super::{Simulation, bounded};
use crate::Vec3;
use crate::error::StepError;

impl Simulation {
    /// Applies `forces` \[N\], `[N]`, at the centres of the spheres from now on, until the next call; world axes. Each internal
    /// step of `dt` changes the momentum of sphere `i` by `dt forces[i]`. As with gravity, a step that begins now feels them
    /// from half a step ago (integrator `moreau`): forces computed from the velocities at every internal step make the
    /// two-step scheme of Adams and Bashforth, of second order. Their work counts as
    /// [`crate::state::EnergyLedger::loads`]. Spheres asleep wake where their force changes; those not in the scene feel none.
    /// Before the first step, [`Self::place`] lets the contact forces at t = 0 balance them.
    ///
    /// # Errors
    /// [`StepError::Argument`] if there are not as many as spheres, or one is NaN or beyond [`super::LARGEST`]; nothing has
    /// changed.
    pub fn apply_forces(&mut self, forces: &[Vec3]) -> Result<(), StepError> {
        let spheres = self.scene.particles.len();
        if forces.len() != spheres {
            return Err(StepError::Argument {
                what: "forces",
                found: forces.len().to_string(),
                expected: "one for each sphere",
            });
        }
        bounded("forces", forces.iter().flat_map(|force| force.iter()))?;
        let state = &mut *self.state;
        for (i, count) in state.calm.iter_mut().enumerate() {
            if state.applied_forces.get(i).copied().unwrap_or_default() != forces[i] {
                *count = 0;
            }
        }
        state.applied_forces.clear();
        // Without forces a run computes the bits of one that never had any.
        if forces.iter().any(|force| *force != Vec3::zeros()) {
            state.applied_forces.extend_from_slice(forces);
        }
        Ok(())
    }
}
