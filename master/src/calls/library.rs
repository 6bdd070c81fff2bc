//! The shared library of a foreign FMU.

use std::env::consts::DLL_SUFFIX;
use std::ffi::{c_char, c_void};
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::error::ImportError;
use crate::open::{Folder, Opened};
use crate::status::RawStatus;

use super::logger;
use super::watch::Watch;

/// An instance, or a saved state of one, as the library knows it.
pub(crate) type Handle = *mut c_void;

/// What happens before the first and after the last function, in the place of their names.
const LOADING: &str = "loading of the library";
const UNLOADING: &str = "unloading of the library";

/// A function of the states of an instance: its name in C, and the function if the library has it.
pub(crate) type Named<F> = (&'static str, Option<F>);

/// The functions that save and restore; of one form in all versions.
pub struct StateCalls {
    pub(crate) save: Named<unsafe extern "C" fn(Handle, *mut Handle) -> RawStatus>,
    pub(crate) restore: Named<unsafe extern "C" fn(Handle, Handle) -> RawStatus>,
    pub(crate) free: Named<unsafe extern "C" fn(Handle, *mut Handle) -> RawStatus>,
    pub(crate) size: Named<unsafe extern "C" fn(Handle, Handle, *mut usize) -> RawStatus>,
    pub(crate) write: Named<unsafe extern "C" fn(Handle, Handle, *mut u8, usize) -> RawStatus>,
    pub(crate) read:
        Named<unsafe extern "C" fn(Handle, *const u8, usize, *mut Handle) -> RawStatus>,
}

/// What the versions of the standard do differently, as far as loading, states and freeing go.
pub trait Interface: Sized {
    /// Name of the function that frees an instance.
    const FREE: &'static str;

    /// What the library keeps a pointer to until the instance is freed.
    type Callbacks: Send + Sync;

    /// Looks the functions up.
    ///
    /// # Errors
    ///
    /// The name of the first one that no simulation can do without and that is missing.
    ///
    /// # Safety
    ///
    /// Symbols must have the types of the standard, and none may be called after `library` is closed.
    unsafe fn resolve(library: &libloading::Library) -> Result<Self, &'static str>;

    /// Whether the library is of this version.
    ///
    /// # Errors
    ///
    /// [`ImportError::Interface`].
    fn check(&self) -> Result<(), ImportError>;

    /// Folders of this platform's libraries; the first that has the library counts.
    fn platforms() -> Vec<&'static str>;

    /// The functions of states.
    fn states(&self) -> StateCalls;

    /// Frees an instance.
    ///
    /// # Safety
    ///
    /// It was made by this library, is not freed, and is not used again.
    unsafe fn free(&self, instance: *mut c_void);
}

/// Declares the table of functions: name in C, field, type. Those that no simulation can do without are
/// `required`; a missing `optional` one is an error only when it is called; one of the `rest` serves steps that return
/// before they are done, derivatives and categories of messages, which this importer never asks for, and is looked up
/// only to tell whether it is there.
macro_rules! functions {
    (
        $(#[$documentation:meta])*
        required { $($required:ident $required_name:literal: $required_type:ty,)* }
        optional { $($optional:ident $optional_name:literal: $optional_type:ty,)* }
        rest { $($rest_name:literal,)* }
    ) => {
        $(#[$documentation])*
        pub struct Functions {
            $(pub(crate) $required: $required_type,)*
            $(pub(crate) $optional: Option<$optional_type>,)*
            /// Names of the optional functions that the library does not have.
            pub(crate) missing: Vec<&'static str>,
        }

        impl Functions {
            /// Looks every function up.
            ///
            /// # Errors
            ///
            /// The name of the first required function that is missing.
            ///
            /// # Safety
            ///
            /// Symbols of these names must have the types that the standard gives them, and no function may be
            /// called after `library` is closed.
            pub(crate) unsafe fn look_up(library: &libloading::Library) -> Result<Self, &'static str> {
                let mut missing = Vec::new();
                $({
                    // SAFETY: the symbol is not used.
                    let symbol = unsafe { library.get::<*const ()>($rest_name) };
                    if symbol.is_err() {
                        missing.push($rest_name);
                    }
                })*
                Ok(Self {
                    $($required: {
                        // SAFETY: the caller vouches for the type.
                        let symbol = unsafe { library.get::<$required_type>($required_name) };
                        *symbol.map_err(|_| $required_name)?
                    },)*
                    $($optional: {
                        // SAFETY: the caller vouches for the type.
                        let symbol = unsafe { library.get::<$optional_type>($optional_name) };
                        if symbol.is_err() {
                            missing.push($optional_name);
                        }
                        symbol.ok().map(|symbol| *symbol)
                    },)*
                    missing,
                })
            }
        }
    };
}
pub(crate) use functions;

/// A loaded library. The folder that it was unpacked to lives at least as long.
pub(crate) struct Library<F> {
    pub(crate) functions: F,
    pub(crate) path: PathBuf,
    /// A call returned `Fatal`: nothing of the library may be called again.
    dead: AtomicBool,
    /// Instances that are not freed.
    living: AtomicUsize,
    /// `None` only while dropped.
    handle: Option<libloading::Library>,
    pub(super) watch: Watch,
    _folder: Arc<Folder>,
}

impl<F> fmt::Debug for Library<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Library")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}

impl<F: Interface> Library<F> {
    /// Loads the library of `fmu` for this system and checks what it says of itself.
    pub(crate) fn load(fmu: &Opened, watch: &Watch) -> Result<Self, ImportError> {
        let name = fmu.description.model_identifier();
        let place = |folder: &&str| format!("binaries/{folder}/{name}{DLL_SUFFIX}");
        let places: Vec<String> = F::platforms().iter().map(place).collect();
        let mut paths = places.iter().map(|place| fmu.folder.path().join(place));
        let Some(path) = paths.find(|path| path.is_file()) else {
            return Err(ImportError::NoBinary {
                path: fmu.path.clone(),
                expected: places.join(" or "),
                found: platforms_in(fmu.folder.path()),
            });
        };
        watch.calling(LOADING);
        // SAFETY: initializers of the library run. They are native code that the user chose to run.
        let handle = match unsafe { open(&path) } {
            Ok(handle) => handle,
            Err(source) => return Err(ImportError::Load { path, source }),
        };
        // SAFETY: the model description says that it is a library of this version; the handle is kept beside the table.
        let functions = match unsafe { F::resolve(&handle) } {
            Ok(functions) => functions,
            Err(function) => return Err(ImportError::MissingFunction { path, function }),
        };
        let library = Self {
            functions,
            path,
            dead: AtomicBool::new(false),
            living: AtomicUsize::new(0),
            handle: Some(handle),
            watch: watch.clone(),
            _folder: Arc::clone(&fmu.folder),
        };
        library.functions.check()?;
        Ok(library)
    }
}

impl<F> Library<F> {
    /// An optional function, or the error that names it.
    pub(crate) fn optional<C>(
        &self,
        name: &'static str,
        function: Option<C>,
    ) -> Result<C, ImportError> {
        function.ok_or_else(|| ImportError::MissingFunction {
            path: self.path.clone(),
            function: name,
        })
    }

    /// Reserves the place of an instance; `false` if there is one and only one is allowed.
    pub(crate) fn enter(&self, only_one: bool) -> bool {
        let update = |living| (!only_one || living == 0).then_some(living + 1);
        self.living
            .fetch_update(Ordering::AcqRel, Ordering::Acquire, update)
            .is_ok()
    }

    pub(crate) fn leave(&self) {
        self.living.fetch_sub(1, Ordering::AcqRel);
    }

    pub(crate) fn is_dead(&self) -> bool {
        self.dead.load(Ordering::Acquire)
    }

    pub(crate) fn kill(&self) {
        self.dead.store(true, Ordering::Release);
    }
}

impl<F> Drop for Library<F> {
    fn drop(&mut self) {
        // After `Fatal` instances were not freed and may have threads in the library: it must stay.
        if self.is_dead() {
            std::mem::forget(self.handle.take());
        }
        self.watch.calling(UNLOADING);
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

/// Checks one of the functions that tell what the library is.
pub(crate) fn expect(
    function: &'static str,
    ask: unsafe extern "C" fn() -> *const c_char,
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
