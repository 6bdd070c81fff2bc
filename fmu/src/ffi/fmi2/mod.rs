//! The 34 functions of FMI 2.0 for co-simulation, in the order of the standard.

#![allow(non_snake_case)]

mod derivatives;
mod states;
mod values;

use std::ffi::c_int;

use super::guard::{
    self, ANY, Component, INITIALIZATION, INSTANTIATED, STEPPED, STEPPING, Stages, call, lend,
};
use super::logging;
use crate::runtime::instance::{Instance, Step};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::{InstantiationError, Refusal};
use crate::runtime::resource;
use sphere_dda_fmi_interface::abi2::*;
use sphere_dda_fmi_interface::log::{Level, Log};
use sphere_dda_fmi_interface::pointers::{Lent, sink};

use fmi2Status::{fmi2Discard, fmi2OK, fmi2Warning};

/// Where a variable that is not fixed may be set: what is set holds for the next step.
const SETTABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
];

/// Platform of the types: "default".
#[unsafe(no_mangle)]
extern "C" fn fmi2GetTypesPlatform() -> fmi2String {
    c"default".as_ptr()
}

/// Version of the standard: "2.0".
#[unsafe(no_mangle)]
extern "C" fn fmi2GetVersion() -> fmi2String {
    c"2.0".as_ptr()
}

/// Chooses which categories are logged; see [`Log::select`]. Unknown names are told and left out.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetDebugLogging(
    c: fmi2Component,
    loggingOn: fmi2Boolean,
    nCategories: usize,
    categories: *const fmi2String,
) -> fmi2Status {
    let on = loggingOn != FMI2_FALSE;
    logging::select((c, "fmi2SetDebugLogging"), ANY, on, nCategories, categories)
}

/// Makes an instance; null if it cannot, with the reason in the log.
#[unsafe(no_mangle)]
extern "C" fn fmi2Instantiate(
    instanceName: fmi2String,
    fmuType: c_int,
    fmuGUID: fmi2String,
    fmuResourceLocation: fmi2String,
    functions: *const fmi2CallbackFunctions,
    _visible: fmi2Boolean,
    loggingOn: fmi2Boolean,
) -> fmi2Component {
    // SAFETY: the importer lends these arguments for this call.
    let lent = unsafe { Lent::new() };
    let name = lent.text(instanceName, "instanceName").unwrap_or_default();
    let callbacks = lent.array(functions, 1, "functions").ok().map(|f| f[0]);
    let log = || {
        Log::new(
            callbacks.and_then(|f| sink(f, name)),
            loggingOn != FMI2_FALSE,
        )
    };
    guard::instantiate("fmi2Instantiate", log, || {
        let guid = lent.text(fmuGUID, "fmuGUID").unwrap_or("(null)");
        let location = lent.text(fmuResourceLocation, "fmuResourceLocation");
        instantiate(name, fmuType, guid, location.ok(), log()).map(Component::new)
    })
}

fn instantiate(
    name: &str,
    kind: c_int,
    guid: &str,
    location: Option<&str>,
    log: Log,
) -> Result<Instance, InstantiationError> {
    if kind != FMI2_CO_SIMULATION {
        return Err(InstantiationError::Interface { found: kind });
    }
    Instance::new(name, guid, &resource::directory(location)?, log)
}

/// Frees an instance, in any state; null is ignored.
#[unsafe(no_mangle)]
extern "C" fn fmi2FreeInstance(c: fmi2Component) {
    guard::free(c);
}

/// Start and stop of the experiment. The tolerance is not used: tolerances are parameters.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetupExperiment(
    c: fmi2Component,
    _toleranceDefined: fmi2Boolean,
    _tolerance: fmi2Real,
    startTime: fmi2Real,
    stopTimeDefined: fmi2Boolean,
    stopTime: fmi2Real,
) -> fmi2Status {
    call(c, "fmi2SetupExperiment", INSTANTIATED, |component| {
        let stop = (stopTimeDefined != FMI2_FALSE).then_some(stopTime);
        component.instance.set_up(startTime, stop)?;
        Ok(fmi2OK)
    })
}

/// Enters initialization mode.
#[unsafe(no_mangle)]
extern "C" fn fmi2EnterInitializationMode(c: fmi2Component) -> fmi2Status {
    call(
        c,
        "fmi2EnterInitializationMode",
        INSTANTIATED,
        |component| {
            component.instance.enter_initialization();
            Ok(fmi2OK)
        },
    )
}

/// Leaves initialization mode: the configuration is read here.
#[unsafe(no_mangle)]
extern "C" fn fmi2ExitInitializationMode(c: fmi2Component) -> fmi2Status {
    call(
        c,
        "fmi2ExitInitializationMode",
        INITIALIZATION,
        |component| {
            component.instance.exit_initialization()?;
            Ok(fmi2OK)
        },
    )
}

