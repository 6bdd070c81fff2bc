//! Boxes and cylinders: regions of which sensors also know how much of a sphere or of a line lies inside.

use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::random::{symmetric, unit};

/// Relative length by which a confined sphere keeps clear of curved borders, above rounding \[-\].
pub(super) const SLACK: f64 = 1e-9;

/// A box or a cylinder, closed below and open above along its own axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Primitive {
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
}

impl Primitive {
    /// Whether a point \[m\] lies in the region.
    pub(crate) fn contains(&self, x: Vec3) -> bool {
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
        }
    }

    /// Whether a whole sphere \[m\] lies in the region; touching its border counts as inside.
    pub(crate) fn holds(&self, centre: Vec3, radius: f64) -> bool {
        match self {
            Self::Box { min, max } => {
                (0..3).all(|k| min[k] + radius <= centre[k] && centre[k] <= max[k] - radius)
            }
            Self::Cylinder {
                base,
                axis,
                radius: bore,
                height,
            } => {
                let along = (centre - base).dot(axis);
                let across = centre - base - axis * along;
                along >= radius && along <= height - radius && across.norm() <= bore - radius
            }
        }
    }

    /// Where a sphere \[m\] whose centre lies in the region has to go, to first order, so that the whole of it does.
    /// A sphere too large for the region finds no such place: ask [`Self::holds`].
    pub(crate) fn confine(&self, centre: Vec3, radius: f64) -> Vec3 {
        match self {
            Self::Box { min, max } => centre
                .sup(&min.add_scalar(radius))
                .inf(&max.add_scalar(-radius)),
            Self::Cylinder {
                base,
                axis,
                radius: bore,
                height,
            } => {
                let along = (centre - base).dot(axis);
                let across = centre - base - axis * along;
                let room = (bore - radius) * (1.0 - SLACK);
                let scale = (room / across.norm()).min(1.0);
                let within = along.min(height - radius * (1.0 + SLACK));
                base + axis * within.max(radius * (1.0 + SLACK)) + across * scale
            }
        }
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around the region.
    pub(crate) fn bounds(&self) -> (Vec3, Vec3) {
        match self {
            Self::Box { min, max } => (*min, *max),
            Self::Cylinder {
                base,
                axis,
                radius,
                height,
            } => {
                let top = base + axis * *height;
                // A disc across `axis` reaches r sqrt(1 - a_k^2) along direction k.
                let disc = axis.map(|a| radius * (1.0 - a * a).max(0.0).sqrt());
                (base.inf(&top) - disc, base.sup(&top) + disc)
            }
        }
    }

    /// Centre \[m\], uniform in space, of a sphere of `radius` \[m\] that lies wholly in the region; `None` if it does
    /// not fit.
    pub(crate) fn random_centre(&self, radius: f64, random: &mut ChaCha8Rng) -> Option<Vec3> {
        let fits = |room: &f64| *room >= 0.0;
        match self {
            Self::Box { min, max } => {
                let room = (max - min).add_scalar(-2.0 * radius);
                room.iter()
                    .all(&fits)
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
        }
    }

    /// Volume \[m^3\].
    pub(crate) fn volume(&self) -> f64 {
        match self {
            Self::Box { min, max } => (max - min).product(),
            Self::Cylinder { radius, height, .. } => {
                std::f64::consts::PI * radius * radius * height
            }
        }
    }
}
