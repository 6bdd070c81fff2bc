//! The 34 functions of FMI 2.0 for co-simulation: null pointers and panics stop here, all else is the instance's.

#![allow(non_snake_case)]

use std::ffi::c_int;
use std::panic::{AssertUnwindSafe, catch_unwind};

use sphere_dda_fmi_interface::abi2::*;
use sphere_dda_fmi_interface::log::{Level, Log};
use sphere_dda_fmi_interface::pointers::{BadArgument, Lent, sink};
use sphere_dda_fmi_interface::{handle, panics};

use crate::export::guid;
use crate::instance::{Instance, LifeCycle, Refusal};

use fmi2Status::{fmi2Discard, fmi2Error, fmi2OK};

/// What an `fmi2Component` points to.
struct Component {
    instance: Instance,
    log: Log,
}

impl handle::Kind for Component {
    const MAGIC: u64 = u64::from_le_bytes(*b"shakinst");
}

/// What an `fmi2FMUstate` points to.
struct Saved(Vec<u8>);

impl handle::Kind for Saved {
    const MAGIC: u64 = u64::from_le_bytes(*b"shaksave");
}

type Outcome = Result<fmi2Status, Refusal>;

/// As [`lend`], for functions without pointers among their arguments.
fn call(
    c: fmi2Component,
    function: &str,
    body: impl FnOnce(&mut Component) -> Outcome,
) -> fmi2Status {
    lend(c, function, |component, _| body(component))
}

