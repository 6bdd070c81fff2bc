//! Rigid motion of boundaries: pose, twist, prescribed laws and commanded paths.
//!
//! A boundary's pose is counted from the scene: `x(t) = a + s(t) + Q(t) (x_0 - a)`, with `a` the point of
//! action \[m\], `s` the total translation \[m\] and `Q` the total rotation. Zero translation and identity
//! rotation mean "as in the scene".

use std::f64::consts::TAU;

use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

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
    pub fn apply(&self, point_of_action: Vec3, x_0: Vec3) -> Vec3 {
        point_of_action + self.translation + self.rotation * (x_0 - point_of_action)
    }

    /// Which point of the scene is at `x` now: `a + Q^T (x - a - s)` \[m\].
    #[must_use]
    pub fn inverse_apply(&self, point_of_action: Vec3, x: Vec3) -> Vec3 {
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
}

impl Motion {
    /// The pose that the scene prescribes at time `t` \[s\]; as in the scene for a motion driven from outside.
    ///
    /// A table interpolates its rotation vectors linearly, so that several turns about one axis are kept.
    #[must_use]
    pub fn pose_at(&self, t: f64) -> Pose {
        match self {
            Self::Fixed | Self::Input(_) => Pose::default(),
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
fn interpolate(time: &[f64], value: &[Vec3], t: f64) -> Vec3 {
    let after = time.partition_point(|&knot| knot <= t);
    let knot = |i: usize| Some((*time.get(i)?, *value.get(i)?));
    match (after.checked_sub(1).and_then(knot), knot(after)) {
        (Some((t0, start)), Some((t1, end))) => start + (end - start) * ((t - t0) / (t1 - t0)),
        (Some((_, held)), None) | (None, Some((_, held))) => held,
        (None, None) => Vec3::zeros(),
    }
}

/// A command for a boundary whose motion is [`Motion::Input`], held until the next one.
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
    /// Displacement \[m\], speed \[m/s\], angle \[rad\] or angular speed \[rad/s\] of a slide or hinge.
    pub scalar: f64,
}
