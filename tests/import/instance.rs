//! One instance: statuses, phases, states, messages.

use std::ops::ControlFlow;

use sphere_dda_master::{
    End, Event, Fmu, ImportError, InputTable, Instance2, Options, Phase, SimulateError, Status,
    Step, System, simulate,
};

use crate::foreign_fmu::{Build, pack};
use crate::{open, run, trace, with};

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
                InputTable::read("time,force[1]\n0,1\n".as_bytes(), "", &System::of(&fmu)).unwrap(),
            ),
            ..with(&[("fault", &format!("{function}:{code}"))])
        };
        let mut heard = Vec::new();
        let error = simulate(&System::of(&fmu), &options, |event| {
            if let Event::Message(message) = event {
                heard.push(message.to_string());
            }
            ControlFlow::Continue(())
        })
        .unwrap_err();
        let SimulateError::Call { failure, .. } = &error else {
            panic!("{function}: {error}");
        };
        let ImportError::Call {
            function: found,
            status: found_status,
            log,
        } = &**failure
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
    let SimulateError::Call { failure, .. } = &error else {
        panic!("{error}");
    };
    assert!(
        matches!(**failure, ImportError::UnknownStatus { found: 17, .. }),
        "{error}"
    );
    let table = run(&fmu, &with(&[("fault", "fmi2DoStep:1")])).unwrap();
    assert_eq!((table.end, table.time.len()), (End::Stop, 41));
}

#[test]
fn states_are_saved_restored_and_carried_to_another_instance() {
    let (_folder, fmu) = open(Build::Whole);
    let mut a = fmu.instantiate("a", false).unwrap();
    let begin = |instance: &mut Instance2| {
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
