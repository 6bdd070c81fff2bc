//! From rows to blocks: which rows are contacts of spheres, which part of the scene they join, and which go together.

use arrayvec::ArrayVec;

use super::block::{Block, STILL};
use super::kernel::{Kernel, NONE, refill};
use super::lanes::{LANES, Sixteen};
use super::layout::first_places;
use super::sheet::Group;
use crate::Vec3;
use crate::problem::{GROUND, Law, Problem, Row};

/// Blocks that fill at the same time: a contact joins one in which its bodies are not yet met.
const OPEN: usize = 16;
/// Relative rounding within which a contact's arm is its body's radius.
const SAME: f64 = 1e-12;

/// Bodies of a group: the first, and one that never moves, counted from the first.
#[derive(Debug, Clone, Copy)]
struct Bodies {
    first: u32,
    still: u32,
}

impl Kernel {
    /// Puts the rows of sphere contacts in the order of the blocks: by group, within it by the place of A.
    pub(super) fn sort(&mut self, problem: &Problem) {
        let parts = self.layout.parts();
        self.group.clear();
        for (k, row) in problem.rows.iter().enumerate() {
            let group = if !self.resisted[k] && self.is_sphere_contact(row) {
                let part = |body: u32| self.layout.place(body as usize).1;
                let a = part(row.a);
                let b = if row.b == GROUND { a } else { part(row.b) };
                group_of(a, b, parts) as u32
            } else {
                NONE
            };
            self.group.push(group);
        }
        self.order.clear();
        let ours = |k: &u32| self.group[*k as usize] != NONE;
        let rows = 0..problem.rows.len() as u32;
        if parts == 1 {
            self.order.extend(rows.filter(ours));
            return;
        }
        let place = |k: u32| self.place[problem.rows[k as usize].a as usize];
        counting_sort(
            rows.filter(ours),
            place,
            &mut self.counts,
            &mut self.by_place,
        );
        let group = |k: u32| self.group[k as usize];
        let rows = self.by_place.iter().copied();
        counting_sort(rows, group, &mut self.counts, &mut self.order);
    }

