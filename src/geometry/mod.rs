//! Boundaries: named rigid bodies made of faces, and the closest-point queries on them.
//!
//! For a sphere of centre `c` and radius `R` the closest point `P0` on a face, edge or vertex gives the
//! normal `n = (c - P0)/|c - P0|` and the gap `g = |c - P0| - R` (paper eqs 9-10, section IV).
//!
//! A [`Geometry`] is a list of [`Shape`]s: half-spaces, flat [`Facets`] (polygons, boxes, STL, terrain) and surfaces of
//! [`Revolution`] (cylinders, cones, discs). All facets of a boundary form one mesh, so a sphere rolls from one
//! to the next without noticing; between shapes of different kinds nothing is merged.
//! Half-spaces are one-sided; everything else is a thin sheet with two sides.

mod ball_fit;
mod closest_point;
mod error;
mod faces;
mod facets;
mod features;
mod mesh;
mod moments;
mod plane;
pub(crate) mod rays;
pub mod region;
mod revolution;
mod solid;
mod stl;
mod terrain;
mod tessellate;
mod topology;
mod triangle;
mod triangles;
mod union;
mod vicinity;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

pub use ball_fit::BallFit;
pub use closest_point::ClosestPoint;
pub use error::GeometryError;
pub use facets::Facets;
pub(crate) use features::Repair;
pub use moments::Moments;
pub use plane::HalfSpace;
pub use revolution::Revolution;
pub use solid::Solid;
pub use terrain::HeightField;
pub use tessellate::Triangulation;
pub(crate) use vicinity::{Ball, Vicinity};

use crate::Vec3;
use crate::spatial::extent::joined;
use mesh::Mesh;

/// One piece of a geometry, in scene coordinates.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// Solid half-space, one-sided.
    HalfSpace(HalfSpace),
    /// Polygons, boxes, triangle meshes, two-sided.
    Facets(Facets),
    /// Cylinders, cones, discs, two-sided.
    Revolution(Revolution),
}

impl From<HalfSpace> for Shape {
    fn from(shape: HalfSpace) -> Self {
        Self::HalfSpace(shape)
    }
}

impl From<Facets> for Shape {
    fn from(shape: Facets) -> Self {
        Self::Facets(shape)
    }
}

impl From<Revolution> for Shape {
    fn from(shape: Revolution) -> Self {
        Self::Revolution(shape)
    }
}

/// The faces of a boundary in its own frame (the scene's at t = 0).
///
/// Serialized as its shapes; what else the queries need is built anew. Clones share everything.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(try_from = "Vec<Shape>", into = "Vec<Shape>")]
pub struct Geometry {
    shapes: Arc<[Shape]>,
    /// All facets together; their features have the lowest numbers.
    mesh: Option<Arc<Mesh>>,
    /// Box around everything but half-spaces \[m\].
    bounds: Option<(Vec3, Vec3)>,
}

impl PartialEq for Geometry {
    fn eq(&self, other: &Self) -> bool {
        self.shapes == other.shapes
    }
}

impl TryFrom<Vec<Shape>> for Geometry {
    type Error = GeometryError;

    fn try_from(shapes: Vec<Shape>) -> Result<Self, GeometryError> {
        Self::new(shapes)
    }
}

impl From<Geometry> for Vec<Shape> {
    fn from(geometry: Geometry) -> Self {
        geometry.shapes.to_vec()
    }
}

impl Geometry {
    /// Prepares shapes for queries: welds facets, drops slivers (see [`Geometry::repair`]), finds flat groups and
    /// straight edges, builds the search tree.
    ///
    /// # Errors
    /// Facets that are not finite, refer to missing vertices, have no area at all, or (within one shape) meet in
    /// threes at an edge.
    pub fn new(shapes: Vec<Shape>) -> Result<Self, GeometryError> {
        let facets: Vec<&Facets> = shapes
            .iter()
            .filter_map(|shape| match shape {
                Shape::Facets(facets) => Some(facets),
                Shape::HalfSpace(_) | Shape::Revolution(_) => None,
            })
            .collect();
        let mesh = match facets[..] {
            [] => None,
            _ => Some(Arc::new(Mesh::new(&facets)?)),
        };
        let bounds = bounds(&shapes, mesh.as_deref());
        Ok(Self {
            shapes: shapes.into(),
            mesh,
            bounds,
        })
    }

    /// The shapes, as given.
    #[must_use]
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// What was mended in its facets; `None` without facets.
    #[must_use]
    pub fn repair(&self) -> Option<&Repair> {
        self.mesh.as_deref().map(Mesh::repair)
    }

    /// Appends every distinct place where a sphere of `radius` \[m\] around `centre` \[m\] comes within
    /// `reach` \[m\] of gap. Sorted by feature; an edge or vertex inside a neighbour's face is left out.
    ///
    /// Distinct places are the local minima of the distance from the centre to the surface, and the sectors of a ring
    /// contact (see [`Revolution`]). Where the centre lies on a sheet, the normal is that of the sheet's plane.
    pub fn closest_points(
        &self,
        centre: Vec3,
        radius: f64,
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        self.touches_by(None, (centre, radius), reach, out);
    }

