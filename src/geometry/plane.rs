//! The half-space: all points behind a plane are solid.
//!
//! `g = (c - x_p) . n - R`, with `x_p` a point of the plane \[m\] and `n` its outward unit normal. One-sided: a
//! centre behind the plane has a negative distance, so a sphere that was pushed through comes back.

use serde::{Deserialize, Serialize};

use super::ClosestPoint;
use super::error::{GeometryError, finite, unit};
use crate::Vec3;

/// The solid half-space behind a plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HalfSpace {
    /// A point of the plane \[m\].
    pub point: Vec3,
    /// Unit normal, out of the solid.
    pub normal: Vec3,
}

impl HalfSpace {
    /// The half-space behind the plane through `point` \[m\], of outward `normal` (any length).
    ///
    /// # Errors
    /// Numbers that are not finite, a normal of length 0.
    pub fn new(point: Vec3, normal: Vec3) -> Result<Self, GeometryError> {
        finite("half-space", "point", point)?;
        let normal = unit("half-space", "normal", normal)?;
        Ok(Self { point, normal })
    }

    pub(super) fn point(&self, centre: Vec3, radius: f64) -> ClosestPoint {
        let distance = (centre - self.point).dot(&self.normal);
        ClosestPoint {
            feature: 0,
            point: centre - self.normal * distance,
            normal: self.normal,
            gap: distance - radius,
            curvature: 0.0,
        }
    }
}
