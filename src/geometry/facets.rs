//! Flat facets: polygons, boxes and triangle meshes, as given.

use nalgebra::UnitQuaternion;
use serde::{Deserialize, Serialize};

use super::error::{GeometryError, finite};
use crate::Vec3;
use crate::spatial::extent::corners;

/// Welding and flatness tolerance over the diagonal of the bounding box \[-\]: seven typed digits.
pub(super) const RELATIVE_TOLERANCE: f64 = 4e-7;

/// Triangles over shared vertices. Two-sided: the side of the sphere's centre decides the normal, so the
/// order of a triangle's vertices does not matter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Facets {
    /// What messages call it: a file name, `box`, `polygon` ...
    pub name: String,
    /// Vertices \[m\].
    pub vertices: Vec<Vec3>,
    /// Vertex indices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// How far a coordinate may be off because of the number format it was stored in \[m\]; 0 for double precision.
    pub rounding: f64,
    /// Whether vertices are computed, so that those which belong together agree to double precision. Others are
    /// taken to have seven correct digits of the mesh's size, as typed ones do.
    pub computed: bool,
}

impl Facets {
    /// A triangle mesh from arrays, for example from a reader of another format.
    #[must_use]
    pub fn mesh(name: impl Into<String>, vertices: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self {
            name: name.into(),
            vertices,
            triangles,
            rounding: 0.0,
            computed: false,
        }
    }

    /// A convex flat polygon of three or more corners \[m\], in order.
    ///
    /// # Errors
    /// Corners that are not finite, in line, off one plane, or not convex.
    pub fn polygon(corners: &[Vec3]) -> Result<Self, GeometryError> {
        Self::named_polygon("polygon", corners)
    }

    /// The triangle `a b c` \[m\].
    ///
    /// # Errors
    /// As [`Facets::polygon`].
    pub fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Result<Self, GeometryError> {
        Self::named_polygon("triangle", &[a, b, c])
    }

    /// The parallelogram with the corners `corner`, `corner + u`, `corner + u + v`, `corner + v` \[m\]: a
    /// rectangle where `u` is square to `v`.
    ///
    /// # Errors
    /// As [`Facets::polygon`].
    pub fn rectangle(corner: Vec3, u: Vec3, v: Vec3) -> Result<Self, GeometryError> {
        Self::named_polygon(
            "rectangle",
            &[corner, corner + u, corner + u + v, corner + v],
        )
    }

    /// The six faces of an axis-parallel box, which spheres touch from inside and outside. Turn it with
    /// [`Facets::placed`].
    ///
    /// # Errors
    /// Corners that are not finite, or `max` not above `min` in every direction.
    pub fn cuboid(min: Vec3, max: Vec3) -> Result<Self, GeometryError> {
        finite("box", "min", min)?;
        finite("box", "max", max)?;
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            let found = max[axis] - min[axis];
            if found <= 0.0 {
                return Err(GeometryError::Range {
                    name: "box".into(),
                    what: format!("size along {name}"),
                    found,
                    expected: "more than 0 m",
                });
            }
        }
        const QUADS: [[u32; 4]; 6] = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = QUADS
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect();
        Ok(Self::mesh("box", corners((min, max)).to_vec(), triangles))
    }

    /// The facets scaled about the origin by `scale` (0.001 for a file in millimetres), then turned about the
    /// origin by `rotation`, then moved by `translation` \[m\].
    #[must_use]
    pub fn placed(mut self, scale: f64, rotation: UnitQuaternion<f64>, translation: Vec3) -> Self {
        for v in &mut self.vertices {
            *v = rotation * (*v * scale) + translation;
        }
        self.rounding *= scale.abs();
        self
    }

    fn named_polygon(name: &str, corners: &[Vec3]) -> Result<Self, GeometryError> {
        for (i, &corner) in corners.iter().enumerate() {
            finite(name, format!("vertex {i}"), corner)?;
        }
        let n = corners.len();
        let corner = |i: usize| corners[i % n];
        // Newell's vector area does not depend on where the fan starts.
        let area: Vec3 = (1..n.saturating_sub(1))
            .map(|i| (corner(i) - corner(0)).cross(&(corner(i + 1) - corner(0))) * 0.5)
            .sum();
        let size = corners
            .iter()
            .map(|c| (c - corner(0)).norm())
            .fold(0.0, f64::max);
        if n < 3 || area.norm() <= RELATIVE_TOLERANCE * size * size {
            return Err(GeometryError::Degenerate {
                name: name.into(),
                vertices: n,
                area: area.norm(),
            });
        }
        let normal = area.normalize();
        // As typed by hand: three correct digits more than a plan would show.
        let tolerance = 1e-6 * size;
        for i in 0..n {
            let distance = (corner(i) - corner(0)).dot(&normal).abs();
            if distance > tolerance {
                return Err(GeometryError::NotPlanar {
                    name: name.into(),
                    vertex: i,
                    distance,
                    tolerance,
                });
            }
        }
        // Convex: seen from every edge all corners lie on its left; that excludes crossing edges as well.
        for i in 0..n {
            let edge = corner(i + 1) - corner(i);
            let left = normal.cross(&edge);
            if edge.norm() <= tolerance
                || corners
                    .iter()
                    .any(|c| (c - corner(i)).dot(&left) < -tolerance * edge.norm())
            {
                return Err(GeometryError::NotConvex {
                    name: name.into(),
                    vertex: (i + 1) % n,
                });
            }
        }
        let triangles = (1..n as u32 - 1).map(|i| [0, i, i + 1]).collect();
        Ok(Self::mesh(name, corners.to_vec(), triangles))
    }
}
