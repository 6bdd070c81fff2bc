//! Surfaces of revolution: cylinder, cone, frustum, disc, annulus, or a whole hopper as one profile.
//!
//! In the half-plane `(rho, z)` through the axis and the sphere's centre the surface is a polyline, the profile,
//! and the closest point is found there: for `rho_c > 0` the distance to a ring is least at the centre's own
//! azimuth and nowhere else, so each straight piece and each corner of the profile gives at most one point. Two-sided,
//! as facets are. With `n = (n_rho, n_z)` the normal, the centre moves on the offset surface, whose principal
//! curvatures are `|n_rho|/rho_c` around the axis (Meusnier) and, at a corner, `1/|c - P0|` in the half-plane: for a
//! cylinder of radius `R_b` that is `1/(R_b - R)` inside and `1/(R_b + R)` outside.
//!
//! A sphere inside and so close to the axis that the far side is in reach as well touches a whole ring (a ball that plugs an
//! outlet, or rests on the rim of a hole). One point cannot represent that: it jumps to the other side where the centre crosses
//! the axis. There each piece and corner gives the closest point of each of eight sectors about the axis instead, which stays
//! in its sector. They are points of the surface, so none forbids anything that the surface allows, and one is the closest.

use std::f64::consts::{PI, TAU};

use serde::{Deserialize, Serialize};

use super::closest_point::{ClosestPoint, keep_distinct};
use super::error::{GeometryError, finite, unit};
use crate::Vec3;

/// Number of sectors.
const SECTORS: usize = 8;
/// A gap on the far side below this share of the radius makes a ring.
const RING: f64 = 0.05;
/// Lengths below this share of the profile's size are rounding \[-\].
const SLACK: f64 = 1e-10;

type Vec2 = nalgebra::Vector2<f64>;

/// A profile turned about an axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Revolution {
    /// Point of the axis with `z = 0` \[m\].
    pub origin: Vec3,
    /// Unit axis, direction of `z`.
    pub axis: Vec3,
    /// Corners `(rho, z)` of the profile \[m\], `[K, 2]`, `K >= 2`, `rho >= 0`.
    pub profile: Vec<Vec2>,
}

/// The centre in the half-plane.
pub(super) struct HalfPlane {
    /// `(rho, z)` of the centre \[m\].
    pub(super) centre: Vec2,
    /// Unit radial direction.
    pub(super) radial: Vec3,
}

/// What a feature number stands for.
enum Feature {
    Piece(usize),
    Corner(usize),
    Sector { part: usize, sector: usize },
}

impl Revolution {
    /// The surface swept by `profile` (corners `(rho, z)` \[m\]) about the axis through `origin` \[m\]. Corners in line
    /// with their neighbours are left out.
    ///
    /// # Errors
    /// Numbers that are not finite, an axis of length 0, a negative radius, fewer than two distinct corners.
    pub fn new(origin: Vec3, axis: Vec3, profile: &[[f64; 2]]) -> Result<Self, GeometryError> {
        Self::named("surface of revolution", origin, axis, profile)
    }

    /// The side of a cone frustum: `base_radius` \[m\] at `base`, `top_radius` \[m\] at `base + height * axis`, both ends
    /// open. One radius may be 0 (cone); equal radii make a cylinder. Add [`Revolution::disc`]s to close it, or give
    /// [`Revolution::new`] the whole profile, which joins them without ghost edges.
    ///
    /// # Errors
    /// As [`Revolution::new`]; a height that is not positive.
    pub fn frustum(
        base: Vec3,
        axis: Vec3,
        base_radius: f64,
        top_radius: f64,
        height: f64,
    ) -> Result<Self, GeometryError> {
        let name = if base_radius == top_radius {
            "cylinder"
        } else {
            "cone"
        };
        positive(name, "height", height)?;
        positive(name, "larger radius", base_radius.max(top_radius))?;
        Self::named(
            name,
            base,
            axis,
            &[[base_radius, 0.0], [top_radius, height]],
        )
    }

    /// The side of a cylinder of `radius` \[m\] from `base` to `base + height * axis`, open at both ends.
    ///
    /// # Errors
    /// As [`Revolution::frustum`].
    pub fn cylinder(
        base: Vec3,
        axis: Vec3,
        radius: f64,
        height: f64,
    ) -> Result<Self, GeometryError> {
        Self::frustum(base, axis, radius, radius, height)
    }

