//! All blocks and bodies of a problem in one precision, and what is done with all of them, part by part.

use std::ops::Range;

use arrayvec::ArrayVec;

use super::block::{Block, Pace, Progress, Vector, Verdict};
use super::dispatch::{self, Drift, Fill, Judge, Precision, Push, Sweep};
use super::lanes::{Body, Real, Sixteen};
use super::layout::PARTS;
use super::local::Source;
use crate::Vec3;
use crate::parallel::Pool;
use crate::solver::residual::Residual;

/// Blocks that are swept together, and the bodies they move.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Group {
    pub(super) blocks: Range<usize>,
    pub(super) bodies: Range<usize>,
}

/// Groups in turns: those of a turn share no body, and their blocks and bodies ascend.
pub(super) type Turns = [ArrayVec<Group, PARTS>; 4];

/// Bodies that take as long to move on as a block to sweep.
const BODIES: usize = 50;

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
    pool: &Pool,
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
    pub(super) fn sweep(&mut self, turns: &Turns, pool: &Pool, pace: Pace) -> Progress {
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
    fn drift(&mut self, turns: &Turns, pool: &Pool, momentum: f64) {
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
        pool.each(rest / BODIES, &mut pairs, |(now, before)| {
            drift(now, before)
        });
    }
}

/// All blocks' contacts in double precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Exact<'a> {
    pub(super) source: Source<'a>,
    /// Rows of each block.
    pub(super) rows: &'a [Sixteen<u32>],
}

impl<'a> Exact<'a> {
    fn of<B>(self, group: &Group, blocks: B) -> dispatch::Exact<'a, B> {
        dispatch::Exact {
            source: self.source,
            rows: &self.rows[group.blocks.clone()],
            blocks,
        }
    }
}

impl<T: Real> Sheet<T> {
    /// Fills the blocks, whose bodies are known, from the contacts and `impulses`, `[C]` \[N s\].
    pub(super) fn fill(&mut self, exact: Exact, impulses: &[Vec3], turns: &Turns, pool: &Pool) {
        self.latest = 0;
        let blocks = |group: &Group| group.blocks.clone();
        by_group(turns, pool, &mut self.blocks, blocks, |group, blocks| {
            let of = exact.of(group, blocks);
            f64::widest(Fill { of, impulses });
        });
    }

    /// Gives the bodies the impulses of all blocks.
    pub(super) fn push(&self, exact: Exact, turns: &Turns, pool: &Pool, bodies: &mut [Body<f64>]) {
        let range = |group: &Group| group.bodies.clone();
        by_group(turns, pool, bodies, range, |group, bodies| {
            f64::widest(Push {
                of: exact.of(group, &self.blocks[group.blocks.clone()]),
                bodies,
                latest: self.latest,
            });
        });
    }

    /// What each block's contacts are off by.
    pub(super) fn judge(
        &self,
        exact: Exact,
        (bodies, drifts): (&[Body<f64>], &[Vector<f64>]),
        turns: &Turns,
        pool: &Pool,
        verdicts: &mut Vec<Verdict>,
    ) -> Residual {
        verdicts.resize(self.blocks.len(), Verdict::default());
        let blocks = |group: &Group| group.blocks.clone();
        by_group(turns, pool, verdicts, blocks, |group, verdicts| {
            f64::widest(Judge {
                of: exact.of(group, &self.blocks[group.blocks.clone()]),
                bodies: &bodies[group.bodies.clone()],
                drifts,
                latest: self.latest,
                verdicts,
            });
        });
        let mut residual = Residual::default();
        let blocks = self.blocks.iter().zip(exact.rows);
        for ((block, rows), [gaps, slips, forces, margins]) in blocks.zip(verdicts) {
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                let values = [gaps[lane], slips[lane], forces[lane]];
                residual.include(row as usize, values, margins[lane]);
            }
        }
        residual
    }

    /// Writes the impulses \[N s\] of the blocks' rows.
    pub(super) fn store(&self, exact: Exact, impulses: &mut [Vec3]) {
        for (block, rows) in self.blocks.iter().zip(exact.rows) {
            let [x, y, z] = block.exact(self.latest, exact.source.unit);
            for (lane, &row) in rows[..block.count as usize].iter().enumerate() {
                impulses[row as usize] = Vec3::new(x[lane], y[lane], z[lane]);
            }
        }
    }

    /// Takes bodies and drifts from double precision, masses over `unit`, as if bodies had not moved before.
    pub(super) fn place(&mut self, bodies: &[Body<f64>], drifts: &[Vector<f64>], unit: f64) {
        self.bodies.clear();
        self.bodies.extend(bodies.iter().map(|Body(x)| {
            let [a, b, c, m, d, e, f, k] = *x;
            Body([a, b, c, m / unit, d, e, f, k / unit].map(T::of))
        }));
        self.before.clone_from(&self.bodies);
        self.drifts.clear();
        let single = |v: &Vector<f64>| [0, 1, 2].map(|k| v[k].map(T::of));
        self.drifts.extend(drifts.iter().map(single));
    }
}
