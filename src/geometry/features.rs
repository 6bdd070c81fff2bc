//! A welded mesh and its named features: faces, straight edges, corners.

use super::topology::Repair;
use crate::Vec3;

/// A named part of the mesh surface.
#[derive(Debug, Clone, Copy)]
pub(super) enum Feature<'m> {
    /// A flat group of triangles in the plane `normal . x = offset`, and its border as pairs of vertices.
    Face {
        normal: Vec3,
        offset: f64,
        border: &'m [[u32; 2]],
    },
    /// A straight edge; `normal` of one of its faces, for a centre that lies on it.
    Edge { ends: [Vec3; 2], normal: Vec3 },
    /// A corner; `normal` of one of its faces, for a centre that lies on it.
    Vertex { point: Vec3, normal: Vec3 },
}

/// A flat group.
#[derive(Debug, Clone)]
pub(super) struct Face {
    pub(super) normal: Vec3,
    pub(super) offset: f64,
    /// Where its border begins and ends in the mesh's list.
    pub(super) border: [u32; 2],
}

/// A welded mesh with its features, numbered faces first, then edges, then vertices.
#[derive(Debug, Clone)]
pub(super) struct Topology {
    /// Welded vertices \[m\].
    pub(super) vertices: Vec<Vec3>,
    /// Vertices of each triangle.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Feature of each part of each triangle: face, edges ab, bc, ca, vertices a, b, c.
    pub(super) parts: Vec<[u32; 7]>,
    pub(super) faces: Vec<Face>,
    pub(super) border: Vec<[u32; 2]>,
    /// Ends and one face of each straight edge.
    pub(super) edges: Vec<([u32; 2], u32)>,
    /// Vertex and one face of each corner.
    pub(super) corners: Vec<(u32, u32)>,
    /// Points closer than this are one \[m\].
    pub(super) tolerance: f64,
    pub(super) repair: Repair,
}

impl Topology {
    /// Number of features.
    pub(super) fn features(&self) -> u32 {
        (self.faces.len() + self.edges.len() + self.corners.len()) as u32
    }

    /// The feature of this number; `None` if there is none.
    pub(super) fn feature(&self, number: u32) -> Option<Feature<'_>> {
        let number = number as usize;
        let point = |v: u32| self.vertices[v as usize];
        let normal = |face: u32| self.faces[face as usize].normal;
        if let Some(face) = self.faces.get(number) {
            let [first, end] = face.border.map(|k| k as usize);
            return Some(Feature::Face {
                normal: face.normal,
                offset: face.offset,
                border: &self.border[first..end],
            });
        }
        let number = number - self.faces.len();
        if let Some(&(ends, face)) = self.edges.get(number) {
            return Some(Feature::Edge {
                ends: ends.map(point),
                normal: normal(face),
            });
        }
        let &(vertex, face) = self.corners.get(number - self.edges.len())?;
        Some(Feature::Vertex {
            point: point(vertex),
            normal: normal(face),
        })
    }

    /// The points \[m\] between which an edge or corner lies; none for a face.
    pub(super) fn ends(&self, number: u32) -> impl Iterator<Item = Vec3> {
        let ends = match self.feature(number) {
            Some(Feature::Edge { ends, .. }) => ends.map(Some),
            Some(Feature::Vertex { point, .. }) => [Some(point), None],
            Some(Feature::Face { .. }) | None => [None; 2],
        };
        ends.into_iter().flatten()
    }

    /// Whether the feature of this number is a face.
    pub(super) fn is_face(&self, number: u32) -> bool {
        (number as usize) < self.faces.len()
    }

    /// Normal and offset of the plane of the face that a triangle belongs to.
    pub(super) fn plane(&self, triangle: u32) -> (Vec3, f64) {
        let face = &self.faces[self.parts[triangle as usize][0] as usize];
        (face.normal, face.offset)
    }

    /// Corners of a triangle \[m\].
    pub(super) fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.triangles[triangle as usize].map(|v| self.vertices[v as usize])
    }
}
