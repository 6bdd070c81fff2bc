//! The Signorini-Coulomb law in augmented form: projections, pure functions.
//!
//! ```text
//! p_n = max(0, p_n - s_n d_n)                        unilateral contact
//! p_t = Proj_{|.| <= mu p_n}(p_t - s_t d_t)          Coulomb friction: open / stick / slip in one formula
//! m_r = Proj_{|.| <= L_r p_n}(m_r - s w_r)           rolling resistance, a disc across the normal
//! m_n = Proj_{|.| <= L_t p_n}(m_n - s w_n)           twisting resistance, an interval along it
//! ```
//!
//! With a compliance `c` the gap is `d + c p`, and the fixed point is `max(0, (p - s d)/(1 + s c))`.
//! `s > 0` is any scale: the fixed points do not depend on it. Source: the paper's
//! eq 8 with the projection that print leaves out.

use serde::{Deserialize, Serialize};

use crate::Vec3;

/// Shear penalty over normal penalty, `P_t = P_n / 2.5` (Shi's constant).
pub const SHEAR_RATIO: f64 = 0.4;

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

/// Projects a tangential vector on the disc of radius `r >= 0`.
#[must_use]
pub fn project_disc(y: Vec3, r: f64) -> Vec3 {
    let length = y.norm();
    if length <= r { y } else { y * (r / length) }
}

/// Projects on the interval `-r..=r`, `r >= 0`.
#[must_use]
pub fn project_interval(y: f64, r: f64) -> f64 {
    y.max(-r).min(r)
}

/// The part of `x` along the unit normal `n`, and the rest across it.
#[must_use]
pub fn split(x: Vec3, n: Vec3) -> (f64, Vec3) {
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

    proptest! {
        #[test]
        fn the_projection_is_idempotent_inside_and_nearest(y in vector(), z in vector(), r in 0.0..5.0f64) {
            let p = project_disc(y, r);
            prop_assert!(p.norm() <= r * (1.0 + 1e-15));
            prop_assert!((project_disc(p, r) - p).norm() <= 1e-15 * (1.0 + r));
            // No other point of the disc is nearer: (y - p).(q - p) <= 0 for all q in the disc.
            let q = project_disc(z, r);
            prop_assert!((y - p).dot(&(q - p)) <= 1e-12);
        }

        #[test]
        fn split_is_orthogonal_and_complete(x in vector(), m in vector()) {
            prop_assume!(m.norm() > 1e-3);
            let n = m.normalize();
            let (along, across) = split(x, n);
            prop_assert!((n * along + across - x).norm() < 1e-13);
            prop_assert!(across.dot(&n).abs() < 1e-12);
        }
    }
}
