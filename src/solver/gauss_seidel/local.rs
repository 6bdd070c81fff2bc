//! Eight contacts: the update of Gauss-Seidel in lanes.
//!
//! With `s = R w`, a contact of two spheres (or of a sphere and the ground) at normal `n` has
//!
//! ```text
//! u   = v_A - v_B - (s_A + s_B) x n + b             [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                     m: inverse mass [1/kg]
//! s_A -= k_A (n x dp),  s_B -= k_B (n x dp)         k = R^2/I [1/kg]
//! ```
//!
//! so that no radius and no arm is needed, and a body is eight numbers. No two contacts of a block share a moving body: the
//! lanes give the bits that one contact after the other gives. No multiplication is fused with an addition, so that
//! processors with and without wide registers agree in every bit.

use super::block::{Block, Vector, Verdict};
use super::lanes::{Body, Lanes, Pack, Real};

/// [`Pace`] in lanes, squared where squares are compared.
pub(super) struct Constants<P> {
    pub(super) momentum: P,
    pub(super) damping: P,
    pub(super) strict: P,
    pub(super) strict_force: P,
    pub(super) zero: P,
}

/// The bodies of some contacts, by components.
type Bodies<P> = [P; 8];

#[inline(always)]
fn dot<P: Pack>(a: [P; 3], b: [P; 3]) -> P {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<P: Pack>(a: [P; 3], b: [P; 3]) -> [P; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
fn each<P>(f: impl Fn(usize) -> P) -> [P; 3] {
    [f(0), f(1), f(2)]
}

/// What the law makes of some contacts' impulses.
struct Solved<P> {
    /// Normal impulse.
    normal: P,
    /// Square of the tangential impulse before it is brought onto the disc, and the share that stays.
    squared: P,
    share: P,
    /// Change of the normal impulse and of the tangential one.
    d_n: P,
    d_t: [P; 3],
}

impl<P: Pack> Solved<P> {
    /// Square of the new impulse, at least `scale`.
    #[inline(always)]
    fn size(&self, scale: P) -> P {
        (self.normal * self.normal + self.squared * self.share * self.share).or_larger(scale)
    }
}

impl<T: Real> Block<T> {
    #[inline(always)]
    fn vector<L: Lanes<T>>(l: L, x: &Vector<T>, pass: usize) -> [L::Pack; 3] {
        [
            l.load(&x[0], pass),
            l.load(&x[1], pass),
            l.load(&x[2], pass),
        ]
    }

    /// Bodies A and B, counted from `offset`.
    #[inline(always)]
    fn at(&self, offset: u32) -> [[u32; 8]; 2] {
        let mut at = self.bodies;
        for index in at.as_flattened_mut() {
            *index = index.wrapping_sub(offset);
        }
        at
    }

    /// Relative velocity with the bias.
    #[inline(always)]
    fn approach<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        n: [L::Pack; 3],
        [a, b]: [&Bodies<L::Pack>; 2],
    ) -> [L::Pack; 3] {
        let bias = Self::vector(l, &self.bias, pass);
        let turn = cross([a[4] + b[4], a[5] + b[5], a[6] + b[6]], n);
        each(|k| (a[k] - b[k]) - turn[k] + bias[k])
    }

    /// The law at impulse `p` and relative velocity `u`.
    #[inline(always)]
    fn solve<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        n: [L::Pack; 3],
        p: [L::Pack; 3],
        u: [L::Pack; 3],
    ) -> Solved<L::Pack> {
        let (u_n, p_n) = (dot(u, n), dot(p, n));
        let [mass_n, mass_t] = [l.load(&self.mass[0], pass), l.load(&self.mass[1], pass)];
        let normal = (p_n - u_n * mass_n).or_larger(l.splat(T::of(0.0)));
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k] - n[k] * p_n);
        let t = each(|k| p_t[k] - (u[k] - n[k] * u_n) * mass_t);
        let (squared, limit) = (dot(t, t), l.load(&self.friction, pass) * normal);
        let one = l.splat(T::of(1.0));
        let share = squared.within(limit * limit, one, limit.over(squared.root()));
        Solved {
            normal,
            squared,
            share,
            d_n: normal - p_n,
            d_t: each(|k| t[k] * share - p_t[k]),
        }
    }

    /// Gives the bodies the impulses `d`.
    #[inline(always)]
    fn give<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        (n, d): ([L::Pack; 3], [L::Pack; 3]),
        [mut a, mut b]: [Bodies<L::Pack>; 2],
        bodies: &mut [Body<T>],
        at: &[[u32; 8]; 2],
    ) {
        let c = cross(n, d);
        for k in 0..3 {
            a[k] = a[k] + a[3] * d[k];
            b[k] = b[k] - b[3] * d[k];
            a[k + 4] = a[k + 4] - a[7] * c[k];
            b[k + 4] = b[k + 4] - b[7] * c[k];
        }
        l.scatter(a, bodies, &at[0], pass, self.count);
        l.scatter(b, bodies, &at[1], pass, self.count);
    }

    /// Solves the contacts of a pass: whether all were within the tolerances, and their shares of [`Progress`].
    #[inline(always)]
    pub(super) fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        bodies: &mut [Body<T>],
        offset: u32,
        pace: &Constants<L::Pack>,
    ) -> (bool, L::Pack, L::Pack) {
        let at = self.at(offset);
        let n = Self::vector(l, &self.normal, pass);
        let old = Self::vector(l, &self.impulse, pass);
        let before = Self::vector(l, &self.previous, pass);
        let a = l.gather(bodies, &at[0], pass);
        let b = l.gather(bodies, &at[1], pass);
        let u = self.approach(l, pass, n, [&a, &b]);
        let p = each(|k| old[k] + pace.momentum * (old[k] - before[k]));
        let solved = self.solve(l, pass, n, p, u);
        let d = each(|k| n[k] * solved.d_n + solved.d_t[k]);
        // Judged before damping.
        let [gap, slip] = [
            l.load(&self.allowed[0], pass),
            l.load(&self.allowed[1], pass),
        ];
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let dd = nn + tt;
        let size = solved.size(l.load(&self.scale, pass));
        let settled = nn.all_within(pace.strict * gap)
            & tt.all_within(pace.strict * slip)
            & dd.all_within(pace.strict_force * size);
        let d = each(|k| d[k] * pace.damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        for k in 0..3 {
            l.store(old[k], &mut self.previous[k], pass);
            l.store(new[k], &mut self.impulse[k], pass);
        }
        // Open contacts move nothing.
        if !dd.all_within(pace.zero) {
            self.give(l, pass, (n, d), [a, b], bodies, &at);
        }
        (settled, along, dd)
    }
}

