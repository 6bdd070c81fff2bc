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
//! lanes give the bits that one contact after the other gives. Products are added by fused operations: what issues fewest
//! instructions is fastest here.

use std::ops::Range;

use super::batch::{Batch, BatchResidual, STILL, SweepParams, Vector};
use super::lanes::{Body, Lanes, Pack, Real, Sixteen, changed};
use crate::problem::law::onto_cone;
use crate::problem::{BIAS, FRICTION, RADIUS, SCALE, SphereContact};

/// [`SweepParams`](super::batch::Pace) in lanes.
pub(super) struct Constants<P> {
    momentum: P,
    /// What of its excess an impulse gets: less than nothing.
    damping: P,
    /// Squares of what gap, slip and force residual may be.
    gap: P,
    slip: P,
    force: P,
    zero: P,
    one: P,
}

impl<P: Pack> Constants<P> {
    pub(super) fn of<T: Real, L: Lanes<T, Pack = P>>(l: L, pace: &SweepParams) -> Self {
        let number = |x: f64| l.splat(T::of(x));
        let allowed = |tolerance: f64| number((pace.strictness * tolerance).powi(2));
        Self {
            momentum: number(pace.momentum),
            damping: number(-pace.damping),
            gap: allowed(pace.tolerance.gap),
            slip: allowed(pace.tolerance.slip),
            force: allowed(pace.tolerance.force),
            zero: number(0.0),
            one: number(1.0),
        }
    }
}

#[inline(always)]
fn dot<P: Pack>(a: [P; 3], b: [P; 3]) -> P {
    (a[0] * b[0]).plus(a[1], b[1]).plus(a[2], b[2])
}

