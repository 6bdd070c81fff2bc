//! The shared library of a foreign FMU.

use std::env::consts::{ARCH, DLL_SUFFIX, OS};
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use tempfile::TempDir;

use super::abi::{Functions, Text};
use super::{Fmu, ImportError, logger};

/// A loaded library. The folder that it was unpacked to lives at least as long.
pub(super) struct Library {
    pub(super) functions: Functions,
    pub(super) path: PathBuf,
    /// A call returned `Fatal`: nothing of the library may be called again.
    dead: AtomicBool,
    /// Instances that are not freed.
    living: AtomicUsize,
    /// `None` only while dropped.
    handle: Option<libloading::Library>,
    _folder: Arc<TempDir>,
}

impl fmt::Debug for Library {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Library")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}

impl Library {
    /// Loads the library of `fmu` for this system and checks what it says of itself.
    pub(super) fn load(fmu: &Fmu) -> Result<Self, ImportError> {
        let relative = format!(
            "binaries/{}/{}{DLL_SUFFIX}",
            platform(),
            fmu.co_simulation.model_identifier
        );
        let path = fmu.folder().join(&relative);
        if !path.is_file() {
            return Err(ImportError::NoBinary {
                path: fmu.path.clone(),
                expected: relative,
                found: platforms_in(fmu.folder()),
            });
        }
        // SAFETY: initializers of the library run. They are native code that the user chose to run.
        let handle = match unsafe { open(&path) } {
            Ok(handle) => handle,
            Err(source) => return Err(ImportError::Load { path, source }),
        };
        // SAFETY: the model description says that it is a library of FMI 2.0; the handle is kept beside the table.
        let functions = match unsafe { Functions::resolve(&handle) } {
            Ok(functions) => functions,
            Err(function) => return Err(ImportError::MissingFunction { path, function }),
        };
        let library = Self {
            functions,
            path,
            dead: AtomicBool::new(false),
            living: AtomicUsize::new(0),
            handle: Some(handle),
            _folder: Arc::clone(&fmu.folder),
        };
        let Functions {
            get_version,
            get_types_platform,
            ..
        } = library.functions;
        expect("fmi2GetVersion", get_version, "2.0")?;
        expect("fmi2GetTypesPlatform", get_types_platform, "default")?;
        Ok(library)
    }

    /// An optional function, or the error that names it.
    pub(super) fn optional<F>(
        &self,
        name: &'static str,
        function: Option<F>,
    ) -> Result<F, ImportError> {
        function.ok_or_else(|| ImportError::MissingFunction {
            path: self.path.clone(),
            function: name,
        })
    }

    /// Reserves the place of an instance; `false` if there is one and only one is allowed.
    pub(super) fn enter(&self, only_one: bool) -> bool {
        let update = |living| (!only_one || living == 0).then_some(living + 1);
        self.living
            .fetch_update(Ordering::AcqRel, Ordering::Acquire, update)
            .is_ok()
    }

    pub(super) fn leave(&self) {
        self.living.fetch_sub(1, Ordering::AcqRel);
    }

    pub(super) fn is_dead(&self) -> bool {
        self.dead.load(Ordering::Acquire)
    }

    pub(super) fn kill(&self) {
        self.dead.store(true, Ordering::Release);
    }
}

impl Drop for Library {
    fn drop(&mut self) {
        // After `Fatal` instances were not freed and may have threads in the library: it must stay.
        if self.is_dead() {
            std::mem::forget(self.handle.take());
        }
    }
}

/// Opens a library with all its symbols resolved now, so that a missing one is an error here, not a crash later.
///
/// # Safety
///
/// As [`libloading::Library::new`].
unsafe fn open(path: &Path) -> Result<libloading::Library, libloading::Error> {
    #[cfg(unix)]
    {
        use libloading::os::unix::{Library, RTLD_LOCAL, RTLD_NOW};
        // SAFETY: passed on to the caller.
        unsafe { Library::open(Some(path), RTLD_NOW | RTLD_LOCAL) }.map(Into::into)
    }
    #[cfg(not(unix))]
    {
        // SAFETY: passed on to the caller.
        unsafe { libloading::Library::new(path) }
    }
}

/// Checks one of the two functions that tell what the library is.
fn expect(
    function: &'static str,
    ask: unsafe extern "C" fn() -> Text,
    expected: &'static str,
) -> Result<(), ImportError> {
    // SAFETY: takes nothing and may be called at any time.
    let answer = unsafe { ask() };
    // SAFETY: a constant text of the library.
    let found = unsafe { logger::text(answer) };
    if found == expected {
        return Ok(());
    }
    Err(ImportError::Interface {
        function,
        found,
        expected,
    })
}

/// Name of this platform in FMI 2.0.
fn platform() -> String {
    let system = match OS {
        "windows" => "win",
        "macos" => "darwin",
        other => other,
    };
    match ARCH {
        "x86_64" => format!("{system}64"),
        "x86" => format!("{system}32"),
        // FMI 2.0 has no name for it; macOS has universal libraries in `darwin64`.
        _ if OS == "macos" => "darwin64".to_owned(),
        other => format!("{other}-{system}"),
    }
}

/// The platforms that `folder` has binaries for, sorted; "none" if there are none.
fn platforms_in(folder: &Path) -> String {
    let Ok(entries) = fs::read_dir(folder.join("binaries")) else {
        return "none".to_owned();
    };
    let mut names: Vec<String> = entries
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    if names.is_empty() {
        return "none".to_owned();
    }
    names.join(", ")
}
