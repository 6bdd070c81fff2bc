//! The law of a row: which impulses it admits. Written here once, for the residual, all solvers and the tangent.
//!
//! With the trial impulse `y = p - s d`, a row's impulse is the projection of `y` on an interval along the normal and a disc
//! across it:
//!
//! ```text
//!                 along the normal         radius across it
//! contact         0 <= p_n                 mu p_n                 unilateral; open, stick, slip in one formula
//! bilateral       any                      any                    springs, constrained points
//! resistance      |m_n| <= L_t p_n         L_r p_n                twisting and rolling; p_n of its contact
//! ```
//!
//! With a compliance `c` the gap is `d + c p`, and the fixed point is the projection of `(p - s d)/(1 + s c)`.
//! `s > 0` is any scale: the fixed points do not depend on it. Source: the paper's
//! eq 8 with the projection that print leaves out.
//!
//! A new law is a variant of [`Law`] with its [`Law::bounds`]: projection, derivative, energy and margin follow.

use std::ops::{Add, Mul, Sub};

use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Shear penalty over normal penalty, `P_t = P_n / 2.5` (Shi's constant).
pub(crate) const SHEAR_RATIO: f64 = 0.4;

/// The law a row obeys.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Law {
    /// Signorini-Coulomb contact with friction coefficient `mu`.
    Contact {
        /// Friction coefficient \[-\].
        mu: f64,
    },
    /// Three equations `u + b + c p = 0`; `normal` only fixes the axes.
    Bilateral,
    /// Rolling and twisting resistance of a contact: couples, of which `p` and `u` are those over and times `radius`.
    Resistance {
        /// The contact's row, which comes before.
        contact: u32,
        /// Largest rolling impulse over the contact's normal one \[-\]: `mu_r R*/R`.
        rolling: f64,
        /// Largest twisting impulse over the contact's normal one \[-\]: `mu_t R*/R`.
        twisting: f64,
    },
}

/// What a law admits: impulses \[N s\] between two bounds along the normal, within a disc across it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    /// Least and greatest impulse along the normal.
    pub along: [f64; 2],
    /// Radius of the disc across it.
    pub across: f64,
}

/// The projection on an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Along {
    /// The projection.
    pub value: f64,
    /// Whether `y` is inside: the derivative of the projection.
    pub inside: bool,
    /// Which bound it is on if it is not: -1 or 1.
    pub side: f64,
    /// The potential of which the projection is the gradient.
    pub energy: f64,
}

/// The projection on a disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Across {
    /// The projection.
    pub value: Vec3,
    /// Its derivative.
    pub tangent: Matrix3<f64>,
    /// Its derivative by the radius.
    pub(crate) outward: Vec3,
    /// The potential of which the projection is the gradient.
    pub energy: f64,
}

/// Numbers that the law of contact works on: one, or one for each lane.
pub(crate) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// `self / other`.
    fn over(self, other: Self) -> Self;
    /// Square root.
    fn root(self) -> Self;
    /// The larger; of equal ones, and where one is no number, `other`.
    fn or_larger(self, other: Self) -> Self;
    /// `yes` where `self <= limit`, else `no`.
    fn within(self, limit: Self, yes: Self, no: Self) -> Self;
}

impl Number for f64 {
    fn over(self, other: Self) -> Self {
        self / other
    }

    fn root(self) -> Self {
        self.sqrt()
    }

    fn or_larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    fn within(self, limit: Self, yes: Self, no: Self) -> Self {
        if self <= limit { yes } else { no }
    }
}

/// The law of contact at the trial impulse `y_n` along the normal and one of square `squared` across it: the normal impulse, and
/// the share that stays of the tangential one.
#[inline(always)]
pub(crate) fn onto_cone<N: Number>(y_n: N, squared: N, mu: N, (zero, one): (N, N)) -> (N, N) {
    let normal = y_n.or_larger(zero);
    (normal, onto_disc(squared, mu * normal, one))
}

/// The law of a row whose bounds do not depend on its own impulse, at the trial impulse `y_n` along the normal and one of square
/// `squared` across it: likewise.
#[inline(always)]
pub(crate) fn onto_cylinder<N: Number>(
    y_n: N,
    squared: N,
    ([least, most], across): ([N; 2], N),
    one: N,
) -> (N, N) {
    let upper = y_n.within(most, y_n, most);
    let normal = least.within(upper, upper, least);
    (normal, onto_disc(squared, across, one))
}

/// The share of a vector of square `squared` that stays on the disc of the given radius.
#[inline(always)]
fn onto_disc<N: Number>(squared: N, radius: N, one: N) -> N {
    let length = squared.root();
    length.within(radius, one, radius.over(length))
}

