//! Results of a real run: the start of the funnel, through the solver. Its frames are left for the Python readers.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::observe::Observation;
use sphere_dda::results::writer::{Options, Results};
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use crate::made::{listed, place};

/// Simulated time \[s\]: the lower layer has reached the cone and carries forces. The whole run is made by setting
/// the variable to its duration.
const TIME: &str = "SPHERE_DDA_FUNNEL_TIME";

#[test]
fn the_funnel_writes_a_run() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/funnel/funnel.toml");
    let scene = Arc::new(Scene::from_file(path).unwrap().scene);
    let duration: f64 = std::env::var(TIME).map_or(0.5, |text| text.parse().unwrap());
    let directory = place("vtk-funnel");
    let mut results = Results::create(&scene, Options::new(&directory, &scene)).unwrap();
    let mut simulation = Simulation::new(Arc::clone(&scene)).unwrap();
    results.record(&Observation::of(&simulation));
    let h = scene.settings.communication_step;
    let steps = (duration / h).round() as u32;
    for k in 1..=steps {
        simulation.advance_to(h * f64::from(k)).unwrap();
        results.record(&Observation::of(&simulation));
    }
    let status = results.finish();
    assert_eq!(status.failures, 0, "{status:?}");
    assert_eq!(status.rows, u64::from(steps) + 1);
    let frames = listed(&directory.join("contacts.pvd"));
    assert_eq!(frames.len(), (duration / 0.1).round() as usize + 1);

    let mut table = csv::Reader::from_path(directory.join("history.csv")).unwrap();
    let names = table.headers().unwrap().clone();
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    let mass: f64 = scene.particles.mass.iter().sum();
    for record in table.records() {
        let record = record.unwrap();
        let value = |name: &str| -> f64 { record[column(name)].parse().unwrap() };
        // A box that ends at the plane where the flow is counted: what is not inside has passed.
        let kept = value("sensor.content.mass [kg]") + value("sensor.discharge.mass [kg]");
        assert!((kept - mass).abs() < 1e-9 * mass);
        assert!(value("maxOverlap [-]") <= scene.settings.tolerance.gap);
        assert!(value("dissipatedEnergy [J]") >= -1e-9 * value("potentialEnergy [J]").abs());
    }
}
