//! Clumps: rigid grains of several spheres.
//!
//! A clump is a rigid body of six unknowns about its centre of mass. Its members are spheres of the scene like all others, so
//! that detection, boundaries and outputs see spheres; they have no unknowns of their own. With the centre `x` and the rotation
//! `Q` of its own axes, member `k` is at `x_k = x + Q a_k` and moves with `v_k = v + w x (Q a_k)`. What a clump is to carry on
//! with stands in the motion of its members alone: `Q` is their orientation, `w` their spin.
//!
//! Mass and inertia are those of the union of the members ([`Moments::of_balls`]), of a solid whose surface they stand for, or given;
//! the centre of mass is that of the union. Its mass is shared out to the members such that `sum m_k = m`, `sum m_k a_k = 0`: sums of mass, momentum and weight over spheres count a clump once.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::geometry::{Moments, Triangulation};
use crate::scene::particles::{Kinematics, Locks, Particles};
use crate::spatial::SpatialVector;

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
    /// What frames show in place of the members, if it is not they.
    pub surface: Option<ClumpSurface>,
}

/// The mesh that the members of clumps stand for, in axes that have their origin in the centre of mass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClumpSurface {
    /// Shared by clumps of all sizes.
    pub mesh: Arc<Triangulation>,
    /// Their size over that of the mesh \[-\].
    pub scale: f64,
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
        let union = Moments::of_balls(centres, radii);
        Self::of_solid(centres, radii, (&union, &union), density, mass, inertia)
    }

    /// As [`Self::new`], with volume and inertia of a `solid` that the members stand for in place of those of their `union`. Its
    /// centroid is put on that of the union.
    #[must_use]
    pub fn of_solid(
        centres: &[Vec3],
        radii: &[f64],
        (solid, union): (&Moments, &Moments),
        density: f64,
        mass: Option<f64>,
        inertia: Option<Matrix3<f64>>,
    ) -> Option<(Self, Vec3)> {
        let centroid = among(centres, union.centroid);
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
            surface: None,
        };
        Some((shape, centroid))
    }

    /// This with a `mesh` as what frames show, in the axes in which its centre of mass is at `centre` \[m\].
    #[must_use]
    pub(crate) fn shown_as(self, mesh: &Triangulation, centre: Vec3) -> Self {
        let mesh = Arc::new(Triangulation {
            points: mesh.points.iter().map(|point| point - centre).collect(),
            triangles: mesh.triangles.clone(),
        });
        let surface = Some(ClumpSurface { mesh, scale: 1.0 });
        Self { surface, ..self }
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
            surface: self.surface.as_ref().map(|surface| ClumpSurface {
                mesh: Arc::clone(&surface.mesh),
                scale: surface.scale * factor,
            }),
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

    /// What its inertia (`f(J) = J`) or another function of it makes of a vector when turned by `rotation`: `f(J) v`.
    fn times(&self, rotation: UnitQuaternion<f64>, f: impl Fn(f64) -> f64, v: &Vec3) -> Vec3 {
        let axes = rotation * self.axes;
        axes * axes
            .inverse_transform_vector(v)
            .component_mul(&self.moments.map(f))
    }

    /// Velocity that `momentum` gives it when turned by `rotation`, or acceleration that a force does: `p/m`, `J^-1 L`.
    pub(crate) fn response(
        &self,
        rotation: UnitQuaternion<f64>,
        momentum: &SpatialVector,
    ) -> SpatialVector {
        SpatialVector {
            linear: momentum.linear / self.mass,
            angular: self.times(rotation, f64::recip, &momentum.angular),
        }
    }

    /// Momentum \[kg m/s\] and angular momentum about its centre of mass \[kg m^2/s\] when turned by `rotation`.
    pub(crate) fn momentum(
        &self,
        rotation: UnitQuaternion<f64>,
        v: &SpatialVector,
    ) -> SpatialVector {
        SpatialVector {
            linear: v.linear * self.mass,
            angular: self.times(rotation, |moment| moment, &v.angular),
        }
    }

    /// Kinetic energy of its centre of mass and of its rotation \[J\] when turned by `rotation`.
    pub(crate) fn kinetic_energy(
        &self,
        rotation: UnitQuaternion<f64>,
        v: &SpatialVector,
    ) -> [f64; 2] {
        let momentum = self.momentum(rotation, v);
        [
            0.5 * v.linear.dot(&momentum.linear),
            0.5 * v.angular.dot(&momentum.angular),
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

    /// Writes the accelerations of its members, turned by `rotation`, into those of all spheres, `[N]`, where its own is `own`.
    pub(crate) fn share(
        &self,
        rotation: UnitQuaternion<f64>,
        own: &SpatialVector,
        accelerations: &mut [SpatialVector],
    ) {
        for (i, arm) in self.members.clone().zip(&self.shape.arms) {
            accelerations[i] = SpatialVector {
                linear: own.at(rotation * arm),
                angular: own.angular,
            };
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

    /// As a shape of scaled spheres.
    #[test]
    fn a_scaled_shape_is_that_of_scaled_spheres() {
        let centres = [Vec3::zeros(), Vec3::new(0.5, 0.2, 0.0), Vec3::y() * -0.4];
        let radii = [0.5, 0.4, 0.3];
        let of = |factor: f64| {
            let centres = centres.map(|c| c * factor);
            let radii = radii.map(|r| r * factor);
            ClumpShape::new(&centres, &radii, 1e3, None, None)
                .unwrap()
                .0
        };
        let (found, expected) = (of(1.0).scaled(1.7), of(1.7));
        let same = |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
        same(found.volume, expected.volume);
        same(found.mass, expected.mass);
        same(found.reach(), expected.reach());
        same(found.equal_radius(), expected.equal_radius());
        for axis in 0..3 {
            same(found.moments[axis], expected.moments[axis]);
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
