//! Clumps: rigid grains of several spheres.
//!
//! A clump is a rigid body of six unknowns about its centre of mass. Its members are spheres of the scene like all others, so
//! that detection, boundaries and outputs see spheres; they have no unknowns of their own. With the centre `x` and the rotation
//! `Q` of its own axes, member `k` is at `x_k = x + Q a_k` and moves with `v_k = v + w x (Q a_k)`. What a clump is to carry on
//! with stands in the motion of its members alone: `Q` is their orientation, `w` their spin.
//!
//! Mass, centre and inertia are those of the union of the members ([`Solid`]) or given. Its mass is shared out to the members
//! such that `sum m_k = m`, `sum m_k a_k = 0`: sums of mass, momentum and weight over spheres count a clump once.

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroUsize;
use std::ops::Range;

use gauss_quad::GaussLegendre;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::scene::particles::{Kinematics, Locks, Particles};
use crate::spatial::SpatialVector;

/// Points of the Gauss rule in each interval of a slice, and of slices.
const POINTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(23);
/// Newton's iterations for the shares of the mass; each about squares the error.
const ITERATIONS: usize = 50;
/// Share of the spread of the members' places across a plane or a line below which they lie in it \[-\].
const FLAT: f64 = 1e-12;

/// A clump in a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Clump {
    /// Its spheres.
    pub members: Range<usize>,
    /// What it is made of.
    pub shape: ClumpShape,
}

/// Mass, inertia and members of a clump, in its own axes, which have their origin in the centre of mass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClumpShape {
    /// Volume \[m^3\].
    pub volume: f64,
    /// Mass \[kg\].
    pub mass: f64,
    /// Principal moments of inertia about the centre of mass \[kg m^2\].
    pub moments: Vec3,
    /// Principal axes: from them to its own axes.
    pub axes: UnitQuaternion<f64>,
    /// Centres of the members \[m\], `[K]`.
    pub arms: Vec<Vec3>,
    /// Their radii \[m\], `[K]`.
    pub radii: Vec<f64>,
    /// Their shares of the mass \[-\], `[K]`.
    pub shares: Vec<f64>,
}

/// Volume, centroid and inertia of a union of balls.
///
/// Along x the union of chords is exact; across it, in slices along y and z, Gauss rules with [`POINTS`] points between the places
/// where spheres begin, end and meet, in `sin(theta)`, which takes out the square roots there. The relative error is below 1e-8
/// for two spheres and below 1e-6 where three or more overlap in one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// Volume \[m^3\].
    pub volume: f64,
    /// Centroid \[m\].
    pub centroid: Vec3,
    /// Inertia about the centroid over the density \[m^5\].
    pub inertia: Matrix3<f64>,
}

impl Solid {
    /// The union of balls of these centres \[m\] and radii \[m\].
    ///
    /// # Panics
    /// If there is no ball.
    #[must_use]
    pub fn union(centres: &[Vec3], radii: &[f64]) -> Self {
        let rule = GaussLegendre::new(POINTS);
        let rule: Vec<(f64, f64)> = rule.iter().map(|(x, w)| (*x, *w)).collect();
        let origin = centres[0];
        let balls: Vec<(Vec3, f64)> = centres
            .iter()
            .map(|c| c - origin)
            .zip(radii.iter().copied())
            .collect();
        // Volume, first and second moments.
        let (mut volume, mut first, mut second) = (0.0, Vec3::zeros(), Matrix3::zeros());
        let mut chords = Vec::new();
        let mut levels = balls
            .iter()
            .flat_map(|(c, r)| [c.z - r, c.z + r])
            .collect::<Vec<_>>();
        for (i, a) in balls.iter().enumerate() {
            levels.extend(balls[..i].iter().filter_map(|b| meeting(*a, *b)).flat_map(
                |(c, n, r)| {
                    let half = r * n.x.hypot(n.y);
                    [c.z - half, c.z + half]
                },
            ));
        }
        for (z, dz) in nodes(levels, &rule) {
            let discs: Vec<(f64, f64, f64)> = balls
                .iter()
                .filter_map(|(c, r)| {
                    let square = r * r - (z - c.z) * (z - c.z);
                    (square > 0.0).then(|| (c.x, c.y, square.sqrt()))
                })
                .collect();
            let mut levels = discs
                .iter()
                .flat_map(|(_, y, r)| [y - r, y + r])
                .collect::<Vec<_>>();
            for (i, a) in discs.iter().enumerate() {
                levels.extend(discs[..i].iter().flat_map(|b| crossing(*a, *b)).flatten());
            }
            for (y, dy) in nodes(levels, &rule) {
                chords.clear();
                chords.extend(discs.iter().filter_map(|(cx, cy, r)| {
                    let square = r * r - (y - cy) * (y - cy);
                    (square > 0.0).then(|| (cx - square.sqrt(), cx + square.sqrt()))
                }));
                chords.sort_by(|a: &(f64, f64), b| a.0.total_cmp(&b.0));
                let mut end = f64::NEG_INFINITY;
                for &(from, to) in &chords {
                    let from = from.max(end);
                    if to <= from {
                        continue;
                    }
                    end = to;
                    let weight = dy * dz;
                    let length = weight * (to - from);
                    let x = 0.5 * (from + to);
                    let square = (to * to + to * from + from * from) / 3.0;
                    let middle = Vec3::new(x, y, z);
                    volume += length;
                    first += middle * length;
                    let mut moment = middle * middle.transpose();
                    moment[(0, 0)] = square;
                    second += moment * length;
                }
            }
        }
        let centroid = first / volume;
        let second = second - centroid * centroid.transpose() * volume;
        Self {
            volume,
            centroid: origin + centroid,
            inertia: Matrix3::identity() * second.trace() - second,
        }
    }
}

