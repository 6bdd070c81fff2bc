//! Fault 9. Symptoms: scenes that work become unusable by a stray sphere, by one sphere more or by unequal sizes; wrong scenes
//! take all memory or minutes instead of a message. Scenes that may take too much memory are read by a process of their own
//! within 2 GB, so that a failed allocation is told as such. Causes stand at each test.

use std::process::{Command, Output};
use std::sync::Arc;
use std::time::{Duration, Instant};

use sphere_dda::Vec3;
use sphere_dda::observe::Observation;
use sphere_dda::scene::Scene;
use sphere_dda::simulation::Simulation;

use crate::support::Case;

/// Time of `work`, the least of three.
fn time_of(mut work: impl FnMut()) -> Duration {
    let once = |_| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..3).map(once).min().unwrap_or_default()
}

/// Time of ten steps of a lattice at rest without gravity, with a stray sphere far away.
fn with_a_stray(speed: f64) -> Duration {
    let lattice = "radius = 0.05\nlattice = { origin = [0.0, 0.0, 0.0], count = [10, 10, 10], spacing = 0.11 }";
    let case = Case::new(1e-3).gravity(Vec3::zeros()).spheres(lattice);
    let stray = case.sphere(
        0.05,
        Vec3::new(-50.0, 0.0, 0.0),
        Vec3::y() * speed,
        Vec3::zeros(),
    );
    let scene = Arc::new(stray.scene());
    time_of(|| {
        let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
        for _ in 0..40 {
            simulation.advance(1e-3).expect("a step");
        }
    })
}

/// One skin for all followed the fastest sphere: forty times the time. Now each sphere has its own.
#[test]
fn a_stray_sphere_costs_the_others_nothing() {
    let [still, fast] = [0.0, 100.0].map(with_a_stray);
    assert!(
        fast < still * 4 + Duration::from_millis(20),
        "{fast:?} instead of {still:?}"
    );
}

/// Cells of the grid were bounded by 512^3, not by the number of spheres: 462 MB and 0.2 s a step from 8192 spheres on.
#[test]
fn a_few_more_small_spheres_cost_a_little_more() {
    let time = |layers: u32| {
        let lattice = format!(
            "radius = 1e-4\nlattice = {{ origin = [0.0, 0.0, 0.0], count = [21, 21, {layers}], spacing = 5e-3 }}"
        );
        let scene = Arc::new(
            Case::new(1e-3)
                .gravity(Vec3::zeros())
                .spheres(&lattice)
                .scene(),
        );
        time_of(|| {
            let mut simulation = Simulation::new(Arc::clone(&scene)).expect("a start");
            for _ in 0..5 {
                simulation.advance(1e-3).expect("a step");
            }
        })
    };
    let [below, above] = [18, 19].map(time);
    assert!(
        above < below * 4 + Duration::from_millis(20),
        "{above:?} instead of {below:?}"
    );
}

/// With one size of cell for all, each sphere of 1/20 of the largest met thousands in its cell.
#[test]
fn unequal_sizes_cost_little() {
    let time = |large: bool| {
        let lattice = "radius = 5e-4\nlattice = { origin = [0.0, 0.0, 0.0], count = [25, 25, 25], spacing = 1.1e-3 }";
        let mut case = Case::new(1e-3).gravity(Vec3::zeros()).spheres(lattice);
        if large {
            case = case.sphere(
                0.03,
                Vec3::new(-0.1, 0.0, 0.0),
                Vec3::zeros(),
                Vec3::zeros(),
            );
        }
        let scene = Arc::new(case.scene());
        time_of(|| {
            Simulation::new(Arc::clone(&scene)).expect("a start");
        })
    };
    let [equal, unequal] = [false, true].map(time);
    assert!(
        unequal < equal * 3 + Duration::from_millis(20),
        "{unequal:?} instead of {equal:?}"
    );
}

/// The start with rolling friction is linear in the number of contacts. Cause: `Assembly::keep` counts for each resistance
/// the rows that are kept before its contact.
#[test]
fn a_start_with_rolling_friction_is_linear_in_the_contacts() {
    let time = |side: u32| {
        let lattice = format!(
            "radius = 0.05\nlattice = {{ origin = [0.0, 0.0, 0.05], count = [{side}, {side}, 1], spacing = 0.11 }}"
        );
        let case = Case::new(1e-3)
            .contact(0.5, 0.0)
            .pair("rolling_friction = 0.05")
            .floor();
        let scene = Arc::new(case.spheres(&lattice).scene());
        time_of(|| {
            Simulation::new(Arc::clone(&scene)).expect("a start");
        })
    };
    let [few, many] = [140, 560].map(time);
    // Linear is 16 times, quadratic 256 times: between them, since other tests run beside this one.
    assert!(many < few * 64, "{many:?} instead of sixteen times {few:?}");
}

/// The text of a scene that a process of its own reads.
const SCENE: &str = "SPHERE_DDA_REGRESSION_SCENE";

/// The test that reads it.
const READ: &str = "bounds::read_in_a_process";

/// Reads the scene of the environment and says what comes of it; run by [`within_two_gigabytes`].
#[test]
#[ignore = "run by other tests in a process of its own"]
fn read_in_a_process() {
    let Ok(text) = std::env::var(SCENE) else {
        return;
    };
    match Scene::from_toml("case", &text, std::path::Path::new("")) {
        Ok(_) => println!("the scene is taken"),
        Err(error) => println!("refused: {error:?}"),
    }
}

