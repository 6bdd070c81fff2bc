//! Regions of space: what a packing fills, a source feeds, a sink empties, a sensor looks at. Fixed in the world.

use serde::{Deserialize, Serialize};

use crate::Vec3;

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
