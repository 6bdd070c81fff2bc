//! Sweeps, pushes and judgements with the widest registers that the processor has.

use super::block::{Block, Pace, Progress, Verdict};
use super::lanes::{Body, Eight, Lanes, Plain, Real};
use super::local::Constants;

/// A precision with its registers.
pub(super) trait Precision: Real {
    /// [`Block`]s swept once; body indices count from `offset`.
    fn sweep(
        blocks: &mut [Block<Self>],
        bodies: &mut [Body<Self>],
        offset: u32,
        pace: Pace,
    ) -> Progress;
}

/// Does `$task` with the widest registers that the processor has, or `$width` numbers at a time without.
macro_rules! widest {
    ($width:literal, $task:ident { $($field:ident),* }) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some(lanes) = pulp::x86::V3::try_new() {
            return lanes.vectorize($task { lanes, $($field),* });
        }
        pulp::NullaryFnOnce::call($task { lanes: Plain::<$width>, $($field),* })
    }};
}

macro_rules! precision {
    ($real:ty, $width:literal) => {
        impl Precision for $real {
            fn sweep(
                blocks: &mut [Block<Self>],
                bodies: &mut [Body<Self>],
                offset: u32,
                pace: Pace,
            ) -> Progress {
                widest!(
                    $width,
                    Sweep {
                        blocks,
                        bodies,
                        offset,
                        pace
                    }
                )
            }
        }
    };
}

precision!(f64, 4);
precision!(f32, 8);

/// Gives `bodies` the impulses of `blocks`.
pub(super) fn push(blocks: &[Block<f64>], bodies: &mut [Body<f64>], offset: u32) {
    widest!(
        4,
        Push {
            blocks,
            bodies,
            offset
        }
    )
}

/// What each block's contacts are off by where `bodies` move as the impulses make them.
pub(super) fn judge(
    blocks: &[Block<f64>],
    bodies: &[Body<f64>],
    offset: u32,
    verdicts: &mut [Verdict],
) {
    widest!(
        4,
        Judge {
            blocks,
            bodies,
            offset,
            verdicts
        }
    )
}

struct Sweep<'a, T, L> {
    lanes: L,
    blocks: &'a mut [Block<T>],
    bodies: &'a mut [Body<T>],
    offset: u32,
    pace: Pace,
}

impl<T: Real, L: Lanes<T>> pulp::NullaryFnOnce for Sweep<'_, T, L> {
    type Output = Progress;

    #[inline(always)]
    fn call(self) -> Progress {
        let (l, pace) = (self.lanes, &self.pace);
        let strict = pace.strictness * pace.strictness;
        let pace = Constants {
            momentum: l.splat(T::of(pace.momentum)),
            damping: l.splat(T::of(pace.damping)),
            strict: l.splat(T::of(strict)),
            strict_force: l.splat(T::of(strict * pace.force * pace.force)),
            zero: l.splat(T::of(0.0)),
        };
        let mut settled = true;
        let (mut along, mut change) = (pace.zero, pace.zero);
        for block in self.blocks {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                let (within, a, c) = block.update(l, pass, self.bodies, self.offset, &pace);
                settled &= within;
                along = along + a;
                change = change + c;
            }
        }
        let sum = |x: L::Pack| {
            let mut lanes = Eight::<T>::default();
            l.store(x, &mut lanes, 0);
            lanes.iter().map(|x| x.exact()).sum()
        };
        Progress {
            settled,
            along: sum(along),
            change: sum(change),
        }
    }
}

struct Push<'a, L> {
    lanes: L,
    blocks: &'a [Block<f64>],
    bodies: &'a mut [Body<f64>],
    offset: u32,
}

impl<L: Lanes<f64>> pulp::NullaryFnOnce for Push<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for block in self.blocks {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                block.push(self.lanes, pass, self.bodies, self.offset);
            }
        }
    }
}

struct Judge<'a, L> {
    lanes: L,
    blocks: &'a [Block<f64>],
    bodies: &'a [Body<f64>],
    offset: u32,
    verdicts: &'a mut [Verdict],
}

impl<L: Lanes<f64>> pulp::NullaryFnOnce for Judge<'_, L> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for (block, verdict) in self.blocks.iter().zip(self.verdicts) {
            for pass in 0..block.count.div_ceil(L::WIDTH) {
                block.judge(self.lanes, pass, self.bodies, self.offset, verdict);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Blocks of eight contacts of sixteen bodies from numbers in -1..1, of which the last one is not full.
    fn blocks<T: Real>(numbers: &[f64]) -> ([Block<T>; 2], Vec<Body<T>>) {
        let mut source = numbers.iter().cycle().map(|&x| T::of(x));
        let mut eight =
            || -> Eight<T> { std::array::from_fn(|_| source.next().unwrap_or_default()) };
        let mut vector = || [eight(), eight(), eight()];
        let block = Block {
            normal: vector(),
            impulse: vector(),
            previous: vector(),
            bias: vector(),
            friction: std::array::from_fn(|k| T::of(0.1 * k as f64)),
            mass: [eight(), eight()].map(|m| m.map(|x| x * x)),
            bodies: [0, 8].map(|first| std::array::from_fn(|k| first + k as u32)),
            count: 8,
            ..Block::default()
        };
        let bodies = (0..16).map(|_| Body(eight())).collect();
        ([block, Block { count: 3, ..block }], bodies)
    }

    proptest! {
        #[test]
        fn wide_registers_give_the_same_bits(
            numbers in prop::collection::vec(-1.0..1.0f64, 8 * 16 + 8 * 14),
            momentum in 0.0..1.0f64,
        ) {
            let pace = Pace { momentum, damping: 0.9, strictness: 1.0, force: 0.1 };
            macro_rules! same {
                ($real:ty, $width:literal) => {{
                    let (start, still) = blocks::<$real>(&numbers);
                    let (mut wide, mut moved) = (start, still.clone());
                    let found = <$real>::sweep(&mut wide, &mut moved, 0, pace);
                    let (mut plain, mut bodies) = (start, still);
                    let expected = pulp::NullaryFnOnce::call(Sweep {
                        lanes: Plain::<$width>,
                        blocks: &mut plain,
                        bodies: &mut bodies,
                        offset: 0,
                        pace,
                    });
                    prop_assert_eq!(format!("{wide:?} {moved:?} {found:?}"), format!("{plain:?} {bodies:?} {expected:?}"));
                }};
            }
            same!(f64, 4);
            same!(f32, 8);
        }
    }
}
