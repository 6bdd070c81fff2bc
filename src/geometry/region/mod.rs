//! Regions of space: what a packing fills, a source feeds, a sink empties, a sensor looks at. Fixed in the world.

mod primitive;

use std::sync::Arc;

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::geometry::{ClosestPoint, Solid};
use crate::spatial::cell::Cell;
pub use primitive::Primitive;
use primitive::SLACK;

/// A region, closed below and open above along its own axes, so that adjacent regions share no point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Region {
    /// A box or a cylinder.
    Primitive(Primitive),
    /// The inside of a closed mesh; its surface belongs to one side or the other.
    Mesh(Arc<Solid>),
    /// The points `x` with `(x - point) . normal >= 0`.
    Beyond {
        /// A point of the plane \[m\].
        point: Vec3,
        /// Unit normal.
        normal: Vec3,
    },
    /// All points outside an axis-parallel box.
    Outside {
        /// Lower corner \[m\].
        min: Vec3,
        /// Upper corner \[m\].
        max: Vec3,
    },
}

impl From<Primitive> for Region {
    fn from(primitive: Primitive) -> Self {
        Self::Primitive(primitive)
    }
}

impl Region {
    /// Whether a point \[m\] lies in the region.
    #[must_use]
    pub fn contains(&self, x: Vec3) -> bool {
        match self {
            Self::Primitive(primitive) => primitive.contains(x),
            Self::Mesh(solid) => solid.contains(x),
            Self::Beyond { point, normal } => (x - point).dot(normal) >= 0.0,
            Self::Outside { min, max } => x.inf(max).sup(min) != x,
        }
    }

    /// Whether a copy of a point \[m\] in a periodic cell lies in the region.
    pub(crate) fn contains_copy(&self, cell: &Cell, x: Vec3) -> bool {
        match self.bounds() {
            Some(bounds) => {
                let mut copies = cell.copies(x, bounds, 0.0);
                copies.any(|image| self.contains(x + cell.shift(image)))
            }
            None => self.contains(cell.wrapped(x)),
        }
    }

    /// Whether a whole sphere \[m\] lies in the region; touching its border counts as inside.
    #[must_use]
    pub fn holds(&self, centre: Vec3, radius: f64) -> bool {
        match self {
            Self::Primitive(primitive) => primitive.holds(centre, radius),
            Self::Mesh(solid) => solid.holds(centre, radius),
            Self::Beyond { point, normal } => (centre - point).dot(normal) >= radius,
            Self::Outside { min, max } => (centre - centre.inf(max).sup(min)).norm() >= radius,
        }
    }

    /// Where a sphere \[m\] whose centre lies in the region has to go, to first order, so that the whole of it does.
    /// `closest_points` is scratch. A sphere too large for the region finds no such place: ask [`Self::holds`].
    #[must_use]
    pub fn confine(
        &self,
        centre: Vec3,
        radius: f64,
        closest_points: &mut Vec<ClosestPoint>,
    ) -> Vec3 {
        match self {
            Self::Primitive(primitive) => primitive.confine(centre, radius),
            Self::Mesh(solid) => {
                closest_points.clear();
                solid.closest_points(centre, radius, 0.0, closest_points);
                closest_points.iter().fold(centre, |c, point| {
                    c - point.normal * (point.gap - SLACK * radius)
                })
            }
            Self::Beyond { point, normal } => {
                let missing = radius - (centre - point).dot(normal);
                centre + normal * missing.max(0.0)
            }
            // A box has no single way out.
            Self::Outside { .. } => centre,
        }
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around the region; `None` if it is unbounded.
    #[must_use]
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        match self {
            Self::Primitive(primitive) => Some(primitive.bounds()),
            Self::Mesh(solid) => Some(solid.bounds()),
            Self::Beyond { .. } | Self::Outside { .. } => None,
        }
    }

    /// Centre \[m\], uniform in space, of a sphere of `radius` \[m\] that lies wholly in the region; `None` if it does
    /// not fit or the region is unbounded.
    pub fn random_centre(&self, radius: f64, random: &mut ChaCha8Rng) -> Option<Vec3> {
        match self {
            Self::Primitive(primitive) => primitive.random_centre(radius, random),
            Self::Mesh(solid) => solid.random_centre(radius, random),
            Self::Beyond { .. } | Self::Outside { .. } => None,
        }
    }

    /// Volume \[m^3\]; infinite beyond a plane and outside a box.
    pub(crate) fn volume(&self) -> f64 {
        match self {
            Self::Primitive(primitive) => primitive.volume(),
            Self::Mesh(solid) => solid.volume(),
            Self::Beyond { .. } | Self::Outside { .. } => f64::INFINITY,
        }
    }
}
