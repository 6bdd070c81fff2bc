//! Time of each stage of a step, of snapshots and of frames, on beds caught in motion and settled.
//!
//! `cargo bench --bench stages [-- FILTER] [--sample-count 20]`; *items* are spheres, rows or updates of rows, as each stage says. Beds are those of
//! `examples/dropped` on a lattice that holds exactly so many spheres; they are settled on first use, which takes a minute
//! for the large one. Under `cargo test --benches` every stage runs once, on a small bed.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::hint::black_box;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use divan::Bencher;
use divan::counter::{BytesCount, ItemsCount};
use sphere_dda::detection::broad_phase::NeighborList;
use sphere_dda::detection::configuration::{Candidate, Configuration};
use sphere_dda::detection::detection_distance::DetectionDistance;
use sphere_dda::formats::vtu::{Precision, encode};
use sphere_dda::observe::Observation;
use sphere_dda::results::frames::{Surface, frame};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::{CommunicationStep, Simulation};
use sphere_dda::solver::gauss_seidel::{self, Kernel};
use sphere_dda::solver::{Params, Report};
use sphere_dda::solver::{SolverKind, Tolerance};

/// Internal step \[s\] of every stage, and of beds at rest: the tolerances of shorter steps leave speeds with which few fall asleep.
const STEP: f64 = 5e-4;
const RESTING_STEP: f64 = 2e-3;
/// Lattices of 1000 and of 10 000 spheres, and the one of tests.
const LATTICES: [[usize; 3]; 2] = [[25, 10, 4], [40, 25, 10]];
const SMALL: [usize; 3] = [5, 5, 4];
const PITCH: f64 = 0.025;
/// When a bed is caught \[s\]: while its upper layers still fall, and when nothing moves to speak of.
const MOVING_AT: f64 = 0.15;
const SETTLED_AT: f64 = 1.0;
/// Speed below which a settled bed comes to rest \[m/s\], and by when it has \[s\]. A sphere that touches nothing but the floor spins on about
/// the vertical for ever: the speed is above that.
const REST_SPEED: f64 = 1.0;
const REST_BY: f64 = 3.0;
/// Steps before the one whose problem is solved.
const WARMING: usize = 10;
const MOST_SWEEPS: usize = 100_000;

fn main() {
    divan::main();
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum When {
    Moving,
    Settled,
    Resting,
}

/// Which bed, and when it is caught.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Bed {
    lattice: [usize; 3],
    when: When,
}

impl fmt::Display for Bed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:?}", self.spheres(), self.when)
    }
}

fn beds(list: &[When]) -> Vec<Bed> {
    // Only `cargo bench` says so.
    let measured = std::env::args().any(|word| word == "--bench");
    let lattices = if measured { &LATTICES[..] } else { &[SMALL] };
    let of = |&lattice: &[usize; 3]| list.iter().map(move |&when| Bed { lattice, when });
    lattices.iter().flat_map(of).collect()
}

/// Beds whose spheres move, fast or slowly.
fn awake() -> Vec<Bed> {
    beds(&[When::Moving, When::Settled])
}

fn all() -> Vec<Bed> {
    beds(&[When::Moving, When::Settled, When::Resting])
}

impl Bed {
    fn spheres(&self) -> usize {
        self.lattice.iter().product()
    }

    fn scene(&self) -> Scene {
        let [nx, ny, _] = self.lattice;
        let [bx, by] = [nx, ny].map(|n| 0.5 * PITCH * n as f64);
        let [x, y] = [bx, by].map(|b| 0.5 * PITCH - b);
        let step = match self.when {
            When::Moving | When::Settled => STEP,
            When::Resting => RESTING_STEP,
        };
        let text = format!(
            "[simulation]\nduration = 1.0\nstep = {step}\nfixed_step = true\nstrict = true\ntolerance = {{ gap = 1e-4, slip = 1e-4, force = 1e-1, opening = 0 }}\n\
             [[material]]\nname = 'glass'\ndensity = 2500.0\n[pair_default]\nfriction = 0.5\n\
             [[spheres]]\nname = 'bed'\nmaterial = 'glass'\nradius = 0.01\nradius_jitter = 0.1\nseed = 1\n\
             lattice = {{ origin = [{x}, {y}, 0.0125], count = {:?}, spacing = {PITCH}, jitter = 0.056 }}\n\
             [[boundary]]\nname = 'box'\nmaterial = 'glass'\nfaces = [\n\
             {{ plane = {{ point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }} }},\n\
             {{ plane = {{ point = [-{bx}, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }} }},\n\
             {{ plane = {{ point = [{bx}, 0.0, 0.0], normal = [-1.0, 0.0, 0.0] }} }},\n\
             {{ plane = {{ point = [0.0, -{by}, 0.0], normal = [0.0, 1.0, 0.0] }} }},\n\
             {{ plane = {{ point = [0.0, {by}, 0.0], normal = [0.0, -1.0, 0.0] }} }} ]\n",
            self.lattice
        );
        let loaded = Scene::from_toml("bed", &text, Path::new("."));
        let mut scene = loaded.expect("a good scene").scene;
        if self.when == When::Resting {
            scene.settings.rest_speed = REST_SPEED;
        }
        scene
    }

