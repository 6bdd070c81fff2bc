//! What every exported function does first and last: null, life cycle, panic, log line, status.

use std::any::Any;
use std::ffi::{CStr, CString, c_char, c_int};
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::abi2::{fmi2CallbackFunctions, fmi2Component, fmi2Status, fmi2String};
use crate::instance::{Instance, Stage};
use crate::log::{Category, Level, Sink, printf};
use crate::refusal::Refusal;

/// What an `fmi2Component` points to.
pub(super) struct Component {
    pub(super) instance: Instance,
    /// Texts handed out by the last `fmi2GetString`, valid until the next call.
    pub(super) strings: Vec<CString>,
}

/// States of the life cycle in which a function may be called.
pub(super) type Stages = &'static [Stage];

/// Any state.
pub(super) const ANY: Stages = &[
    Stage::Instantiated,
    Stage::Initialization,
    Stage::StepComplete,
    Stage::StepFailed,
    Stage::Error,
    Stage::Terminated,
];

/// Runs `body` on the instance behind `component`; whatever happens ends as a status, with a log line if it is bad.
pub(super) fn call(
    component: fmi2Component,
    function: &str,
    allowed: Stages,
    body: impl FnOnce(&mut Component) -> Result<fmi2Status, Refusal>,
) -> fmi2Status {
    // SAFETY: the importer passes null or what fmi2Instantiate returned and fmi2FreeInstance has not taken back, and
    // calls one instance from one thread at a time (FMI 2.0, section 4.2.1).
    let Some(component) = (unsafe { component.cast::<Component>().as_mut() }) else {
        return fmi2Status::fmi2Error;
    };
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        require(component.instance.stage(), allowed)?;
        body(component)
    }));
    match outcome {
        Ok(Ok(status)) => status,
        Ok(Err(refusal)) => {
            component
                .instance
                .log()
                .write(Level::Error, format_args!("{function}: {refusal}"));
            fmi2Status::fmi2Error
        }
        Err(panic) => {
            // A second panic, while the first is cleaned up, must not cross into C either.
            let fail = || {
                component
                    .instance
                    .fail(&format!("{function}: {}", text(&*panic)))
            };
            let _ = catch_unwind(AssertUnwindSafe(fail));
            fmi2Status::fmi2Error
        }
    }
}

fn require(found: Stage, allowed: Stages) -> Result<(), Refusal> {
    if allowed.contains(&found) {
        return Ok(());
    }
    let names: Vec<String> = allowed.iter().map(Stage::to_string).collect();
    Err(Refusal::Stage {
        found,
        expected: names.join(" or "),
    })
}

/// The message of a panic.
pub(super) fn text(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    owned
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("panic without a message")
}

/// A sink that calls the importer's logger. The callbacks are copied: they need not outlive the instantiation.
pub(super) fn sink(callbacks: fmi2CallbackFunctions, name: &str) -> Option<Sink> {
    let logger = callbacks.logger?;
    let environment = callbacks.component_environment;
    let name = c_string(name);
    Some(Box::new(
        move |level: Level, category: Category, message: &str| {
            let (category, message) = (c_string(category.name()), c_string(&printf(message)));
            // SAFETY: the logger is the importer's own, valid as long as the instance; all texts end with NUL and outlive
            // the call; the message holds no printf directive, so no further argument is read.
            unsafe {
                logger(
                    environment,
                    name.as_ptr(),
                    level as c_int,
                    category.as_ptr(),
                    message.as_ptr(),
                )
            };
        },
    ))
}

/// A C string; a NUL inside cuts it.
pub(super) fn c_string(text: &str) -> CString {
    let end = text.find('\0').unwrap_or(text.len());
    CString::new(&text[..end]).unwrap_or_default()
}

/// A text from C.
pub(super) fn str_from<'a>(
    pointer: fmi2String,
    argument: &'static str,
) -> Result<&'a str, Refusal> {
    if pointer.is_null() {
        return Err(null(argument));
    }
    // SAFETY: not null; the importer passes a NUL-terminated text that lives through the call.
    let text = unsafe { CStr::from_ptr(pointer.cast::<c_char>()) };
    text.to_str().map_err(|error| Refusal::Argument {
        argument,
        found: error.to_string(),
        expected: "UTF-8",
    })
}

/// An array from C; of no length it may be null.
pub(super) fn array<'a, T>(
    pointer: *const T,
    length: usize,
    argument: &'static str,
) -> Result<&'a [T], Refusal> {
    match (pointer.is_null(), length) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(null(argument)),
        // SAFETY: not null; the importer passes `length` values that live through the call.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts(pointer, length) }),
    }
}

/// An array of C that is written.
pub(super) fn array_mut<'a, T>(
    pointer: *mut T,
    length: usize,
    argument: &'static str,
) -> Result<&'a mut [T], Refusal> {
    match (pointer.is_null(), length) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(null(argument)),
        // SAFETY: not null; the importer lends `length` values through the call and reads none of them meanwhile.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts_mut(pointer, length) }),
    }
}

/// One value of C that is written.
pub(super) fn value_mut<'a, T>(
    pointer: *mut T,
    argument: &'static str,
) -> Result<&'a mut T, Refusal> {
    Ok(&mut array_mut(pointer, 1, argument)?[0])
}

fn null(argument: &'static str) -> Refusal {
    Refusal::Argument {
        argument,
        found: "null".to_owned(),
        expected: "a pointer",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Log;
    use crate::model::Model;
    use std::cell::RefCell;
    use std::path::Path;
    use std::rc::Rc;

    #[test]
    fn a_panic_is_an_error_until_reset() {
        let folder = tempfile::tempdir().unwrap();
        let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/feeder/feeder.toml");
        std::fs::copy(scene, folder.path().join("scene.toml")).unwrap();
        let guid = Model::read(&folder.path().join("scene.toml"), None)
            .unwrap()
            .guid;
        let lines = Rc::new(RefCell::new(Vec::new()));
        let copy = Rc::clone(&lines);
        let sink: Sink = Box::new(move |_, _, line| copy.borrow_mut().push(line.to_owned()));
        let log = Log::new(Some(sink), false);
        let instance = Instance::new("one", &guid, folder.path(), log).unwrap();
        let mut component = Component {
            instance,
            strings: Vec::new(),
        };
        let c: fmi2Component = (&raw mut component).cast();

        let panics = |_: &mut Component| panic!("out of {}", "luck");
        assert_eq!(call(c, "fmi2DoStep", ANY, panics), fmi2Status::fmi2Error);
        assert!(lines.borrow()[0].contains("internal error: fmi2DoStep: out of luck"));
        let idle = |_: &mut Component| Ok(fmi2Status::fmi2OK);
        let stepping: Stages = &[Stage::Instantiated, Stage::StepComplete];
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2Error);
        assert!(lines.borrow()[1].contains("not allowed in state error"));
        component.instance.reset();
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2OK);
    }
}