#[inline(always)]
fn cross<P: Pack>(a: [P; 3], b: [P; 3]) -> [P; 3] {
    [
        (a[1] * b[2]).less(a[2], b[1]),
        (a[2] * b[0]).less(a[0], b[2]),
        (a[0] * b[1]).less(a[1], b[0]),
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
    /// What the impulse has too much along the normal and across it.
    over_n: P,
    over_t: [P; 3],
}

impl<P: Pack> Solved<P> {
    /// Square of the new impulse, at least `scale`.
    #[inline(always)]
    fn size(&self, scale: P) -> P {
        (self.normal * self.normal)
            .plus(self.squared * self.share, self.share)
            .or_larger(scale)
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

#[inline(always)]
fn vector<T, L: Lanes<T>>(l: L, x: &Vector<T>, pass: usize) -> [L::Pack; 3] {
    [
        l.load(&x[0], pass),
        l.load(&x[1], pass),
        l.load(&x[2], pass),
    ]
}

impl<P: Pack> Seen<P> {
    /// The law at impulse `p`.
    #[inline(always)]
    fn solve(&self, p: [P; 3], friction: P, (zero, one): (P, P)) -> Solved<P> {
        let (n, u_t) = (self.n, self.u_t);
        // Where nothing moves the impulse stays.
        let mass = |w: P| w.within(zero, zero, one.over(w));
        let (mass_n, mass_t) = (mass(self.w_n), mass(self.w_t));
        let p_n = dot(p, n);
        let free = p_n.less(self.u_n, mass_n);
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k].less(n[k], p_n));
        let t = each(|k| p_t[k].less(u_t[k], mass_t));
        let squared = dot(t, t);
        let (normal, share) = onto_cone(free, squared, friction, (zero, one));
        Solved {
            free,
            normal,
            squared,
            share,
            over_n: p_n - normal,
            over_t: each(|k| p_t[k].less(t[k], share)),
        }
    }
}

impl<T: Real> Batch<T> {
    /// Bodies A and B.
    #[inline(always)]
    fn fetch<L: Lanes<R>, R: Real>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<R>],
    ) -> [[L::Pack; 8]; 2] {
        [
            l.fetch(bodies, &self.bodies[0], pass),
            l.fetch(bodies, &self.bodies[1], pass),
        ]
    }

    /// What contacts of normals `n` and the given biases see of their bodies `ab`, as fetched.
    #[inline(always)]
    fn see<L: Lanes<R>, R>(
        &self,
        l: L,
        pass: usize,
        ab: [[L::Pack; 8]; 2],
        (n, bias): ([L::Pack; 3], L::Pack),
        prescribed_velocities: &[Vector<R>],
    ) -> Seen<L::Pack> {
        let [x, y, z, w_n, s_x, s_y, s_z, w_s] = l.between(ab);
        let mut u = [
            x.less(s_y, n[2]).plus(s_z, n[1]),
            y.less(s_z, n[0]).plus(s_x, n[2]),
            z.less(s_x, n[1]).plus(s_y, n[0]),
        ];
        if self.prescribed != STILL {
            let drift = vector(l, &prescribed_velocities[self.prescribed as usize], pass);
            u = each(|k| u[k] + drift[k]);
        }
        let along = dot(u, n);
        Seen {
            n,
            u_n: along + bias,
            u_t: each(|k| u[k].less(n[k], along)),
            w_n,
            w_t: w_n + w_s,
        }
    }

    /// Gives the bodies `ab`, as fetched, the impulses `d`.
    #[inline(always)]
    fn give<L: Lanes<R>, R>(
        &self,
        l: L,
        pass: usize,
        (n, d): ([L::Pack; 3], [L::Pack; 3]),
        ab: [[L::Pack; 8]; 2],
        bodies: &mut [Body<R>],
    ) {
        let [a, b] = l.pushed(ab, d, cross(n, d));
        l.put(a, bodies, &self.bodies[0], pass);
        l.put(b, bodies, &self.bodies[1], pass);
    }

    /// Solves the contacts of a pass, of which `latest` of the impulses are the last: which were within the tolerances, and
    /// their shares of [`Progress`](super::batch::Progress).
    #[inline(always)]
    pub(super) fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        bodies: &mut [Body<T>],
        prescribed_velocities: &[Vector<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let old = vector(l, &self.impulse[latest], pass);
        let before = vector(l, &self.impulse[1 - latest], pass);
        let ab = self.fetch(l, pass, bodies);
        let along = (vector(l, &self.normal, pass), l.load(&self.bias, pass));
        let seen = self.see(l, pass, ab, along, prescribed_velocities);
        let p = each(|k| old[k].plus(pace.momentum, old[k] - before[k]));
        let friction = l.load(&self.friction, pass);
        let solved = seen.solve(p, friction, (pace.zero, pace.one));
        // What opens ends at zero to the last bit, which rounding would miss.
        let over = each(|k| {
            let closed = solved.over_t[k].plus(seen.n[k], solved.over_n);
            solved.normal.within(pace.zero, p[k], closed)
        });
        // Judged before damping.
        let (nn, tt) = (
            solved.over_n * solved.over_n,
            dot(solved.over_t, solved.over_t),
        );
        let (dd, length) = (nn + tt, l.load(&self.length, pass));
        let size = solved.size(l.load(&self.scale, pass));
        let settled = (nn * (seen.w_n * seen.w_n)).bits_within(pace.gap * length)
            & (tt * (seen.w_t * seen.w_t)).bits_within(pace.slip * length)
            & dd.bits_within(pace.force * size);
        let d = each(|k| over[k] * pace.damping);
        let new = each(|k| p[k] + d[k]);
        let along = dot(d, each(|k| new[k] - old[k]));
        for (new, axis) in new.into_iter().zip(&mut self.impulse[1 - latest]) {
            l.store(new, axis, pass);
        }
        self.give(l, pass, (seen.n, d), ab, bodies);
        (settled, along, dd)
    }
}

/// Where blocks have their contacts from: the numbers of rows, in double precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) numbers: &'a [SphereContact],
    /// Time step \[s\].
    pub(super) step: f64,
    /// Factor on impulses in the blocks.
    pub(super) unit: f64,
}

/// Contacts in double precision.
struct Contacts<P> {
    n: [P; 3],
    bias: P,
    friction: P,
    /// Squares of the radius over the step and of the scale of the force residual.
    length: P,
    scale: P,
}

impl Source<'_> {
    /// The contacts that are in `rows`.
    #[inline(always)]
    fn contacts<L: Lanes<f64>>(&self, l: L, rows: &Sixteen<u32>, pass: usize) -> Contacts<L::Pack> {
        let x = l.columns(l.fetch(self.numbers, rows, pass));
        let length = x[RADIUS] * l.splat(1.0 / self.step);
        Contacts {
            n: [x[0], x[1], x[2]],
            bias: x[BIAS],
            friction: x[FRICTION],
            length: length * length,
            scale: x[SCALE] * x[SCALE],
        }
    }
}

