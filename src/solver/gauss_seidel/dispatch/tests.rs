//! All kinds of lanes compared, and what they cost.

#![cfg(test)]

use super::*;
use crate::problem::{Law, Row, SphereContact};
use crate::solver::Tolerance;
use crate::solver::bodies::probe_row;
use crate::solver::gauss_seidel::batch::{Extra, PLAIN};
use proptest::prelude::*;

/// One kind of lanes.
trait Run: Copy {
    fn single(self, work: Sweep<f32>) -> Progress;
    fn double(self, work: Sweep<f64>) -> Progress;
    fn fill(self, work: Fill<f32>);
    fn push(self, work: Push<f32>);
    fn judge(self, work: Judge<f64>) -> Residual;
}

macro_rules! run {
    ($lanes:ty, |$l:ident, $work:ident| $run:expr) => {
        run!($lanes, |$l, $work| $run, single: Sweep<f32> => Progress, double: Sweep<f64> => Progress, fill: Fill<f32> => (), push: Push<f32> => (), judge: Judge<f64> => Residual);
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

run!(Plain<4, false>, |lanes, work| work.with(lanes));
run!(Plain<4, true>, |lanes, work| work.with(lanes));
run!(Plain<16, true>, |lanes, work| work.with(lanes));
#[cfg(target_arch = "x86_64")]
run!(pulp::x86::V3, |lanes, work| lanes
    .vectorize(Job { work, lanes }));
#[cfg(target_arch = "x86_64")]
run!(pulp::x86::V4, |lanes, work| lanes
    .vectorize(Job { work, lanes }));

/// Blocks with their bodies.
#[derive(Debug, Clone)]
struct Case<T> {
    numbers: Vec<SphereContact>,
    rows: Vec<Sixteen<u32>>,
    blocks: Vec<Batch<T>>,
    unsettled: Vec<u16>,
    resistances: Vec<Resistances<T>>,
    sources: Vec<resistance::Source>,
    bodies: Vec<Body<T>>,
    extras: Vec<Extra<T>>,
    levers: Vec<Levers<T>>,
    exact_levers: Vec<Levers<f64>>,
    heavy: Vec<Heavy<T>>,
    exact_heavy: Vec<Heavy<f64>>,
}

impl<T> Case<T> {
    fn exact(&self) -> Exact<'_> {
        let source = Source {
            numbers: &self.numbers,
            step: 0.3,
            unit: 0.7,
        };
        Exact {
            source,
            rows: &self.rows,
            resistances: &self.sources,
            levers: &self.exact_levers,
            heavy: &self.exact_heavy,
        }
    }

    /// Some of the blocks as a group.
    fn group(&self, blocks: std::ops::Range<usize>) -> Group {
        let resisted = |end: usize| self.blocks[..end].iter().filter(|b| b.resisted).count();
        let resistances = resisted(blocks.start)..resisted(blocks.end);
        Group {
            blocks,
            resistances,
            bodies: 0..self.bodies.len(),
            form: Form::Levered,
        }
    }

    /// Over all blocks that are on no heavy body, or over those that are.
    fn sweep(&mut self, form: Form, latest: usize, pace: SweepParams) -> Sweep<'_, T> {
        let on_heavy = self.blocks.len() - self.heavy.len();
        let (others, own) = self.blocks.split_at_mut(on_heavy);
        let (of_others, of_own) = self.unsettled.split_at_mut(on_heavy);
        let ((blocks, unsettled), resistances) = match form {
            Form::Heavy => ((own, of_own), &mut [][..]),
            _ => ((others, of_others), &mut self.resistances[..]),
        };
        Sweep {
            blocks,
            unsettled,
            resistances,
            bodies: &mut self.bodies,
            extras: &self.extras,
            levers: &self.levers,
            heavy: &self.heavy,
            form,
            latest,
            pace,
        }
    }
}

