//! FMUs of FMI 3.0 whose events the importer handles: `tests/foreign_fmu/events.c` refuses to work without.

use sphere_dda_master::{
    Coupling, End, Fmu, InputTable, Options, SimulateError, System, Table, Values,
};

use crate::foreign_fmu::{pack_events, pack_reference};
use crate::{drive, run, with};

fn events(any_step: bool) -> (tempfile::TempDir, Fmu) {
    let folder = tempfile::tempdir().unwrap();
    let fmu = Fmu::open(pack_events(folder.path(), any_step)).unwrap();
    (folder, fmu)
}

fn counts<'t>(table: &'t Table, name: &str) -> &'t [i64] {
    let column = table.columns.iter().find(|column| column.name == name);
    match column.map(|column| &column.values) {
        Some(Values::Integer(values)) => values,
        other => panic!("{name}: {other:?}"),
    }
}

/// The bell rings every 0.25 s, the level falls by 0.37 every 0.37 s, whatever the step: events take place when they do.
#[test]
fn events_take_place_at_their_times() {
    let (_folder, fmu) = events(true);
    for (step, updates) in [(0.1, "1"), (0.125, "3"), (1.0, "2"), (0.037, "1")] {
        let options = Options {
            step: Some(step),
            ..with(&[("updates", updates)])
        };
        let table = run(&fmu, &options).unwrap();
        assert_eq!(table.end, End::Stop);
        let level = table.real("level").unwrap();
        for (row, t) in table.time.iter().enumerate() {
            let resets = (t / 0.37 + 1e-9).floor();
            assert_eq!(
                counts(&table, "rings")[row] as f64,
                (t / 0.25 + 1e-9).floor(),
                "at {t}"
            );
            assert_eq!(counts(&table, "resets")[row] as f64, resets, "at {t}");
            assert!((level[row] - (t - 0.37 * resets)).abs() < 1e-9, "at {t}");
        }
        let early = *counts(&table, "early").last().unwrap();
        assert_eq!(early, if step == 0.037 { 0 } else { 5 }, "step {step}");
    }
}

/// Steps of one length do not end early: events are handled where the next of them ends.
#[test]
fn events_wait_for_the_end_of_a_step_of_one_length() {
    let (_folder, fmu) = events(false);
    let table = run(&fmu, &Options::default()).unwrap();
    assert_eq!(table.time.len(), 21);
    // A bell that is late by less than a step rings as often.
    for (row, t) in table.time.iter().enumerate() {
        let rings = counts(&table, "rings")[row] as f64;
        assert_eq!(rings, (t / 0.25 + 1e-9).floor(), "at {t}");
        let level = table.real("level").unwrap()[row];
        let resets = counts(&table, "resets")[row] as f64;
        assert!(
            (level - (t - 0.37 * resets)).abs() < 1e-9 && level < 0.37,
            "at {t}"
        );
    }
    assert_eq!(counts(&table, "early")[20], 0);
}

/// A discrete input that changes is an event, one that is set to what it is already is none.
#[test]
fn a_change_of_a_discrete_input_is_an_event() {
    let (_folder, fmu) = events(true);
    let system = System::of(&fmu);
    let text = "time,load\n0,1\n0.5,2\n1,2\n1.5,7\n";
    let options = Options {
        inputs: Some(InputTable::read(text.as_bytes(), "drive.csv", &system).unwrap()),
        step: Some(0.5),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    // A row shows what was there before the inputs of its time.
    assert_eq!(counts(&table, "sum"), [0, 0, 2, 2, 9]);
}

/// Repeated steps go back to the events that lie before them, and to the inputs that were set then.
#[test]
fn iterated_steps_repeat_their_events() {
    let folder = tempfile::tempdir().unwrap();
    let bell = Fmu::open(pack_events(folder.path(), true)).unwrap();
    let wire = Fmu::open(pack_reference(folder.path(), "Feedthrough")).unwrap();
    let parts = [("wire", &wire), ("bell", &bell)];
    let parts = parts.map(|(name, fmu)| (name.to_owned(), fmu));
    let mut system = System::coupled(parts).unwrap();
    system
        .connect([
            ("bell.level", "wire.Float64_continuous_input"),
            ("wire.Int32_output", "bell.load"),
        ])
        .unwrap();
    let text = "time,wire.Int32_input\n0,0\n1.1,3\n";
    let options = Options {
        coupling: Coupling::Iterated,
        step: Some(0.1),
        stop: Some(2.0),
        inputs: Some(InputTable::read(text.as_bytes(), "drive.csv", &system).unwrap()),
        ..Options::default()
    };
    let table = drive(&system, &options).unwrap();
    // The level falls at 0.74 s and 1.11 s, which no guess foresees; the bell rings at 0.75 s, the load changes at 1.1 s.
    let iterations = &table.iterations;
    assert!(iterations[7] > 1 && iterations[11] > 1, "{iterations:?}");
    for (row, t) in table.time.iter().enumerate() {
        let rings = (t / 0.25 + 1e-9).floor();
        assert_eq!(counts(&table, "bell.rings")[row] as f64, rings, "at {t}");
        let sum = if *t > 1.15 { 3 } else { 0 };
        assert_eq!(counts(&table, "bell.sum")[row], sum, "at {t}");
        let level = table.real("bell.level").unwrap()[row];
        let handed = table.real("wire.Float64_continuous_output").unwrap()[row];
        assert!((handed - level).abs() < 1e-6, "at {t}");
    }
}

#[test]
fn an_event_can_end_the_simulation_or_have_no_end() {
    let (_folder, fmu) = events(true);
    let table = run(&fmu, &with(&[("last", "1.2")])).unwrap();
    assert_eq!(table.end, End::Terminated);
    // The first event after 1.2 s is the bell's at 1.25 s.
    assert_eq!(table.time.last(), Some(&1.25));
    assert_eq!(counts(&table, "rings").last(), Some(&5));

    let error = run(&fmu, &with(&[("updates", "-1")])).unwrap_err();
    assert!(matches!(error, SimulateError::Call { .. }), "{error}");
    let told = error.to_string();
    assert!(
        told.contains("fmi3UpdateDiscreteStates: found 1000 calls at one time"),
        "{told}"
    );
}
