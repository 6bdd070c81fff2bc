//! Time integration: what a step starts from and what it leaves.
//!
//! ```text
//! moreau  v_free = v + dt a_ext          W = M^-1       v' = v1            x' = x + dt v1
//! shi     v_free = v + dt/2 a_ext        W = (2 M)^-1   v' = k (2 v1 - v)  x' = x + dt v1
//! ```
//!
//! `v1` solves the step's problem; for Shi it is the mean velocity `D/dt` of the step (constant acceleration:
//! `K_ii = 2/dt^2 M`, `F_i = 2/dt M v`). Moreau's state velocity is the half-step one; the reported velocity is
//! `v + dt/2 a_p` with `a_p` the acceleration by external and persisting contact forces, and when `dt`
//! changes `v += (dt_old - dt_new)/2 a_p` keeps it continuous.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::spatial::SpatialVector;

/// Time integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Velocity-level Moreau-Jean step on staggered velocities.
    #[default]
    Moreau,
    /// Constant acceleration over the step, as Shi (1988) and the paper.
    Shi,
}

impl Integrator {
    /// The state velocity for a step of `dt` \[s\] after one of `last` \[s\].
    pub(crate) fn shift_half_step(
        self,
        velocity: &SpatialVector,
        smooth: &SpatialVector,
        last: f64,
        dt: f64,
    ) -> SpatialVector {
        match self {
            Self::Moreau => velocity.plus(smooth, 0.5 * (last - dt)),
            Self::Shi => *velocity,
        }
    }

    /// Middle \[s\] of the interval over which a step of `dt` \[s\] from `start` \[s\] changes the state velocity: there
    /// forces of time count, so that the scheme is of second order.
    pub(crate) fn middle(self, start: f64, dt: f64) -> f64 {
        match self {
            Self::Moreau => start,
            Self::Shi => start + 0.5 * dt,
        }
    }

    /// Velocity without contacts.
    pub(crate) fn free(
        self,
        velocity: &SpatialVector,
        external: &SpatialVector,
        dt: f64,
    ) -> SpatialVector {
        let share = match self {
            Self::Moreau => dt,
            Self::Shi => 0.5 * dt,
        };
        velocity.plus(external, share)
    }

    /// Factor on the inverse mass in the step's problem.
    pub(crate) fn mobility(self) -> f64 {
        match self {
            Self::Moreau => 1.0,
            Self::Shi => 0.5,
        }
    }

    /// State velocity after the step, from the one before it and the solution `v1` of its problem.
    pub(crate) fn finish(
        self,
        before: &SpatialVector,
        v1: &SpatialVector,
        dynamic_coefficient: f64,
    ) -> SpatialVector {
        match self {
            Self::Moreau => *v1,
            Self::Shi => SpatialVector::ZERO
                .plus(v1, 2.0 * dynamic_coefficient)
                .plus(before, -dynamic_coefficient),
        }
    }

    /// Velocity at the time of the state, from the state velocity after a step of `last` \[s\].
    pub(crate) fn reported(
        self,
        velocity: &SpatialVector,
        smooth: &SpatialVector,
        last: f64,
    ) -> SpatialVector {
        match self {
            Self::Moreau => velocity.plus(smooth, 0.5 * last),
            Self::Shi => *velocity,
        }
    }

    /// Time \[s\] by which the half step after a step of `last` \[s\] lies earlier than half of `step` \[s\] before its end.
    pub(crate) fn shift(self, last: f64, step: f64) -> f64 {
        match self {
            Self::Moreau => 0.5 * (last - step),
            Self::Shi => 0.0,
        }
    }
}
