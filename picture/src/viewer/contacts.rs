//! Contacts of a block: every pair that has touched in it, how hard it presses in each frame.
//!
//! ```text
//! for each frame   of every pair so far, in their order: its force; the number of new pairs, then of each: rank of sphere 1
//!                  less that of the pair before, partner, form, force. Behind a force that is not none, forms 1 and 2: branch
//! partner          rank of sphere 2, or boundary
//! form             0 sphere, 1 boundary, 2 sphere across a face of the periodic cell
//! force            1 byte: 0 none, else F = F_max 10^(DECADES (c - L)/(L - 1)); its odds depend on that of the frame before
//! branch           3 bytes, 127 times the branch over its length scale; change modulo 256
//! file             see entropy
//! ```

use std::collections::BTreeMap;

use super::entropy::{Bytes, Encoder, Numbers};
use super::recording::{Contact, Moment};
use super::survey::Survey;

/// Powers of ten between the weakest force that is shown and the largest.
pub(super) const DECADES: f64 = 5.0;

const SPHERE: u8 = 0;
const BOUNDARY: u8 = 1;
const ACROSS: u8 = 2;

/// Rank of sphere 1, form, partner, number among those that agree in all this.
type Key = (usize, u8, i64, u32);

#[derive(Clone, Copy)]
struct Known {
    key: Key,
    force: u8,
    branch: [i8; 3],
}

/// The contacts of a block that is being filled.
pub(super) struct Contacts<'a> {
    survey: &'a Survey,
    /// Codes of forces `L`.
    levels: u8,
    /// Every pair so far, as it was last.
    pairs: Vec<Known>,
    encoder: Encoder,
    forces: Bytes,
    branches: Bytes,
    forms: Bytes,
    counts: Numbers,
    ranks: Numbers,
    partners: Numbers,
}

impl<'a> Contacts<'a> {
    pub(super) fn new(survey: &'a Survey, levels: u8) -> Self {
        Self {
            survey,
            levels,
            pairs: Vec::new(),
            encoder: Encoder::new(),
            forces: Bytes::new(64),
            branches: Bytes::new(1),
            forms: Bytes::new(1),
            counts: Numbers::new(),
            ranks: Numbers::new(),
            partners: Numbers::new(),
        }
    }

    /// Adds the contacts of a frame; `ranks` are those of its spheres. Contacts of spheres that are not there are left out.
    pub(super) fn push(&mut self, moment: &Moment, ranks: &[usize]) {
        let mut places = vec![None; self.survey.slots.len()];
        for (k, &rank) in ranks.iter().enumerate() {
            places[rank] = Some(k);
        }
        let mut now: BTreeMap<Key, Known> = BTreeMap::new();
        for contact in &moment.contacts {
            let force = self.force_code(contact.force);
            let Some((rank, form, partner, length)) = self.place(contact, moment, &places) else {
                continue;
            };
            if force == 0 {
                continue;
            }
            let mut key = (rank, form, partner, 0);
            while now.contains_key(&key) {
                key.3 += 1;
            }
            let scaled = contact.branch * (127.0 / length);
            let branch = scaled.map(|v| v.round().clamp(-127.0, 127.0) as i8).into();
            now.insert(key, Known { key, force, branch });
        }
        for k in 0..self.pairs.len() {
            let last = self.pairs[k];
            let none = Known { force: 0, ..last };
            let own = now.remove(&last.key).unwrap_or(none);
            self.put(own, last);
            self.pairs[k] = own;
        }
        self.counts.put(&mut self.encoder, now.len() as i64, 0);
        let mut before = 0;
        for own in now.into_values() {
            let (rank, form, partner, _) = own.key;
            self.ranks.put(&mut self.encoder, rank as i64 - before, 0);
            before = rank as i64;
            self.partners.put(&mut self.encoder, partner, 0);
            self.forms.put(&mut self.encoder, form, 0);
            let none = Known {
                force: 0,
                branch: [0; 3],
                ..own
            };
            self.put(own, none);
            self.pairs.push(own);
        }
    }

    /// Force and branch of a pair that was `last` before.
    fn put(&mut self, own: Known, last: Known) {
        let context = usize::from(last.force >> 2);
        self.forces.put(&mut self.encoder, own.force, context);
        if own.force == 0 || own.key.1 == SPHERE {
            return;
        }
        for (a, b) in own.branch.iter().zip(last.branch) {
            let change = a.wrapping_sub(b) as u8;
            self.branches.put(&mut self.encoder, change, 0);
        }
    }

    /// Rank of sphere 1, form, partner and length scale \[m\] of a contact.
    fn place(
        &self,
        contact: &Contact,
        moment: &Moment,
        places: &[Option<usize>],
    ) -> Option<(usize, u8, i64, f64)> {
        let rank = self.survey.rank(contact.ids[0])?;
        let own = self.survey.slots[rank].radius;
        if contact.with_boundary {
            return Some((rank, BOUNDARY, contact.ids[1], 1.05 * own));
        }
        let other = self.survey.rank(contact.ids[1])?;
        let position = |rank: usize| places[rank].map(|k| moment.spheres.position[k]);
        let between = position(other)? - position(rank)?;
        let sum = own + self.survey.slots[other].radius;
        let across = (between - contact.branch).norm() > 0.1 * sum;
        let form = if across { ACROSS } else { SPHERE };
        Some((rank, form, other as i64, 1.05 * sum))
    }

    fn force_code(&self, force: f64) -> u8 {
        let levels = f64::from(self.levels);
        let decades = (force / self.survey.largest_force).log10();
        let code = levels + (levels - 1.0) * decades / DECADES;
        // Also what is no number: no force.
        if code >= 0.5 { code.round() as u8 } else { 0 }
    }

    pub(super) fn pack(self) -> Vec<u8> {
        let mut out = Vec::new();
        self.encoder.finish(&mut out);
        out
    }
}
