//! The same scene gives the same bytes: run twice, or put back at any moment, in this simulation or another.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::contact::Partner;
use sphere_dda::contact::cohesion::Cohesion;
use sphere_dda::error::SnapshotError;
use sphere_dda::formats::snapshot::spheres;
use sphere_dda::scene::Scene;
use sphere_dda::scene::materials::Pair;
use sphere_dda::simulation::Simulation;

/// Communication steps of a run.
const STEPS: usize = 40;

fn scene(name: &str) -> Arc<Scene> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}/{name}.toml"));
    let loaded = Scene::from_file(file).unwrap_or_else(|e| panic!("{}", e.plain()));
    Arc::new(loaded.scene)
}

/// The funnel as its spheres pile up at the mouth: contacts, impacts and friction from the first steps on.
fn funnel() -> Arc<Scene> {
    let mut scene = Scene::clone(&scene("funnel"));
    for position in &mut scene.initial.position {
        position.z -= 0.9;
    }
    // A fall of a few steps is enough to reach the wall.
    for velocity in &mut scene.initial.velocity {
        velocity.z = -4.0;
    }
    Arc::new(scene)
}

/// Runs on to communication step `end`; the state after each step.
fn run(simulation: &mut Simulation, start: usize, end: usize) -> Vec<Vec<u8>> {
    let h = simulation.scene().settings.communication_step;
    (start + 1..=end)
        .map(|k| {
            simulation.advance_to(k as f64 * h).expect("a step");
            simulation.snapshot()
        })
        .collect()
}

#[test]
fn the_same_scene_twice_gives_the_same_bytes() {
    for scene in [funnel(), scene("feeder")] {
        let runs = [(), ()].map(|()| {
            let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
            run(&mut simulation, 0, STEPS)
        });
        assert!(runs[0] == runs[1], "{}", scene.title);
        assert_ne!(runs[0][0], runs[0][1], "the state moves");
    }
}

/// Warm-start multipliers, contact history, penalty and clock are all in the state: nothing else decides.
#[test]
fn a_restored_run_equals_the_uninterrupted_one_bit_for_bit() {
    let scene = funnel();
    let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
    let whole = run(&mut simulation, 0, STEPS);
    assert!(
        simulation.contacts().len() > 20,
        "a run without contacts shows nothing"
    );

    // Points drawn once with a die; the last but one step makes the continuation a single step.
    for point in [3, 11, 17, 26, STEPS - 2] {
        let saved = &whole[point];
        simulation.restore(saved).expect("its own state");
        assert!(simulation.snapshot() == *saved, "restored state at {point}");
        assert!(
            run(&mut simulation, point + 1, STEPS) == whole[point + 1..],
            "back in time to step {point}"
        );

        let mut fresh = Simulation::new(Arc::clone(&scene)).expect("a start");
        fresh.restore(saved).expect("a state of the same scene");
        assert!(
            run(&mut fresh, point + 1, STEPS) == whole[point + 1..],
            "in a fresh simulation from step {point}"
        );
    }
}

