//! Rolling and twisting resistance in lanes: each goes right after its contact.
//!
//! With `s = R_i w_i`, `k = R_i^2/I_i` as in [`local`](super::local) and the levers `a = R/R_A`, `b = R/R_B`, where `R` is the
//! radius of the row, its impulse `p` (a couple over `R`) has
//!
//! ```text
//! u    = a s_A - b s_B + u_0        [m/s]
//! s_A += a k_A dp,  s_B -= b k_B dp
//! w    = a^2 k_A + b^2 k_B          [1/kg], the same along the normal and across it
//! ```
//!
//! or, where the contact has [levers](super::levers), `s_A += a K_A dp` and the bounds of that operator.

use super::batch::{Batch, BatchResidual, Vector};
use super::lanes::{Body, Columns, Lanes, Pack, Real, Sixteen, changed};
use super::levers::{Levers, Shared};
use super::local::{self, Constants, Contacts, Seen, Solved, dot, each, edge, vector};
use crate::Vec3;
use crate::problem::law::onto_cylinder;
use crate::problem::{Law, Row};

/// Resistances of the contacts of a block; zeros where a contact has none.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Resistances<T> {
    numbers: Numbers<T>,
    /// Impulses \[N s\], like those of the block.
    impulse: [Vector<T>; 2],
}

/// What resistances are, without their impulses.
#[derive(Debug, Clone, Copy, Default)]
struct Numbers<T> {
    /// `a` and `b`.
    levers: [Sixteen<T>; 2],
    /// Largest impulse along the normal and across it over the contact's normal one.
    bounds: [Sixteen<T>; 2],
    /// `u_0`.
    prescribed: Vector<T>,
}

/// The resistances of a block as rows, in double precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    /// The row of each, [`NO_ROW`] where there is none.
    rows: Sixteen<u32>,
    numbers: Numbers<f64>,
}

/// Row of a contact without resistance.
const NO_ROW: u32 = u32::MAX;

impl Default for Source {
    fn default() -> Self {
        Self {
            rows: [NO_ROW; _],
            numbers: Numbers::default(),
        }
    }
}

/// What a pass needs of the contacts themselves.
pub(super) struct OfContacts<P> {
    /// Their normals and the normal impulses that press.
    pub(super) n: [P; 3],
    pub(super) load: P,
    /// Squares of the radius over the step, and of the scale of the force residual.
    pub(super) length: P,
    pub(super) scale: P,
}

/// Resistances as a pass holds them.
struct Held<P> {
    levers: [P; 2],
    bounds: [P; 2],
    prescribed: [P; 3],
}

impl<T: Real> Numbers<T> {
    #[inline(always)]
    fn held<L: Lanes<T>>(&self, l: L, pass: usize) -> Held<L::Pack> {
        let [a, b] = &self.levers;
        let [twisting, rolling] = &self.bounds;
        Held {
            levers: [l.load(a, pass), l.load(b, pass)],
            bounds: [l.load(twisting, pass), l.load(rolling, pass)],
            prescribed: vector(l, &self.prescribed, pass),
        }
    }
}

impl<P: Pack> Held<P> {
    /// What they see of bodies A and B of contacts with normals `n`, and with `levers` where they have such.
    #[inline(always)]
    fn see<T: Real, L: Lanes<T, Pack = P>>(
        &self,
        (l, pass): (L, usize),
        n: [P; 3],
        [a, b]: &Columns<P>,
        levers: Option<&Levers<T>>,
    ) -> Seen<P> {
        let [lever_a, lever_b] = self.levers;
        let u = each(|k| {
            self.prescribed[k]
                .plus(lever_a, a[k + 4])
                .less(lever_b, b[k + 4])
        });
        let along = dot(u, n);
        let [w_n, w_t] = match levers {
            None => [(lever_a * lever_a * a[7]).plus(lever_b * lever_b, b[7]); 2],
            Some(levers) => {
                let [twisting, rolling] = &levers.bounds[1];
                [l.load(twisting, pass), l.load(rolling, pass)]
            }
        };
        Seen {
            n,
            u_n: along,
            u_t: each(|k| u[k].less(n[k], along)),
            w_n,
            w_t,
        }
    }

