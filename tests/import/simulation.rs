//! The master: times, values, inputs, failures on the way.

use std::ops::ControlFlow;

use sphere_dda_master::{
    End, Event, Fmu, InputTable, InputTableError, Options, SimulateError, System, Values,
    VariableError, simulate,
};

use crate::foreign_fmu::{Build, pack};
use crate::{closed_form, open, run, trace, with};

#[test]
fn simulation_equals_the_closed_form() {
    let (_folder, fmu) = open(Build::Whole);
    let table = run(&fmu, &Options::default()).unwrap();
    assert_eq!(table.end, End::Stop);
    assert_eq!(table.time.len(), 41);
    assert_eq!(table.time.last(), Some(&2.0));
    for (t, x) in table.time.iter().zip(table.real("mass.x").unwrap()) {
        assert!((x - closed_form(*t, 1.0, 0.0)).abs() < 1e-13, "{t}: {x}");
    }
    let names: Vec<&str> = table.columns.iter().map(|column| &*column.name).collect();
    assert_eq!(
        names,
        ["mass.x", "mass.v", "echo", "steps", "levelEcho", "greeting"]
    );
    let life = trace(&fmu);
    assert_eq!(
        life[..4],
        [
            "fmi2Instantiate",
            "fmi2SetupExperiment",
            "fmi2EnterInitializationMode",
            "fmi2ExitInitializationMode"
        ]
    );
    assert_eq!(life.iter().filter(|call| *call == "fmi2DoStep").count(), 40);
    assert_eq!(life[44..], ["fmi2Terminate", "fmi2FreeInstance"]);
}

#[test]
fn communication_points_are_not_accumulated_and_end_on_stop() {
    let (_folder, fmu) = open(Build::Whole);
    let times = |stop, step| {
        let options = Options {
            stop: Some(stop),
            step: Some(step),
            ..Options::default()
        };
        run(&fmu, &options).unwrap()
    };
    let table = times(3.0, 0.1);
    assert_eq!(table.time.len(), 31);
    for (k, time) in table.time.iter().enumerate().take(30) {
        assert_eq!(*time, k as f64 * 0.1);
    }
    let table = times(0.25, 0.1);
    assert_eq!(table.time, [0.0, 0.1, 0.2, 0.25]);
    let x = table.real("mass.x").unwrap();
    assert!((x[3] - closed_form(0.25, 1.0, 0.0)).abs() < 1e-14);
    assert_eq!(times(0.0, 0.1).time, [0.0]);

    for (stop, step) in [
        (1.0, 0.0),
        (1.0, -0.1),
        (-1.0, 0.1),
        (f64::NAN, 0.1),
        (1.0, 1e-300),
    ] {
        let options = Options {
            stop: Some(stop),
            step: Some(step),
            ..Options::default()
        };
        let error = run(&fmu, &options).unwrap_err();
        assert!(matches!(error, SimulateError::Times { .. }), "{error}");
    }
}

