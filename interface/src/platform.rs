//! Platforms as FMUs name them: where the library of each lies in the archive.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};

/// An operating system and processor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Platform {
    /// Folder of its binaries in FMI 2.0; also its name for people.
    pub name: &'static str,
    /// Folder of its binaries in FMI 3.0: architecture and system.
    pub tuple: &'static str,
    /// What file names of shared libraries begin with when they are built.
    pub prefix: &'static str,
    /// What they end with.
    pub suffix: &'static str,
}

impl Platform {
    /// Linux on 64-bit Intel and AMD processors.
    pub const LINUX64: Self = Self {
        name: "linux64",
        tuple: "x86_64-linux",
        prefix: "lib",
        suffix: ".so",
    };
    /// Windows on such processors.
    pub const WINDOWS64: Self = Self {
        name: "win64",
        tuple: "x86_64-windows",
        prefix: "",
        suffix: ".dll",
    };
    /// The platform this program runs on.
    pub const HERE: Self = Self {
        name: if cfg!(target_os = "windows") {
            "win64"
        } else if cfg!(target_os = "macos") {
            "darwin64"
        } else {
            "linux64"
        },
        tuple: match (
            cfg!(target_arch = "aarch64"),
            cfg!(target_os = "windows"),
            cfg!(target_os = "macos"),
        ) {
            (false, false, false) => "x86_64-linux",
            (false, true, _) => "x86_64-windows",
            (false, false, true) => "x86_64-darwin",
            (true, false, false) => "aarch64-linux",
            (true, true, _) => "aarch64-windows",
            (true, false, true) => "aarch64-darwin",
        },
        prefix: DLL_PREFIX,
        suffix: DLL_SUFFIX,
    };

    /// The platform of a name that FMUs are built for from elsewhere, or of this one.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let known = [Self::HERE, Self::LINUX64, Self::WINDOWS64];
        known.into_iter().find(|platform| platform.name == name)
    }

    /// Where the library of the model `identifier` lies in an archive of FMI 2.0.
    #[must_use]
    pub fn path_2(&self, identifier: &str) -> String {
        format!("binaries/{}/{identifier}{}", self.name, self.suffix)
    }

    /// The same for FMI 3.0.
    #[must_use]
    pub fn path_3(&self, identifier: &str) -> String {
        format!("binaries/{}/{identifier}{}", self.tuple, self.suffix)
    }

    /// File name of the library of the crate `name` as it is built.
    #[must_use]
    pub fn file(&self, name: &str) -> String {
        format!("{}{name}{}", self.prefix, self.suffix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_those_of_the_standards() {
        let (linux, windows) = (Platform::LINUX64, Platform::WINDOWS64);
        assert_eq!(linux.path_2("m"), "binaries/linux64/m.so");
        assert_eq!(linux.path_3("m"), "binaries/x86_64-linux/m.so");
        assert_eq!(windows.path_2("m"), "binaries/win64/m.dll");
        assert_eq!(windows.path_3("m"), "binaries/x86_64-windows/m.dll");
        assert_eq!(linux.file("m"), "libm.so");
        assert_eq!(windows.file("m"), "m.dll");
        assert_eq!(Platform::named("linux64").map(|p| p.suffix), Some(".so"));
        assert_eq!(Platform::named("linux32"), None);
    }
}
