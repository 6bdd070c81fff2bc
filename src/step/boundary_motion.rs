//! Motion of a prescribed boundary over a step, of second order in its length.
//!
//! A material point that is at `x` in the middle of the step moves from there by half the displacement to either side:
//!
//! ```text
//! v(x) = (s_1 - s_0)/dt + 2 sin(theta/2)/dt e x (x - c)      e theta: rotation from pose 0 to pose 1
//!                                                           c: reference point in the middle of the step
//! ```
//!
//! The chord from the point's place at the start would point into a turning surface by `W^2 r dt/2`.

use crate::Vec3;
use crate::spatial::Pose;

/// Mean velocity of a boundary's points over a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BoundaryMotion {
    linear: Vec3,
    /// \[rad/s\]; of the chords, not of the arcs.
    pub(super) angular: Vec3,
    centre: Vec3,
}

impl BoundaryMotion {
    /// From one pose to another within `dt` \[s\]; the boundary rotates about its `reference` point \[m\].
    pub(super) fn new(reference: Vec3, [from, to]: [&Pose; 2], dt: f64) -> Self {
        let turn = (to.rotation * from.rotation.inverse()).into_inner();
        let middle = (from.translation + to.translation) * 0.5;
        Self {
            linear: (to.translation - from.translation) / dt,
            // The vector part is sin(theta/2) e, of the shorter rotation where the scalar part is positive.
            angular: turn.imag() * (2.0 / dt * turn.w.signum()),
            centre: reference + middle,
        }
    }

    /// Velocity of the point at `x` \[m\] in the middle of the step \[m/s\].
    pub(super) fn at(&self, x: Vec3) -> Vec3 {
        self.linear + self.angular.cross(&(x - self.centre))
    }

    /// Acceleration of that point by the rotation \[m/s^2\].
    pub(super) fn centripetal(&self, x: Vec3) -> Vec3 {
        self.angular.cross(&self.angular.cross(&(x - self.centre)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the displacement of a material point to either side of the middle; a point of a turning circle does not leave it.
    #[test]
    fn points_move_to_either_side_of_the_middle() {
        let (reference, dt) = (Vec3::new(0.3, -0.2, 0.5), 0.02);
        let pose = |s: f64| {
            let (slide, turn) = (Vec3::new(0.1, 0.2, -0.3), Vec3::new(1.0, 7.0, -4.0));
            Pose::from_rotation_vector(slide * s, turn * s)
        };
        let motion = BoundaryMotion::new(reference, [&pose(1.0), &pose(1.0 + dt)], dt);
        let x = Vec3::new(0.7, 0.1, -0.4);
        let middle = pose(1.0 + 0.5 * dt);
        let material = middle.inverse_apply(reference, x);
        let [from, to] = [1.0, 1.0 + dt].map(|s| pose(s).apply(reference, material));
        assert!((motion.at(x) - (to - from) / dt).norm() < 1e-12);
        let arm = x - reference - middle.translation;
        let turning = motion.at(x) - (pose(1.0 + dt).translation - pose(1.0).translation) / dt;
        assert!(turning.dot(&arm).abs() < 1e-12);
    }

    /// Of two rotations that lead to the same pose the shorter one counts.
    #[test]
    fn the_shorter_rotation_counts() {
        let (from, to) = (
            Pose::default(),
            Pose::from_rotation_vector(Vec3::zeros(), Vec3::z() * -0.1),
        );
        let mut other = to;
        other.rotation = nalgebra::Unit::new_unchecked(-to.rotation.into_inner());
        let motion = |to| BoundaryMotion::new(Vec3::zeros(), [&from, to], 0.1).angular;
        assert!((motion(&to) - motion(&other)).norm() < 1e-15);
        assert!((motion(&to).z + 2.0 * 0.05_f64.sin() / 0.1).abs() < 1e-12);
    }
}
