//! The shared library as an importer sees it: symbols of a `.so`, raw pointers, a logger.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::{Path, PathBuf};
use std::ptr::{null, null_mut};
use std::sync::Mutex;

use libloading::Library;
use sphere_dda_export::find_library;

pub(crate) const OK: c_int = 0;
pub(crate) const WARNING: c_int = 1;
pub(crate) const DISCARD: c_int = 2;
pub(crate) const ERROR: c_int = 3;

/// An `fmi2Component` or `fmi2FMUstate`.
pub(crate) type Handle = *mut c_void;

#[repr(C)]
struct Callbacks {
    logger: Option<extern "C" fn(Handle, *const c_char, c_int, *const c_char, *const c_char)>,
    unused: [usize; 3],
    environment: *const Mutex<Vec<String>>,
}

extern "C" fn logger(
    log: Handle,
    _name: *const c_char,
    status: c_int,
    category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: the environment is the log of the instance, which outlives it; the texts end with NUL.
    let (log, category, message) = unsafe {
        (
            &*log.cast::<Mutex<Vec<String>>>(),
            CStr::from_ptr(category),
            CStr::from_ptr(message),
        )
    };
    let line = format!(
        "{status} {} {}",
        category.to_str().unwrap(),
        message.to_str().unwrap()
    );
    log.lock().unwrap().push(line);
}

macro_rules! functions {
    ($($name:ident: fn($($argument:ty),*) $(-> $result:ty)?;)*) => {
        /// Every function the standard asks of a co-simulation FMU, by its own name.
        #[allow(non_snake_case)]
        pub(crate) struct Functions { $(pub(crate) $name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)* }

        impl Functions {
            fn of(library: &Library) -> Self {
                // SAFETY: the types are those of the standard.
                Self { $($name: *unsafe { library.get(stringify!($name)) }.expect(stringify!($name)),)* }
            }
        }

        /// Their names.
        pub(crate) const NAMES: &[&str] = &[$(stringify!($name)),*];
    };
}

functions! {
    fmi2GetTypesPlatform: fn() -> *const c_char;
    fmi2GetVersion: fn() -> *const c_char;
    fmi2SetDebugLogging: fn(Handle, c_int, usize, *const *const c_char) -> c_int;
    fmi2Instantiate: fn(*const c_char, c_int, *const c_char, *const c_char, *const c_void, c_int, c_int) -> Handle;
    fmi2FreeInstance: fn(Handle);
    fmi2SetupExperiment: fn(Handle, c_int, f64, f64, c_int, f64) -> c_int;
    fmi2EnterInitializationMode: fn(Handle) -> c_int;
    fmi2ExitInitializationMode: fn(Handle) -> c_int;
    fmi2Terminate: fn(Handle) -> c_int;
    fmi2Reset: fn(Handle) -> c_int;
    fmi2GetReal: fn(Handle, *const u32, usize, *mut f64) -> c_int;
    fmi2GetInteger: fn(Handle, *const u32, usize, *mut c_int) -> c_int;
    fmi2GetBoolean: fn(Handle, *const u32, usize, *mut c_int) -> c_int;
    fmi2GetString: fn(Handle, *const u32, usize, *mut *const c_char) -> c_int;
    fmi2SetReal: fn(Handle, *const u32, usize, *const f64) -> c_int;
    fmi2SetInteger: fn(Handle, *const u32, usize, *const c_int) -> c_int;
    fmi2SetBoolean: fn(Handle, *const u32, usize, *const c_int) -> c_int;
    fmi2SetString: fn(Handle, *const u32, usize, *const *const c_char) -> c_int;
    fmi2GetFMUstate: fn(Handle, *mut Handle) -> c_int;
    fmi2SetFMUstate: fn(Handle, Handle) -> c_int;
    fmi2FreeFMUstate: fn(Handle, *mut Handle) -> c_int;
    fmi2SerializedFMUstateSize: fn(Handle, Handle, *mut usize) -> c_int;
    fmi2SerializeFMUstate: fn(Handle, Handle, *mut c_char, usize) -> c_int;
    fmi2DeSerializeFMUstate: fn(Handle, *const c_char, usize, *mut Handle) -> c_int;
    fmi2GetDirectionalDerivative: fn(Handle, *const u32, usize, *const u32, usize, *const f64, *mut f64) -> c_int;
    fmi2SetRealInputDerivatives: fn(Handle, *const u32, usize, *const c_int, *const f64) -> c_int;
    fmi2GetRealOutputDerivatives: fn(Handle, *const u32, usize, *const c_int, *mut f64) -> c_int;
    fmi2DoStep: fn(Handle, f64, f64, c_int) -> c_int;
    fmi2CancelStep: fn(Handle) -> c_int;
    fmi2GetStatus: fn(Handle, c_int, *mut c_int) -> c_int;
    fmi2GetRealStatus: fn(Handle, c_int, *mut f64) -> c_int;
    fmi2GetIntegerStatus: fn(Handle, c_int, *mut c_int) -> c_int;
    fmi2GetBooleanStatus: fn(Handle, c_int, *mut c_int) -> c_int;
    fmi2GetStringStatus: fn(Handle, c_int, *mut *const c_char) -> c_int;
}