/// The circle in which two spheres meet: centre, unit normal, radius.
fn meeting((a, ra): (Vec3, f64), (b, rb): (Vec3, f64)) -> Option<(Vec3, Vec3, f64)> {
    let apart = (b - a).norm();
    if apart == 0.0 {
        return None;
    }
    let n = (b - a) / apart;
    let along = 0.5 * (apart + (ra * ra - rb * rb) / apart);
    let square = ra * ra - along * along;
    (square > 0.0).then(|| (a + n * along, n, square.sqrt()))
}

/// The `y` at which two circles `(x, y, radius)` meet.
fn crossing((ax, ay, ra): (f64, f64, f64), (bx, by, rb): (f64, f64, f64)) -> Option<[f64; 2]> {
    let circle = |x, y, r| (Vec3::new(x, y, 0.0), r);
    let (c, n, r) = meeting(circle(ax, ay, ra), circle(bx, by, rb))?;
    Some([c.y - r * n.x, c.y + r * n.x])
}

/// Places and weights of a rule in `y = m + h sin(theta)` between `levels`.
fn nodes(mut levels: Vec<f64>, rule: &[(f64, f64)]) -> Vec<(f64, f64)> {
    levels.sort_by(f64::total_cmp);
    let pairs = levels.windows(2).filter(|pair| pair[1] > pair[0]);
    let all = pairs.flat_map(|pair| {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        rule.iter().map(move |(s, w)| {
            let (sin, cos) = (s * FRAC_PI_2).sin_cos();
            (middle + half * sin, w * FRAC_PI_2 * half * cos)
        })
    });
    all.collect()
}

/// The point nearest to `point` of the line, the plane or the space that these centres span \[m\]: there a union has its centroid.
fn among(centres: &[Vec3], point: Vec3) -> Vec3 {
    let from = centres[0];
    let ways = centres.iter().map(|c| c - from);
    let spread: Matrix3<f64> = ways.map(|way| way * way.transpose()).sum();
    let (eigen, size) = (spread.symmetric_eigen(), spread.trace());
    let spanned = (0..3).filter(|&k| eigen.eigenvalues[k] > FLAT * size);
    let axes = spanned.map(|k| eigen.eigenvectors.column(k).into_owned());
    from + axes.map(|n: Vec3| n * n.dot(&(point - from))).sum::<Vec3>()
}

