//! The importer against an FMU that is not of this project: `tests/foreign_fmu`, built with `cc` here.

mod foreign_fmu;

use std::ops::ControlFlow;
use std::path::Path;

use foreign_fmu::{Build, entries, pack, write_archive};
use sphere_dda_fmu::import::{
    ArchiveError, End, Event, Fmu, ImportError, Limits, Options, Phase, Signals, SignalsError,
    SimulateError, Status, Step, Table, Values, VariableError, simulate,
};

fn open(build: Build) -> (tempfile::TempDir, Fmu) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("oscillator.fmu");
    pack(&path, build, |_| ());
    let fmu = Fmu::open(&path).unwrap();
    (folder, fmu)
}

fn run(fmu: &Fmu, options: &Options) -> Result<Table, SimulateError> {
    simulate(fmu, options, |_| ControlFlow::Continue(()))
}

fn with(set: &[(&str, &str)]) -> Options {
    Options {
        set: set
            .iter()
            .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
            .collect(),
        ..Options::default()
    }
}

fn trace(fmu: &Fmu) -> Vec<String> {
    let text = std::fs::read_to_string(fmu.folder().join("resources/trace.txt")).unwrap();
    text.lines().map(str::to_owned).collect()
}

/// Displacement [m] at `t` [s] of m x'' + c x' + k x = F from x0 at rest.
fn closed_form(t: f64, x0: f64, force: f64) -> f64 {
    let (m, c, k) = (2.0_f64, 0.4, 8.0);
    let (decay, rest) = (c / (2.0 * m), force / k);
    let omega = (k / m - decay * decay).sqrt();
    let a = x0 - rest;
    rest + (-decay * t).exp() * (a * (omega * t).cos() + a * decay / omega * (omega * t).sin())
}

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
        SimulateError::Variable(error) => error,
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
    let signals = Signals::read(text.as_bytes(), "drive.csv", fmu.description()).unwrap();
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
        let error = Signals::read(text.as_bytes(), "drive.csv", fmu.description()).unwrap_err();
        let message = error.to_string();
        assert!(message.starts_with("drive.csv"), "{message}");
        assert!(message.contains(part), "{text:?}: {message}");
    }
    let error = Signals::from_csv("/no/such.csv", fmu.description()).unwrap_err();
    assert!(matches!(error, SignalsError::Open { .. }), "{error}");
}

#[test]
fn a_failing_call_is_named_with_its_status_and_what_the_fmu_says() {
    for (function, code, status) in [
        ("fmi2SetReal", 3, Status::Error),
        ("fmi2EnterInitializationMode", 3, Status::Error),
        ("fmi2EnterInitializationMode", 2, Status::Discard),
        ("fmi2ExitInitializationMode", 4, Status::Fatal),
        ("fmi2GetReal", 3, Status::Error),
        ("fmi2GetInteger", 2, Status::Discard),
        ("fmi2GetString", 4, Status::Fatal),
        ("fmi2DoStep", 3, Status::Error),
        ("fmi2DoStep", 4, Status::Fatal),
        ("fmi2DoStep", 5, Status::Pending),
        ("fmi2Terminate", 3, Status::Error),
    ] {
        let (folder, fmu) = open(Build::Whole);
        let options = Options {
            inputs: Some(
                Signals::read("time,force[1]\n0,1\n".as_bytes(), "", fmu.description()).unwrap(),
            ),
            ..with(&[("fault", &format!("{function}:{code}"))])
        };
        let mut heard = Vec::new();
        let error = simulate(&fmu, &options, |event| {
            if let Event::Message(message) = event {
                heard.push(message.to_string());
            }
            ControlFlow::Continue(())
        })
        .unwrap_err();
        let SimulateError::Call { source, .. } = &error else {
            panic!("{function}: {error}");
        };
        let ImportError::Call {
            function: found,
            status: found_status,
            log,
        } = &**source
        else {
            panic!("{function}: {error}");
        };
        assert_eq!((*found, *found_status), (function, status));
        assert_eq!(
            log.last().map(String::as_str),
            Some("failed on purpose, 100 %")
        );
        assert_eq!(heard.len(), 1, "{heard:?}");
        assert!(
            heard[0].contains("[logStatusError] failed on purpose"),
            "{heard:?}"
        );
        // After `Fatal` nothing may be called, not even to free the instance.
        let freed = trace(&fmu).iter().any(|call| call == "fmi2FreeInstance");
        assert_eq!(freed, status != Status::Fatal, "{function}");
        if status == Status::Fatal {
            let error = fmu.instantiate("second", false).unwrap_err();
            assert!(
                matches!(
                    error,
                    ImportError::Phase {
                        found: Phase::Dead,
                        ..
                    }
                ),
                "{error}"
            );
        }
        drop((fmu, folder));
    }
}

