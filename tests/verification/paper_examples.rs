//! The paper's two examples (reconstructions): whatever the penalty starts from, the overlap stays within the
//! tolerance in every step and no sphere passes a boundary.
//!
//! The short versions run with the other tests; the whole examples by
//! `cargo test --release --test verification -- --ignored`.

use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;
use sphere_dda::solver::SolverKind;

/// Runs an example with the direct solver and the penalty times `factor`; `inside` says of a sphere's centre and
/// radius whether it is where a boundary lets it be.
fn run(path: &str, factor: f64, duration: f64, inside: impl Fn(Vec3, f64) -> bool) {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let mut scene = Scene::from_file(file).expect("the example loads").scene;
    scene.settings.solver = SolverKind::Direct;
    scene.settings.penalty = scene.settings.penalty.map(|p| p * factor);
    let radius = scene.particles.radius.clone();
    let h = scene.settings.communication_step;
    let mut simulation = Simulation::new(Arc::new(scene)).expect("the example starts");
    let mut augmentations = 0;
    for k in 1..=(duration / h).round() as u64 {
        let report = simulation
            .advance_to(k as f64 * h)
            .expect("the step converges");
        augmentations += report.augmentations;
        assert!(
            report.max_overlap <= 1e-6,
            "t = {}: {:e}",
            simulation.time(),
            report.max_overlap
        );
        for (&x, &r) in simulation.kinematics().position.iter().zip(&radius) {
            assert!(
                inside(x, r),
                "t = {}: a sphere of radius {r} is at {x:?}",
                simulation.time()
            );
        }
    }
    assert!(
        augmentations > 0,
        "the augmented-Lagrangian loop did the work"
    );
}

/// Centres stay above the cone `rho = 0.7 + z` (half-angle 45 degrees), by their radius, while between its
/// outlet and its mouth.
fn in_funnel(x: Vec3, r: f64) -> bool {
    let rho = x.xy().norm();
    let height = (x.z + 0.7 - rho) / 2f64.sqrt();
    let beside_the_face = x.z - height / 2f64.sqrt() > 0.0 && x.z - height / 2f64.sqrt() < 3.3;
    x.z > 3.3 || x.z < 0.0 || !beside_the_face || height >= r * (1.0 - 2e-6)
}

/// Centres stay above the profile of the five planes and between the side walls.
fn on_slopes(x: Vec3, r: f64) -> bool {
    let mut low = f64::INFINITY;
    let (mut px, mut pz) = (0.0, 220.286_410_608);
    for degrees in [10.0f64, 8.0, 6.0, 4.0, 2.0, 0.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        low = low.min((x.x - px) * sin + (x.z - pz) * cos);
        px += 422.0 * cos;
        pz -= 422.0 * sin;
    }
    let wall = r * (1.0 - 2e-6);
    low >= wall && x.y >= wall && 80.0 - x.y >= wall
}

const FUNNEL: &str = "examples/funnel/funnel.toml";
const SLOPES: &str = "examples/slopes/slopes.toml";

#[test]
fn funnel_starts_with_any_penalty() {
    for factor in [0.01, 1.0, 100.0] {
        run(FUNNEL, factor, 0.6, in_funnel);
    }
}

#[test]
fn slopes_start_with_any_penalty() {
    for factor in [0.01, 1.0, 100.0] {
        run(SLOPES, factor, 4.0, on_slopes);
    }
}

#[test]
#[ignore = "minutes; see the module's text"]
fn funnel_with_any_penalty() {
    for factor in [0.01, 1.0, 100.0] {
        run(FUNNEL, factor, 8.6, in_funnel);
    }
}

#[test]
#[ignore = "minutes; see the module's text"]
fn slopes_with_any_penalty() {
    for factor in [0.01, 1.0, 100.0] {
        run(SLOPES, factor, 63.0, on_slopes);
    }
}
