//! Why a geometry is refused.

use thiserror::Error;

use crate::Vec3;

/// A shape or mesh that cannot bound spheres. Facets and vertices are counted from 0 in the order given.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// A mesh file that cannot be opened or parsed.
    #[error("cannot read mesh `{path}`: {reason}; expected a binary or ASCII STL file")]
    Unreadable {
        /// The file.
        path: String,
        /// What the system or the reader says.
        reason: String,
    },
    /// Nothing is left to touch.
    #[error(
        "{name}: no facet of positive area among {facets}; expected at least one, check the file and its scale"
    )]
    Empty {
        /// The shape.
        name: String,
        /// Facets found, all of them slivers.
        facets: usize,
    },
    /// NaN or infinity.
    #[error("{name}: {what} is ({}, {}, {}); expected finite numbers", found.x, found.y, found.z)]
    NotFinite {
        /// The shape.
        name: String,
        /// Which point or direction.
        what: String,
        /// Its value.
        found: Vec3,
    },
    /// A facet refers to a vertex that does not exist.
    #[error("{name}: facet {facet} uses vertex {vertex}; expected an index below {vertices}")]
    Index {
        /// The shape.
        name: String,
        /// The facet.
        facet: usize,
        /// The vertex index found.
        vertex: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// An edge with more than two facets.
    #[error(
        "{name}: facets {facets:?} share the edge from ({}, {}, {}) to ({}, {}, {}); \
         expected at most two facets at an edge: delete duplicate facets or split the mesh into several shapes",
        edge[0].x, edge[0].y, edge[0].z, edge[1].x, edge[1].y, edge[1].z
    )]
    NonManifold {
        /// The shape.
        name: String,
        /// All facets at the edge.
        facets: Vec<usize>,
        /// Ends of the edge \[m\].
        edge: [Vec3; 2],
    },
    /// A mesh that should close and does not.
    #[error(
        "{name}: {edges} edges have one facet only, the first from ({}, {}, {}) to ({}, {}, {}); \
         expected a closed mesh: fill the hole there, or let neighbours share whole edges",
        edge[0].x, edge[0].y, edge[0].z, edge[1].x, edge[1].y, edge[1].z
    )]
    Open {
        /// The shape.
        name: String,
        /// Number of such edges.
        edges: usize,
        /// Ends of the first \[m\].
        edge: [Vec3; 2],
    },
    /// A polygon without area.
    #[error(
        "{name}: {vertices} vertices span an area of {area:e} m2; expected three or more that are not in line"
    )]
    Degenerate {
        /// The shape.
        name: String,
        /// Number of vertices.
        vertices: usize,
        /// Area found \[m^2\].
        area: f64,
    },
    /// A polygon that is not flat.
    #[error(
        "{name}: vertex {vertex} lies {distance:e} m off the polygon's plane; expected at most {tolerance:e} m: \
         correct it or split the polygon into triangles"
    )]
    NotPlanar {
        /// The shape.
        name: String,
        /// The vertex.
        vertex: usize,
        /// Its distance from the plane \[m\].
        distance: f64,
        /// What is allowed \[m\].
        tolerance: f64,
    },
    /// A polygon with a reflex corner or crossing edges.
    #[error(
        "{name}: the boundary turns back at vertex {vertex}; expected a convex polygon: split it into convex ones"
    )]
    NotConvex {
        /// The shape.
        name: String,
        /// The vertex.
        vertex: usize,
    },
    /// A direction of zero length.
    #[error("{name}: {what} has length 0; expected a direction")]
    Direction {
        /// The shape.
        name: String,
        /// Which direction.
        what: &'static str,
    },
    /// A number out of range.
    #[error("{name}: {what} is {found}; expected {expected}")]
    Range {
        /// The shape.
        name: String,
        /// Which number.
        what: String,
        /// Its value.
        found: f64,
        /// What is allowed.
        expected: &'static str,
    },
}

/// Refuses a point or direction that is not finite.
pub(super) fn finite(name: &str, what: impl Into<String>, v: Vec3) -> Result<(), GeometryError> {
    if v.iter().all(|x| x.is_finite()) {
        Ok(())
    } else {
        Err(GeometryError::NotFinite {
            name: name.into(),
            what: what.into(),
            found: v,
        })
    }
}

/// The unit vector along `v`, or why there is none.
pub(super) fn unit(name: &str, what: &'static str, v: Vec3) -> Result<Vec3, GeometryError> {
    finite(name, what, v)?;
    v.try_normalize(0.0)
        .ok_or_else(|| GeometryError::Direction {
            name: name.into(),
            what,
        })
}
