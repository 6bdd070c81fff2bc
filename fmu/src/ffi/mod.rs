//! The C boundary: a wall between the importer and [`crate::instance`].
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

mod fmi2;
mod fmi3;
mod guard;
mod logging;
mod saved;

use std::ffi::{CStr, c_char};
use std::path::{Path, PathBuf};

/// Build id of a library of this crate.
///
/// # Errors
/// If it cannot be loaded or is another library.
pub fn build_id(path: &Path) -> Result<String, libloading::Error> {
    // A name without folder would be searched for in the system's library folders.
    let path: PathBuf = if path.is_absolute() {
        path.to_path_buf()
    } else {
        Path::new(".").join(path)
    };
    // SAFETY: loading runs the initializers of the library; the caller names a library of this project.
    let library = unsafe { libloading::Library::new(path.as_os_str())? };
    // SAFETY: the symbol belongs to this crate, which has given it this type ever since.
    let ask = unsafe { library.get::<extern "C" fn() -> *const c_char>("sphere_dda_build_id")? };
    // SAFETY: the function returns a constant text ended by NUL; it is copied before the library is closed.
    Ok(unsafe { CStr::from_ptr(ask()) }
        .to_string_lossy()
        .into_owned())
}
