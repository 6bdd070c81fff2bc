//! Contact transfer: what the last step's contacts hand to the next step's candidates.

use super::{Contact, Key};
use crate::Vec3;

/// What a contact carried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// Force on A \[N\].
    pub force: Vec3,
    /// Couple of its resistance on A \[N m\].
    pub torque: Vec3,
}

impl Carried {
    fn of(contact: Option<&Contact>) -> Self {
        Self {
            force: contact.map_or_else(Vec3::zeros, |contact| contact.force),
            torque: contact.map_or_else(Vec3::zeros, |contact| contact.torque),
        }
    }
}

/// Into `carried` what each key of `keys` carried in `contacts`, zero for new contacts. Both are in canonical order.
pub fn transfer(contacts: &[Contact], keys: impl Iterator<Item = Key>, carried: &mut Vec<Carried>) {
    let mut old = contacts.iter().peekable();
    carried.clear();
    carried.extend(keys.map(|key| {
        while old.next_if(|contact| contact.key < key).is_some() {}
        Carried::of(old.next_if(|contact| contact.key == key))
    }));
}

/// What `key` carried in `contacts`, which are in canonical order.
#[must_use]
pub fn find(contacts: &[Contact], key: Key) -> Carried {
    let at = contacts.binary_search_by_key(&key, |contact| contact.key);
    Carried::of(at.ok().map(|at| &contacts[at]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contacts::Partner;

    #[test]
    fn forces_follow_their_keys() {
        let key = |i, j| Key {
            sphere: i,
            partner: Partner::sphere(j),
        };
        let contact = |key, f| Contact {
            key,
            point: Vec3::zeros(),
            normal: Vec3::z(),
            gap: 0.0,
            force: Vec3::z() * f,
            torque: Vec3::x() * f,
        };
        let old = [
            contact(key(0, 1), 1.0),
            contact(key(0, 3), 2.0),
            contact(key(2, 4), 3.0),
        ];
        let new = [key(0, 2), key(0, 3), key(1, 2), key(2, 4), key(5, 6)];
        let mut carried = Vec::new();
        transfer(&old, new.into_iter(), &mut carried);
        assert!(
            new.iter()
                .zip(&carried)
                .all(|(key, c)| find(&old, *key) == *c)
        );
        let [force, torque] = [|c: &Carried| c.force.z, |c: &Carried| c.torque.x]
            .map(|of| carried.iter().map(of).collect::<Vec<f64>>());
        assert_eq!(force, [0.0, 2.0, 0.0, 3.0, 0.0]);
        assert_eq!(torque, force);
    }
}
