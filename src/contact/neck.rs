//! The force curve of elastic grains that adhere, by Johnson, Kendall and Roberts (Proc. R. Soc. A 324, 1971).
//!
//! With the contact radius `a` \[m\], the work of adhesion `w` \[J/m^2\], the reduced radius `R*` and modulus `E*` of
//! [`super::elasticity`]:
//!
//! ```text
//! F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3),    d = a^2/R* - sqrt(2 pi w a/E*)        force that presses [N], overlap [m]
//! ```
//!
//! In `t = sqrt(a/a_0)`, where `a_0^3 = 9 pi w R*^2/(2 E*)` is the contact without force, both are polynomials,
//!
//! ```text
//! F + f_c = P (t^3 - 1/2)^2,    d = D (t^4 - 2/3 t),    integral of F = P D (2/5 t^10 - 2/3 t^7 + 1/6 t^4)
//! P = 6 pi w R*,    D = a_0^2/R*,    f_c = P/4 = 3/2 pi w R*
//! ```
//!
//! Where surfaces touch first (`d = 0`) the force jumps from nothing to `-8/9 f_c`. They are pulled with most, `f_c`, at
//! `t^3 = 1/2`; from there on a neck holds them with less and less, until it parts at the *fold* `t^3 = 1/6`, where no contact is
//! any more that is pulled farther: `d_f = -D/2 6^(-1/3)`, with `5/9 f_c`. To make and to part a contact costs `-integral of F` from
//! the fold to `d = 0`, `7.09 (w^5 R*^4/E*^2)^(1/3)` (Thornton and Ning, Powder Technology 99, 1998).

use std::f64::consts::PI;

/// `t^3` at the fold, at the largest tension, and where surfaces touch first.
const FOLD: f64 = 1.0 / 6.0;
const TENSEST: f64 = 0.5;
const FIRST: f64 = 2.0 / 3.0;
/// Most steps of Newton's method: near the fold, where two roots meet, each halves the error.
const STEPS: usize = 60;
/// Least force that presses, over `P`, at which the curve has a tangent to go on with.
const LEAST: f64 = 1e-12;

/// The curve of one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Neck {
    /// `P` \[N\].
    force: f64,
    /// `D` \[m\].
    length: f64,
    /// `a_0/sqrt(R*)` \[m^0.5\].
    root: f64,
}

impl Neck {
    /// Of the work of adhesion \[J/m^2\] > 0, `E*` \[Pa\] and `R*` \[m\].
    pub(crate) fn new(energy: f64, young: f64, reduced_radius: f64) -> Self {
        let cube = 4.5 * PI * energy * reduced_radius * reduced_radius / young;
        let radius = libm::cbrt(cube);
        Self {
            force: 6.0 * PI * energy * reduced_radius,
            length: radius * radius / reduced_radius,
            root: radius / reduced_radius.sqrt(),
        }
    }

    /// Overlap \[m\] at the fold, negative.
    pub(crate) fn fold(&self) -> f64 {
        self.at(libm::cbrt(FOLD))
    }

    /// Overlap \[m\] at which it is pulled with most, negative.
    pub(crate) fn tensest(&self) -> f64 {
        self.at(libm::cbrt(TENSEST))
    }

    /// `F + f_c` \[N\] at an overlap \[m\] from the fold on.
    pub(crate) fn force(&self, overlap: f64) -> f64 {
        let t = self.inverse(overlap);
        let root = t * t * t - TENSEST;
        self.force * (root * root)
    }

    /// `f_c` \[N\].
    pub(crate) fn pull_off(&self) -> f64 {
        0.25 * self.force
    }

    /// Derivative of the force \[N/m\]; negative before the largest tension.
    pub(crate) fn slope(&self, overlap: f64) -> f64 {
        let t = self.inverse(overlap);
        let cube = t * t * t;
        let rise = 4.5 * t * t * (2.0 * cube - 1.0) / (6.0 * cube - 1.0);
        self.force / self.length * rise
    }

    /// A stiffness \[N/m\] by which a force tells how far it is off.
    pub(crate) fn stiffness(&self) -> f64 {
        self.force / self.length
    }

