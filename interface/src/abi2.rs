//! Types of the FMI 2.0 C interface (`fmi2TypesPlatform.h`, `fmi2FunctionTypes.h`), platform "default".
//!
//! Enumerations that arrive from C are plain integers: a value outside the enumeration must be refused, not assumed
//! away.

#![allow(non_camel_case_types)]

use std::ffi::{c_char, c_int, c_uint, c_void};

/// An instance.
pub type fmi2Component = *mut c_void;
/// What the importer wants back with every log line.
pub type fmi2ComponentEnvironment = *mut c_void;
/// A saved state.
pub type fmi2FMUstate = *mut c_void;
/// Handle of a variable.
pub type fmi2ValueReference = c_uint;
/// A real number.
pub type fmi2Real = f64;
/// An integer.
pub type fmi2Integer = c_int;
/// A truth value: 0 is false.
pub type fmi2Boolean = c_int;
/// A text, UTF-8, ended by NUL.
pub type fmi2String = *const c_char;
/// A byte of a serialized state.
pub type fmi2Byte = c_char;

/// False.
pub const FMI2_FALSE: fmi2Boolean = 0;
/// True.
pub const FMI2_TRUE: fmi2Boolean = 1;
/// `fmi2CoSimulation` of `fmi2Type`.
pub const FMI2_CO_SIMULATION: c_int = 1;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
pub const FMI2_LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
pub const FMI2_TERMINATED: c_int = 3;

/// Status of a call. `fmi2Fatal` and `fmi2Pending` are never returned.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum fmi2Status {
    /// Done.
    fmi2OK,
    /// Done, with a hint in the log.
    fmi2Warning,
    /// Not done, the state is as before.
    fmi2Discard,
    /// Refused or failed.
    fmi2Error,
}

/// The importer's logger: a C function like `printf`.
pub type fmi2CallbackLogger =
    unsafe extern "C" fn(fmi2ComponentEnvironment, fmi2String, c_int, fmi2String, fmi2String, ...);

/// Functions of the importer. Only the logger is used.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct fmi2CallbackFunctions {
    /// Takes log lines; may be null.
    pub logger: Option<fmi2CallbackLogger>,
    /// Not used: `canNotUseMemoryManagementFunctions`.
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    /// Not used.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Not used: steps are not asynchronous.
    pub step_finished: Option<unsafe extern "C" fn(fmi2ComponentEnvironment, c_int)>,
    /// Handed to the logger.
    pub component_environment: fmi2ComponentEnvironment,
}
