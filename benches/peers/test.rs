//! What the comparison with other codes reads off a run is what the library says of it.

mod measure;

use std::path::Path;
use std::sync::Arc;

use measure::{Outputs, measure, memory};
use sphere_dda::contact::Partner;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

const SCENE: &str = r#"
[simulation]
duration = 0.12
step = 1e-3
fixed_step = true
strict = true
communication_step = 0.02
tolerance = { gap = 1e-4, slip = 1e-4, force = 0.1, opening = 0 }

[[material]]
name = "glass"
density = 2500.0

[pair_default]
friction = 0.5

[[spheres]]
name = "bed"
material = "glass"
radius = 0.01
seed = 3
lattice = { origin = [0.0, 0.0, 0.011], count = [3, 3, 2], spacing = 0.021, jitter = 0.02 }

[[boundary]]
name = "side"
material = "glass"
faces = [{ plane = { point = [-0.0105, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }]

[[boundary]]
name = "floor"
material = "glass"
faces = [{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }]
"#;

fn scene() -> Scene {
    let loaded = Scene::from_toml("bed", SCENE, Path::new(""));
    loaded.expect("a good scene").scene
}

fn numbers(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).expect("a written file");
    let (words, rest) = bytes.as_chunks::<8>();
    assert!(rest.is_empty(), "whole numbers");
    words.iter().map(|word| f64::from_le_bytes(*word)).collect()
}

#[test]
fn a_measured_run_is_what_the_library_says_of_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let (frames, end) = (folder.path().join("frames"), folder.path().join("end"));
    let touching = folder.path().join("contacts");
    let outputs = Outputs {
        frames: Some(&frames),
        end: Some(&end),
        contacts: Some(&touching),
        mean_s: 0.04,
    };
    let measured = measure(scene(), outputs, memory("VmRSS:")).expect("a run");

    let mut simulation = Simulation::new(Arc::new(scene())).expect("a start");
    let particles = simulation.scene().particles.clone();
    let (mut worst, mut sweeps, mut steps, mut floor) = (0.0_f64, 0, 0, Vec::new());
    let (mut positions, mut pairs, mut wrenches) = (Vec::new(), Vec::new(), Vec::new());
    for k in 1..=6 {
        let report = simulation
            .advance_to(0.12 * f64::from(k) / 6.0)
            .expect("a step");
        worst = worst.max(report.max_overlap);
        sweeps += report.sweeps;
        steps += report.internal_steps;
        floor.push(-simulation.mean_wrench(1).force.z);
        positions.extend(simulation.kinematics().position.iter().copied());
        wrenches.push(simulation.mean_wrench(0));
        let contacts = simulation.contacts();
        pairs.push(contacts.len() as i64);
        for contact in &contacts {
            pairs.push(i64::from(contact.key.sphere));
            pairs.push(match contact.key.partner {
                Partner::Sphere { index, .. } => i64::from(index),
                Partner::Boundary { .. } => -1,
            });
        }
    }
    assert!(worst > 0.0 && worst <= 1e-4);
    let last = measured.course.max_overlap[5];
    assert!(last < worst, "the worst is not the last");
    assert_eq!(measured.total.max_overlap, worst);
    assert_eq!(
        (measured.total.sweeps, measured.total.internal_steps),
        (sweeps, steps)
    );
    // The last two of six communication steps are 0.04 s.
    let mean = 0.5 * (floor[4] + floor[5]);
    let error = measured.floor_force.expect("a floor") - mean;
    assert!(
        error.abs() < 1e-12 * mean && mean > 0.0,
        "{error} of {mean} N"
    );

    let bytes = std::fs::read(&touching).expect("a written file");
    let written = bytes.as_chunks::<8>().0.iter();
    let written: Vec<i64> = written.map(|word| i64::from_le_bytes(*word)).collect();
    assert_eq!(written, pairs);
    assert!(pairs.contains(&-1) && pairs.len() > 6);
    for (found, wrench) in measured.wrenches["side"].iter().zip(&wrenches) {
        assert_eq!(found[..3], *wrench.force.as_slice());
        assert_eq!(found[3..], *wrench.torque.as_slice());
    }
    assert_eq!(measured.wrenches["side"].len(), 6);

    let written = numbers(&frames);
    let expected: Vec<f64> = positions.iter().flat_map(|x| [x.x, x.y, x.z]).collect();
    assert_eq!(written, expected);
    let mut energy = 0.0;
    for (i, row) in numbers(&end).as_chunks::<9>().0.iter().enumerate() {
        let (v, w) = (&row[3..6], &row[6..9]);
        assert_eq!(row[..3], *simulation.kinematics().position[i].as_slice());
        let square = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>();
        energy += 0.5 * (particles.mass[i] * square(v) + particles.inertia(i) * square(w));
    }
    assert!(energy > 0.0);
    assert!((measured.kinetic_energy - energy).abs() < 1e-12 * energy);
}

#[test]
fn the_course_adds_up_to_the_whole() {
    let outputs = Outputs {
        frames: None,
        end: None,
        contacts: None,
        mean_s: 0.04,
    };
    let measured = measure(scene(), outputs, memory("VmRSS:")).expect("a run");
    let course = &measured.course;
    assert_eq!(course.time.len(), 6);
    assert_eq!(
        course.steps.iter().sum::<u64>(),
        measured.total.internal_steps
    );
    assert_eq!(course.sweeps.iter().sum::<u64>(), measured.total.sweeps);
    let cpu: f64 = course.cpu_s.iter().sum();
    assert_eq!(course.cpu_s.len(), 6);
    assert!(
        cpu <= measured.cpu_s + 1e-9,
        "{cpu} of {} s",
        measured.cpu_s
    );
    let clock: f64 = course.wall_s.iter().sum();
    assert!(clock > 0.0 && clock <= measured.wall_s + 1e-9);
    let worst = course.max_overlap.iter().copied().fold(0.0, f64::max);
    assert_eq!(worst, measured.total.max_overlap);
}
