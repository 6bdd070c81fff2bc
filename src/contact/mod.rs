//! Contacts: who touches whom, with which force, and what goes on from step to step.

pub mod cohesion;
pub mod elasticity;
pub(crate) mod forces;
pub(crate) mod history;
pub(crate) mod neck;
pub(crate) mod spring;

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::spatial::cell::{HERE, Image};

/// Identity of a contact over steps; its order is the canonical order of contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct ContactId {
    /// The sphere (body A); of two spheres the one with the smaller index.
    pub sphere: u32,
    /// What it touches (body B).
    pub partner: Partner,
}

impl ContactId {
    /// Gives the spheres the numbers that stand in the places of theirs; their order is the same.
    pub(crate) fn renumber(&mut self, number: &[u32]) {
        self.sphere = number[self.sphere as usize];
        if let Partner::Sphere { index, .. } = &mut self.partner {
            *index = number[*index as usize];
        }
    }

    /// The spheres that touch.
    pub(crate) fn spheres(&self) -> impl Iterator<Item = usize> + use<> {
        let other = match self.partner {
            Partner::Sphere { index, .. } => Some(index as usize),
            Partner::Boundary { .. } => None,
        };
        std::iter::once(self.sphere as usize).chain(other)
    }
}

impl Partner {
    /// Sphere `index` where it is, not a copy of it.
    #[must_use]
    pub fn sphere(index: u32) -> Self {
        Self::Sphere { index, image: HERE }
    }
}

/// Body B of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Partner {
    /// Another sphere, of larger index than body A.
    Sphere {
        /// Index of the sphere.
        index: u32,
        /// Which copy of it, in unwrapped coordinates: `x + k L` of a periodic [`crate::spatial::cell`].
        image: Image,
    },
    /// A feature (face, edge, vertex) of a boundary.
    Boundary {
        /// Index of the boundary.
        boundary: u16,
        /// Feature number inside the boundary.
        feature: u32,
    },
}

/// What a contact carried in the last step, but for a couple: `forces::ContactForces`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ContactForce {
    /// Identity.
    pub key: ContactId,
    /// Unit normal from B to A at the start of the step.
    pub normal: Vec3,
    /// Force on A \[N\], mean over the step.
    pub force: Vec3,
}

/// A loaded contact, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Identity.
    pub key: ContactId,
    /// Closest point \[m\] on body B.
    pub point: Vec3,
    /// Unit normal from B to A at the start of the last step.
    pub normal: Vec3,
    /// True geometric gap \[m\]; negative: overlap.
    pub gap: f64,
    /// Force on A \[N\], mean over the last internal step.
    pub force: Vec3,
    /// Couple of rolling and twisting resistance on A \[N m\], likewise; its opposite acts on B.
    pub torque: Vec3,
    /// What holds its surfaces together.
    pub hold: Hold,
}
