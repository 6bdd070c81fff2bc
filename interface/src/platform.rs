//! Platforms as FMUs name them: where the library of each lies in the archive.
//!
//! FMI 2.0 has names of its own for Intel and AMD processors only, where "64" stands for 64-bit x86; for all others it
//! refers to the tuples of FMI 3.0 (2.0.4 and later, section 2.3).

use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};

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

/// Architecture and system as Rust names them, and what FMI makes of them.
const KNOWN: [(&str, &str, Platform); 8] = [
    ("x86_64", "linux", Platform::LINUX64),
    ("x86", "linux", linux("linux32", "x86-linux")),
    ("aarch64", "linux", Platform::AARCH64_LINUX),
    ("x86_64", "windows", Platform::WINDOWS64),
    ("x86", "windows", windows("win32", "x86-windows")),
    (
        "aarch64",
        "windows",
        windows("aarch64-windows", "aarch64-windows"),
    ),
    ("x86_64", "macos", darwin("darwin64", "x86_64-darwin")),
    (
        "aarch64",
        "macos",
        darwin("aarch64-darwin", "aarch64-darwin"),
    ),
];

const fn linux(name: &'static str, tuple: &'static str) -> Platform {
    let (prefix, suffix) = ("lib", ".so");
    Platform {
        name,
        tuple,
        prefix,
        suffix,
    }
}

const fn windows(name: &'static str, tuple: &'static str) -> Platform {
    let (prefix, suffix) = ("", ".dll");
    Platform {
        name,
        tuple,
        prefix,
        suffix,
    }
}

const fn darwin(name: &'static str, tuple: &'static str) -> Platform {
    let (prefix, suffix) = ("lib", ".dylib");
    Platform {
        name,
        tuple,
        prefix,
        suffix,
    }
}

impl Platform {
    /// Linux on 64-bit Intel and AMD processors.
    pub const LINUX64: Self = linux("linux64", "x86_64-linux");
    /// Linux on 64-bit ARM processors.
    pub const AARCH64_LINUX: Self = linux("aarch64-linux", "aarch64-linux");
    /// Windows on 64-bit Intel and AMD processors.
    pub const WINDOWS64: Self = windows("win64", "x86_64-windows");
    /// Any machine with a runtime for components of WebAssembly, by the draft FMI-LS-WASM; FMI 3.0 only.
    pub const WASM: Self = Self {
        name: "wasm",
        tuple: "wasm32-wasip2",
        prefix: "",
        suffix: ".wasm",
    };
    /// The platforms that `fmu/platforms/build` builds for.
    pub const APART: [Self; 4] = [
        Self::LINUX64,
        Self::AARCH64_LINUX,
        Self::WINDOWS64,
        Self::WASM,
    ];
    /// The platform this program runs on. One that FMI does not name has the name of its system, which is no other's.
    pub const HERE: Self = match Self::of(ARCH, OS) {
        Some(platform) => platform,
        None => Self {
            name: OS,
            tuple: OS,
            prefix: DLL_PREFIX,
            suffix: DLL_SUFFIX,
        },
    };

    /// The platform of an architecture and a system, as [`std::env::consts`] names them.
    #[must_use]
    pub const fn of(architecture: &str, system: &str) -> Option<Self> {
        let mut k = 0;
        while k < KNOWN.len() {
            let (known, on, platform) = KNOWN[k];
            if same(known, architecture) && same(on, system) {
                return Some(platform);
            }
            k += 1;
        }
        None
    }

    /// The platform of a name that FMUs are built for from elsewhere, or of this one.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let mut known = [Self::HERE].into_iter().chain(Self::APART);
        known.find(|platform| platform.name == name)
    }

    /// Folders in which importers of FMI 2.0 look for its libraries, in this order: tools for macOS put libraries for
    /// both processors into one file.
    #[must_use]
    pub fn folders_2(&self) -> Vec<&'static str> {
        match self.suffix {
            ".dylib" if self.name != "darwin64" => vec![self.name, "darwin64"],
            _ => vec![self.name],
        }
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

/// Whether two texts are the same, for constants.
const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut k = 0;
    while k < a.len() && k < b.len() && a[k] == b[k] {
        k += 1;
    }
    k == a.len() && k == b.len()
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
        let arm = Platform::named("aarch64-linux").unwrap();
        assert_eq!(Platform::of("aarch64", "linux"), Some(arm));
        assert_eq!(arm.path_2("m"), arm.path_3("m"));
        assert_eq!(Platform::WASM.path_3("m"), "binaries/wasm32-wasip2/m.wasm");
    }

    #[test]
    fn only_x86_has_the_short_names() {
        let paths = |architecture, system| {
            let platform = Platform::of(architecture, system).unwrap();
            (platform.path_2("m"), platform.path_3("m"))
        };
        for (architecture, system, two, three) in [
            ("x86_64", "linux", "linux64/m.so", "x86_64-linux/m.so"),
            ("x86", "linux", "linux32/m.so", "x86-linux/m.so"),
            (
                "aarch64",
                "linux",
                "aarch64-linux/m.so",
                "aarch64-linux/m.so",
            ),
            ("x86_64", "windows", "win64/m.dll", "x86_64-windows/m.dll"),
            ("x86", "windows", "win32/m.dll", "x86-windows/m.dll"),
            (
                "aarch64",
                "windows",
                "aarch64-windows/m.dll",
                "aarch64-windows/m.dll",
            ),
            (
                "x86_64",
                "macos",
                "darwin64/m.dylib",
                "x86_64-darwin/m.dylib",
            ),
            (
                "aarch64",
                "macos",
                "aarch64-darwin/m.dylib",
                "aarch64-darwin/m.dylib",
            ),
        ] {
            let expected = (format!("binaries/{two}"), format!("binaries/{three}"));
            assert_eq!(
                paths(architecture, system),
                expected,
                "{architecture} {system}"
            );
        }
        for (architecture, system) in [("riscv64", "linux"), ("x86_64", "freebsd"), ("x86_6", "")] {
            assert_eq!(Platform::of(architecture, system), None);
        }
        let here = Platform::HERE;
        assert_eq!((here.prefix, here.suffix), (DLL_PREFIX, DLL_SUFFIX));
        assert_eq!(here.folders_2()[0], here.name);
        let mac = Platform::of("aarch64", "macos").unwrap();
        assert_eq!(mac.folders_2(), ["aarch64-darwin", "darwin64"]);
    }
}