#[test]
fn values_of_every_type_are_set() {
    let (_folder, fmu) = open(Build::Whole);
    let options = with(&[
        ("label", "you, \"there\""),
        ("frozen", "true"),
        ("level", "high"),
        ("mass.m", "3.5"),
    ]);
    let table = run(&fmu, &options).unwrap();
    let last = |name: &str| {
        let column = table.columns.iter().find(|column| column.name == name);
        let values = &column.unwrap().values;
        values.get(table.time.len() - 1).unwrap().to_string()
    };
    assert_eq!(last("greeting"), "hello, you, \"there\"");
    assert_eq!(last("levelEcho"), "2");
    assert_eq!(last("mass.x"), "1.0");
    let mut csv = Vec::new();
    table.write_csv(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    let line = csv.lines().nth(1).unwrap();
    assert_eq!(line, "0.0,1.0,0.0,0.0,0,0,\"hello, you, \"\"there\"\"\"");

    let refused = |set: &[(&str, &str)]| match run(&fmu, &with(set)).unwrap_err() {
        SimulateError::Variables(mut errors) => errors.pop().unwrap(),
        error => panic!("{error}"),
    };
    let error = refused(&[("damping.", "1")]);
    assert!(
        error.to_string().contains("did you mean `damping`"),
        "{error}"
    );
    let error = refused(&[("mass.m", "heavy")]);
    assert!(error.to_string().contains("a finite number"), "{error}");
    let error = refused(&[("level", "middle")]);
    assert!(error.to_string().contains("`low`, `high`"), "{error}");
    assert!(matches!(
        refused(&[("mass.m", "NaN")]),
        VariableError::Value { .. }
    ));
    assert!(matches!(
        refused(&[("steps", "1")]),
        VariableError::NotSettable { .. }
    ));
}

#[test]
fn inputs_are_linear_or_held_and_jump_at_double_times() {
    let (_folder, fmu) = open(Build::Whole);
    let text = "\u{feff}time,\"force[1]\", level\n\
                0.5, 0, low\n\
                1, 5, high\n\
                1, 10, low\n\
                1.5, 20, 2\n";
    let signals = InputTable::read(text.as_bytes(), "drive.csv", &System::of(&fmu)).unwrap();
    let options = Options {
        inputs: Some(signals),
        ..Options::default()
    };
    let table = run(&fmu, &options).unwrap();
    // The row after a step shows what was held over the step: the values where it began.
    let at = |k: usize| {
        let echo = table.real("echo").unwrap()[k + 1];
        let column = table
            .columns
            .iter()
            .find(|column| column.name == "levelEcho");
        match &column.unwrap().values {
            Values::Integer(levels) => (echo, levels[k + 1]),
            values => panic!("{values:?}"),
        }
    };
    for (k, force, level) in [
        (0, 0.0, 1),
        (10, 0.0, 1),
        (15, 2.5, 1),
        (19, 4.5, 1),
        (20, 10.0, 1),
        (25, 15.0, 1),
        (30, 20.0, 2),
        (39, 20.0, 2),
    ] {
        let (echo, echoed_level) = at(k);
        assert!((echo - force).abs() < 1e-12, "{k}: {echo} is not {force}");
        assert_eq!(echoed_level, level, "{k}");
    }
}

#[test]
fn bad_tables_of_inputs_are_refused_with_their_place() {
    let (_folder, fmu) = open(Build::Whole);
    for (text, part) in [
        ("", "expected `time`"),
        (
            "t,force[1]\n0,1\n",
            "found first column \"t\", expected `time`",
        ),
        ("time,force[1]\n", "no line of values"),
        (
            "time,force[2]\n0,1\n",
            "line 1: variable: found `force[2]`, expected a name in the model description: did you mean `force[1]`",
        ),
        (
            "time,mass.x\n0,1\n",
            "expected an input or a tunable parameter",
        ),
        (
            "time,mass.m\n0,1\n",
            "expected an input or a tunable parameter",
        ),
        ("time,force[1],force[1]\n0,1,1\n", "column `force[1]` twice"),
        (
            "time,force[1]\n0,1\n1,x\n",
            "line 3: variable `force[1]`: found \"x\", expected a finite number",
        ),
        (
            "time,force[1]\n0,nan\n",
            "line 2: variable `force[1]`: found \"nan\"",
        ),
        ("time,force[1]\n1,1\n0,1\n", "line 3: found time \"0\""),
        ("time,force[1]\ninf,1\n", "line 2: found time \"inf\""),
        ("time,force[1]\n0\n", "as many in each line"),
    ] {
        let error = InputTable::read(text.as_bytes(), "drive.csv", &System::of(&fmu)).unwrap_err();
        let message = error.to_string();
        assert!(message.starts_with("drive.csv"), "{message}");
        assert!(message.contains(part), "{text:?}: {message}");
    }
    let error = InputTable::from_csv("/no/such.csv", &System::of(&fmu)).unwrap_err();
    assert!(matches!(error, InputTableError::Open { .. }), "{error}");
}

#[test]
fn what_was_recorded_before_an_error_is_kept() {
    let (_folder, fmu) = open(Build::Whole);
    let options = with(&[("fault", "fmi2DoStep:3"), ("faultTime", "1")]);
    let error = run(&fmu, &options).unwrap_err();
    let table = error.table().unwrap();
    assert_eq!(table.time.len(), 21);
    assert!(
        error.to_string().starts_with("at time 1 s: fmi2DoStep"),
        "{error}"
    );
}

#[test]
fn nan_is_an_error_unless_allowed() {
    let (_folder, fmu) = open(Build::Whole);
    let mut options = with(&[("fault", "nan"), ("faultTime", "1")]);
    let error = run(&fmu, &options).unwrap_err();
    let SimulateError::Nan { time, variable, .. } = &error else {
        panic!("{error}");
    };
    assert_eq!((*time, &**variable), (1.05, "mass.x"));
    options.allow_nan = true;
    assert_eq!(run(&fmu, &options).unwrap().time.len(), 41);
}

#[test]
fn discarded_steps_are_taken_up_again_or_end_the_simulation() {
    let (_folder, fmu) = open(Build::Whole);
    // "crumbs": 25 parts that come on are no failed attempts. Fault: more than 12 ended the run with "no progress".
    for fault in ["short", "half", "crumbs"] {
        let table = run(&fmu, &with(&[("fault", fault)])).unwrap();
        assert_eq!(table.time.len(), 41, "{fault}");
        for (t, x) in table.time.iter().zip(table.real("mass.x").unwrap()) {
            assert!(
                (x - closed_form(*t, 1.0, 0.0)).abs() < 1e-12,
                "{fault} {t}: {x}"
            );
        }
    }

    let options = with(&[("fault", "terminate"), ("faultTime", "0.72")]);
    let table = run(&fmu, &options).unwrap();
    assert_eq!(table.end, End::Terminated);
    assert_eq!(table.time.last(), Some(&0.72));
    let x = table.real("mass.x").unwrap();
    assert!((x[x.len() - 1] - closed_form(0.72, 1.0, 0.0)).abs() < 1e-13);

    let (_folder, fmu) = open(Build::Whole);
    let error = run(&fmu, &with(&[("fault", "fmi2DoStep:2")])).unwrap_err();
    assert!(
        matches!(error, SimulateError::Discarded { time: 0.0, .. }),
        "{error}"
    );
    let steps = trace(&fmu)
        .iter()
        .filter(|call| *call == "fmi2DoStep")
        .count();
    assert!(steps < 200, "{steps}");

    // One that needs steps of one length gets no others.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("even.fmu");
    pack(&path, Build::Whole, |xml| {
        *xml = xml.replace("canHandleVariableCommunicationStepSize=\"true\"", "");
    });
    let fmu = Fmu::open(&path).unwrap();
    let error = run(&fmu, &with(&[("fault", "short")])).unwrap_err();
    assert!(error.to_string().contains("steps of one length"), "{error}");
    let options = Options {
        stop: Some(0.12),
        ..Options::default()
    };
    let error = run(&fmu, &options).unwrap_err();
    assert!(matches!(error, SimulateError::Uneven { .. }), "{error}");
}

#[test]
fn the_observer_can_end_the_simulation() {
    let (_folder, fmu) = open(Build::Whole);
    let table = simulate(
        &System::of(&fmu),
        &Options::default(),
        |event| match event {
            Event::Time { step: 7, .. } => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        },
    )
    .unwrap();
    assert_eq!((table.end, table.time.len()), (End::Interrupted, 8));
    assert!(trace(&fmu).ends_with(&["fmi2Terminate".to_owned(), "fmi2FreeInstance".to_owned()]));
}

#[test]
fn instances_run_in_threads_of_their_own() {
    let (_folder, fmu) = open(Build::Whole);
    let one = run(&fmu, &Options::default()).unwrap();
    std::thread::scope(|scope| {
        let runs: Vec<_> = (0..8)
            .map(|_| scope.spawn(|| run(&fmu, &Options::default()).unwrap()))
            .collect();
        for run in runs {
            assert_eq!(run.join().unwrap(), one);
        }
    });
}