/// Four blocks of 32 bodies from numbers in -1..1. Some contacts of the first have resistances; the second is not full, and its
/// ground moves; the third has levers, resistances, masses that depend on the direction and a body that contacts share, once as A; the
/// fourth, which is not full, is on a heavy body. The last body never moves.
fn case<T: Real>(numbers: &[f64]) -> Case<T> {
    let mut source = numbers.iter().cycle().map(|&x| T::of(x));
    let mut sixteen =
        || -> Sixteen<T> { std::array::from_fn(|_| source.next().unwrap_or_default()) };
    let mut vector = || [sixteen(), sixteen(), sixteen()];
    let mut full = Batch {
        normal: vector(),
        impulse: [vector(), vector()],
        friction: std::array::from_fn(|k| T::of(0.1 * k as f64)),
        bodies: [0, 16].map(|first| std::array::from_fn(|k| first + k as u32)),
        count: 16,
        extra: PLAIN,
        levers: PLAIN,
        heavy: PLAIN,
        resisted: true,
        ..Batch::default()
    };
    let mut drift = vector();
    drift.iter_mut().for_each(|x| x[5..].fill(T::of(0.0)));
    let mut compliance = [vector()[0], vector()[1]].map(|c| c.map(|c| c * c));
    compliance.iter_mut().for_each(|c| c[5..].fill(T::of(0.0)));
    let extras = vec![Extra {
        velocity: drift,
        compliance,
    }];
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
    let compact = (0..21).map(|_| SphereContact(std::array::from_fn(|k| sixteen()[k].exact())));
    let numbers = compact.collect();
    let rows = [0, 16, 5, 9].map(|first| std::array::from_fn(|k| (first + k as u32) % 21));
    let mut part = Batch {
        count: 5,
        extra: 0,
        resisted: false,
        ..full
    };
    part.clear_from(5);
    let impulses = part.impulse.iter_mut().flatten();
    impulses.for_each(|lanes| lanes[5..].fill(T::default()));
    part.bodies.iter_mut().for_each(|at| at[5..].fill(32));
    let mut own = resistance::Source::default();
    let impulses: Vec<Vec3> = (0..16)
        .map(|lane| {
            let mut number = |k: usize| sixteen()[k].exact();
            let row = Row {
                prescribed_velocity: Vec3::new(number(0), number(1), number(2)),
                radius: 1.0 + 0.5 * number(3),
                ..probe_row(Law::Resistance {
                    contact: 0,
                    rolling: number(4).abs(),
                    twisting: number(5).abs(),
                })
            };
            if lane % 3 != 1 {
                own.set(lane, (lane as u32, &row), [1.3, 0.7]);
            }
            Vec3::new(number(6), number(7), number(8))
        })
        .collect();
    let mut exact =
        || -> Vector<f64> { [sixteen(), sixteen(), sixteen()].map(|x| x.map(T::exact)) };
    let levers = Levers {
        arms: [exact(), exact()],
        turns: [exact(), exact()].map(|[x, y, z]| [x, y, z, y, z, x]),
        bounds: [exact(), exact()].map(|[a, b, _]| [a, b].map(|x| x.map(|x| 1.0 + x * x))),
        masses: [exact(), exact()].map(|[x, y, z]| [y, z, x, x, y, z]),
        directed: true,
        shared: Some((17, 0.3)),
    };
    let mut levered = Batch { levers: 0, ..full };
    for lane in [3, 4, 9, 14] {
        levered.bodies[1][lane] = 17;
    }
    (levered.bodies[0][7], levered.bodies[1][7]) = (17, 23);
    let heavy = Heavy {
        at: 30,
        arms: exact(),
        bounds: [0, 1].map(|k| exact()[k].map(|x| 1.0 + x * x)),
        mass: [2.0, 1.0, 1.5, 0.2, -0.3, 0.1],
        turn: [0.3, 0.5, 0.4, 0.1, 0.2, -0.1],
    };
    let mut on_heavy = Batch { heavy: 0, ..part };
    on_heavy.bodies[1].fill(30);
    let mut resistances = Resistances::default();
    resistances.fill(&own, &impulses, 0.7);
    let mut scaled = Levers::default();
    levers.write(0.8, &mut scaled);
    let mut scaled_heavy = Heavy::default();
    heavy.write(&heavy.bounds, 0.8, &mut scaled_heavy);
    Case {
        numbers,
        rows: rows.to_vec(),
        blocks: vec![full, part, levered, on_heavy],
        unsettled: vec![0; 4],
        resistances: vec![resistances; 2],
        sources: vec![own; 2],
        bodies,
        extras,
        levers: vec![scaled],
        exact_levers: vec![levers],
        heavy: vec![scaled_heavy],
        exact_heavy: vec![heavy],
    }
}

