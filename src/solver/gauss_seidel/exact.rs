//! Blocks in double precision, whatever theirs is: their impulses on bodies, and what their contacts are off by.

use super::batch::{Batch, BatchResidual, Extra};
use super::heavy::{Given, Heavy};
use super::lanes::{Body, Lanes, Pack, Real, Sixteen};
use super::levers::{Levers, Shared};
use super::local::{Contacts, Source, dot, edge, vector};
use crate::problem::law::onto_cone;

impl<T: Real> Batch<T> {
    /// Gives the bodies its impulses.
    #[inline(always)]
    pub(super) fn push<L: Lanes<f64>>(
        &self,
        l: L,
        (source, rows): (&Source, &Sixteen<u32>),
        (levers, heavy): (Option<&Levers<f64>>, Option<&Heavy<f64>>),
        bodies: &mut [Body<f64>],
        latest: usize,
    ) {
        let impulse = self.exact(latest, source.unit);
        let mut shared = Shared::of(self, levers, bodies);
        let mut on_heavy = heavy.map(|heavy| (heavy, Given::none()));
        for pass in self.passes::<L, f64>() {
            let p = vector(l, &impulse, pass);
            if let Some(levers) = levers {
                let mut ab = self.columns(l, pass, bodies);
                levers.give(l, pass, p, &mut ab);
                self.put(l, pass, ab, (&mut *bodies, &mut shared));
                continue;
            }
            let n = source.contacts(l, rows, pass).n;
            if let Some((heavy, given)) = &mut on_heavy {
                let a = self.spheres(l, pass, bodies);
                let moved = (&mut *bodies, given);
                heavy.give(l, pass, (self, a), (n, p), moved);
                continue;
            }
            let ab = self.fetch(l, pass, bodies);
            self.give(l, pass, (n, p), ab, bodies);
        }
        if let Some(shared) = shared {
            shared.finish(bodies);
        }
        if let Some((heavy, given)) = on_heavy {
            given.finish(heavy, bodies);
        }
    }

    /// What its contacts are off by.
    #[inline(always)]
    pub(super) fn judge<L: Lanes<f64>>(
        &self,
        l: L,
        (source, rows): (&Source, &Sixteen<u32>),
        how: (Option<&Levers<f64>>, Option<&Heavy<f64>>),
        (bodies, extras): (&[Body<f64>], &[Extra<f64>]),
        latest: usize,
    ) -> BatchResidual {
        let mut verdict = BatchResidual::default();
        let (zero, one, tiny) = (l.splat(0.0), l.splat(1.0), l.splat(f64::MIN_POSITIVE));
        let impulse = self.exact(latest, source.unit);
        for pass in self.passes::<L, f64>() {
            let p = vector(l, &impulse, pass);
            let contacts = source.contacts(l, rows, pass);
            let Contacts {
                n, bias, friction, ..
            } = contacts;
            let mut seen = match how {
                (None, None) => {
                    let between = l.between(self.fetch(l, pass, bodies));
                    self.see(l, pass, between, (n, bias), extras)
                }
                (_, Some(heavy)) => {
                    let a = self.spheres(l, pass, bodies);
                    heavy.see(l, pass, (self, &a), (n, bias), (bodies, extras))
                }
                (Some(levers), None) => {
                    let (drift, ab) = (self.drift(l, pass, extras), self.columns(l, pass, bodies));
                    levers.see(l, pass, &ab, (n, bias), drift)
                }
            };
            self.yields(l, pass, &mut seen, p, extras);
            let trial = seen.trial(p, (zero, one));
            let law = onto_cone(trial.free, trial.squared, friction, (zero, one));
            let solved = trial.held(law);
            let [gap, slip, force] = solved.residuals(l, &seen, contacts.length, contacts.scale);
            // Distances to the edges of the state: of opening, and of slip.
            let held = dot(p, p).or_larger(contacts.scale).root();
            let size = solved.free.or_larger(zero - solved.free);
            let opens = held.within(zero, one, size.over(held.or_larger(tiny)));
            let bound = friction * dot(p, n).or_larger(zero);
            let slips = edge(l, solved.squared.root(), bound);
            let nearest = opens.within(slips, opens, slips);
            let [gaps, slipped, forces, margins] = &mut verdict;
            l.store(gap, gaps, pass);
            l.store(slip, slipped, pass);
            l.store(force, forces, pass);
            l.store(seen.w_n.within(zero, one, nearest), margins, pass);
        }
        verdict
    }
}
