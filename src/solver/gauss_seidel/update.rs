//! One pass of a sweep over a block: plain contacts, those with resistances, those of bodies that are no spheres, and those on heavy bodies.

use super::batch::{Batch, Extra};
use super::heavy::{Given, Heavy};
use super::lanes::{Body, Columns, Lanes, Pack, Real, between, pushed};
use super::levers::{Levers, Shared};
use super::local::{Constants, Update, cross, dot, vector};
use super::resistance::{OfContacts, Resistances};

impl<T: Real> Batch<T> {
    /// Solves the contacts of a pass, of which `latest` of the impulses are the last: which were within the tolerances, and
    /// their shares of [`Progress`](super::batch::Progress).
    #[inline(always)]
    pub(super) fn update<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        bodies: &mut [Body<T>],
        extras: &[Extra<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let ab = self.fetch(l, pass, bodies);
        let between = l.between(ab);
        let own = self.solve(l, pass, between, extras, latest, pace);
        self.give(l, pass, (own.n, own.change.d), ab, bodies);
        (own.settled, own.change.along, own.squared)
    }

    /// [`Batch::update`] of contacts with resistances.
    #[inline(always)]
    pub(super) fn update_resisted<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        (bodies, resistances): (&mut [Body<T>], &mut Resistances<T>),
        extras: &[Extra<T>],
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let ab = self.columns(l, pass, bodies);
        let between = between(&ab);
        let own = self.solve(l, pass, between, extras, latest, pace);
        let mut ab = pushed(ab, own.change.d, cross(own.n, own.change.d));
        let moved = (&mut ab, resistances);
        let found = self.resist(l, pass, (&own, None), moved, latest, pace);
        self.put_columns(l, pass, ab, bodies);
        found
    }

    /// [`Batch::update`] of contacts with levers, of which some may have resistances.
    #[inline(always)]
    pub(super) fn update_levered<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        (bodies, shared): (&mut [Body<T>], &mut Option<Shared<T>>),
        (levers, resistances, extras): (&Levers<T>, Option<&mut Resistances<T>>, &[Extra<T>]),
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let mut ab = self.columns(l, pass, bodies);
        let own = (vector(l, &self.normal, pass), l.load(&self.bias, pass));
        let seen = levers.see(l, pass, &ab, own, self.drift(l, pass, extras));
        let own = self.solve_seen(l, pass, seen, extras, latest, pace);
        levers.give(l, pass, own.change.d, &mut ab);
        let found = match resistances {
            None => (own.settled, own.change.along, own.squared),
            Some(resistances) => {
                let moved = (&mut ab, resistances);
                self.resist(l, pass, (&own, Some(levers)), moved, latest, pace)
            }
        };
        self.put(l, pass, ab, (bodies, shared));
        found
    }

    /// [`Batch::update`] of contacts on a heavy body, which gets what is `given` later.
    #[inline(always)]
    pub(super) fn update_on_heavy<L: Lanes<T>>(
        &mut self,
        l: L,
        pass: usize,
        (bodies, given): (&mut [Body<T>], &mut Given<T>),
        (heavy, extras): (&Heavy<T>, &[Extra<T>]),
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let a = self.spheres(l, pass, bodies);
        let own = (vector(l, &self.normal, pass), l.load(&self.bias, pass));
        let seen = heavy.see(l, pass, (&*self, &a), own, (bodies, extras));
        let own = self.solve_seen(l, pass, seen, extras, latest, pace);
        let moved = (bodies, given);
        heavy.give(l, pass, (&*self, a), (own.n, own.change.d), moved);
        (own.settled, own.change.along, own.squared)
    }

    /// Solves the resistances of contacts that have been solved to `own`: what [`Batch::update`] says, of both together.
    #[inline(always)]
    fn resist<L: Lanes<T>>(
        &self,
        l: L,
        pass: usize,
        (own, levers): (&Update<L::Pack>, Option<&Levers<T>>),
        (ab, resistances): (&mut Columns<L::Pack>, &mut Resistances<T>),
        latest: usize,
        pace: &Constants<L::Pack>,
    ) -> (u16, L::Pack, L::Pack) {
        let contacts = OfContacts {
            n: own.n,
            load: dot(own.change.new, own.n).or_larger(pace.zero),
            length: l.load(&self.length, pass),
            scale: l.load(&self.scale, pass),
        };
        let moved = (ab, levers);
        let (turned, along, squared) = resistances.update(l, pass, &contacts, moved, latest, pace);
        (
            own.settled & turned,
            own.change.along + along,
            own.squared + squared,
        )
    }
}
