//! From rows to blocks: which rows are contacts of spheres, which part of the scene they join, and which go together.

use arrayvec::ArrayVec;

use super::batch::{Batch, Extra, Group, PLAIN};
use super::general_rows::spin_scale;
use super::kernel::{ATTACHED, Kernel, NONE, refill};
use super::lanes::{LANES, Real, Sixteen};
use super::levers::Levers;
use super::resistance::Source;
use super::sharing::Sharing;
use crate::problem::{GROUND, Problem, Row, Rows};
use crate::sorting::counting_sort;

/// Blocks that fill at the same time: a contact joins one that does not have its bodies yet.
const OPEN: usize = 16;

/// Turn of the last group.
const LAST: usize = 3;

/// Bodies of a group: the first, and one that never moves, counted from the first.
#[derive(Debug, Clone, Copy)]
struct Bodies {
    first: u32,
    still: u32,
}

impl Kernel {
    /// Puts the rows of sphere contacts in the order of the blocks: by group, within it by the place of A.
    pub(super) fn sort(&mut self, problem: &Problem) {
        let rows = &problem.rows;
        let parts = self.layout.parts();
        if parts == 1 && rows.are_of_spheres() && self.radius.iter().all(|r| *r > 0.0) {
            refill(&mut self.resistance, rows.len(), NONE);
            refill(&mut self.group, rows.len(), 0);
            self.levered.clear();
            self.order.clear();
            self.order.extend(0..rows.len() as u32);
            return;
        }
        let moves_alike = |body: u32| self.radius[body as usize] > 0.0;
        let spheres = problem.inverse_mass.len();
        let part = |body: u32| Some(self.layout.seat(body as usize, spheres)?.1);
        refill(&mut self.resistance, rows.len(), NONE);
        for (k, contact) in rows.resistances() {
            self.resistance[contact] = k as u32;
        }
        let resistance = &self.resistance;
        let group_of = |k: usize, levered: &mut bool| {
            let [a, b] = rows.bodies(k);
            let alike = moves_alike(a) && (b == GROUND || moves_alike(b));
            let is_contact = rows.general(k).is_none_or(Row::is_contact);
            *levered = is_contact && !(alike && rows.is_of_spheres(k));
            let resistance = resistance[k];
            let rigid = resistance == NONE || rows.get(resistance as usize).is_rigid_resistance();
            if !is_contact || !rigid {
                return NONE;
            } else if parts == 1 {
                // Blocks of plain contacts are swept faster without others among them.
                return u32::from(*levered);
            }
            match (part(a), part(if b == GROUND { a } else { b })) {
                (Some(a), Some(b)) => group_between(a, b, parts) as u32,
                _ => last_group(parts) as u32,
            }
        };
        self.levered.resize(rows.len(), false);
        self.group.resize(rows.len(), NONE);
        let all = (&mut self.group[..], &mut self.levered[..]);
        let work = |first, (groups, levered): (&mut [u32], &mut [bool])| {
            for (k, (group, levered)) in (first..).zip(groups.iter_mut().zip(levered)) {
                *group = group_of(k, levered);
            }
        };
        self.pool.pieces(all, work, |(), ()| ());
        for (contact, &k) in self.resistance.iter().enumerate() {
            if k != NONE && self.group[contact] != NONE {
                self.group[k as usize] = ATTACHED;
            }
        }
        self.order.clear();
        let ours = |k: &u32| self.group[*k as usize] < ATTACHED;
        let all = 0..rows.len() as u32;
        if parts == 1 {
            for group in 0..2 {
                let own = |k: &u32| self.group[*k as usize] == group;
                self.order.extend(all.clone().filter(own));
            }
            return;
        }
        let place = |k: &u32| self.place[rows.bodies(*k as usize)[0] as usize];
        counting_sort(
            all.filter(ours),
            (place, self.held.len()),
            &mut self.counts,
            &mut self.by_place,
        );
        let group = |k: &u32| self.group[*k as usize];
        let rows = self.by_place.iter().copied();
        counting_sort(rows, (group, 2 * parts), &mut self.counts, &mut self.order);
    }

