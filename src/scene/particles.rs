//! The spheres: structure of arrays, all of length `N`, index = rank in the scene.

use nalgebra::{UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contact::{ContactId, Partner};
use crate::spatial::SpatialVector;
use crate::spatial::extent::{larger, smaller};

/// Degrees of freedom of a sphere that are held at zero velocity, in world axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Locks {
    /// Translation along x, y, z.
    pub translation: [bool; 3],
    /// Rotation about x, y, z.
    pub rotation: [bool; 3],
}

impl Locks {
    /// All three rotations held: a sphere that slides like a block.
    pub const ROTATIONS: Self = Self {
        translation: [false; 3],
        rotation: [true; 3],
    };

    /// One where a component is free, zero where it is locked.
    fn free(locked: [bool; 3]) -> Vec3 {
        Vector3::from(locked.map(|l| if l { 0.0 } else { 1.0 }))
    }
}

/// What never changes during a run, one entry per sphere.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Particles {
    /// Radius \[m\], `[N]`.
    pub radius: Vec<f64>,
    /// Mass \[kg\], `[N]`.
    pub mass: Vec<f64>,
    /// Index into the scene's materials, `[N]`.
    pub material: Vec<u16>,
    /// Held degrees of freedom, `[N]`.
    pub locks: Vec<Locks>,
    /// Number of the clump that each sphere belongs to, `[N]`; empty where there is none.
    pub clump: Vec<Option<u32>>,
}

/// What moves, one entry per sphere.
#[derive(Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Kinematics {
    /// Centre \[m\], `[N]`.
    pub position: Vec<Vec3>,
    /// Orientation, body to world, `[N]`.
    pub orientation: Vec<UnitQuaternion<f64>>,
    /// Velocity of the centre \[m/s\], `[N]`: the integrator's own (half step for Moreau).
    pub velocity: Vec<Vec3>,
    /// Angular velocity in world axes \[rad/s\], `[N]`.
    pub spin: Vec<Vec3>,
    /// Whether the sphere is in the scene, `[N]`: a source's spheres wait outside, a sink takes spheres out. One that
    /// is absent rests where it was, touches nothing and counts nowhere.
    pub present: Vec<bool>,
}

impl Particles {
    /// Number of spheres `N`.
    #[must_use]
    pub fn len(&self) -> usize {
        self.radius.len()
    }

    /// Smallest radius \[m\]; infinite without spheres.
    pub(crate) fn smallest_radius(&self) -> f64 {
        self.radius.iter().copied().fold(f64::INFINITY, smaller)
    }

    /// Largest radius \[m\]; zero without spheres.
    pub(crate) fn largest_radius(&self) -> f64 {
        self.radius.iter().copied().fold(0.0, larger)
    }

