//! Facets near a place: a search within a ball looks through those of a larger ball instead of the whole mesh.
//!
//! The facets of a ball are those that are not clearly outside. What a smaller ball inside it meets is among them, so that both
//! ways find the same places.

use rstar::AABB;

use crate::Vec3;

/// All points within a distance of a point; the default has none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Ball {
    middle: Vec3,
    /// Radius \[m\]; 0: no point at all.
    range: f64,
}

impl Ball {
    /// All points within `range` \[m\] of `middle` \[m\].
    pub(super) fn around(middle: Vec3, range: f64) -> Self {
        Self { middle, range }
    }

    /// Whether all points within `range` \[m\] of `middle` \[m\] lie in it.
    pub(super) fn contains(&self, middle: Vec3, range: f64) -> bool {
        let room = (self.range - range) * (1.0 - 1e-9);
        room >= 0.0 && (self.middle - middle).norm_squared() <= room * room
    }
}

/// The cube along the axes around a ball \[m\].
pub(super) fn cube(middle: Vec3, range: f64) -> AABB<[f64; 3]> {
    let [low, high] = [-range, range].map(|way| middle.add_scalar(way).into());
    AABB::from_corners(low, high)
}

/// All facets of a mesh that meet a ball.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vicinity<'f> {
    ball: Ball,
    facets: &'f [u32],
}

impl<'f> Vicinity<'f> {
    /// `facets` as [`super::Geometry::facets_near`] found them in `ball`.
    pub(crate) fn new(ball: Ball, facets: &'f [u32]) -> Self {
        Self { ball, facets }
    }

    /// The facets to look through for those within `range` \[m\] of `middle` \[m\]; `None` if there may be others.
    pub(super) fn facets(&self, middle: Vec3, range: f64) -> Option<&'f [u32]> {
        self.ball.contains(middle, range).then_some(self.facets)
    }
}