    /// [`Self::closest_points`], exactly, by facets that were found before: faster while the centre stays so near that its
    /// reach lies in their ball.
    pub(crate) fn touches_near(
        &self,
        known: &Vicinity,
        (centre, radius): (Vec3, f64),
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        self.touches_by(Some(known), (centre, radius), reach, out);
    }

    /// Appends the facets that [`Self::touches_near`] needs for places up to `range` \[m\] from `centre`; their ball.
    pub(crate) fn facets_near(&self, centre: Vec3, range: f64, out: &mut Vec<u32>) -> Ball {
        match &self.mesh {
            Some(mesh) => mesh.facets_near(centre, range, out),
            None => Ball::default(),
        }
    }

    /// Whether some of it is made of facets.
    pub(crate) fn has_facets(&self) -> bool {
        self.mesh.is_some()
    }

    fn touches_by(
        &self,
        known: Option<&Vicinity>,
        (centre, radius): (Vec3, f64),
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        if let Some(mesh) = &self.mesh {
            mesh.closest_points(known, (centre, radius), reach, out);
        }
        self.touches_beside(centre, radius, reach, out);
    }

    /// A bound below the gaps up to `reach` \[m\] of a sphere \[m\], infinite if there are clearly none; `spare` is used for
    /// its memory.
    pub(crate) fn least_gap(
        &self,
        known: &Vicinity,
        (centre, radius): (Vec3, f64),
        reach: f64,
        spare: &mut Vec<ClosestPoint>,
    ) -> f64 {
        spare.clear();
        self.touches_beside(centre, radius, reach, spare);
        let clearance = |mesh: &Mesh| mesh.clearance(Some(known), centre, radius + reach);
        let mesh = self.mesh.as_deref().map_or(f64::INFINITY, clearance);
        let gaps = spare.iter().map(|point| point.gap);
        gaps.fold(mesh - radius, f64::min)
    }

    /// The touches on what is no facet.
    fn touches_beside(&self, centre: Vec3, radius: f64, reach: f64, out: &mut Vec<ClosestPoint>) {
        let mut first = self.mesh.as_deref().map_or(0, Mesh::features);
        for shape in self.shapes.iter() {
            let start = out.len();
            match shape {
                Shape::Facets(_) => {}
                Shape::HalfSpace(plane) => {
                    let point = plane.point(centre, radius);
                    if point.gap <= reach {
                        out.push(point);
                    }
                }
                Shape::Revolution(surface) => surface.closest_points(centre, radius, reach, out),
            }
            for point in &mut out[start..] {
                point.feature += first;
            }
            first += own_features(shape);
        }
    }

    /// Follows one feature: the gap of a sphere at `centre` to it, keeping the side of `normal` (a face keeps
    /// its side if the centre crosses it). Beyond the border of a face: the closest point of its border.
    ///
    /// A feature number that the geometry does not have gives a point with infinite gap.
    #[must_use]
    pub fn follow(&self, feature: u32, normal: Vec3, centre: Vec3, radius: f64) -> ClosestPoint {
        self.follow_known(feature, normal, centre, radius)
            .unwrap_or(ClosestPoint {
                feature,
                point: centre,
                normal,
                gap: f64::INFINITY,
                curvature: 0.0,
            })
    }

    fn follow_known(
        &self,
        feature: u32,
        normal: Vec3,
        centre: Vec3,
        radius: f64,
    ) -> Option<ClosestPoint> {
        let mut first = 0;
        if let Some(mesh) = &self.mesh {
            first = mesh.features();
            if feature < first {
                return mesh.follow(feature, normal, centre, radius);
            }
        }
        for shape in self.shapes.iter() {
            let local = feature - first;
            let count = own_features(shape);
            if local < count {
                let point = match shape {
                    Shape::Facets(_) => None,
                    Shape::HalfSpace(plane) => Some(plane.point(centre, radius)),
                    Shape::Revolution(surface) => surface.follow(local, normal, centre, radius),
                };
                return point.map(|point| ClosestPoint { feature, ..point });
            }
            first += count;
        }
        None
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around the geometry; `None` if it is empty or has a half-space.
    #[must_use]
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let half_space = |shape: &Shape| matches!(shape, Shape::HalfSpace(_));
        self.bounds.filter(|_| !self.shapes.iter().any(half_space))
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around everything but half-spaces; `None` if there is nothing else.
    pub(crate) fn finite_bounds(&self) -> Option<(Vec3, Vec3)> {
        self.bounds
    }
}

/// Box `(min, max)` \[m\] around facets and surfaces of revolution.
fn bounds(shapes: &[Shape], mesh: Option<&Mesh>) -> Option<(Vec3, Vec3)> {
    let vertices = mesh.into_iter().flat_map(Mesh::vertices);
    let surfaces = shapes.iter().filter_map(|shape| match shape {
        Shape::Revolution(surface) => Some(surface.bounds()),
        Shape::HalfSpace(_) | Shape::Facets(_) => None,
    });
    vertices.map(|&v| (v, v)).chain(surfaces).reduce(joined)
}

/// Features of a shape besides those of the common mesh.
fn own_features(shape: &Shape) -> u32 {
    match shape {
        Shape::Facets(_) => 0,
        Shape::HalfSpace(_) => 1,
        Shape::Revolution(surface) => surface.features(),
    }
}