    /// Which rows each of the `blocks` of all groups has.
    pub(super) fn share_out<T: Real>(&mut self, problem: &Problem, blocks: &mut Vec<Batch<T>>) {
        let (parts, spheres) = (self.layout.parts(), problem.inverse_mass.len());
        self.contents.rows.clear();
        self.contents.resistances.clear();
        self.contents.split.clear();
        let mut filled = 0;
        self.turns.iter_mut().for_each(ArrayVec::clear);
        let order = std::mem::take(&mut self.order);
        self.sharing.find(problem, &order);
        let mut open = Open {
            used: 0,
            blocks,
            rows: &mut self.contents.rows,
            held: &mut self.held,
            sharing: &self.sharing,
        };
        let mut rest = &order[..];
        for group in 0..2 * parts {
            let (turn, low) = turn_of(group, parts);
            let part = |k: usize| {
                let range = self.layout.part(k, spheres);
                range.start + k..range.end + k + 1
            };
            let bodies = match turn {
                0 => part(low),
                1 | 2 => part(low).start..part(low + 1).end,
                _ => 0..problem.free.len() + parts,
            };
            let own = |k: &&u32| self.group[**k as usize] as usize == group;
            let count = rest.iter().take_while(own).count();
            let (rows, others) = rest.split_at(count);
            rest = others;
            let first = open.used;
            let range = Bodies {
                first: bodies.start as u32,
                still: (part(low).end - 1 - bodies.start) as u32,
            };
            open.take(problem.rows.all_bodies(), rows, &self.place, range);
            let blocks = first..open.used;
            let first = self.contents.resistances.len();
            for block in blocks.clone() {
                let rows = &open.rows[block][..open.blocks[block].count as usize];
                open.blocks[block].resisted =
                    rows.iter().any(|&k| self.resistance[k as usize] != NONE);
                if open.blocks[block].resisted {
                    let source = resistances(&problem.rows, rows, &self.resistance, &self.radius);
                    self.contents.resistances.push(source);
                }
                let levered = |&k: &u32| self.levered.get(k as usize) == Some(&true);
                if rows.iter().any(levered) {
                    open.blocks[block].levers = filled as u32;
                    let length = |i: usize| spin_scale(&self.radius, i);
                    let of = |k: u32| problem.rows.general(self.resistance[k as usize] as usize);
                    let resistance = |k: u32| of(k).copied();
                    let block = &open.blocks[block];
                    let registers = self.exact.registers;
                    let at = filled;
                    filled += 1;
                    match self.contents.levers.get_mut(at) {
                        Some(old) => *old = Levers::default(),
                        None => self.contents.levers.push(Levers::default()),
                    }
                    let levers = &mut self.contents.levers[at];
                    let directions = levers.fill(problem, rows, resistance, length, registers);
                    let shared = self.sharing.shared(problem, block, rows);
                    levers.shared = shared.map(|at| (at, 1.0));
                    if let Some(split) = levers.split(block, &directions, registers) {
                        self.contents.split.push((at, split));
                    }
                }
            }
            let resistances = first..self.contents.resistances.len();
            // Interiors stay in any case: momentum moves their bodies.
            if turn == 0 || !blocks.is_empty() {
                self.turns[turn].push(Group {
                    blocks,
                    resistances,
                    bodies,
                });
            }
        }
        let used = open.used;
        blocks.truncate(used);
        self.contents.levers.truncate(filled);
        self.order = order;
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

/// Blocks that fill.
struct Open<'a, T> {
    /// Blocks in use; beyond are old ones, for their memory.
    used: usize,
    blocks: &'a mut Vec<Batch<T>>,
    rows: &'a mut Vec<Sixteen<u32>>,
    held: &'a mut [u16],
    sharing: &'a Sharing,
}

/// A block that fills.
#[derive(Clone, Copy)]
struct Filling {
    block: usize,
    /// The body that its contacts may share, and how many more of them.
    shared: Option<(u32, usize)>,
}

impl<T: Real> Open<'_, T> {
    /// Blocks of rows `order`: a contact joins the first open block that does not have its bodies yet; when there is none the
    /// oldest is closed.
    fn take(&mut self, who: &[[u32; 2]], order: &[u32], place: &[u32], range: Bodies) {
        let mut open: [Option<Filling>; OPEN] = [None; OPEN];
        let mut oldest = 0;
        for &k in order {
            let place = |body: u32| place.get(body as usize).map(|at| at - range.first);
            let who = who[k as usize];
            let bodies = who.map(|body| place(body).unwrap_or(range.still));
            let held = bodies.map(|at| self.held[at as usize]);
            let mut at = (!(held[0] | held[1])).trailing_zeros() as usize;
            if at >= OPEN {
                at = oldest;
                oldest = (oldest + 1) % OPEN;
                self.close(open[at].take(), at);
            }
            let filling = open[at].get_or_insert_with(|| Filling {
                block: self.new_block(range),
                shared: None,
            });
            for (body, who) in bodies.into_iter().zip(who) {
                let limit = self.sharing.limit(who);
                if limit > 1 && filling.shared.is_none() {
                    filling.shared = Some((body, limit));
                }
                match &mut filling.shared {
                    Some((shared, left)) if *shared == body && *left > 1 => *left -= 1,
                    _ => self.held[body as usize] |= 1 << at,
                }
            }
            let block = filling.block;
            // Any number of contacts may join the one that never moves.
            self.held[range.still as usize] = 0;
            let lane = self.blocks[block].join(bodies);
            self.rows[block][lane] = k;
            if lane + 1 == LANES {
                self.close(open[at].take(), at);
            }
        }
        for (at, filling) in open.into_iter().enumerate() {
            self.close(filling, at);
        }
    }