    /// Largest impulses along the normal and across it under the given load.
    #[inline(always)]
    fn limits(&self, load: P) -> [P; 2] {
        [self.bounds[0] * load, self.bounds[1] * load]
    }

    /// The law at impulse `p` under the given load.
    #[inline(always)]
    fn solve(&self, seen: &Seen<P>, p: [P; 3], load: P, (zero, one): (P, P)) -> Solved<P> {
        let [twisting, rolling] = self.limits(load);
        let bounds = ([zero - twisting, twisting], rolling);
        let trial = seen.trial(p, (zero, one));
        let law = onto_cylinder(trial.free, trial.squared, bounds, one);
        trial.held(law)
    }

    /// Gives the bodies the impulses `d`.
    #[inline(always)]
    fn give<T: Real, L: Lanes<T, Pack = P>>(
        &self,
        (l, pass): (L, usize),
        d: [P; 3],
        [a, b]: &mut Columns<P>,
        levers: Option<&Levers<T>>,
    ) {
        let [lever_a, lever_b] = self.levers;
        if let Some(levers) = levers {
            let couples = [d.map(|d| lever_a * d), d.map(|d| lever_b * d)];
            return levers.turn(l, pass, couples, [a, b]);
        }
        let [of_a, of_b] = [lever_a * a[7], lever_b * b[7]];
        for k in 0..3 {
            a[k + 4] = a[k + 4].plus(of_a, d[k]);
            b[k + 4] = b[k + 4].less(of_b, d[k]);
        }
    }
}

impl<T: Real> Resistances<T> {
    /// Solves them for bodies `ab`: as [`Batch::update`] says of contacts.
    #[inline(always)]
    pub(super) fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        contacts: &OfContacts<L::Pack>,
        (ab, levers): (&mut Columns<L::Pack>, Option<&Levers<T>>),
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let held = self.numbers.held(l, pass);
        let seen = held.see((l, pass), contacts.n, ab, levers);
        let old = vector(l, &self.impulse[latest], pass);
        let p = pace.moved(old, vector(l, &self.impulse[1 - latest], pass));
        let ends = (pace.zero, pace.one);
        let solved = held.solve(&seen, p, contacts.load, ends);
        let over = solved.over(seen.n, p, contacts.load, pace.zero);
        let (nn, tt) = solved.squares();
        let (dd, size) = (nn + tt, solved.size(contacts.scale));
        // Both are angles by which it turns while it need not.
        let allowed = pace.slip * contacts.length;
        let settled = (nn * (seen.w_n * seen.w_n)).bits_within(allowed)
            & (tt * (seen.w_t * seen.w_t)).bits_within(allowed)
            & dd.bits_within(pace.force * size);
        let change = pace.correct(l, pass, (p, old, over), &mut self.impulse[1 - latest]);
        held.give((l, pass), change.d, ab, levers);
        (settled, change.along, dd)
    }

    /// Takes them from `source` and from the rows' `impulses` \[N s\], `[C]`.
    pub(super) fn fill(&mut self, source: &Source, impulses: &[Vec3], unit: f64) {
        let mut impulse = Vector::<T>::default();
        for (lane, row) in source.lanes() {
            for (lanes, x) in impulse.iter_mut().zip(&impulses[row]) {
                lanes[lane] = T::of(x * unit);
            }
        }
        self.impulse = [impulse; 2];
        let Numbers {
            levers,
            bounds,
            prescribed,
        } = &source.numbers;
        self.numbers = Numbers {
            levers: [0, 1].map(|k| changed(&levers[k], T::of)),
            bounds: [0, 1].map(|k| changed(&bounds[k], T::of)),
            prescribed: each(|k| changed(&prescribed[k], T::of)),
        };
    }

    /// Impulses \[N s\] after the last sweep, in double precision.
    #[inline(always)]
    pub(super) fn exact(&self, latest: usize, unit: f64) -> Vector<f64> {
        local::exact(&self.impulse[latest], unit)
    }
}

