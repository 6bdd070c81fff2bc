//! How surfaces hold on to each other: cohesion and bonds.
//!
//! A contact that has touched is *attached*: its bodies attract each other along the normal with `f_c` \[N\], whatever it carries,
//! until its gap is wider than `s`. With the force `p = p' - f_c n` on A the cone of a contact is shifted by its pull-off force:
//!
//! ```text
//! p_n >= -f_c,    |p_t| <= mu (p_n + f_c)            p' >= 0, |p'_t| <= mu p'_n
//! ```
//!
//! so that a solver finds an ordinary contact, `p'`; where grains give way `p'` is a spring's, and JKR's a curve (`contact::neck`).
//! Of a surface energy `W` \[J/m^2\] (work of adhesion) and the reduced radius `R*`
//!
//! ```text
//! DMT   f_c = 2 pi W R*        (Derjaguin, Muller and Toporov, J. Colloid Interface Sci. 53, 1975)
//! JKR   f_c = 3/2 pi W R*      (Johnson, Kendall and Roberts, Proc. R. Soc. A 324, 1971)
//! ```
//!
//! A bond is glue of the section `A = pi R_b^2`, `R_b` the smaller radius, between surfaces that touch or are no farther apart than its
//! reach. Between rigid grains it holds without slip nor turn; where they give way it is an elastic beam beside the contact, of the
//! length `L` between the centres (on a boundary: from it),
//!
//! ```text
//! k_n = E A/L,   k_t = 2/5 k_n,   k_b = k_n R_b^2/4,   k_w = k_t R_b^2/2       pull, shear, bending, twisting
//! ```
//!
//! with the given `E`, or `E*` of its materials; with a linear spring `k_n = k` of that. It breaks for good after a step that ends with
//!
//! ```text
//! -p_n + 4 |m_b|/R_b > f_t    or    |p_t| + 2 |m_t|/R_b > f_s + mu max(p_n, 0),     f_t = s_t A, f_s = s_s A
//! ```
//!
//! (Potyondy and Cundall, Int. J. Rock Mech. Min. Sci. 41, 2004, with Mohr and Coulomb's friction), `m_b` and `m_t` being the couples
//! of bending and of twisting.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::elasticity::Elasticity;
use super::neck::Neck;
use super::spring::BondSpring;
use crate::problem::law::SHEAR_RATIO;

/// Attraction of two materials.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Cohesion {
    /// Pull-off force \[N\] of every contact.
    pub force: f64,
    /// Pull-off force over the reduced radius \[N/m\]: of a surface energy.
    pub per_radius: f64,
    /// Gap \[m\] up to which an attached contact attracts; zero: as long as it is closed.
    pub rupture_distance: f64,
    /// Whether elastic grains follow the force curve of Johnson, Kendall and Roberts.
    pub jkr: bool,
}

impl Cohesion {
    /// Of a surface energy `W` \[J/m^2\] by Derjaguin, Muller and Toporov.
    #[must_use]
    pub fn dmt(energy: f64) -> Self {
        Self {
            per_radius: 2.0 * PI * energy,
            ..Self::default()
        }
    }

    /// Of a surface energy `W` \[J/m^2\] by Johnson, Kendall and Roberts.
    #[must_use]
    pub fn jkr(energy: f64) -> Self {
        Self {
            per_radius: 1.5 * PI * energy,
            jkr: true,
            ..Self::default()
        }
    }

    /// The force curve of a contact whose materials give way so.
    #[must_use]
    pub(crate) fn neck(&self, elasticity: &Elasticity, reduced_radius: f64) -> Option<Neck> {
        let energy = self.per_radius / (1.5 * PI);
        let neck = || elasticity.neck(energy, reduced_radius);
        self.jkr.then(neck).flatten()
    }

    /// Pull-off force `f_c` \[N\] of a contact of the reduced radius `R*` \[m\].
    #[must_use]
    pub fn pull_off(&self, reduced_radius: f64) -> f64 {
        self.force + self.per_radius * reduced_radius
    }
}

/// Strengths of the bonds of two materials.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Bond {
    /// Tensile strength `s_t` \[Pa\].
    pub normal_strength: f64,
    /// Shear strength `s_s` \[Pa\].
    pub shear_strength: f64,
    /// Gap \[m\] up to which it joins at the start; zero: what touches.
    pub reach: f64,
    /// Young's modulus `E` \[Pa\] where grains give way; `None`: that of their contact.
    pub young: Option<f64>,
}

/// Strengths \[N\] of one bond, and its radius \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BondStrength {
    pub(crate) tension: f64,
    pub(crate) shear: f64,
    pub(crate) radius: f64,
}

/// What a bond carries: force along the normal, positive where it presses, and across it \[N\], couples of bending and of twisting \[N m\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct BondLoad {
    pub(crate) normal: f64,
    pub(crate) shear: f64,
    pub(crate) bending: f64,
    pub(crate) twisting: f64,
}

