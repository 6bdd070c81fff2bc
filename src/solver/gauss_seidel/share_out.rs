//! Which rows go together: by where their bodies are into groups, within each group into blocks.
//!
//! Groups of a turn share no body. Within a group a contact joins the first block that fills and does not have its bodies yet; when
//! there is none the oldest is closed. Groups are shared out side by side: what is in which block depends on the rows and the places
//! of their bodies alone.

use std::mem::take;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use arrayvec::ArrayVec;

use super::batch::{Batch, Form, Group, Grouped, PLAIN};
use super::heavy::Heavy;
use super::kernel::Kernel;
use super::kinds::{Kind, Kinds, NONE};
use super::lanes::{LANES, Real, Sixteen};
use super::levers::Levers;
use super::resistance::Source;
use super::sharing::Sharing;
use crate::memory;
use crate::problem::{GROUND, Problem};
use crate::sorting::counting_sort;

/// Blocks that fill at the same time.
const OPEN: usize = 16;

/// Turn of the last group of parts, and that of contacts on heavy bodies.
const LAST: usize = 3;
const ON_HEAVY: usize = 4;

/// Places of the bodies of a group, and of one that never moves, counted from the first.
struct Bodies {
    range: Range<usize>,
    still: u32,
}

impl Kernel {
    /// Puts the contacts into `blocks`, and these into turns.
    pub(super) fn share_out<T: Real>(&mut self, problem: &Problem, blocks: &mut Vec<Batch<T>>) {
        self.group(problem);
        let (who, places) = (problem.rows.all_bodies(), self.seats.places());
        let mut grouped = take(&mut self.grouped);
        let (size, sorts) = (grouped.order.len() / LANES, self.layout.parts() > 1);
        memory::resize(&mut grouped.slots, grouped.order.len(), 0);
        let (mut order, mut slots) = (&mut grouped.order[..], &mut grouped.slots[..]);
        let mut start = 0;
        let groups = grouped.ends.iter().enumerate().map(|(group, &end)| {
            let count = (end - start) as usize;
            start = end;
            Share {
                rows: cut(&mut order, count),
                slots: cut(&mut slots, count),
                bodies: self.bodies_of(group),
                blocks: 0,
            }
        });
        let mut groups: Vec<Share> = groups.collect();
        self.pool.each(size, &mut groups, |group| {
            if sorts {
                group.sort(who, places);
            }
            group.fill(who, places, &self.sharing);
        });
        let counts: Vec<usize> = groups.iter().map(|group| group.blocks).collect();
        let (count, rows) = (counts.iter().sum(), &mut self.contents.rows);
        memory::make_room(blocks, count);
        blocks.resize_with(count, Batch::default);
        memory::resize(rows, count, Sixteen::default());
        let lanes = &mut grouped.lanes;
        lanes.clear();
        memory::make_room(lanes, who.len());
        lanes.resize_with(who.len(), || AtomicU32::new(NONE));
        let (mut own, mut rows, mut first) = (&mut blocks[..], &mut rows[..], 0);
        let groups = groups.into_iter().map(|group| {
            let (count, before) = (group.blocks, first);
            first += count;
            (group, before, cut(&mut own, count), cut(&mut rows, count))
        });
        let mut groups: Vec<_> = groups.collect();
        self.pool
            .each(size, &mut groups, |(group, first, blocks, rows)| {
                group.write((who, places), &self.kinds, blocks, rows);
                group.tell((*first * LANES) as u32, lanes);
            });
        self.line_up(blocks, &counts);
        self.grouped = grouped;
    }