impl Source {
    /// Lanes that have a resistance, and its row.
    pub(super) fn lanes(&self) -> impl Iterator<Item = (usize, usize)> {
        let lanes = self.rows.iter().enumerate();
        let own = lanes.filter(|(_, row)| **row != NO_ROW);
        own.map(|(lane, &row)| (lane, row as usize))
    }

    /// Adds that of lane `lane`: row `k`, whose bodies' spins are scaled by `scales` \[m\].
    pub(super) fn set(&mut self, lane: usize, (k, row): (u32, &Row), scales: [f64; 2]) {
        let Law::Resistance {
            rolling, twisting, ..
        } = row.law
        else {
            return;
        };
        self.rows[lane] = k;
        let numbers = &mut self.numbers;
        for (levers, scale) in numbers.levers.iter_mut().zip(scales) {
            levers[lane] = row.radius / scale;
        }
        for (bounds, bound) in numbers.bounds.iter_mut().zip([twisting, rolling]) {
            bounds[lane] = bound;
        }
        for (lanes, x) in numbers.prescribed.iter_mut().zip(&row.prescribed_velocity) {
            lanes[lane] = *x;
        }
    }

    /// Gives the bodies of `contacts` the impulses `impulse`.
    #[inline(always)]
    pub(super) fn push<L: Lanes<f64>, T: Real>(
        &self,
        l: L,
        (contacts, levers): (&Batch<T>, Option<&Levers<f64>>),
        impulse: &Vector<f64>,
        bodies: &mut [Body<f64>],
    ) {
        let mut shared = Shared::of(contacts, levers, bodies);
        for pass in contacts.passes::<L, f64>() {
            let mut ab = contacts.columns(l, pass, bodies);
            let held = self.numbers.held(l, pass);
            held.give((l, pass), vector(l, impulse, pass), &mut ab, levers);
            contacts.put(l, pass, ab, (bodies, &mut shared));
        }
        if let Some(shared) = shared {
            shared.finish(bodies);
        }
    }

    /// What those of `contacts` are off by, at `impulses` of these and of the resistances.
    #[inline(always)]
    pub(super) fn judge<L: Lanes<f64>, T: Real>(
        &self,
        l: L,
        (contacts, levers): (&Batch<T>, Option<&Levers<f64>>),
        (source, rows): (&local::Source, &Sixteen<u32>),
        impulses: [&Vector<f64>; 2],
        bodies: &[Body<f64>],
    ) -> BatchResidual {
        let mut verdict = BatchResidual::default();
        let (zero, one) = (l.splat(0.0), l.splat(1.0));
        for pass in contacts.passes::<L, f64>() {
            let Contacts {
                n, length, scale, ..
            } = source.contacts(l, rows, pass);
            let p = vector(l, impulses[1], pass);
            let load = dot(vector(l, impulses[0], pass), n).or_larger(zero);
            let held = self.numbers.held(l, pass);
            let ab = contacts.columns(l, pass, bodies);
            let seen = held.see((l, pass), n, &ab, levers);
            let solved = held.solve(&seen, p, load, (zero, one));
            let [along, across, force] = solved.residuals(l, &seen, length, scale);
            let [twisting, rolling] = held.limits(load);
            let twists = edge(l, solved.free.or_larger(zero - solved.free), twisting);
            let rolls = edge(l, solved.squared.root(), rolling);
            let nearest = twists.within(rolls, twists, rolls);
            let [gaps, slips, forces, margins] = &mut verdict;
            l.store(zero, gaps, pass);
            l.store(along.or_larger(across), slips, pass);
            l.store(force, forces, pass);
            l.store(seen.w_n.within(zero, one, nearest), margins, pass);
        }
        verdict
    }
}
