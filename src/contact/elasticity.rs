//! How surfaces give way where they press on each other.
//!
//! With the overlap `d = -g` \[m\] and the reduced radius `1/R* = 1/R_A + 1/R_B` (on a boundary `R`):
//!
//! ```text
//!          normal force        shear stiffness             stored
//! linear   F = k d             k_t = 2/5 k                 k d^2/2
//! Hertz    F = K d^(3/2)       k_t = 8 G* sqrt(R* d)       2/5 K d^(5/2)      K = 4/3 E* sqrt(R*)
//!
//! 1/E* = (1 - n_A^2)/E_A + (1 - n_B^2)/E_B,   1/G* = (2 - n_A)/G_A + (2 - n_B)/G_B,   G = E/(2 (1 + n))
//! ```
//!
//! `E` is Young's modulus \[Pa\], `n` Poisson's ratio; a material without them is rigid. Sources: Johnson, Contact Mechanics, 1985,
//! sections 4.2 and 7.2 (Hertz; Mindlin without micro-slip); the ratio 2/5 is Shi's.
//!
//! A damper beside the spring, `F_d = -2 z sqrt(m s) d(d)/dt`, takes of the speed of a pair of the reduced mass `m` what the
//! coefficient of restitution `e` says, at any speed: linear with `s = k`, Hertz with `s = 5/4 K sqrt(d)` (Tsuji, Tanaka and Ishida,
//! Powder Technology 71, 1992). The contact ends where the force does:
//!
//! ```text
//! e = exp(-2 z/q atan(q/z)), q = sqrt(1 - z^2)    and for z > 1    e = exp(-2 z/q artanh(q/z)), q = sqrt(z^2 - 1)
//! ```
//!
//! (Schwager and Poeschel, Granular Matter 9, 2007). That holds for both: with `y = sqrt(4/5) d^(5/4)` and the pseudo-time in
//! which `dy = d(d)/dt ds`, Hertz's law with this damper is the linear one, `y'' = -y - 2 z y'`, and its force ends where that does.

use serde::{Deserialize, Serialize};

use super::neck::Neck;
use super::spring::ContactSpring;
use crate::problem::law::SHEAR_RATIO;

/// Overlap over the radius \[-\] above which Hertz's law, one of small overlaps, is a repulsion and no more.
pub const LARGEST_COMPRESSION: f64 = 0.1;
/// Damping ratio of the least coefficient of restitution, 0.01.
const LARGEST_RATIO: f64 = 5.0;

/// How two materials give way to each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Elasticity {
    /// By a spring.
    Linear {
        /// Stiffness `k` \[N/m\] along the normal.
        stiffness: f64,
        /// Stiffness \[N/m\] across it; infinite: rigid.
        shear: f64,
    },
    /// As elastic spheres.
    Hertz {
        /// `E*` \[Pa\].
        young: f64,
        /// `G*` \[Pa\].
        shear: f64,
    },
}

/// Young's modulus \[Pa\] and Poisson's ratio \[-\] of a material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Elastic {
    /// Young's modulus \[Pa\], > 0.
    pub young: f64,
    /// Poisson's ratio \[-\], 0..=0.5.
    pub poisson: f64,
}

impl Elasticity {
    /// Springs of stiffness `k` \[N/m\] along the normal and 2/5 of it across.
    #[must_use]
    pub fn linear(stiffness: f64) -> Self {
        Self::Linear {
            stiffness,
            shear: SHEAR_RATIO * stiffness,
        }
    }

    /// Of two materials, of which one may be rigid; `None` where both are.
    #[must_use]
    pub fn hertz(materials: [Option<Elastic>; 2]) -> Option<Self> {
        let soft = || materials.iter().flatten();
        soft().next()?;
        let normal = |m: &Elastic| (1.0 - m.poisson * m.poisson) / m.young;
        let across = |m: &Elastic| 2.0 * (2.0 - m.poisson) * (1.0 + m.poisson) / m.young;
        Some(Self::Hertz {
            young: 1.0 / soft().map(normal).sum::<f64>(),
            shear: 1.0 / soft().map(across).sum::<f64>(),
        })
    }

    /// The spring of a contact of the reduced radius `R*` \[m\].
    #[must_use]
    pub(crate) fn spring(&self, reduced_radius: f64) -> ContactSpring {
        match *self {
            Self::Linear { stiffness, shear } => ContactSpring::linear(stiffness, shear),
            Self::Hertz { young, shear } => ContactSpring::hertz(young, shear, reduced_radius),
        }
    }