    /// Puts the contacts of blocks in the order of their groups: of parts and borders, then on heavy bodies.
    fn group(&mut self, problem: &Problem) {
        let (rows, kinds) = (&problem.rows, &self.kinds);
        let (parts, spheres) = (self.layout.parts(), problem.inverse_mass.len());
        let all = 0..rows.len() as u32;
        let Grouped {
            group, order, ends, ..
        } = &mut self.grouped;
        if parts == 1 && kinds.are_plain() {
            ends.clear();
            ends.extend([all.end; 2]);
            order.clear();
            memory::make_room(order, rows.len());
            order.extend(all);
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
        memory::resize(group, rows.len(), NONE);
        self.pool.fill(&mut group[..], group_of);
        let contacts = all.filter(|&k| group[k as usize] != NONE);
        let groups = 2 * parts + problem.operators.len();
        counting_sort(
            contacts,
            (|k: &u32| group[*k as usize], groups),
            ends,
            order,
        );
    }

    /// Bodies of a group.
    fn bodies_of(&self, group: usize) -> Bodies {
        let (turn, low) = turn_of(group, self.layout.parts());
        let part = |k: usize| self.seats.part(k);
        let range = match turn {
            0 => part(low),
            1 | 2 => part(low).start..part(low + 1).end,
            _ => 0..self.seats.count(),
        };
        let still = (self.seats.still(low) - range.start) as u32;
        Bodies { range, still }
    }

    /// Puts the groups, of so many blocks each, into turns, and numbers what some of the blocks have.
    fn line_up<T: Real>(&mut self, blocks: &mut [Batch<T>], counts: &[usize]) {
        let parts = self.layout.parts();
        self.turns.iter_mut().for_each(ArrayVec::clear);
        let (mut first, mut resisted, mut levered) = (0, 0, 0);
        for (group, count) in counts[..2 * parts].iter().enumerate() {
            let own = first..first + count;
            first = own.end;
            let before = (resisted, levered);
            for block in &mut blocks[own.clone()] {
                resisted += usize::from(block.resisted);
                if block.levers != PLAIN {
                    block.levers = levered as u32;
                    levered += 1;
                }
            }
            let (turn, _) = turn_of(group, parts);
            // Interiors stay in any case: momentum moves their bodies.
            if turn == 0 || !own.is_empty() {
                self.turns[turn].push(Group {
                    blocks: own,
                    resistances: before.0..resisted,
                    bodies: self.bodies_of(group).range,
                    form: match levered > before.1 {
                        true => Form::Levered,
                        false => Form::Spheres,
                    },
                });
            }
        }
        let on_heavy = &mut blocks[first..];
        for (at, block) in on_heavy.iter_mut().enumerate() {
            block.heavy = at as u32;
        }
        let heavy = on_heavy.len();
        if heavy > 0 {
            self.turns[ON_HEAVY].push(Group {
                blocks: first..first + heavy,
                resistances: resisted..resisted,
                bodies: 0..self.seats.count(),
                form: Form::Heavy,
            });
        }
        let contents = &mut self.contents;
        contents.resistances.resize_with(resisted, Source::default);
        contents.levers.resize_with(levered, Levers::default);
        contents.heavy.resize_with(heavy, Heavy::default);
    }
}

/// A group that is shared out among blocks.
struct Share<'a> {
    rows: &'a mut [u32],
    /// Where each of the rows is among the lanes of the blocks.
    slots: &'a mut [u32],
    bodies: Bodies,
    /// How many blocks there are.
    blocks: usize,
}

/// A block that fills.
#[derive(Clone, Copy)]
struct Filling {
    block: usize,
    /// Its bodies so far.
    count: usize,
    bodies: [[u32; 2]; LANES],
    /// The body that its contacts may share, and how many more of them.
    shared: Option<(u32, usize)>,
}

impl Bodies {
    /// Places in the group of the bodies `who`.
    #[inline]
    fn of(&self, who: [u32; 2], places: &[u32]) -> [u32; 2] {
        let first = self.range.start as u32;
        let place = |body: u32| places.get(body as usize).map(|at| at - first);
        who.map(|body| place(body).unwrap_or(self.still))
    }
}

