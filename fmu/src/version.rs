//! Version and sources that this crate was built from; versions of the standard.

/// Version of this crate: part of the guid, so that a library and a description of another version part ways.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Hash of the sources that this crate was built from; its library holds the same as text.
pub const BUILD_ID: &str = env!("SPHERE_DDA_BUILD_ID");

/// Version of the standard that an FMU keeps to. The library in it is the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Version {
    /// FMI 2.0: scalars.
    #[default]
    Two,
    /// FMI 3.0: arrays.
    Three,
}
