//! Rigid motion of boundaries: pose, twist, prescribed laws and commanded paths.
//!
//! A boundary's pose is counted from the scene: `x(t) = a + s(t) + Q(t) (x_0 - a)`, with `a` the point of
//! action \[m\], `s` the total translation \[m\] and `Q` the total rotation. Zero translation and identity
//! rotation mean "as in the scene".

use std::f64::consts::TAU;

use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::driven::Body;

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
    #[must_use]
    pub fn from_rotation_vector(translation: Vec3, rotation: Vec3) -> Self {
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
        point_of_action + self.translation + self.rotation * (x_0 - point_of_action)
    }

    /// Whether nothing is displaced: most boundaries stay where they are.
    #[inline]
    fn is_none(&self) -> bool {
        let q = self.rotation.as_ref();
        q.w == 1.0 && q.i == 0.0 && q.j == 0.0 && q.k == 0.0 && self.translation == Vec3::zeros()
    }

    /// Which point of the scene is at `x` now: `a + Q^T (x - a - s)` \[m\].
    #[must_use]
    #[inline]
    pub fn inverse_apply(&self, point_of_action: Vec3, x: Vec3) -> Vec3 {
        if self.is_none() {
            return x;
        }
        point_of_action
            + self
                .rotation
                .inverse_transform_vector(&(x - point_of_action - self.translation))
    }

    /// The pose at `fraction` of the way to `end`: translation linear, rotation by its logarithm (constant angular
    /// velocity, the shorter way round). Fractions outside 0..=1 extrapolate.
    #[must_use]
    pub fn interpolate(&self, end: &Self, fraction: f64) -> Self {
        let turn = (end.rotation * self.rotation.inverse()).scaled_axis();
        Self {
            translation: self.translation + (end.translation - self.translation) * fraction,
            rotation: UnitQuaternion::from_scaled_axis(turn * fraction) * self.rotation,
        }
    }

    /// The constant twist that leads to `end` within `duration` \[s\] along [`Pose::interpolate`].
    #[must_use]
    pub fn twist_to(&self, end: &Self, duration: f64) -> Twist {
        Twist {
            linear: (end.translation - self.translation) / duration,
            angular: (end.rotation * self.rotation.inverse()).scaled_axis() / duration,
        }
    }

    /// The pose after `duration` \[s\] of a constant twist.
    #[must_use]
    pub fn advanced(&self, twist: &Twist, duration: f64) -> Self {
        Self {
            translation: self.translation + twist.linear * duration,
            rotation: UnitQuaternion::from_scaled_axis(twist.angular * duration) * self.rotation,
        }
    }
}

/// Linear and angular velocity of the point of action, world axes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Twist {
    /// Linear velocity \[m/s\].
    pub linear: Vec3,
    /// Angular velocity \[rad/s\].
    pub angular: Vec3,
}

