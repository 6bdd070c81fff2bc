//! What every exported function does first and last: null, life cycle, panic, log line, status.

use std::ffi::CString;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::instance::{Instance, Stage};
use crate::refusal::Refusal;
use sphere_dda_fmi_interface::abi2::{fmi2Component, fmi2Status};
use sphere_dda_fmi_interface::log::Level;
use sphere_dda_fmi_interface::pointers::panic_text;

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
                    .fail(&format!("{function}: {}", panic_text(&*panic)))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use sphere_dda_fmi_interface::log::{Log, Sink};
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
