//! Values of keys that are absent.

use super::{OneOrMany, Triple, Vector};

pub(super) fn one() -> f64 {
    1.0
}

pub(super) fn one_for_all() -> OneOrMany<f64> {
    OneOrMany::One(1.0)
}

pub(super) fn up() -> Vector {
    Triple([0.0, 0.0, 1.0])
}
