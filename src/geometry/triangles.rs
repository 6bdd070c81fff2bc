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