impl Share<'_> {
    /// Puts the rows in the order of the places of their bodies A, bodies of all rows being those of `who`.
    fn sort(&mut self, who: &[[u32; 2]], places: &[u32]) {
        if self.rows.is_empty() {
            return;
        }
        let first = self.bodies.range.start as u32;
        let place = |k: &u32| places[who[*k as usize][0] as usize] - first;
        let (mut ends, mut sorted) = (Vec::new(), Vec::new());
        let places = (place, self.bodies.range.len());
        counting_sort(self.rows.iter().copied(), places, &mut ends, &mut sorted);
        self.rows.copy_from_slice(&sorted);
    }

    /// Finds the slots.
    fn fill(&mut self, who: &[[u32; 2]], places: &[u32], sharing: &Sharing) {
        if self.rows.is_empty() {
            return;
        }
        // For each body, the filling blocks that hold it, as bits.
        let mut held = vec![0_u16; self.bodies.range.len()];
        let mut open: [Option<Filling>; OPEN] = [None; OPEN];
        let mut oldest = 0;
        for (k, slot) in self.rows.iter().zip(&mut *self.slots) {
            let who = who[*k as usize];
            let bodies = self.bodies.of(who, places);
            let [a, b] = bodies.map(|at| held[at as usize]);
            let mut at = (!(a | b)).trailing_zeros() as usize;
            if at >= OPEN {
                at = oldest;
                oldest = (oldest + 1) % OPEN;
                close(&mut open, at, &mut held);
            }
            let filling = open[at].get_or_insert_with(|| {
                self.blocks += 1;
                Filling {
                    block: self.blocks - 1,
                    count: 0,
                    bodies: [[0; 2]; LANES],
                    shared: None,
                }
            });
            for (body, who) in bodies.into_iter().zip(who) {
                let limit = sharing.limit(who);
                if limit > 1 && filling.shared.is_none() {
                    filling.shared = Some((body, limit));
                }
                match &mut filling.shared {
                    Some((shared, left)) if *shared == body && *left > 1 => *left -= 1,
                    _ => held[body as usize] |= 1 << at,
                }
            }
            // Any number of contacts may join the one that never moves.
            held[self.bodies.still as usize] = 0;
            *slot = (filling.block * LANES + filling.count) as u32;
            filling.bodies[filling.count] = bodies;
            filling.count += 1;
            if filling.count == LANES {
                close(&mut open, at, &mut held);
            }
        }
    }

    /// Writes who is in `blocks`, and which `rows` each has.
    fn write<T: Real>(
        &self,
        (who, places): (&[[u32; 2]], &[u32]),
        kinds: &Kinds,
        blocks: &mut [Batch<T>],
        rows: &mut [Sixteen<u32>],
    ) {
        // Lanes without a contact have any.
        rows.fill(Sixteen::default());
        for block in &mut *blocks {
            (block.count, block.resisted) = (0, false);
            (block.levers, block.heavy) = (PLAIN, PLAIN);
            block.bodies = [[self.bodies.still; LANES]; 2];
        }
        for (&k, &slot) in self.rows.iter().zip(&*self.slots) {
            let (at, lane) = (slot as usize / LANES, slot as usize % LANES);
            let block = &mut blocks[at];
            rows[at][lane] = k;
            block.count += 1;
            let bodies = self.bodies.of(who[k as usize], places);
            for (lanes, body) in block.bodies.iter_mut().zip(bodies) {
                lanes[lane] = body;
            }
            block.resisted |= kinds.resistance(k).is_some();
            if kinds.of(k) == Kind::Levered {
                block.levers = 0;
            }
        }
    }

    /// Tells in which of all `lanes` the rows are, of which those of the group begin at `first`.
    fn tell(&self, first: u32, lanes: &[AtomicU32]) {
        for (&k, &slot) in self.rows.iter().zip(&*self.slots) {
            lanes[k as usize].store(first + slot, Ordering::Relaxed);
        }
    }
}

/// Lets the bodies of the block that fills at `at` join another.
fn close(open: &mut [Option<Filling>; OPEN], at: usize, held: &mut [u16]) {
    let Some(filling) = open[at].take() else {
        return;
    };
    for &body in filling.bodies[..filling.count].as_flattened() {
        held[body as usize] &= !(1 << at);
    }
}

/// The first `count` of `items`, which then are the others.
fn cut<'a, X>(items: &mut &'a mut [X], count: usize) -> &'a mut [X] {
    let (first, others) = take(items).split_at_mut(count);
    *items = others;
    first
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

/// The group of parts that is swept last: its bodies are those of all parts, and those behind them.
fn last_group(parts: usize) -> usize {
    2 * parts - 1
}

/// Turn of a group, and its lower part.
fn turn_of(group: usize, parts: usize) -> (usize, usize) {
    if group < parts {
        (0, group)
    } else if group == last_group(parts) {
        (LAST, 0)
    } else if group > last_group(parts) {
        (ON_HEAVY, 0)
    } else if group < parts + parts / 2 {
        (1, 2 * (group - parts))
    } else {
        (2, 2 * (group - parts - parts / 2) + 1)
    }
}
