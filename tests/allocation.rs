//! A steady step takes no memory that grows with the scene, and neither do states that are kept.

use std::alloc::{GlobalAlloc, Layout, System};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

/// Bytes from which a request counts: a number for each of the thousand spheres is more.
const LARGE: usize = 4096;

static COUNT: AtomicUsize = AtomicUsize::new(0);
/// Bytes in use.
static USED: AtomicUsize = AtomicUsize::new(0);

/// One test at a time: the counters are those of the process.
static ALONE: Mutex<()> = Mutex::new(());

/// The system's allocator, which counts large requests.
struct Counting;

// SAFETY: all calls go to the system's allocator as they come.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.size() >= LARGE {
            COUNT.fetch_add(1, Ordering::Relaxed);
        }
        USED.fetch_add(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        USED.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The bed of 1000 spheres.
fn bed() -> Simulation {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/dropped/dropped.toml");
    let mut scene = Scene::from_file(file).expect("a scene").scene;
    scene.settings.step = 1e-3;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    simulation.advance_to(0.5).expect("a step");
    simulation
}

/// Internal steps of a communication step: what a whole communication step keeps to go back to is not counted.
#[test]
fn a_steady_step_takes_no_memory() {
    let _alone = ALONE.lock().expect("no test has failed");
    let mut simulation = bed();
    let mut march = simulation.begin(0.6).expect("a step");
    let mut counts = Vec::new();
    while !march.is_done() {
        let before = COUNT.load(Ordering::Relaxed);
        simulation.internal_step(&mut march).expect("a step");
        counts.push(COUNT.load(Ordering::Relaxed) - before);
    }
    assert_eq!(counts.len(), 100);
    assert!(simulation.contacts().len() > 1000);
    // Neighbours are listed anew now and then, and lists that have never been so long grow.
    counts.sort_unstable();
    assert_eq!(counts[50], 0, "{counts:?}");
}

/// A state costs what a step changes, not what it holds: keeping and restoring copies no array, and dropping a state gives back all
/// that no other holds.
#[test]
fn states_share_what_no_step_has_changed() {
    let _alone = ALONE.lock().expect("no test has failed");
    let mut simulation = bed();
    let before = COUNT.load(Ordering::Relaxed);
    let kept: Vec<_> = (0..100).map(|_| simulation.save()).collect();
    for one in &kept {
        simulation.load(one);
    }
    assert_eq!(COUNT.load(Ordering::Relaxed), before);
    drop(kept);
    let first = simulation.save();
    let expected = simulation.snapshot();
    let mut held = Vec::new();
    simulation.advance(1e-3).expect("a step");
    simulation.advance(1e-3).expect("a step");
    let used = USED.load(Ordering::Relaxed);
    for _ in 0..8 {
        held.push(simulation.save());
        simulation.advance(1e-3).expect("a step");
    }
    let size = expected.len();
    assert!(USED.load(Ordering::Relaxed) > used + 6 * size / 2);
    assert_eq!(first.snapshot(), expected, "later steps leave it as it was");
    drop(held);
    // Lists of neighbours and contacts grow and shrink.
    let left = USED.load(Ordering::Relaxed).saturating_sub(used);
    assert!(left < 2 * size, "{left} B left of states of {size} B");
    let after = simulation.snapshot();
    simulation.load(&first);
    assert_eq!(simulation.snapshot(), expected);
    for _ in 0..10 {
        simulation.advance(1e-3).expect("a step");
    }
    assert_eq!(simulation.snapshot(), after);
}
