//! The C boundary: a wall between the importer and [`crate::runtime::instance`].
//!
//! Null pointers, the life cycle, and panics stop here; values and times are judged by the instance. All `unsafe`
//! code of the exported library is in this folder. A function answers
//!
//! - `fmi2OK` or, where the call is served but hints at a mistake, `fmi2Warning`;
//! - `fmi2Discard` for a step that was not taken, and for a status that is not provided;
//! - `fmi2Error` for a refused call, which has changed nothing, and for a failed instance, which then waits for
//!   `fmi2Reset`, `fmi2SetFMUstate` or `fmi2FreeInstance`. `fmi2Fatal` is never returned.
//!
//! and likewise `fmi3OK` to `fmi3Error`. Model exchange is not offered: FMI 2.0 asks a co-simulation FMU not to export
//! its functions, FMI 3.0 asks for all functions, and those of what is not offered are refused.

#[cfg(target_family = "wasm")]
mod embedded;
mod fmi2;
mod fmi3;
mod guard;
mod logging;
mod saved;
mod values;

use crate::version::BUILD_ID;

/// Which sources this library was built from: not FMI, for the exporter, which finds the text in the file.
#[unsafe(no_mangle)]
static SPHERE_DDA_BUILD_ID: &str = BUILD_ID;
