//! Contacts of a block: those of the frame before that are still there, the new ones, how hard each presses.
//!
//! ```text
//! for each frame   bits: which of the frame before stay, in their order; varint: number of new ones,
//!                  each varint rank of sphere 1 less that of the one before, varint partner, 1 byte form
//! partner          rank of sphere 2, or boundary
//! form             0 sphere, 1 boundary, 2 sphere across a face of the periodic cell
//! force            1 byte: 0 none, else F = F_max 10^(DECADES (c - 255)/254); change modulo 256
//! branch           forms 1 and 2: 3 bytes, 127 times the branch over its length scale; change modulo 256
//! file             three lengths u32, then bits and new ones, forces, branches
//! ```

use std::collections::BTreeMap;

use super::coding::{put_bits, put_varint};
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
    last: Vec<Known>,
    heads: Vec<u8>,
    forces: Vec<u8>,
    branches: Vec<u8>,
}

impl<'a> Contacts<'a> {
    pub(super) fn new(survey: &'a Survey) -> Self {
        Self {
            survey,
            last: Vec::new(),
            heads: Vec::new(),
            forces: Vec::new(),
            branches: Vec::new(),
        }
    }

    /// Adds the contacts of a frame; `ranks` are those of its spheres. Contacts of spheres that are not there are left out.
    pub(super) fn push(&mut self, moment: &Moment, ranks: &[usize]) {
        let mut places = BTreeMap::new();
        for (k, &rank) in ranks.iter().enumerate() {
            places.insert(rank, k);
        }
        let mut now: BTreeMap<Key, Known> = BTreeMap::new();
        for contact in &moment.contacts {
            let Some((rank, form, partner, length)) = self.place(contact, moment, &places) else {
                continue;
            };
            let mut key = (rank, form, partner, 0);
            while now.contains_key(&key) {
                key.3 += 1;
            }
            let scaled = contact.branch * (127.0 / length);
            let known = Known {
                key,
                force: self.force_code(contact.force),
                branch: scaled.map(|v| v.round().clamp(-127.0, 127.0) as i8).into(),
            };
            now.insert(key, known);
        }
        let mut list = Vec::with_capacity(now.len());
        let stays = self.last.iter().map(|known| now.contains_key(&known.key));
        put_bits(&mut self.heads, stays);
        for known in &self.last {
            if let Some(own) = now.remove(&known.key) {
                self.forces.push(own.force.wrapping_sub(known.force));
                if own.key.1 != SPHERE {
                    let changes = own.branch.iter().zip(known.branch);
                    let changes = changes.map(|(a, b)| a.wrapping_sub(b) as u8);
                    self.branches.extend(changes);
                }
                list.push(own);
            }
        }
        put_varint(&mut self.heads, now.len() as i64);
        let mut before = 0;
        for own in now.into_values() {
            let (rank, form, partner, _) = own.key;
            put_varint(&mut self.heads, rank as i64 - before);
            before = rank as i64;
            put_varint(&mut self.heads, partner);
            self.heads.push(form);
            self.forces.push(own.force);
            if form != SPHERE {
                self.branches.extend(own.branch.map(|b| b as u8));
            }
            list.push(own);
        }
        self.last = list;
    }

    /// Rank of sphere 1, form, partner and length scale \[m\] of a contact.
    fn place(
        &self,
        contact: &Contact,
        moment: &Moment,
        places: &BTreeMap<usize, usize>,
    ) -> Option<(usize, u8, i64, f64)> {
        let rank = self.survey.rank(contact.ids[0])?;
        let own = self.survey.slots[rank].radius;
        if contact.with_boundary {
            return Some((rank, BOUNDARY, contact.ids[1], 1.05 * own));
        }
        let other = self.survey.rank(contact.ids[1])?;
        let position = |rank| places.get(rank).map(|&k| moment.spheres.position[k]);
        let between = position(&other)? - position(&rank)?;
        let sum = own + self.survey.slots[other].radius;
        let across = (between - contact.branch).norm() > 0.1 * sum;
        let form = if across { ACROSS } else { SPHERE };
        Some((rank, form, other as i64, 1.05 * sum))
    }

    fn force_code(&self, force: f64) -> u8 {
        let decades = (force / self.survey.largest_force).log10();
        let code = 255.0 + 254.0 * decades / DECADES;
        // Also what is no number: no force.
        if code >= 0.5 { code.round() as u8 } else { 0 }
    }

    pub(super) fn pack(self) -> Vec<u8> {
        let parts = [self.heads, self.forces, self.branches];
        let mut out = Vec::new();
        for part in &parts {
            out.extend((part.len() as u32).to_le_bytes());
        }
        for part in parts {
            out.extend(part);
        }
        out
    }
}
