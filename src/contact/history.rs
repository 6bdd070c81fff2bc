//! Contact transfer: what the last step's contacts hand to the next step's candidates.

use nalgebra::UnitQuaternion;

use super::cohesion::Hold;
use super::forces::{ContactForces, SpringState};
use super::{ContactForce, ContactId, Partner};
use crate::Vec3;
use crate::problem::law::split;

/// What a contact carried in the last step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Carried {
    /// Force on A \[N\].
    pub(crate) force: Vec3,
    /// Couple on A \[N m\].
    pub(crate) torque: Vec3,
    /// Unit normal from B to A in that step.
    pub(crate) normal: Vec3,
    /// Its spring, if it gave way.
    pub(crate) spring: Option<SpringState>,
    /// What holds its surfaces together.
    pub(crate) hold: Hold,
}

impl Carried {
    /// Force \[N\] along its normal by which its spring was pressed.
    pub(crate) fn pressed(&self) -> f64 {
        match self.spring {
            Some(SpringState::Stretched { .. }) => self.force.dot(&self.normal),
            _ => 0.0,
        }
    }

    /// Shear force \[N\] and stiffness \[N/m\] of its spring where the normal is `normal` now: the force turns with the contact.
    pub(crate) fn shear(&self, normal: Vec3) -> Option<(Vec3, f64)> {
        let Some(SpringState::Stretched { shear, stiffness }) = self.spring else {
            return None;
        };
        let turned = split(shear, normal).1;
        let direction = turned.try_normalize(0.0)?;
        Some((direction * shear.norm(), stiffness))
    }
}

/// Which of the last step's contacts a candidate goes on with, if any.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HistoryIndex(u32);

impl HistoryIndex {
    /// A contact that was not there.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Its force on A \[N\] in those `contacts`; zero without one.
    #[inline]
    pub(crate) fn force(self, contacts: &[ContactForce]) -> Vec3 {
        let load = contacts.get(self.0 as usize);
        load.map_or_else(Vec3::zeros, |load| load.force)
    }

    /// Energy \[J\] that its shear spring has stored.
    pub(crate) fn stored(self, contacts: &ContactForces) -> f64 {
        let spring = contacts.beside(self.0 as usize).spring;
        spring.map_or(0.0, |spring| spring.energy())
    }

    /// All that its row is made from.
    #[inline]
    pub(crate) fn carried(self, contacts: &ContactForces) -> Carried {
        let load = contacts.get(self.0 as usize);
        Carried {
            force: self.force(contacts),
            torque: self.torque(contacts),
            normal: load.map_or_else(Vec3::zeros, |load| load.normal),
            spring: contacts.beside(self.0 as usize).spring,
            hold: self.hold(contacts),
        }
    }

    /// Likewise what holds its surfaces together.
    #[inline]
    pub(crate) fn hold(self, contacts: &ContactForces) -> Hold {
        contacts.hold(self.0 as usize)
    }

    /// [`Self::torque`] that has turned with the normal, which is `normal` now.
    pub(crate) fn turned_torque(self, contacts: &ContactForces, normal: Vec3) -> Vec3 {
        let before = contacts.get(self.0 as usize).map(|load| load.normal);
        let turn = before.and_then(|before| UnitQuaternion::rotation_between(&before, &normal));
        let torque = self.torque(contacts);
        turn.map_or(torque, |turn| turn * torque)
    }

    /// Likewise the couple of its resistance on A \[N m\].
    pub(crate) fn torque(self, contacts: &ContactForces) -> Vec3 {
        contacts.torque(self.0 as usize)
    }
}

/// Which of `contacts` each of `keys` goes on with. Both are in canonical order.
pub(crate) fn transfer(
    contacts: &[ContactForce],
    keys: impl Iterator<Item = ContactId>,
) -> impl Iterator<Item = HistoryIndex> {
    let mut at = None;
    keys.map(move |key| {
        let from = at.unwrap_or_else(|| contacts.partition_point(|load| load.key < key));
        let older = contacts[from..].iter().take_while(|load| load.key < key);
        let place = from + older.count();
        at = Some(place);
        let same = contacts.get(place).is_some_and(|load| load.key == key);
        if same {
            HistoryIndex(place as u32)
        } else {
            HistoryIndex::NONE
        }
    })
}

/// What the candidate `key` of a boundary goes on with where `own` is none: the attached contact of its sphere with another feature
/// of this boundary, which the sphere has left for this one. `is_candidate` knows those that it has not.
pub(crate) fn succeed(
    contacts: &ContactForces,
    own: HistoryIndex,
    key: ContactId,
    is_candidate: impl Fn(ContactId) -> bool,
) -> HistoryIndex {
    let Partner::Boundary { boundary, .. } = key.partner else {
        return own;
    };
    if own != HistoryIndex::NONE {
        return own;
    }
    let first = ContactId {
        partner: Partner::Boundary {
            boundary,
            feature: 0,
        },
        ..key
    };
    let from = contacts.partition_point(|load| load.key < first);
    let same = |load: &&ContactForce| match load.key.partner {
        Partner::Boundary { boundary: b, .. } => load.key.sphere == key.sphere && b == boundary,
        Partner::Sphere { .. } => false,
    };
    let mut left = contacts[from..].iter().take_while(same).zip(from..);
    let left = left.find(|(load, k)| contacts.hold(*k) != Hold::Loose && !is_candidate(load.key));
    left.map_or(own, |(_, k)| HistoryIndex(k as u32))
}

/// Which of `contacts`, which are in canonical order, `key` goes on with.
pub(crate) fn find(contacts: &[ContactForce], key: ContactId) -> HistoryIndex {
    let at = contacts.binary_search_by_key(&key, |load| load.key);
    at.map_or(HistoryIndex::NONE, |at| HistoryIndex(at as u32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Partner;
    use crate::contact::forces::Beside;

    #[test]
    fn forces_follow_their_keys() {
        let key = |i, j| ContactId {
            sphere: i,
            partner: Partner::sphere(j),
        };
        let contact = |key, f| ContactForce {
            key,
            normal: Vec3::z(),
            force: Vec3::z() * f,
        };
        let mut old = ContactForces::default();
        for (key, f) in [(key(0, 1), 1.0), (key(0, 3), 2.0), (key(2, 4), 3.0)] {
            let beside = Beside {
                torque: Some(Vec3::x() * f),
                spring: None,
                hold: None,
            };
            old.push(contact(key, f), beside);
        }
        let new = [key(0, 2), key(0, 3), key(1, 2), key(2, 4), key(5, 6)];
        let past: Vec<HistoryIndex> = transfer(&old, new.into_iter()).collect();
        assert!(transfer(&old, new.into_iter().skip(2)).eq(past[2..].iter().copied()));
        assert!(new.iter().zip(&past).all(|(key, p)| find(&old, *key) == *p));
        let force: Vec<f64> = past.iter().map(|p| p.force(&old).z).collect();
        let torque: Vec<f64> = past.iter().map(|p| p.torque(&old).x).collect();
        assert_eq!(force, [0.0, 2.0, 0.0, 3.0, 0.0]);
        assert_eq!(torque, force);
    }
}