/// All that `run` makes of the cases, to the last bit.
fn outcome(
    run: impl Run,
    single: &Case<f32>,
    double: &Case<f64>,
    pace: SweepParams,
) -> [String; 3] {
    let (mut filled, mut moved) = (single.clone(), double.clone());
    run.fill(Fill {
        exact: double.exact(),
        blocks: &mut filled.blocks,
        impulses: &double
            .numbers
            .iter()
            .map(|x| Vec3::from_column_slice(&x.0[..3]))
            .collect::<Vec<_>>(),
    });
    run.push(Push {
        exact: single.exact(),
        blocks: (&single.blocks, &single.resistances),
        bodies: &mut moved.bodies,
        latest: 1,
    });
    let (mut single, mut swept) = (single.clone(), double.clone());
    let found = [Form::Levered, Form::Heavy].map(|form| {
        (
            run.single(single.sweep(form, 0, pace)),
            run.double(swept.sweep(form, 0, pace)),
        )
    });
    let judged = [0..1, 1..2, 2..3, 3..4, 0..4].map(|blocks| {
        let group = double.group(blocks.clone());
        run.judge(Judge {
            exact: double.exact().of(&group),
            blocks: (
                &double.blocks[blocks],
                &double.resistances[group.resistances],
            ),
            bodies: &moved.bodies,
            extras: &double.extras,
            latest: 1,
        })
    });
    [
        format!("{:?} {single:?}", found.map(|(found, _)| found)),
        format!("{:?} {swept:?}", found.map(|(_, found)| found)),
        format!("{judged:?} {moved:?} {filled:?}"),
    ]
}

fn pace(momentum: f64) -> SweepParams {
    let tolerance = Tolerance {
        gap: 0.5,
        slip: 0.5,
        force: 0.5,
    };
    SweepParams {
        momentum,
        damping: 0.9,
        strictness: 1.0,
        tolerance,
    }
}

proptest! {
    #[test]
    fn wide_registers_give_the_same_bits(
        numbers in prop::collection::vec(-1.0..1.0f64, 16 * 259),
        momentum in 0.0..1.0f64,
    ) {
        let pace = pace(momentum);
        let (single, double) = (case::<f32>(&numbers), case::<f64>(&numbers));
        let expected = outcome(Plain::<16, true>, &single, &double, pace);
        prop_assert_eq!(&outcome(Plain::<4, true>, &single, &double, pace), &expected);
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

proptest! {
    /// What runs where nothing can be fused.
    #[test]
    fn without_fusion_all_is_the_same_but_for_rounding(
        numbers in prop::collection::vec(-1.0..1.0f64, 16 * 259),
        momentum in 0.0..1.0f64,
    ) {
        let pace = pace(momentum);
        let mut cases = [case::<f64>(&numbers), case::<f64>(&numbers)];
        for form in [Form::Levered, Form::Heavy] {
            Plain::<4, true>.double(cases[0].sweep(form, 0, pace));
            Plain::<4, false>.double(cases[1].sweep(form, 0, pace));
        }
        let impulses = cases[0].blocks.iter().flat_map(|block| block.impulse.as_flattened());
        let largest = impulses.flatten().fold(1.0, |most, p| p.abs().max(most));
        let [a, b] = cases.map(|case| case.bodies);
        for (a, b) in a.iter().zip(&b).flat_map(|(a, b)| a.0.iter().zip(b.0)) {
            // The direction of a short slip magnifies rounding by 1 over its length.
            prop_assert!((a - b).abs() < 1e-8 * largest, "{} and {}, {}", a, b, largest);
        }
    }
}

/// Contacts of neighbours in a cubic lattice of `side` spheres along an edge, on the ground.
fn lattice<T: Real>(side: usize) -> Case<T> {
    let n = side * side * side;
    let still = Batch {
        bodies: [[n as u32; 16]; 2],
        extra: PLAIN,
        levers: PLAIN,
        heavy: PLAIN,
        ..Batch::default()
    };
    let mut blocks: Vec<Batch<T>> = Vec::new();
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
        numbers: Vec::new(),
        rows: Vec::new(),
        unsettled: vec![0; blocks.len()],
        blocks,
        resistances: Vec::new(),
        sources: Vec::new(),
        bodies,
        extras: Vec::new(),
        levers: Vec::new(),
        exact_levers: Vec::new(),
        heavy: Vec::new(),
        exact_heavy: Vec::new(),
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
    let pace = SweepParams {
        momentum: 0.1,
        damping: 1.0,
        strictness: 1.0,
        tolerance,
    };
    let sweeps = 2 * (200_000 / contacts as usize).max(1);
    let times = (0..25).map(|_| {
        let start = std::time::Instant::now();
        for k in 0..sweeps {
            std::hint::black_box(sweep(case.sweep(Form::Spheres, k % 2, pace)));
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
    row("plain", Plain::<4, false>);
}
