//! Runs of scenes that nobody tuned. [`Run`] checks momentum to 1e-9 and overlaps in every step; a run that goes on from a saved
//! state has the same bits, with any number of threads.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::contact::cohesion::Hold;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use crate::support::Run;

const MATERIALS: &str = r#"
[[material]]
name = "grain"
density = 2500.0
[[material]]
name = "wall"
"#;

pub fn scene(text: &str) -> Arc<Scene> {
    let materials = match text.contains("[[material]]") {
        true => "",
        false => MATERIALS,
    };
    let text = format!("{text}{materials}");
    let loaded = Scene::from_toml("scene", &text, Path::new(""));
    Arc::new(loaded.unwrap_or_else(|e| panic!("{}", e.plain())).scene)
}

pub fn start(scene: &Arc<Scene>) -> Run {
    let simulation = Simulation::new(Arc::clone(scene)).expect("a start");
    Run { simulation }
}

/// Runs for `count` communication steps, from half of which a saved state goes on in another simulation, with two threads.
pub fn check(text: &str, count: usize) -> Run {
    let scene = scene(text);
    let mut run = start(&scene);
    let mut unconverged = 0;
    let h = scene.settings.communication_step;
    let mut saved = None;
    for k in 0..count {
        if k == count / 2 {
            saved = Some(run.simulation.snapshot());
        }
        // Spheres that come and go have their momentum with them.
        match scene.sources.is_empty() && scene.sinks.is_empty() {
            true => run.advance(h),
            false => drop(run.simulation.advance(h).expect("a step")),
        }
        assert!(run.simulation.report().max_overlap <= scene.settings.tolerance.gap);
        unconverged += run.simulation.report().unconverged_steps;
    }
    assert_eq!(unconverged, 0);
    let mut other = Scene::clone(&scene);
    other.settings.threads = 2;
    let mut again = start(&Arc::new(other));
    again
        .simulation
        .restore(&saved.unwrap())
        .expect("its state");
    for _ in count / 2..count {
        again.simulation.advance(h).expect("a step");
    }
    assert!(again.simulation.snapshot() == run.simulation.snapshot());
    run
}

/// Contacts that are held so.
pub fn held(run: &Run, by: impl Fn(&Hold) -> bool) -> usize {
    let contacts = run.simulation.contacts();
    contacts.iter().filter(|c| by(&c.hold)).count()
}

/// Of a rock of 4 x 3 x 4 bonded grains, some bonds have broken and some hold, and none is missing.
pub fn broken_in_part(run: &Run) {
    let whole = held(run, Hold::is_bond);
    let broken = run.simulation.state().broken_bonds as usize;
    assert_eq!(whole + broken, 3 * 3 * 4 + 4 * 2 * 4 + 4 * 3 * 3);
    assert!(broken > 5 && whole > 5, "{broken} broken, {whole} whole");
}
