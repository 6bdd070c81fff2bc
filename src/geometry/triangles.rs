//! On which triangles of the tessellation a contact is.

use std::f64::consts::TAU;

use super::revolution::{HalfPlane, Revolution, on_piece};
use super::tessellate::SEGMENTS;
use super::{Geometry, Shape, own_features};
use crate::Vec3;

impl Geometry {
    /// Number of triangles of [`Self::tessellate`].
    #[must_use]
    pub fn triangles(&self) -> usize {
        let facets = self.mesh.as_deref().map_or(0, |mesh| mesh.indices().len());
        let others = self.shapes().iter().map(own_triangles);
        facets + others.sum::<usize>()
    }

    /// Areas \[m^2\] of the triangles of [`Self::tessellate`].
    pub fn areas(&self) -> impl Iterator<Item = f64> {
        let area = |[a, b, c]: [Vec3; 3]| 0.5 * (b - a).cross(&(c - a)).norm();
        self.corners().into_iter().map(area)
    }

    /// Corners \[m\] of the triangles of [`Self::tessellate`].
    #[must_use]
    pub fn corners(&self) -> Vec<[Vec3; 3]> {
        let patch = self.tessellate((Vec3::zeros(), Vec3::zeros()));
        let corners = patch.triangles.iter();
        corners
            .map(|triangle| triangle.map(|point| patch.points[point as usize]))
            .collect()
    }

    /// Appends the triangles of [`Self::tessellate`] that feel a contact at the point `x` \[m\] of `feature`, in ascending order: of
    /// facets all on which the point lies, two on an edge between them and more in a corner; of surfaces of revolution one. A
    /// half-space has none: its square is a picture.
    pub(crate) fn triangles_at(&self, feature: u32, x: Vec3, out: &mut Vec<u32>) {
        let (mut features, mut triangles) = (0, 0);
        if let Some(mesh) = &self.mesh {
            features = mesh.features();
            triangles = mesh.indices().len();
            if feature < features {
                return mesh.triangles_at(feature, x, out);
            }
        }
        for shape in self.shapes() {
            features += own_features(shape);
            if feature < features {
                if let Shape::Revolution(surface) = shape {
                    out.push((triangles + surface.triangle_at(x)) as u32);
                }
                return;
            }
            triangles += own_triangles(shape);
        }
    }
}

/// Triangles of a shape besides those of the common mesh.
fn own_triangles(shape: &Shape) -> usize {
    match shape {
        Shape::Facets(_) => 0,
        Shape::HalfSpace(_) => 2,
        Shape::Revolution(surface) => SEGMENTS * surface.of_segment(0..surface.profile.len() - 1),
    }
}

impl Revolution {
    /// Triangles of these pieces of the profile in one segment: a corner on the axis has no ring.
    fn of_segment(&self, pieces: std::ops::Range<usize>) -> usize {
        let ends = pieces.flat_map(|piece| [piece, piece + 1]);
        ends.filter(|&corner| self.profile[corner].x > 0.0).count()
    }

    /// The triangle of the segment in which the point `x` \[m\] lies, on the nearest piece of the profile.
    fn triangle_at(&self, x: Vec3) -> usize {
        let HalfPlane { centre, radial } = self.half_plane(x);
        let [e1, e2] = self.transverse();
        let angle = radial.dot(&e2).atan2(radial.dot(&e1)).rem_euclid(TAU);
        let around = angle / TAU * SEGMENTS as f64;
        let segment = (around as usize).min(SEGMENTS - 1);
        let pieces = 0..self.profile.len() - 1;
        let ends = |piece: usize| [self.profile[piece], self.profile[piece + 1]];
        let off = |piece: &usize| {
            let [a, b] = ends(*piece);
            (on_piece(a, b, centre).0 - centre).norm_squared()
        };
        let nearest = pieces.clone().min_by(|a, b| off(a).total_cmp(&off(b)));
        let piece = nearest.unwrap_or_default();
        let [a, b] = ends(piece);
        let along = on_piece(a, b, centre).1.clamp(0.0, 1.0);
        // On which side of the diagonal from the first corner of the segment to the opposite one.
        let share = around - segment as f64;
        let first = a.x == 0.0 || share * (a.x + (b.x - a.x) * along) < along * b.x;
        let second = usize::from(!first && b.x > 0.0);
        segment * self.of_segment(pieces) + self.of_segment(0..piece) + second
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Facets;
    use proptest::prelude::*;

    /// A box, a cone, a cup and a disc apart from each other: facets come first, then each surface of revolution.
    fn geometry() -> Geometry {
        let corner = Vec3::new(1.0, 1.0, 0.5);
        let foot = Facets::cuboid(-corner, corner).unwrap();
        let (base, up) = (Vec3::new(3.1, 0.2, 0.5), Vec3::new(0.1, -0.3, 1.0));
        let cone = Revolution::frustum(base, up, 0.3, 0.0, 1.0).unwrap();
        let profile = [[0.0, 0.0], [0.8, 0.3], [0.4, 0.9]];
        let cup = Revolution::new(base * 2.0, up, &profile).unwrap();
        let disc = Revolution::disc(base * 3.0, up, 0.0, 0.7).unwrap();
        Geometry::new(vec![cone.into(), foot.into(), cup.into(), disc.into()]).unwrap()
    }

    proptest! {
        /// A point inside a triangle, brought to the true surface, is felt by this triangle.
        #[test]
        fn points_are_found_in_their_triangles(pick in 0.0..1.0_f64, u in 0.01..0.98_f64, v in 0.01..0.98_f64) {
            let geometry = geometry();
            let all = geometry.tessellate((Vec3::zeros(), Vec3::zeros()));
            prop_assert_eq!(all.triangles.len(), geometry.triangles());
            let number = (pick * all.triangles.len() as f64) as usize;
            let [a, b, c] = all.triangles[number].map(|point| all.points[point as usize]);
            let (u, v) = if u + v < 0.99 { (u, v) } else { (0.99 - 0.98 * u, 0.99 - 0.98 * v) };
            prop_assume!(u + v < 0.99);
            let x = a + (b - a) * u + (c - a) * v;
            let mut near = Vec::new();
            geometry.closest_points(x, 1e-3, 0.1, &mut near);
            let distance = |point: &&crate::geometry::ClosestPoint| (point.point - x).norm();
            let nearest = near.iter().min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap();
            let mut found = Vec::new();
            geometry.triangles_at(nearest.feature, nearest.point, &mut found);
            prop_assert_eq!(found, vec![number as u32]);
        }
    }
}