    /// Contact radius over the root of the reduced radius \[m^0.5\]: what Hertz's law has as the root of the overlap.
    pub(crate) fn root(&self, overlap: f64) -> f64 {
        let t = self.inverse(overlap);
        self.root * (t * t)
    }

    /// Overlap \[m\] at `F + f_c` \[N\] >= 0, not before the largest tension.
    pub(crate) fn overlap(&self, force: f64) -> f64 {
        let share = (force / self.force).max(LEAST);
        self.at(libm::cbrt(TENSEST + share.sqrt()))
    }

    /// Energy \[J\] stored at an overlap since the surfaces touched.
    pub(crate) fn stored(&self, overlap: f64) -> f64 {
        let [now, first] = [self.inverse(overlap), libm::cbrt(FIRST)].map(energy);
        self.force * self.length * (now - first)
    }

    /// Energy \[J\] that is stored when it parts: what one making and breaking of the contact costs.
    pub(crate) fn parted(&self) -> f64 {
        let [last, first] = [FOLD, FIRST].map(|cube| energy(libm::cbrt(cube)));
        self.force * self.length * (last - first)
    }

    /// Energy \[J\] of `F + f_c` at an overlap, from the largest tension on; zero before it.
    pub(crate) fn pressed(&self, overlap: f64) -> f64 {
        let t = self.inverse(overlap);
        match t * t * t > TENSEST {
            true => self.force * self.length * pressed(t),
            false => 0.0,
        }
    }

    /// Overlap \[m\] at which [`Self::pressed`] is `energy` \[J\].
    pub(crate) fn reach(&self, energy: f64) -> f64 {
        let wanted = energy / (self.force * self.length);
        let [mut low, mut high] = [libm::cbrt(TENSEST), 2.0];
        while pressed(high) < wanted {
            (low, high) = (high, 2.0 * high);
        }
        // A scale of stiffness needs no more digits.
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            match pressed(middle) < wanted {
                true => low = middle,
                false => high = middle,
            }
        }
        self.at(high)
    }

    fn at(&self, t: f64) -> f64 {
        let square = t * t;
        self.length * (square * square - 2.0 / 3.0 * t)
    }

    /// `t` at an overlap; at the fold before that. Newton's method on a convex function, from its far side.
    fn inverse(&self, overlap: f64) -> f64 {
        let q = overlap / self.length;
        let least = libm::cbrt(FOLD);
        if overlap <= self.fold() {
            return least;
        }
        let mut t = q.max(0.0).sqrt().sqrt() + libm::cbrt(FIRST);
        for _ in 0..STEPS {
            let cube = t * t * t;
            let next = t - (cube * t - 2.0 / 3.0 * t - q) / (4.0 * cube - 2.0 / 3.0);
            if next >= t || next <= least {
                break;
            }
            t = next;
        }
        t
    }
}

/// Integral of `F` over `P D`, from `a = 0` on.
fn energy(t: f64) -> f64 {
    let cube = t * t * t;
    cube * t * ((0.4 * cube - 2.0 / 3.0) * cube + 1.0 / 6.0)
}

/// Integral of `F + f_c` over `P D`, from the largest tension on.
fn pressed(t: f64) -> f64 {
    let whole = |t: f64| energy(t) + 0.25 * (t * t * t * t - 2.0 / 3.0 * t);
    whole(t) - whole(libm::cbrt(TENSEST))
}

#[cfg(test)]
mod tests {
    use super::*;

    const W: f64 = 0.2;
    const YOUNG: f64 = 3e6;
    const RADIUS: f64 = 4e-3;

    fn neck() -> Neck {
        Neck::new(W, YOUNG, RADIUS)
    }

    /// The formulas of the paper at a contact radius: force and overlap.
    fn paper(a: f64) -> [f64; 2] {
        let force =
            4.0 * YOUNG * a.powi(3) / (3.0 * RADIUS) - (8.0 * PI * W * YOUNG * a.powi(3)).sqrt();
        [force, a * a / RADIUS - (2.0 * PI * a * W / YOUNG).sqrt()]
    }

