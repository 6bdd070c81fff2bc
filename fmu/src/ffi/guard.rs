//! What every exported function does first and last: null, life cycle, panic, log line, status.

use std::ffi::CString;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::runtime::instance::Instance;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use sphere_dda_fmi_interface::abi2::{fmi2Component, fmi2Status};
use sphere_dda_fmi_interface::abi3::{
    fmi3InstanceEnvironment, fmi3IntermediateUpdateCallback, fmi3Status,
};
use sphere_dda_fmi_interface::log::Level;
use sphere_dda_fmi_interface::pointers::panic_text;

/// What an `fmi2Component` points to.
pub(super) struct Component {
    pub(super) instance: Instance,
    /// Texts handed out by the last `fmi2GetString`, valid until the next call.
    pub(super) strings: Vec<CString>,
    /// Bytes handed out by the last `fmi3GetBinary`, likewise.
    pub(super) binaries: Vec<Vec<u8>>,
    /// The importer's wish to be called within a step; FMI 3.0 only.
    pub(super) updates: Option<Updates>,
}

impl Component {
    pub(super) fn new(instance: Instance) -> Self {
        Self {
            instance,
            strings: Vec::new(),
            binaries: Vec::new(),
            updates: None,
        }
    }
}

/// How the importer is called within a step.
#[derive(Clone, Copy)]
pub(super) struct Updates {
    pub(super) callback: fmi3IntermediateUpdateCallback,
    pub(super) environment: fmi3InstanceEnvironment,
    pub(super) early_return_allowed: bool,
}

/// The statuses of a version of the standard.
pub(super) trait Status {
    const OK: Self;
    const WARNING: Self;
    const ERROR: Self;
}

impl Status for fmi2Status {
    const OK: Self = Self::fmi2OK;
    const WARNING: Self = Self::fmi2Warning;
    const ERROR: Self = Self::fmi2Error;
}

impl Status for fmi3Status {
    const OK: Self = Self::fmi3OK;
    const WARNING: Self = Self::fmi3Warning;
    const ERROR: Self = Self::fmi3Error;
}

/// States of the life cycle in which a function may be called.
pub(super) type Stages = &'static [LifeCycle];

/// Any state but within a step.
pub(super) const ANY: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Error,
    LifeCycle::Terminated,
];

/// Nothing is set up.
pub(super) const INSTANTIATED: Stages = &[LifeCycle::Instantiated];
/// Initialization mode.
pub(super) const INITIALIZATION: Stages = &[LifeCycle::Initialization];
/// Between two steps.
pub(super) const STEPPING: Stages = &[LifeCycle::StepComplete, LifeCycle::StepFailed];

/// After the first step, and when only reading is left.
pub(super) const STEPPED: Stages = &[
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Error,
    LifeCycle::Terminated,
];

/// Where outputs have derivatives by inputs.
pub(super) const KNOWN: Stages = &[
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Terminated,
];

/// Runs `body` on the instance behind `component`; whatever happens ends as a status, with a log line if it is bad.
pub(super) fn call<S: Status>(
    component: fmi2Component,
    function: &str,
    allowed: Stages,
    body: impl FnOnce(&mut Component) -> Result<S, Refusal>,
) -> S {
    // SAFETY: the importer passes null or what fmi2Instantiate returned and fmi2FreeInstance has not taken back, and
    // calls one instance from one thread at a time (FMI 2.0, section 4.2.1).
    let Some(component) = (unsafe { component.cast::<Component>().as_mut() }) else {
        return S::ERROR;
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
            S::ERROR
        }
        Err(panic) => {
            // A second panic, while the first is cleaned up, must not cross into C either.
            let fail = || {
                component
                    .instance
                    .fail(&format!("{function}: {}", panic_text(&*panic)))
            };
            let _ = catch_unwind(AssertUnwindSafe(fail));
            S::ERROR
        }
    }
}

fn require(found: LifeCycle, allowed: Stages) -> Result<(), Refusal> {
    if allowed.contains(&found) {
        return Ok(());
    }
    let names: Vec<String> = allowed.iter().map(LifeCycle::to_string).collect();
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
        let mut component = Component::new(instance);
        let c: fmi2Component = (&raw mut component).cast();

        let panics =
            |_: &mut Component| -> Result<fmi2Status, Refusal> { panic!("out of {}", "luck") };
        assert_eq!(call(c, "fmi2DoStep", ANY, panics), fmi2Status::fmi2Error);
        assert!(lines.borrow()[0].contains("internal error: fmi2DoStep: out of luck"));
        let idle = |_: &mut Component| Ok(fmi2Status::fmi2OK);
        let stepping: Stages = &[LifeCycle::Instantiated, LifeCycle::StepComplete];
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2Error);
        assert!(lines.borrow()[1].contains("not allowed in state error"));
        component.instance.reset();
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2OK);
    }
}
