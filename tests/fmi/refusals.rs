//! Bad calls: the right status and a log line, no crash, nothing changed.

use std::ffi::{CString, c_void};
use std::ptr::{null, null_mut};

use super::c::{DISCARD, ERROR, OK, WARNING};
use super::{box_scene, fmi};

#[test]
fn null_instances_are_errors() {
    let f = &fmi().f;
    let none = null_mut();
    // SAFETY: a null handle stops every function before it looks at anything else.
    let statuses = unsafe {
        (f.fmi2FreeInstance)(none);
        [
            (f.fmi2SetDebugLogging)(none, 1, 0, null()),
            (f.fmi2SetupExperiment)(none, 0, 0.0, 0.0, 0, 0.0),
            (f.fmi2EnterInitializationMode)(none),
            (f.fmi2ExitInitializationMode)(none),
            (f.fmi2Terminate)(none),
            (f.fmi2Reset)(none),
            (f.fmi2GetReal)(none, null(), 0, null_mut()),
            (f.fmi2GetInteger)(none, null(), 0, null_mut()),
            (f.fmi2GetBoolean)(none, null(), 0, null_mut()),
            (f.fmi2GetString)(none, null(), 0, null_mut()),
            (f.fmi2SetReal)(none, null(), 0, null()),
            (f.fmi2SetInteger)(none, null(), 0, null()),
            (f.fmi2SetBoolean)(none, null(), 0, null()),
            (f.fmi2SetString)(none, null(), 0, null()),
            (f.fmi2GetFMUstate)(none, null_mut()),
            (f.fmi2SetFMUstate)(none, null_mut()),
            (f.fmi2FreeFMUstate)(none, null_mut()),
            (f.fmi2SerializedFMUstateSize)(none, null_mut(), null_mut()),
            (f.fmi2SerializeFMUstate)(none, null_mut(), null_mut(), 0),
            (f.fmi2DeSerializeFMUstate)(none, null(), 0, null_mut()),
            (f.fmi2GetDirectionalDerivative)(none, null(), 0, null(), 0, null(), null_mut()),
            (f.fmi2SetRealInputDerivatives)(none, null(), 0, null(), null()),
            (f.fmi2GetRealOutputDerivatives)(none, null(), 0, null(), null_mut()),
            (f.fmi2DoStep)(none, 0.0, 0.1, 0),
            (f.fmi2CancelStep)(none),
            (f.fmi2GetStatus)(none, 0, null_mut()),
            (f.fmi2GetRealStatus)(none, 2, null_mut()),
            (f.fmi2GetIntegerStatus)(none, 0, null_mut()),
            (f.fmi2GetBooleanStatus)(none, 3, null_mut()),
            (f.fmi2GetStringStatus)(none, 1, null_mut()),
        ]
    };
    assert_eq!(statuses, [ERROR; 30]);
}

#[test]
fn null_arguments_are_errors() {
    let scene = box_scene();
    let i = scene.instance();
    i.initialize();
    let (f, c, state) = (i.f(), i.handle, i.state());
    let (time, no_text, mut no_state, mut size) = (0, null(), null_mut(), 0);
    // SAFETY: every pointer is valid or null, which each function must notice.
    let statuses = unsafe {
        [
            (f.fmi2SetDebugLogging)(c, 1, 1, null()),
            (f.fmi2SetDebugLogging)(c, 1, 1, &raw const no_text),
            (f.fmi2GetReal)(c, null(), 1, null_mut()),
            (f.fmi2GetReal)(c, &raw const time, 1, null_mut()),
            (f.fmi2GetString)(c, null(), 1, null_mut()),
            (f.fmi2SetReal)(c, null(), 1, null()),
            (f.fmi2SetReal)(c, &raw const time, 1, null()),
            (f.fmi2SetString)(c, null(), 1, null()),
            (f.fmi2GetFMUstate)(c, null_mut()),
            (f.fmi2SetFMUstate)(c, null_mut()),
            (f.fmi2FreeFMUstate)(c, null_mut()),
            (f.fmi2SerializedFMUstateSize)(c, state, null_mut()),
            (f.fmi2SerializedFMUstateSize)(c, null_mut(), &raw mut size),
            (f.fmi2SerializeFMUstate)(c, null_mut(), null_mut(), 0),
            (f.fmi2SerializeFMUstate)(c, state, null_mut(), 3),
            (f.fmi2DeSerializeFMUstate)(c, null(), 8, &raw mut no_state),
            (f.fmi2DeSerializeFMUstate)(c, null(), 0, null_mut()),
            (f.fmi2GetRealStatus)(c, 2, null_mut()),
        ]
    };
    assert_eq!(statuses, [ERROR; 18]);
    let lines = i.log();
    assert_eq!(lines.len(), 18, "{lines:#?}");
    assert!(
        lines
            .iter()
            .all(|line| line.starts_with("3 logStatusError fmi2")),
        "{lines:#?}"
    );
    i.free(state);
    // Nothing of nothing is fine, and a null state is nothing to free.
    // SAFETY: lengths are zero; the place of the state is valid.
    unsafe {
        assert_eq!((f.fmi2GetReal)(c, null(), 0, null_mut()), OK);
        assert_eq!((f.fmi2SetString)(c, null(), 0, null()), OK);
        assert_eq!((f.fmi2FreeFMUstate)(c, &raw mut no_state), OK);
    }
    assert_eq!(i.step(0.0, 0.01), OK);
}

