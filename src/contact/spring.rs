//! The spring of one contact that gives way: Hertz's or a linear one, with the neck of a contact that adheres or with a bond beside it.
//!
//! Overlaps `d = -g` are negative where a neck or a bond holds surfaces that are apart. Forces are those that press against the
//! attraction of [`super::cohesion`], `F + f_c`, which are never negative: what a solver finds.

use super::neck::Neck;

/// Most steps of Newton's method.
const STEPS: usize = 60;

/// The spring of one contact.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactSpring {
    /// `k` \[N/m\] or `K` \[N/m^1.5\].
    pub(super) normal: f64,
    /// Shear stiffness \[N/m\], or over the root of the overlap.
    pub(super) shear: f64,
    pub(super) hertz: bool,
    /// What holds it, on the heap: most have nothing.
    held: Option<Box<Held>>,
}

/// What holds the surfaces of a contact together.
#[derive(Debug, Clone, PartialEq)]
struct Held {
    /// The curve that takes the place of Hertz's law while it adheres.
    curve: Option<Neck>,
    /// Whether it does.
    adheres: bool,
    /// What acts beside it.
    bond: Option<BondSpring>,
}

/// The springs of a bond, which pull and press alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BondSpring {
    /// Stiffness \[N/m\] along the normal.
    pub(crate) normal: f64,
    /// Stiffness \[N/m\] across it.
    pub(crate) shear: f64,
    /// Gap \[m\] at which it carries nothing.
    pub(crate) rest: f64,
    /// Attraction \[N\] by which its cone is shifted.
    pub(crate) attraction: f64,
}

impl BondSpring {
    /// Force \[N\] that presses at an overlap \[m\], less the attraction.
    fn force(&self, overlap: f64) -> f64 {
        self.normal * (overlap + self.rest)
    }

    /// Energy \[J\] stored along the normal at an overlap.
    pub(crate) fn energy(&self, overlap: f64) -> f64 {
        0.5 * self.force(overlap) * (overlap + self.rest)
    }

    /// Stiffnesses over the square of the radius `R_b` \[N/m\] against bending, `E I/L`, and twisting, `G J/L`.
    pub(crate) fn turning(&self) -> [f64; 2] {
        [0.25 * self.normal, 0.5 * self.shear]
    }
}

impl ContactSpring {
    /// A linear one of these stiffnesses \[N/m\] along the normal and across it.
    pub(super) fn linear(normal: f64, shear: f64) -> Self {
        Self {
            normal,
            shear,
            hertz: false,
            held: None,
        }
    }

    /// Hertz's and Mindlin's, of `E*` and `G*` \[Pa\] and `R*` \[m\].
    pub(super) fn hertz(young: f64, shear: f64, reduced_radius: f64) -> Self {
        let root = reduced_radius.sqrt();
        Self {
            normal: 4.0 / 3.0 * young * root,
            shear: 8.0 * shear * root,
            hertz: true,
            held: None,
        }
    }

    /// This with the curve that it follows once it adheres, whether it `adheres`, and its bond.
    pub(crate) fn held(
        self,
        (curve, adheres): (Option<Neck>, bool),
        bond: Option<BondSpring>,
    ) -> Self {
        let held = (curve.is_some() || bond.is_some()).then_some(Held {
            curve,
            adheres,
            bond,
        });
        Self {
            held: held.map(Box::new),
            ..self
        }
    }

    /// The curve that it follows once it adheres.
    pub(crate) fn curve(&self) -> Option<&Neck> {
        self.held.as_ref()?.curve.as_ref()
    }

    /// Its neck: that curve, while it adheres.
    pub(crate) fn neck(&self) -> Option<&Neck> {
        self.curve()
            .filter(|_| self.held.as_ref().is_some_and(|held| held.adheres))
    }

    /// Its bond.
    pub(crate) fn bond(&self) -> Option<&BondSpring> {
        self.held.as_ref()?.bond.as_ref()
    }

    /// Overlap \[m\] from which on it acts.
    pub(crate) fn least(&self) -> f64 {
        match (self.neck(), self.bond()) {
            (_, Some(_)) => f64::NEG_INFINITY,
            (Some(neck), None) => neck.fold(),
            (None, None) => 0.0,
        }
    }

    /// Normal force \[N\] at an overlap \[m\] not before [`Self::least`].
    pub(crate) fn force(&self, overlap: f64) -> f64 {
        match (self.neck(), self.bond()) {
            (_, Some(bond)) => {
                self.own_force(overlap.max(0.0)) + bond.force(overlap) + bond.attraction
            }
            (Some(neck), None) => neck.force(overlap),
            (None, None) => self.own_force(overlap),
        }
    }

    /// Its derivative by the overlap \[N/m\].
    pub(crate) fn slope(&self, overlap: f64) -> f64 {
        match (self.neck(), self.bond()) {
            (_, Some(bond)) => match overlap > 0.0 {
                true => self.own_slope(overlap) + bond.normal,
                false => bond.normal,
            },
            (Some(neck), None) => neck.slope(overlap),
            (None, None) => self.own_slope(overlap),
        }
    }

