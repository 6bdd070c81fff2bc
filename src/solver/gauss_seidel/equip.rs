//! What some contacts of blocks have: resistances, levers, moving ground and springs.

use super::batch::{Batch, Extra, PLAIN};
use super::general_rows::spin_scale;
use super::kernel::Kernel;
use super::kinds::Kinds;
use super::lanes::Real;
use super::levers::Levers;
use super::resistance::Source;
use crate::problem::{GROUND, Problem, Rows};

impl Kernel {
    /// Resistances and levers of `blocks`.
    pub(super) fn equip<T: Real>(&mut self, problem: &Problem, blocks: &[Batch<T>]) {
        let (kinds, registers) = (&self.kinds, self.exact.registers);
        let length = |i: usize| spin_scale(&self.radius, i);
        let lever = |k: u32| Some(problem.rows.radius(kinds.resistance(k)? as usize));
        let contents = &mut self.contents;
        contents.split.clear();
        contents.heavy_parts.clear();
        let mut sources = contents.resistances.iter_mut();
        for (block, rows) in blocks.iter().zip(&contents.rows) {
            let rows = &rows[..block.count as usize];
            if block.resisted
                && let Some(source) = sources.next()
            {
                *source = resistances(&problem.rows, rows, kinds, length);
            }
            if let Some(heavy) = contents.heavy.get_mut(block.heavy as usize) {
                let parts = heavy.fill((problem, rows), self.seats.places(), length, registers);
                contents.heavy_parts.push(parts);
            }
            let at = block.levers as usize;
            if let Some(levers) = contents.levers.get_mut(at) {
                *levers = Levers::default();
                let directions = levers.fill(problem, rows, lever, length, registers);
                let shared = self.sharing.shared(problem, block, rows);
                levers.shared = shared.map(|body| (body, 1.0));
                if let Some(split) = levers.split(block, &directions, registers) {
                    contents.split.push((at, split));
                }
            }
        }
    }

    /// Lets contacts of `blocks` have moving ground and springs.
    pub(super) fn add_extras<T: Real>(&mut self, rows: &Rows, blocks: &mut [Batch<T>]) {
        self.extras.clear();
        for (block, own) in blocks.iter_mut().zip(&self.contents.rows) {
            block.extra = PLAIN;
            if rows.are_plain() {
                continue;
            }
            for (lane, &k) in own[..block.count as usize].iter().enumerate() {
                let Some(row) = rows.general(k as usize) else {
                    continue;
                };
                if block.extra == PLAIN {
                    block.extra = self.extras.len() as u32;
                    self.extras.push(Extra::default());
                }
                let extra = &mut self.extras[block.extra as usize];
                let velocity = row.prescribed_velocity + row.across();
                for (lanes, x) in extra.velocity.iter_mut().zip(&velocity) {
                    lanes[lane] = *x;
                }
                extra.compliance[0][lane] = row.compliance_n;
                extra.compliance[1][lane] = row.compliance_t;
            }
        }
    }
}

/// Resistances of the contacts that are rows `own`, where spins of bodies are scaled by `length`.
fn resistances(rows: &Rows, own: &[u32], kinds: &Kinds, length: impl Fn(usize) -> f64) -> Source {
    let mut source = Source::default();
    for (lane, &k) in own.iter().enumerate() {
        let Some(k) = kinds.resistance(k) else {
            continue;
        };
        if let Some(row) = rows.general(k as usize) {
            let scales = [row.a, row.b].map(|body| match body {
                GROUND => f64::INFINITY,
                body => length(body as usize),
            });
            source.set(lane, (k, row), scales);
        }
    }
    source
}