    /// The flat ring between `inner_radius` and `radius` \[m\] around `centre`, square to `axis`; a disc where
    /// `inner_radius` is 0.
    ///
    /// # Errors
    /// As [`Revolution::new`]; radii not in order.
    pub fn disc(
        centre: Vec3,
        axis: Vec3,
        inner_radius: f64,
        radius: f64,
    ) -> Result<Self, GeometryError> {
        positive("disc", "radius less inner radius", radius - inner_radius)?;
        Self::named("disc", centre, axis, &[[inner_radius, 0.0], [radius, 0.0]])
    }

    fn named(
        name: &str,
        origin: Vec3,
        axis: Vec3,
        profile: &[[f64; 2]],
    ) -> Result<Self, GeometryError> {
        finite(name, "origin", origin)?;
        let axis = unit(name, "axis", axis)?;
        for (i, &[rho, z]) in profile.iter().enumerate() {
            finite(
                name,
                format!("profile corner {i} (rho, z, 0)"),
                Vec3::new(rho, z, 0.0),
            )?;
            if rho < 0.0 {
                return Err(GeometryError::Range {
                    name: name.into(),
                    what: format!("radius of profile corner {i}"),
                    found: rho,
                    expected: "0 m or more",
                });
            }
        }
        let mut corners: Vec<Vec2> = Vec::with_capacity(profile.len());
        for &[rho, z] in profile {
            let corner = Vec2::new(rho, z);
            while let [.., a, b] = corners[..] {
                let (ab, bc) = (b - a, corner - b);
                let straight =
                    ab.perp(&bc).abs() <= SLACK * ab.norm() * bc.norm() && ab.dot(&bc) > 0.0;
                if !straight {
                    break;
                }
                corners.pop();
            }
            if corners.last() != Some(&corner) {
                corners.push(corner);
            }
        }
        if corners.len() < 2 {
            return Err(GeometryError::Range {
                name: name.into(),
                what: "number of distinct profile corners".into(),
                found: corners.len() as f64,
                expected: "2 or more",
            });
        }
        Ok(Self {
            origin,
            axis,
            profile: corners,
        })
    }

    fn pieces(&self) -> usize {
        self.profile.len() - 1
    }

    /// Number of features: pieces, corners, and both by sectors.
    pub(super) fn features(&self) -> u32 {
        (self.parts() * (1 + SECTORS)) as u32
    }

    /// Pieces and corners.
    fn parts(&self) -> usize {
        self.pieces() + self.profile.len()
    }

    fn part(&self, feature: u32) -> Option<Feature> {
        let (pieces, corners, feature) = (self.pieces(), self.profile.len(), feature as usize);
        if feature < pieces {
            Some(Feature::Piece(feature))
        } else if feature < pieces + corners {
            Some(Feature::Corner(feature - pieces))
        } else if (feature as u32) < self.features() {
            let sector = feature - self.parts();
            Some(Feature::Sector {
                part: sector / SECTORS,
                sector: sector % SECTORS,
            })
        } else {
            None
        }
    }

    fn corner_feature(&self, corner: usize) -> u32 {
        (self.pieces() + corner) as u32
    }

    fn slack(&self) -> f64 {
        SLACK * self.profile.iter().map(|p| p.amax()).fold(0.0, f64::max)
    }

    /// Two unit vectors square to the axis and to each other; they depend on the axis only.
    pub(super) fn transverse(&self) -> [Vec3; 2] {
        let e1 = self
            .axis
            .cross(&Vec3::ith(self.axis.iamin(), 1.0))
            .normalize();
        [e1, self.axis.cross(&e1)]
    }

    pub(super) fn half_plane(&self, c: Vec3) -> HalfPlane {
        let arm = c - self.origin;
        let z = arm.dot(&self.axis);
        let across = arm - self.axis * z;
        let rho = across.norm();
        // On the axis every direction is as good: the first transverse one, always the same.
        let (rho, radial) = if rho > self.slack() {
            (rho, across / rho)
        } else {
            (0.0, self.transverse()[0])
        };
        HalfPlane {
            centre: Vec2::new(rho, z),
            radial,
        }
    }

    /// The point `(rho, z)` at the azimuth of `radial`.
    pub(super) fn at(&self, p: Vec2, radial: Vec3) -> Vec3 {
        self.origin + radial * p.x + self.axis * p.y
    }