/// Share by which rounding may have grains at a bond's reach appear beyond it.
const NEARLY: f64 = 1e-9;

impl Bond {
    /// Whether it joins at the start what has this gap \[m\], where surfaces touch up to that of `closed` \[m\].
    pub(crate) fn joins(&self, gap: f64, closed: f64) -> bool {
        gap <= closed.max(self.reach * (1.0 + NEARLY))
    }

    /// Of a bond whose smaller radius is `radius` \[m\].
    pub(crate) fn strength(&self, radius: f64) -> BondStrength {
        let section = PI * radius * radius;
        BondStrength {
            tension: self.normal_strength * section,
            shear: self.shear_strength * section,
            radius,
        }
    }

    /// Largest elongation \[m\] of a bond of at most this radius \[m\].
    pub(crate) fn stretch(&self, elasticity: &Elasticity, radius: f64) -> f64 {
        let beam = (radius, 2.0 * radius + self.reach);
        let spring = self.spring(elasticity, beam, 0.0);
        self.strength(radius).tension / spring.normal
    }

    /// Its springs between centres that are `length` \[m\] apart, where it carries nothing at the gap `rest` \[m\].
    pub(crate) fn spring(
        &self,
        elasticity: &Elasticity,
        (radius, length): (f64, f64),
        rest: f64,
    ) -> BondSpring {
        let beam = |young: f64| young * PI * radius * radius / length;
        let normal = match (self.young, *elasticity) {
            (Some(young), _) | (None, Elasticity::Hertz { young, .. }) => beam(young),
            (None, Elasticity::Linear { stiffness, .. }) => stiffness,
        };
        BondSpring {
            normal,
            shear: SHEAR_RATIO * normal,
            rest,
            attraction: self.strength(radius).attraction(),
        }
    }
}

impl BondStrength {
    /// Attraction \[N\] whose cone, with a friction of at least 1, holds all that the bond bears.
    pub(crate) fn attraction(&self) -> f64 {
        self.tension + self.shear
    }

    /// Whether it breaks under a load, where its surfaces have the friction `mu`.
    pub(crate) fn breaks(&self, load: &BondLoad, mu: f64) -> bool {
        let tension = 4.0 * load.bending / self.radius - load.normal;
        let shear = load.shear + 2.0 * load.twisting / self.radius;
        tension > self.tension || shear > self.shear + mu * load.normal.max(0.0)
    }
}

/// What holds the surfaces of a contact together in the next step.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub enum Hold {
    /// Nothing.
    #[default]
    Loose,
    /// Cohesion.
    Attached,
    /// A bond.
    Bonded {
        /// Gap \[m\] that it keeps, or at which its spring carries nothing.
        rest: f64,
    },
}

impl Hold {
    /// Whether it is a bond.
    #[must_use]
    pub fn is_bond(&self) -> bool {
        matches!(self, Self::Bonded { .. })
    }

    /// Gap \[m\] that a bond keeps; zero without one.
    pub(crate) fn rest(&self) -> f64 {
        match self {
            Self::Bonded { rest } => *rest,
            Self::Loose | Self::Attached => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The shifted cone holds every load that a bond bears, and the strengths are sharp.
    #[test]
    fn a_bond_breaks_at_its_strengths() {
        let bond = Bond {
            normal_strength: 2e4,
            shear_strength: 5e3,
            reach: 0.0,
            young: None,
        };
        let strength = bond.strength(0.1);
        let load = |normal, shear, bending, twisting| BondLoad {
            normal,
            shear,
            bending,
            twisting,
        };
        let section = 0.01 * PI;
        let mu = 0.4;
        let edges = [
            load(-2e4 * section, 0.0, 0.0, 0.0),
            load(0.0, 5e3 * section, 0.0, 0.0),
            load(1e3, 5e3 * section + mu * 1e3, 0.0, 0.0),
            load(0.0, 0.0, 2e4 * section * 0.1 / 4.0, 0.0),
            load(0.0, 0.0, 0.0, 5e3 * section * 0.1 / 2.0),
        ];
        for edge in edges {
            let scaled = |s: f64| {
                load(
                    if edge.normal > 0.0 {
                        edge.normal
                    } else {
                        s * edge.normal
                    },
                    s * edge.shear,
                    s * edge.bending,
                    s * edge.twisting,
                )
            };
            assert!(!strength.breaks(&scaled(1.0 - 1e-9), mu));
            assert!(strength.breaks(&scaled(1.0 + 1e-9), mu));
            let pressed = edge.normal + strength.attraction();
            assert!(edge.shear <= pressed);
            // Couples are at most the lever R* times the shifted force; R* is at least half the smaller radius.
            assert!(edge.bending.max(edge.twisting) <= 0.05 * pressed);
        }
    }
}
