//! The inside of a closed triangle mesh.
//!
//! A point is inside if a ray from it to z = +infinity crosses the surface an odd number of times. The crossings
//! are counted exactly: on which side of an edge or a facet the ray passes is decided by exact predicates
//! (Shewchuk 1997), and where it meets an edge or a vertex the point is taken as moved by `(e, e^2)` in x and y with
//! an infinitesimal `e` (Edelsbrunner and Muecke 1990), so that no facet is missed or counted twice.
//!
//! The volume is the surface integral `1/3 int x . n dA` (divergence theorem) of every shell, turned outwards;
//! a shell inside an odd number of others is a cavity and counts negative. The order of a facet's vertices in the
//! file does not matter.

use nalgebra::Vector3;
use rand_chacha::ChaCha8Rng;
use robust::{Coord, Coord3D, orient2d, orient3d};
use serde::{Deserialize, Serialize};

use super::error::GeometryError;
use super::facets::Facets;
use super::mesh::Mesh;
use super::{ClosestPoint, topology};
use crate::Vec3;
use crate::random::unit;
use crate::spatial::extent::around;

/// Random points tried to place a sphere.
const POINTS: usize = 10_000;

/// A closed mesh ready for queries. Serialized as its facets.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Facets", into = "Facets")]
pub struct Solid {
    facets: Facets,
    mesh: Mesh,
    bounds: (Vec3, Vec3),
    volume: f64,
}

impl PartialEq for Solid {
    fn eq(&self, other: &Self) -> bool {
        self.facets == other.facets
    }
}

impl TryFrom<Facets> for Solid {
    type Error = GeometryError;

    fn try_from(facets: Facets) -> Result<Self, GeometryError> {
        Self::new(facets)
    }
}

impl From<Solid> for Facets {
    fn from(solid: Solid) -> Self {
        solid.facets
    }
}

impl Solid {
    /// Welds the facets and checks that they close.
    ///
    /// # Errors
    /// What [`super::Geometry::new`] refuses, and [`GeometryError::Open`] for an edge with one facet.
    pub fn new(facets: Facets) -> Result<Self, GeometryError> {
        let mesh = Mesh::new(&[&facets])?;
        let (edges, edge_of) = topology::edges(mesh.indices());
        let open: Vec<_> = edges.iter().filter(|e| e.triangles.len() < 2).collect();
        if let Some(first) = open.first() {
            return Err(GeometryError::Open {
                name: facets.name,
                edges: open.len(),
                edge: first.ends.map(|v| mesh.vertices()[v as usize]),
            });
        }
        let bounds = around(mesh.vertices().iter().copied());
        let mut solid = Self {
            facets,
            mesh,
            bounds,
            volume: 0.0,
        };
        let shells = shells(solid.mesh.indices(), &edges, &edge_of);
        solid.volume = solid.measure(&shells);
        Ok(solid)
    }

    /// Whether a point \[m\] lies inside. Decided exactly for the welded mesh; the surface belongs to one side.
    #[must_use]
    pub fn contains(&self, x: Vec3) -> bool {
        let crossed = |t: &u32| crosses(&self.mesh.corners(*t), x);
        self.mesh.above(x).filter(crossed).count() % 2 == 1
    }

    /// Whether a whole sphere \[m\] lies inside.
    #[must_use]
    pub fn holds(&self, centre: Vec3, radius: f64) -> bool {
        let mut closest_points = Vec::new();
        self.closest_points(centre, radius, 0.0, &mut closest_points);
        closest_points.iter().all(|point| point.gap >= 0.0) && self.contains(centre)
    }

    /// Appends the places of the surface within `reach` \[m\] of gap, as [`super::Geometry::closest_points`] does.
    pub(crate) fn closest_points(
        &self,
        centre: Vec3,
        radius: f64,
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        self.mesh.closest_points(None, (centre, radius), reach, out);
    }

    /// Centre \[m\], uniform in space, of a sphere of `radius` \[m\] that lies wholly inside; `None` if many random
    /// points find no such place.
    pub(crate) fn random_centre(&self, radius: f64, random: &mut ChaCha8Rng) -> Option<Vec3> {
        let low = self.bounds.0.add_scalar(radius);
        let side = self.bounds.1.add_scalar(-radius) - low;
        if side.iter().any(|side| *side < 0.0) {
            return None;
        }
        (0..POINTS)
            .map(|_| low + side.map(|side| side * unit(random)))
            .find(|place| self.holds(*place, radius))
    }