/// A source rains through the faces of a periodic cell, in a frame that turns: images, the wandering positions and the frame's part
/// of the accelerations are in the state as well. Nothing that is emitted overlaps, through no face.
#[test]
fn a_periodic_rotating_scene_is_restored_bit_for_bit() {
    let text = r#"
[simulation]
duration = 1.0
step = 2e-3
fixed_step = true
strict = true
tolerance = { gap = 1e-6, slip = 1e-6, force = 1e-6, opening = 0 }
communication_step = 1e-2
gravity_motion = { rotation = { axis = [1, 0, 0], speed = -0.5 } }
rotating_frame = { axis = [1, 0, 0], speed = 0.5, point = [0, 0, 1] }
[cell]
x = [0.0, 0.33]
[pair_default]
friction = 0.4
[[material]]
name = "stone"
density = 2500.0
[[source]]
name = "rain"
material = "stone"
radius = 0.05
capacity = 40
rate = 400
velocity = [2.0, 0.0, -1.0]
seed = 5
region = { box = { min = [0.2, -0.2, 0.1], max = [0.6, 0.2, 0.5] } }
[[boundary]]
name = "floor"
material = "stone"
faces = [{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]
"#;
    let loaded = Scene::from_toml("rain", text, Path::new(""));
    let scene = Arc::new(loaded.unwrap_or_else(|e| panic!("{}", e.plain())).scene);
    let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
    let mut whole = Vec::new();
    for k in 0..STEPS {
        whole.extend(run(&mut simulation, k, k + 1));
        let overlap = simulation.report().max_overlap;
        assert!(overlap <= scene.settings.tolerance.gap, "{overlap}");
    }
    let through = simulation.contacts().into_iter().filter(
        |contact| matches!(contact.key.partner, Partner::Sphere { image, .. } if image != [0; 3]),
    );
    assert!(through.count() > 3, "contacts through faces");
    for point in [7, 23] {
        let mut fresh = Simulation::new(Arc::clone(&scene)).expect("a start");
        fresh
            .restore(&whole[point])
            .expect("a state of the same scene");
        assert!(
            run(&mut fresh, point + 1, STEPS) == whole[point + 1..],
            "{point}"
        );
    }
}

#[test]
fn a_failed_step_leaves_the_state_as_it_was() {
    let mut simulation = Simulation::new(funnel()).expect("a start");
    run(&mut simulation, 0, 5);
    let before = simulation.snapshot();
    for end in [simulation.time(), 0.0, f64::NAN, f64::INFINITY] {
        simulation.advance_to(end).expect_err("not a time to go to");
        assert!(simulation.snapshot() == before, "after a step to {end}");
    }
}

#[test]
fn foreign_and_damaged_states_are_refused() {
    let mut simulation = Simulation::new(scene("feeder")).expect("a start");
    run(&mut simulation, 0, 2);
    let own = simulation.snapshot();

    let mut other = Simulation::new(scene("funnel")).expect("a start");
    let refusal = other.restore(&own).expect_err("another scene");
    assert!(matches!(refusal, SnapshotError::Scene { .. }), "{refusal}");
    for hash in [&simulation.scene().hash, &other.scene().hash] {
        assert!(refusal.to_string().contains(&hash[..12]), "{refusal}");
    }

    let mut old = own.clone();
    old[8] = 1;
    let refusal = simulation.restore(&old).expect_err("another version");
    assert!(
        matches!(refusal, SnapshotError::Version { found: 1, .. }),
        "{refusal}"
    );

    let mut bad: Vec<(String, Vec<u8>)> = vec![
        ("nothing".into(), vec![]),
        (
            "noise".into(),
            (0..997_u32).map(|k| (k * 193 % 251) as u8).collect(),
        ),
        ("one byte more".into(), [own.as_slice(), &[0]].concat()),
    ];
    for length in [1, 8, 20, own.len() / 2, own.len() - 1] {
        bad.push((format!("cut to {length}"), own[..length].to_vec()));
    }
    for at in (0..own.len()).step_by(own.len() / 50 + 1) {
        let mut flipped = own.clone();
        flipped[at] ^= 0x10;
        bad.push((format!("byte {at} changed"), flipped));
    }
    for (what, blob) in bad {
        assert!(simulation.restore(&blob).is_err(), "{what}");
        assert!(spheres(&blob).is_err(), "spheres of {what}");
        assert!(
            simulation.snapshot() == own,
            "{what}: the state has changed"
        );
    }
}

/// Another run starts with the velocities at the moment of the snapshot, not with the integrator's of half a step before.
#[test]
fn spheres_are_read_from_a_snapshot_of_any_scene() {
    let mut simulation = Simulation::new(funnel()).expect("a start");
    run(&mut simulation, 0, 15);
    let (radius, kinematics) = spheres(&simulation.snapshot()).expect("a whole snapshot");
    assert_eq!(radius, simulation.scene().particles.radius);
    let own = simulation.kinematics();
    assert_eq!(kinematics.position, own.position);
    assert_eq!(kinematics.orientation, own.orientation);
    assert_eq!(kinematics.present, own.present);
    for i in 0..radius.len() {
        assert_eq!(kinematics.velocity[i], simulation.velocity(i).linear);
        assert_eq!(kinematics.spin[i], simulation.velocity(i).angular);
    }
    assert_ne!(kinematics.velocity, own.velocity);
}

/// Large scenes are cut into parts by where spheres are, not by how many threads there are.
#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let mut scene = Scene::clone(&scene("dropped"));
    let (particles, initial) = (scene.particles.clone(), scene.initial.clone());
    scene.boundaries.clear();
    // Fourteen beds side by side that drift into each other.
    for copy in 1..14 {
        for i in 0..particles.len() {
            let shift = nalgebra::Vector3::new(0.398 * f64::from(copy), 0.0, 0.0);
            scene.particles.radius.push(particles.radius[i]);
            scene.particles.mass.push(particles.mass[i]);
            scene.particles.material.push(particles.material[i]);
            scene.particles.locks.push(particles.locks[i]);
            let drift = nalgebra::Vector3::new(-0.5 * f64::from(copy), 0.0, -1.0);
            scene
                .initial
                .push(initial.position[i] + shift, drift, initial.spin[i]);
        }
    }
    same_with_any_number_of_threads(&scene);
    // Sticky ones, whose contacts hold.
    let ball = scene.particles.material[0];
    let cohesion = Some(Cohesion {
        force: 10.0 * scene.particles.mass[0] * 9.81,
        ..Cohesion::default()
    });
    let pair = Pair {
        cohesion,
        rolling_friction: 0.1,
        ..scene.pairs.get(ball, ball)
    };
    scene.pairs.set(ball, ball, pair);
    same_with_any_number_of_threads(&scene);
}

/// Clumps go with the part of their first members.
#[test]
fn clumps_give_the_same_bytes_with_any_number_of_threads() {
    let text = r#"
[simulation]
duration = 1.0
gravity = [20, 10, -150]
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.4
[[clump]]
name = "rod"
members = [{ position = [0, 0, 0], radius = 1 }, { position = [1.4, 0, 0], radius = 0.9 }]
[[spheres]]
name = "rods"
material = "stone"
clump = "rod"
radius = 0.005
seed = 3
lattice = { origin = [0, 0, 0.01], count = [40, 11, 10], spacing = 0.018, jitter = 0.1 }
[[boundary]]
name = "box"
material = "stone"
faces = [{ box = { min = [-0.02, -0.02, -0.01], max = [0.75, 0.22, 1.0] } }]
"#;
    let loaded =
        Scene::from_toml("rods", text, Path::new("")).unwrap_or_else(|e| panic!("{}", e.plain()));
    // Of 640 spheres a part: eight of them.
    assert!(loaded.scene.particles.len() > 8192, "few parts are no test");
    same_with_any_number_of_threads(&loaded.scene);
}

fn same_with_any_number_of_threads(scene: &Scene) {
    let runs = [1, 2, 3].map(|threads| {
        let mut scene = scene.clone();
        scene.settings.threads = threads;
        let mut simulation = Simulation::new(Arc::new(scene)).expect("a start");
        let contacts = |simulation: &Simulation| simulation.contacts().len();
        simulation.advance_to(0.04).expect("a step");
        (simulation.snapshot(), contacts(&simulation))
    });
    assert!(runs[0].1 > 200, "{} contacts", runs[0].1);
    assert!(runs[0] == runs[1] && runs[0] == runs[2]);
}
