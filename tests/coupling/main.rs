//! The shaker and the grains as two FMUs: what one gives the other gets, and how heavy the grains may be.

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::Command;

use sphere_dda_export::{Contents, Version, export, find_libraries};
use sphere_dda_master::{Coupling, End, Fmu, Iteration, Options, Step, System, Table, simulate};

const FORCE: &str = "bed.boundary.tray.averageForce[3]";
const GRAVITY: f64 = 9.81;
/// Mass of the shaker [kg], spring [N/m], damper [N.s/m]: the defaults of its FMU.
const SHAKER: [f64; 3] = [2.0, 8000.0, 20.0];

fn shaker(folder: &Path) -> Fmu {
    let path = folder.join("shaker.fmu");
    let done = Command::new(env!("CARGO_BIN_EXE_export-shaker"))
        .arg(&path)
        .output();
    assert!(done.unwrap().status.success());
    Fmu::open(path).unwrap()
}

/// A scene of the example as an FMU, its text edited.
fn bed(folder: &Path, name: &str, edit: impl FnOnce(&mut String)) -> Fmu {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut text = fs::read_to_string(example.join(name)).unwrap();
    edit(&mut text);
    let (scene, fmu): (PathBuf, PathBuf) = (folder.join(name), folder.join("bed.fmu"));
    fs::write(&scene, text).unwrap();
    let contents = Contents {
        smoke_test: None,
        scene: &scene,
        values: &[],
        start: None,
        libraries: &find_libraries(None, &[]).unwrap(),
        version: Version::Two,
        draw: |_| None,
    };
    export(contents, &fmu).unwrap();
    Fmu::open(fmu).unwrap()
}