/// What a process says that reads the scene with 2 GB of memory and 60 s.
fn within_two_gigabytes(test: &str, text: &str) -> Output {
    let program = std::env::current_exe().expect("this program");
    let script =
        "ulimit -v 2000000; exec timeout 60 \"$0\" --exact \"$1\" --include-ignored --nocapture";
    let command = Command::new("sh")
        .args(["-c", script])
        .arg(program)
        .arg(test)
        .env(SCENE, text)
        .output();
    command.expect("a shell")
}

/// The scene is refused, in words, with the quantity that is at fault.
fn is_refused(text: &str, words: &[&str]) {
    let output = within_two_gigabytes(READ, text);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{}: {}",
        output.status,
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(said.contains("refused"), "{said}");
    assert!(words.iter().any(|word| said.contains(word)), "{said}");
}

/// 20 000 spheres at one place have 2e8 pairs that overlap. Cause: `Overlaps::of` keeps all of them.
#[test]
fn spheres_at_one_place_are_refused_within_memory() {
    // A lattice as good as one place: an argument of the environment is at most 128 kB long.
    let lattice = "radius = 0.01\nlattice = { origin = [0.0, 0.0, 0.0], count = [200, 100, 1], spacing = 1e-9 }";
    is_refused(&Case::new(1e-3).spheres(lattice).text(), &["overlap"]);
}

/// A packing region of 1e12 m asks for one allocation of 52 GB.
#[test]
fn a_packing_of_a_region_too_large_is_refused_within_memory() {
    for (size, radius, count) in [(1e12, 1e6, 1000), (1e12, 1e-3, 1000)] {
        let packing = format!(
            "radius = {radius:?}\npacking = {{ region = {{ box = {{ min = [0.0, 0.0, 0.0], max = [{size:?}, {size:?}, {size:?}] }} }}, count = {count} }}"
        );
        let output = within_two_gigabytes(READ, &Case::new(1e-3).spheres(&packing).text());
        assert!(
            output.status.success(),
            "{}: {}",
            output.status,
            String::from_utf8_lossy(&output.stderr)
        );
    }
}

/// A cell smaller than a sphere has as many images of it as fit. Cause: overlaps are sought over all images before the
/// message that edges need 1.001 diameters.
#[test]
fn a_cell_smaller_than_a_sphere_is_refused_within_memory() {
    for radius in [8.0, 256.0] {
        let case = Case::new(1e-3).sphere(radius, Vec3::zeros(), Vec3::zeros(), Vec3::zeros());
        let cell = "[cell]\nx = [0.0, 0.4]\ny = [0.0, 0.2]\n";
        is_refused(&case.table(cell).text(), &["cell", "diameter"]);
    }
}

/// Thousands of problems in a scene are told, or the first hundreds of them, within seconds.
#[test]
fn thousands_of_problems_are_told_within_seconds() {
    let mut case = Case::new(1e-3);
    for _ in 0..4000 {
        case = case.spheres("radius = -1.0\npositions = [[0.0, 0.0, 0.0]]\nfrom = 1\nradios = 2");
    }
    let text = case.text();
    let start = Instant::now();
    let error =
        Scene::from_toml("case", &text, std::path::Path::new("")).expect_err("a wrong scene");
    let told = error.to_string().len();
    let time = start.elapsed();
    assert!(time < Duration::from_secs(3), "{time:?}, {told} characters");
}

/// A step of many cells' edges: copies of every sphere on its way were sought in all cells, and took 8 GB.
#[test]
fn a_step_over_many_cells_is_cut_or_refused() {
    let lattice = "radius = 0.01\nlattice = { origin = [0.02, 0.02, 0.05], count = [5, 5, 3], spacing = 0.03 }";
    let cell = "[cell]\nx = [0.0, 0.4]\ny = [0.0, 0.2]\n";
    let case = Case::new(1.0).floor().spheres(lattice).table(cell);
    let output = within_two_gigabytes("bounds::stepped_in_a_process", &case.text());
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{}", output.status);
    assert!(
        said.contains("three steps") || said.contains("shorter"),
        "{said}"
    );
}

/// Takes three steps of the scene of the environment; run by the test above.
#[test]
#[ignore = "run by other tests in a process of its own"]
fn stepped_in_a_process() {
    let Ok(text) = std::env::var(SCENE) else {
        return;
    };
    let loaded = Scene::from_toml("case", &text, std::path::Path::new("")).expect("a scene");
    let mut simulation = Simulation::new(Arc::new(loaded.scene)).expect("a start");
    match (0..3).try_for_each(|_| simulation.advance(1.0).map(|_| ())) {
        Ok(()) => println!("three steps"),
        Err(error) => println!("{error}"),
    }
}

/// What leaves a box is taken out of the scene, and its mass is booked.
#[test]
fn spheres_that_leave_the_scene_are_removed() {
    let lost = "[[sink]]\nname = \"lost\"\nregion = { outside = { min = [-1.0, -1.0, -1.0], max = [1.0, 1.0, 1.0] } }\n";
    let case = Case::new(1e-2).gravity(Vec3::zeros()).table(lost);
    let away = [-Vec3::x(), -Vec3::y(), Vec3::z() * 2.0, Vec3::zeros()];
    let case = away.iter().enumerate().fold(case, |case, (k, v)| {
        case.sphere(0.05, Vec3::x() * (0.2 * k as f64), *v, Vec3::zeros())
    });
    let mut run = case.start();
    run.until(0.4);
    assert_eq!(run.simulation.kinematics().present, [true; 4]);
    run.until(2.0);
    assert_eq!(
        run.simulation.kinematics().present,
        [false, false, false, true]
    );
    let found = Observation::of(&run.simulation).removed[0];
    assert!(
        (found / (3.0 * run.mass(0)) - 1.0).abs() < 1e-12,
        "{found} kg"
    );
}
