//! The functional mock-up unit of sphere-dda: a scene-agnostic co-simulation library for FMI 2.0 and FMI 3.0, and what
//! the exporter asks of it.
//!
//! ```text
//! scene.toml -> model (scene, variables, guid) -> crate sphere-dda-export -> X.fmu
//! X.fmu -> any master -> ffi -> instance -> sphere_dda::simulation
//! ```
//!
//! The library holds no scene: it reads the one in `resources/`, builds the same variable table as the exporter did
//! and refuses a guid that does not fit. Unsafe code is in [`ffi`] only.

#[cfg(all(panic = "abort", not(target_family = "wasm")))]
compile_error!(
    "a panic would end the importer's process: build with panic = \"unwind\", which is the default"
);

pub mod ffi;
pub mod model;
pub mod runtime;
pub mod table;
pub mod version;