    /// Overlap \[m\] at which the tangent at `overlap` has no force.
    pub(crate) fn intercept(&self, overlap: f64) -> f64 {
        match (self.neck().is_some() || self.bond().is_some(), self.hertz) {
            (true, _) => overlap - self.force(overlap) / self.slope(overlap),
            (false, true) => overlap / 3.0,
            (false, false) => 0.0,
        }
    }

    /// Shear stiffness \[N/m\] at an overlap.
    pub(crate) fn shear(&self, overlap: f64) -> f64 {
        self.own_shear(overlap) + self.bond().map_or(0.0, |bond| bond.shear)
    }

    /// Likewise without that of a bond.
    pub(crate) fn own_shear(&self, overlap: f64) -> f64 {
        match self.bond().is_some() && overlap <= 0.0 {
            true => 0.0,
            false => self.shear * self.root(overlap),
        }
    }

    /// Energy \[J\] of the force that presses, by which [`Self::reach`] tells how far it will be pressed.
    pub(crate) fn energy(&self, overlap: f64) -> f64 {
        match (self.neck(), self.bond()) {
            (_, Some(bond)) => self.own_energy(overlap.max(0.0)) + bond.energy(overlap),
            (Some(neck), None) => neck.pressed(overlap),
            (None, None) => self.own_energy(overlap),
        }
    }

    /// Energy \[J\] that its own law stores at an overlap >= 0, without neck or bond.
    pub(crate) fn own_energy(&self, overlap: f64) -> f64 {
        let share = if self.hertz { 0.4 } else { 0.5 };
        share * self.own_force(overlap) * overlap
    }

    /// Overlap \[m\] at a normal force \[N\] >= 0.
    pub(crate) fn overlap(&self, force: f64) -> f64 {
        match (self.neck(), self.bond()) {
            (_, Some(bond)) => self.overlap_beside(bond, force),
            (Some(neck), None) => neck.overlap(force),
            (None, None) => self.own_overlap(force),
        }
    }

    /// Overlap \[m\] at which an energy \[J\] is stored; with a bond, an upper bound.
    pub(crate) fn reach(&self, energy: f64) -> f64 {
        let own = match (self.neck(), self.hertz) {
            (Some(neck), _) => neck.reach(energy),
            (None, true) => libm::pow(2.5 * energy / self.normal, 0.4),
            (None, false) => (2.0 * energy / self.normal).sqrt(),
        };
        match self.bond() {
            Some(bond) => own.min((2.0 * energy / bond.normal).sqrt() - bond.rest),
            None => own,
        }
    }

    /// Coefficient \[N s/m\] of the damper along the normal of damping ratio `z` at an overlap, for the reduced mass `m` \[kg\].
    pub(crate) fn damping(&self, ratio: f64, mass: f64, overlap: f64) -> f64 {
        let share = if self.hertz { 1.25 } else { 1.0 };
        let own = match self.bond().is_some() && overlap <= 0.0 {
            true => 0.0,
            false => share * self.normal * self.root(overlap),
        };
        let bond = self.bond().map_or(0.0, |bond| bond.normal);
        2.0 * ratio * (mass * (own + bond)).sqrt()
    }

    /// Force \[N\] of its own law at an overlap >= 0, without neck or bond.
    pub(crate) fn own_force(&self, overlap: f64) -> f64 {
        self.normal * overlap * self.own_root(overlap)
    }

    fn own_slope(&self, overlap: f64) -> f64 {
        let exponent = if self.hertz { 1.5 } else { 1.0 };
        exponent * self.normal * self.own_root(overlap)
    }

    fn own_overlap(&self, force: f64) -> f64 {
        let ratio = force / self.normal;
        match self.hertz {
            true => libm::cbrt(ratio * ratio),
            false => ratio,
        }
    }

    /// Overlap at a force that a bond shares: by Newton's method on a convex function, from its far side.
    fn overlap_beside(&self, bond: &BondSpring, force: f64) -> f64 {
        // What is left once the surfaces touch.
        let rest = force - bond.attraction - bond.normal * bond.rest;
        if rest <= 0.0 {
            return rest / bond.normal;
        }
        let mut overlap = self.own_overlap(rest).min(rest / bond.normal);
        for _ in 0..STEPS {
            let off = self.own_force(overlap) + bond.normal * overlap - rest;
            let next = overlap - off / (self.own_slope(overlap) + bond.normal);
            if next >= overlap || next <= 0.0 {
                break;
            }
            overlap = next;
        }
        overlap
    }

    /// Contact radius over the root of the reduced radius.
    fn root(&self, overlap: f64) -> f64 {
        match self.neck() {
            Some(neck) => neck.root(overlap),
            None => self.own_root(overlap),
        }
    }

    fn own_root(&self, overlap: f64) -> f64 {
        if self.hertz { overlap.sqrt() } else { 1.0 }
    }
}