/// Shares of the mass for members of these `volumes` and places from the centre of mass, so that they have the same centre: those
/// nearest to the volumes in the sense of entropy, `s_k ~ V_k exp(l . a_k)`, which are positive. `None` where the centre of mass
/// does not lie between the members.
fn shares(volumes: &[f64], arms: &[Vec3]) -> Option<Vec<f64>> {
    let size = arms.iter().map(Vec3::norm).fold(0.0, f64::max);
    if size == 0.0 {
        return Some(vec![1.0 / arms.len() as f64; arms.len()]);
    }
    let mut tilt = Vec3::zeros();
    for _ in 0..ITERATIONS {
        let weights = volumes
            .iter()
            .zip(arms)
            .map(|(v, a)| v * libm::exp(tilt.dot(a) / size));
        let mut shares: Vec<f64> = weights.collect();
        let sum: f64 = shares.iter().sum();
        shares.iter_mut().for_each(|share| *share /= sum);
        let off: Vec3 = shares.iter().zip(arms).map(|(s, a)| a * (s / size)).sum();
        if off.norm() < 1e-15 {
            return Some(shares);
        }
        let spread: Matrix3<f64> = (shares.iter().zip(arms))
            .map(|(s, a)| (a / size - off) * (a / size - off).transpose() * *s)
            .sum();
        // Members in a plane or on a line leave directions in which there is nothing to do.
        let step = spread.pseudo_inverse(FLAT).ok()? * off;
        tilt -= step * (1.0 / (1.0 + step.norm()));
        if step.norm() < 1e-12 {
            return (off.norm() < 1e-12).then_some(shares);
        }
    }
    None
}

impl ClumpShape {
    /// The shape of members of these centres \[m\] and radii \[m\], of any axes, with a `density` \[kg/m^3\]; `mass` \[kg\] and `inertia`
    /// about the centre of mass \[kg m^2\] where they are given. Returns also the centre of mass in the axes given \[m\].
    ///
    /// `None` where the members have no common centre of mass between them: one that lies inside another alone.
    #[must_use]
    pub fn new(
        centres: &[Vec3],
        radii: &[f64],
        density: f64,
        mass: Option<f64>,
        inertia: Option<Matrix3<f64>>,
    ) -> Option<(Self, Vec3)> {
        let solid = Solid::union(centres, radii);
        let centroid = among(centres, solid.centroid);
        let mass = mass.unwrap_or(density * solid.volume);
        let inertia = inertia.unwrap_or(solid.inertia * (mass / solid.volume));
        let eigen = inertia.symmetric_eigen();
        let mut axes = eigen.eigenvectors;
        if axes.determinant() < 0.0 {
            axes.column_mut(2).neg_mut();
        }
        let arms: Vec<Vec3> = centres.iter().map(|c| c - centroid).collect();
        let volumes: Vec<f64> = radii.iter().map(|r| r.powi(3)).collect();
        let shape = Self {
            volume: solid.volume,
            mass,
            moments: eigen.eigenvalues,
            axes: UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes)),
            shares: shares(&volumes, &arms)?,
            arms,
            radii: radii.to_vec(),
        };
        Some((shape, centroid))
    }

    /// The same shape of the same density, `factor` times as large.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let cube = factor.powi(3);
        Self {
            volume: self.volume * cube,
            mass: self.mass * cube,
            moments: self.moments * (cube * factor * factor),
            axes: self.axes,
            arms: self.arms.iter().map(|arm| arm * factor).collect(),
            radii: self.radii.iter().map(|radius| radius * factor).collect(),
            shares: self.shares.clone(),
        }
    }

    /// Radius of a sphere of its volume \[m\].
    #[must_use]
    pub fn equal_radius(&self) -> f64 {
        libm::cbrt(self.volume / (4.0 / 3.0 * PI))
    }

    /// Radius of the ball about the centre of mass that holds it \[m\].
    #[must_use]
    pub fn reach(&self) -> f64 {
        let members = self.arms.iter().zip(&self.radii);
        members.map(|(a, r)| a.norm() + r).fold(0.0, f64::max)
    }

    /// Its inertia \[kg m^2\] (`f(J) = J`) or another function of it, world axes, when turned by `rotation`.
    pub(crate) fn inertia(
        &self,
        rotation: UnitQuaternion<f64>,
        f: impl Fn(f64) -> f64,
    ) -> Matrix3<f64> {
        let axes = (rotation * self.axes).to_rotation_matrix();
        axes * Matrix3::from_diagonal(&self.moments.map(f)) * axes.inverse()
    }

    /// Kinetic energy of its centre of mass and of its rotation \[J\] when turned by `rotation`.
    pub(crate) fn kinetic_energy(
        &self,
        rotation: UnitQuaternion<f64>,
        v: &SpatialVector,
    ) -> [f64; 2] {
        let inertia = self.inertia(rotation, |moment| moment);
        [
            0.5 * self.mass * v.linear.norm_squared(),
            0.5 * v.angular.dot(&(inertia * v.angular)),
        ]
    }
}