/// Runs `body` on the shaker behind `c`; whatever happens ends as a status, with a log line if it is bad. Only pointers among the
/// arguments of this call may be handed to what `body` gets.
fn lend(
    c: fmi2Component,
    function: &str,
    body: impl for<'call> FnOnce(&mut Component, Lent<'call>) -> Outcome,
) -> fmi2Status {
    // SAFETY: the importer calls one instance from one thread at a time (FMI 2.0, section 4.2.1).
    let Some(component) = (unsafe { handle::look::<Component>(c) }) else {
        return fmi2Error;
    };
    // SAFETY: callers are the functions of the C interface, whose arguments the importer lends for the call; `body` is over
    // before it is.
    let lent = unsafe { Lent::new() };
    let why = match catch_unwind(AssertUnwindSafe(|| body(component, lent))) {
        Ok(Ok(status)) => return status,
        Ok(Err(refusal)) => refusal.to_string(),
        Err(panic) => {
            component.instance.fail();
            format!("internal error: {}", panics::told(&*panic))
        }
    };
    let log = || {
        component
            .log
            .write(Level::Error, format_args!("{function}: {why}"))
    };
    // A panic of the log must not cross into C either.
    let _ = catch_unwind(AssertUnwindSafe(log));
    fmi2Error
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetTypesPlatform() -> fmi2String {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetVersion() -> fmi2String {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SetDebugLogging(
    c: fmi2Component,
    loggingOn: fmi2Boolean,
    nCategories: usize,
    categories: *const fmi2String,
) -> fmi2Status {
    lend(c, "fmi2SetDebugLogging", |component, lent| {
        let names = lent.array(categories, nCategories, "categories")?.iter();
        let names: Vec<&str> = names
            .map(|&name| lent.text(name, "categories"))
            .collect::<Result<_, BadArgument>>()?;
        let unknown = component.log.select(loggingOn != FMI2_FALSE, &names);
        Ok(if unknown.is_empty() {
            fmi2OK
        } else {
            fmi2Status::fmi2Warning
        })
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2Instantiate(
    instanceName: fmi2String,
    fmuType: c_int,
    fmuGUID: fmi2String,
    _fmuResourceLocation: fmi2String,
    functions: *const fmi2CallbackFunctions,
    _visible: fmi2Boolean,
    loggingOn: fmi2Boolean,
) -> fmi2Component {
    panics::watch();
    let make = || {
        // SAFETY: the importer lends these arguments for this call.
        let lent = unsafe { Lent::new() };
        let name = lent.text(instanceName, "instanceName").unwrap_or_default();
        let callbacks = lent
            .array(functions, 1, "functions")
            .ok()
            .and_then(|f| f.first());
        let log = Log::new(
            callbacks.and_then(|f| sink(*f, name)),
            loggingOn != FMI2_FALSE,
        );
        let found = lent.text(fmuGUID, "fmuGUID").unwrap_or("(null)");
        let refused = match guid() {
            _ if name.is_empty() => "instanceName is empty, expected a name".to_owned(),
            _ if fmuType != FMI2_CO_SIMULATION => {
                format!("fmuType {fmuType}, expected 1 (co-simulation)")
            }
            Ok(own) if own == found => {
                let instance = Instance::default();
                return Some(Component { instance, log });
            }
            Ok(own) => format!("guid {found}, expected {own}: export the shaker again"),
            Err(error) => error.to_string(),
        };
        log.write(Level::Error, format_args!("fmi2Instantiate: {refused}"));
        None
    };
    match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Some(component)) => handle::give(component),
        _ => std::ptr::null_mut(),
    }
}

#[unsafe(no_mangle)]
extern "C" fn fmi2FreeInstance(c: fmi2Component) {
    // SAFETY: the importer has ended all calls of the instance.
    let component = unsafe { handle::take::<Component>(c) };
    // There is nobody left to tell of a panic.
    let _ = catch_unwind(AssertUnwindSafe(|| drop(component)));
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SetupExperiment(
    c: fmi2Component,
    _toleranceDefined: fmi2Boolean,
    _tolerance: fmi2Real,
    startTime: fmi2Real,
    _stopTimeDefined: fmi2Boolean,
    _stopTime: fmi2Real,
) -> fmi2Status {
    call(c, "fmi2SetupExperiment", |component| {
        component.instance.set_up(startTime)?;
        Ok(fmi2OK)
    })
}

/// The next part of the life cycle.
fn enter(c: fmi2Component, function: &str, from: &[LifeCycle], to: LifeCycle) -> fmi2Status {
    call(c, function, |component| {
        component.instance.enter(from, to)?;
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2EnterInitializationMode(c: fmi2Component) -> fmi2Status {
    let function = "fmi2EnterInitializationMode";
    enter(
        c,
        function,
        &[LifeCycle::Instantiated],
        LifeCycle::Initialization,
    )
}

#[unsafe(no_mangle)]
extern "C" fn fmi2ExitInitializationMode(c: fmi2Component) -> fmi2Status {
    let function = "fmi2ExitInitializationMode";
    enter(
        c,
        function,
        &[LifeCycle::Initialization],
        LifeCycle::Stepping,
    )
}

#[unsafe(no_mangle)]
extern "C" fn fmi2Terminate(c: fmi2Component) -> fmi2Status {
    enter(
        c,
        "fmi2Terminate",
        &[LifeCycle::Stepping],
        LifeCycle::Terminated,
    )
}

#[unsafe(no_mangle)]
extern "C" fn fmi2Reset(c: fmi2Component) -> fmi2Status {
    call(c, "fmi2Reset", |component| {
        component.instance = Instance::default();
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Real,
) -> fmi2Status {
    lend(c, "fmi2GetReal", |component, lent| {
        let references = lent.array(vr, nvr, "vr")?.iter();
        let values: Vec<f64> = references
            .map(|&reference| component.instance.get(reference))
            .collect::<Result<_, _>>()?;
        lent.places(value, nvr, "value")?
            .write_copy_of_slice(&values);
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Real,
) -> fmi2Status {
    lend(c, "fmi2SetReal", |component, lent| {
        let (references, values) = (lent.array(vr, nvr, "vr")?, lent.array(value, nvr, "value")?);
        let pairs = references.iter().copied().zip(values.iter().copied());
        component.instance.set(pairs)?;
        Ok(fmi2OK)
    })
}

/// Get and set of types that no variable has: fine for none.
macro_rules! no_variables {
    ($($name:ident: $value:ty;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            c: fmi2Component,
            vr: *const fmi2ValueReference,
            nvr: usize,
            _value: $value,
        ) -> fmi2Status {
            lend(c, stringify!($name), |_, lent| match lent.array(vr, nvr, "vr")?.first() {
                Some(&reference) => Err(Refusal::Reference(reference)),
                None => Ok(fmi2OK),
            })
        }
    )*};
}

no_variables! {
    fmi2GetInteger: *mut fmi2Integer;
    fmi2GetBoolean: *mut fmi2Boolean;
    fmi2GetString: *mut fmi2String;
    fmi2SetInteger: *const fmi2Integer;
    fmi2SetBoolean: *const fmi2Boolean;
    fmi2SetString: *const fmi2String;
}

#[unsafe(no_mangle)]
extern "C" fn fmi2DoStep(
    c: fmi2Component,
    currentCommunicationPoint: fmi2Real,
    communicationStepSize: fmi2Real,
    _noSetFMUStatePriorToCurrentPoint: fmi2Boolean,
) -> fmi2Status {
    call(c, "fmi2DoStep", |component| {
        let instance = &mut component.instance;
        instance.step(currentCommunicationPoint, communicationStepSize)?;
        Ok(fmi2OK)
    })
}

/// The saved state behind a pointer.
fn saved<'a>(state: fmi2FMUstate) -> Result<&'a mut Vec<u8>, BadArgument> {
    // SAFETY: the importer uses a state in one call at a time.
    match unsafe { handle::look::<Saved>(state) } {
        Some(saved) => Ok(&mut saved.0),
        None => Err(none()),
    }
}

fn none() -> BadArgument {
    BadArgument {
        argument: "FMUstate",
        found: "null, or was freed".to_owned(),
        expected: "a saved state",
    }
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    lend(c, "fmi2GetFMUstate", |component, lent| {
        let place = lent.variable(state, "FMUstate")?;
        let bytes = component.instance.save();
        match place.is_null() {
            true => *place = handle::give(Saved(bytes)),
            false => *saved(*place)? = bytes,
        }
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SetFMUstate(c: fmi2Component, state: fmi2FMUstate) -> fmi2Status {
    call(c, "fmi2SetFMUstate", |component| {
        component.instance = Instance::load(saved(state)?)?;
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2FreeFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    lend(c, "fmi2FreeFMUstate", |_, lent| {
        let place = lent.variable(state, "FMUstate")?;
        if !place.is_null() {
            // SAFETY: the importer uses the state in no other call.
            drop(unsafe { handle::take::<Saved>(*place) }.ok_or_else(none)?);
            *place = std::ptr::null_mut();
        }
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SerializedFMUstateSize(
    c: fmi2Component,
    state: fmi2FMUstate,
    size: *mut usize,
) -> fmi2Status {
    lend(c, "fmi2SerializedFMUstateSize", |_, lent| {
        let bytes = saved(state)?.len();
        lent.place(size, "size")?.write(bytes);
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2SerializeFMUstate(
    c: fmi2Component,
    state: fmi2FMUstate,
    serialized: *mut fmi2Byte,
    size: usize,
) -> fmi2Status {
    lend(c, "fmi2SerializeFMUstate", |_, lent| {
        let bytes = saved(state)?;
        if size != bytes.len() {
            return Err(Refusal::State { found: size });
        }
        lent.places(serialized.cast::<u8>(), size, "serializedState")?
            .write_copy_of_slice(bytes);
        Ok(fmi2OK)
    })
}

#[unsafe(no_mangle)]
extern "C" fn fmi2DeSerializeFMUstate(
    c: fmi2Component,
    serialized: *const fmi2Byte,
    size: usize,
    state: *mut fmi2FMUstate,
) -> fmi2Status {
    lend(c, "fmi2DeSerializeFMUstate", |_, lent| {
        let bytes = lent.array(serialized.cast::<u8>(), size, "serializedState")?;
        let place = lent.place(state, "FMUstate")?;
        let bytes = Instance::load(bytes)?.save();
        place.write(handle::give(Saved(bytes)));
        Ok(fmi2OK)
    })
}

/// Functions of capabilities that are not offered, by the flag in the model description.
macro_rules! not_offered {
    ($($name:ident($($argument:ty),*): $flag:literal;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(c: fmi2Component, $(_: $argument),*) -> fmi2Status {
            call(c, stringify!($name), |_| Err(Refusal::NotOffered($flag)))
        }
    )*};
}

not_offered! {
    fmi2GetDirectionalDerivative(
        *const fmi2ValueReference, usize, *const fmi2ValueReference, usize, *const fmi2Real, *mut fmi2Real
    ): "providesDirectionalDerivative";
    fmi2SetRealInputDerivatives(
        *const fmi2ValueReference, usize, *const fmi2Integer, *const fmi2Real
    ): "canInterpolateInputs";
    fmi2GetRealOutputDerivatives(
        *const fmi2ValueReference, usize, *const fmi2Integer, *mut fmi2Real
    ): "maxOutputDerivativeOrder";
    fmi2CancelStep(): "canRunAsynchronuously";
}

/// Status questions that belong to steps under way: there are none.
macro_rules! no_status {
    ($($name:ident: $value:ty;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(c: fmi2Component, _kind: c_int, _value: *mut $value) -> fmi2Status {
            call(c, stringify!($name), |_| Ok(fmi2Discard))
        }
    )*};
}

no_status! {
    fmi2GetStatus: c_int;
    fmi2GetIntegerStatus: fmi2Integer;
    fmi2GetBooleanStatus: fmi2Boolean;
    fmi2GetStringStatus: fmi2String;
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetRealStatus(c: fmi2Component, kind: c_int, value: *mut fmi2Real) -> fmi2Status {
    lend(c, "fmi2GetRealStatus", |component, lent| {
        if kind != FMI2_LAST_SUCCESSFUL_TIME {
            return Ok(fmi2Discard);
        }
        let time = component.instance.time();
        lent.place(value, "value")?.write(time);
        Ok(fmi2OK)
    })
}