impl Law {
    /// What it admits where a contact presses with `normal` \[N s\]: its own normal impulse, or that of the contact to which a
    /// resistance belongs.
    #[inline]
    pub(crate) fn bounds(&self, normal: f64) -> Bounds {
        match *self {
            Self::Contact { mu } => Bounds {
                along: [0.0, f64::INFINITY],
                across: mu * normal,
            },
            Self::Bilateral => Bounds {
                along: [f64::NEG_INFINITY, f64::INFINITY],
                across: f64::INFINITY,
            },
            Self::Resistance {
                rolling, twisting, ..
            } => Bounds {
                along: [-twisting * normal, twisting * normal],
                across: rolling * normal,
            },
        }
    }

    /// How the bounds grow with the normal impulse \[-\]: the upper one along the normal, and the radius across it.
    pub(crate) fn growth(&self) -> [f64; 2] {
        match *self {
            Self::Contact { mu } => [0.0, mu],
            Self::Bilateral => [0.0; 2],
            Self::Resistance {
                rolling, twisting, ..
            } => [twisting, rolling],
        }
    }

    /// The impulse \[N s\] that is admitted nearest to a trial, along the normal and across it; `load` bounds a resistance.
    #[must_use]
    #[inline]
    pub fn project(&self, y_n: f64, y_t: Vec3, load: f64) -> (f64, Vec3) {
        let squared = y_t.norm_squared();
        let (normal, share) = match *self {
            Self::Contact { mu } => onto_cone(y_n, squared, mu, (0.0, 1.0)),
            _ => {
                let Bounds { along, across } = self.bounds(load);
                onto_cylinder(y_n, squared, (along, across), 1.0)
            }
        };
        (normal, y_t * share)
    }

    /// Distance of a trial impulse \[N s\] to the nearest edge between two states of the row (open, stick, slip) over its
    /// size: 1 or more is far. `normal` presses ([`Law::bounds`]), `size` is that of the row's impulse.
    #[inline]
    pub(crate) fn margin(&self, y_n: f64, y_t: f64, normal: f64, size: f64) -> f64 {
        let edge = |size: f64, bound: f64| match bound > 0.0 && bound.is_finite() {
            true => (size - bound).abs() / bound,
            false => 1.0,
        };
        let Bounds { along, across } = self.bounds(normal);
        let along = match *self {
            Self::Contact { .. } if size > 0.0 => y_n.abs() / size,
            _ => edge(y_n.abs(), along[1]),
        };
        along.min(edge(y_t, across))
    }
}

impl Bounds {
    /// The projection along the normal.
    #[inline]
    pub(crate) fn along(&self, y: f64) -> Along {
        let [least, most] = self.along;
        let value = y.max(least).min(most);
        Along {
            value,
            inside: least < y && y < most,
            side: y.signum(),
            energy: value * (y - 0.5 * value),
        }
    }

    /// The projection across the normal, where `identity` is that of the tangent plane.
    pub(crate) fn across(&self, y: Vec3, identity: &Matrix3<f64>) -> Across {
        let (length, radius) = (y.norm(), self.across);
        if length < radius {
            return Across {
                value: y,
                tangent: *identity,
                outward: Vec3::zeros(),
                energy: 0.5 * length * length,
            };
        }
        let outward = y.try_normalize(0.0).unwrap_or_default();
        let tangent = match radius > 0.0 {
            true => (identity - outward * outward.transpose()) * (radius / length),
            false => Matrix3::zeros(),
        };
        Across {
            value: y * onto_disc(y.norm_squared(), radius, 1.0),
            tangent,
            outward,
            energy: radius * length - 0.5 * radius * radius,
        }
    }
}