impl Block<f64> {
    /// Gives the bodies its impulses.
    #[inline(always)]
    pub(super) fn push<L: Lanes<f64>>(
        &self,
        l: L,
        pass: usize,
        bodies: &mut [Body<f64>],
        offset: u32,
    ) {
        let n = Self::vector(l, &self.normal, pass);
        let p = Self::vector(l, &self.impulse, pass);
        if !dot(p, p).all_within(l.splat(0.0)) {
            let at = self.at(offset);
            let a = l.gather(bodies, &at[0], pass);
            let b = l.gather(bodies, &at[1], pass);
            self.give(l, pass, (n, p), [a, b], bodies, &at);
        }
    }

    /// What its contacts are off by.
    #[inline(always)]
    pub(super) fn judge<L: Lanes<f64>>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<f64>],
        offset: u32,
        verdict: &mut Verdict,
    ) {
        let n = Self::vector(l, &self.normal, pass);
        let p = Self::vector(l, &self.impulse, pass);
        let at = self.at(offset);
        let a = l.gather(bodies, &at[0], pass);
        let b = l.gather(bodies, &at[1], pass);
        let u = self.approach(l, pass, n, [&a, &b]);
        let solved = self.solve(l, pass, n, p, u);
        let (zero, one, tiny) = (l.splat(0.0), l.splat(1.0), l.splat(f64::MIN_POSITIVE));
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let (dd, scale) = (nn + tt, l.load(&self.scale, pass));
        let [gap, slip] = [
            l.load(&self.allowed[0], pass),
            l.load(&self.allowed[1], pass),
        ];
        let size = solved.size(scale);
        // Without any scale an impulse that should vanish is off by all of itself.
        let size = size.within(zero, dd.or_larger(tiny), size);
        // Distances to the edges of the state: of opening, and of slip.
        let (mass, p_n) = (l.load(&self.mass[0], pass), dot(p, n));
        let held = dot(p, p).or_larger(scale).root();
        let to_opening = p_n - dot(u, n) * mass;
        let opens = to_opening
            .or_larger(zero - to_opening)
            .over(held.or_larger(tiny));
        let opens = held.within(zero, one, opens);
        let bound = l.load(&self.friction, pass) * p_n.or_larger(zero);
        let to_slip = solved.squared.root() - bound;
        let slips = to_slip
            .or_larger(zero - to_slip)
            .over(bound.or_larger(tiny));
        let slips = bound.within(zero, one, slips);
        let nearest = opens.within(slips, opens, slips);
        let [gaps, slipped, forces, margins] = verdict;
        l.store(nn.over(gap).root(), gaps, pass);
        l.store(tt.over(slip).root(), slipped, pass);
        l.store(dd.over(size).root(), forces, pass);
        l.store(mass.within(zero, one, nearest), margins, pass);
    }
}