#[test]
fn pointers_to_something_else_are_errors() {
    let scene = box_scene();
    let i = scene.instance();
    i.initialize();
    let (f, c, state) = (i.f(), i.handle, i.state());
    let mut foreign = [0_u64; 64];
    let foreign: *mut c_void = foreign.as_mut_ptr().cast();
    let odd = c.wrapping_byte_add(1);
    let (time, mut value, mut size) = (0_u32, [0.0_f64; 2], 0_usize);
    for wrong in [foreign, odd, state] {
        // SAFETY: each pointer is readable, and none is an instance.
        unsafe {
            assert_eq!((f.fmi2Reset)(wrong), ERROR);
            assert_eq!((f.fmi2DoStep)(wrong, 0.0, 0.01, 0), ERROR);
            (f.fmi2FreeInstance)(wrong);
        }
    }
    for mut wrong in [foreign, odd, c] {
        let found = wrong;
        // SAFETY: each pointer is readable, and none is a state.
        let statuses = unsafe {
            [
                (f.fmi2GetFMUstate)(c, &raw mut wrong),
                (f.fmi2SetFMUstate)(c, wrong),
                (f.fmi2SerializedFMUstateSize)(c, wrong, &raw mut size),
                (f.fmi2SerializeFMUstate)(c, wrong, value.as_mut_ptr().cast(), 8),
                (f.fmi2FreeFMUstate)(c, &raw mut wrong),
            ]
        };
        assert_eq!((statuses, wrong), ([ERROR; 5], found));
        let lines = i.log();
        let told = lines.iter().filter(|line| line.contains("`FMUstate` is"));
        assert_eq!(told.count(), 5, "{lines:#?}");
    }
    let value = value.as_mut_ptr();
    // SAFETY: what would be read or written there is refused before.
    let statuses = unsafe {
        [
            (f.fmi2GetReal)(c, &raw const time, 1, value.wrapping_byte_add(4)),
            (f.fmi2SetReal)(c, &raw const time, 1, value.wrapping_byte_add(4)),
            (f.fmi2GetReal)(c, &raw const time, usize::MAX, value),
            (f.fmi2GetReal)(c, &raw const time, usize::MAX / 8, value),
        ]
    };
    assert_eq!(statuses, [ERROR; 4]);
    let lines = i.log();
    for (line, part) in lines.iter().zip([
        "fits the type",
        "fits the type",
        "fits into memory",
        "fits into memory",
    ]) {
        assert!(line.contains(part), "{lines:#?}");
    }
    // All is as before.
    i.free(state);
    assert_eq!(i.step(0.0, 0.01), OK);
}

