//! All blocks and bodies of a problem in one precision, and what is done with all of them, part by part.

use std::ops::Range;

use arrayvec::ArrayVec;

use super::block::{Block, Pace, Progress, Vector, Verdict, single};
use super::dispatch::{Drift, Judge, Precision, Push, Sweep};
use super::lanes::Body;
use super::layout::PARTS;
use crate::parallel::Pool;

/// Blocks that are swept together, and the bodies they move.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Group {
    pub(super) blocks: Range<usize>,
    pub(super) bodies: Range<usize>,
}

/// Groups in turns: those of a turn share no body, and their blocks and bodies ascend.
pub(super) type Turns = [ArrayVec<Group, PARTS>; 4];

/// Blocks and bodies in one precision.
#[derive(Debug, Default)]
pub(super) struct Sheet<T> {
    pub(super) blocks: Vec<Block<T>>,
    /// Which of the blocks' impulses are the last.
    pub(super) latest: usize,
    /// Velocities of moving ground under the contacts of blocks \[m/s\], where there is such.
    pub(super) drifts: Vec<Vector<T>>,
    pub(super) bodies: Vec<Body<T>>,
    /// Bodies before the last sweep.
    pub(super) before: Vec<Body<T>>,
}

/// Blocks of a turn.
fn size(turn: &[Group]) -> usize {
    turn.iter().map(|group| group.blocks.len()).sum()
}

/// `ranges` of `items`, which ascend.
fn split<X>(
    mut items: &mut [X],
    ranges: impl Iterator<Item = Range<usize>>,
) -> ArrayVec<&mut [X], PARTS> {
    let mut done = 0;
    let part = |range: Range<usize>| {
        let (_, rest) = std::mem::take(&mut items).split_at_mut(range.start - done);
        let (part, rest) = rest.split_at_mut(range.len());
        items = rest;
        done = range.end;
        part
    };
    ranges.map(part).collect()
}

/// Does `work` with every group and its `range` of `items`, those of a turn side by side.
fn by_group<X: Send>(
    turns: &Turns,
    pool: &mut Pool,
    items: &mut [X],
    range: impl Fn(&Group) -> Range<usize>,
    work: impl Fn(&Group, &mut [X]) + Sync,
) {
    for turn in turns {
        let parts = split(items, turn.iter().map(&range));
        let mut tasks: ArrayVec<_, PARTS> = turn.iter().zip(parts).collect();
        pool.each(size(turn), &mut tasks, |(group, part)| work(group, part));
    }
}

impl<T: Precision> Sheet<T> {
    /// One sweep.
    pub(super) fn sweep(&mut self, turns: &Turns, pool: &mut Pool, pace: Pace) -> Progress {
        self.drift(turns, pool, pace.momentum);
        let mut total = Progress::NONE;
        for turn in turns.iter().filter(|turn| !turn.is_empty()) {
            let blocks = split(&mut self.blocks, turn.iter().map(|g| g.blocks.clone()));
            let bodies = split(&mut self.bodies, turn.iter().map(|g| g.bodies.clone()));
            let (drifts, latest) = (&self.drifts[..], self.latest);
            let mut tasks: ArrayVec<_, PARTS> = blocks
                .into_iter()
                .zip(bodies)
                .map(|task| (task, Progress::NONE))
                .collect();
            pool.each(size(turn), &mut tasks, |((blocks, bodies), found)| {
                *found = T::widest(Sweep {
                    blocks,
                    bodies,
                    drifts,
                    latest,
                    pace,
                });
            });
            total = tasks.iter().fold(total, |sum, (_, found)| sum.with(found));
        }
        self.latest = 1 - self.latest;
        total
    }

    /// Moves all bodies on by `momentum` times their last change.
    fn drift(&mut self, turns: &Turns, pool: &mut Pool, momentum: f64) {
        let parts = || turns[0].iter().map(|group| group.bodies.clone());
        // Behind the parts are driven bodies.
        let rest = turns[0].last().map_or(0, |group| group.bodies.end);
        let drift = |bodies: &mut [Body<T>], before: &mut [Body<T>]| {
            T::widest(Drift {
                bodies,
                before,
                momentum,
            });
        };
        drift(&mut self.bodies[rest..], &mut self.before[rest..]);
        let bodies = split(&mut self.bodies, parts()).into_iter();
        let pairs = bodies.zip(split(&mut self.before, parts()));
        let mut pairs: ArrayVec<_, PARTS> = pairs.collect();
        pool.each(rest, &mut pairs, |(now, before)| drift(now, before));
    }
}

impl Sheet<f64> {
    /// Gives the bodies the impulses of all blocks.
    pub(super) fn push(&mut self, turns: &Turns, pool: &mut Pool) {
        let (blocks, latest) = (&self.blocks, self.latest);
        let bodies = |group: &Group| group.bodies.clone();
        by_group(turns, pool, &mut self.bodies, bodies, |group, bodies| {
            f64::widest(Push {
                blocks: &blocks[group.blocks.clone()],
                bodies,
                latest,
            });
        });
    }

    /// What each block's contacts are off by.
    pub(super) fn judge(&self, turns: &Turns, pool: &mut Pool, verdicts: &mut Vec<Verdict>) {
        verdicts.resize(self.blocks.len(), Verdict::default());
        let blocks = |group: &Group| group.blocks.clone();
        by_group(turns, pool, verdicts, blocks, |group, verdicts| {
            f64::widest(Judge {
                blocks: &self.blocks[group.blocks.clone()],
                bodies: &self.bodies[group.bodies.clone()],
                drifts: &self.drifts,
                latest: self.latest,
                verdicts,
            });
        });
    }

    /// Copies itself into single precision, impulses and masses times `unit`.
    pub(super) fn single(&self, unit: f64, turns: &Turns, pool: &mut Pool, to: &mut Sheet<f32>) {
        to.latest = self.latest;
        to.drifts.clear();
        let drifts = self.drifts.iter();
        to.drifts
            .extend(drifts.map(|v| [0, 1, 2].map(|k| single(&v[k], 1.0))));
        to.blocks.resize(self.blocks.len(), Block::default());
        let blocks = |group: &Group| group.blocks.clone();
        by_group(turns, pool, &mut to.blocks, blocks, |group, copies| {
            let blocks = &self.blocks[group.blocks.clone()];
            for (block, copy) in blocks.iter().zip(copies) {
                *copy = block.single(unit);
            }
        });
        self.single_bodies(unit, to);
    }

    /// Copies the bodies alone, as if they had not moved before.
    pub(super) fn single_bodies(&self, unit: f64, to: &mut Sheet<f32>) {
        to.bodies.clear();
        to.bodies.extend(self.bodies.iter().map(|Body(x)| {
            let [a, b, c, m, d, e, f, k] = *x;
            Body([a, b, c, m / unit, d, e, f, k / unit].map(|x| x as f32))
        }));
        to.before.clone_from(&to.bodies);
    }

    /// Takes the impulses back from single precision, as if they had not changed before.
    pub(super) fn take_impulses(&mut self, unit: f64, from: &Sheet<f32>) {
        self.latest = from.latest;
        for (block, single) in self.blocks.iter_mut().zip(&from.blocks) {
            for (axis, values) in single.impulse[from.latest].iter().enumerate() {
                let exact = values.map(|x| f64::from(x) / unit);
                block.impulse[0][axis] = exact;
                block.impulse[1][axis] = exact;
            }
        }
    }
}
