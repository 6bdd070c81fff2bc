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

use super::batch::{Batch, Extra, PLAIN, SweepParams, Vector};
use super::lanes::{Body, Columns, Lanes, Pack, Real, Sixteen, changed};
use crate::Vec3;
use crate::problem::law::onto_cone;
use crate::problem::{BIAS, FRICTION, RADIUS, SCALE, SphereContact};

/// [`SweepParams`] in lanes.
pub(super) struct Constants<P> {
    momentum: P,
    /// What of its excess an impulse gets: less than nothing.
    damping: P,
    /// Squares of what gap, slip and force residual may be.
    gap: P,
    pub(super) slip: P,
    pub(super) force: P,
    pub(super) zero: P,
    pub(super) one: P,
}

/// An impulse's change that has been applied.
pub(super) struct Change<P> {
    /// The change, and the impulse after it.
    pub(super) d: [P; 3],
    pub(super) new: [P; 3],
    /// The change times that since the last sweep.
    pub(super) along: P,
}

/// Contacts that have been solved.
pub(super) struct Update<P> {
    /// Which were within the tolerances.
    pub(super) settled: u16,
    /// Their normals.
    pub(super) n: [P; 3],
    pub(super) change: Change<P>,
    /// Square of the change before damping.
    pub(super) squared: P,
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

    /// Impulses `old`, moved on by momentum.
    #[inline(always)]
    pub(super) fn moved(&self, old: [P; 3], before: [P; 3]) -> [P; 3] {
        each(|k| old[k].plus(self.momentum, old[k] - before[k]))
    }

    /// Writes the impulses `p`, which were `old`, without what they have too much.
    #[inline(always)]
    pub(super) fn correct<T: Real, L: Lanes<T, Pack = P>>(
        &self,
        l: L,
        pass: usize,
        (p, old, over): ([P; 3], [P; 3], [P; 3]),
        impulse: &mut Vector<T>,
    ) -> Change<P> {
        let d = each(|k| over[k] * self.damping);
        let new = each(|k| p[k] + d[k]);
        for (new, axis) in new.into_iter().zip(impulse) {
            l.store(new, axis, pass);
        }
        let along = dot(d, each(|k| new[k] - old[k]));
        Change { d, new, along }
    }
}

#[inline(always)]
pub(super) fn dot<P: Pack>(a: [P; 3], b: [P; 3]) -> P {
    (a[0] * b[0]).plus(a[1], b[1]).plus(a[2], b[2])
}

#[inline(always)]
pub(super) fn cross<P: Pack>(a: [P; 3], b: [P; 3]) -> [P; 3] {
    [
        (a[1] * b[2]).less(a[2], b[1]),
        (a[2] * b[0]).less(a[0], b[2]),
        (a[0] * b[1]).less(a[1], b[0]),
    ]
}

#[inline(always)]
pub(super) fn each<P>(f: impl Fn(usize) -> P) -> [P; 3] {
    [f(0), f(1), f(2)]
}

/// What the law makes of some contacts' impulses.
pub(super) struct Solved<P> {
    /// Normal impulse, before and after it is brought between its bounds.
    pub(super) free: P,
    normal: P,
    /// Square of the tangential impulse before it is brought onto the disc, and the share that stays.
    pub(super) squared: P,
    share: P,
    /// What the impulse has too much along the normal and across it.
    over_n: P,
    over_t: [P; 3],
}

impl<P: Pack> Solved<P> {
    /// Square of the new impulse, at least `scale`.
    #[inline(always)]
    pub(super) fn size(&self, scale: P) -> P {
        (self.normal * self.normal)
            .plus(self.squared * self.share, self.share)
            .or_larger(scale)
    }

    /// What impulses `p` have too much. Where `load` holds nothing they end at zero to the last bit, which rounding would miss.
    #[inline(always)]
    pub(super) fn over(&self, n: [P; 3], p: [P; 3], load: P, zero: P) -> [P; 3] {
        each(|k| {
            let held = self.over_t[k].plus(n[k], self.over_n);
            load.within(zero, p[k], held)
        })
    }

    /// Squares of what the impulses have too much along the normal and across it.
    #[inline(always)]
    pub(super) fn squares(&self) -> (P, P) {
        (self.over_n * self.over_n, dot(self.over_t, self.over_t))
    }

    /// Residuals along the normal and across it, and of force, for squares of the length and of the scale.
    #[inline(always)]
    pub(super) fn residuals<L: Lanes<f64, Pack = P>>(
        &self,
        l: L,
        seen: &Seen<P>,
        length: P,
        scale: P,
    ) -> [P; 3] {
        let (nn, tt) = self.squares();
        let (dd, size) = (nn + tt, self.size(scale));
        // Without any scale an impulse that should vanish is off by all of itself.
        let tiny = l.splat(f64::MIN_POSITIVE);
        let size = size.within(l.splat(0.0), dd.or_larger(tiny), size);
        [
            nn.over(length).root() * seen.w_n,
            tt.over(length).root() * seen.w_t,
            dd.over(size).root(),
        ]
    }
}

