//! All blocks and bodies of a problem in one precision, and what is done with all of them, part by part.

use std::iter::repeat_with;
use std::mem::take;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

use arrayvec::ArrayVec;

use super::batch::{Batch, Extra, Group, Progress, SweepParams};
use super::dispatch::{Drift, Exact, Fill, Judge, Precision, Push, Sweep};
use super::heavy::Heavy;
use super::kinds::NONE;
use super::lanes::{Body, LANES, Real};
use super::levers::Levers;
use super::partition::PARTS;
use super::resistance::Resistances;
use crate::Vec3;
use crate::memory;
use crate::parallel::Pool;
use crate::solver::params::Registers;
use crate::solver::residual::Residual;

/// Groups in turns: those of a turn share no body, and their blocks and bodies ascend.
pub(super) type Colours = [ArrayVec<Group, PARTS>; 5];

/// Bodies that take as long to move on as a block to sweep.
pub(super) const BODIES: usize = 50;

/// Blocks and bodies in one precision.
#[derive(Debug, Default)]
pub(super) struct Batches<T> {
    pub(super) registers: Registers,
    pub(super) blocks: Vec<Batch<T>>,
    /// Which contacts of each block the last sweep found off by more than the tolerances, as bits. Beside the blocks: to write into
    /// each of them takes 3 % of the time of a bed.
    pub(super) unsettled: Vec<u16>,
    /// Of those blocks that have such, in their order.
    pub(super) resistances: Vec<Resistances<T>>,
    /// Which of the blocks' impulses are the last.
    pub(super) latest: usize,
    /// Velocities of moving ground under the contacts of blocks \[m/s\], where there is such.
    pub(super) extras: Vec<Extra<T>>,
    /// Of the blocks that have contacts of bodies that are no spheres.
    pub(super) levers: Vec<Levers<T>>,
    /// Of the blocks whose contacts are on heavy bodies.
    pub(super) heavy: Vec<Heavy<T>>,
    pub(super) bodies: Vec<Body<T>>,
    /// Bodies before the last sweep.
    pub(super) before: Vec<Body<T>>,
}

/// Blocks of a turn.
fn size(turn: &[Group]) -> usize {
    turn.iter().map(|group| group.blocks.len()).sum()
}

