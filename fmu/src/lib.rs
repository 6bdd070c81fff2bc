//! The functional mock-up unit of sphere-dda: a scene-agnostic FMI 2.0 co-simulation library, its exporter, and a
//! small master for FMUs of any kind.
//!
//! ```text
//! scene.toml -> model (scene, variables, guid) -> description -> export -> X.fmu
//! X.fmu -> any master -> ffi -> instance -> sphere_dda::simulation
//! ```
//!
//! The library holds no scene: it reads the one in `resources/`, builds the same variable table as the exporter did
//! and refuses a guid that does not fit. Unsafe code is in [`ffi`] and in the importer only.

pub mod description;
pub mod documentation;
pub mod export;
pub mod ffi;
pub mod import;
pub mod instance;
pub mod model;
pub mod recorder;
pub mod refusal;
pub mod resource;
pub mod state;
pub mod terminals;
pub mod variables;
