//! One place where a sphere may touch a boundary.

use crate::Vec3;

/// One place where a sphere may touch a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosestPoint {
    /// Stable number of the feature inside its boundary; coplanar facets that share an edge share it.
    pub feature: u32,
    /// Closest point `P0` \[m\].
    pub point: Vec3,
    /// Unit normal, from the boundary to the sphere.
    pub normal: Vec3,
    /// Distance of the centre along `normal` minus the radius \[m\]; negative: overlap.
    pub gap: f64,
    /// Largest principal curvature of the surface on which the centre moves while the gap stays constant
    /// \[1/m\]: 0 on a plane, `1/|c - P0|` at an edge or vertex, `1/(R_b - R)` inside a cylinder.
    /// Bounded by `1e6/R`, so that it stays finite where the centre meets the edge or the axis.
    pub curvature: f64,
}

impl ClosestPoint {
    /// Touch at a point of an edge or corner; `fallback` is the normal where the centre lies on the point.
    pub(super) fn at_point(
        feature: u32,
        point: Vec3,
        centre: Vec3,
        radius: f64,
        fallback: Vec3,
    ) -> Self {
        let arm = centre - point;
        let distance = arm.norm();
        Self {
            feature,
            point,
            normal: if distance > 1e-12 * radius {
                arm / distance
            } else {
                fallback
            },
            gap: distance - radius,
            curvature: 1.0 / distance.max(1e-6 * radius),
        }
    }
}

/// Sorts `out[start..]` by feature and leaves one per closest point, that of the lowest number: faces come
/// before edges, edges before corners.
pub(super) fn keep_distinct(out: &mut Vec<ClosestPoint>, start: usize, tolerance: f64) {
    out[start..].sort_unstable_by_key(|point| point.feature);
    let mut kept = start;
    for i in start..out.len() {
        let point = out[i];
        let repeated = out[start..kept]
            .iter()
            .any(|k| k.feature == point.feature || (k.point - point.point).norm() <= tolerance);
        if !repeated {
            out[kept] = point;
            kept += 1;
        }
    }
    out.truncate(kept);
}