#[test]
fn a_status_beyond_the_standard_is_an_error_and_a_warning_is_none() {
    let (_folder, fmu) = open(Build::Whole);
    let error = run(&fmu, &with(&[("fault", "fmi2DoStep:17")])).unwrap_err();
    let SimulateError::Call { source, .. } = &error else {
        panic!("{error}");
    };
    assert!(
        matches!(**source, ImportError::UnknownStatus { found: 17, .. }),
        "{error}"
    );
    let table = run(&fmu, &with(&[("fault", "fmi2DoStep:1")])).unwrap();
    assert_eq!((table.end, table.time.len()), (End::Stop, 41));
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
    for fault in ["short", "half"] {
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
    let table = simulate(&fmu, &Options::default(), |event| match event {
        Event::Time { step: 7, .. } => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    })
    .unwrap();
    assert_eq!((table.end, table.time.len()), (End::Interrupted, 8));
    assert!(trace(&fmu).ends_with(&["fmi2Terminate".to_owned(), "fmi2FreeInstance".to_owned()]));
}

#[test]
fn states_are_saved_restored_and_carried_to_another_instance() {
    let (_folder, fmu) = open(Build::Whole);
    let mut a = fmu.instantiate("a", false).unwrap();
    let begin = |instance: &mut sphere_dda_fmu::import::Instance| {
        instance.setup_experiment(None, 0.0, None).unwrap();
        instance.enter_initialization_mode().unwrap();
        instance.exit_initialization_mode().unwrap();
    };
    begin(&mut a);
    assert_eq!(a.do_step(0.0, 0.1, false).unwrap(), Step::Done);
    let state = a.save_state().unwrap();
    a.do_step(0.1, 0.1, false).unwrap();
    let once = a.get_real(&[0, 1]).unwrap();
    a.restore_state(&state).unwrap();
    a.do_step(0.1, 0.1, false).unwrap();
    assert_eq!(a.get_real(&[0, 1]).unwrap(), once);

    let bytes = a.serialize_state(&state).unwrap();
    let mut b = fmu.instantiate("b", false).unwrap();
    let error = b.restore_state(&state).unwrap_err();
    assert!(matches!(error, ImportError::ForeignState { .. }), "{error}");
    let carried = b.deserialize_state(&bytes).unwrap();
    b.restore_state(&carried).unwrap();
    assert_eq!(b.phase(), Phase::Stepping);
    b.do_step(0.1, 0.1, false).unwrap();
    assert_eq!(b.get_real(&[0, 1]).unwrap(), once);
    assert!(b.deserialize_state(b"garbage").is_err());

    a.free_state(state).unwrap();
    drop((a, b));
    // The one that `b` still held was freed with it.
    let freed = trace(&fmu)
        .iter()
        .filter(|call| *call == "fmi2FreeFMUstate")
        .count();
    assert_eq!(freed, 2);
}

#[test]
fn calls_out_of_turn_are_refused_before_they_reach_the_fmu() {
    let (_folder, fmu) = open(Build::Whole);
    let mut instance = fmu.instantiate("a", false).unwrap();
    for error in [
        instance.do_step(0.0, 0.1, false).map(|_| ()).unwrap_err(),
        instance.terminate().unwrap_err(),
        instance.exit_initialization_mode().unwrap_err(),
        instance.get_real(&[0]).map(|_| ()).unwrap_err(),
    ] {
        assert!(
            matches!(
                error,
                ImportError::Phase {
                    found: Phase::Instantiated,
                    ..
                }
            ),
            "{error}"
        );
    }
    let error = instance.set_real(&[2, 3], &[1.0]).unwrap_err();
    assert!(
        matches!(
            error,
            ImportError::Length {
                found: 1,
                expected: 2,
                ..
            }
        ),
        "{error}"
    );
    let error = instance.set_string(&[0], &["a\0b"]).unwrap_err();
    assert!(matches!(error, ImportError::Nul { .. }), "{error}");
    assert_eq!(trace(&fmu), ["fmi2Instantiate"]);

    instance.setup_experiment(None, 0.0, None).unwrap();
    instance.enter_initialization_mode().unwrap();
    let error = instance.get_real(&[99]).unwrap_err();
    assert!(
        matches!(
            error,
            ImportError::Call {
                status: Status::Error,
                ..
            }
        ),
        "{error}"
    );
    assert_eq!(instance.phase(), Phase::Failed);
    instance.reset().unwrap();
    assert_eq!(instance.phase(), Phase::Instantiated);
}

#[test]
fn the_logger_shows_texts_and_leaves_other_formats() {
    let (_folder, fmu) = open(Build::Whole);
    let instance = fmu.instantiate("a", true).unwrap();
    let (messages, lost) = instance.take_messages();
    assert_eq!((messages.len(), lost), (1, 0));
    assert_eq!(messages[0].text, "made at 100%, part %d of %d");
    assert_eq!(messages[0].category, "logEvents");
    assert_eq!(messages[0].status, Some(Status::Ok));
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

#[test]
fn libraries_that_cannot_be_used_are_named() {
    let instantiate = |build: Build, edit: fn(&mut String)| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.fmu");
        pack(&path, build, edit);
        let fmu = Fmu::open(&path).unwrap();
        let result = fmu.instantiate("x", false).map(|_| ());
        result.unwrap_err()
    };
    let error = instantiate(Build::WithoutDoStep, |_| ());
    assert!(
        matches!(
            error,
            ImportError::MissingFunction {
                function: "fmi2DoStep",
                ..
            }
        ),
        "{error}"
    );
    let error = instantiate(Build::UndefinedSymbol, |_| ());
    assert!(matches!(error, ImportError::Load { .. }), "{error}");
    let error = instantiate(Build::OtherVersion, |_| ());
    assert!(
        error
            .to_string()
            .contains("found \"1.0\", expected \"2.0\""),
        "{error}"
    );
    let error = instantiate(Build::Whole, |xml| {
        *xml = xml.replace("{foreign-", "{other-")
    });
    assert!(
        error
            .to_string()
            .contains("the FMU says: wrong guid {other-oscillator}"),
        "{error}"
    );
    let error = instantiate(Build::Whole, |xml| {
        *xml = xml.replace("Identifier=\"oscillator\"", "Identifier=\"pendulum\"");
    });
    let ImportError::NoBinary { found, .. } = &error else {
        panic!("{error}");
    };
    assert!(found.contains("64"), "{found}");
}

#[test]
fn a_missing_optional_function_matters_only_when_called() {
    let (_folder, fmu) = open(Build::WithoutStates);
    let missing = fmu.missing_functions().unwrap();
    assert_eq!(missing.len(), 6, "{missing:?}");
    assert!(run(&fmu, &Options::default()).is_ok());
    let mut instance = fmu.instantiate("a", false).unwrap();
    let error = instance.save_state().unwrap_err();
    assert!(
        matches!(
            error,
            ImportError::MissingFunction {
                function: "fmi2GetFMUstate",
                ..
            }
        ),
        "{error}"
    );
    let (_folder, fmu) = open(Build::Whole);
    assert!(fmu.missing_functions().unwrap().is_empty());
}

#[test]
fn an_fmu_of_one_instance_gets_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    pack(&path, Build::Whole, |xml| {
        *xml = xml.replace(
            "<CoSimulation ",
            "<CoSimulation canBeInstantiatedOnlyOncePerProcess=\"true\" ",
        );
    });
    let fmu = Fmu::open(&path).unwrap();
    let first = fmu.instantiate("a", false).unwrap();
    let error = fmu.instantiate("b", false).unwrap_err();
    assert!(matches!(error, ImportError::OnlyOnce), "{error}");
    drop(first);
    fmu.instantiate("c", false).unwrap();
}