#[test]
fn calls_out_of_order_are_refused() {
    let scene = box_scene();
    let i = scene.instance();
    let (f, c) = (i.f(), i.handle);
    let force = scene.reference("boundary.floor.force[3]");
    let mut value = [0.0];
    let refused = |status, what: &str| {
        let lines = i.log();
        assert_eq!(status, ERROR, "{what}: {lines:?}");
        assert_eq!(lines.len(), 1, "{what}: {lines:?}");
        assert!(lines[0].contains("state"), "{what}: {lines:?}");
    };
    let mut real = 0.0;
    // Instantiated.
    refused(i.exit(), "exit before enter");
    refused(i.step(0.0, 0.01), "step before start");
    refused(i.terminate(), "terminate before start");
    refused(i.get(&[force], &mut value), "output before initialization");
    // SAFETY: a valid place.
    refused(
        unsafe { (f.fmi2GetRealStatus)(c, 2, &raw mut real) },
        "status before a step",
    );
    assert_eq!([i.set_up(0.0, None), i.enter()], [OK; 2]);
    // Initialization mode.
    refused(i.set_up(0.0, None), "set up in initialization");
    refused(i.enter(), "enter twice");
    refused(i.step(0.0, 0.01), "step in initialization");
    assert_eq!(i.get(&[force], &mut value), OK);
    assert_eq!(i.exit(), OK);
    // Stepping.
    refused(i.exit(), "exit twice");
    refused(i.enter(), "enter while stepping");
    refused(i.set_up(0.0, None), "set up while stepping");
    refused(
        i.set(scene.reference("solver.step"), 1e-4),
        "fixed parameter while stepping",
    );
    refused(
        i.set_string(scene.reference("output.directory"), "x"),
        "fixed text while stepping",
    );
    assert_eq!(i.step(0.0, 0.01), OK);
    assert_eq!(i.terminate(), OK);
    // Terminated.
    refused(i.step(0.01, 0.01), "step after the end");
    refused(i.terminate(), "terminate twice");
    refused(
        i.set(scene.reference("gravity[3]"), 0.0),
        "set after the end",
    );
    assert_eq!(i.get(&[force], &mut value), OK);
    assert_eq!(i.reset(), OK);
    i.initialize();
}

#[test]
fn bad_values_are_refused() {
    let scene = box_scene();
    let i = scene.instance();
    let lift = scene.reference("boundary.floor.translation[3]");
    let refused = |status, words: &str| {
        let lines = i.log();
        assert_eq!(status, ERROR, "{words}");
        assert!(
            lines.len() == 1 && lines[0].contains(words),
            "{words}: {lines:?}"
        );
    };
    refused(
        i.set(scene.reference("solver.tolerance.gap"), 0.5),
        "expected a number from 1e-12 to 0.1",
    );
    refused(
        i.set(scene.reference("solver.step"), 0.0),
        "expected a number > 0",
    );
    refused(i.set_up(f64::NAN, None), "startTime");
    refused(i.set_up(0.0, Some(-1.0)), "stopTime");
    i.initialize();
    for (value, found) in [
        (f64::NAN, "NaN"),
        (f64::INFINITY, "inf"),
        (f64::NEG_INFINITY, "-inf"),
    ] {
        refused(
            i.set(lift, value),
            &format!("`boundary.floor.translation[3]` = {found}"),
        );
    }
    refused(
        i.set(scene.reference("boundary.floor.force[3]"), 0.0),
        "only parameters and inputs can be set",
    );
    refused(
        i.set(scene.reference("time"), 0.0),
        "only parameters and inputs can be set",
    );
    refused(
        i.set(999_999, 0.0),
        "value reference 999999 is no Real variable",
    );
    refused(
        i.set(scene.reference("output.directory"), 0.0),
        "it is `output.directory` of type String",
    );
    refused(
        i.get(&[scene.reference("time"), 77_777], &mut [0.0; 2]),
        "value reference 77777",
    );
    refused(i.set_string(lift, "1"), "is no String variable");
    let point = "currentCommunicationPoint";
    let size = "communicationStepSize";
    for (t, h, words) in [
        (0.0, 0.0, size),
        (0.0, -0.01, size),
        (0.0, f64::NAN, size),
        (0.0, f64::INFINITY, size),
        (f64::NAN, 0.01, point),
        (1e9, 1e-9, size),
        (0.005, 0.01, "communication point 0.005 s, expected 0 s"),
    ] {
        refused(i.step(t, h), words);
    }
    // A jump of the floor by more than a radius in one internal step names the boundary.
    assert_eq!(i.set(lift, 5.0), OK);
    refused(i.step(0.0, 0.01), "boundary `floor` moves it by");
    assert_eq!(i.set(lift, 0.0), OK);
    assert_eq!(i.step(0.0, 0.01), OK, "{:?}", i.log());
}

#[test]
fn one_bad_value_sets_none() {
    let scene = box_scene();
    let i = scene.instance();
    let references = [1, 2].map(|k| scene.reference(&format!("boundary.floor.translation[{k}]")));
    let values = [0.25, f64::NAN];
    // SAFETY: two references, two values.
    let status = unsafe { (i.f().fmi2SetReal)(i.handle, references.as_ptr(), 2, values.as_ptr()) };
    assert_eq!(status, ERROR);
    assert_eq!(i.real(references[0]), 0.0);
}

