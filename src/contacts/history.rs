//! Contact transfer: what the last step's contacts hand to the next step's candidates.

use super::{Contact, Key};
use crate::Vec3;

/// The force \[N\] each key of `keys` carried in `contacts`, zero for new contacts. Both are in canonical
/// order.
pub fn transfer(contacts: &[Contact], keys: impl Iterator<Item = Key>) -> Vec<Vec3> {
    let mut old = contacts.iter().peekable();
    keys.map(|key| {
        while old.next_if(|contact| contact.key < key).is_some() {}
        old.next_if(|contact| contact.key == key)
            .map_or_else(Vec3::zeros, |contact| contact.force)
    })
    .collect()
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
        };
        let old = [
            contact(key(0, 1), 1.0),
            contact(key(0, 3), 2.0),
            contact(key(2, 4), 3.0),
        ];
        let new = [key(0, 2), key(0, 3), key(1, 2), key(2, 4), key(5, 6)];
        let force: Vec<f64> = transfer(&old, new.into_iter())
            .iter()
            .map(|f| f.z)
            .collect();
        assert_eq!(force, [0.0, 2.0, 0.0, 3.0, 0.0]);
    }
}