    /// Whether there is no sphere at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.radius.is_empty()
    }

    /// Adds a sphere of the given radius \[m\], density \[kg/m^3\] and material.
    pub fn push(&mut self, radius: f64, density: f64, material: u16, locks: Locks) {
        self.radius.push(radius);
        self.mass
            .push(4.0 / 3.0 * std::f64::consts::PI * density * radius.powi(3));
        self.material.push(material);
        self.locks.push(locks);
        if !self.clump.is_empty() {
            self.clump.push(None);
        }
    }

    /// The clump that sphere `i` belongs to.
    #[inline]
    pub(crate) fn clump(&self, i: usize) -> Option<usize> {
        self.clump
            .get(i)
            .copied()
            .flatten()
            .map(|clump| clump as usize)
    }

    /// Whether two spheres belong to one clump, and never touch.
    #[inline]
    pub(crate) fn are_one(&self, i: u32, j: u32) -> bool {
        let clump = self.clump(i as usize);
        clump.is_some() && clump == self.clump(j as usize)
    }

    /// Gives memory back that more spheres would have needed.
    pub(crate) fn shrink_to_fit(&mut self) {
        self.radius.shrink_to_fit();
        self.mass.shrink_to_fit();
        self.material.shrink_to_fit();
        self.locks.shrink_to_fit();
        self.clump.shrink_to_fit();
    }

    /// Moment of inertia `2/5 m R^2` \[kg m^2\] of sphere `i`.
    #[must_use]
    pub fn inertia(&self, i: usize) -> f64 {
        0.4 * self.mass[i] * self.radius[i] * self.radius[i]
    }

    /// Kinetic energy \[J\] of sphere `i` at a velocity \[m/s\] and angular velocity \[rad/s\].
    #[must_use]
    pub fn kinetic_energy(&self, i: usize, linear: &Vec3, angular: &Vec3) -> f64 {
        0.5 * self.mass[i] * linear.norm_squared() + 0.5 * self.inertia(i) * angular.norm_squared()
    }

    /// Translations and rotations of sphere `i`: one where it is free, zero where locked.
    pub(crate) fn free(&self, i: usize) -> [Vec3; 2] {
        let locks = &self.locks[i];
        [locks.translation, locks.rotation].map(Locks::free)
    }

    /// Radius \[m\] of the other sphere of a contact, if that is with one.
    fn other_radius(&self, key: ContactId) -> Option<f64> {
        match key.partner {
            Partner::Sphere { index, .. } => Some(self.radius[index as usize]),
            Partner::Boundary { .. } => None,
        }
    }

    /// Smaller radius \[m\] of the partners of a contact.
    #[must_use]
    pub fn smaller_radius(&self, key: ContactId) -> f64 {
        let own = self.radius[key.sphere as usize];
        self.other_radius(key).map_or(own, |other| own.min(other))
    }

    /// `1/(1/R_A + 1/R_B)` \[m\] of the partners of a contact; of a sphere on a boundary its own radius.
    #[must_use]
    pub fn reduced_radius(&self, key: ContactId) -> f64 {
        let own = self.radius[key.sphere as usize];
        self.other_radius(key)
            .map_or(own, |other| own * other / (own + other))
    }

    /// Inverse mass \[1/kg\] of sphere `i` along x, y, z; zero where locked.
    pub(crate) fn inverse_mass(&self, i: usize) -> Vec3 {
        Locks::free(self.locks[i].translation) / self.mass[i]
    }

    /// Inverse inertia \[1/(kg m^2)\] of sphere `i` about x, y, z; zero where locked.
    pub(crate) fn inverse_inertia(&self, i: usize) -> Vec3 {
        Locks::free(self.locks[i].rotation) / self.inertia(i)
    }
}

impl Clone for Kinematics {
    fn clone(&self) -> Self {
        let mut copy = Self::default();
        copy.clone_from(self);
        copy
    }

    /// In the memory that there is.
    fn clone_from(&mut self, other: &Self) {
        self.position.clone_from(&other.position);
        self.orientation.clone_from(&other.orientation);
        self.velocity.clone_from(&other.velocity);
        self.spin.clone_from(&other.spin);
        self.present.clone_from(&other.present);
    }
}

impl Kinematics {
    /// Whether every array has `count` spheres.
    pub(crate) fn fits(&self, count: usize) -> bool {
        let lengths = [
            self.present.len(),
            self.position.len(),
            self.orientation.len(),
            self.velocity.len(),
            self.spin.len(),
        ];
        lengths == [count; 5]
    }

    /// Velocity \[m/s\] and angular velocity \[rad/s\] of sphere `i`, the integrator's own.
    #[inline]
    pub(crate) fn spatial_velocity(&self, i: usize) -> SpatialVector {
        SpatialVector {
            linear: self.velocity[i],
            angular: self.spin[i],
        }
    }

    /// Adds a sphere at `position` \[m\] with `velocity` \[m/s\] and `spin` \[rad/s\].
    pub fn push(&mut self, position: Vec3, velocity: Vec3, spin: Vec3) {
        self.position.push(position);
        self.orientation.push(UnitQuaternion::identity());
        self.velocity.push(velocity);
        self.spin.push(spin);
        self.present.push(true);
    }

    /// Adds a sphere that waits outside the scene; `position` \[m\] is where drawings would put it.
    pub(crate) fn push_absent(&mut self, position: Vec3) {
        self.push(position, Vec3::zeros(), Vec3::zeros());
        if let Some(present) = self.present.last_mut() {
            *present = false;
        }
    }

    /// Gives memory back that more spheres would have needed.
    pub(crate) fn shrink_to_fit(&mut self) {
        self.position.shrink_to_fit();
        self.orientation.shrink_to_fit();
        self.velocity.shrink_to_fit();
        self.spin.shrink_to_fit();
        self.present.shrink_to_fit();
    }

    /// Sets every velocity to zero.
    pub fn stop(&mut self) {
        self.velocity.fill(Vec3::zeros());
        self.spin.fill(Vec3::zeros());
    }

    /// Number of spheres `N`.
    #[must_use]
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no sphere at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}
