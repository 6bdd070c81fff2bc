//! Several FMUs: who gets which value when, and connections that cannot be made.

use sphere_dda_master::{
    ConnectionFault, Coupling, End, Fmu, InputTable, Options, SimulateError, System, SystemError,
    Table, Values,
};

use crate::foreign_fmu::{Build, pack};
use crate::{closed_form, drive};

/// Oscillators, their descriptions edited.
fn oscillators(edits: &[fn(&mut String)]) -> (tempfile::TempDir, Vec<Fmu>) {
    let folder = tempfile::tempdir().unwrap();
    let open = |(k, edit): (usize, &fn(&mut String))| {
        let path = folder.path().join(format!("{k}.fmu"));
        pack(&path, Build::Whole, edit);
        Fmu::open(&path).unwrap()
    };
    let fmus = edits.iter().enumerate().map(open).collect();
    (folder, fmus)
}

/// Displacements as forces: the tests look at who gets what, not at mechanics.
fn without_units(xml: &mut String) {
    *xml = xml
        .replace("<Real unit=\"m\"", "<Real")
        .replace("<Real unit=\"N\"", "<Real");
}

fn system<'f>(names: &[&str], fmus: &'f [Fmu]) -> System<'f> {
    let names = names.iter().map(|name| (*name).to_owned());
    System::coupled(names.zip(fmus)).unwrap()
}

fn values<'t>(table: &'t Table, name: &str) -> &'t [f64] {
    table
        .real(name)
        .unwrap_or_else(|| panic!("no column {name}"))
}

#[test]
fn every_input_has_the_value_of_the_scheme() {
    let (_folder, fmus) = oscillators(&[without_units, without_units]);
    // `echo` is the force that was held over the step before.
    for (order, coupling, late) in [
        (["a", "b"], Coupling::Jacobi, 1),
        (["b", "a"], Coupling::Jacobi, 1),
        (["a", "b"], Coupling::GaussSeidel, 0),
        (["b", "a"], Coupling::GaussSeidel, 1),
    ] {
        let mut system = system(&order, &fmus);
        system.connect([("a.mass.x", "b.force[1]")]).unwrap();
        let options = Options {
            coupling,
            ..Options::default()
        };
        let table = drive(&system, &options).unwrap();
        assert_eq!((table.end, table.time.len()), (End::Stop, 41));
        let (x, echo) = (values(&table, "a.mass.x"), values(&table, "b.echo"));
        assert_eq!(echo[1..], x[1 - late..41 - late], "{order:?} {coupling:?}");
        for (t, x) in table.time.iter().zip(x) {
            assert!((x - closed_form(*t, 1.0, 0.0)).abs() < 1e-13);
        }
    }
}

/// Both ways: two oscillators that push each other, against the recursion done by hand with the closed form.
#[test]
fn a_loop_equals_the_recursion_by_hand() {
    let (_folder, fmus) = oscillators(&[without_units, without_units]);
    let (m, c, k, h) = (2.0_f64, 0.4, 8.0, 0.05);
    let step = |[x, v]: [f64; 2], force: f64| {
        let (decay, rest) = (c / (2.0 * m), force / k);
        let omega = (k / m - decay * decay).sqrt();
        let (a, e) = (x - rest, (-decay * h).exp());
        let b = (v + decay * a) / omega;
        let (s, c) = (omega * h).sin_cos();
        [
            rest + e * (a * c + b * s),
            e * ((b * omega - decay * a) * c - (a * omega + decay * b) * s),
        ]
    };
    for coupling in [Coupling::Jacobi, Coupling::GaussSeidel] {
        let mut system = system(&["a", "b"], &fmus);
        let pairs = [("a.mass.x", "b.force[1]"), ("b.mass.v", "a.force[1]")];
        system.connect(pairs).unwrap();
        let options = Options {
            coupling,
            set: vec![("b.mass.x".to_owned(), "-0.5".to_owned())],
            ..Options::default()
        };
        let table = drive(&system, &options).unwrap();
        let (mut a, mut b) = ([1.0, 0.0], [-0.5, 0.0]);
        for row in 0..table.time.len() {
            for (state, name) in [(a, "a"), (b, "b")] {
                let x = values(&table, &format!("{name}.mass.x"))[row];
                assert!((x - state[0]).abs() < 1e-12, "{coupling:?} {name} {row}");
            }
            let next = step(a, b[1]);
            let seen = if coupling == Coupling::Jacobi {
                a
            } else {
                next
            };
            (a, b) = (next, step(b, seen[0]));
        }
    }
}

