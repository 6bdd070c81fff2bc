//! Types of the FMI 3.0 C interface (`fmi3PlatformTypes.h`, `fmi3FunctionTypes.h`).
//!
//! Truth values that arrive from C are one byte; any but 0 is true.

#![allow(non_camel_case_types)]

use std::ffi::{c_char, c_int, c_void};

/// An instance.
pub type fmi3Instance = *mut c_void;
/// What the importer wants back with every call back.
pub type fmi3InstanceEnvironment = *mut c_void;
/// A saved state.
pub type fmi3FMUState = *mut c_void;
/// Handle of a variable.
pub type fmi3ValueReference = u32;
/// A real number.
pub type fmi3Float64 = f64;
/// A truth value: 0 is false.
pub type fmi3Boolean = u8;
/// A text, UTF-8, ended by NUL.
pub type fmi3String = *const c_char;
/// A byte of a binary or of a serialized state.
pub type fmi3Byte = u8;
/// Bytes of a binary.
pub type fmi3Binary = *const fmi3Byte;

/// Status of a call. `fmi3Fatal` is never returned.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum fmi3Status {
    /// Done.
    fmi3OK,
    /// Done, with a hint in the log.
    fmi3Warning,
    /// Not done, the state is as before.
    fmi3Discard,
    /// Refused or failed.
    fmi3Error,
}

/// The importer's logger: takes the message as it is.
pub type fmi3LogMessageCallback =
    unsafe extern "C" fn(fmi3InstanceEnvironment, c_int, fmi3String, fmi3String);

/// The importer's function that is called within a step: environment, time, whether inputs may be set, whether
/// variables may be read, whether an internal step is done, whether the step may end here; early return wanted, and when.
pub type fmi3IntermediateUpdateCallback = unsafe extern "C" fn(
    fmi3InstanceEnvironment,
    fmi3Float64,
    fmi3Boolean,
    fmi3Boolean,
    fmi3Boolean,
    fmi3Boolean,
    *mut fmi3Boolean,
    *mut fmi3Float64,
);