/// Which quantity an FMU input (or a caller of the library) drives.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum InputKind {
    /// Total translation \[m\] and rotation vector \[rad\], reached at the end of the communication step.
    Pose,
    /// Pose and twist together: reaches `pose + twist * h`, no lag.
    Motion,
    /// Velocity \[m/s\] and angular velocity \[rad/s\], held over the step and integrated inside.
    Twist,
    /// Displacement \[m\] along a unit axis.
    Slide {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Speed \[m/s\] along a unit axis.
    SlideSpeed {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Angle \[rad\] about a unit axis through the point of action.
    Hinge {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Angular speed \[rad/s\] about a unit axis through the point of action.
    HingeSpeed {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Force \[N\] and torque \[N m\] on a free body, held over the step.
    Load,
    /// Force \[N\] along the slide of a body, held over the step.
    SlideForce {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Torque \[N m\] about the hinge of a body, held over the step.
    HingeTorque {
        /// Unit axis, world.
        axis: Vec3,
    },
}

/// How a boundary moves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// Stays as in the scene.
    Fixed,
    /// Constant linear \[m/s\] and angular \[rad/s\] velocity.
    Constant(Twist),
    /// `amplitude * sin(2 pi frequency t + phase) - amplitude * sin(phase)`, for translation \[m\] and
    /// rotation vector \[rad\]: zero displacement at t = 0.
    Sinusoid {
        /// Amplitude of the translation \[m\].
        translation: Vec3,
        /// Amplitude of the rotation vector \[rad\].
        rotation: Vec3,
        /// Frequency \[Hz\].
        frequency: f64,
        /// Phase \[rad\].
        phase: f64,
    },
    /// Piecewise linear table, held constant outside; rotation vectors \[rad\].
    Table {
        /// Times \[s\], strictly increasing, `[K]`.
        time: Vec<f64>,
        /// Translations \[m\], `[K]`.
        translation: Vec<Vec3>,
        /// Rotation vectors \[rad\], `[K]`.
        rotation: Vec<Vec3>,
    },
    /// Driven from outside, by [`crate::simulation::Simulation::command`].
    Input(InputKind),
    /// Moved by force and torque: its motion is solved together with that of the spheres.
    Driven(Box<Body>),
}

impl Motion {
    /// What the outside commands, if anything.
    #[must_use]
    pub fn input(&self) -> Option<InputKind> {
        match self {
            Self::Input(kind) => Some(*kind),
            Self::Driven(body) => body.input_kind(),
            _ => None,
        }
    }

    /// The pressure \[Pa\] that the outside may change, as in the scene.
    #[must_use]
    pub fn pressure_input(&self) -> Option<f64> {
        match self {
            Self::Driven(body) => body.pressure_input(),
            _ => None,
        }
    }

    /// The pose that the scene prescribes at time `t` \[s\]; as in the scene for a motion driven from outside, that of
    /// t = 0 for a driven body.
    ///
    /// A table interpolates its rotation vectors linearly, so that several turns about one axis are kept.
    #[must_use]
    pub fn pose_at(&self, t: f64) -> Pose {
        match self {
            Self::Fixed | Self::Input(_) => Pose::default(),
            Self::Driven(body) => body.pose,
            Self::Constant(twist) => Pose::default().advanced(twist, t),
            Self::Sinusoid {
                translation,
                rotation,
                frequency,
                phase,
            } => {
                let factor = (TAU * frequency * t + phase).sin() - phase.sin();
                Pose::from_rotation_vector(translation * factor, rotation * factor)
            }
            Self::Table {
                time,
                translation,
                rotation,
            } => Pose::from_rotation_vector(
                interpolate(time, translation, t),
                interpolate(time, rotation, t),
            ),
        }
    }
}

/// Piecewise linear value at `t`, held constant outside; zero from an empty table.
pub(crate) fn interpolate(time: &[f64], value: &[Vec3], t: f64) -> Vec3 {
    let after = time.partition_point(|&knot| knot <= t);
    let knot = |i: usize| Some((*time.get(i)?, *value.get(i)?));
    match (after.checked_sub(1).and_then(knot), knot(after)) {
        (Some((t0, start)), Some((t1, end))) => start + (end - start) * ((t - t0) / (t1 - t0)),
        (Some((_, held)), None) | (None, Some((_, held))) => held,
        (None, None) => Vec3::zeros(),
    }
}

/// A command for a boundary with a [`Motion::input`], a belt or a servo pressure driven from outside, held until the next one.
/// Components that the boundary's [`InputKind`] does not use are ignored.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Command {
    /// Total translation \[m\] from the scene (`Pose`, `Motion`).
    pub translation: Vec3,
    /// Total rotation vector \[rad\] from the scene (`Pose`, `Motion`); may exceed pi.
    pub rotation: Vec3,
    /// Velocity \[m/s\] (`Motion`, `Twist`).
    pub velocity: Vec3,
    /// Angular velocity \[rad/s\] (`Motion`, `Twist`).
    pub angular_velocity: Vec3,
    /// Force \[N\] at the point of action (`Load`), world axes.
    pub force: Vec3,
    /// Torque \[N m\] (`Load`), world axes.
    pub torque: Vec3,
    /// Displacement \[m\], speed \[m/s\], angle \[rad\], angular speed \[rad/s\], force \[N\] or torque \[N m\] of a
    /// slide or hinge.
    pub scalar: f64,
    /// Velocity of the surface against the boundary \[m/s\], its own axes ([`crate::boundaries::Belt`]).
    pub surface_velocity: Vec3,
    /// Pressure of a servo wall \[Pa\] ([`crate::driven::Servo::input`]).
    pub pressure: f64,
}

/// First and second derivative of a command by time: each component in its unit over s and s^2.
pub type Rates = [Command; 2];

impl Command {
    /// The command `s` \[s\] later, `u + u' s + u'' s^2/2`.
    #[must_use]
    pub fn along(&self, [first, second]: &Rates, s: f64) -> Self {
        self.plus(first, s).plus(second, 0.5 * s * s)
    }

    /// `self + scale * other`.
    #[must_use]
    pub fn plus(&self, other: &Self, scale: f64) -> Self {
        Self {
            translation: self.translation + other.translation * scale,
            rotation: self.rotation + other.rotation * scale,
            velocity: self.velocity + other.velocity * scale,
            angular_velocity: self.angular_velocity + other.angular_velocity * scale,
            force: self.force + other.force * scale,
            torque: self.torque + other.torque * scale,
            scalar: self.scalar + other.scalar * scale,
            surface_velocity: self.surface_velocity + other.surface_velocity * scale,
            pressure: self.pressure + other.pressure * scale,
        }
    }
}

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
        #[test]
        fn a_pose_and_its_inverse_cancel(pose in pose(), a in vector(3.0), x in vector(3.0)) {
            prop_assert!(near(pose.inverse_apply(a, pose.apply(a, x)), x, 1e-13));
            // The point of action only translates.
            prop_assert!(near(pose.apply(a, a), a + pose.translation, 1e-15));
        }

        /// Halfway plus halfway is the whole way; the twist of the way leads to its end, and its velocity field is
        /// the derivative of the path: v = s' + w x (x - a - s).
        #[test]
        fn an_interpolated_path_has_one_twist(from in pose(), to in pose(), x in vector(3.0), f in 0.1..0.9f64) {
            let a = Vec3::new(0.3, -0.2, 0.1);
            let end = from.interpolate(&to, 1.0);
            prop_assert!(near(end.apply(a, x), to.apply(a, x), 1e-12));
            let duration = 0.7;
            let twist = from.twist_to(&to, duration);
            let at = from.interpolate(&to, f);
            prop_assert!(near(from.advanced(&twist, f * duration).apply(a, x), at.apply(a, x), 1e-12));
            let errors = [1e-3, 5e-4].map(|h| {
                let [before, after] = [f - h, f + h].map(|f| from.interpolate(&to, f).apply(a, x));
                let measured = (after - before) / (2.0 * h * duration);
                let arm = at.apply(a, x) - a - at.translation;
                (measured - twist.linear - twist.angular.cross(&arm)).norm()
            });
            // Central differences: second order.
            prop_assert!(errors[1] <= 0.26 * errors[0] + 1e-10, "{errors:?}");
        }
    }

    #[test]
    fn prescribed_motions_start_as_in_the_scene_and_follow_their_law() {
        let axis = Vec3::new(0.0, 0.0, 1.0);
        let constant = Motion::Constant(Twist {
            linear: Vec3::x() * 2.0,
            angular: axis * 0.5,
        });
        let sinusoid = Motion::Sinusoid {
            translation: Vec3::x() * 0.1,
            rotation: axis * 0.2,
            frequency: 2.0,
            phase: 0.4,
        };
        for motion in [
            &constant,
            &sinusoid,
            &Motion::Fixed,
            &Motion::Input(InputKind::Pose),
        ] {
            assert_eq!(motion.pose_at(0.0), Pose::default());
        }
        let pose = constant.pose_at(3.0);
        assert!(near(pose.translation, Vec3::x() * 6.0, 1e-15));
        assert!(near(pose.rotation_vector(), axis * 1.5, 1e-15));
        let factor = (TAU * 2.0 * 0.3 + 0.4).sin() - 0.4f64.sin();
        let pose = sinusoid.pose_at(0.3);
        assert!(near(pose.translation, Vec3::x() * 0.1 * factor, 1e-15));
        assert!(near(pose.rotation_vector(), axis * 0.2 * factor, 1e-15));
    }

    #[test]
    fn a_table_is_linear_between_its_knots_and_constant_outside() {
        let axis = Vec3::new(0.0, 1.0, 0.0);
        let table = Motion::Table {
            time: vec![1.0, 2.0, 4.0],
            translation: vec![Vec3::zeros(), Vec3::x(), Vec3::x() * 5.0],
            rotation: vec![Vec3::zeros(), axis * 10.0, axis * 10.0],
        };
        for (t, x, angle) in [
            (0.0, 0.0, 0.0),
            (1.5, 0.5, 5.0),
            (2.0, 1.0, 10.0),
            (3.0, 3.0, 10.0),
            (9.0, 5.0, 10.0),
        ] {
            let pose = table.pose_at(t);
            assert!(near(pose.translation, Vec3::x() * x, 1e-15), "{t}");
            // More than a turn: compare where a point goes.
            let expected = UnitQuaternion::from_scaled_axis(axis * angle) * Vec3::z();
            assert!(near(pose.rotation * Vec3::z(), expected, 1e-14), "{t}");
        }
    }
}
