//! Extremes of many numbers and points. What is no number is passed over, or stays where it comes first: comparisons that
//! look for it would take three times as long, and every step asks for some extreme of all spheres.

use crate::Vec3;

/// The larger one.
#[inline]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The smaller one.
#[inline]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The smallest box around two.
#[inline]
pub(crate) fn joined((low, high): (Vec3, Vec3), (min, max): (Vec3, Vec3)) -> (Vec3, Vec3) {
    (low.zip_map(&min, smaller), high.zip_map(&max, larger))
}

/// Lower and upper corner of the box around `points`; the origin if there are none.
pub(crate) fn around(points: impl Iterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.map(|p| (p, p)).reduce(joined).unwrap_or_default()
}

/// The corners of a box: bit k of their number says which side along axis k.
pub(crate) fn corners((low, high): (Vec3, Vec3)) -> [Vec3; 8] {
    std::array::from_fn(|number| {
        Vec3::from_fn(|axis, _| match number >> axis & 1 {
            0 => low[axis],
            _ => high[axis],
        })
    })
}

/// Whether the ray from `x` along `direction` (any length) passes a box: the slab method.
pub(crate) fn passed((low, high): (Vec3, Vec3), x: Vec3, direction: Vec3) -> bool {
    let (mut from, mut to) = (0.0, f64::INFINITY);
    for axis in 0..3 {
        let (x, d) = (x[axis], direction[axis]);
        let (low, high) = (low[axis], high[axis]);
        if d == 0.0 {
            if x < low || x > high {
                return false;
            }
        } else {
            let (p, q) = ((low - x) / d, (high - x) / d);
            from = larger(from, smaller(p, q));
            to = smaller(to, larger(p, q));
        }
    }
    from <= to
}
