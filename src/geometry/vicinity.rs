//! Facets near a place: a search within a cube looks through those of a larger cube instead of the whole mesh.
//!
//! The facets of a cube are those whose bounding box meets it. A cube inside another meets no others, so that both ways
//! find the same facets, in the same order.

use rstar::{AABB, Envelope};

use crate::Vec3;

/// A cube along the axes \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cube(pub(super) AABB<[f64; 3]>);

impl Cube {
    /// All points within `range` \[m\] of `middle` \[m\] along every axis.
    pub(super) fn around(middle: Vec3, range: f64) -> Self {
        let [low, high] = [-range, range].map(|way| middle.add_scalar(way).into());
        Self(AABB::from_corners(low, high))
    }

    /// Whether the other cube lies in it.
    pub(super) fn contains(&self, other: &Self) -> bool {
        self.0.contains_envelope(&other.0)
    }

    /// One that contains nothing.
    pub(super) fn empty() -> Self {
        Self(AABB::new_empty())
    }
}

/// All facets of a mesh that meet a cube.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vicinity<'f> {
    cube: Cube,
    facets: &'f [u32],
}

impl<'f> Vicinity<'f> {
    /// `facets` as [`super::Geometry::facets_near`] found them in `cube`.
    pub(crate) fn new(cube: Cube, facets: &'f [u32]) -> Self {
        Self { cube, facets }
    }

    /// The facets to look through for those of `cube`; `None` if there may be others.
    pub(super) fn facets(&self, cube: &Cube) -> Option<&'f [u32]> {
        self.cube.contains(cube).then_some(self.facets)
    }
}
