//! Closest points on a facet mesh.
//!
//! A sphere touches the mesh wherever the distance from its centre has a local minimum over the whole surface.
//! A point `x` on an edge or vertex is one only if no triangle through `x` comes closer to the centre; else it
//! lies in that triangle's contact cone and is dropped. The test asks which triangles pass through `x`, not which
//! are joined there, so facets that meet without sharing vertices leave no ghost edges either.

use std::ops::ControlFlow;

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, Envelope, RTree};

use super::closest_point::{ClosestPoint, keep_distinct};
use super::error::GeometryError;
use super::faces::Faces;
use super::facets::Facets;
use super::features::{Feature, Repair, Topology};
use super::topology;
use super::triangle::{on_segment, on_triangle};
use super::vicinity::{Ball, Vicinity, cube};
use crate::Vec3;

/// Most facets that are looked through one by one; among more the tree is faster.
const MOST_FACETS: usize = 128;
/// Likewise of the facets of one face, those beside a point.
const MOST_IN_FACE: usize = 32;

/// A mesh ready for queries.
#[derive(Debug, Clone)]
pub(super) struct Mesh {
    topology: Topology,
    /// Lengths that rounding may produce \[m\], far below the tolerance.
    slack: f64,
    tree: RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>,
    sheets: Vec<TriangleBounds>,
    /// How far features of a triangle lie from its plane at most \[m\].
    bulge: f64,
    faces: Faces,
}

/// Where a triangle may be: its bounding box, as in the tree, and the plane `normal . x = offset` of its face.
#[derive(Debug, Clone, Copy)]
struct TriangleBounds {
    bounds: AABB<[f64; 3]>,
    normal: Vec3,
    offset: f64,
    /// A circle around it.
    middle: Vec3,
    radius: f64,
}

impl TriangleBounds {
    /// Whether the triangle is clearly farther than `range` \[m\] from a point, or no feature of it is nearer that lies off its
    /// plane by up to `bulge` \[m\].
    fn is_beyond(&self, x: Vec3, range: f64, bulge: f64) -> bool {
        let (height, range) = (self.height(x), range + bulge);
        if height > range {
            return true;
        }
        // Within its plane, by Pythagoras, rounded generously.
        let wide = (range * range - height * height).sqrt() + self.radius;
        (x - self.middle).norm_squared() > (wide * wide + height * height) * (1.0 + 1e-9)
    }

    /// Distance of a point from the plane \[m\].
    fn height(&self, x: Vec3) -> f64 {
        (self.normal.dot(&x) - self.offset).abs()
    }
}

impl Mesh {
    pub(super) fn new(shapes: &[&Facets]) -> Result<Self, GeometryError> {
        let topology = topology::build(shapes)?;
        let mut largest: f64 = 0.0;
        let triangles = 0..topology.triangles.len() as u32;
        let sheets = triangles.clone().map(|t| {
            let [a, b, c] = topology.corners(t);
            let (min, max) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
            largest = largest.max(min.amax()).max(max.amax());
            let (normal, offset) = topology.plane(t);
            let bounds = AABB::from_corners(min.into(), max.into());
            let middle = (a + b + c) / 3.0;
            let radius = [a, b, c].map(|corner| (corner - middle).norm());
            TriangleBounds {
                bounds,
                normal,
                offset,
                middle,
                radius: radius.into_iter().fold(0.0, f64::max) + topology.tolerance,
            }
        });
        let sheets: Vec<_> = sheets.collect();
        let leaves = sheets.iter().zip(triangles);
        let leaves = leaves.map(|(sheet, t)| GeomWithData::new(Rectangle::from(sheet.bounds), t));
        let bulges = sheets
            .iter()
            .zip(&topology.parts)
            .flat_map(|(sheet, parts)| {
                let ends = parts[1..].iter().map(|&part| topology.ends(part));
                ends.flatten().map(|x| sheet.height(x))
            });
        let bulge = bulges.fold(0.0, f64::max);
        let face: Vec<u32> = topology.parts.iter().map(|parts| parts[0]).collect();
        let bounds: Vec<_> = sheets.iter().map(|sheet| sheet.bounds).collect();
        Ok(Self {
            slack: (1e-3 * topology.tolerance).max(16.0 * f64::EPSILON * largest),
            tree: RTree::bulk_load(leaves.collect()),
            topology,
            sheets,
            bulge,
            faces: Faces::new(&face, &bounds),
        })
    }

