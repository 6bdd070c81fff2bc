//! A steady step takes no memory that grows with the scene.

use std::alloc::{GlobalAlloc, Layout, System};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

/// Bytes from which a request counts: a number for each of the thousand spheres is more.
const LARGE: usize = 4096;

static COUNT: AtomicUsize = AtomicUsize::new(0);

/// The system's allocator, which counts large requests.
struct Counting;

// SAFETY: all calls go to the system's allocator as they come.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.size() >= LARGE {
            COUNT.fetch_add(1, Ordering::Relaxed);
        }
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Internal steps of a communication step: what a whole communication step keeps to go back to is not counted.
#[test]
fn a_steady_step_takes_no_memory() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/dropped/dropped.toml");
    let mut scene = Scene::from_file(file).expect("a scene").scene;
    scene.settings.step = 1e-3;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
    simulation.advance_to(0.5).expect("a step");
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