/// The loaded library.
pub(crate) struct Fmi {
    pub(crate) f: Functions,
    _library: Library,
}

impl Fmi {
    pub(crate) fn load() -> Self {
        let path: PathBuf = find_library(None).unwrap();
        // SAFETY: a library of this project.
        let library = unsafe { Library::new(path) }.unwrap();
        Self {
            f: Functions::of(&library),
            _library: library,
        }
    }

    /// `fmi2Instantiate` of a co-simulation instance; a null handle if it is refused.
    pub(crate) fn instantiate<'a>(
        &'a self,
        name: &str,
        guid: &str,
        resources: &Path,
    ) -> Instance<'a> {
        self.instantiate_as(1, name, guid, &format!("file://{}", resources.display()))
    }

    pub(crate) fn instantiate_as<'a>(
        &'a self,
        kind: c_int,
        name: &str,
        guid: &str,
        uri: &str,
    ) -> Instance<'a> {
        let log = Box::new(Mutex::new(Vec::new()));
        let text = |t: &str| CString::new(t).unwrap();
        let (name, guid, uri) = (text(name), text(guid), text(uri));
        let callbacks = Callbacks {
            logger: Some(logger),
            unused: [0; 3],
            environment: &raw const *log,
        };
        let functions = (&raw const callbacks).cast();
        // SAFETY: all pointers are valid through the call; the log lives as long as the instance.
        let handle = unsafe {
            (self.f.fmi2Instantiate)(
                name.as_ptr(),
                kind,
                guid.as_ptr(),
                uri.as_ptr(),
                functions,
                0,
                0,
            )
        };
        Instance {
            fmi: self,
            handle,
            log,
        }
    }
}

/// An instance with its log.
pub(crate) struct Instance<'a> {
    fmi: &'a Fmi,
    pub(crate) handle: Handle,
    log: Box<Mutex<Vec<String>>>,
}

impl Drop for Instance<'_> {
    fn drop(&mut self) {
        // SAFETY: the handle came from fmi2Instantiate, or is null.
        unsafe { (self.fmi.f.fmi2FreeInstance)(self.handle) };
    }
}