    /// Force, overlap and contact radius are those of the paper from the fold on, and the inverse finds the overlap.
    #[test]
    fn the_curve_is_that_of_the_paper() {
        let (neck, pull_off) = (neck(), 1.5 * PI * W * RADIUS);
        assert!((neck.pull_off() / pull_off - 1.0).abs() < 1e-14);
        let zero = libm::cbrt(4.5 * PI * W * RADIUS * RADIUS / YOUNG);
        for share in [0.31_f64, 0.35, 0.5, 0.62, 0.64, 0.9, 1.0, 1.5, 4.0] {
            let [force, overlap] = paper(share * zero);
            let error = (neck.force(overlap) - pull_off - force) / pull_off;
            assert!(error.abs() < 1e-11, "{share}: {error:e}");
            let radius = neck.root(overlap) * RADIUS.sqrt();
            assert!((radius / (share * zero) - 1.0).abs() < 1e-10, "{share}");
            // From the largest tension on, at a = 0.63 a_0.
            if share > 0.63 {
                let found = neck.overlap(force + pull_off);
                assert!((found - overlap).abs() < 1e-9 * neck.length, "{share}");
            }
        }
    }

    /// The marks of the curve: first touch, largest tension, fold.
    #[test]
    fn the_marks_of_the_curve() {
        let (neck, pull_off) = (neck(), 1.5 * PI * W * RADIUS);
        let at = |overlap: f64| (neck.force(overlap) - pull_off) / pull_off;
        assert!((at(0.0) + 8.0 / 9.0).abs() < 1e-12);
        assert!((at(neck.tensest()) + 1.0).abs() < 1e-12);
        assert!((at(neck.fold()) + 5.0 / 9.0).abs() < 1e-6);
        let fold = -0.5 * neck.length / libm::cbrt(6.0);
        assert!((neck.fold() / fold - 1.0).abs() < 1e-12);
        let cost = libm::cbrt(W.powi(5) * RADIUS.powi(4) / (YOUNG * YOUNG));
        assert!((neck.parted() / cost - 7.09).abs() < 5e-3);
    }

    /// Energies have the force as their derivative, the slope is that of the force, `reach` is an inverse.
    #[test]
    fn energy_force_and_slope_belong_together() {
        let neck = neck();
        for share in [-0.25, -0.2, -0.1, 0.05, 0.5, 3.0] {
            let (d, h) = (share * neck.length, 1e-6 * neck.length);
            let rate = |f: &dyn Fn(f64) -> f64| (f(d + h) - f(d - h)) / (2.0 * h);
            let force = neck.force(d);
            let error = rate(&|d| neck.stored(d)) - (force - neck.pull_off());
            assert!(error.abs() < 1e-7 * neck.pull_off(), "{share}: {error:e}");
            let error = rate(&|d| neck.force(d)) - neck.slope(d);
            assert!(error.abs() < 1e-5 * neck.stiffness(), "{share}: {error:e}");
            if d > neck.tensest() {
                let error = rate(&|d| neck.pressed(d)) - force;
                assert!(error.abs() < 1e-7 * neck.pull_off(), "{share}: {error:e}");
                let found = neck.reach(neck.pressed(d));
                assert!((found - d).abs() < 1e-5 * neck.length);
            }
        }
        let error = neck.stored(neck.fold()) - neck.parted();
        assert!(error.abs() < 1e-9 * neck.parted());
        assert!(neck.stored(0.0).abs() < 1e-12 * neck.parted());
    }

    /// Without adhesion the curve is Hertz's.
    #[test]
    fn a_weak_neck_is_hertz() {
        let weak = Neck::new(1e-9, YOUNG, RADIUS);
        let d = 1e-4_f64;
        let hertz = 4.0 / 3.0 * YOUNG * RADIUS.sqrt() * d.powf(1.5);
        assert!((weak.force(d) / hertz - 1.0).abs() < 1e-3);
        assert!((weak.root(d) / d.sqrt() - 1.0).abs() < 1e-3);
    }
}
