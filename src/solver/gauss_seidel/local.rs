//! Contacts in lanes: the update of Gauss-Seidel.
//!
//! With `s = R w`, a contact of two spheres (or of a sphere and the ground) at normal `n` has
//!
//! ```text
//! u   = v_A - v_B - (s_A + s_B) x n + b             [m/s]
//! v_A += m_A dp,  v_B -= m_B dp                     m: inverse mass [1/kg]
//! s_A -= k_A (n x dp),  s_B -= k_B (n x dp)         k = R^2/I [1/kg]
//! ```
//!
//! so that no radius and no arm is needed, and a body is eight numbers. Its operator is diagonal, `w_n = m_A + m_B` along the
//! normal and `w_t = w_n + k_A + k_B` across it; dividing by them anew costs less than to fetch their reciprocals. No two contacts of a block share a moving body: the
//! lanes give the bits that one contact after the other gives. No multiplication is fused with an addition, so that
//! processors with and without wide registers agree in every bit.

use super::block::{Block, Pace, STILL, Vector, Verdict};
use super::lanes::{Body, Lanes, Pack, Real};

/// [`Pace`](super::block::Pace) in lanes.
pub(super) struct Constants<P> {
    momentum: P,
    damping: P,
    /// Squares of what gap, slip and force residual may be.
    gap: P,
    slip: P,
    force: P,
    zero: P,
    one: P,
}

impl<P: Pack> Constants<P> {
    pub(super) fn of<T: Real, L: Lanes<T, Pack = P>>(l: L, pace: &Pace) -> Self {
        let number = |x: f64| l.splat(T::of(x));
        let allowed = |tolerance: f64| number((pace.strictness * tolerance).powi(2));
        Self {
            momentum: number(pace.momentum),
            damping: number(pace.damping),
            gap: allowed(pace.tolerance.gap),
            slip: allowed(pace.tolerance.slip),
            force: allowed(pace.tolerance.force),
            zero: number(0.0),
            one: number(1.0),
        }
    }
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
    /// Normal impulse, before and after it is cut at zero.
    free: P,
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

/// What contacts see of their bodies.
struct Seen<P> {
    /// Normals.
    n: [P; 3],
    /// Relative velocity along the normal with the bias, and the one across it.
    u_n: P,
    u_t: [P; 3],
    /// `w_n`, `w_t`.
    w_n: P,
    w_t: P,
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

    /// What the contacts see of bodies `a` and `b`.
    #[inline(always)]
    fn see<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        [a, b]: [&Bodies<L::Pack>; 2],
        drifts: &[Vector<T>],
    ) -> Seen<L::Pack> {
        let n = Self::vector(l, &self.normal, pass);
        let turn = cross([a[4] + b[4], a[5] + b[5], a[6] + b[6]], n);
        let mut u = each(|k| (a[k] - b[k]) - turn[k]);
        if self.drift != STILL {
            let drift = Self::vector(l, &drifts[self.drift as usize], pass);
            u = each(|k| u[k] + drift[k]);
        }
        let along = dot(u, n);
        let w_n = a[3] + b[3];
        Seen {
            n,
            u_n: along + l.load(&self.bias, pass),
            u_t: each(|k| u[k] - n[k] * along),
            w_n,
            w_t: w_n + (a[7] + b[7]),
        }
    }