/// Safe calls with slices; the tests of null pointers use [`Functions`] themselves.
impl Instance<'_> {
    pub(crate) fn f(&self) -> &Functions {
        &self.fmi.f
    }

    /// The log lines since the last call.
    pub(crate) fn log(&self) -> Vec<String> {
        std::mem::take(&mut *self.log.lock().unwrap())
    }

    pub(crate) fn set_up(&self, start: f64, stop: Option<f64>) -> c_int {
        let defined = c_int::from(stop.is_some());
        // SAFETY: no pointers but the handle.
        unsafe {
            (self.f().fmi2SetupExperiment)(self.handle, 0, 0.0, start, defined, stop.unwrap_or(0.0))
        }
    }

    pub(crate) fn enter(&self) -> c_int {
        // SAFETY: as above.
        unsafe { (self.f().fmi2EnterInitializationMode)(self.handle) }
    }

    pub(crate) fn exit(&self) -> c_int {
        // SAFETY: as above.
        unsafe { (self.f().fmi2ExitInitializationMode)(self.handle) }
    }

    pub(crate) fn initialize(&self) {
        assert_eq!(
            [self.set_up(0.0, None), self.enter(), self.exit()],
            [OK; 3],
            "{:?}",
            self.log()
        );
    }

    pub(crate) fn step(&self, point: f64, h: f64) -> c_int {
        // SAFETY: as above.
        unsafe { (self.f().fmi2DoStep)(self.handle, point, h, 0) }
    }

    pub(crate) fn terminate(&self) -> c_int {
        // SAFETY: as above.
        unsafe { (self.f().fmi2Terminate)(self.handle) }
    }

    pub(crate) fn reset(&self) -> c_int {
        // SAFETY: as above.
        unsafe { (self.f().fmi2Reset)(self.handle) }
    }

    pub(crate) fn get(&self, references: &[u32], values: &mut [f64]) -> c_int {
        // SAFETY: slices of the length that is passed.
        unsafe {
            (self.f().fmi2GetReal)(
                self.handle,
                references.as_ptr(),
                references.len(),
                values.as_mut_ptr(),
            )
        }
    }

    pub(crate) fn integer(&self, reference: u32) -> i32 {
        let mut value = -1;
        // SAFETY: one reference, room for one value.
        let status = unsafe {
            (self.f().fmi2GetInteger)(self.handle, &raw const reference, 1, &raw mut value)
        };
        assert_eq!(status, OK, "{:?}", self.log());
        value
    }

    pub(crate) fn real(&self, reference: u32) -> f64 {
        let mut value = [f64::NAN];
        assert_eq!(self.get(&[reference], &mut value), OK, "{:?}", self.log());
        value[0]
    }

    pub(crate) fn set(&self, reference: u32, value: f64) -> c_int {
        // SAFETY: one reference, one value.
        unsafe { (self.f().fmi2SetReal)(self.handle, &raw const reference, 1, &raw const value) }
    }

    pub(crate) fn set_string(&self, reference: u32, value: &str) -> c_int {
        let value = CString::new(value).unwrap();
        let pointer = value.as_ptr();
        // SAFETY: one reference, one text.
        unsafe {
            (self.f().fmi2SetString)(self.handle, &raw const reference, 1, &raw const pointer)
        }
    }

    pub(crate) fn set_boolean(&self, reference: u32, value: bool) -> c_int {
        let value = c_int::from(value);
        // SAFETY: one reference, one value.
        unsafe { (self.f().fmi2SetBoolean)(self.handle, &raw const reference, 1, &raw const value) }
    }

    pub(crate) fn string(&self, reference: u32) -> String {
        let mut value = null();
        // SAFETY: one reference, one place; the text is copied at once.
        unsafe {
            assert_eq!(
                (self.f().fmi2GetString)(self.handle, &raw const reference, 1, &raw mut value),
                OK
            );
            CStr::from_ptr(value).to_str().unwrap().to_owned()
        }
    }

    pub(crate) fn state(&self) -> Handle {
        let mut state = null_mut();
        assert_eq!(
            // SAFETY: the place is valid.
            unsafe { (self.f().fmi2GetFMUstate)(self.handle, &raw mut state) },
            OK
        );
        state
    }

    pub(crate) fn restore(&self, state: Handle) -> c_int {
        // SAFETY: a state of this library, or null.
        unsafe { (self.f().fmi2SetFMUstate)(self.handle, state) }
    }

    pub(crate) fn free(&self, mut state: Handle) {
        assert_eq!(
            // SAFETY: a state of this library, not used again.
            unsafe { (self.f().fmi2FreeFMUstate)(self.handle, &raw mut state) },
            OK
        );
        assert!(state.is_null());
    }

    /// The serialized state of now.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let state = self.state();
        let bytes = self.serialized(state);
        self.free(state);
        bytes
    }

    /// A saved state as bytes.
    pub(crate) fn serialized(&self, state: Handle) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: the places are valid, the buffer has the length that is passed.
        unsafe {
            assert_eq!(
                (self.f().fmi2SerializedFMUstateSize)(self.handle, state, &raw mut size),
                OK
            );
            let mut bytes = vec![0_u8; size];
            assert_eq!(
                (self.f().fmi2SerializeFMUstate)(
                    self.handle,
                    state,
                    bytes.as_mut_ptr().cast(),
                    size
                ),
                OK
            );
            bytes
        }
    }

    /// Deserializes and restores.
    pub(crate) fn load(&self, bytes: &[u8]) -> c_int {
        let mut state = null_mut();
        // SAFETY: a slice of the length that is passed, a valid place.
        let status = unsafe {
            (self.f().fmi2DeSerializeFMUstate)(
                self.handle,
                bytes.as_ptr().cast(),
                bytes.len(),
                &raw mut state,
            )
        };
        if status != OK {
            assert!(state.is_null());
            return status;
        }
        let status = self.restore(state);
        self.free(state);
        status
    }

    pub(crate) fn last_time(&self) -> f64 {
        let mut value = f64::NAN;
        assert_eq!(
            // SAFETY: a valid place.
            unsafe { (self.f().fmi2GetRealStatus)(self.handle, 2, &raw mut value) },
            OK
        );
        value
    }

    pub(crate) fn terminated(&self) -> bool {
        let mut value = -1;
        assert_eq!(
            // SAFETY: a valid place.
            unsafe { (self.f().fmi2GetBooleanStatus)(self.handle, 3, &raw mut value) },
            OK
        );
        value == 1
    }
}
