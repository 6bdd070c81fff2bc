//! Sources and sinks.

use sphere_dda::observe::Observation;
use sphere_dda::observe::energy::Momentum;
use sphere_dda::results::frames;
use sphere_dda::simulation::Simulation;

use crate::simulation;

/// Spheres of 1 kg each rain into a sink 2 m below; `{}` is the body of the source.
fn rain(source: &str) -> Simulation {
    simulation(&format!(
        r#"
[simulation]
duration = 4.0
step = 0.01
fixed_step = true
strict = true
tolerance = {{ gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }}
[[material]]
name = "steel"
density = 1909.859317102744 # 1 kg at radius 0.05 m
[[source]]
name = "hose"
material = "steel"
radius = 0.05
seed = 3
region = {{ box = {{ min = [-0.3, -0.3, 2.0], max = [0.3, 0.3, 2.4] }} }}
{source}
[[sink]]
name = "drain"
region = {{ beyond = {{ point = [0, 0, 0], normal = [0, 0, -1] }} }}
"#
    ))
}

fn present(simulation: &Simulation) -> usize {
    Observation::of(simulation).present().count()
}

#[test]
fn a_source_emits_its_rate_to_the_sphere() {
    // 20 spheres a second from 0.5 s on: floor(20 (t - 0.5)) at every time, whatever the step.
    for step in [0.01, 0.004, 0.1] {
        let mut simulation = rain("capacity = 100\nrate = 20\nstart = 0.5\nvelocity = [0, 0, 1]");
        for k in 1..=10 {
            let t = f64::from(k) * 0.1;
            while simulation.time() < t - 1e-9 {
                simulation
                    .advance_to((simulation.time() + step).min(t))
                    .unwrap();
            }
            let due = (20.0 * (t - 0.5) + 1e-6).floor().max(0.0);
            assert_eq!(present(&simulation) as f64, due, "t = {t}, step = {step}");
            assert!((simulation.state().emitted[0] - due).abs() < 1e-12);
        }
    }
}

#[test]
fn a_source_of_mass_emits_mass_until_it_stops() {
    let mut simulation = rain("capacity = 100\nmass_rate = 10\nstop = 0.75");
    simulation.advance_to(0.5).unwrap();
    assert!((simulation.state().emitted[0] - 5.0).abs() < 1e-12);
    simulation.advance_to(1.5).unwrap();
    // 7.5 kg were due: seven whole spheres.
    assert!((simulation.state().emitted[0] - 7.0).abs() < 1e-12);
}

#[test]
fn mass_in_is_mass_in_the_scene_plus_mass_out_at_every_step() {
    let mut simulation = rain("capacity = 30\nrate = 50");
    let mut drained = 0.0;
    for k in 1..=200 {
        simulation.advance_to(f64::from(k) * 0.02).unwrap();
        let state = simulation.state();
        let balance = state.emitted[0] - state.removed[0] - present(&simulation) as f64;
        assert!(balance.abs() < 1e-9, "{balance}");
        assert!(present(&simulation) <= 30, "more spheres than the capacity");
        drained = state.removed[0];
    }
    // The thirty spheres went round: what the sink took came again.
    assert!(drained > 60.0, "{drained}");
}

#[test]
fn new_spheres_fall_as_thrown() {
    // One sphere, thrown at t = 0.1: z = z0 + v (t - t0) - g (t - t0)^2 / 2 at the nodes, to rounding.
    let mut simulation =
        rain("capacity = 1\nrate = 10\nvelocity = [0.3, 0, 1.5]\nspin = [0, 2, 0]");
    simulation.advance_to(0.1).unwrap();
    let start = simulation.kinematics().position[0];
    assert_eq!(simulation.velocity(0).linear.z, 1.5);
    simulation.advance_to(0.5).unwrap();
    let now = simulation.kinematics().position[0];
    let t = 0.4;
    assert!((now.z - (start.z + 1.5 * t - 0.5 * 9.81 * t * t)).abs() < 1e-12);
    assert!((now.x - (start.x + 0.3 * t)).abs() < 1e-12);
    assert_eq!(simulation.velocity(0).angular.y, 2.0);
}