    /// The curve of a contact that adheres with a work of adhesion \[J/m^2\]; `None` where grains are no elastic solids or it is zero.
    #[must_use]
    pub(crate) fn neck(&self, energy: f64, reduced_radius: f64) -> Option<Neck> {
        match *self {
            Self::Hertz { young, .. } if energy > 0.0 => {
                Some(Neck::new(energy, young, reduced_radius))
            }
            _ => None,
        }
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
#[must_use]
pub(crate) fn damping_ratio(e: f64) -> f64 {
    if e >= 1.0 {
        return 0.0;
    }
    let [mut low, mut high] = [0.0, LARGEST_RATIO];
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
    use crate::contact::spring::BondSpring;

    fn springs() -> [ContactSpring; 2] {
        let glass = Elastic {
            young: 70e9,
            poisson: 0.25,
        };
        let hertz = Elasticity::hertz([Some(glass), None]).unwrap();
        [Elasticity::linear(3e4), hertz].map(|law| law.spring(5e-3))
    }

    /// A bond adds its line to the force, pulls where surfaces are apart, and `overlap` stays the inverse.
    #[test]
    fn a_bond_acts_beside_the_spring() {
        let bond = BondSpring {
            normal: 2e4,
            shear: 8e3,
            rest: 3e-6,
            attraction: 7.0,
        };
        for spring in springs() {
            let bonded = spring.clone().held((None, false), Some(bond));
            for d in [-1e-4, -1e-6, 0.0, 2e-7, 1e-5] {
                let beside = bonded.force(d) - spring.force(d.max(0.0));
                assert!((beside - 7.0 - 2e4 * (d + 3e-6)).abs() < 1e-9);
                let found = bonded.overlap(bonded.force(d));
                assert!((found - d).abs() < 1e-12, "{found:e} for {d:e}");
                let own = if d > 0.0 { spring.shear(d) } else { 0.0 };
                assert!((bonded.shear(d) - own - 8e3).abs() < 1e-9 * own.max(1.0));
                let h = 1e-9;
                if d != 0.0 {
                    let rise = (bonded.force(d + h) - bonded.force(d - h)) / (2.0 * h);
                    assert!((bonded.slope(d) / rise - 1.0).abs() < 1e-4);
                }
                let tangent = bonded.force(d) - bonded.slope(d) * (d - bonded.intercept(d));
                assert!(tangent.abs() < 1e-9);
            }
        }
    }

    /// Force is the derivative of energy, slope that of force; `overlap` and `reach` are inverses, the tangent has its zero.
    #[test]
    fn the_functions_of_a_spring_belong_together() {
        for spring in springs() {
            for d in [1e-9, 1e-6, 1e-4] {
                let h = 1e-4 * d;
                let rate = |f: &dyn Fn(f64) -> f64| (f(d + h) - f(d - h)) / (2.0 * h);
                let force = spring.force(d);
                assert!((rate(&|d| spring.energy(d)) / force - 1.0).abs() < 1e-7);
                assert!((rate(&|d| spring.force(d)) / spring.slope(d) - 1.0).abs() < 1e-7);
                assert!((spring.overlap(force) / d - 1.0).abs() < 1e-12);
                let tangent = force - spring.slope(d) * (d - spring.intercept(d));
                assert!(tangent.abs() < 1e-12 * force);
                assert!((spring.reach(spring.energy(d)) / d - 1.0).abs() < 1e-12);
            }
        }
    }

    /// Two equal materials are half as stiff as one on a rigid wall, and Mindlin's ratio `k_t/k_n` is `2 (1 - n)/(2 - n)`.
    #[test]
    fn moduli_are_those_of_hertz_and_mindlin() {
        let steel = Elastic {
            young: 210e9,
            poisson: 0.3,
        };
        assert_eq!(Elasticity::hertz([None, None]), None);
        let moduli = |pair| match Elasticity::hertz(pair) {
            Some(Elasticity::Hertz { young, shear }) => [young, shear],
            other => panic!("{other:?}"),
        };
        let [wall, both] = [[Some(steel), None], [Some(steel); 2]].map(moduli);
        assert!((wall[0] / (210e9 / 0.91) - 1.0).abs() < 1e-15);
        assert!((0..2).all(|k| (wall[k] / both[k] - 2.0).abs() < 1e-15));
        let spring = Elasticity::hertz([Some(steel); 2]).unwrap().spring(0.01);
        let ratio = spring.shear(1e-6) / spring.slope(1e-6);
        assert!((ratio - 2.0 * 0.7 / 1.7).abs() < 1e-14, "{ratio}");
    }

    /// Contacts integrated in tiny explicit steps part with `e` of their speed, whatever that is.
    #[test]
    fn the_damper_gives_the_coefficient_of_restitution() {
        let mass = 0.01;
        for spring in springs() {
            for (e, v) in [
                (0.02, 1.0),
                (0.1, 0.1),
                (0.3, 1.0),
                (0.6, 10.0),
                (0.9, 0.01),
                (1.0, 1.0),
            ] {
                let z = damping_ratio(e);
                let deepest = spring.reach(0.5 * mass * v * v);
                let dt = 1e-5 * deepest / v;
                let (mut x, mut speed) = (0.0_f64, v);
                while x >= 0.0 {
                    let force = spring.force(x) + spring.damping(z, mass, x) * speed;
                    if force < 0.0 {
                        break;
                    }
                    speed -= force / mass * dt;
                    x += speed * dt;
                }
                assert!((-speed / v - e).abs() < 1e-3, "{} for {e}", -speed / v);
            }
        }
        assert!((damping_ratio(0.0) - LARGEST_RATIO).abs() < 1e-9);
    }
}