/// Motion forward, force back.
fn coupled(order: [(&str, &Fmu); 2], options: &Options) -> Table {
    let named = order.map(|(name, fmu)| (name.to_owned(), fmu));
    let mut system = System::coupled(named).unwrap();
    system
        .connect([
            ("shaker.position", "bed.boundary.tray.displacement"),
            (FORCE, "shaker.force"),
        ])
        .unwrap();
    let table = simulate(&system, options, |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(table.end, End::Stop);
    table
}

fn set(pairs: &[(&str, f64)]) -> Vec<(String, String)> {
    let text = |(name, value): &(&str, f64)| ((*name).to_owned(), value.to_string());
    pairs.iter().map(text).collect()
}

/// m x'' + d x' + k x = F held, from (x, v) over h: underdamped closed form.
fn free_step([x, v]: [f64; 2], mass: f64, force: f64, h: f64) -> [f64; 2] {
    let [_, k, d] = SHAKER;
    let (decay, rest) = (d / (2.0 * mass), force / k);
    let omega = (k / mass - decay * decay).sqrt();
    let (a, e) = (x - rest, (-decay * h).exp());
    let b = (v + decay * a) / omega;
    let (s, c) = (omega * h).sin_cos();
    [
        rest + e * (a * c + b * s),
        e * ((b * omega - decay * a) * c - (a * omega + decay * b) * s),
    ]
}

#[test]
fn the_fmu_of_the_shaker_is_its_equation_and_rolls_back() {
    let folder = tempfile::tempdir().unwrap();
    let fmu = shaker(folder.path());
    assert_eq!(fmu.missing_functions().unwrap(), [""; 0]);
    assert_eq!(fmu.description().version_2().unwrap().validate(), []);
    let mut instance = fmu.instantiate("one", false).unwrap();
    instance.setup_experiment(None, 0.0, None).unwrap();
    instance.set_real(&[1, 8], &[0.01, 0.0]).unwrap();
    instance.enter_initialization_mode().unwrap();
    instance.exit_initialization_mode().unwrap();
    let mut state = [0.01, 0.0];
    let mut saved = None;
    for k in 0..100 {
        if k == 40 {
            let kept = instance.save_state().unwrap();
            saved = Some((instance.serialize_state(&kept).unwrap(), state));
        }
        let force = f64::from(k % 7) - 3.0;
        instance.set_real(&[0], &[force]).unwrap();
        let done = instance
            .do_step(f64::from(k) * 0.003, 0.003, false)
            .unwrap();
        assert_eq!(done, Step::Done);
        state = free_step(state, SHAKER[0], force, 0.003);
        let found = instance.get_real(&[1, 2]).unwrap();
        assert!((found[0] - state[0]).abs() < 1e-15 && (found[1] - state[1]).abs() < 1e-13);
    }
    let last = instance.get_real(&[1, 2, 3, 4]).unwrap();

    // The bytes go on in another instance.
    let (bytes, _) = saved.unwrap();
    let mut other = fmu.instantiate("two", false).unwrap();
    let kept = other.deserialize_state(&bytes).unwrap();
    other.restore_state(&kept).unwrap();
    for k in 40..100 {
        other.set_real(&[0], &[f64::from(k % 7) - 3.0]).unwrap();
        other.do_step(f64::from(k) * 0.003, 0.003, false).unwrap();
    }
    assert_eq!(other.get_real(&[1, 2, 3, 4]).unwrap(), last);
    assert!(other.set_real(&[5], &[1.0]).is_err(), "the mass is fixed");
    other.restore_state(&kept).unwrap();
    assert!(other.deserialize_state(&bytes[1..]).is_err());
    let (messages, _) = other.take_messages();
    let told: Vec<&str> = messages.iter().map(|message| &*message.text).collect();
    assert!(
        told[0].contains("`mass` cannot be set in state step complete"),
        "{told:?}"
    );
    assert!(told[1].contains("108 bytes that are no state"), "{told:?}");
}

#[test]
fn what_the_grains_lose_the_shaker_gets_in_every_step() {
    let folder = tempfile::tempdir().unwrap();
    let shaker = shaker(folder.path());
    let bed = bed(folder.path(), "bed.toml", |_| ());
    for (coupling, bed_first) in [
        (Coupling::Jacobi, false),
        (Coupling::GaussSeidel, false),
        (Coupling::GaussSeidel, true),
        (Coupling::Iterated, false),
    ] {
        let together = bed_first || coupling == Coupling::Iterated;
        let options = Options {
            stop: Some(0.3),
            coupling,
            ..Options::default()
        };
        let mut order = [("shaker", &shaker), ("bed", &bed)];
        if bed_first {
            order.reverse();
        }
        let table = coupled(order, &options);
        let column = |name: &str| table.real(name).unwrap();
        let (force, impulse) = (column(FORCE), column("shaker.impulse"));
        let (momentum, mass) = (column("bed.momentum[3]"), column("bed.mass")[0]);
        let h = 1e-3;
        let peak = force.iter().copied().fold(0.0, |a: f64, b| a.max(b.abs()));
        assert_eq!(table.time.len(), 301);
        let mut given = 0.0;
        for n in 1..=300 {
            // The force of which step the shaker holds: the last, or this one if the bed goes first or both iterate.
            given += h * force[if together { n } else { n - 1 }];
            let apart = match coupling {
                Coupling::Iterated => 1e-6 * h * n as f64 * peak,
                _ => 1e-12,
            };
            assert!((impulse[n] - given).abs() < apart, "{coupling:?} row {n}");
            let lost = momentum[n - 1] - momentum[n] - h * mass * GRAVITY;
            let gap = (lost - h * force[n]).abs();
            assert!(
                gap < 1e-9 * h * mass * GRAVITY,
                "{coupling:?} row {n}: {gap:e}"
            );
        }
        // Grains are thrown and caught: there is something to balance.
        let least = force.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(least < -2.0 * mass * GRAVITY, "{coupling:?}: {least}");
        // The tray is where the shaker was told to be: at the end of this step, or of the one before.
        let late = usize::from(coupling == Coupling::Jacobi || bed_first);
        let (x, tray) = (
            column("shaker.position"),
            column("bed.boundary.tray.position[3]"),
        );
        assert!((1..=300).all(|n| (tray[n] - x[n - late]).abs() < 1e-15));
    }
}

/// A mass that lies on the tray, as an exchange between two programs makes of it: the tray moves from X_n to X_(n+1)
/// in step n, the mass with it, so that the mean force is m_g ((X_(n+1) - 2 X_n + X_(n-1)) / h^2 + g) downward.
///
/// A support carries the mass at rest; the shaker begins with the velocity `v0` \[m/s\].
fn by_hand(coupling: Coupling, grain: f64, v0: f64, h: f64, steps: usize) -> Vec<f64> {
    let (mut state, mut tray) = ([0.0, v0], [0.0, 0.0]);
    let mut forces = vec![-grain * GRAVITY];
    for n in 0..steps {
        let before = state[0];
        state = free_step(state, SHAKER[0], forces[n] + grain * GRAVITY, h);
        let next = match coupling {
            Coupling::GaussSeidel => state[0],
            _ => before,
        };
        let [x, last] = tray;
        forces.push(-grain * ((next - 2.0 * x + last) / (h * h) + GRAVITY));
        tray = [next, x];
    }
    forces
}

/// Largest fourth difference in a part of a series: what changes from step to step, without the slow swing.
fn jitter(series: &[f64]) -> f64 {
    let fourth = |w: &[f64]| (w[0] - 4.0 * w[1] + 6.0 * w[2] - 4.0 * w[3] + w[4]).abs();
    series.windows(5).map(fourth).fold(0.0, f64::max)
}

/// The limit is sqrt(5) - 1 for Jacobi, 2 for Gauss-Seidel, whatever the step: examples/two_fmus/README.md derives it.
#[test]
fn loose_coupling_is_stable_up_to_the_added_mass_limit() {
    let folder = tempfile::tempdir().unwrap();
    let shaker = shaker(folder.path());
    let density = 2.0 / (4.0 / 3.0 * std::f64::consts::PI * 0.05_f64.powi(3));
    for (coupling, limit) in [
        (Coupling::Jacobi, 5.0_f64.sqrt() - 1.0),
        (Coupling::GaussSeidel, 2.0),
    ] {
        for ratio in [0.85 * limit, 1.15 * limit] {
            let grain = SHAKER[0] * ratio;
            let bed = bed(folder.path(), "plate.toml", |text| {
                let before = format!("density = {density}");
                assert!(text.contains(&before), "{before}");
                *text = text.replace(&before, &format!("density = {}", density * ratio));
            });
            for h in [1e-3, 2.5e-4] {
                let options = Options {
                    stop: Some(200.0 * h),
                    step: Some(h),
                    coupling,
                    set: set(&[
                        ("shaker.amplitude", 0.0),
                        ("shaker.support", grain * GRAVITY),
                        ("shaker.velocity", 0.1 * h),
                        ("bed.solver.step", h),
                    ]),
                    ..Options::default()
                };
                let table = coupled([("shaker", &shaker), ("bed", &bed)], &options);
                let force = table.real(FORCE).unwrap();
                let expected = by_hand(coupling, grain, 0.1 * h, h, 200);
                // While the mass lies on the tray, the run is the recursion.
                let lies = expected.iter().take_while(|force| **force < 0.0).count();
                assert!(lies > 20, "{coupling:?} {ratio} {h}: {lies}");
                for n in 0..lies {
                    let error = (force[n] - expected[n]).abs() / (grain * GRAVITY);
                    assert!(error < 1e-3, "{coupling:?} {ratio} {h} row {n}: {error:e}");
                }
                let (early, late) = (jitter(&force[5..30]), jitter(&force[150..]));
                if ratio < limit {
                    assert!(
                        lies == 201 && late < 0.02 * early,
                        "{coupling:?} {ratio} {h}: {early:e} {late:e}"
                    );
                } else {
                    assert!(
                        lies < 201 && late > 5.0 * early,
                        "{coupling:?} {ratio} {h}: {early:e} {late:e}"
                    );
                }
            }
        }
    }
}

/// The same recursion with the force of the step itself, which depends on where the tray goes under it: affine, so that
/// two tries tell it.
fn by_hand_together(grain: f64, v0: f64, h: f64, steps: usize) -> Vec<f64> {
    let (mut state, mut tray) = ([0.0, v0], [0.0, 0.0]);
    let mut forces = vec![-grain * GRAVITY];
    for _ in 0..steps {
        let [x, last] = tray;
        let answer = |force: f64| {
            let next = free_step(state, SHAKER[0], force + grain * GRAVITY, h)[0];
            -grain * ((next - 2.0 * x + last) / (h * h) + GRAVITY)
        };
        let (at_zero, slope) = (answer(0.0), answer(1.0) - answer(0.0));
        let force = at_zero / (1.0 - slope);
        state = free_step(state, SHAKER[0], force + grain * GRAVITY, h);
        forces.push(force);
        tray = [state[0], x];
    }
    forces
}

/// Beyond the limits of loose coupling: a = -(q/2)(a + a_before), so |z| = q / (2 + q) < 1 for every ratio q.
#[test]
fn iterated_coupling_is_stable_beyond_the_limit() {
    let folder = tempfile::tempdir().unwrap();
    let shaker = shaker(folder.path());
    let density = 2.0 / (4.0 / 3.0 * std::f64::consts::PI * 0.05_f64.powi(3));
    for ratio in [4.0, 10.0] {
        let grain = SHAKER[0] * ratio;
        let bed = bed(folder.path(), "plate.toml", |text| {
            *text = text.replace(
                &format!("density = {density}"),
                &format!("density = {}", density * ratio),
            );
        });
        for h in [1e-3, 2.5e-4] {
            let options = Options {
                stop: Some(200.0 * h),
                step: Some(h),
                coupling: Coupling::Iterated,
                iteration: Iteration {
                    tolerance: 1e-8,
                    ..Iteration::default()
                },
                set: set(&[
                    ("shaker.amplitude", 0.0),
                    ("shaker.support", grain * GRAVITY),
                    ("shaker.velocity", 0.1 * h),
                    ("bed.solver.step", h),
                ]),
                ..Options::default()
            };
            let table = coupled([("shaker", &shaker), ("bed", &bed)], &options);
            let force = table.real(FORCE).unwrap();
            let expected = by_hand_together(grain, 0.1 * h, h, 200);
            for n in 0..=200 {
                let error = (force[n] - expected[n]).abs() / (grain * GRAVITY);
                assert!(error < 1e-3, "{ratio} {h} row {n}: {error:e}");
            }
            let (early, late) = (jitter(&force[1..26]), jitter(&force[150..]));
            assert!(late < 0.02 * early, "{ratio} {h}: {early:e} {late:e}");
            let most = table.iterations.iter().max();
            assert!(most <= Some(&6), "{:?}", table.iterations);
        }
    }
}