    /// Blocks of all groups.
    pub(super) fn fill_groups(&mut self, problem: &Problem, impulses: &[Vec3]) {
        let (parts, spheres) = (self.layout.parts(), problem.inverse_mass.len());
        self.used = 0;
        self.exact.drifts.clear();
        self.turns.iter_mut().for_each(ArrayVec::clear);
        let order = std::mem::take(&mut self.order);
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
            let first = self.used;
            let range = Bodies {
                first: bodies.start as u32,
                still: (part(low).end - 1 - bodies.start) as u32,
            };
            self.fill_group(problem, rows, range, impulses);
            let blocks = first..self.used;
            // Interiors stay in any case: momentum moves their bodies.
            if turn == 0 || !blocks.is_empty() {
                self.turns[turn].push(Group { blocks, bodies });
            }
        }
        self.exact.blocks.truncate(self.used);
        self.rows.truncate(self.used);
        self.order = order;
    }

    /// Blocks of `rows`: a contact joins the first open block in which its bodies are not yet met; when there is none the
    /// oldest is closed.
    fn fill_group(&mut self, problem: &Problem, rows: &[u32], range: Bodies, impulses: &[Vec3]) {
        let mut open = [None; OPEN];
        let mut oldest = 0;
        for &k in rows {
            let row = &problem.rows[k as usize];
            let place = |body: u32| self.place.get(body as usize).map(|at| at - range.first);
            let bodies = [row.a, row.b].map(|body| place(body).unwrap_or(range.still));
            let held = bodies.map(|at| self.held[at as usize]);
            let mut at = (!(held[0] | held[1])).trailing_zeros() as usize;
            if at >= OPEN {
                at = oldest;
                oldest = (oldest + 1) % OPEN;
                self.close(open[at].take(), at);
            }
            let block = match open[at] {
                Some(block) => block,
                None => self.new_block(range),
            };
            open[at] = Some(block);
            for body in bodies {
                self.held[body as usize] |= 1 << at;
            }
            // Any number of contacts may join the one that never moves.
            self.held[range.still as usize] = 0;
            self.fill(block, (k, row), bodies, impulses[k as usize]);
            if self.exact.blocks[block].count as usize == LANES {
                self.close(open[at].take(), at);
            }
        }
        for (at, block) in open.into_iter().enumerate() {
            self.close(block, at);
        }
    }

    /// An empty block, in the memory of an old one if there is one left.
    fn new_block(&mut self, range: Bodies) -> usize {
        let at = self.used;
        self.used += 1;
        if at == self.exact.blocks.len() {
            self.exact.blocks.push(Block::default());
            self.rows.push(Sixteen::default());
        }
        let block = &mut self.exact.blocks[at];
        (block.count, block.drift) = (0, STILL);
        block.bodies = [[range.still; LANES]; 2];
        at
    }

    /// Lets the bodies of the block that was open at `at` join another.
    fn close(&mut self, block: Option<usize>, at: usize) {
        let Some(block) = block.map(|block| &mut self.exact.blocks[block]) else {
            return;
        };
        for &body in block.bodies.as_flattened() {
            self.held[body as usize] &= !(1 << at);
        }
        block.clear_from(block.count as usize);
        block.impulse[1] = block.impulse[0];
    }

    /// Adds a contact of spheres to a block.
    fn fill(&mut self, index: usize, (k, row): (u32, &Row), bodies: [u32; 2], impulse: Vec3) {
        let Law::Contact { mu } = row.law else {
            return;
        };
        let block = &mut self.exact.blocks[index];
        let lane = block.count as usize % LANES;
        block.count += 1;
        self.rows[index][lane] = k;
        let bias = row.bias.dot(&row.normal);
        let across = row.bias - row.normal * bias;
        let length = row.radius / self.step;
        for (lanes, body) in block.bodies.iter_mut().zip(bodies) {
            lanes[lane] = body;
        }
        for axis in 0..3 {
            block.normal[axis][lane] = row.normal[axis];
            block.impulse[0][axis][lane] = impulse[axis];
        }
        block.bias[lane] = bias;
        block.friction[lane] = mu;
        block.length[lane] = length * length;
        block.scale[lane] = row.impulse_scale * row.impulse_scale;
        if row.drift == Vec3::zeros() && across.norm_squared() <= (SAME * bias).powi(2) {
            return;
        }
        let drifts = &mut self.exact.drifts;
        if block.drift == STILL {
            block.drift = drifts.len() as u32;
            drifts.push(Default::default());
        }
        let drift = row.drift + across;
        for (lanes, x) in drifts[block.drift as usize].iter_mut().zip(drift.iter()) {
            lanes[lane] = *x;
        }
    }

    /// `row` as a contact of spheres: those have the same mobility in all directions and are touched at `R normal`.
    fn is_sphere_contact(&mut self, row: &Row) -> bool {
        matches!(row.law, Law::Contact { .. })
            && row.compliance_n == 0.0
            && row.compliance_t == 0.0
            && self.is_sphere(row.a, -row.arm_a, row.normal)
            && (row.b == GROUND || self.is_sphere(row.b, row.arm_b, row.normal))
    }

    /// Whether a body is a sphere that is touched at `arm`; the first time that is where it gets its radius.
    fn is_sphere(&mut self, body: u32, arm: Vec3, normal: Vec3) -> bool {
        let known = &mut self.radius[body as usize];
        if *known == 0.0 {
            *known = arm.dot(&normal).max(0.0);
        }
        *known > 0.0 && (arm - normal * *known).norm_squared() <= (SAME * *known).powi(2)
    }
}

/// Group of rows between parts `a` and `b` of `parts`: interiors, then borders of even and of odd parts, then all else.
fn group_of(a: usize, b: usize, parts: usize) -> usize {
    let low = a.min(b);
    match (a.abs_diff(b), low % 2) {
        (0, _) => low,
        (1, 0) => parts + low / 2,
        (1, _) => parts + parts / 2 + low / 2,
        _ => 2 * parts - 1,
    }
}

/// Turn of a group, and its lower part.
fn turn_of(group: usize, parts: usize) -> (usize, usize) {
    if group < parts {
        (0, group)
    } else if group == 2 * parts - 1 {
        (3, 0)
    } else if group < parts + parts / 2 {
        (1, 2 * (group - parts))
    } else {
        (2, 2 * (group - parts - parts / 2) + 1)
    }
}

/// Into `sorted` the `items` by ascending key; of equal keys in the order they come in.
fn counting_sort(
    items: impl Iterator<Item = u32> + Clone,
    key: impl Fn(u32) -> u32,
    counts: &mut Vec<u32>,
    sorted: &mut Vec<u32>,
) {
    let keys = items.clone().map(&key);
    let largest = keys.clone().max().unwrap_or_default() as usize;
    first_places(keys, largest + 1, counts);
    refill(sorted, counts.last().map_or(0, |&all| all as usize), 0);
    for item in items {
        let next = &mut counts[key(item) as usize];
        sorted[*next as usize] = item;
        *next += 1;
    }
}
