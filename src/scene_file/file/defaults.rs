//! Values of keys that are absent; those of `[simulation]` are those of [`Settings`].

use super::{OneOrMany, Triple, Vector};
use crate::scene::Settings;

/// Functions of the names of keys, as serde wants them.
macro_rules! of_settings {
    ($($key:ident: $typed:ty),+) => {
        $(pub(super) fn $key() -> $typed {
            Settings::default().$key as $typed
        })+
    };
}

of_settings! {
    strict: bool, adapt_penalty: bool, max_initial_overlap: f64, dynamic_coefficient: f64,
    max_iterations: u32, max_cuts: u32, threads: u32
}

pub(super) fn one() -> f64 {
    1.0
}

pub(super) fn one_for_all() -> OneOrMany<f64> {
    OneOrMany::One(1.0)
}

pub(super) fn up() -> Vector {
    Triple([0.0, 0.0, 1.0])
}