    /// The law at impulse `p`.
    #[inline(always)]
    fn solve<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        p: [L::Pack; 3],
        seen: &Seen<L::Pack>,
        (zero, one): (L::Pack, L::Pack),
    ) -> Solved<L::Pack> {
        let (n, u_t) = (seen.n, seen.u_t);
        // Where nothing moves the impulse stays.
        let mass = |w: L::Pack| w.within(zero, zero, one.over(w));
        let (mass_n, mass_t) = (mass(seen.w_n), mass(seen.w_t));
        let p_n = dot(p, n);
        let free = p_n - seen.u_n * mass_n;
        let normal = free.or_larger(zero);
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k] - n[k] * p_n);
        let t = each(|k| p_t[k] - u_t[k] * mass_t);
        let (squared, limit) = (dot(t, t), l.load(&self.friction, pass) * normal);
        let share = squared.within(limit * limit, one, limit.over(squared.root()));
        Solved {
            free,
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
    ) {
        let c = cross(n, d);
        for k in 0..3 {
            a[k] = a[k] + a[3] * d[k];
            b[k] = b[k] - b[3] * d[k];
            a[k + 4] = a[k + 4] - a[7] * c[k];
            b[k + 4] = b[k + 4] - b[7] * c[k];
        }
        l.scatter(a, bodies, &self.bodies[0], pass);
        l.scatter(b, bodies, &self.bodies[1], pass);
    }

    /// Solves the contacts of a pass, of which `latest` of the impulses are the last: which were within the tolerances, and
    /// their shares of [`Progress`](super::block::Progress).
    #[inline(always)]
    pub(super) fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        bodies: &mut [Body<T>],
        drifts: &[Vector<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let old = Self::vector(l, &self.impulse[latest], pass);
        let before = Self::vector(l, &self.impulse[1 - latest], pass);
        let a = l.gather(bodies, &self.bodies[0], pass);
        let b = l.gather(bodies, &self.bodies[1], pass);
        let seen = self.see(l, pass, [&a, &b], drifts);
        let p = each(|k| old[k] + pace.momentum * (old[k] - before[k]));
        let solved = self.solve(l, pass, p, &seen, (pace.zero, pace.one));
        let full = each(|k| seen.n[k] * solved.d_n + solved.d_t[k]);
        // Judged before damping.
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let (dd, length) = (nn + tt, l.load(&self.length, pass));
        let size = solved.size(l.load(&self.scale, pass));
        let settled = (nn * (seen.w_n * seen.w_n)).bits_within(pace.gap * length)
            & (tt * (seen.w_t * seen.w_t)).bits_within(pace.slip * length)
            & dd.bits_within(pace.force * size);
        let d = each(|k| full[k] * pace.damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        for (new, axis) in new.into_iter().zip(&mut self.impulse[1 - latest]) {
            l.store(new, axis, pass);
        }
        self.give(l, pass, (seen.n, d), [a, b], bodies);
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
        latest: usize,
    ) {
        let n = Self::vector(l, &self.normal, pass);
        let p = Self::vector(l, &self.impulse[latest], pass);
        let a = l.gather(bodies, &self.bodies[0], pass);
        let b = l.gather(bodies, &self.bodies[1], pass);
        self.give(l, pass, (n, p), [a, b], bodies);
    }

    /// What its contacts are off by.
    #[inline(always)]
    pub(super) fn judge<L: Lanes<f64>>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<f64>],
        drifts: &[Vector<f64>],
        latest: usize,
        verdict: &mut Verdict,
    ) {
        let (zero, one, tiny) = (l.splat(0.0), l.splat(1.0), l.splat(f64::MIN_POSITIVE));
        let p = Self::vector(l, &self.impulse[latest], pass);
        let a = l.gather(bodies, &self.bodies[0], pass);
        let b = l.gather(bodies, &self.bodies[1], pass);
        let seen = self.see(l, pass, [&a, &b], drifts);
        let solved = self.solve(l, pass, p, &seen, (zero, one));
        let (nn, tt) = (solved.d_n * solved.d_n, dot(solved.d_t, solved.d_t));
        let (dd, scale) = (nn + tt, l.load(&self.scale, pass));
        let length = l.load(&self.length, pass);
        let size = solved.size(scale);
        // Without any scale an impulse that should vanish is off by all of itself.
        let size = size.within(zero, dd.or_larger(tiny), size);
        // Distances to the edges of the state: of opening, and of slip.
        let held = dot(p, p).or_larger(scale).root();
        let opens = solved
            .free
            .or_larger(zero - solved.free)
            .over(held.or_larger(tiny));
        let opens = held.within(zero, one, opens);
        let bound = l.load(&self.friction, pass) * dot(p, seen.n).or_larger(zero);
        let to_slip = solved.squared.root() - bound;
        let slips = to_slip
            .or_larger(zero - to_slip)
            .over(bound.or_larger(tiny));
        let slips = bound.within(zero, one, slips);
        let nearest = opens.within(slips, opens, slips);
        let [gaps, slipped, forces, margins] = verdict;
        l.store((nn.over(length)).root() * seen.w_n, gaps, pass);
        l.store((tt.over(length)).root() * seen.w_t, slipped, pass);
        l.store(dd.over(size).root(), forces, pass);
        l.store(seen.w_n.within(zero, one, nearest), margins, pass);
    }
}