impl Clump {
    /// Its centre of mass \[m\] and the rotation of its own axes.
    #[must_use]
    pub fn place(&self, kinematics: &Kinematics) -> (Vec3, UnitQuaternion<f64>) {
        let first = self.members.start;
        let rotation = kinematics.orientation[first];
        (
            kinematics.position[first] - rotation * self.shape.arms[0],
            rotation,
        )
    }

    /// Puts it into `kinematics` with its centre of mass at `position` \[m\], turned by `rotation`, moving with `velocity`.
    pub(crate) fn put(
        &self,
        (position, rotation): (Vec3, UnitQuaternion<f64>),
        velocity: &SpatialVector,
        kinematics: &mut Kinematics,
    ) {
        for (i, arm) in self.members.clone().zip(&self.shape.arms) {
            let arm = rotation * arm;
            kinematics.position[i] = position + arm;
            kinematics.orientation[i] = rotation;
            kinematics.velocity[i] = velocity.at(arm);
            kinematics.spin[i] = velocity.angular;
        }
    }

    /// Velocity of its centre of mass and its spin, or an acceleration, when that of its first member is `of_first`.
    pub(crate) fn of_member(
        &self,
        rotation: UnitQuaternion<f64>,
        of_first: &SpatialVector,
    ) -> SpatialVector {
        SpatialVector {
            linear: of_first.at(rotation * -self.shape.arms[0]),
            angular: of_first.angular,
        }
    }

    /// Adds a clump of `shape` and `material` with its centre of mass at `position` \[m\], turned by `rotation`, which moves with `velocity`
    /// \[m/s\], \[rad/s\].
    pub fn push(
        shape: &ClumpShape,
        material: u16,
        place: (Vec3, UnitQuaternion<f64>),
        velocity: &SpatialVector,
        (particles, initial, clumps): (&mut Particles, &mut Kinematics, &mut Vec<Self>),
    ) {
        let clump = Self::push_absent(shape, material, place.0, (particles, initial, clumps));
        initial.present[clump.members.clone()].fill(true);
        clump.put(place, velocity, initial);
    }

