//! What every exported function does first and last: null, life cycle, panic, log line, status.

use std::ffi::CString;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::runtime::instance::Instance;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::{InstantiationError, Refusal};
use sphere_dda_fmi_interface::abi2::{fmi2Component, fmi2Status};
use sphere_dda_fmi_interface::abi3::{
    fmi3InstanceEnvironment, fmi3IntermediateUpdateCallback, fmi3Status,
};
use sphere_dda_fmi_interface::handle;
use sphere_dda_fmi_interface::log::{Level, Log};
use sphere_dda_fmi_interface::panics;
use sphere_dda_fmi_interface::pointers::Lent;

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

impl handle::Kind for Component {
    const MAGIC: u64 = u64::from_le_bytes(*b"SDDAinst");
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
    lend(component, function, allowed, |component, _| body(component))
}

/// As [`call`], for functions with pointers among their arguments: only these may be handed to what `body` gets.
pub(super) fn lend<S: Status>(
    component: fmi2Component,
    function: &str,
    allowed: Stages,
    body: impl for<'call> FnOnce(&mut Component, Lent<'call>) -> Result<S, Refusal>,
) -> S {
    // SAFETY: the importer calls one instance from one thread at a time (FMI 2.0, section 4.2.1).
    let Some(component) = (unsafe { handle::look::<Component>(component) }) else {
        return S::ERROR;
    };
    // SAFETY: callers are the functions of the C interface, whose arguments the importer lends for the call; `body` is over
    // before it is.
    let lent = unsafe { Lent::new() };
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        require(component.instance.stage(), allowed)?;
        body(component, lent)
    }));
    let report = || match outcome {
        Ok(Ok(status)) => status,
        Ok(Err(refusal)) => {
            let log = component.instance.log();
            log.write(Level::Error, format_args!("{function}: {refusal}"));
            S::ERROR
        }
        Err(panic) => {
            let what = format!("{function}: {}", panics::told(&*panic));
            component.instance.fail(&what);
            S::ERROR
        }
    };
    // A panic while this is told, in the words of a refusal or in the logger, must not cross into C either.
    catch_unwind(AssertUnwindSafe(report)).unwrap_or(S::ERROR)
}

/// Takes an instance back from the importer, if it is one. The log still hears of result files that could not be written.
pub(super) fn free(component: fmi2Component) {
    // SAFETY: the importer has ended all calls of the instance.
    let component = unsafe { handle::take::<Component>(component) };
    // There is nobody left to tell of a panic.
    let _ = catch_unwind(AssertUnwindSafe(|| {
        if let Some(mut component) = component {
            component.instance.close();
        }
    }));
}

/// Makes an instance, or tells in the log why not and gives null.
pub(super) fn instantiate(
    function: &str,
    log: impl Fn() -> Log,
    make: impl FnOnce() -> Result<Component, InstantiationError>,
) -> fmi2Component {
    panics::watch();
    let refused = match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Ok(component)) => return handle::give(component),
        Ok(Err(error)) => error.to_string(),
        Err(panic) => format!("internal error: {}", panics::told(&*panic)),
    };
    let tell = || log().write(Level::Error, format_args!("{function}: {refused}"));
    let _ = catch_unwind(AssertUnwindSafe(tell));
    std::ptr::null_mut()
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
        let c = handle::give(Component::new(instance));
        panics::watch();

        let panics =
            |_: &mut Component| -> Result<fmi2Status, Refusal> { panic!("out of {}", "luck") };
        assert_eq!(call(c, "fmi2DoStep", ANY, panics), fmi2Status::fmi2Error);
        let line = lines.borrow()[0].clone();
        assert!(
            line.contains("internal error: fmi2DoStep: out of luck (")
                && line.contains("guard.rs:"),
            "{line}"
        );
        let idle = |_: &mut Component| Ok(fmi2Status::fmi2OK);
        let stepping: Stages = &[LifeCycle::Instantiated, LifeCycle::StepComplete];
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2Error);
        assert!(lines.borrow()[1].contains("not allowed in state error"));
        let reset = |component: &mut Component| {
            component.instance.reset();
            Ok(fmi2Status::fmi2OK)
        };
        assert_eq!(call(c, "fmi2Reset", ANY, reset), fmi2Status::fmi2OK);
        assert_eq!(call(c, "fmi2DoStep", stepping, idle), fmi2Status::fmi2OK);
        free(c);
    }

    /// Refusals are told by a logger that may be anything.
    #[test]
    fn a_panic_of_the_logger_is_an_error_too() {
        let folder = tempfile::tempdir().unwrap();
        let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/feeder/feeder.toml");
        std::fs::copy(scene, folder.path().join("scene.toml")).unwrap();
        let log = || Log::new(Some(Box::new(|_, _, _| panic!("no more paper"))), false);
        let make = |guid: &str| {
            instantiate("fmi2Instantiate", log, || {
                Instance::new("one", guid, folder.path(), log()).map(Component::new)
            })
        };
        assert!(make("of another scene").is_null());
        let path = folder.path().join("scene.toml");
        let c = make(&Model::read(&path, None).unwrap().guid);
        assert!(!c.is_null());
        let refuse = |_: &mut Component| -> Result<fmi2Status, Refusal> {
            Err(Refusal::NotOffered {
                capability: "all",
                value: "false",
            })
        };
        assert_eq!(
            call(c, "fmi2CancelStep", ANY, refuse),
            fmi2Status::fmi2Error
        );
        free(c);
    }
}
