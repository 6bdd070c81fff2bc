//! What the contacts of a step carried: forces, couples where materials resist rolling or twisting, and the energy of their shear
//! springs where they give way.

use std::ops::Deref;

use serde::{Deserialize, Serialize};

use super::{ContactForce, ContactId};
use crate::Vec3;

/// Loads in canonical order, `[C]`, as which this reads, and what goes with them.
#[derive(Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactForces {
    loads: Vec<ContactForce>,
    /// `[C]`; empty unless pairs of materials resist: most scenes have none.
    torques: Vec<Vec3>,
    /// Energy \[J\] that shear springs have stored, `[C]`; empty unless contacts give way.
    stored: Vec<f64>,
}

/// What goes with the force of a contact; all contacts have it, or none has.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Beside {
    /// Couple of rolling and twisting resistance on A \[N m\].
    pub(crate) torque: Option<Vec3>,
    /// Energy \[J\] that its shear spring has stored.
    pub(crate) stored: Option<f64>,
}

impl ContactForces {
    /// What goes with contact `k`.
    pub(crate) fn beside(&self, k: usize) -> Beside {
        Beside {
            torque: self.torques.get(k).copied(),
            stored: self.stored.get(k).copied(),
        }
    }

    /// Energy \[J\] that the shear spring of contact `k` has stored.
    pub(crate) fn stored(&self, k: usize) -> f64 {
        self.stored.get(k).copied().unwrap_or_default()
    }

    /// Couple of rolling and twisting resistance of contact `k` on A \[N m\], mean over the step; its opposite acts on B.
    pub(crate) fn torque(&self, k: usize) -> Vec3 {
        self.torques.get(k).copied().unwrap_or_default()
    }

    /// Adds a contact, the last in canonical order.
    pub(crate) fn push(&mut self, load: ContactForce, beside: Beside) {
        self.loads.push(load);
        self.torques.extend(beside.torque);
        self.stored.extend(beside.stored);
    }

    /// Forgets all contacts, but keeps the memory.
    pub(crate) fn clear(&mut self) {
        self.loads.clear();
        self.torques.clear();
        self.stored.clear();
    }

    /// Forgets the contacts whose keys are not `kept`.
    pub(crate) fn retain(&mut self, kept: impl Fn(&ContactId) -> bool) {
        let mut loads = self.loads.iter();
        let mut next = || loads.next().is_some_and(|load| kept(&load.key));
        self.torques.retain(|_| next());
        let mut loads = self.loads.iter();
        let mut next = || loads.next().is_some_and(|load| kept(&load.key));
        self.stored.retain(|_| next());
        self.loads.retain(|load| kept(&load.key));
    }

    /// Lets `change` change force and couple of each contact.
    pub(crate) fn change(&mut self, mut change: impl FnMut(&mut Vec3, Option<&mut Vec3>)) {
        let mut torques = self.torques.iter_mut();
        for load in &mut self.loads {
            change(&mut load.force, torques.next());
        }
    }

    /// Whether all that goes with contacts belongs to them.
    pub(crate) fn fits(&self) -> bool {
        let fits = |count: usize| count == 0 || count == self.loads.len();
        fits(self.torques.len()) && fits(self.stored.len())
    }
}

impl Deref for ContactForces {
    type Target = [ContactForce];

    fn deref(&self) -> &[ContactForce] {
        &self.loads
    }
}

impl Clone for ContactForces {
    fn clone(&self) -> Self {
        Self {
            loads: self.loads.clone(),
            torques: self.torques.clone(),
            stored: self.stored.clone(),
        }
    }

    /// In the memory that there is.
    fn clone_from(&mut self, other: &Self) {
        self.loads.clone_from(&other.loads);
        self.torques.clone_from(&other.torques);
        self.stored.clone_from(&other.stored);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Partner;

    #[test]
    fn couples_stay_with_their_contacts() {
        let load = |sphere| ContactForce {
            key: ContactId {
                sphere,
                partner: Partner::sphere(9),
            },
            normal: Vec3::z(),
            force: Vec3::z(),
        };
        let mut carried = ContactForces::default();
        for i in 0..4 {
            carried.push(
                load(i),
                Beside {
                    torque: Some(Vec3::x() * f64::from(i)),
                    stored: Some(f64::from(i)),
                },
            );
        }
        carried.retain(|key| key.sphere % 2 == 1);
        assert_eq!(carried.len(), 2);
        assert_eq!([0, 1].map(|k| carried.torque(k).x), [1.0, 3.0]);
        assert_eq!([0, 1].map(|k| carried.stored(k)), [1.0, 3.0]);
        assert!(carried.fits());
        carried.clear();
        carried.push(load(0), Beside::default());
        assert_eq!(carried.torque(0), Vec3::zeros());
        assert!(carried.fits());
        assert_eq!(size_of::<ContactForce>(), 72);
    }
}
