//! Packs a scene and the library of `sphere-dda-fmu` into an FMU of FMI 2.0 or 3.0.
//!
//! ```text
//! scene.toml -> sphere_dda_fmu::model (scene, variables, guid) -> description, terminals, documentation -> X.fmu
//! ```
//!
//! [`export`] writes the archive, [`find_libraries`] looks for the libraries that go into it.

pub mod component;
pub mod description;
pub mod documentation;
mod error;
mod geometry;
mod library;
mod pack;
mod references;
mod terminals;

pub use error::{ExportError, LIBRARY_VARIABLE};
pub use library::{Library, check_library, find_libraries, find_library};
pub use pack::{Contents, Exported, Pictures, core_module_of, export};
pub use references::SmokeTest;
pub use sphere_dda_fmi_interface::platform::Platform;
pub use sphere_dda_fmu::version::Version;
