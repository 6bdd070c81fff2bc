//! Strong coupling: steps are repeated until what is exchanged at their end agrees.

use sphere_dda_master::{
    Coupling, End, Fmu, Iteration, Options, SimulateError, System, Table, Values,
};

use crate::drive;
use crate::foreign_fmu::{Build, pack};

const NAMES: [&str; 2] = ["a", "b"];

/// Two oscillators whose displacements are each other's forces: m x'' + c x' + k x = y and the other way round.
fn pair(build: Build, edit: fn(&mut String)) -> (tempfile::TempDir, Vec<Fmu>) {
    let folder = tempfile::tempdir().unwrap();
    let open = |name: &str| {
        let path = folder.path().join(format!("{name}.fmu"));
        pack(&path, build, |xml| {
            *xml = xml
                .replace("<Real unit=\"m\"", "<Real")
                .replace("<Real unit=\"N\"", "<Real");
            edit(xml);
        });
        Fmu::open(&path).unwrap()
    };
    let fmus = NAMES.map(open).into();
    (folder, fmus)
}

fn system(fmus: &[Fmu]) -> System<'_> {
    let names = NAMES.map(str::to_owned).into_iter();
    let mut system = System::coupled(names.zip(fmus)).unwrap();
    let pairs = [("a.mass.x", "b.force[1]"), ("b.mass.x", "a.force[1]")];
    system.connect(pairs).unwrap();
    system
}

fn options(coupling: Coupling, step: f64) -> Options {
    Options {
        coupling,
        step: Some(step),
        stop: Some(2.0),
        iteration: Iteration {
            tolerance: 1e-12,
            ..Iteration::default()
        },
        set: vec![("b.mass.x".to_owned(), "-0.5".to_owned())],
        ..Options::default()
    }
}

/// One step of an oscillator under a force that is held, in closed form.
fn step([x, v]: [f64; 2], force: f64, h: f64) -> [f64; 2] {
    let (m, c, k) = (2.0_f64, 0.4, 8.0);
    let (decay, rest) = (c / (2.0 * m), force / k);
    let omega = (k / m - decay * decay).sqrt();
    let (a, e) = (x - rest, (-decay * h).exp());
    let b = (v + decay * a) / omega;
    let (sin, cos) = (omega * h).sin_cos();
    [
        rest + e * (a * cos + b * sin),
        e * ((b * omega - decay * a) * cos - (a * omega + decay * b) * sin),
    ]
}

fn real<'t>(table: &'t Table, name: &str) -> &'t [f64] {
    table.real(name).unwrap()
}

/// Both hold over the step what the other has at its end: the implicit equations, solved here by plain repetition.
#[test]
fn the_exchanged_values_are_those_of_the_end_of_the_step() {
    let (_folder, fmus) = pair(Build::Whole, |_| ());
    let h = 0.05;
    let table = drive(&system(&fmus), &options(Coupling::Iterated, h)).unwrap();
    assert_eq!(
        (table.end, table.time.len(), table.iterations.len()),
        (End::Stop, 41, 40)
    );
    let (mut a, mut b) = ([1.0, 0.0], [-0.5, 0.0]);
    for row in 0..41 {
        for (state, name) in [(a, "a.mass.x"), (b, "b.mass.x")] {
            let x = real(&table, name)[row];
            assert!(
                (x - state[0]).abs() < 1e-10,
                "{name} {row}: {x} is not {}",
                state[0]
            );
        }
        let (mut x, mut y) = (a[0], b[0]);
        for _ in 0..200 {
            x = step(a, y, h)[0];
            y = step(b, x, h)[0];
        }
        (a, b) = (step(a, y, h), step(b, x, h));
    }
    // `steps` counts every step that the FMU has done: iterations that were given up are rolled back.
    let steps = table.columns.iter().find(|c| c.name == "a.steps").unwrap();
    assert_eq!(steps.values.get(40), Values::Integer(vec![40]).get(0));
    let most = table.iterations.iter().max().unwrap();
    assert!(*most <= 5, "{:?}", table.iterations);
}

#[test]
fn a_coupling_that_does_not_come_to_rest_is_an_error_that_names_the_value() {
    let (_folder, fmus) = pair(Build::Whole, |_| ());
    let options = Options {
        iteration: Iteration {
            max_iterations: 2,
            tolerance: 1e-13,
            ..Iteration::default()
        },
        ..options(Coupling::Iterated, 0.5)
    };
    let error = drive(&system(&fmus), &options).unwrap_err();
    let told = error.to_string();
    assert!(
        told.starts_with("at time 0 s: `b.mass.x` changes by ")
            && told.contains("after 2 iterations"),
        "{told}"
    );
    assert_eq!(error.table().unwrap().time, [0.0]);
    for (tolerance, max_iterations, relaxation) in [
        (0.0, 9, 0.5),
        (1e-3, 0, 0.5),
        (1e-3, 9, 1.5),
        (f64::NAN, 9, 0.5),
    ] {
        let options = Options {
            iteration: Iteration {
                tolerance,
                max_iterations,
                relaxation,
                accept_unconverged: false,
            },
            ..options.clone()
        };
        let error = drive(&system(&fmus), &options).unwrap_err();
        assert!(matches!(error, SimulateError::Iteration { .. }), "{error}");
    }
}