#[test]
fn a_full_region_waits_and_never_overlaps() {
    // Emission into a cup that cannot hold it: spheres never overlap, the rest is forgone.
    let mut simulation = simulation(
        r#"
[simulation]
duration = 2.0
step = 0.005
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[pair_default]
friction = 0.5
[[material]]
name = "steel"
density = 2500
[[source]]
name = "hose"
material = "steel"
size = { uniform = { min = 0.03, max = 0.05 } }
seed = 1
capacity = 200
rate = 400
region = { cylinder = { base = [0, 0, 0.3], radius = 0.15, height = 0.2 } }
[[boundary]]
name = "cup"
material = "steel"
faces = [{ box = { min = [-0.2, -0.2, 0.0], max = [0.2, 0.2, 0.6] } }]
"#,
    );
    for k in 1..=100 {
        let report = simulation.advance_to(f64::from(k) * 0.01).unwrap();
        assert!(report.max_overlap <= 1e-6, "{}", report.max_overlap);
    }
    let placed = present(&simulation);
    assert!((60..200).contains(&placed), "{placed}");
}

#[test]
fn a_sink_recycles_spheres_of_any_group() {
    let mut simulation = simulation(
        r#"
[simulation]
duration = 2.0
step = 0.01
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
[[material]]
name = "steel"
density = 2500
[[spheres]]
name = "load"
material = "steel"
radius = 0.04
positions = [[0, 0, 0.5]]
[[source]]
name = "hose"
material = "steel"
radius = 0.05
capacity = 1
rate = 2
region = { box = { min = [-0.2, -0.2, 2.0], max = [0.2, 0.2, 2.3] } }
[[sink]]
name = "drain"
recycle = "hose"
region = { box = { min = [-1, -1, -1], max = [1, 1, 0] } }
"#,
    );
    simulation.advance_to(0.45).unwrap();
    assert_eq!(simulation.kinematics().present, [false, false]);
    // At 0.5 s the source's own sphere, at 1.0 s the load's.
    simulation.advance_to(0.55).unwrap();
    assert_eq!(simulation.kinematics().present, [false, true]);
    simulation.advance_to(1.05).unwrap();
    assert!(simulation.kinematics().present[0]);
    assert!(simulation.kinematics().position[0].z > 1.5);
}

#[test]
fn a_snapshot_holds_sources_and_sinks() {
    let drive = |simulation: &mut Simulation, from: u32, to: u32| {
        for k in from..=to {
            simulation.advance_to(f64::from(k) * 0.02).unwrap();
        }
    };
    let source = "capacity = 30\nrate = 50";
    let mut whole = rain(source);
    drive(&mut whole, 1, 50);
    let saved = whole.snapshot();
    drive(&mut whole, 51, 100);

    let mut restored = rain(source);
    restored.restore(&saved).unwrap();
    drive(&mut restored, 51, 100);
    assert_eq!(restored.snapshot(), whole.snapshot());
    whole.restore(&saved).unwrap();
    drive(&mut whole, 51, 100);
    assert_eq!(restored.snapshot(), whole.snapshot());
}

#[test]
fn absent_spheres_count_nowhere() {
    let mut simulation = rain("capacity = 5\nrate = 10");
    let at_start = Observation::of(&simulation);
    assert_eq!(
        frames::spheres(&at_start).connectivity.len(),
        1,
        "readers need a cell"
    );
    assert_eq!(Momentum::of(&at_start), Momentum::default());
    simulation.advance_to(0.25).unwrap();
    let state = Observation::of(&simulation);
    assert_eq!(frames::spheres(&state).points.len(), 2);
}