/// `ranges` of `items`, which ascend.
pub(super) fn split<X>(
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
    turns: &Colours,
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

impl<T: Precision> Batches<T> {
    /// One sweep. Bodies first move on by the momentum times their last change: those of a part by who sweeps it, for they are at
    /// hand there.
    pub(super) fn sweep(&mut self, turns: &Colours, pool: &Pool, pace: SweepParams) -> Progress {
        let (mut total, registers) = (Progress::NONE, self.registers);
        let move_on = |bodies: &mut [Body<T>], before: &mut [Body<T>]| {
            let momentum = pace.momentum;
            T::with(
                registers,
                Drift {
                    bodies,
                    before,
                    momentum,
                },
            );
        };
        // Behind the parts are driven bodies and clumps.
        let rest = turns[0].last().map_or(0, |group| group.bodies.end);
        let (parts, others) = self.before.split_at_mut(rest);
        move_on(&mut self.bodies[rest..], others);
        memory::resize(&mut self.unsettled, self.blocks.len(), 0);
        let mut before = split(parts, turns[0].iter().map(|group| group.bodies.clone()));
        for turn in turns.iter().filter(|turn| !turn.is_empty()) {
            let blocks = split(&mut self.blocks, turn.iter().map(|g| g.blocks.clone()));
            let unsettled = split(&mut self.unsettled, turn.iter().map(|g| g.blocks.clone()));
            let of_group = turn.iter().map(|g| g.resistances.clone());
            let resistances = split(&mut self.resistances, of_group);
            let bodies = split(&mut self.bodies, turn.iter().map(|g| g.bodies.clone()));
            let (extras, latest) = (&self.extras[..], self.latest);
            let (levers, heavy) = (&self.levers[..], &self.heavy[..]);
            // The first turn is that of the parts.
            let before = take(&mut before)
                .into_iter()
                .map(Some)
                .chain(repeat_with(|| None));
            let mut tasks: ArrayVec<_, PARTS> = blocks
                .into_iter()
                .zip(unsettled)
                .zip(resistances)
                .zip(bodies.into_iter().zip(before))
                .zip(turn)
                .map(|task| (task, Progress::NONE))
                .collect();
            pool.each(size(turn), &mut tasks, |(task, found)| {
                let ((((blocks, unsettled), resistances), (bodies, before)), group) = task;
                if let Some(before) = before {
                    move_on(bodies, before);
                }
                *found = T::with(
                    registers,
                    Sweep {
                        blocks,
                        unsettled,
                        resistances,
                        bodies,
                        extras,
                        levers,
                        heavy,
                        form: group.form,
                        latest,
                        pace,
                    },
                );
            });
            total = tasks.iter().fold(total, |sum, (_, found)| sum.with(found));
        }
        self.latest = 1 - self.latest;
        total
    }
}

impl<T: Real> Batches<T> {
    /// Fills the blocks, whose bodies are known, from the contacts and `impulses`, `[C]` \[N s\].
    pub(super) fn fill(&mut self, exact: Exact, impulses: &[Vec3], turns: &Colours, pool: &Pool) {
        self.latest = 0;
        let registers = self.registers;
        self.resistances
            .resize_with(exact.resistances.len(), Resistances::default);
        for (own, source) in self.resistances.iter_mut().zip(exact.resistances) {
            own.fill(source, impulses, exact.source.unit);
        }
        let blocks = |group: &Group| group.blocks.clone();
        by_group(turns, pool, &mut self.blocks, blocks, |group, blocks| {
            let exact = exact.of(group);
            f64::with(
                registers,
                Fill {
                    exact,
                    blocks,
                    impulses,
                },
            );
        });
    }

    /// Gives the bodies the impulses of all blocks.
    pub(super) fn push(
        &self,
        exact: Exact,
        turns: &Colours,
        pool: &Pool,
        bodies: &mut [Body<f64>],
    ) {
        let (range, registers) = (|group: &Group| group.bodies.clone(), self.registers);
        by_group(turns, pool, bodies, range, |group, bodies| {
            f64::with(
                registers,
                Push {
                    exact: exact.of(group),
                    blocks: self.of(group),
                    bodies,
                    latest: self.latest,
                },
            );
        });
    }

    /// What the blocks' contacts are off by.
    pub(super) fn judge(
        &self,
        exact: Exact,
        (bodies, extras): (&[Body<f64>], &[Extra<f64>]),
        turns: &Colours,
        pool: &Pool,
    ) -> Residual {
        let (mut residual, registers) = (Residual::default(), self.registers);
        for turn in turns {
            let none = |group| (group, Residual::default());
            let mut tasks: ArrayVec<_, PARTS> = turn.iter().map(none).collect();
            pool.each(size(turn), &mut tasks, |(group, found)| {
                *found = f64::with(
                    registers,
                    Judge {
                        exact: exact.of(group),
                        blocks: self.of(group),
                        bodies: &bodies[group.bodies.clone()],
                        extras,
                        latest: self.latest,
                    },
                );
            });
            tasks.iter().for_each(|(_, found)| residual.join(found));
        }
        residual
    }

    /// Blocks and resistances of a group.
    fn of(&self, group: &Group) -> (&[Batch<T>], &[Resistances<T>]) {
        let blocks = &self.blocks[group.blocks.clone()];
        (blocks, &self.resistances[group.resistances.clone()])
    }

    /// Writes the impulses \[N s\] of the blocks' rows, which are in these `lanes`.
    pub(super) fn store(
        &self,
        exact: Exact,
        lanes: &[AtomicU32],
        pool: &Pool,
        impulses: &mut [Vec3],
    ) {
        let unit = exact.source.unit;
        let store = |first: usize, impulses: &mut [Vec3]| {
            for (impulse, lane) in impulses.iter_mut().zip(&lanes[first..]) {
                let lane = lane.load(Ordering::Relaxed);
                if lane != NONE {
                    let (block, lane) = (lane as usize / LANES, lane as usize % LANES);
                    *impulse = self.blocks[block].exact_of(lane, self.latest, unit);
                }
            }
        };
        pool.pieces(&mut *impulses, store, |(), ()| ());
        for (own, source) in self.resistances.iter().zip(exact.resistances) {
            let [x, y, z] = own.exact(self.latest, unit);
            for (lane, row) in source.lanes() {
                impulses[row] = Vec3::new(x[lane], y[lane], z[lane]);
            }
        }
    }

    /// Takes bodies and extras from double precision, masses over `unit`, as if bodies had not moved before.
    pub(super) fn place(
        &mut self,
        bodies: &[Body<f64>],
        extras: &[Extra<f64>],
        unit: f64,
        pool: &Pool,
    ) {
        let share = 1.0 / unit;
        let place = |first: usize, own: &mut [Body<T>]| {
            for (own, Body(x)) in own.iter_mut().zip(&bodies[first..]) {
                let [a, b, c, m, d, e, f, k] = *x;
                let (m, k) = (m * share, k * share);
                let [a, b, c, d] = [T::of(a), T::of(b), T::of(c), T::of(d)];
                *own = Body([a, b, c, T::of(m), d, T::of(e), T::of(f), T::of(k)]);
            }
        };
        self.bodies.resize(bodies.len(), Body::default());
        self.before.resize(bodies.len(), Body::default());
        let both = (&mut self.bodies[..], &mut self.before[..]);
        let work = |first, (bodies, before): (&mut [Body<T>], &mut [Body<T>])| {
            place(first, bodies);
            before.copy_from_slice(bodies);
        };
        pool.pieces(both, work, |(), ()| ());
        self.extras.clear();
        self.extras.extend(extras.iter().map(|extra| Extra {
            velocity: extra.velocity.map(|axis| axis.map(T::of)),
            compliance: extra.compliance.map(|c| c.map(|c| T::of(c * share))),
        }));
    }
}