/// The part of `x` along the unit normal `n`, and the rest across it.
pub(crate) fn split(x: Vec3, n: Vec3) -> (f64, Vec3) {
    let along = n.dot(&x);
    (along, x - n * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-10.0..10.0f64).prop_map(Vec3::from)
    }

    /// Every law, with trial impulses and the load of a resistance.
    fn cases() -> impl Strategy<Value = (Law, f64, Vec3, f64)> {
        let law = prop_oneof![
            (0.0..2.0f64).prop_map(|mu| Law::Contact { mu }),
            Just(Law::Contact { mu: 0.0 }),
            Just(Law::Bilateral),
            (0.0..2.0f64, 0.0..2.0f64).prop_map(|(rolling, twisting)| Law::Resistance {
                contact: 0,
                rolling,
                twisting,
            }),
        ];
        let across = vector().prop_map(|y| split(y, Vec3::z()).1);
        (law, -10.0..10.0f64, across, 0.0..5.0f64)
    }

    /// What presses a row of impulse `p_n` along its normal.
    fn pressing(law: &Law, p_n: f64, load: f64) -> f64 {
        match law {
            Law::Resistance { .. } => load,
            _ => p_n,
        }
    }

    proptest! {
        /// What is projected is admitted, stays where it is, and nothing else that is admitted lies nearer with the same bounds.
        #[test]
        fn the_projection_is_admitted_idempotent_and_nearest((law, y_n, y_t, load) in cases(), z_n in -10.0..10.0f64, z_t in vector()) {
            let (p_n, p_t) = law.project(y_n, y_t, load);
            let bounds = law.bounds(pressing(&law, p_n, load));
            let [least, most] = bounds.along;
            prop_assert!(least <= p_n && p_n <= most);
            prop_assert!(p_t.norm() <= bounds.across * (1.0 + 1e-15));
            let (again_n, again_t) = law.project(p_n, p_t, load);
            prop_assert!(again_n == p_n && (again_t - p_t).norm() <= 1e-15 * p_t.norm());
            let identity = Matrix3::identity();
            let (q_n, q_t) = (bounds.along(z_n).value, bounds.across(z_t, &identity).value);
            prop_assert!((y_n - p_n).abs() <= (y_n - q_n).abs() + 1e-12);
            prop_assert!((y_t - p_t).norm() <= (y_t - q_t).norm() + 1e-12);
        }

        /// Value, derivative by the trial and by the radius, and energy belong together: central differences, second order.
        #[test]
        fn derivatives_are_those_of_the_projection((law, y_n, y_t, load) in cases(), d in vector()) {
            let (bounds, identity) = (law.bounds(load), Matrix3::identity());
            let edge = (bounds.across - y_t.norm()).abs();
            prop_assume!(edge > 1e-2 && y_t.norm() > 1e-2);
            prop_assume!(bounds.along.iter().all(|bound| (y_n - bound).abs() > 1e-2));
            let here = bounds.across(y_t, &identity);
            let d = d.normalize();
            let h = 1e-4;
            let [low, high] = [-h, h].map(|h| bounds.across(y_t + d * h, &identity));
            prop_assert!(((high.value - low.value) / (2.0 * h) - here.tangent * d).norm() < 1e-4);
            prop_assert!(((high.energy - low.energy) / (2.0 * h) - here.value.dot(&d)).abs() < 1e-4);
            if bounds.across.is_finite() {
                let radius = |h: f64| Bounds { across: bounds.across + h, ..bounds };
                let [low, high] = [-h, h].map(|h| radius(h).across(y_t, &identity).value);
                prop_assert!(((high - low) / (2.0 * h) - here.outward).norm() < 1e-6);
            }
            let here = bounds.along(y_n);
            let [low, high] = [-h, h].map(|h| bounds.along(y_n + h));
            let slope = if here.inside { 1.0 } else { 0.0 };
            prop_assert!(((high.value - low.value) / (2.0 * h) - slope).abs() < 1e-9);
            prop_assert!(((high.energy - low.energy) / (2.0 * h) - here.value).abs() < 1e-6);
        }

        /// Bounds have the given derivative.
        #[test]
        fn bounds_grow_with_the_normal_impulse((law, _, _, load) in cases()) {
            let [low, high] = [0.0, load].map(|load| law.bounds(load));
            let grown = |low: f64, high: f64| if high.is_finite() { high - low } else { 0.0 };
            let [along, across] = law.growth();
            prop_assert!((grown(low.along[1], high.along[1]) - along * load).abs() < 1e-12);
            prop_assert!((grown(low.across, high.across) - across * load).abs() < 1e-12);
        }

        #[test]
        fn split_is_orthogonal_and_complete(x in vector(), m in vector()) {
            prop_assume!(m.norm() > 1e-3);
            let n = m.normalize();
            let (along, across) = split(x, n);
            prop_assert!((n * along + across - x).norm() < 1e-13);
            prop_assert!(across.dot(&n).abs() < 1e-12);
        }

        /// The margin vanishes at the edges alone, and says how far they are.
        #[test]
        fn the_margin_is_the_way_to_the_edge(mu in 0.1..2.0f64, normal in 0.1..5.0f64, off in -0.5..0.5f64) {
            let law = Law::Contact { mu };
            let edge = mu * normal;
            prop_assert!((law.margin(normal, edge * (1.0 + off), normal, normal) - off.abs()).abs() < 1e-12);
            prop_assert!((law.margin(off * normal, 0.0, normal, normal) - off.abs()).abs() < 1e-12);
        }
    }
}