#[test]
fn tables_and_records_use_the_names_of_the_system() {
    let (_folder, fmus) = oscillators(&[without_units, without_units]);
    let mut system = system(&["first", "second"], &fmus);
    system
        .connect([
            ("first.mass.x", "second.force[1]"),
            ("first.levelEcho", "second.level"),
        ])
        .unwrap_err();
    system
        .connect([("first.mass.x", "second.force[1]")])
        .unwrap();
    let text = "time,first.force[1],second.level\n0,3,high\n";
    let options = Options {
        inputs: Some(InputTable::read(text.as_bytes(), "drive.csv", &system).unwrap()),
        outputs: Some(vec!["second.levelEcho".to_owned(), "first.echo".to_owned()]),
        stop: Some(0.1),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    assert_eq!(table.columns[0].values, Values::Integer(vec![0, 2, 2]));
    assert_eq!(values(&table, "first.echo"), [0.0, 3.0, 3.0]);

    let twice = "time,second.force[1]\n0,3\n";
    let error = InputTable::read(twice.as_bytes(), "drive.csv", &system).unwrap_err();
    assert!(
        error.to_string().contains("`first.mass.x` feeds"),
        "{error}"
    );
    let options = Options {
        set: vec![("second.force[1]".to_owned(), "1".to_owned())],
        ..Options::default()
    };
    let error = drive(&system, &options).unwrap_err();
    assert!(
        error.to_string().contains("`first.mass.x` feeds"),
        "{error}"
    );
}

#[test]
fn connections_that_cannot_be_made_are_all_named() {
    fn millimetres(xml: &mut String) {
        *xml = xml.replace(
            "<BaseUnit kg=\"1\" m=\"1\" s=\"-2\"/>",
            "<BaseUnit kg=\"1\" m=\"1\" s=\"-2\" factor=\"1000\"/>",
        );
    }
    let (_folder, fmus) = oscillators(&[|_| (), without_units, millimetres]);
    let mut system = system(&["a", "b", "kilo"], &fmus);
    let pairs = [
        ("a.mass.x", "a.force[1]"),
        ("a.echo", "kilo.force[1]"),
        ("a.mass.y", "c.force[1]"),
        ("force[1]", "b.force[1]"),
        ("a.force[1]", "b.mass.x"),
        ("a.steps", "b.force[1]"),
        ("a.steps", "b.level"),
        ("a.echo", "b.force[1]"),
        ("b.echo", "b.force[1]"),
    ];
    let error = system.connect(pairs).unwrap_err();
    let told = error.to_string();
    for part in [
        "connection `a.mass.x` to `a.force[1]`: found units `m` and `N`, expected one unit",
        "found units `N` and `N (factor 1000 to SI)`",
        "found `a.mass.y`, expected `<FMU>.<variable>` with a name in the FMU's model description: did you mean `a.mass.",
        "found `c.force[1]`",
        "`a.force[1]` has causality Input, expected Output",
        "`b.mass.x` has causality Output, expected Input",
        "found types Integer and Real, expected one type",
        "found types Integer and Enumeration, expected one type",
        "connection `b.echo` to `b.force[1]`: the input is fed by `a.echo` already",
    ] {
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    let SystemError::Connections(errors) = error else {
        panic!("{error}");
    };
    assert_eq!(errors.len(), 10);
    let taken = errors
        .iter()
        .filter(|e| matches!(e.fault, ConnectionFault::Taken(_)));
    assert_eq!(taken.count(), 1);

    let twice = [("a", &fmus[0]), ("a", &fmus[1])];
    let error = System::coupled(twice.map(|(name, fmu)| (name.to_owned(), fmu))).unwrap_err();
    assert_eq!(error, SystemError::Twice("a".to_owned()));
}

#[test]
fn failures_name_the_fmu() {
    let (_folder, fmus) = oscillators(&[without_units, without_units]);
    let mut system = system(&["good", "bad"], &fmus);
    system.connect([("bad.mass.x", "good.force[1]")]).unwrap();
    let fault = |fault: &str| Options {
        set: vec![
            ("bad.fault".to_owned(), fault.to_owned()),
            ("bad.faultTime".to_owned(), "1".to_owned()),
        ],
        ..Options::default()
    };
    let error = drive(&system, &fault("fmi2DoStep:3")).unwrap_err();
    let told = error.to_string();
    assert!(
        told.starts_with("at time 1 s: bad: fmi2DoStep: found status Error"),
        "{told}"
    );
    assert_eq!(error.table().unwrap().time.len(), 21);

    // A NaN goes to no other FMU, recorded or not.
    let options = Options {
        outputs: Some(vec!["good.echo".to_owned()]),
        ..fault("nan")
    };
    let error = drive(&system, &options).unwrap_err();
    assert!(
        matches!(&error, SimulateError::Nan { variable, .. } if variable == "bad.mass.x"),
        "{error}"
    );
    assert!(
        values(error.table().unwrap(), "good.echo")
            .iter()
            .all(|force| force.is_finite())
    );

    // The last row is the last point that all have reached.
    let table = drive(&system, &fault("terminate")).unwrap();
    assert_eq!(table.end, End::Terminated);
    assert_eq!(table.time.last(), Some(&1.0));

    // A discarded step is taken up again by its FMU alone.
    let table = drive(&system, &fault("half")).unwrap();
    for (t, x) in table.time.iter().zip(values(&table, "bad.mass.x")) {
        assert!((x - closed_form(*t, 1.0, 0.0)).abs() < 1e-12);
    }
}