    /// The bed as it was caught.
    fn simulation(self) -> Simulation {
        // What was caught of beds so far.
        static CAUGHT: Mutex<BTreeMap<Bed, Vec<u8>>> = Mutex::new(BTreeMap::new());
        let known = |bed| {
            let caught = CAUGHT.lock().unwrap_or_else(PoisonError::into_inner);
            caught.get(bed).cloned()
        };
        let mut simulation = start(self.scene());
        let blob = known(&self).unwrap_or_else(|| {
            let blob = self.catch();
            let mut caught = CAUGHT.lock().unwrap_or_else(PoisonError::into_inner);
            caught.insert(self, blob.clone());
            blob
        });
        simulation.restore(&blob).expect("its own snapshot");
        simulation
    }

    /// Runs the bed until it is to be caught.
    fn catch(self) -> Vec<u8> {
        let mut simulation = start(self.scene());
        if self.when == When::Settled {
            let moving = Self {
                when: When::Moving,
                ..self
            };
            let caught = moving.simulation().snapshot();
            simulation.restore(&caught).expect("the same");
        }
        let end = match self.when {
            When::Moving => MOVING_AT,
            When::Settled => SETTLED_AT,
            When::Resting => REST_BY,
        };
        let rests = |simulation: &Simulation| {
            let velocity = &simulation.kinematics().velocity;
            self.when == When::Resting && velocity.iter().all(|v| v.norm_squared() == 0.0)
        };
        while simulation.time() < end && !rests(&simulation) {
            let next = (simulation.time() + 0.01).min(end);
            simulation.advance_to(next).expect("a step");
        }
        assert!(
            self.when != When::Resting || rests(&simulation),
            "{self} moves at {REST_BY} s"
        );
        simulation.snapshot()
    }
}

fn start(scene: Scene) -> Simulation {
    Simulation::new(Arc::new(scene)).expect("a start")
}

/// What each sphere can move in a step, and a little \[m\]: how far pairs are looked for.
fn reaches(simulation: &Simulation) -> Vec<f64> {
    let (kinematics, radius) = (
        simulation.kinematics(),
        &simulation.scene().particles.radius,
    );
    let speeds = kinematics.velocity.iter().map(|v| v.norm() + 9.81 * STEP);
    let reaches = speeds.zip(radius).map(|(v, r)| v * STEP + 1e-3 * r);
    reaches.collect()
}

fn placed(simulation: &Simulation) -> Configuration<'_> {
    let state = simulation.state();
    Configuration::of(simulation.scene(), &state.kinematics, &state.poses)
}

fn neighbours(simulation: &Simulation, reach: &[f64]) -> NeighborList {
    let mut list = NeighborList::default();
    let reach = reach.iter().map(|&reach| DetectionDistance {
        pairs: reach,
        boundaries: reach,
    });
    list.ensure(&placed(simulation), &reach.collect::<Vec<_>>(), 0.0);
    list
}

/// The list of pairs within the skin, built anew; items: spheres.
#[divan::bench(args = awake())]
fn neighbour_list(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    let reach = reaches(&simulation);
    let items = ItemsCount::new(bed.spheres());
    bencher
        .counter(items)
        .bench_local(|| neighbours(&simulation, &reach));
}

/// Candidates of the listed pairs; items: spheres.
#[divan::bench(args = awake())]
fn narrow_phase(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    let reach = reaches(&simulation);
    let list = neighbours(&simulation, &reach);
    let now = placed(&simulation);
    let mut found: Vec<Candidate> = Vec::new();
    let items = ItemsCount::new(bed.spheres());
    bencher.counter(items).bench_local(|| {
        now.candidates(
            black_box(&list),
            |i, j| reach[i as usize] + reach[j as usize],
            |i, _| reach[i as usize],
            &mut found,
        );
        found.len()
    });
}

/// Both and the rows of the problem, in new memory; items: rows.
#[divan::bench(args = awake())]
fn problem(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    let rows = simulation.problem(STEP).expect("a problem").0.rows.len();
    let items = ItemsCount::new(rows);
    bencher
        .counter(items)
        .bench_local(|| simulation.problem(STEP).expect("a problem"));
}

