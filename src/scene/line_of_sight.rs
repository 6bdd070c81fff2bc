//! Boundaries as rays meet them.

use super::{Boundary, Scene};
use crate::Vec3;
use crate::geometry::rays::Rays;
use crate::spatial::Pose;

/// A boundary where it is.
pub(crate) struct Wall<'a> {
    pub(crate) boundary: &'a Boundary,
    pub(crate) pose: Pose,
    pub(crate) rays: Rays,
}

impl<'a> Wall<'a> {
    /// A boundary at a pose.
    pub(crate) fn new(boundary: &'a Boundary, pose: Pose) -> Self {
        Self {
            boundary,
            pose,
            rays: Rays::new(&boundary.geometry),
        }
    }

    /// A world point \[m\], or its copy in a periodic cell nearest to the boundary, in the boundary's frame.
    pub(crate) fn local(&self, scene: &Scene, x: Vec3) -> Vec3 {
        let near = self.boundary.copy_near(&scene.cell, &self.pose, x);
        self.boundary.to_frame(&self.pose, near)
    }

    /// Whether the ray from the world point `x` \[m\] along `direction` meets it.
    pub(crate) fn meets(&self, scene: &Scene, x: Vec3, direction: Vec3) -> bool {
        let direction = self.pose.rotation.inverse() * direction;
        self.rays.is_hit(self.local(scene, x), direction)
    }
}