/// Distance of `size` to `bound` over `bound`; one where that is zero.
#[inline(always)]
pub(super) fn edge<L: Lanes<f64>>(l: L, size: L::Pack, bound: L::Pack) -> L::Pack {
    let (zero, tiny) = (l.splat(0.0), l.splat(f64::MIN_POSITIVE));
    let off = size - bound;
    let share = off.or_larger(zero - off).over(bound.or_larger(tiny));
    bound.within(zero, l.splat(1.0), share)
}

/// What contacts see of their bodies.
pub(super) struct Seen<P> {
    /// Normals.
    pub(super) n: [P; 3],
    /// Relative velocity along the normal with the bias, and the one across it.
    pub(super) u_n: P,
    pub(super) u_t: [P; 3],
    /// `w_n`, `w_t`.
    pub(super) w_n: P,
    pub(super) w_t: P,
}

#[inline(always)]
pub(super) fn vector<T, L: Lanes<T>>(l: L, x: &Vector<T>, pass: usize) -> [L::Pack; 3] {
    [
        l.load(&x[0], pass),
        l.load(&x[1], pass),
        l.load(&x[2], pass),
    ]
}

/// Impulses that would stop all motion, for the law to bring between its bounds.
pub(super) struct Trial<P> {
    /// Normal and tangential impulse that contacts have, and what they should have.
    p_n: P,
    pub(super) free: P,
    p_t: [P; 3],
    t: [P; 3],
    /// Square of the tangential one that they should have.
    pub(super) squared: P,
}

impl<P: Pack> Trial<P> {
    /// What the law makes of it: the normal impulse, and the share of the tangential one that stays.
    #[inline(always)]
    pub(super) fn held(self, (normal, share): (P, P)) -> Solved<P> {
        Solved {
            free: self.free,
            normal,
            squared: self.squared,
            share,
            over_n: self.p_n - normal,
            over_t: each(|k| self.p_t[k].less(self.t[k], share)),
        }
    }
}

impl<P: Pack> Seen<P> {
    /// The trial at impulse `p`.
    #[inline(always)]
    pub(super) fn trial(&self, p: [P; 3], (zero, one): (P, P)) -> Trial<P> {
        let (n, u_t) = (self.n, self.u_t);
        // Where nothing moves the impulse stays.
        let mass = |w: P| w.within(zero, zero, one.over(w));
        let (mass_n, mass_t) = (mass(self.w_n), mass(self.w_t));
        let p_n = dot(p, n);
        let free = p_n.less(self.u_n, mass_n);
        // Tangential part of p - u/w_t, on the disc. All as differences: what is solved stays to the last bit.
        let p_t = each(|k| p[k].less(n[k], p_n));
        let t = each(|k| p_t[k].less(u_t[k], mass_t));
        Trial {
            p_n,
            free,
            p_t,
            t,
            squared: dot(t, t),
        }
    }
}

