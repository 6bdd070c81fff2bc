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

use nalgebra::{Quaternion, UnitQuaternion};

use crate::motion::Twist;
use crate::particles::Kinematics;
use crate::problem::Dof6;
use crate::scene::{Integrator, Settings};

/// Velocities of the spheres that differ from the integrator's own, formed for the sphere that is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Velocities<'a> {
    /// What moves, with the integrator's own velocities.
    pub kinematics: &'a Kinematics,
    /// Acceleration by external and persisting contact forces in the last step, `[N]`.
    pub persisting: &'a [Dof6],
    /// Integrator.
    pub integrator: Integrator,
    /// Last internal step \[s\].
    pub last: f64,
    /// `simulation.step` of the scene \[s\].
    pub step: f64,
}

impl Velocities<'_> {
    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` at the time of the state.
    #[must_use]
    #[inline]
    pub fn reported(&self, i: usize) -> Twist {
        let (own, persisting) = (self.own(i), &self.persisting[i]);
        twist(&self.integrator.reported(&own, persisting, self.last))
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` half a `simulation.step` before that time (integrator
    /// `shi`: at that time).
    #[must_use]
    #[inline]
    pub fn half_step(&self, i: usize) -> Twist {
        let shift = self.integrator.shift(self.last, self.step);
        twist(&self.own(i).plus(&self.persisting[i], shift))
    }

    #[inline]
    fn own(&self, i: usize) -> Dof6 {
        Dof6 {
            linear: self.kinematics.velocity[i],
            angular: self.kinematics.spin[i],
        }
    }
}

fn twist(velocity: &Dof6) -> Twist {
    Twist {
        linear: velocity.linear,
        angular: velocity.angular,
    }
}

impl Integrator {
    /// The state velocity for a step of `dt` \[s\] after one of `last` \[s\].
    #[must_use]
    pub fn restep(self, velocity: &Dof6, persisting: &Dof6, last: f64, dt: f64) -> Dof6 {
        match self {
            Self::Moreau => velocity.plus(persisting, 0.5 * (last - dt)),
            Self::Shi => *velocity,
        }
    }

    /// Middle \[s\] of the interval over which a step of `dt` \[s\] from `start` \[s\] changes the state velocity: there
    /// forces of time count, so that the scheme is of second order.
    #[must_use]
    pub fn middle(self, start: f64, dt: f64) -> f64 {
        match self {
            Self::Moreau => start,
            Self::Shi => start + 0.5 * dt,
        }
    }

    /// Velocity without contacts.
    #[must_use]
    pub fn free(self, velocity: &Dof6, external: &Dof6, dt: f64) -> Dof6 {
        let share = match self {
            Self::Moreau => dt,
            Self::Shi => 0.5 * dt,
        };
        velocity.plus(external, share)
    }

    /// Factor on the inverse mass in the step's problem.
    #[must_use]
    pub fn mobility(self) -> f64 {
        match self {
            Self::Moreau => 1.0,
            Self::Shi => 0.5,
        }
    }

    /// State velocity after the step, from the one before it and the solution `v1` of its problem.
    #[must_use]
    pub fn finish(self, before: &Dof6, v1: &Dof6, settings: &Settings) -> Dof6 {
        match self {
            Self::Moreau => *v1,
            Self::Shi => Dof6::ZERO
                .plus(v1, 2.0 * settings.dynamic_coefficient)
                .plus(before, -settings.dynamic_coefficient),
        }
    }

    /// Velocity at the time of the state, from the state velocity after a step of `last` \[s\].
    #[must_use]
    pub fn reported(self, velocity: &Dof6, persisting: &Dof6, last: f64) -> Dof6 {
        match self {
            Self::Moreau => velocity.plus(persisting, 0.5 * last),
            Self::Shi => *velocity,
        }
    }

    /// Time \[s\] by which the half step after a step of `last` \[s\] lies earlier than half of `step` \[s\] before its end.
    #[must_use]
    pub fn shift(self, last: f64, step: f64) -> f64 {
        match self {
            Self::Moreau => 0.5 * (last - step),
            Self::Shi => 0.0,
        }
    }
}

impl Dof6 {
    /// `self + scale * other`.
    #[must_use]
    pub fn plus(&self, other: &Self, scale: f64) -> Self {
        Self {
            linear: self.linear + other.linear * scale,
            angular: self.angular + other.angular * scale,
        }
    }
}

/// Orientation after turning with `angular` \[rad/s\] for `dt` \[s\]: the exact exponential, not the paper's
/// eq 4, which is not orthogonal when two angles are non-zero.
#[must_use]
pub fn turned(
    orientation: &UnitQuaternion<f64>,
    angular: &crate::Vec3,
    dt: f64,
) -> UnitQuaternion<f64> {
    let half = angular * (0.5 * dt);
    let square = half.norm_squared();
    let turn = if square < SMALL {
        // Series of cos and sin(x)/x, exact to rounding.
        let scalar = 1.0 - square * (0.5 - square * (1.0 / 24.0 - square / 720.0));
        let vector = half * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square / 5040.0)));
        Quaternion::from_parts(scalar, vector)
    } else {
        UnitQuaternion::from_scaled_axis(half * 2.0).into_inner()
    };
    UnitQuaternion::new_normalize(turn * orientation.into_inner())
}

/// Square of half an angle below which four terms of a series are exact: the fifth is 1e-17.
const SMALL: f64 = 1e-3;
