//! Versions of the standard.

use sphere_dda_fmi_interface::platform::Platform;

/// Version of the standard that an FMU keeps to. The library in it is the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Version {
    /// FMI 2.0: scalars.
    #[default]
    Two,
    /// FMI 3.0: arrays.
    Three,
}

impl Version {
    /// Path of the library for a platform inside the archive.
    pub(crate) fn library_path(self, platform: &Platform, identifier: &str) -> String {
        match self {
            Self::Two => platform.path_2(identifier),
            Self::Three => platform.path_3(identifier),
        }
    }
}
