//! What each row is to the blocks.

use super::lanes::LANES;
use super::sharing::Sharing;
use crate::memory;
use crate::parallel::Pool;
use crate::problem::{GROUND, Law, Problem, Row};

/// No row, and no group.
pub(super) const NONE: u32 = u32::MAX;

/// What a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A contact of spheres that move alike in all directions.
    Plain,
    /// A contact of such a sphere, without resistance, on this body, which is [heavy](super::heavy).
    Heavy(u32),
    /// Any other contact: it has [levers](super::levers).
    Levered,
    /// The resistance of this contact, in whose block it is.
    Resistance(u32),
    /// In no block.
    Single,
}

/// Kinds of the rows of a problem.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Kinds {
    /// `[C]`; empty where all are plain.
    kinds: Vec<Kind>,
    /// Row of each contact's resistance, `[C]`, or [`NONE`]; empty where no contact of a block has one.
    resistance: Vec<u32>,
}

impl Kinds {
    /// Takes those of `problem`, whose bodies are spheres where their `radius` is positive, `[N + M]`, and what bodies contacts
    /// may share.
    pub(super) fn find(
        &mut self,
        problem: &Problem,
        radius: &[f64],
        sharing: &mut Sharing,
        pool: &Pool,
    ) {
        self.find_all_but_heavy(problem, radius, pool);
        sharing.find(problem, self.those(Kind::Levered));
        if !sharing.any() {
            return;
        }
        for (k, kind) in self.kinds.iter_mut().enumerate() {
            let [a, b] = problem.rows.bodies(k);
            let resisted = || self.resistance.get(k).is_some_and(|own| *own != NONE);
            if *kind == Kind::Levered
                && radius[a as usize] > 0.0
                && sharing.limit(b) == LANES
                && problem.rows.is_radial(k)[0]
                && !resisted()
            {
                *kind = Kind::Heavy(b);
            }
        }
    }

    /// Likewise, as if no body were heavy.
    fn find_all_but_heavy(&mut self, problem: &Problem, radius: &[f64], pool: &Pool) {
        let rows = &problem.rows;
        self.kinds.clear();
        self.resistance.clear();
        if rows.are_of_spheres() && radius.iter().all(|radius| *radius > 0.0) {
            return;
        }
        let is_sphere = |body: u32| body == GROUND || radius[body as usize] > 0.0;
        let kind_of = |k: usize| match rows.general(k).map(|row| row.law) {
            Some(Law::Resistance { contact, .. }) => Kind::Resistance(contact),
            Some(Law::Bilateral) => Kind::Single,
            _ if rows.is_of_spheres(k) && rows.bodies(k).into_iter().all(is_sphere) => Kind::Plain,
            _ => Kind::Levered,
        };
        memory::resize(&mut self.kinds, rows.len(), Kind::Plain);
        pool.fill(&mut self.kinds[..], kind_of);
        for k in 0..rows.len() {
            let Kind::Resistance(contact) = self.kinds[k] else {
                continue;
            };
            if self.resistance.is_empty() {
                memory::resize(&mut self.resistance, rows.len(), NONE);
            }
            let contact = contact as usize;
            if rows.general(k).is_some_and(Row::is_rigid_resistance) {
                self.resistance[contact] = k as u32;
            } else {
                (self.kinds[k], self.kinds[contact]) = (Kind::Single, Kind::Single);
            }
        }
    }

    /// Whether all are plain.
    pub(super) fn are_plain(&self) -> bool {
        self.kinds.is_empty()
    }

    /// That of row `k`.
    #[inline]
    pub(super) fn of(&self, k: u32) -> Kind {
        self.kinds.get(k as usize).map_or(Kind::Plain, |kind| *kind)
    }

    /// Rows of this kind.
    fn those(&self, kind: Kind) -> impl Iterator<Item = u32> + Clone {
        let kinds = (0..).zip(&self.kinds);
        kinds.filter(move |(_, own)| **own == kind).map(|(k, _)| k)
    }

    /// Rows that are in no block.
    pub(super) fn single(&self) -> impl Iterator<Item = u32> {
        self.those(Kind::Single)
    }

    /// Row of the resistance that the contact of a block has which is row `k`.
    #[inline]
    pub(super) fn resistance(&self, k: u32) -> Option<u32> {
        let own = *self.resistance.get(k as usize)?;
        (own != NONE).then_some(own)
    }
}
