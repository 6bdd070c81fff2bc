//! What a step's problem is made from.

use crate::Vec3;
use crate::scene::Scene;
use crate::scene::particles::Kinematics;
use crate::spatial::{Pose, SpatialVector, Twist};
use crate::step::assemble::SphereMotion;
use crate::step::driven::BodyPrediction;

/// What a step's problem is made from.
#[derive(Debug, Clone, Copy)]
pub struct AssemblyInput<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// State at the start; velocities already match `step`.
    pub kinematics: &'a Kinematics,
    /// External acceleration, `[N]`.
    pub external: &'a [SpatialVector],
    /// The spheres as contacts see them, `[N]`.
    pub spheres: &'a [SphereMotion],
    /// Time step \[s\].
    pub step: f64,
    /// Boundary poses at the start and at the end, `[B]`; those of driven bodies at the end are without contacts.
    pub poses: [&'a [Pose]; 2],
    /// Driven bodies, `[D]`, by ascending boundary; boundaries that are not among them move as prescribed.
    pub bodies: &'a [BodyPrediction<'a>],
    /// Boundary twists over the previous step, `[B]`.
    pub twists: &'a [Twist],
    /// Velocities of the boundaries' surfaces against their shapes \[m/s\], world axes, `[B]`.
    pub surfaces: &'a [Vec3],
    /// Gravity \[m/s^2\].
    pub gravity: Vec3,
    /// Its size.
    pub gravity_size: f64,
    /// Spring targets at the end of the step \[m\], `[S]`.
    pub targets: &'a [Vec3],
    /// [`mean_acceleration`](crate::step::external::mean_acceleration) \[m/s^2\].
    pub mean_acceleration: f64,
}