    /// Number of features.
    pub(super) fn features(&self) -> u32 {
        self.topology.features()
    }

    pub(super) fn repair(&self) -> &Repair {
        &self.topology.repair
    }

    /// Welded vertices \[m\]. Slivers that were left out may have been the only ones at some.
    pub(super) fn vertices(&self) -> &[Vec3] {
        &self.topology.vertices
    }

    /// Corners of a triangle \[m\].
    pub(super) fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.topology.corners(triangle)
    }

    /// Numbers of the welded vertices of each triangle.
    pub(super) fn indices(&self) -> &[[u32; 3]] {
        &self.topology.triangles
    }

    /// The triangles whose bounding box meets the ray from `x` to z = +infinity.
    pub(super) fn above(&self, x: Vec3) -> impl Iterator<Item = u32> {
        let ray = AABB::from_corners([x.x, x.y, x.z], [x.x, x.y, f64::MAX]);
        self.tree
            .locate_in_envelope_intersecting(ray)
            .map(|leaf| leaf.data)
    }

    /// Distance of a point from the nearest triangle \[m\].
    pub(super) fn distance(&self, x: Vec3) -> f64 {
        let mut least = f64::INFINITY;
        // Boxes come by their distances: the first that is farther than a triangle ends the search.
        for (leaf, bound) in self.tree.nearest_neighbor_iter_with_distance_2(x.into()) {
            if bound >= least {
                break;
            }
            let (closest, _) = on_triangle(&self.topology.corners(leaf.data), x);
            least = least.min((closest - x).norm_squared());
        }
        least.sqrt()
    }

    /// Appends the triangles in which [`Self::closest_points`] finds all places up to `range` \[m\] from `centre`; the ball that
    /// they meet. None, and a ball without contents, where they are many.
    pub(super) fn facets_near(&self, centre: Vec3, range: f64, out: &mut Vec<u32>) -> Ball {
        let start = out.len();
        let range = self.widened(range);
        let many = self.near((centre, range), None, |t| {
            if !self.sheets[t as usize].is_beyond(centre, range, self.bulge) {
                out.push(t);
            }
            match out.len() - start > MOST_FACETS {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        });
        if many.is_break() {
            out.truncate(start);
            return Ball::default();
        }
        Ball::around(centre, range)
    }

    /// A range in which all facets lie that a place at most `range` \[m\] away may be on, and those around that place.
    fn widened(&self, range: f64) -> f64 {
        range + 4.0 * self.topology.tolerance
    }

    /// As [`super::Geometry::closest_points`]; searches inside the ball of `known` look through its facets only.
    pub(super) fn closest_points(
        &self,
        known: Option<&Vicinity>,
        (centre, radius): (Vec3, f64),
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        let start = out.len();
        let range = radius + reach + self.topology.tolerance;
        let _: ControlFlow<()> = self.near((centre, range), known, |t| {
            if self.sheets[t as usize].is_beyond(centre, range, self.bulge) {
                return ControlFlow::Continue(());
            }
            let (closest, feature) = self.closest_in(t, centre);
            let seen = out[start..].iter().any(|point| point.feature == feature);
            if seen || (closest.is_none() && self.topology.is_face(feature)) {
                return ControlFlow::Continue(());
            }
            let Some(point) = self.point(feature, closest, centre, radius) else {
                return ControlFlow::Continue(());
            };
            let local = || closest.is_some() || !self.is_undercut(known, point.point, centre);
            if point.gap <= reach && local() {
                out.push(point);
            }
            ControlFlow::Continue(())
        });
        keep_distinct(out, start, self.topology.tolerance);
    }

    /// A bound below the distances \[m\] of the places that [`Self::closest_points`] finds up to `range` \[m\] from `centre`, without
    /// looking for them; infinite if there are clearly none.
    pub(super) fn clearance(&self, known: Option<&Vicinity>, centre: Vec3, range: f64) -> f64 {
        let tolerance = self.topology.tolerance;
        let (mut least, place) = (f64::INFINITY, centre.into());
        let _: ControlFlow<()> = self.near((centre, range + tolerance), known, |t| {
            let sheet = &self.sheets[t as usize];
            let height = sheet.height(centre) - self.bulge;
            if height < least {
                least = least.min(height.max(sheet.bounds.distance_2(&place).sqrt()));
            }
            ControlFlow::Continue(())
        });
        // Welded vertices and joined edges lie off the triangles by so much.
        least - 4.0 * tolerance
    }

    pub(super) fn follow(
        &self,
        feature: u32,
        normal: Vec3,
        centre: Vec3,
        radius: f64,
    ) -> Option<ClosestPoint> {
        match self.topology.feature(feature)? {
            Feature::Face {
                normal: face,
                offset,
                border,
            } => {
                let distance = face.dot(&centre) - offset;
                let foot = centre - face * distance;
                let side = if face.dot(&normal) < 0.0 { -1.0 } else { 1.0 };
                if self.face_contains(feature, foot) {
                    return Some(ClosestPoint {
                        feature,
                        point: foot,
                        normal: face * side,
                        gap: distance * side - radius,
                        curvature: 0.0,
                    });
                }
                let nearest = border
                    .iter()
                    .map(|ends| ends.map(|v| self.topology.vertices[v as usize]))
                    .map(|[a, b]| on_segment(a, b, foot))
                    .min_by(|p, q| {
                        (p - foot)
                            .norm_squared()
                            .total_cmp(&(q - foot).norm_squared())
                    });
                Some(ClosestPoint::at_point(
                    feature,
                    nearest.unwrap_or(foot),
                    centre,
                    radius,
                    face * side,
                ))
            }
            Feature::Edge { ends: [a, b], .. } => Some(ClosestPoint::at_point(
                feature,
                on_segment(a, b, centre),
                centre,
                radius,
                normal,
            )),
            Feature::Vertex { point, .. } => Some(ClosestPoint::at_point(
                feature, point, centre, radius, normal,
            )),
        }
    }

    /// The point on a feature; `foot` is the centre's foot where the feature is a face.
    fn point(
        &self,
        feature: u32,
        foot: Option<Vec3>,
        centre: Vec3,
        radius: f64,
    ) -> Option<ClosestPoint> {
        Some(match self.topology.feature(feature)? {
            Feature::Face { normal, offset, .. } => {
                let distance = normal.dot(&centre) - offset;
                ClosestPoint {
                    feature,
                    point: foot.unwrap_or(centre - normal * distance),
                    normal: if distance < 0.0 { -normal } else { normal },
                    gap: distance.abs() - radius,
                    curvature: 0.0,
                }
            }
            Feature::Edge {
                ends: [a, b],
                normal,
            } => ClosestPoint::at_point(feature, on_segment(a, b, centre), centre, radius, normal),
            Feature::Vertex { point, normal } => {
                ClosestPoint::at_point(feature, point, centre, radius, normal)
            }
        })
    }

    /// The feature of triangle `t` closest to `c`, and the foot of `c` on the plane of its face if the triangle
    /// contains it.
    fn closest_in(&self, t: u32, c: Vec3) -> (Option<Vec3>, u32) {
        let parts = &self.topology.parts[t as usize];
        let (foot, normal) = self.foot(t, c);
        let (closest, part) = on_triangle(&self.topology.corners(t), foot);
        let off = closest - foot;
        let contained = (off - normal * off.dot(&normal)).norm() <= self.slack;
        if contained {
            (Some(foot), parts[0])
        } else {
            (None, parts[part])
        }
    }

    /// Foot of `c` on the plane of the face that triangle `t` belongs to, and its normal. All triangles of a face
    /// use one plane: they tile it without gaps or overlaps.
    fn foot(&self, t: u32, c: Vec3) -> (Vec3, Vec3) {
        let (normal, offset) = self.topology.plane(t);
        (c - normal * (normal.dot(&c) - offset), normal)
    }

    /// Whether a triangle through `x` has a point closer to the centre `c` than `x`.
    fn is_undercut(&self, known: Option<&Vicinity>, x: Vec3, c: Vec3) -> bool {
        self.near((x, self.topology.tolerance), known, |t| {
            let corners = &self.topology.corners(t);
            if (on_triangle(corners, x).0 - x).norm() > self.topology.tolerance {
                return ControlFlow::Continue(());
            }
            let w = on_triangle(corners, self.foot(t, c).0).0 - x;
            // |c - x - w| < |c - x| without cancellation. The factor .6 instead of .5 keeps two facets with a
            // crack between them from ruling each other out by rounding.
            if w.norm() > self.slack && (c - x).dot(&w) > 0.6 * w.norm_squared() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .is_break()
    }

    /// Appends the triangles of a feature on which its point `x` \[m\] lies, ascending; the nearest one where rounding leaves none.
    pub(super) fn triangles_at(&self, feature: u32, x: Vec3, out: &mut Vec<u32>) {
        let start = out.len();
        let near = 2.0 * self.topology.tolerance;
        let has = |t: u32| self.topology.parts[t as usize].contains(&feature);
        let distance = |t: u32| (on_triangle(&self.topology.corners(t), x).0 - x).norm();
        let _: ControlFlow<()> = self.near((x, near), None, |t| {
            if has(t) && distance(t) <= near {
                out.push(t);
            }
            ControlFlow::Continue(())
        });
        out[start..].sort_unstable();
        if out.len() == start {
            let all = (0..self.indices().len() as u32).filter(|&t| has(t));
            out.extend(all.min_by(|&s, &t| distance(s).total_cmp(&distance(t))));
        }
    }

    fn face_contains(&self, feature: u32, foot: Vec3) -> bool {
        let tolerance = self.topology.tolerance;
        let cube = cube(foot, tolerance);
        let contains = |t: u32| self.closest_in(t, foot).0.is_some();
        let facets = self.faces.beside(feature, foot, tolerance);
        if facets.len() <= MOST_IN_FACE {
            return facets.iter().any(|&t| self.meets(t, &cube) && contains(t));
        }
        self.near((foot, tolerance), None, |t| {
            if self.topology.parts[t as usize][0] == feature && contains(t) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .is_break()
    }

    /// Whether the bounding box of triangle `t` meets `cube`.
    fn meets(&self, t: u32, cube: &AABB<[f64; 3]>) -> bool {
        self.sheets[t as usize].bounds.intersects(cube)
    }

    /// Visits the triangles whose bounding box meets the cube around a ball, and at least those that meet the ball.
    fn near<B>(
        &self,
        (middle, range): (Vec3, f64),
        known: Option<&Vicinity>,
        mut visit: impl FnMut(u32) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let cube = cube(middle, range);
        match known.and_then(|known| known.facets(middle, range)) {
            Some(facets) => {
                let mut met = facets.iter().filter(|&&t| self.meets(t, &cube));
                met.try_for_each(|&t| visit(t))
            }
            None => self
                .tree
                .locate_in_envelope_intersecting_int(cube, |leaf| visit(leaf.data)),
        }
    }
}
