//! Sweeps, pushes and judgements with the widest registers that the processor has.

use std::ops::Range;

use super::block::{Block, Pace, Progress, Vector, Verdict};
use super::lanes::{Body, Lanes, Plain, Real, Sixteen};
use super::local::Constants;

/// What a sweep goes over, in one precision: all of one group.
#[derive(Debug)]
pub(super) struct Sweep<'a, T> {
    pub(super) blocks: &'a mut [Block<T>],
    pub(super) bodies: &'a mut [Body<T>],
    pub(super) drifts: &'a [Vector<T>],
    /// Which of the blocks' impulses are the last.
    pub(super) latest: usize,
    pub(super) pace: Pace,
}

/// What gives bodies their impulses.
#[derive(Debug)]
pub(super) struct Push<'a> {
    pub(super) blocks: &'a [Block<f64>],
    pub(super) bodies: &'a mut [Body<f64>],
    pub(super) latest: usize,
}

/// What finds out what each block's contacts are off by where the bodies move as the impulses make them.
#[derive(Debug)]
pub(super) struct Judge<'a> {
    pub(super) blocks: &'a [Block<f64>],
    pub(super) bodies: &'a [Body<f64>],
    pub(super) drifts: &'a [Vector<f64>],
    pub(super) latest: usize,
    pub(super) verdicts: &'a mut [Verdict],
}

/// Work on blocks that goes some numbers at a time.
pub(super) trait Work: Sized {
    /// Precision of its numbers.
    type Real: Real;
    /// What it finds.
    type Output;

    /// Does it with `lanes`.
    fn with<L: Lanes<Self::Real>>(self, lanes: L) -> Self::Output;
}

/// A precision with its registers.
pub(super) trait Precision: Real {
    /// Does `work` with the widest registers that the processor has.
    fn widest<W: Work<Real = Self>>(work: W) -> W::Output;
}

macro_rules! precision {
    ($real:ty) => {
        impl Precision for $real {
            fn widest<W: Work<Real = Self>>(work: W) -> W::Output {
                #[cfg(target_arch = "x86_64")]
                if let Some(lanes) = pulp::x86::V4::try_new() {
                    return lanes.vectorize(Job { work, lanes });
                }
                #[cfg(target_arch = "x86_64")]
                if let Some(lanes) = pulp::x86::V3::try_new() {
                    return lanes.vectorize(Job { work, lanes });
                }
                work.with(Plain::<4>)
            }
        }
    };
}

precision!(f64);
precision!(f32);

/// Work with its lanes.
pub(super) struct Job<W, L> {
    pub(super) work: W,
    pub(super) lanes: L,
}

impl<W: Work, L: Lanes<W::Real>> pulp::NullaryFnOnce for Job<W, L> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.work.with(self.lanes)
    }
}

/// Passes over the contacts that `block` holds.
#[inline(always)]
fn passes<T, L: Lanes<T>>(block: &Block<T>) -> Range<usize> {
    0..(block.count as usize).div_ceil(L::WIDTH).min(L::PASSES)
}

impl<T: Real> Work for Sweep<'_, T> {
    type Real = T;
    type Output = Progress;

    #[inline(always)]
    fn with<L: Lanes<T>>(self, l: L) -> Progress {
        let pace = Constants::of(l, &self.pace);
        let mut settled = L::ALL;
        // Lane by lane, so that every width sums in the same order.
        let mut along = Sixteen::<T>::default();
        let mut change = Sixteen::<T>::default();
        for block in self.blocks {
            for pass in passes::<T, L>(block) {
                let (within, a, c) =
                    block.update(l, pass, self.bodies, self.drifts, self.latest, &pace);
                settled &= within;
                l.store(l.load(&along, pass) + a, &mut along, pass);
                l.store(l.load(&change, pass) + c, &mut change, pass);
            }
        }
        let sum = |x: Sixteen<T>| x.iter().map(|x| x.exact()).sum();
        Progress {
            settled: settled == L::ALL,
            along: sum(along),
            change: sum(change),
        }
    }
}

impl Work for Push<'_> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        for block in self.blocks {
            for pass in passes::<f64, L>(block) {
                block.push(l, pass, self.bodies, self.latest);
            }
        }
    }
}