impl<T: Real> Batch<T> {
    /// Impulses [N s] after the last sweep, in double precision.
    #[inline(always)]
    pub(super) fn exact(&self, latest: usize, unit: f64) -> Vector<f64> {
        let share = 1.0 / unit;
        each(|axis| changed(&self.impulse[latest][axis], |x| x.exact() * share))
    }

    /// Takes all but the impulses from `rows`.
    #[inline(always)]
    pub(super) fn fill<L: Lanes<f64>>(&mut self, l: L, source: &Source, rows: &Sixteen<u32>) {
        let mut numbers = [Sixteen::<f64>::default(); 7];
        let unit = l.splat(source.unit * source.unit);
        for pass in 0..L::PASSES {
            let Contacts {
                n: [x, y, z],
                bias,
                friction,
                length,
                scale,
            } = source.contacts(l, rows, pass);
            let found = [x, y, z, bias, friction, length, scale * unit];
            for (number, found) in numbers.iter_mut().zip(found) {
                l.store(found, number, pass);
            }
        }
        let number = |k: usize| changed(&numbers[k], T::of);
        self.normal = each(number);
        (self.bias, self.friction) = (number(3), number(4));
        (self.length, self.scale) = (number(5), number(6));
        self.clear_from(self.count as usize);
    }

    /// Gives the bodies its impulses.
    #[inline(always)]
    pub(super) fn push<L: Lanes<f64>>(
        &self,
        l: L,
        source: &Source,
        rows: &Sixteen<u32>,
        bodies: &mut [Body<f64>],
        latest: usize,
    ) {
        let impulse = self.exact(latest, source.unit);
        for pass in self.passes::<L, f64>() {
            let n = source.contacts(l, rows, pass).n;
            let p = vector(l, &impulse, pass);
            let ab = self.fetch(l, pass, bodies);
            self.give(l, pass, (n, p), ab, bodies);
        }
    }

    /// What its contacts are off by.
    #[inline(always)]
    pub(super) fn judge<L: Lanes<f64>>(
        &self,
        l: L,
        source: &Source,
        rows: &Sixteen<u32>,
        (bodies, prescribed_velocities): (&[Body<f64>], &[Vector<f64>]),
        latest: usize,
    ) -> BatchResidual {
        let mut verdict = BatchResidual::default();
        let (zero, one, tiny) = (l.splat(0.0), l.splat(1.0), l.splat(f64::MIN_POSITIVE));
        let impulse = self.exact(latest, source.unit);
        for pass in self.passes::<L, f64>() {
            let p = vector(l, &impulse, pass);
            let ab = self.fetch(l, pass, bodies);
            let Contacts {
                n,
                bias,
                friction,
                length,
                scale,
            } = source.contacts(l, rows, pass);
            let seen = self.see(l, pass, ab, (n, bias), prescribed_velocities);
            let solved = seen.solve(p, friction, (zero, one));
            let (over_n, over_t) = (solved.over_n, solved.over_t);
            let (nn, tt) = (over_n * over_n, dot(over_t, over_t));
            let dd = nn + tt;
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
            let bound = friction * dot(p, seen.n).or_larger(zero);
            let to_slip = solved.squared.root() - bound;
            let slips = to_slip
                .or_larger(zero - to_slip)
                .over(bound.or_larger(tiny));
            let slips = bound.within(zero, one, slips);
            let nearest = opens.within(slips, opens, slips);
            let [gaps, slipped, forces, margins] = &mut verdict;
            l.store((nn.over(length)).root() * seen.w_n, gaps, pass);
            l.store((tt.over(length)).root() * seen.w_t, slipped, pass);
            l.store(dd.over(size).root(), forces, pass);
            l.store(seen.w_n.within(zero, one, nearest), margins, pass);
        }
        verdict
    }

    /// Passes over the contacts that it holds.
    #[inline(always)]
    pub(super) fn passes<L: Lanes<R>, R>(&self) -> Range<usize> {
        0..(self.count as usize).div_ceil(L::WIDTH).min(L::PASSES)
    }
}