    /// Adds a clump that waits outside the scene; drawings would put it at `position` \[m\].
    pub(crate) fn push_absent<'a>(
        shape: &ClumpShape,
        material: u16,
        position: Vec3,
        (particles, initial, clumps): (&mut Particles, &mut Kinematics, &'a mut Vec<Self>),
    ) -> &'a Self {
        let first = particles.len();
        let members = shape.arms.iter().zip(shape.radii.iter().zip(&shape.shares));
        for (arm, (radius, share)) in members {
            particles.push(*radius, 0.0, material, Locks::default());
            let i = particles.len() - 1;
            particles.mass[i] = shape.mass * share;
            particles.clump.resize(i + 1, None);
            particles.clump[i] = Some(clumps.len() as u32);
            initial.push_absent(position + arm);
        }
        clumps.push(Self {
            members: first..particles.len(),
            shape: shape.clone(),
        });
        &clumps[clumps.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A single ball, and two that meet in a lens: volume and moments in closed form.
    ///
    /// ```text
    /// lens of two balls of radius R at distance d:   V = pi (4R + d)(2R - d)^2 / 12
    /// about the axis   I = 2 (pi/2) int_{d/2}^{R} (R^2 - x^2)^2 dx    of the lens, 2/5 m R^2 of each ball
    /// ```
    #[test]
    fn balls_and_lenses_are_exact() {
        let (r, d): (f64, f64) = (0.7, 0.9);
        let ball = Solid::union(&[Vec3::new(1.0, 2.0, 3.0)], &[r]);
        let volume = 4.0 / 3.0 * PI * r.powi(3);
        assert!(
            (ball.volume / volume - 1.0).abs() < 1e-12,
            "{}",
            ball.volume / volume - 1.0
        );
        assert!((ball.inertia - Matrix3::identity() * (0.4 * volume * r * r)).norm() < 1e-12);
        for along in [
            Vec3::x(),
            Vec3::y(),
            Vec3::z(),
            Vec3::new(0.6, 0.0, 0.8),
            Vec3::new(2.0, -3.0, 6.0) / 7.0,
        ] {
            let two = Solid::union(&[along * -0.5 * d, along * 0.5 * d], &[r; 2]);
            let lens = PI * (4.0 * r + d) * (2.0 * r - d).powi(2) / 12.0;
            let union = 2.0 * volume - lens;
            assert!(
                (two.volume / union - 1.0).abs() < 1e-8,
                "{}",
                two.volume / union - 1.0
            );
            assert!(two.centroid.norm() < 1e-12);
            let f = |x: f64| r.powi(4) * x - 2.0 / 3.0 * r * r * x.powi(3) + x.powi(5) / 5.0;
            let axial = 2.0 * 0.4 * volume * r * r - PI * (f(r) - f(0.5 * d));
            let found = along.dot(&(two.inertia * along));
            assert!(
                (found / axial - 1.0).abs() < 1e-8,
                "{}",
                found / axial - 1.0
            );
            // Across: int x^2 dV + half the axial one; second moments of halves cut at the middle.
            let g = |x: f64| r * r * x.powi(3) / 3.0 - x.powi(5) / 5.0;
            let cap = |x: f64| {
                // int pi (R^2 - u^2)(u + d/2)^2 du from u = -d/2, u from the ball's centre.
                let h = 0.5 * d;
                PI * (g(x)
                    + 2.0 * h * (r * r * x * x / 2.0 - x.powi(4) / 4.0)
                    + h * h * (r * r * x - x.powi(3) / 3.0))
            };
            let across = 2.0 * (cap(r) - cap(-0.5 * d)) + 0.5 * axial;
            let side = Vec3::new(along.y, -along.x, 0.0)
                .try_normalize(1e-9)
                .unwrap_or_else(Vec3::x);
            let found = side.dot(&(two.inertia * side));
            assert!(
                (found / across - 1.0).abs() < 1e-8,
                "{}",
                found / across - 1.0
            );
        }
    }

    /// Four balls that all overlap, turned: the rule does not know where three of them meet.
    #[test]
    fn where_three_balls_meet_the_rule_is_good_to_a_millionth() {
        let corners = [
            [1.0, 1.0, 1.0],
            [1.0, -1.0, -1.0],
            [-1.0, 1.0, -1.0],
            [-1.0, -1.0, 1.0],
        ];
        let of = |turn: f64| {
            let turn = UnitQuaternion::from_scaled_axis(Vec3::new(turn, 0.7 * turn, -0.3 * turn));
            let centres: Vec<Vec3> = corners.map(|c| turn * Vec3::from(c) * 0.4).into();
            Solid::union(&centres, &[0.6; 4])
        };
        let known = of(0.0);
        for turn in [0.2, 0.9, 1.7, 2.6] {
            let found = of(turn);
            assert!(
                (found.volume / known.volume - 1.0).abs() < 1e-6,
                "{}",
                found.volume / known.volume - 1.0
            );
            assert!(
                (found.inertia / known.inertia[0] - known.inertia / known.inertia[0]).norm() < 2e-6
            );
        }
    }

    #[test]
    fn shares_have_the_centre_of_mass_of_the_whole() {
        let centres = [
            Vec3::zeros(),
            Vec3::new(0.5, 0.2, 0.0),
            Vec3::new(-0.3, 0.6, 0.1),
            Vec3::new(0.1, -0.2, 0.9),
        ];
        for count in 2..=4 {
            let radii = &[0.5, 0.4, 0.3, 0.6][..count];
            let (shape, _) = ClumpShape::new(&centres[..count], radii, 1000.0, None, None).unwrap();
            let centre: Vec3 = shape
                .arms
                .iter()
                .zip(&shape.shares)
                .map(|(a, s)| a * *s)
                .sum();
            assert!(centre.norm() < 1e-13, "{count}: {}", centre.norm());
            assert!((shape.shares.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            assert!(shape.shares.iter().all(|share| *share > 0.0));
        }
        let inside = ClumpShape::new(
            &[Vec3::zeros(), Vec3::x() * 0.1],
            &[0.5, 0.2],
            1.0,
            None,
            None,
        );
        assert!(inside.is_none());
    }
}