#[test]
fn capabilities_not_offered_say_so() {
    let scene = box_scene();
    let i = scene.instance();
    i.initialize();
    let (f, c, mut value, mut text) = (i.f(), i.handle, 7, null());
    // SAFETY: null arrays are not looked at; places are valid.
    unsafe {
        assert_eq!((f.fmi2CancelStep)(c), ERROR);
        assert_eq!((f.fmi2GetStatus)(c, 0, &raw mut value), DISCARD);
        assert_eq!((f.fmi2GetIntegerStatus)(c, 0, &raw mut value), DISCARD);
        assert_eq!((f.fmi2GetStringStatus)(c, 1, &raw mut text), DISCARD);
    }
    assert_eq!((value, i.log().len()), (7, 4));
}

#[test]
fn instantiation_is_refused_with_a_reason() {
    let scene = box_scene();
    let (guid, place) = (
        &scene.model.guid,
        format!("file://{}", scene.resources().display()),
    );
    let empty = tempfile::tempdir().unwrap();
    let nowhere = format!("file://{}", empty.path().join("no").display());
    let bare = format!("file://{}", empty.path().display());
    for (kind, name, guid, uri, words) in [
        (1, "box", "{50 %s}", &place, "guid {50 %%s}, expected {"),
        (
            0,
            "box",
            guid.as_str(),
            &place,
            "model exchange is not offered",
        ),
        (9, "box", guid, &place, "fmuType 9"),
        (1, "", guid, &place, "instanceName is empty"),
        (1, "box", guid, &nowhere, "resource location"),
        (1, "box", guid, &bare, "scene.toml"),
        (
            1,
            "box",
            guid,
            &"http://example.org/x".to_owned(),
            "resource location",
        ),
    ] {
        let instance = fmi().instantiate_as(kind, name, guid, uri);
        let lines = instance.log();
        assert!(instance.handle.is_null());
        assert!(
            lines.len() == 1 && lines[0].starts_with("3 logStatusError fmi2Instantiate: "),
            "{lines:?}"
        );
        assert!(lines[0].contains(words), "{words}: {lines:?}");
    }
}

#[test]
fn callbacks_may_be_missing() {
    let scene = box_scene();
    let text = |t: &str| CString::new(t).unwrap();
    let (name, guid) = (text("box"), text(&scene.model.guid));
    let uri = text(&scene.resources().display().to_string());
    let f = &fmi().f;
    // SAFETY: valid texts; no callbacks, which is legal; null texts, which are refused.
    unsafe {
        let c = (f.fmi2Instantiate)(name.as_ptr(), 1, guid.as_ptr(), uri.as_ptr(), null(), 0, 1);
        assert!(!c.is_null());
        assert_eq!((f.fmi2DoStep)(c, 0.0, 0.1, 0), ERROR);
        (f.fmi2FreeInstance)(c);
        assert!((f.fmi2Instantiate)(null(), 1, null(), null(), null(), 0, 1).is_null());
    }
}

#[test]
fn only_chosen_categories_are_logged() {
    let scene = box_scene();
    let i = scene.instance();
    let select = |on, names: &[&str]| {
        let names: Vec<CString> = names.iter().map(|n| CString::new(*n).unwrap()).collect();
        let pointers: Vec<_> = names.iter().map(|n| n.as_ptr()).collect();
        // SAFETY: as many texts as said.
        unsafe { (i.f().fmi2SetDebugLogging)(i.handle, on, pointers.len(), pointers.as_ptr()) }
    };
    assert_eq!(select(1, &["logEvents"]), OK);
    assert_eq!(i.step(0.0, 0.1), ERROR);
    assert!(i.log().is_empty());
    i.initialize();
    assert!(i.log()[0].starts_with("0 logEvents initialized: 18 spheres"));
    assert_eq!(select(1, &["logAll", "logMagic"]), WARNING);
    assert!(i.log()[0].contains("logMagic"));
    assert_eq!(select(0, &[]), OK);
    assert_eq!(i.reset(), OK);
    i.initialize();
    assert!(i.log().is_empty());
    assert_eq!(i.step(0.0, -0.1), ERROR);
    assert_eq!(i.log().len(), 1);
}