    pub(super) fn closest_points(
        &self,
        c: Vec3,
        radius: f64,
        reach: f64,
        out: &mut Vec<ClosestPoint>,
    ) {
        let start = out.len();
        let frame = self.half_plane(c);
        for piece in 0..self.pieces() {
            let (a, b) = (self.profile[piece], self.profile[piece + 1]);
            let (closest, t) = on_piece(a, b, frame.centre);
            if self.is_in_ring([a, b], (closest, frame.centre), radius, reach) {
                self.push_sectors(piece, &frame, (radius, reach), out);
                continue;
            }
            let on_face = (0.0..=1.0).contains(&t);
            let point = if on_face {
                self.face_touch(piece, &frame, 1.0, radius)
            } else {
                let corner = if t < 0.0 { piece } else { piece + 1 };
                if self.is_undercut(corner, frame.centre) {
                    continue;
                }
                self.corner_touch(corner, &frame, radius)
            };
            let point = if on_face && point.gap + radius < 0.0 {
                self.face_touch(piece, &frame, -1.0, radius)
            } else {
                point
            };
            if point.gap <= reach {
                out.push(point);
            }
        }
        keep_distinct(out, start, self.slack());
    }

    /// Whether a sphere around `centre` touches the far side of a piece as well as `closest`.
    fn is_in_ring(
        &self,
        [a, b]: [Vec2; 2],
        (closest, centre): (Vec2, Vec2),
        radius: f64,
        reach: f64,
    ) -> bool {
        let opposite = Vec2::new(-centre.x, centre.y);
        let far = (on_piece(a, b, opposite).0 - opposite).norm();
        // Of a piece square to the axis the two are the same but for rounding.
        closest.x > centre.x + self.slack() && far - radius <= reach.max(RING * radius)
    }

    fn push_sectors(
        &self,
        piece: usize,
        frame: &HalfPlane,
        (radius, reach): (f64, f64),
        out: &mut Vec<ClosestPoint>,
    ) {
        for sector in 0..SECTORS {
            let turned = self.in_sector(frame, sector);
            let [a, b] = [piece, piece + 1].map(|k| self.profile[k]);
            let (_, t) = on_piece(a, b, turned.centre);
            let corner = if t < 0.0 { piece } else { piece + 1 };
            let part = match (0.0..=1.0).contains(&t) {
                true => piece,
                false if self.is_undercut(corner, turned.centre) => continue,
                false => self.pieces() + corner,
            };
            let point = self.sector_touch(part, sector, frame, radius);
            if point.gap <= reach {
                out.push(point);
            }
        }
    }

    pub(super) fn follow(
        &self,
        feature: u32,
        normal: Vec3,
        c: Vec3,
        radius: f64,
    ) -> Option<ClosestPoint> {
        let frame = self.half_plane(c);
        Some(match self.part(feature)? {
            Feature::Piece(piece) => {
                let (a, b) = (self.profile[piece], self.profile[piece + 1]);
                let (closest, t) = on_piece(a, b, frame.centre);
                if (0.0..=1.0).contains(&t) {
                    self.face_touch(piece, &frame, self.kept_side(piece, &frame, normal), radius)
                } else {
                    self.point_touch(
                        feature,
                        closest,
                        &frame,
                        radius,
                        self.outward(piece, &frame),
                    )
                }
            }
            Feature::Corner(corner) => self.corner_touch(corner, &frame, radius),
            Feature::Sector { part, sector } => self.sector_touch(part, sector, &frame, radius),
        })
    }

    /// Which side of a piece (+1 or -1 along its left normal) a sphere keeps that had `normal` there.
    ///
    /// Seen from the new azimuth the old normal points against the present side in two cases: the centre went through
    /// the surface, which is then near, or it passed the axis, which is then near. The nearer one decides.
    fn kept_side(&self, piece: usize, frame: &HalfPlane, normal: Vec3) -> f64 {
        let outward = self.outward(piece, frame);
        let distance = self.signed_distance(piece, frame.centre);
        let now = if distance < 0.0 { -1.0 } else { 1.0 };
        let before = if normal.dot(&outward) < 0.0 {
            -1.0
        } else {
            1.0
        };
        if distance.abs() < frame.centre.x {
            before
        } else {
            now
        }
    }

    fn left_normal(&self, piece: usize) -> Vec2 {
        let along = (self.profile[piece + 1] - self.profile[piece]).normalize();
        Vec2::new(-along.y, along.x)
    }

    fn outward(&self, piece: usize, frame: &HalfPlane) -> Vec3 {
        let m = self.left_normal(piece);
        frame.radial * m.x + self.axis * m.y
    }

    fn signed_distance(&self, piece: usize, c: Vec2) -> f64 {
        (c - self.profile[piece]).dot(&self.left_normal(piece))
    }

    fn face_touch(&self, piece: usize, frame: &HalfPlane, side: f64, radius: f64) -> ClosestPoint {
        let m = self.left_normal(piece);
        let distance = self.signed_distance(piece, frame.centre);
        let rho = frame.centre.x.max(1e-6 * radius);
        ClosestPoint {
            feature: piece as u32,
            point: self.at(frame.centre - m * distance, frame.radial),
            normal: self.outward(piece, frame) * side,
            gap: side * distance - radius,
            curvature: m.x.abs() / rho,
        }
    }