    /// Smallest axis-parallel box `(min, max)` \[m\] around it.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, Vec3) {
        self.bounds
    }

    /// Volume \[m^3\].
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// Sum over the shells; `shells` has the number of its shell and its orientation (1, -1) for each triangle.
    fn measure(&self, shells: &[(usize, f64)]) -> f64 {
        let corners: Vec<_> = (0..shells.len() as u32)
            .map(|t| self.mesh.corners(t))
            .collect();
        let number = shells.iter().map(|(shell, _)| shell + 1).max().unwrap_or(0);
        let mut volume = 0.0;
        for shell in 0..number {
            let own = || (0..corners.len()).filter(|&t| shells[t].0 == shell);
            // About the middle of the box: far from the origin the sum would cancel.
            let middle = (self.bounds.0 + self.bounds.1) * 0.5;
            let signed: f64 = own()
                .map(|t| {
                    let [a, b, c] = corners[t].map(|v| v - middle);
                    shells[t].1 * a.dot(&b.cross(&c)) / 6.0
                })
                .sum();
            let probe = own().next().map_or(middle, |t| corners[t][0]);
            let around = (0..corners.len())
                .filter(|&t| shells[t].0 != shell && crosses(&corners[t], probe))
                .count();
            volume += if around % 2 == 0 {
                signed.abs()
            } else {
                -signed.abs()
            };
        }
        volume
    }
}

/// The connected shell of each triangle and whether its order of vertices runs with (1) or against (-1) that of the
/// first one of the shell.
fn shells(
    triangles: &[[u32; 3]],
    edges: &[topology::Edge],
    edge_of: &[[u32; 3]],
) -> Vec<(usize, f64)> {
    // +1 if the triangle runs through its edge `slot` from the lower vertex number to the higher.
    let runs = |t: usize, slot: usize| {
        let [from, to] = [slot, (slot + 1) % 3].map(|k| triangles[t][k]);
        if from < to { 1.0 } else { -1.0 }
    };
    let mut found: Vec<Option<(usize, f64)>> = vec![None; triangles.len()];
    let mut number = 0;
    for seed in 0..triangles.len() {
        if found[seed].is_some() {
            continue;
        }
        found[seed] = Some((number, 1.0));
        let mut front = vec![(seed, 1.0)];
        while let Some((t, sign)) = front.pop() {
            for (slot, &edge) in edge_of[t].iter().enumerate() {
                for next in edges[edge as usize].triangles.iter().map(|&n| n as usize) {
                    if found[next].is_some() {
                        continue;
                    }
                    let other = (0..3).find(|&k| edge_of[next][k] == edge).unwrap_or(0);
                    // Neighbours that agree run through their edge in opposite directions.
                    let sign = -sign * runs(t, slot) * runs(next, other);
                    found[next] = Some((number, sign));
                    front.push((next, sign));
                }
            }
        }
        number += 1;
    }
    found.into_iter().flatten().collect()
}

/// Whether the ray from `x` to z = +infinity crosses the triangle.
fn crosses(&[a, b, c]: &[Vec3; 3], x: Vec3) -> bool {
    let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| left_of(p, q, x));
    let up = match sides {
        [Some(true), Some(true), Some(true)] => 1.0,
        [Some(false), Some(false), Some(false)] => -1.0,
        _ => return false,
    };
    let at = |v: Vec3| Coord3D {
        x: v.x,
        y: v.y,
        z: v.z,
    };
    // Positive where x lies below the plane of a, b, c seen counterclockwise from above.
    up * orient3d(at(a), at(b), at(c), at(x)) > 0.0
}

/// Whether `x` moved by `(e, e^2)` lies left of the line `p q` seen from above; `None` if that line is a point.
fn left_of(p: Vec3, q: Vec3, x: Vec3) -> Option<bool> {
    let at = |v: Vec3| Coord { x: v.x, y: v.y };
    let side = orient2d(at(p), at(q), at(x));
    let along: Vector3<f64> = q - p;
    // What the move adds to the determinant, in falling order: `-e along.y`, `e^2 along.x`.
    [side, -along.y, along.x]
        .into_iter()
        .find(|s| *s != 0.0)
        .map(|s| s > 0.0)
}