#[test]
fn fmus_without_states_are_iterated_only_where_nothing_comes_back() {
    let (_folder, fmus) = pair(Build::WithoutStates, |xml| {
        *xml = xml.replace("canGetAndSetFMUstate=\"true\"", "");
    });
    let error = drive(&system(&fmus), &options(Coupling::Iterated, 0.05)).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("FMU `a`: found no canGetAndSetFMUstate"),
        "{error}"
    );
    let names = NAMES.map(str::to_owned).into_iter();
    let mut chain = System::coupled(names.zip(&fmus)).unwrap();
    chain.connect([("a.mass.x", "b.force[1]")]).unwrap();
    let iterated = drive(&chain, &options(Coupling::Iterated, 0.05)).unwrap();
    let once = drive(&chain, &options(Coupling::GaussSeidel, 0.05)).unwrap();
    assert_eq!(iterated.columns, once.columns);
    assert_eq!(iterated.iterations, vec![1; 40]);
}

/// What a run that goes on keeps is the best of the iterations. The oscillators are linear in what they exchange, so a third
/// try settles what two do not.
#[test]
fn a_run_can_go_on_with_values_that_do_not_agree() {
    let (_folder, fmus) = pair(Build::Whole, |_| ());
    let coarse = |limit| Options {
        iteration: Iteration {
            max_iterations: limit,
            tolerance: 1e-15,
            accept_unconverged: true,
            ..Iteration::default()
        },
        ..options(Coupling::Iterated, 0.5)
    };
    let tables = [2, 3].map(|limit| drive(&system(&fmus), &coarse(limit)).unwrap());
    let exact = drive(&system(&fmus), &options(Coupling::Iterated, 0.5)).unwrap();
    let worst = |table: &Table| {
        let left = table.not_converged.iter().map(|step| step.change);
        left.fold(0.0, f64::max)
    };
    let off = |table: &Table| (real(table, "a.mass.x")[1] - real(&exact, "a.mass.x")[1]).abs();
    for table in &tables {
        assert_eq!((table.end, table.time.len()), (End::Stop, 5));
        // The iterations that were given up have left nothing behind.
        let steps = table.columns.iter().find(|c| c.name == "b.steps").unwrap();
        assert_eq!(steps.values.get(4), Values::Integer(vec![4]).get(0));
    }
    assert_eq!(tables[0].not_converged[0].time, 0.0);
    assert_eq!(
        tables[0].iterations[0], 3,
        "two iterations, and the better again"
    );
    assert!(worst(&tables[0]) > 1e-3, "{:?}", tables[0].not_converged);
    assert!(
        off(&tables[0]) > 10.0 * off(&tables[1]),
        "{} {}",
        off(&tables[0]),
        off(&tables[1])
    );
}

/// Fault: an FMU that wanted to end in a trial, under values that were not the step's, ended the run.
#[test]
fn an_end_in_a_trial_that_did_not_agree_does_not_count() {
    let (_folder, fmus) = pair(Build::Whole, |_| ());
    let one = |coupling| Options {
        stop: Some(0.5),
        ..options(coupling, 0.5)
    };
    let first = |table: &Table| real(table, "a.mass.x")[1];
    let exact = drive(&system(&fmus), &one(Coupling::Iterated)).unwrap();
    // The first trial is the step of Gauss and Seidel.
    let trial = first(&drive(&system(&fmus), &one(Coupling::GaussSeidel)).unwrap());
    let agreed = first(&exact);
    assert!((trial - agreed).abs() > 1e-3, "{trial} {agreed}");
    let between = (0.5 * (trial + agreed)).to_string();
    let ends = |fault: &str| {
        let mut options = one(Coupling::Iterated);
        for (name, value) in [("a.fault", fault), ("a.faultTime", &between)] {
            options.set.push((name.to_owned(), value.to_owned()));
        }
        drive(&system(&fmus), &options).unwrap()
    };
    let (passed, stayed) = match trial < agreed {
        true => ("down", "up"),
        false => ("up", "down"),
    };
    let table = ends(passed);
    assert_eq!((table.end, first(&table)), (End::Stop, agreed));
    assert_ne!(ends(stayed).end, End::Stop);
}
