//! Derivatives of all quantities: by time, and by the commands of boundaries.

use super::Observation;
use super::quantities::values;
use crate::error::StepError;
use crate::simulation::{Direction, Simulation};

impl Simulation {
    /// First derivative by time of all quantities ([`crate::observe::quantities`]) at the end of the last communication step, in
    /// their units over s; counts and the solver's report have none, which is given as 0.
    ///
    /// # Errors
    /// [`StepError::Argument`] where there is no [`Self::replay_record`], another if the last step cannot be taken again: an internal
    /// failure.
    pub fn time_derivatives(&self) -> Result<Vec<f64>, StepError> {
        self.time_derivatives_of(|simulation| values(&Observation::of(simulation)))
    }

    /// Derivative of all quantities ([`crate::observe::quantities`]) at the end of the last communication step by each of
    /// `directions`, in their units over that of the direction. Counts and the solver's report have none, which is
    /// given as 0. Where a contact is at the edge of its state, it is one-sided.
    ///
    /// # Errors
    /// [`StepError::Argument`] where there is no [`Self::replay_record`] or if a direction is of no such boundary,
    /// [`StepError::NotConverged`] if the tangent of the contact solve is singular.
    pub fn directional_derivatives(
        &self,
        directions: &[Direction],
    ) -> Result<Vec<Vec<f64>>, StepError> {
        self.directional_derivatives_of(directions, |simulation| {
            values(&Observation::of(simulation))
        })
    }
}
