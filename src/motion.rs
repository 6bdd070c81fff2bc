//! Rigid motion of boundaries: pose, twist, prescribed laws and commanded paths.
//!
//! A boundary's pose is counted from the scene: `x(t) = a + s(t) + Q(t) (x_0 - a)`, with `a` the point of
//! action \[m\], `s` the total translation \[m\] and `Q` the total rotation. Zero translation and identity
//! rotation mean "as in the scene".

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

impl Motion {
    /// stand-in
    pub fn pose_at(&self, t: f64) -> Pose {
        match self {
            Self::Constant(w) => Pose {
                translation: w.linear * t,
                rotation: UnitQuaternion::from_scaled_axis(w.angular * t),
            },
            _ => Pose::default(),
        }
    }
}
