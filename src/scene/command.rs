//! What is commanded of a boundary from outside, constant or changing over a communication step.

use nalgebra::Quaternion;
use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Which quantity an FMU input (or a caller of the library) sets.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum InputKind {
    /// Total translation \[m\] and rotation vector \[rad\], reached at the end of the communication step.
    Pose,
    /// Position \[m\] and orientation in the world, reached at the end of the communication step.
    WorldPose {
        /// Reference point \[m\] where the scene has it: the position that leaves it there.
        reference: Vec3,
    },
    /// Pose and twist together: reaches `pose + twist * h`, no lag.
    Motion,
    /// Velocity \[m/s\] and angular velocity \[rad/s\], constant over the step and integrated inside.
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
    /// Force \[N\] and torque \[N m\] on a free body, constant over the step.
    Load,
    /// Force \[N\] along the slide of a body, constant over the step.
    SlideForce {
        /// Unit axis, world.
        axis: Vec3,
    },
    /// Torque \[N m\] about the hinge of a body, constant over the step.
    HingeTorque {
        /// Unit axis, world.
        axis: Vec3,
    },
}

/// A command for a boundary with a [`Motion::input`](crate::scene::Motion::input), a belt or a servo
/// pressure that is set from outside, constant until the next one.
/// Components that the boundary's [`InputKind`] does not use are ignored.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Command {
    /// Total translation \[m\] from the scene (`Pose`, `Motion`).
    pub translation: Vec3,
    /// Total rotation vector \[rad\] from the scene (`Pose`, `Motion`); may exceed pi.
    pub rotation: Vec3,
    /// Position \[m\] of the reference point (`WorldPose`).
    pub position: Vec3,
    /// Rotation from the scene's placement (`WorldPose`): its length counts as 1, `q` and `-q` are the same.
    pub orientation: Quaternion<f64>,
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
    /// Velocity of the surface against the boundary \[m/s\], its own axes ([`crate::scene::Belt`]).
    pub surface_velocity: Vec3,
    /// Pressure of a servo boundary \[Pa\] ([`crate::scene::body::Servo::input`]).
    pub pressure: f64,
}

/// First and second derivative of a command by time: each component in its unit over s and s^2.
pub type CommandDerivatives = [Command; 2];

impl Command {
    /// The command `s` \[s\] later, `u + u' s + u'' s^2/2`.
    pub(crate) fn along(&self, [first, second]: &CommandDerivatives, s: f64) -> Self {
        self.plus(first, s).plus(second, 0.5 * s * s)
    }

    /// `self + scale * other`.
    #[must_use]
    pub fn plus(&self, other: &Self, scale: f64) -> Self {
        Self {
            translation: self.translation + other.translation * scale,
            rotation: self.rotation + other.rotation * scale,
            position: self.position + other.position * scale,
            orientation: self.orientation + other.orientation * scale,
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