/// A solve by sweeps, from the warm start of a step, to a tolerance of gap and slip of `1e-EXPONENT`; items: rows times sweeps.
#[divan::bench(args = awake(), consts = [4, 6], sample_size = 1, max_time = 5)]
fn gauss_seidel<const EXPONENT: i32>(bencher: Bencher, bed: &Bed) {
    let length = 10_f64.powi(-EXPONENT);
    let tolerance = Tolerance {
        gap: length,
        slip: length,
        force: 0.1,
    };
    let mut scene = bed.scene();
    scene.settings.tolerance = tolerance;
    let mut simulation = start(scene);
    let blob = bed.simulation().snapshot();
    simulation.restore(&blob).expect("its own snapshot");
    // Beds are caught at one tolerance: steps at this one make the start what it is in a run.
    for _ in 0..WARMING {
        simulation.advance(STEP).expect("a step");
    }
    let (problem, warm) = simulation.problem(STEP).expect("a problem");
    let params = Params {
        kind: SolverKind::GaussSeidel,
        tolerance,
        accept: false,
        min_sweeps: 1,
        max_sweeps: MOST_SWEEPS,
        max_factorizations: 0,
        penalty: 0.0,
        adapt_penalty: false,
        smoothing: 0,
    };
    let mut kernel = Kernel::default();
    let radii = simulation.scene().particles.radius.iter().copied();
    let diameter = 2.1 * radii.fold(0.0, f64::max);
    let mut solve = |impulses: &mut [sphere_dda::Vec3]| -> Report {
        kernel.prepare(
            &simulation.kinematics().position,
            diameter,
            std::iter::empty(),
        );
        gauss_seidel::solve(&problem, &params, &mut kernel, impulses)
    };
    let report = solve(&mut warm.clone());
    assert!(report.converged, "{bed}: {report:?}");
    bencher
        .counter(ItemsCount::new(problem.rows.len() * report.sweeps.max(1)))
        .with_inputs(|| warm.clone())
        .bench_local_refs(|impulses| solve(impulses));
}

/// A whole internal step, as every next one: memory and neighbours are there; items: spheres.
#[divan::bench(args = all(), sample_size = 1)]
fn step(bencher: Bencher, bed: &Bed) {
    let simulation = RefCell::new(bed.simulation());
    let blob = simulation.borrow().snapshot();
    // One step beforehand leaves its memory.
    let begin = || -> CommunicationStep {
        let mut simulation = simulation.borrow_mut();
        simulation.restore(&blob).expect("its own snapshot");
        let end = simulation.time() + STEP;
        simulation.begin(end).expect("a step")
    };
    let take = |march: &mut CommunicationStep| {
        simulation
            .borrow_mut()
            .internal_step(march)
            .expect("a step")
    };
    take(&mut begin());
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .with_inputs(begin)
        .bench_local_refs(take);
}

/// A communication step of one internal step: that, and the state that is kept to go back to; items: spheres.
#[divan::bench(args = all(), sample_size = 1)]
fn advance(bencher: Bencher, bed: &Bed) {
    let simulation = RefCell::new(bed.simulation());
    let blob = simulation.borrow().snapshot();
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .with_inputs(|| {
            let mut simulation = simulation.borrow_mut();
            simulation.restore(&blob).expect("its own snapshot");
        })
        .bench_local_refs(|()| simulation.borrow_mut().advance(STEP).expect("a step"));
}

/// The state as bytes; items: spheres.
#[divan::bench(args = awake())]
fn snapshot(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .counter(BytesCount::new(simulation.snapshot().len()))
        .bench_local(|| simulation.snapshot());
}

/// The state from bytes; items: spheres.
#[divan::bench(args = awake())]
fn restore(bencher: Bencher, bed: &Bed) {
    let mut simulation = bed.simulation();
    let blob = simulation.snapshot();
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .counter(BytesCount::new(blob.len()))
        .bench_local(|| {
            simulation
                .restore(black_box(&blob))
                .expect("its own snapshot")
        });
}

/// Grids of all series, which the simulation waits for; items: spheres.
#[divan::bench(args = awake())]
fn vtu_grids(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    let surface = Surface::new(simulation.scene());
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .bench_local(|| frame(&Observation::of(&simulation), &surface));
}

/// Files of the grids, which the writer makes in the background; items: spheres.
#[divan::bench(args = awake())]
fn vtu_files(bencher: Bencher, bed: &Bed) {
    let simulation = bed.simulation();
    let time = simulation.time();
    let grids = frame(
        &Observation::of(&simulation),
        &Surface::new(simulation.scene()),
    );
    let write = || -> Vec<Vec<u8>> {
        let files = grids.iter().map(|(series, grid)| {
            encode(grid, time, Precision::Single, series.name()).expect("a good grid")
        });
        files.collect()
    };
    let bytes: usize = write().iter().map(Vec::len).sum();
    bencher
        .counter(ItemsCount::new(bed.spheres()))
        .counter(BytesCount::new(bytes))
        .bench_local(write);
}
