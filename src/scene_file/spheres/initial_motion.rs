//! How a sphere starts, and what a group of spheres is added to.

use nalgebra::UnitQuaternion;

use crate::Vec3;
use crate::scene::Boundary;
use crate::scene::clump::Clump;
use crate::scene::particles::{Kinematics, Particles};
use crate::spatial::cell::Cell;

/// Most spheres of a scene: a bound that catches a mistyped count before it eats the memory.
pub(crate) const MOST_SPHERES: usize = 10_000_000;

/// How a sphere starts.
pub(super) struct InitialMotion {
    pub(super) position: Vec3,
    pub(super) orientation: UnitQuaternion<f64>,
    pub(super) velocity: Vec3,
    pub(super) spin: Vec3,
}

impl InitialMotion {
    pub(super) fn at(position: Vec3) -> Self {
        Self {
            position,
            orientation: UnitQuaternion::identity(),
            velocity: Vec3::zeros(),
            spin: Vec3::zeros(),
        }
    }
}

/// What a group is added to.
pub(crate) struct Present<'a> {
    /// The spheres so far.
    pub(crate) particles: &'a mut Particles,
    /// How they start.
    pub(crate) initial: &'a mut Kinematics,
    /// The clumps among them.
    pub(crate) clumps: &'a mut Vec<Clump>,
    /// The boundaries; `None` if one of them was refused.
    pub(crate) boundaries: Option<&'a [Boundary]>,
    /// The periodic cell.
    pub(crate) cell: Cell,
}
