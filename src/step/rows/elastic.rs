//! Contacts that give way: a spring and a damper side by side that cannot pull,
//!
//! ```text
//! F = -k g - d g' >= 0,   p = -dt (k g + (theta k dt + d) u1)
//! ```
//!
//! as a row of bias `w g/dt` and compliance `w/(k dt^2)`, `w = k dt/(theta k dt + d)`. A free sphere of reduced mass `m` that such
//! a contact throws back has, with `z = d/(2 sqrt(k m))`,
//!
//! ```text
//! e = exp(-2 z/s atan(s/z)), s = sqrt(1 - z^2)    and for z > 1    e = exp(-2 z/s artanh(s/z)), s = sqrt(z^2 - 1)
//! ```
//!
//! of its speed (Schwager and Poeschel, Granular Matter 9, 2007): the damper follows from the coefficient of restitution. A
//! step that resolves the contact, `k dt^2 <= 0.1 m`, takes the spring nearly as it is before it (`theta` = 0.02), which keeps the
//! energy to second order. In a longer one an impact is that of a rigid contact, by Newton's law, and what persists is a spring
//! alone, as it is after the step (`theta` = 1), which is stable at any step. So is every contact with the integrator of Shi,
//! which has no restitution.

use crate::integrator::Integrator;

/// Largest `k dt^2/m` of a step that resolves a contact: 10 steps from touching to parting.
const RESOLVED: f64 = 0.1;
/// `theta` of a step that resolves it.
const AHEAD: f64 = 0.02;
/// Damping ratio of the least coefficient of restitution, 0.01.
const STIFFEST: f64 = 5.0;

/// Spring and damper of a contact in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Elastic {
    /// `k` \[N/m\].
    pub(crate) stiffness: f64,
    /// `d` \[N s/m\].
    pub(crate) damping: f64,
    /// `w`.
    pub(super) weight: f64,
    /// Whether the step resolves the contact.
    pub(super) resolved: bool,
}

impl Elastic {
    /// Of a contact between bodies of the reduced mass `mass` \[kg\], in a step of `dt` \[s\].
    pub(super) fn new(
        stiffness: f64,
        restitution: f64,
        (mass, dt, integrator): (f64, f64, Integrator),
    ) -> Self {
        let resolved = integrator == Integrator::Moreau && stiffness * dt * dt <= RESOLVED * mass;
        let damping = match resolved {
            true => 2.0 * damping_ratio(restitution) * (stiffness * mass).sqrt(),
            false => 0.0,
        };
        let theta = if resolved { AHEAD } else { 1.0 };
        let spring = stiffness * dt;
        Self {
            stiffness,
            damping,
            weight: spring / (theta * spring + damping),
            resolved,
        }
    }

    /// Energy stored at a gap \[J\].
    pub(crate) fn energy(&self, gap: f64) -> f64 {
        0.5 * self.stiffness * gap.min(0.0).powi(2)
    }
}

/// The coefficient of restitution of a damping ratio.
fn restitution(ratio: f64) -> f64 {
    let s = (1.0 - ratio * ratio).abs().sqrt();
    let turn = match ratio.partial_cmp(&1.0) {
        Some(std::cmp::Ordering::Less) => libm::atan2(s, ratio) / s,
        Some(std::cmp::Ordering::Greater) => libm::atanh(s / ratio) / s,
        _ => 1.0,
    };
    libm::exp(-2.0 * ratio * turn)
}

/// The damping ratio of a coefficient of restitution.
fn damping_ratio(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    let [mut low, mut high] = [0.0, STIFFEST];
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        match restitution(middle) > e {
            true => low = middle,
            false => high = middle,
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contact integrated in tiny explicit steps parts with `e`.
    #[test]
    fn the_damper_gives_the_coefficient_of_restitution() {
        for e in [0.02, 0.1, (-2.0_f64).exp(), 0.3, 0.6, 0.9, 1.0] {
            let z = damping_ratio(e);
            let (dt, mut x, mut v) = (1e-5, 0.0_f64, -1.0_f64);
            loop {
                let force = -x - 2.0 * z * v;
                if force < 0.0 && x < 0.0 {
                    break;
                }
                v += force.max(0.0) * dt;
                x += v * dt;
                if x >= 0.0 {
                    break;
                }
            }
            assert!((v - e).abs() < 1e-3, "{v} for {e} at {z}");
        }
        assert!((damping_ratio(0.0) - STIFFEST).abs() < 1e-9);
    }
}