/// Status of a call that completes the result files: a warning if some could not be written.
fn written(whole: bool) -> fmi2Status {
    if whole { fmi2OK } else { fmi2Warning }
}

/// Ends the run.
#[unsafe(no_mangle)]
extern "C" fn fmi2Terminate(c: fmi2Component) -> fmi2Status {
    call(c, "fmi2Terminate", STEPPING, |component| {
        Ok(written(component.instance.terminate()))
    })
}

/// Back to the state after instantiation.
#[unsafe(no_mangle)]
extern "C" fn fmi2Reset(c: fmi2Component) -> fmi2Status {
    call(c, "fmi2Reset", ANY, |component| {
        Ok(written(component.instance.reset()))
    })
}

fn not_offered(
    c: fmi2Component,
    function: &str,
    capability: &'static str,
    value: &'static str,
) -> fmi2Status {
    call(c, function, ANY, |_| {
        Err(Refusal::NotOffered { capability, value })
    })
}

/// Takes a step; a discarded one leaves the instance at its beginning.
#[unsafe(no_mangle)]
extern "C" fn fmi2DoStep(
    c: fmi2Component,
    currentCommunicationPoint: fmi2Real,
    communicationStepSize: fmi2Real,
    noSetFMUStatePriorToCurrentPoint: fmi2Boolean,
) -> fmi2Status {
    call(c, "fmi2DoStep", STEPPING, |component| {
        let final_past = noSetFMUStatePriorToCurrentPoint != FMI2_FALSE;
        let instance = &mut component.instance;
        match instance.do_step(currentCommunicationPoint, communicationStepSize, final_past)? {
            Step::Complete => Ok(match instance.unconverged("fmi2DoStep") {
                true => fmi2Warning,
                false => fmi2OK,
            }),
            Step::Discarded(why) => {
                instance
                    .log()
                    .write(Level::Discard, format_args!("fmi2DoStep: {why}"));
                Ok(fmi2Discard)
            }
        }
    })
}

/// Not offered: no step is ever pending.
#[unsafe(no_mangle)]
extern "C" fn fmi2CancelStep(c: fmi2Component) -> fmi2Status {
    not_offered(c, "fmi2CancelStep", "canRunAsynchronuously", "false")
}

/// Answers a status question if `ask` knows it; `fmi2Discard` means "not provided".
fn status<T: Copy>(
    (c, function): (fmi2Component, &str),
    kind: c_int,
    value: *mut T,
    ask: impl FnOnce(&Instance) -> Option<T>,
) -> fmi2Status {
    lend(c, function, STEPPED, |component, lent| {
        let place = lent.place(value, "value")?;
        let Some(answer) = ask(&component.instance) else {
            let text = format!(
                "{function}: status kind {kind} is not provided: steps are not asynchronous"
            );
            component.instance.log().write(Level::Discard, text);
            return Ok(fmi2Discard);
        };
        place.write(answer);
        Ok(fmi2OK)
    })
}

/// No such status: steps are not asynchronous.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetStatus(c: fmi2Component, s: c_int, value: *mut c_int) -> fmi2Status {
    status((c, "fmi2GetStatus"), s, value, |_| None)
}

/// `fmi2LastSuccessfulTime`: where the instance stands.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetRealStatus(c: fmi2Component, s: c_int, value: *mut fmi2Real) -> fmi2Status {
    status((c, "fmi2GetRealStatus"), s, value, |i| {
        (s == FMI2_LAST_SUCCESSFUL_TIME).then(|| i.time())
    })
}

/// No such status.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetIntegerStatus(
    c: fmi2Component,
    s: c_int,
    value: *mut fmi2Integer,
) -> fmi2Status {
    status((c, "fmi2GetIntegerStatus"), s, value, |_| None)
}

/// `fmi2Terminated`: true in state error only. After a discarded step a shorter one may be tried.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetBooleanStatus(
    c: fmi2Component,
    s: c_int,
    value: *mut fmi2Boolean,
) -> fmi2Status {
    let answer = |i: &Instance| {
        if i.wants_to_terminate() {
            FMI2_TRUE
        } else {
            FMI2_FALSE
        }
    };
    status((c, "fmi2GetBooleanStatus"), s, value, |i| {
        (s == FMI2_TERMINATED).then(|| answer(i))
    })
}

/// No such status.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetStringStatus(
    c: fmi2Component,
    s: c_int,
    value: *mut fmi2String,
) -> fmi2Status {
    status((c, "fmi2GetStringStatus"), s, value, |_| None)
}
