//! The inside of a closed triangle mesh.
//!
//! A point is inside if a ray from it to z = +infinity crosses the surface an odd number of times. The crossings
//! are counted exactly: on which side of an edge or a facet the ray passes is decided by exact predicates
//! (Shewchuk 1997), and where it meets an edge or a vertex the point is taken as moved by `(e, e^2)` in x and y with
//! an infinitesimal `e` (Edelsbrunner and Muecke 1990), so that no facet is missed or counted twice.
//!
//! Volume, centroid and inertia are exact sums over the tetrahedra `(0, a, b, c)` of all facets (divergence theorem), with
//! `D = a . (b x c)` and `s = a + b + c`:
//!
//! ```text
//! int dV = D/6,   int x dV = D/24 s,   int x x^T dV = D/120 (a a^T + b b^T + c c^T + s s^T)
//! ```
//!
//! of every shell, turned outwards; a shell inside an odd number of others is a cavity and counts negative. The order of a
//! facet's vertices in the file does not matter.

use nalgebra::{Matrix3, Vector3};
use rand_chacha::ChaCha8Rng;
use robust::{Coord, Coord3D, orient2d, orient3d};
use serde::{Deserialize, Serialize};

use super::error::GeometryError;
use super::facets::Facets;
use super::features::Repair;
use super::mesh::Mesh;
use super::moments::Moments;
use super::tessellate::Triangulation;
use super::{ClosestPoint, topology};
use crate::Vec3;
use crate::random::unit;
use crate::spatial::extent::around;

/// Random points tried to place a sphere.
const POINTS: usize = 10_000;
/// `1/p` and `1/p^2` of the plastic number `p^3 = p + 1`.
const PLASTIC: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

/// A closed mesh ready for queries. Serialized as its facets.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Facets", into = "Facets")]
pub struct Solid {
    facets: Facets,
    mesh: Mesh,
    bounds: (Vec3, Vec3),
    moments: Moments,
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
        // A facet without area, which is left out, may have vertices anywhere.
        let corners = mesh.indices().iter().flatten();
        let bounds = around(corners.map(|&v| mesh.vertices()[v as usize]));
        let moments = measure(&mesh, bounds, &shells(mesh.indices(), &edges, &edge_of));
        Ok(Self {
            facets,
            mesh,
            bounds,
            moments,
        })
    }

    /// What was mended in its facets.
    #[must_use]
    pub fn repair(&self) -> &Repair {
        self.mesh.repair()
    }

    /// Its surface, welded.
    #[must_use]
    pub fn surface(&self) -> Triangulation {
        Triangulation {
            points: self.mesh.vertices().to_vec(),
            triangles: self.mesh.indices().to_vec(),
        }
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
        self.moments.volume
    }

    /// Volume, centroid and inertia.
    #[must_use]
    pub fn moments(&self) -> &Moments {
        &self.moments
    }

    /// Distance of a point \[m\] from the surface \[m\].
    #[must_use]
    pub fn distance(&self, x: Vec3) -> f64 {
        self.mesh.distance(x)
    }

    /// `count` points spread evenly over the surface \[m\]: equal areas apart along the list of facets, and within a facet by the
    /// additive recurrence of the plastic number (Roberts 2018).
    #[must_use]
    pub fn surface_points(&self, count: usize) -> Vec<Vec3> {
        let facets = self.mesh.indices().len() as u32;
        let corners: Vec<_> = (0..facets).map(|t| self.mesh.corners(t)).collect();
        let areas = corners
            .iter()
            .map(|[a, b, c]| (b - a).cross(&(c - a)).norm());
        let ends: Vec<f64> = areas
            .scan(0.0, |sum, area| {
                *sum += area;
                Some(*sum)
            })
            .collect();
        let whole = ends.last().copied().unwrap_or(0.0);
        let point = |k: usize| {
            let along = (k as f64 + 0.5) / count as f64 * whole;
            let [a, b, c] = corners[ends.partition_point(|&end| end <= along)];
            let [mut u, mut v] = PLASTIC.map(|step| (0.5 + step * (k as f64 + 1.0)).fract());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            a + (b - a) * u + (c - a) * v
        };
        (0..count).map(point).collect()
    }
}

/// Sum over the shells; `shells` has the number of its shell and its orientation (1, -1) for each triangle.
fn measure(mesh: &Mesh, bounds: (Vec3, Vec3), shells: &[(usize, f64)]) -> Moments {
    let corners: Vec<_> = (0..shells.len() as u32).map(|t| mesh.corners(t)).collect();
    let number = shells.iter().map(|(shell, _)| shell + 1).max().unwrap_or(0);
    // About the middle of the box: far from the origin the sums would cancel.
    let middle = (bounds.0 + bounds.1) * 0.5;
    let (mut volume, mut first, mut second) = (0.0, Vec3::zeros(), Matrix3::zeros());
    for shell in 0..number {
        let own = || (0..corners.len()).filter(|&t| shells[t].0 == shell);
        let probe = own().next().map_or(middle, |t| corners[t][0]);
        let around = (0..corners.len())
            .filter(|&t| shells[t].0 != shell && crosses(&corners[t], probe))
            .count();
        let tetrahedra = own().map(|t| {
            let [a, b, c] = corners[t].map(|v| v - middle);
            let (size, sum) = (shells[t].1 * a.dot(&b.cross(&c)), a + b + c);
            let square: Matrix3<f64> = [a, b, c, sum].map(|v| v * v.transpose()).iter().sum();
            (size / 6.0, sum * (size / 24.0), square * (size / 120.0))
        });
        let (v, x, xx) = tetrahedra.fold(
            (0.0, Vec3::zeros(), Matrix3::zeros()),
            |(v, x, xx), (dv, dx, dxx)| (v + dv, x + dx, xx + dxx),
        );
        let sign = f64::signum(v) * if around % 2 == 0 { 1.0 } else { -1.0 };
        volume += sign * v;
        first += x * sign;
        second += xx * sign;
    }
    Moments::of_integrals(middle, (volume, first, second))
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