impl Work for Judge<'_> {
    type Real = f64;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<f64>>(self, l: L) {
        for (block, verdict) in self.blocks.iter().zip(self.verdicts) {
            for pass in passes::<f64, L>(block) {
                block.judge(l, pass, self.bodies, self.drifts, self.latest, verdict);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::block::STILL;
    use super::*;
    use crate::scene::Tolerance;
    use proptest::prelude::*;

    /// Blocks of sixteen contacts of 32 bodies from numbers in -1..1; the second is not full, and its ground drifts.
    #[derive(Debug, Clone)]
    struct Case<T> {
        blocks: [Block<T>; 2],
        bodies: Vec<Body<T>>,
        drifts: Vec<Vector<T>>,
    }

    fn case<T: Real>(numbers: &[f64]) -> Case<T> {
        let mut source = numbers.iter().cycle().map(|&x| T::of(x));
        let mut sixteen =
            || -> Sixteen<T> { std::array::from_fn(|_| source.next().unwrap_or_default()) };
        let mut vector = || [sixteen(), sixteen(), sixteen()];
        let mut full = Block {
            normal: vector(),
            impulse: [vector(), vector()],
            friction: std::array::from_fn(|k| T::of(0.1 * k as f64)),
            bodies: [0, 16].map(|first| std::array::from_fn(|k| first + k as u32)),
            count: 16,
            drift: STILL,
            ..Block::default()
        };
        let drifts = vec![vector()];
        [full.bias, full.length, full.scale] = vector();
        let mut bodies: Vec<_> = (0..16)
            .flat_map(|_| sixteen().as_chunks().0.to_vec())
            .map(Body)
            .collect();
        // Masses of either sign, and none.
        for (k, body) in bodies.iter_mut().enumerate() {
            body.0[3] = T::of([0.0, 0.3, 1.0, 2.0][k % 4]);
        }
        let part = Block {
            count: 5,
            drift: 0,
            ..full
        };
        Case {
            blocks: [full, part],
            bodies,
            drifts,
        }
    }

    /// A sweep, a push and a judgement by one kind of lanes.
    macro_rules! done {
        ($case:expr, $pace:expr, $job:expr) => {{
            let mut case = $case.clone();
            let Case {
                blocks,
                bodies,
                drifts,
            } = &mut case;
            let found = $job(Sweep {
                blocks,
                bodies,
                drifts,
                latest: 0,
                pace: $pace,
            });
            format!("{found:?} {case:?}")
        }};
    }

    proptest! {
        #[test]
        fn wide_registers_give_the_same_bits(
            numbers in prop::collection::vec(-1.0..1.0f64, 16 * 31),
            momentum in 0.0..1.0f64,
        ) {
            let pace = Pace {
                momentum,
                damping: 0.9,
                strictness: 1.0,
                tolerance: Tolerance { gap: 0.5, slip: 0.5, force: 0.5 },
            };
            let (quick, exact) = (case::<f32>(&numbers), case::<f64>(&numbers));
            let expected = [
                done!(quick, pace, |work: Sweep<f32>| work.with(Plain::<16>)),
                done!(exact, pace, |work: Sweep<f64>| work.with(Plain::<16>)),
            ];
            let judged = |job: &dyn Fn(Push), judge: &dyn Fn(Judge)| {
                let Case { blocks, mut bodies, drifts } = exact.clone();
                job(Push { blocks: &blocks, bodies: &mut bodies, latest: 1 });
                let mut verdicts = [Verdict::default(); 2];
                judge(Judge { blocks: &blocks, bodies: &bodies, drifts: &drifts, latest: 1, verdicts: &mut verdicts });
                format!("{bodies:?} {verdicts:?}")
            };
            let verdict = judged(&|w| w.with(Plain::<16>), &|w| w.with(Plain::<16>));
            macro_rules! same {
                ($run:expr, $swept:expr, $exact:expr, $push:expr, $judge:expr) => {
                    prop_assert_eq!(&done!(quick, pace, $swept), &expected[0], "{} single", $run);
                    prop_assert_eq!(&done!(exact, pace, $exact), &expected[1], "{} double", $run);
                    prop_assert_eq!(judged(&$push, &$judge), verdict.clone(), "{} judgement", $run);
                };
            }
            same!("four", |w: Sweep<f32>| w.with(Plain::<4>), |w: Sweep<f64>| w.with(Plain::<4>), |w| w.with(Plain::<4>), |w| w.with(Plain::<4>));
            #[cfg(target_arch = "x86_64")]
            macro_rules! registers {
                ($lanes:ident) => {
                    if let Some(lanes) = pulp::x86::$lanes::try_new() {
                        macro_rules! job {
                            () => { |work| lanes.vectorize(Job { work, lanes }) };
                        }
                        same!(stringify!($lanes), |w: Sweep<f32>| lanes.vectorize(Job { work: w, lanes }), |w: Sweep<f64>| lanes.vectorize(Job { work: w, lanes }), |work| lanes.vectorize(Job { work, lanes }), |work| lanes.vectorize(Job { work, lanes }));
                    }
                };
            }
            #[cfg(target_arch = "x86_64")]
            { registers!(V3); registers!(V4); }
        }
    }
}
