//! FMUs that step at the same time: they do, with the bits of one after another, and errors keep their names.

use sphere_dda_master::{Coupling, End, Fmu, ImportError, Options, SimulateError, System};

use crate::drive;
use crate::foreign_fmu::{Build, pack};

/// An oscillator whose displacement can be another's force.
fn oscillator(edit: fn(&mut String)) -> (tempfile::TempDir, Fmu) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("oscillator.fmu");
    pack(&path, Build::Whole, |xml| {
        *xml = xml
            .replace("<Real unit=\"m\"", "<Real")
            .replace("<Real unit=\"N\"", "<Real");
        edit(xml);
    });
    let fmu = Fmu::open(&path).unwrap();
    (folder, fmu)
}

/// Instances of one library, each driven by the one before it, the first by the last.
fn ring<'f>(names: &[&str], fmu: &'f Fmu) -> System<'f> {
    let named = names.iter().map(|name| ((*name).to_owned(), fmu));
    let mut system = System::coupled(named).unwrap();
    let pairs: Vec<_> = (0..names.len())
        .map(|k| {
            let next = names[(k + 1) % names.len()];
            (format!("{}.mass.x", names[k]), format!("{next}.force[1]"))
        })
        .collect();
    let pairs = pairs.iter().map(|(from, to)| (&**from, &**to));
    system.connect(pairs).unwrap();
    system
}

fn set(pairs: &[(&str, &str)]) -> Options {
    Options {
        set: pairs
            .iter()
            .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
            .collect(),
        stop: Some(0.5),
        ..Options::default()
    }
}

/// Each waits within its step until all have begun theirs, which one after another would never do.
#[test]
fn two_and_three_step_at_the_same_time() {
    for names in [&["a", "b"][..], &["a", "b", "c"]] {
        let (_folder, fmu) = oscillator(|_| ());
        let system = ring(names, &fmu);
        let mut options = set(&[]);
        let count = names.len().to_string();
        for name in names {
            options.set.push((format!("{name}.fault"), "meet".into()));
            options
                .set
                .push((format!("{name}.faultTime"), count.clone()));
        }
        let table = drive(&system, &options).unwrap();
        assert_eq!((table.end, table.time.len()), (End::Stop, 11));
    }
}

#[test]
fn the_results_are_those_of_one_after_another() {
    let (_folder, fmu) = oscillator(|_| ());
    let names = ["a", "b", "c"];
    let system = ring(&names, &fmu);
    let start = set(&[
        ("b.mass.x", "-0.3"),
        ("c.mass.x", "0.7"),
        ("c.stiffness", "5"),
    ]);
    let at_once = drive(&system, &start).unwrap();
    let sequential = Options {
        sequential: true,
        ..start
    };
    let expected = drive(&system, &sequential).unwrap();
    assert!(expected.real("c.mass.x").unwrap()[10] != expected.real("a.mass.x").unwrap()[10]);
    assert_eq!(at_once, expected);
}

#[test]
fn what_fails_or_ends_is_named_as_one_after_another() {
    let (_folder, fmu) = oscillator(|_| ());
    let system = ring(&["a", "b", "c"], &fmu);
    for sequential in [false, true] {
        // The first that fails, whichever comes back first; what it logged is its own.
        let options = Options {
            sequential,
            ..set(&[
                ("b.fault", "fmi2DoStep:3"),
                ("b.faultTime", "0.2"),
                ("c.fault", "fmi2DoStep:3"),
                ("c.faultTime", "0.2"),
            ])
        };
        let error = drive(&system, &options).unwrap_err();
        let SimulateError::Call {
            time,
            component,
            failure,
            table,
        } = &error
        else {
            panic!("{error}");
        };
        assert_eq!((*time, component.as_deref()), (0.2, Some("b")));
        assert_eq!(table.time.len(), 5);
        let ImportError::Call { log, .. } = &**failure else {
            panic!("{failure}");
        };
        assert_eq!(log, &["failed on purpose, 100 %"]);
        // One that wants to end ends the run for all.
        let options = Options {
            sequential,
            ..set(&[("c.fault", "terminate"), ("c.faultTime", "0.22")])
        };
        let table = drive(&system, &options).unwrap();
        assert_eq!((table.end, table.time.len()), (End::Terminated, 5));
    }
}

/// An FMU that allows one instance has globals that a second instance would share, with or without threads.
#[test]
fn an_fmu_of_one_instance_per_process_is_not_taken_twice() {
    let (_folder, fmu) = oscillator(|xml| {
        *xml = xml.replace(
            "<CoSimulation ",
            "<CoSimulation canBeInstantiatedOnlyOncePerProcess=\"true\" ",
        );
    });
    let error = drive(&ring(&["a", "b"], &fmu), &set(&[])).unwrap_err();
    let told = error.to_string();
    assert!(told.contains("only once per process"), "{told}");
    assert!(told.starts_with("b: "), "{told}");
    let alone = set(&[]);
    assert_eq!(drive(&System::of(&fmu), &alone).unwrap().end, End::Stop);
    assert_eq!(alone.coupling, Coupling::Jacobi);
}
