//! Rigid displacement of a boundary: `x(t) = a + s(t) + Q(t) (x_0 - a)`, with `a` the reference point \[m\], `s` the
//! translation \[m\] and `Q` the rotation from the scene. Zero translation and identity rotation mean "as in the scene".

use nalgebra::{Matrix3, Quaternion, UnitQuaternion};
use serde::{Deserialize, Serialize};

use super::Twist;
use crate::Vec3;

/// Total rigid displacement from the scene's placement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Translation of the point of action \[m\].
    pub translation: Vec3,
    /// Rotation about the point of action.
    pub rotation: UnitQuaternion<f64>,
}

impl Default for Pose {
    fn default() -> Self {
        Self {
            translation: Vec3::zeros(),
            rotation: UnitQuaternion::identity(),
        }
    }
}

impl Pose {
    /// Translation \[m\] and rotation vector \[rad\] from the scene; the vector may be longer than pi.
    pub(crate) fn from_rotation_vector(translation: Vec3, rotation: Vec3) -> Self {
        Self {
            translation,
            rotation: UnitQuaternion::from_scaled_axis(rotation),
        }
    }

    /// The rotation as a vector \[rad\] of length at most pi.
    #[must_use]
    pub fn rotation_vector(&self) -> Vec3 {
        self.rotation.scaled_axis()
    }

    /// Where the point `x_0` of the scene is now: `a + s + Q (x_0 - a)` \[m\].
    #[must_use]
    #[inline]
    pub fn apply(&self, point_of_action: Vec3, x_0: Vec3) -> Vec3 {
        if self.is_none() {
            return x_0;
        }
        let from_reference = x_0 - point_of_action;
        point_of_action
            + self.translation
            + match self.turns() {
                true => self.rotation * from_reference,
                false => from_reference,
            }
    }

    /// Whether nothing is displaced: most boundaries stay where they are.
    #[inline]
    fn is_none(&self) -> bool {
        !self.turns() && self.translation == Vec3::zeros()
    }

    /// Whether it is turned: many boundaries move without.
    #[inline]
    fn turns(&self) -> bool {
        let q = self.rotation.as_ref();
        q.w != 1.0 || q.i != 0.0 || q.j != 0.0 || q.k != 0.0
    }

    /// Which point of the scene is at `x` now: `a + Q^T (x - a - s)` \[m\].
    #[inline]
    pub(crate) fn inverse_apply(&self, point_of_action: Vec3, x: Vec3) -> Vec3 {
        if self.is_none() {
            return x;
        }
        let from_reference = x - point_of_action - self.translation;
        point_of_action
            + match self.turns() {
                true => self.rotation.inverse_transform_vector(&from_reference),
                false => from_reference,
            }
    }

    /// What the move to `to` does to points of a boundary whose reference point is `point_of_action`; `None` where it does not move.
    pub(crate) fn displacement(&self, to: &Self, point_of_action: Vec3) -> Option<Displacement> {
        if self == to {
            return None;
        }
        let turn = (to.rotation * self.rotation.inverse()).to_rotation_matrix();
        Some(Displacement {
            pivot: point_of_action + self.translation,
            shift: to.translation - self.translation,
            turn: turn.matrix() - Matrix3::identity(),
            turns: self.rotation != to.rotation,
        })
    }

    /// The constant twist that leads to `end` within `duration` \[s\], the shorter way round.
    pub(crate) fn twist_to(&self, end: &Self, duration: f64) -> Twist {
        Twist {
            linear: (end.translation - self.translation) / duration,
            angular: (end.rotation * self.rotation.inverse()).scaled_axis() / duration,
        }
    }

    /// The pose after `duration` \[s\] of a constant twist.
    pub(crate) fn advanced(&self, twist: &Twist, duration: f64) -> Self {
        Self {
            translation: self.translation + twist.linear * duration,
            rotation: UnitQuaternion::from_scaled_axis(twist.angular * duration) * self.rotation,
        }
    }
}

/// A rigid displacement: `x' - x = s + (Q - 1)(x - p)`, with the pivot `p` \[m\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Displacement {
    pivot: Vec3,
    shift: Vec3,
    turn: Matrix3<f64>,
    /// Whether it is more than a translation.
    pub(crate) turns: bool,
}

impl Displacement {
    /// Of the point that was at `x` \[m\].
    #[inline]
    pub(crate) fn at(&self, x: Vec3) -> Vec3 {
        self.shift + self.turn * (x - self.pivot)
    }
}

/// Orientation after turning with `angular` \[rad/s\] for `dt` \[s\]: the exact exponential, not the paper's
/// eq 4, which is not orthogonal when two angles are non-zero.
#[must_use]
pub fn turned(orientation: &UnitQuaternion<f64>, angular: &Vec3, dt: f64) -> UnitQuaternion<f64> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-size..size).prop_map(Vec3::from)
    }

    fn pose() -> impl Strategy<Value = Pose> {
        (vector(2.0), vector(1.7)).prop_map(|(s, r)| Pose::from_rotation_vector(s, r))
    }

    fn near(a: Vec3, b: Vec3, tolerance: f64) -> bool {
        (a - b).norm() <= tolerance
    }

    proptest! {
        /// A displacement leads points from where one pose has them to where another has them.
        #[test]
        fn a_displacement_is_the_way_between_two_poses(from in pose(), to in pose(), a in vector(1.0), x_0 in vector(3.0)) {
            let [start, end] = [&from, &to].map(|pose| pose.apply(a, x_0));
            let displacement = from.displacement(&to, a).expect("a move");
            prop_assert!(near(start + displacement.at(start), end, 1e-13));
            prop_assert!(from.displacement(&from, a).is_none());
        }
    }

    proptest! {
        #[test]
        fn a_pose_and_its_inverse_cancel(pose in pose(), a in vector(3.0), x in vector(3.0)) {
            prop_assert!(near(pose.inverse_apply(a, pose.apply(a, x)), x, 1e-13));
            // The point of action only translates.
            prop_assert!(near(pose.apply(a, a), a + pose.translation, 1e-15));
        }

        /// A turn so small that its cosine rounds to one moves points all the same.
        #[test]
        fn a_tiny_turn_is_a_turn(turn in vector(1e-9), a in vector(1.0), x in vector(1.0)) {
            let (pose, moved) = (Pose::from_rotation_vector(Vec3::zeros(), turn), turn.cross(&(x - a)));
            prop_assert!(near(pose.apply(a, x), x + moved, 1e-15));
            prop_assert!(near(pose.inverse_apply(a, x), x - moved, 1e-15));
        }

        /// The twist between two poses leads to the end, and its velocity field is the derivative of the path:
        /// v = s' + w x (x - a - s).
        #[test]
        fn two_poses_have_one_twist(from in pose(), to in pose(), x in vector(3.0), f in 0.1..0.9f64) {
            let a = Vec3::new(0.3, -0.2, 0.1);
            let duration = 0.7;
            let twist = from.twist_to(&to, duration);
            let path = |f: f64| from.advanced(&twist, f * duration);
            prop_assert!(near(path(1.0).apply(a, x), to.apply(a, x), 1e-12));
            let at = path(f);
            let errors = [1e-3, 5e-4].map(|h| {
                let [before, after] = [f - h, f + h].map(|f| path(f).apply(a, x));
                let measured = (after - before) / (2.0 * h * duration);
                let arm = at.apply(a, x) - a - at.translation;
                (measured - twist.linear - twist.angular.cross(&arm)).norm()
            });
            // Central differences: second order.
            prop_assert!(errors[1] <= 0.26 * errors[0] + 1e-10, "{errors:?}");
        }
    }
}
