//! The 75 functions of FMI 3.0: those of co-simulation here and in `values`, `states`, `step` and `derivatives`; those of what is not
//! offered in `absent`.

#![allow(non_snake_case)]

mod absent;
#[cfg(target_family = "wasm")]
mod component;
mod derivatives;
mod states;
mod step;
mod values;

use std::ffi::c_void;

use super::guard::{self, ANY, Component, INITIALIZATION, INSTANTIATED, STEPPING, Updates, call};
use super::logging;
use crate::runtime::instance::Instance;
use crate::runtime::refusal::InstantiationError;
use crate::runtime::resource;
use crate::version::Version;
use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_fmi_interface::log::{Level, Log};
use sphere_dda_fmi_interface::pointers::{Lent, message_sink};

use fmi3Status::{fmi3OK, fmi3Warning};

/// What an importer is told that wants events.
const NO_EVENTS: &str = "fmi3InstantiateCoSimulation: eventModeUsed is true, but hasEventMode is false: there will be no events";

/// Version of the standard: "3.0".
#[unsafe(no_mangle)]
extern "C" fn fmi3GetVersion() -> fmi3String {
    c"3.0".as_ptr()
}

/// Chooses which categories are logged.
#[unsafe(no_mangle)]
extern "C" fn fmi3SetDebugLogging(
    instance: fmi3Instance,
    loggingOn: fmi3Boolean,
    nCategories: usize,
    categories: *const fmi3String,
) -> fmi3Status {
    let call = (instance, "fmi3SetDebugLogging");
    logging::select(call, ANY, loggingOn != 0, nCategories, categories)
}

/// Makes an instance; null if it cannot, with the reason in the log.
#[unsafe(no_mangle)]
extern "C" fn fmi3InstantiateCoSimulation(
    instanceName: fmi3String,
    instantiationToken: fmi3String,
    resourcePath: fmi3String,
    _visible: fmi3Boolean,
    loggingOn: fmi3Boolean,
    eventModeUsed: fmi3Boolean,
    earlyReturnAllowed: fmi3Boolean,
    requiredIntermediateVariables: *const fmi3ValueReference,
    nRequiredIntermediateVariables: usize,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: Option<fmi3LogMessageCallback>,
    intermediateUpdate: Option<fmi3IntermediateUpdateCallback>,
) -> fmi3Instance {
    let log = || {
        Log::new(
            message_sink(logMessage, instanceEnvironment),
            loggingOn != 0,
        )
    };
    let updates = intermediateUpdate.map(|callback| Updates {
        callback,
        environment: instanceEnvironment,
        early_return_allowed: earlyReturnAllowed != 0,
    });
    // SAFETY: the importer lends these arguments for this call.
    let lent = unsafe { Lent::new() };
    guard::instantiate("fmi3InstantiateCoSimulation", log, || {
        if eventModeUsed != 0 {
            log().write(Level::Warning, NO_EVENTS);
        }
        let name = lent.text(instanceName, "instanceName").unwrap_or_default();
        let token = lent.text(instantiationToken, "instantiationToken");
        let path = lent.text(resourcePath, "resourcePath").ok();
        let resources = resource::directory(path)?;
        let instance = Instance::new(name, token.unwrap_or("(null)"), &resources, log())?;
        let (required, count) = (
            requiredIntermediateVariables,
            nRequiredIntermediateVariables,
        );
        known(
            &instance,
            lent.array(required, count, "requiredIntermediateVariables")?,
        )?;
        Ok(Component {
            updates,
            ..Component::new(instance)
        })
    })
}

/// The variables that the importer wants within a step must be such as can be had there.
fn known(instance: &Instance, required: &[fmi3ValueReference]) -> Result<(), InstantiationError> {
    let table = &instance.model().table;
    let has = |&reference: &u32| {
        let entry = table.get(Version::Three, reference);
        entry.is_some_and(|entry| entry.variable.is_intermediate())
    };
    match required.iter().find(|&reference| !has(reference)) {
        Some(&reference) => Err(InstantiationError::Intermediate { reference }),
        None => Ok(()),
    }
}