    /// An empty block, in the memory of an old one if there is one left.
    fn new_block(&mut self, range: Bodies) -> usize {
        let at = self.used;
        self.used += 1;
        if at == self.blocks.len() {
            self.blocks.push(Batch::default());
        }
        self.rows.push(Sixteen::default());
        let block = &mut self.blocks[at];
        (block.count, block.levers) = (0, PLAIN);
        block.bodies = [[range.still; LANES]; 2];
        at
    }

    /// Lets the bodies of the block that was open at `at` join another.
    fn close(&mut self, filling: Option<Filling>, at: usize) {
        let Some(Filling { block, .. }) = filling else {
            return;
        };
        for &body in self.blocks[block].bodies.as_flattened() {
            self.held[body as usize] &= !(1 << at);
        }
    }
}

/// Resistances of the contacts that are rows `own`, where `resistance` says which row each has, and spins are scaled by `radius`.
fn resistances(rows: &Rows, own: &[u32], resistance: &[u32], radius: &[f64]) -> Source {
    let mut source = Source::default();
    for (lane, &k) in own.iter().enumerate() {
        let k = resistance[k as usize];
        if let Some(row) = rows.general(k as usize) {
            let scales = [row.a, row.b].map(|body| match body {
                GROUND => f64::INFINITY,
                body => spin_scale(radius, body as usize),
            });
            source.set(lane, (k, row), scales);
        }
    }
    source
}

/// Group of rows between parts `a` and `b` of `parts`: interiors, then borders of even and of odd parts, then all else.
fn group_between(a: usize, b: usize, parts: usize) -> usize {
    let low = a.min(b);
    match (a.abs_diff(b), low % 2) {
        (0, _) => low,
        (1, 0) => parts + low / 2,
        (1, _) => parts + parts / 2 + low / 2,
        _ => last_group(parts),
    }
}

/// The group that is swept last: its bodies are those of all parts, and those behind them.
fn last_group(parts: usize) -> usize {
    2 * parts - 1
}

/// Turn of a group, and its lower part.
fn turn_of(group: usize, parts: usize) -> (usize, usize) {
    if group < parts {
        (0, group)
    } else if group == last_group(parts) {
        (LAST, 0)
    } else if group < parts + parts / 2 {
        (1, 2 * (group - parts))
    } else {
        (2, 2 * (group - parts - parts / 2) + 1)
    }
}
