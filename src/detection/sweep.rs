//! Swept contact: whether two bodies touch on straight paths through a step, wherever they are at its ends.

use super::configuration::Configuration;
use crate::Vec3;
use crate::geometry::{ClosestPoint, Geometry};
use crate::spatial::cell::Image;

/// A gap below this share of the radius counts as contact.
const MET: f64 = 1e-3;
/// Most advances along a path; one that grazes a surface for longer counts as contact.
const ADVANCES: usize = 1000;

/// Smallest distance from the origin on the segment `a`-`b` \[m\].
pub(crate) fn least_distance(a: Vec3, b: Vec3) -> f64 {
    let way = b - a;
    let length2 = way.norm_squared();
    if length2 == 0.0 {
        return a.norm();
    }
    (a + way * (-a.dot(&way) / length2).clamp(0.0, 1.0)).norm()
}

/// Whether a sphere of `radius` \[m\] that goes from `a` to `b` in the geometry's frame touches it, by conservative
/// advancement: the gap is a distance it can go without touching.
pub(crate) fn meets(geometry: &Geometry, a: Vec3, b: Vec3, radius: f64) -> bool {
    let length = (b - a).norm();
    if length == 0.0 {
        return false;
    }
    let along = (b - a) / length;
    let (mut gone, mut closest_points) = (0.0, Vec::<ClosestPoint>::new());
    for _ in 0..ADVANCES {
        closest_points.clear();
        geometry.closest_points(a + along * gone, radius, length - gone, &mut closest_points);
        let Some(gap) = closest_points.iter().map(|t| t.gap).min_by(f64::total_cmp) else {
            return false;
        };
        if gap <= MET * radius {
            return true;
        }
        gone += gap;
        if gone >= length {
            return false;
        }
    }
    true
}

impl Configuration<'_> {
    /// Centre of sphere `i` from that of image `image` of sphere `j` \[m\].
    pub(crate) fn between(&self, i: u32, j: u32, image: Image) -> Vec3 {
        self.position[i as usize] - self.position[j as usize] - self.cell.shift(image)
    }

    /// The path of sphere `i` from here to `end` in the frame of boundary `b` \[m\], by the copy that is nearest to it here.
    pub(crate) fn path_in_frame(&self, end: &Self, i: u32, b: u16) -> [Vec3; 2] {
        let (b, i) = (usize::from(b), i as usize);
        let boundary = &self.boundaries[b];
        let near = boundary.copy_near(self.cell, &self.poses[b], self.position[i]);
        let copy = near - self.position[i];
        [self, end].map(|at| boundary.to_frame(&at.poses[b], at.position[i] + copy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Facets;

    #[test]
    fn segments_pass_the_origin_at_their_least_distance() {
        let v = Vec3::new;
        assert_eq!(least_distance(v(-3.0, 1.0, 0.0), v(2.0, 1.0, 0.0)), 1.0);
        assert_eq!(least_distance(v(3.0, 4.0, 0.0), v(6.0, 8.0, 0.0)), 5.0);
        assert_eq!(least_distance(v(0.0, 0.0, 2.0), v(0.0, 0.0, 2.0)), 2.0);
    }

    #[test]
    fn a_way_through_a_sheet_meets_it_and_one_beside_it_does_not() {
        let v = Vec3::new;
        let sheet = Facets::rectangle(Vec3::zeros(), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0));
        let sheet = Geometry::new(vec![sheet.expect("a sheet").into()]).expect("a geometry");
        for (x, met) in [(0.5, true), (1.09, true), (1.11, false), (-0.2, false)] {
            let way = [v(x, 0.5, 3.0), v(x, 0.5, -4.0)];
            assert_eq!(meets(&sheet, way[0], way[1], 0.1), met, "{x}");
            assert_eq!(meets(&sheet, way[1], way[0], 0.1), met, "{x}");
        }
        assert!(!meets(&sheet, v(-2.0, 0.5, 0.11), v(3.0, 0.5, 0.11), 0.1));
    }
}