    fn corner_touch(&self, corner: usize, frame: &HalfPlane, radius: f64) -> ClosestPoint {
        let piece = corner.min(self.pieces() - 1);
        self.point_touch(
            self.corner_feature(corner),
            self.profile[corner],
            frame,
            radius,
            self.outward(piece, frame),
        )
    }

    fn point_touch(
        &self,
        feature: u32,
        p: Vec2,
        frame: &HalfPlane,
        radius: f64,
        fallback: Vec3,
    ) -> ClosestPoint {
        let centre = self.at(frame.centre, frame.radial);
        let mut point =
            ClosestPoint::at_point(feature, self.at(p, frame.radial), centre, radius, fallback);
        if p.x > 0.0 {
            let around = point.normal.dot(&frame.radial).abs() / frame.centre.x.max(1e-6 * radius);
            point.curvature = point.curvature.max(around);
        }
        point
    }

    /// The half-plane of a sector that is nearest to the centre's own, and the centre's foot in it.
    fn in_sector(&self, frame: &HalfPlane, sector: usize) -> HalfPlane {
        let [e1, e2] = self.transverse();
        let own = frame.radial.dot(&e2).atan2(frame.radial.dot(&e1));
        let width = TAU / SECTORS as f64;
        let middle = (sector as f64 + 0.5) * width;
        let off = (own - middle + TAU + PI).rem_euclid(TAU) - PI;
        if off.abs() <= 0.5 * width {
            return HalfPlane { ..*frame };
        }
        let (sin, cos) = (middle + 0.5 * width * off.signum()).sin_cos();
        let radial = e1 * cos + e2 * sin;
        let [rho, z] = [frame.centre.x, frame.centre.y];
        HalfPlane {
            centre: Vec2::new(rho * radial.dot(&frame.radial), z),
            radial,
        }
    }

    /// The closest point of a piece or corner within a sector.
    fn sector_touch(
        &self,
        part: usize,
        sector: usize,
        frame: &HalfPlane,
        radius: f64,
    ) -> ClosestPoint {
        let feature = (self.parts() + part * SECTORS + sector) as u32;
        let turned = self.in_sector(frame, sector);
        let (p, piece) = match part.checked_sub(self.pieces()) {
            Some(corner) => (self.profile[corner], corner.min(self.pieces() - 1)),
            None => {
                let [a, b] = [part, part + 1].map(|k| self.profile[k]);
                (on_piece(a, b, turned.centre).0, part)
            }
        };
        let centre = self.at(frame.centre, frame.radial);
        let point = self.at(p, turned.radial);
        let fallback = self.outward(piece, &turned);
        ClosestPoint::at_point(feature, point, centre, radius, fallback)
    }

    /// Whether a piece at the corner has a point closer to `c` than the corner.
    fn is_undercut(&self, corner: usize, c: Vec2) -> bool {
        let x = self.profile[corner];
        let first = corner.saturating_sub(1);
        let last = corner.min(self.pieces() - 1);
        (first..=last).any(|piece| {
            let w = on_piece(self.profile[piece], self.profile[piece + 1], c).0 - x;
            w.norm() > self.slack() && (c - x).dot(&w) > 0.6 * w.norm_squared()
        })
    }

    /// Smallest box around the surface \[m\].
    pub(super) fn bounds(&self) -> (Vec3, Vec3) {
        let (mut min, mut max) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
        for p in &self.profile {
            let middle = self.origin + self.axis * p.y;
            let half = self.axis.map(|a| p.x * (1.0 - a * a).max(0.0).sqrt());
            (min, max) = (min.inf(&(middle - half)), max.sup(&(middle + half)));
        }
        (min, max)
    }
}

/// The closest point of segment `a`-`b` to `p`, and the parameter of the foot on the infinite line.
pub(super) fn on_piece(a: Vec2, b: Vec2, p: Vec2) -> (Vec2, f64) {
    let ab = b - a;
    let t = (p - a).dot(&ab) / ab.norm_squared();
    let closest = if t <= 0.0 {
        a
    } else if t >= 1.0 {
        b
    } else {
        a + ab * t
    };
    (closest, t)
}

fn positive(name: &str, what: &str, found: f64) -> Result<(), GeometryError> {
    if found > 0.0 {
        Ok(())
    } else {
        Err(GeometryError::Range {
            name: name.into(),
            what: what.into(),
            found,
            expected: "more than 0 m",
        })
    }
}