#[test]
fn hostile_archives_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let refusal = |path: &Path, limits: Limits| match Fmu::open_within(path, limits).unwrap_err() {
        ImportError::Archive { source, .. } => source,
        error => panic!("{error}"),
    };
    let small = Limits {
        entries: 10,
        bytes: 1 << 20,
        ratio: 100,
    };

    for name in [
        "../evil.txt",
        "/evil.txt",
        "a/../../evil.txt",
        "..\\evil.txt",
        "C:\\evil.txt",
    ] {
        write_archive(&path, &[(name, b"x".to_vec())]);
        let error = refusal(&path, Limits::default());
        assert!(
            matches!(error, ArchiveError::Escape { .. }),
            "{name}: {error}"
        );
        assert!(!folder.path().parent().unwrap().join("evil.txt").exists());
    }

    write_archive(&path, &[("zeros", vec![0; 2 << 20])]);
    let error = refusal(&path, small);
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "bytes unpacked",
                ..
            }
        ),
        "{error}"
    );
    // 1000 to 1, once there is enough of it to matter.
    write_archive(&path, &[("zeros", vec![0; 80 << 20])]);
    let error = refusal(&path, Limits::default());
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "unpacked bytes per packed byte",
                ..
            }
        ),
        "{error}"
    );

    let many: Vec<String> = (0..11).map(|k| format!("f{k}")).collect();
    let many: Vec<_> = many.iter().map(|name| (&**name, Vec::new())).collect();
    write_archive(&path, &many);
    let error = refusal(&path, small);
    assert!(
        matches!(
            error,
            ArchiveError::Limit {
                what: "entries",
                ..
            }
        ),
        "{error}"
    );

    foreign_fmu::write_link(&path, "resources/link", "/etc/passwd");
    let error = refusal(&path, Limits::default());
    assert!(
        matches!(error, ArchiveError::SymbolicLink { .. }),
        "{error}"
    );

    write_archive(
        &path,
        &[("a1", b"first".to_vec()), ("a2", b"second".to_vec())],
    );
    let bytes = std::fs::read(&path).unwrap();
    let twice: Vec<u8> = String::from_utf8_lossy(&bytes)
        .contains("a2")
        .then(|| replace(&bytes, b"a2", b"a1"))
        .unwrap();
    std::fs::write(&path, twice).unwrap();
    let error = refusal(&path, Limits::default());
    assert!(matches!(error, ArchiveError::Overlap), "{error}");

    std::fs::write(&path, b"no zip at all").unwrap();
    let error = refusal(&path, Limits::default());
    assert!(matches!(error, ArchiveError::Zip { .. }), "{error}");
    let error = refusal(&folder.path().join("absent.fmu"), Limits::default());
    assert!(matches!(error, ArchiveError::Io { .. }), "{error}");

    // A size in the directory that lies: less is declared than comes out, or the checksum does not fit.
    let whole = entries(Build::Whole, |_| ());
    let whole: Vec<_> = whole
        .iter()
        .map(|(name, bytes)| (&**name, bytes.clone()))
        .collect();
    write_archive(&path, &whole);
    let bytes = std::fs::read(&path).unwrap();
    for cut in [bytes.len() / 2, bytes.len() - 10, 30] {
        std::fs::write(&path, &bytes[..cut]).unwrap();
        let error = refusal(&path, Limits::default());
        assert!(matches!(error, ArchiveError::Zip { .. }), "{error}");
    }
}