/// Tells in the log that an interface is not offered.
fn refuse(
    interface: &'static str,
    environment: fmi3InstanceEnvironment,
    logger: Option<fmi3LogMessageCallback>,
) -> fmi3Instance {
    let error = InstantiationError::Interface3 { interface };
    Log::new(message_sink(logger, environment), false).write(Level::Error, error);
    std::ptr::null_mut()
}

/// Not offered: null, with the reason in the log.
#[unsafe(no_mangle)]
extern "C" fn fmi3InstantiateModelExchange(
    _instanceName: fmi3String,
    _instantiationToken: fmi3String,
    _resourcePath: fmi3String,
    _visible: fmi3Boolean,
    _loggingOn: fmi3Boolean,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: Option<fmi3LogMessageCallback>,
) -> fmi3Instance {
    refuse("model exchange", instanceEnvironment, logMessage)
}

/// Not offered: null, with the reason in the log.
#[unsafe(no_mangle)]
extern "C" fn fmi3InstantiateScheduledExecution(
    _instanceName: fmi3String,
    _instantiationToken: fmi3String,
    _resourcePath: fmi3String,
    _visible: fmi3Boolean,
    _loggingOn: fmi3Boolean,
    instanceEnvironment: fmi3InstanceEnvironment,
    logMessage: Option<fmi3LogMessageCallback>,
    _clockUpdate: *const c_void,
    _lockPreemption: *const c_void,
    _unlockPreemption: *const c_void,
) -> fmi3Instance {
    refuse("scheduled execution", instanceEnvironment, logMessage)
}

/// Frees an instance; null is ignored, and so is a call within a step, which still needs it.
#[unsafe(no_mangle)]
extern "C" fn fmi3FreeInstance(instance: fmi3Instance) {
    if call(instance, "fmi3FreeInstance", ANY, |_| Ok(fmi3OK)) != fmi3OK {
        return;
    }
    guard::free(instance);
}

/// Enters initialization mode with start and stop of the experiment. The tolerance is not used: tolerances are
/// parameters.
#[unsafe(no_mangle)]
extern "C" fn fmi3EnterInitializationMode(
    instance: fmi3Instance,
    _toleranceDefined: fmi3Boolean,
    _tolerance: fmi3Float64,
    startTime: fmi3Float64,
    stopTimeDefined: fmi3Boolean,
    stopTime: fmi3Float64,
) -> fmi3Status {
    let function = "fmi3EnterInitializationMode";
    call(instance, function, INSTANTIATED, |component| {
        let stop = (stopTimeDefined != 0).then_some(stopTime);
        component.instance.set_up(startTime, stop)?;
        component.instance.enter_initialization();
        Ok(fmi3OK)
    })
}

/// Leaves initialization mode: the configuration is read here.
#[unsafe(no_mangle)]
extern "C" fn fmi3ExitInitializationMode(instance: fmi3Instance) -> fmi3Status {
    let function = "fmi3ExitInitializationMode";
    call(instance, function, INITIALIZATION, |component| {
        component.instance.exit_initialization()?;
        Ok(fmi3OK)
    })
}

/// Status of a call that completes the result files: a warning if some could not be written.
fn written(whole: bool) -> fmi3Status {
    if whole { fmi3OK } else { fmi3Warning }
}

/// Ends the run.
#[unsafe(no_mangle)]
extern "C" fn fmi3Terminate(instance: fmi3Instance) -> fmi3Status {
    call(instance, "fmi3Terminate", STEPPING, |component| {
        Ok(written(component.instance.terminate()))
    })
}

/// Back to the state after instantiation.
#[unsafe(no_mangle)]
extern "C" fn fmi3Reset(instance: fmi3Instance) -> fmi3Status {
    call(instance, "fmi3Reset", ANY, |component| {
        Ok(written(component.instance.reset()))
    })
}
