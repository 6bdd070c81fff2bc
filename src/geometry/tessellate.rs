//! Triangles of a geometry, for pictures.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::Geometry;
use super::plane::HalfSpace;
use super::revolution::Revolution;
use crate::Vec3;

/// Segments around a surface of revolution.
pub(super) const SEGMENTS: usize = 64;

/// A triangulated surface.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Triangulation {
    /// Points \[m\].
    pub points: Vec<Vec3>,
    /// Point indices of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Triangulation {
    fn push_triangle(&mut self, corners: [Vec3; 3]) {
        let first = self.points.len() as u32;
        self.points.extend(corners);
        self.triangles.push([first, first + 1, first + 2]);
    }

    /// A square of the plane that covers the shadow of the box `extent`.
    fn push_half_space(&mut self, plane: &HalfSpace, extent: (Vec3, Vec3)) {
        let half = (0.5 * (extent.1 - extent.0).norm()).max(f64::MIN_POSITIVE);
        let middle = plane.point(0.5 * (extent.0 + extent.1), 0.0).point;
        let u = plane
            .normal
            .cross(&Vec3::ith(plane.normal.iamin(), 1.0))
            .normalize()
            * half;
        let v = plane.normal.cross(&u);
        let [a, b, c, d] = [-u - v, u - v, u + v, v - u].map(|arm| middle + arm);
        self.push_triangle([a, b, c]);
        self.push_triangle([a, c, d]);
    }

    fn push_revolution(&mut self, surface: &Revolution) {
        let first = self.points.len() as u32;
        let [e1, e2] = surface.transverse();
        for segment in 0..SEGMENTS {
            let (sin, cos) = (TAU * segment as f64 / SEGMENTS as f64).sin_cos();
            let radial = e1 * cos + e2 * sin;
            self.points
                .extend(surface.profile.iter().map(|&p| surface.at(p, radial)));
        }
        let corners = surface.profile.len();
        let index = |segment: usize, corner: usize| {
            first + ((segment % SEGMENTS) * corners + corner) as u32
        };
        for segment in 0..SEGMENTS {
            for k in 0..corners - 1 {
                let [a, b] = [index(segment, k), index(segment, k + 1)];
                let [d, c] = [index(segment + 1, k), index(segment + 1, k + 1)];
                // A corner on the axis has no ring: one triangle of the two has no area.
                if surface.profile[k + 1].x > 0.0 {
                    self.triangles.push([a, b, c]);
                }
                if surface.profile[k].x > 0.0 {
                    self.triangles.push([a, c, d]);
                }
            }
        }
    }
}

impl Geometry {
    /// Triangles of the whole geometry: facets as they are after welding, half-spaces as a square that covers the
    /// shadow of the box `extent = (min, max)` \[m\], surfaces of revolution with 64 segments around.
    #[must_use]
    pub fn tessellate(&self, extent: (Vec3, Vec3)) -> Triangulation {
        let mut out = Triangulation::default();
        if let Some(mesh) = &self.mesh {
            out.points.extend(mesh.vertices());
            out.triangles.extend(mesh.indices());
        }
        for shape in self.shapes() {
            match shape {
                super::Shape::HalfSpace(plane) => out.push_half_space(plane, extent),
                super::Shape::Revolution(surface) => out.push_revolution(surface),
                super::Shape::Facets(_) => {}
            }
        }
        out
    }
}