fn replace(bytes: &[u8], from: &[u8], to: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for at in 0..=bytes.len() - from.len() {
        if bytes[at..].starts_with(from) {
            bytes[at..at + from.len()].copy_from_slice(to);
        }
    }
    bytes
}

#[test]
fn descriptions_that_cannot_be_used_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.fmu");
    let refusal = |description: Option<&[u8]>| {
        match description {
            Some(text) => write_archive(&path, &[("modelDescription.xml", text.to_vec())]),
            None => write_archive(&path, &[("oscillator/modelDescription.xml", Vec::new())]),
        }
        Fmu::open(&path).unwrap_err()
    };
    let error = refusal(None);
    assert!(
        matches!(error, ImportError::NoDescription { .. }),
        "{error}"
    );
    let error = refusal(Some(b"\xff\xfe not UTF-8"));
    assert!(
        matches!(error, ImportError::NoDescription { .. }),
        "{error}"
    );
    for text in [
        "",
        "<fmiModelDescription",
        "<a/>",
        "<fmiModelDescription fmiVersion=\"3.0\"/>",
    ] {
        let error = refusal(Some(text.as_bytes()));
        assert!(matches!(error, ImportError::Description { .. }), "{error}");
    }
    let xml = String::from_utf8(entries(Build::Whole, |_| ())[0].1.clone()).unwrap();
    let exchange = xml
        .replace("<CoSimulation", "<ModelExchange")
        .replace("canHandleVariableCommunicationStepSize=\"true\"", "");
    let error = refusal(Some(exchange.as_bytes()));
    assert!(
        matches!(error, ImportError::NoCoSimulation { .. }),
        "{error}"
    );
    let escaping = xml.replace(
        "modelIdentifier=\"oscillator\"",
        "modelIdentifier=\"../../evil\"",
    );
    let error = refusal(Some(escaping.as_bytes()));
    assert!(
        matches!(error, ImportError::ModelIdentifier { .. }),
        "{error}"
    );
}