impl<T: Real> Batch<T> {
    /// Bodies A and B.
    #[inline(always)]
    pub(super) fn fetch<L: Lanes<R>, R: Real>(
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

    /// Bodies A and B by components.
    #[inline(always)]
    pub(super) fn columns<L: Lanes<R>, R: Real>(
        &self,
        l: L,
        pass: usize,
        bodies: &[Body<R>],
    ) -> Columns<L::Pack> {
        let [a, b] = self.fetch(l, pass, bodies);
        // Written out: a closure that is not inlined does not get the wide registers.
        [l.columns(a), l.columns(b)]
    }

    /// Puts them back.
    #[inline(always)]
    pub(super) fn put_columns<L: Lanes<R>, R: Real>(
        &self,
        l: L,
        pass: usize,
        [a, b]: Columns<L::Pack>,
        bodies: &mut [Body<R>],
    ) {
        l.put(l.rows(a), bodies, &self.bodies[0], pass);
        l.put(l.rows(b), bodies, &self.bodies[1], pass);
    }

    /// Velocities of moving ground, and biases across the normal \[m/s\].
    #[inline(always)]
    pub(super) fn drift<L: Lanes<R>, R>(
        &self,
        l: L,
        pass: usize,
        extras: &[Extra<R>],
    ) -> Option<[L::Pack; 3]> {
        match self.extra {
            PLAIN => None,
            extra => Some(vector(l, &extras[extra as usize].velocity, pass)),
        }
    }

    /// What contacts of normals `n` and the given biases see of what is [`Lanes::between`] their bodies.
    #[inline(always)]
    pub(super) fn see<L: Lanes<R>, R>(
        &self,
        l: L,
        pass: usize,
        between: [L::Pack; 8],
        (n, bias): ([L::Pack; 3], L::Pack),
        extras: &[Extra<R>],
    ) -> Seen<L::Pack> {
        let [x, y, z, w_n, s_x, s_y, s_z, w_s] = between;
        let mut u = [
            x.less(s_y, n[2]).plus(s_z, n[1]),
            y.less(s_z, n[0]).plus(s_x, n[2]),
            z.less(s_x, n[1]).plus(s_y, n[0]),
        ];
        if let Some(drift) = self.drift(l, pass, extras) {
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

    /// Adds to what they see what their springs make of impulses `p`.
    #[inline(always)]
    pub(super) fn yields<L: Lanes<R>, R>(
        &self,
        l: L,
        pass: usize,
        seen: &mut Seen<L::Pack>,
        p: [L::Pack; 3],
        extras: &[Extra<R>],
    ) {
        if self.extra != PLAIN {
            let [c_n, c_t] = &extras[self.extra as usize].compliance;
            let (c_n, c_t, p_n) = (l.load(c_n, pass), l.load(c_t, pass), dot(p, seen.n));
            seen.u_n = seen.u_n.plus(c_n, p_n);
            seen.u_t = each(|k| seen.u_t[k].plus(c_t, p[k].less(seen.n[k], p_n)));
            (seen.w_n, seen.w_t) = (seen.w_n + c_n, seen.w_t + c_t);
        }
    }

    /// Gives the bodies `ab`, as fetched, the impulses `d`.
    #[inline(always)]
    pub(super) fn give<L: Lanes<R>, R>(
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

    /// Solves the contacts of a pass that see `between`.
    #[inline(always)]
    pub(super) fn solve<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        between: [L::Pack; 8],
        extras: &[Extra<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> Update<L::Pack> {
        let own = (vector(l, &self.normal, pass), l.load(&self.bias, pass));
        let seen = self.see(l, pass, between, own, extras);
        self.solve_seen(l, pass, seen, extras, latest, pace)
    }

    /// Solves the contacts of a pass that see this.
    #[inline(always)]
    pub(super) fn solve_seen<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        mut seen: Seen<L::Pack>,
        extras: &[Extra<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> Update<L::Pack> {
        let old = vector(l, &self.impulse[latest], pass);
        let p = pace.moved(old, vector(l, &self.impulse[1 - latest], pass));
        self.yields(l, pass, &mut seen, p, extras);
        let (ends, friction) = ((pace.zero, pace.one), l.load(&self.friction, pass));
        let trial = seen.trial(p, ends);
        let law = onto_cone(trial.free, trial.squared, friction, ends);
        let solved = trial.held(law);
        let over = solved.over(seen.n, p, solved.normal, pace.zero);
        // Judged before damping.
        let (nn, tt) = solved.squares();
        let (dd, length) = (nn + tt, l.load(&self.length, pass));
        let size = solved.size(l.load(&self.scale, pass));
        let settled = (nn * (seen.w_n * seen.w_n)).bits_within(pace.gap * length)
            & (tt * (seen.w_t * seen.w_t)).bits_within(pace.slip * length)
            & dd.bits_within(pace.force * size);
        let change = pace.correct(l, pass, (p, old, over), &mut self.impulse[1 - latest]);
        Update {
            settled,
            n: seen.n,
            change,
            squared: dd,
        }
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
pub(super) struct Contacts<P> {
    pub(super) n: [P; 3],
    pub(super) bias: P,
    pub(super) friction: P,
    /// Squares of the radius over the step and of the scale of the force residual.
    pub(super) length: P,
    pub(super) scale: P,
}

impl Source<'_> {
    /// The contacts that are in `rows`.
    #[inline(always)]
    pub(super) fn contacts<L: Lanes<f64>>(
        &self,
        l: L,
        rows: &Sixteen<u32>,
        pass: usize,
    ) -> Contacts<L::Pack> {
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

/// Impulses that are held times `unit`, in double precision \[N s\].
#[inline(always)]
pub(super) fn exact<T: Real>(impulse: &Vector<T>, unit: f64) -> Vector<f64> {
    let share = 1.0 / unit;
    each(|axis| changed(&impulse[axis], |x| x.exact() * share))
}

impl<T: Real> Batch<T> {
    /// Impulses [N s] after the last sweep, in double precision.
    #[inline(always)]
    pub(super) fn exact(&self, latest: usize, unit: f64) -> Vector<f64> {
        exact(&self.impulse[latest], unit)
    }

    /// That of the contact in `lane`.
    #[inline]
    pub(super) fn exact_of(&self, lane: usize, latest: usize, unit: f64) -> Vec3 {
        let (impulse, share) = (&self.impulse[latest], 1.0 / unit);
        Vec3::from_fn(|axis, _| impulse[axis][lane].exact() * share)
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

    /// Passes over the contacts that it holds.
    #[inline(always)]
    pub(super) fn passes<L: Lanes<R>, R>(&self) -> Range<usize> {
        0..(self.count as usize).div_ceil(L::WIDTH).min(L::PASSES)
    }
}
