//! What the contacts of a step carried: forces, and couples where materials resist rolling or twisting.

use std::ops::Deref;

use serde::{Deserialize, Serialize};

use super::{ContactForce, ContactId};
use crate::Vec3;

/// Loads in canonical order, `[C]`, as which this reads, and the couples that go with them.
#[derive(Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactForces {
    loads: Vec<ContactForce>,
    /// `[C]`; empty unless pairs of materials resist: most scenes have none.
    torques: Vec<Vec3>,
}

impl ContactForces {
    /// Couple of rolling and twisting resistance of contact `k` on A \[N m\], mean over the step; its opposite acts on B.
    pub(crate) fn torque(&self, k: usize) -> Vec3 {
        self.torques.get(k).copied().unwrap_or_default()
    }

    /// Adds a contact, the last in canonical order; all have a `torque` \[N m\], or none has.
    pub(crate) fn push(&mut self, load: ContactForce, torque: Option<Vec3>) {
        self.loads.push(load);
        self.torques.extend(torque);
    }

    /// Forgets all contacts, but keeps the memory.
    pub(crate) fn clear(&mut self) {
        self.loads.clear();
        self.torques.clear();
    }

    /// Forgets the contacts whose keys are not `kept`.
    pub(crate) fn retain(&mut self, kept: impl Fn(&ContactId) -> bool) {
        let mut loads = self.loads.iter();
        self.torques
            .retain(|_| loads.next().is_some_and(|load| kept(&load.key)));
        self.loads.retain(|load| kept(&load.key));
    }

    /// Lets `change` change force and couple of each contact.
    pub(crate) fn change(&mut self, mut change: impl FnMut(&mut Vec3, Option<&mut Vec3>)) {
        let mut torques = self.torques.iter_mut();
        for load in &mut self.loads {
            change(&mut load.force, torques.next());
        }
    }

    /// Whether the couples belong to the contacts.
    pub(crate) fn fits(&self) -> bool {
        self.torques.is_empty() || self.torques.len() == self.loads.len()
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
        }
    }

    /// In the memory that there is.
    fn clone_from(&mut self, other: &Self) {
        self.loads.clone_from(&other.loads);
        self.torques.clone_from(&other.torques);
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
            carried.push(load(i), Some(Vec3::x() * f64::from(i)));
        }
        carried.retain(|key| key.sphere % 2 == 1);
        assert_eq!(carried.len(), 2);
        assert_eq!([0, 1].map(|k| carried.torque(k).x), [1.0, 3.0]);
        assert!(carried.fits());
        carried.clear();
        carried.push(load(0), None);
        assert_eq!(carried.torque(0), Vec3::zeros());
        assert!(carried.fits());
        assert_eq!(size_of::<ContactForce>(), 72);
    }
}
