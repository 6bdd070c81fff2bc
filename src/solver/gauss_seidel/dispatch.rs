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
struct Job<W, L> {
    work: W,
    lanes: L,
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

/// What moves bodies on by `momentum` times their last change, and keeps where they were in `before`.
#[derive(Debug)]
pub(super) struct Drift<'a, T> {
    pub(super) bodies: &'a mut [Body<T>],
    pub(super) before: &'a mut [Body<T>],
    pub(super) momentum: f64,
}

impl<T: Real> Work for Drift<'_, T> {
    type Real = T;
    type Output = ();

    #[inline(always)]
    fn with<L: Lanes<T>>(self, _: L) {
        let momentum = T::of(self.momentum);
        for (body, before) in self.bodies.iter_mut().zip(self.before) {
            let now = *body;
            // Masses do not change, so that they stay.
            for (x, x_before) in body.0.iter_mut().zip(before.0) {
                *x += momentum * (*x - x_before);
            }
            *before = now;
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

    /// One kind of lanes.
    trait Run: Copy {
        fn single(self, work: Sweep<f32>) -> Progress;
        fn double(self, work: Sweep<f64>) -> Progress;
        fn push(self, work: Push);
        fn judge(self, work: Judge);
    }

    macro_rules! run {
        ($lanes:ty, |$l:ident, $work:ident| $run:expr) => {
            run!($lanes, |$l, $work| $run, single: Sweep<f32> => Progress, double: Sweep<f64> => Progress, push: Push => (), judge: Judge => ());
        };
        ($lanes:ty, |$l:ident, $work:ident| $run:expr, $($name:ident: $task:ty => $found:ty),*) => {
            impl Run for $lanes {
                $(fn $name(self, $work: $task) -> $found {
                    let $l = self;
                    $run
                })*
            }
        };
    }

    run!(Plain<4>, |lanes, work| work.with(lanes));
    run!(Plain<16>, |lanes, work| work.with(lanes));
    #[cfg(target_arch = "x86_64")]
    run!(pulp::x86::V3, |lanes, work| lanes
        .vectorize(Job { work, lanes }));
    #[cfg(target_arch = "x86_64")]
    run!(pulp::x86::V4, |lanes, work| lanes
        .vectorize(Job { work, lanes }));

    /// Blocks with their bodies.
    #[derive(Debug, Clone)]
    struct Case<T> {
        blocks: Vec<Block<T>>,
        bodies: Vec<Body<T>>,
        drifts: Vec<Vector<T>>,
    }

    impl<T> Case<T> {
        fn sweep(&mut self, latest: usize, pace: Pace) -> Sweep<'_, T> {
            Sweep {
                blocks: &mut self.blocks,
                bodies: &mut self.bodies,
                drifts: &self.drifts,
                latest,
                pace,
            }
        }
    }

    /// Two blocks of 32 bodies from numbers in -1..1; the second is not full, and its ground drifts. The last body never moves.
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
        let mut drift = vector();
        drift.iter_mut().for_each(|x| x[5..].fill(T::of(0.0)));
        let drifts = vec![drift];
        [full.bias, full.length, full.scale] = vector();
        full.length = full.length.map(|x| x * x);
        let masses = [0.0, 0.3, 1.0, 2.0].map(T::of);
        let bodies = (0..32).map(|k| {
            let numbers = sixteen();
            let mut body: [T; 8] = std::array::from_fn(|i| numbers[i]);
            (body[3], body[7]) = (masses[k % 4], masses[k / 4 % 4]);
            Body(body)
        });
        let bodies = bodies.chain([Body::default()]).collect();
        let mut part = Block {
            count: 5,
            drift: 0,
            ..full
        };
        part.clear_from(5);
        part.bodies.iter_mut().for_each(|at| at[5..].fill(32));
        Case {
            blocks: vec![full, part],
            bodies,
            drifts,
        }
    }

    /// All that `run` makes of the cases, to the last bit.
    fn outcome(run: impl Run, single: &Case<f32>, double: &Case<f64>, pace: Pace) -> [String; 3] {
        let (mut single, mut swept, mut moved) = (single.clone(), double.clone(), double.clone());
        let found = [
            run.single(single.sweep(0, pace)),
            run.double(swept.sweep(0, pace)),
        ];
        run.push(Push {
            blocks: &moved.blocks,
            bodies: &mut moved.bodies,
            latest: 1,
        });
        let mut verdicts = [Verdict::default(); 2];
        run.judge(Judge {
            blocks: &moved.blocks,
            bodies: &moved.bodies,
            drifts: &moved.drifts,
            latest: 1,
            verdicts: &mut verdicts,
        });
        // What empty lanes hold is nobody's.
        verdicts[1]
            .iter_mut()
            .for_each(|lanes| lanes[5..].fill(0.0));
        [
            format!("{:?} {single:?}", found[0]),
            format!("{:?} {swept:?}", found[1]),
            format!("{verdicts:?} {moved:?}"),
        ]
    }

    proptest! {
        #[test]
        fn wide_registers_give_the_same_bits(
            numbers in prop::collection::vec(-1.0..1.0f64, 16 * 47),
            momentum in 0.0..1.0f64,
        ) {
            let tolerance = Tolerance { gap: 0.5, slip: 0.5, force: 0.5 };
            let pace = Pace { momentum, damping: 0.9, strictness: 1.0, tolerance };
            let (single, double) = (case::<f32>(&numbers), case::<f64>(&numbers));
            let expected = outcome(Plain::<16>, &single, &double, pace);
            prop_assert_eq!(&outcome(Plain::<4>, &single, &double, pace), &expected);
            #[cfg(target_arch = "x86_64")]
            if let Some(lanes) = pulp::x86::V3::try_new() {
                prop_assert_eq!(&outcome(lanes, &single, &double, pace), &expected);
            }
            #[cfg(target_arch = "x86_64")]
            if let Some(lanes) = pulp::x86::V4::try_new() {
                prop_assert_eq!(&outcome(lanes, &single, &double, pace), &expected);
            }
        }
    }

    /// Contacts of neighbours in a cubic lattice of `side` spheres along an edge, on the ground.
    fn lattice<T: Real>(side: usize) -> Case<T> {
        let n = side * side * side;
        let still = Block {
            bodies: [[n as u32; 16]; 2],
            drift: STILL,
            ..Block::default()
        };
        let mut blocks: Vec<Block<T>> = Vec::new();
        // One of two contacts in a line, so that those of a block share no body; then the others.
        for (axis, odd) in (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]) {
            let stride = side.pow(axis);
            let first = (0..n).filter(|i| {
                let along = i / stride % side;
                along % 2 == odd && along + 1 < side
            });
            for (k, i) in first.enumerate() {
                if k % 16 == 0 {
                    blocks.push(still);
                }
                let (block, lane) = (blocks.last_mut().expect("one was pushed"), k % 16);
                block.count += 1;
                for (at, body) in block.bodies.iter_mut().zip([i, i + stride]) {
                    at[lane] = body as u32;
                }
                block.normal[axis as usize][lane] = T::of(-1.0);
                block.bias[lane] = T::of(0.01 * (i * 7 % 13) as f64 - 0.03);
                block.friction[lane] = T::of(0.5);
                block.length[lane] = T::of(100.0);
                block.scale[lane] = T::of(1e-6);
            }
        }
        let body = [0.1, -0.1, -0.2, 0.9, 0.05, 0.0, 0.02, 2.2].map(T::of);
        let mut bodies = vec![Body(body); n];
        bodies.push(Body::default());
        Case {
            blocks,
            bodies,
            drifts: Vec::new(),
        }
    }

    /// Shortest time of a contact's update by `sweep` \[ns\].
    fn nanoseconds<T: Real>(side: usize, sweep: impl Fn(Sweep<T>) -> Progress) -> f64 {
        let mut case = lattice::<T>(side);
        let contacts: u32 = case.blocks.iter().map(|block| block.count).sum();
        let tolerance = Tolerance {
            gap: 1e-4,
            slip: 1e-4,
            force: 0.1,
        };
        let pace = Pace {
            momentum: 0.1,
            damping: 1.0,
            strictness: 1.0,
            tolerance,
        };
        let sweeps = 2 * (200_000 / contacts as usize).max(1);
        let times = (0..25).map(|_| {
            let start = std::time::Instant::now();
            for k in 0..sweeps {
                std::hint::black_box(sweep(case.sweep(k % 2, pace)));
            }
            start.elapsed().as_secs_f64() * 1e9 / (sweeps * contacts as usize) as f64
        });
        times.fold(f64::INFINITY, f64::min)
    }

    /// Prints what an update costs; docs/solvers.md, "Roofline".
    #[test]
    #[ignore = "a measurement: cargo test --release --lib update_costs -- --ignored --nocapture"]
    fn update_costs() {
        fn row(name: &str, run: impl Run) {
            for side in [10, 22, 46] {
                let single = nanoseconds::<f32>(side, |work| run.single(work));
                let double = nanoseconds::<f64>(side, |work| run.double(work));
                let n = side * side * side;
                println!("| {name} | {n} | {single:.1} | {double:.1} |");
            }
        }
        println!("| lanes | spheres | single ns | double ns |");
        #[cfg(target_arch = "x86_64")]
        if let Some(lanes) = pulp::x86::V4::try_new() {
            row("AVX-512", lanes);
        }
        #[cfg(target_arch = "x86_64")]
        if let Some(lanes) = pulp::x86::V3::try_new() {
            row("AVX2", lanes);
        }
        row("plain", Plain::<4>);
    }
}
