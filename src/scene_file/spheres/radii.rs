//! Radii of a group.

use rand_chacha::ChaCha8Rng;

use crate::scene_file::document::Document;
use crate::scene_file::file::{self, OneOrMany};
use crate::scene_file::sizes::Sizes;

/// The group's `radius_jitter`, checked.
pub(super) fn jitter(
    document: &mut Document<'_>,
    path: &str,
    group: &file::Spheres,
) -> Option<f64> {
    let jitter = group.radius_jitter;
    let expected = "0 <= radius_jitter < 1 [-]";
    let good = document.within((path, "radius_jitter"), jitter, 0.0..1.0, expected);
    good.then_some(jitter)
}

/// Radii of a group whose places are known.
pub(super) enum Radii {
    /// One each \[m\].
    Listed(Vec<f64>),
    /// Drawn in the order of the spheres.
    Drawn(Sizes),
}

impl Radii {
    /// For `number` spheres, whose radii \[m\] may come from a file.
    pub(super) fn new(
        document: &mut Document<'_>,
        path: &str,
        group: &file::Spheres,
        number: usize,
        from_file: Option<Vec<f64>>,
    ) -> Option<Self> {
        let key = format!("{path}.radius");
        match (&group.radius, from_file) {
            (None, Some(list)) if group.size.is_none() => Some(Self::Listed(list)),
            (given, Some(_)) => {
                let key = given.as_ref().map_or(format!("{path}.size"), |_| key);
                let message = "found both this key and radii in the file, expected one of them";
                document.reject(key, message, "remove one of the two")
            }
            (Some(OneOrMany::Many(list)), None) if group.size.is_none() => {
                let expected = format!("one radius, or {number} of them");
                let found = format!("{} radii", list.len());
                let mut good =
                    document.demand(list.len() == number, key.as_str(), found, &expected);
                for (k, r) in list.iter().enumerate() {
                    good &= document.positive(format!("{key}[{k}]"), *r, "a radius > 0 [m]");
                }
                good.then(|| Self::Listed(list.clone()))
            }
            _ => Self::drawn(document, path, group).map(Self::Drawn),
        }
    }

    /// One radius for all, or a distribution.
    pub(super) fn drawn(
        document: &mut Document<'_>,
        path: &str,
        group: &file::Spheres,
    ) -> Option<Sizes> {
        let one = match &group.radius {
            Some(OneOrMany::Many(list)) if group.size.is_none() => {
                let found = format!("a list of {} radii", list.len());
                let expected = "one radius for all, or `size` instead of it";
                return document.refuse((path, "radius"), found, expected);
            }
            // With `size` given too the number does not matter: one of the two is too many.
            Some(OneOrMany::Many(_)) => Some(1.0),
            Some(OneOrMany::One(radius)) => Some(*radius),
            None => None,
        };
        Sizes::new(document, path, one, group.size.as_ref())
    }

    /// Radius of sphere `k` of the group \[m\].
    pub(super) fn of(&self, k: usize, random: &mut ChaCha8Rng) -> f64 {
        match self {
            Self::Listed(list) => list[k],
            Self::Drawn(sizes) => sizes.draw(random),
        }
    }
}
