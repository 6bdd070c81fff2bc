//! Velocities of the spheres that differ from the integrator's own.

use crate::integrator::Integrator;
use crate::scene::particles::Kinematics;
use crate::spatial::{SpatialVector, Twist};

/// Velocities of the spheres that differ from the integrator's own, formed for the sphere that is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Velocities<'a> {
    /// What moves, with the integrator's own velocities.
    pub kinematics: &'a Kinematics,
    /// Acceleration by external and persisting contact forces in the last step, `[N]`.
    pub smooth: &'a [SpatialVector],
    /// Integrator.
    pub integrator: Integrator,
    /// Last internal step \[s\].
    pub last: f64,
    /// `simulation.step` of the scene, or the first communication step if that is shorter \[s\].
    pub step: f64,
}

impl Velocities<'_> {
    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` at the time of the state.
    #[inline]
    pub(crate) fn reported(&self, i: usize) -> Twist {
        let (own, smooth) = (self.own(i), &self.smooth[i]);
        twist(&self.integrator.reported(&own, smooth, self.last))
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i` half of `step` before that time (integrator `shi`:
    /// at that time).
    #[inline]
    pub(crate) fn half_step(&self, i: usize) -> Twist {
        let shift = self.integrator.shift(self.last, self.step);
        twist(&self.own(i).plus(&self.smooth[i], shift))
    }

    #[inline]
    fn own(&self, i: usize) -> SpatialVector {
        SpatialVector {
            linear: self.kinematics.velocity[i],
            angular: self.kinematics.spin[i],
        }
    }
}

fn twist(velocity: &SpatialVector) -> Twist {
    Twist {
        linear: velocity.linear,
        angular: velocity.angular,
    }
}
