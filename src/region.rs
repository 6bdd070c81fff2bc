//! Regions of space: what a packing fills, a source feeds, a sink empties, a sensor looks at. Fixed in the world.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::random::{symmetric, unit};

/// A region, closed below and open above along its own axes, so that adjacent regions share no point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Region {
    /// Axis-parallel box.
    Box {
        /// Lower corner \[m\].
        min: Vec3,
        /// Upper corner \[m\].
        max: Vec3,
    },
    /// Solid cylinder.
    Cylinder {
        /// Centre of the first end \[m\].
        base: Vec3,
        /// Unit vector from the first end to the second.
        axis: Vec3,
        /// Radius \[m\].
        radius: f64,
        /// Length \[m\].
        height: f64,
    },
    /// The points `x` with `(x - point) . normal >= 0`.
    Beyond {
        /// A point of the plane \[m\].
        point: Vec3,
        /// Unit normal.
        normal: Vec3,
    },
}

impl Region {
    /// Whether a point \[m\] lies in the region.
    #[must_use]
    pub fn contains(&self, x: Vec3) -> bool {
        match self {
            Self::Box { min, max } => (0..3).all(|k| min[k] <= x[k] && x[k] < max[k]),
            Self::Cylinder {
                base,
                axis,
                radius,
                height,
            } => {
                let along = (x - base).dot(axis);
                let across = x - base - axis * along;
                (0.0..*height).contains(&along) && across.norm_squared() < radius * radius
            }
            Self::Beyond { point, normal } => (x - point).dot(normal) >= 0.0,
        }
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around the region; `None` if it is unbounded.
    #[must_use]
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        match self {
            Self::Box { min, max } => Some((*min, *max)),
            Self::Cylinder {
                base,
                axis,
                radius,
                height,
            } => {
                let top = base + axis * *height;
                // A disc across `axis` reaches r sqrt(1 - a_k^2) along direction k.
                let disc = axis.map(|a| radius * (1.0 - a * a).max(0.0).sqrt());
                Some((base.inf(&top) - disc, base.sup(&top) + disc))
            }
            Self::Beyond { .. } => None,
        }
    }

    /// Centre \[m\], uniform in space, of a sphere of `radius` \[m\] that lies wholly in the region; `None` if it does
    /// not fit or the region is unbounded.
    pub fn random_centre(&self, radius: f64, random: &mut ChaCha8Rng) -> Option<Vec3> {
        let fits = |room: &f64| *room >= 0.0;
        match self {
            Self::Box { min, max } => {
                let room = (max - min).add_scalar(-2.0 * radius);
                room.iter()
                    .all(|r| fits(r))
                    .then(|| min.add_scalar(radius) + room.map(|room| room * unit(random)))
            }
            Self::Cylinder {
                base,
                axis,
                radius: wide,
                height,
            } => {
                let around = Some(wide - radius).filter(fits)?;
                let along = Some(height - 2.0 * radius).filter(fits)?;
                let side = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
                // By rejection: sine and cosine differ between machines.
                let (u, v) = loop {
                    let (u, v) = (symmetric(random), symmetric(random));
                    if u * u + v * v <= 1.0 {
                        break (u, v);
                    }
                };
                let across = (side * u + axis.cross(&side) * v) * around;
                Some(base + across + axis * (radius + along * unit(random)))
            }
            Self::Beyond { .. } => None,
        }
    }

    /// Volume \[m^3\]; infinite beyond a plane.
    #[must_use]
    pub fn volume(&self) -> f64 {
        match self {
            Self::Box { min, max } => (max - min).product(),
            Self::Cylinder { radius, height, .. } => {
                std::f64::consts::PI * radius * radius * height
            }
            Self::Beyond { .. } => f64::INFINITY,
        }
    }
}
