//! Gravity as a function of time.
//!
//! ```text
//! fixed       g(t) = g
//! rotation    g(t) = Q(w t) g        w \[rad/s\]: angular velocity, Q: rotation by that vector
//! table       g(t)                   piecewise linear \[m/s^2\], held constant outside
//! ```
//!
//! A step takes gravity at the middle of the interval over which it changes its velocity, so that both integrators stay of
//! second order: Moreau's velocities are half a step off its positions: for it that is the start of the step
//! (`integrator::Integrator::middle`).

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::scene::motion::interpolate;
use crate::spatial::Pose;

/// How gravity changes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub enum GravityMotion {
    /// It does not.
    #[default]
    Fixed,
    /// Its direction turns.
    Rotation {
        /// Angular velocity \[rad/s\].
        angular_velocity: Vec3,
    },
    /// It is given, whatever the gravity that is set.
    Table {
        /// Times \[s\], strictly increasing, `[K]`.
        time: Vec<f64>,
        /// Gravity \[m/s^2\], `[K]`.
        gravity: Vec<Vec3>,
    },
}

impl GravityMotion {
    /// Gravity \[m/s^2\] at time `t` \[s\]; `set` \[m/s^2\] is what it is without motion.
    pub(crate) fn at(&self, set: Vec3, t: f64) -> Vec3 {
        match self {
            Self::Fixed => set,
            // Total angle times axis, never a sum of turns: no drift in an hour.
            Self::Rotation { angular_velocity } => {
                Pose::from_rotation_vector(Vec3::zeros(), angular_velocity * t).rotation * set
            }
            Self::Table { time, gravity } => interpolate(time, gravity, t),
        }
    }

    /// Gravity when it is largest \[m/s^2\]; `set` as for [`Self::at`].
    pub(crate) fn largest(&self, set: Vec3) -> Vec3 {
        match self {
            Self::Fixed | Self::Rotation { .. } => set,
            // Nowhere between two times is it larger than at both.
            Self::Table { gravity, .. } => {
                let largest = gravity.iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
                largest.copied().unwrap_or_default()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_turns_and_a_table_bends() {
        let set = Vec3::new(0.0, 0.0, -9.81);
        assert_eq!(GravityMotion::Fixed.at(set, 7.0), set);
        // Right hand about y: -z turns to -x, in a quarter of a turn.
        let turning = GravityMotion::Rotation {
            angular_velocity: Vec3::y() * 2.0,
        };
        assert_eq!(turning.at(set, 0.0), set);
        let quarter = turning.at(set, std::f64::consts::FRAC_PI_4);
        assert!((quarter - Vec3::new(-9.81, 0.0, 0.0)).norm() < 1e-14);
        let table = GravityMotion::Table {
            time: vec![1.0, 3.0],
            gravity: vec![set, Vec3::x()],
        };
        for (t, expected) in [(0.0, set), (2.0, (set + Vec3::x()) / 2.0), (9.0, Vec3::x())] {
            assert_eq!(table.at(Vec3::repeat(5.0), t), expected);
        }
        assert_eq!(table.largest(Vec3::repeat(99.0)), set);
        assert_eq!(turning.largest(set), set);
    }
}
