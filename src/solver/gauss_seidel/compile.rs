//! From rows to blocks: which rows are contacts of spheres, which part of the scene they join, and which go together.

use arrayvec::ArrayVec;

use super::batch::{Batch, Extra, Form, Group, PLAIN};
use super::general_rows::spin_scale;
use super::heavy::Heavy;
use super::kernel::{Kernel, refill};
use super::kinds::{Kind, Kinds, NONE};
use super::lanes::{LANES, Real, Sixteen};
use super::levers::Levers;
use super::resistance::Source;
use super::sharing::Sharing;
use crate::problem::{GROUND, Problem, Rows};
use crate::sorting::counting_sort;

/// Blocks that fill at the same time: a contact joins one that does not have its bodies yet.
const OPEN: usize = 16;

/// Turn of the last group of parts, and that of contacts on heavy bodies.
const LAST: usize = 3;
const ON_HEAVY: usize = 4;

/// Bodies of a group: the first, and one that never moves, counted from the first.
#[derive(Debug, Clone, Copy)]
struct Bodies {
    first: u32,
    still: u32,
}

impl Kernel {
    /// Puts the contacts of blocks in their order: by group, then by heavy body; within it by the place of A. `ends` then has where
    /// those of each group and body end.
    pub(super) fn sort(&mut self, problem: &Problem) {
        let (rows, kinds) = (&problem.rows, &self.kinds);
        let (parts, spheres) = (self.layout.parts(), problem.inverse_mass.len());
        let all = 0..rows.len() as u32;
        if parts == 1 && kinds.are_plain() {
            refill(&mut self.ends, 2, all.end);
            self.order.clear();
            self.order.extend(all);
            return;
        }
        let part = |body: u32| Some(self.layout.seat(body as usize, spheres)?.1);
        let group_of = |k: usize| {
            let [a, b] = rows.bodies(k);
            let other = if b == GROUND { a } else { b };
            let group = match kinds.of(k as u32) {
                Kind::Resistance(_) | Kind::Single => return NONE,
                Kind::Heavy(body) => 2 * parts + body as usize - spheres,
                // Blocks of plain contacts are swept faster without others among them.
                Kind::Plain if parts == 1 => 0,
                Kind::Plain | Kind::Levered => match (part(a), part(other)) {
                    (Some(a), Some(b)) if parts > 1 => group_between(a, b, parts),
                    _ => last_group(parts),
                },
            };
            group as u32
        };
        self.group.resize(rows.len(), NONE);
        let work = |first, groups: &mut [u32]| {
            for (k, group) in (first..).zip(groups) {
                *group = group_of(k);
            }
        };
        self.pool.pieces(&mut self.group[..], work, |(), ()| ());
        let contacts = all.filter(|&k| self.group[k as usize] != NONE);
        let group = |k: &u32| self.group[*k as usize];
        let groups = (group, 2 * parts + problem.operators.len());
        let (ends, order) = (&mut self.ends, &mut self.order);
        if parts == 1 {
            return counting_sort(contacts, groups, ends, order);
        }
        let place = |k: &u32| self.seats.places()[rows.bodies(*k as usize)[0] as usize];
        let places = (place, self.held.len());
        counting_sort(contacts, places, ends, &mut self.by_place);
        counting_sort(self.by_place.iter().copied(), groups, ends, order);
    }

    /// Which rows each of the `blocks` of all groups has.
    pub(super) fn share_out<T: Real>(&mut self, problem: &Problem, blocks: &mut Vec<Batch<T>>) {
        let parts = self.layout.parts();
        self.contents.rows.clear();
        let (mut resisted, mut levered) = (0, 0);
        self.turns.iter_mut().for_each(ArrayVec::clear);
        let mut open = Open {
            used: 0,
            blocks,
            rows: &mut self.contents.rows,
            held: &mut self.held,
            sharing: &self.sharing,
        };
        let mut start = 0;
        for (group, &end) in self.ends[..2 * parts].iter().enumerate() {
            let (turn, low) = turn_of(group, parts);
            let part = |k: usize| self.seats.part(k);
            let bodies = match turn {
                0 => part(low),
                1 | 2 => part(low).start..part(low + 1).end,
                _ => 0..self.seats.count(),
            };
            let rows = &self.order[start..end as usize];
            start = end as usize;
            let (first, first_resisted, first_levered) = (open.used, resisted, levered);
            let range = Bodies {
                first: bodies.start as u32,
                still: (self.seats.still(low) - bodies.start) as u32,
            };
            open.take(problem.rows.all_bodies(), rows, self.seats.places(), range);
            let blocks = first..open.used;
            if !self.kinds.are_plain() {
                for k in blocks.clone() {
                    let block = &mut open.blocks[k];
                    let mut rows = open.rows[k][..block.count as usize].iter();
                    block.resisted = (rows.clone()).any(|&k| self.kinds.resistance(k).is_some());
                    resisted += usize::from(block.resisted);
                    if rows.any(|&k| self.kinds.of(k) == Kind::Levered) {
                        block.levers = levered as u32;
                        levered += 1;
                    }
                }
            }
            // Interiors stay in any case: momentum moves their bodies.
            if turn == 0 || !blocks.is_empty() {
                self.turns[turn].push(Group {
                    blocks,
                    resistances: first_resisted..resisted,
                    bodies,
                    form: match levered > first_levered {
                        true => Form::Levered,
                        false => Form::Spheres,
                    },
                });
            }
        }
        let (first, bodies) = (open.used, 0..self.seats.count());
        let range = Bodies {
            first: 0,
            still: self.seats.still(0) as u32,
        };
        for &end in &self.ends[2 * parts..] {
            let rows = &self.order[start..end as usize];
            start = end as usize;
            open.take(problem.rows.all_bodies(), rows, self.seats.places(), range);
        }
        let on_heavy = first..open.used;
        for (at, k) in on_heavy.clone().enumerate() {
            open.blocks[k].heavy = at as u32;
        }
        let heavy = on_heavy.len();
        if !on_heavy.is_empty() {
            self.turns[ON_HEAVY].push(Group {
                blocks: on_heavy,
                resistances: resisted..resisted,
                bodies,
                form: Form::Heavy,
            });
        }
        let used = open.used;
        blocks.truncate(used);
        let contents = &mut self.contents;
        contents.resistances.resize_with(resisted, Source::default);
        contents.levers.resize_with(levered, Levers::default);
        contents.heavy.resize_with(heavy, Heavy::default);
    }

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
        (block.count, block.resisted) = (0, false);
        (block.levers, block.heavy) = (PLAIN, PLAIN);
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
