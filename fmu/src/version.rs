//! Version and sources that this crate was built from.

/// Version of this crate: part of the guid, so that a library and a description of another version part ways.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Hash of the sources that this crate was built from; its library holds the same as text.
pub const BUILD_ID: &str = env!("SPHERE_DDA_BUILD_ID");
