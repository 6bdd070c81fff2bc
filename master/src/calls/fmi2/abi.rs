//! The C interface of FMI 2.0 as an importer sees it.
//!
//! Types follow `fmi2TypesPlatform.h` ("default") and `fmi2FunctionTypes.h`. Enumerations cross the border
//! as integers: a foreign library may return a number that no enumeration has.

use std::ffi::{c_int, c_void};

use crate::calls::library::{StateCalls, functions};
use crate::status::RawStatus;

pub(crate) use sphere_dda_fmi_interface::abi2::{
    FMI2_CO_SIMULATION as CO_SIMULATION, FMI2_LAST_SUCCESSFUL_TIME as LAST_SUCCESSFUL_TIME,
    FMI2_TERMINATED as TERMINATED, fmi2Boolean as Boolean, fmi2Component as Component,
    fmi2FMUstate as FmuState, fmi2String as Text, fmi2ValueReference as ValueReference,
};

/// `fmi2CallbackLogger`, with one argument in place of the variable ones: see `calls/logger.rs`.
pub(crate) type Logger =
    unsafe extern "C" fn(*mut c_void, Text, RawStatus, Text, Text, *const c_void);

/// `fmi2CallbackFunctions`. The library keeps a pointer to it until the instance is freed.
#[repr(C)]
pub struct Callbacks {
    pub(crate) logger: Logger,
    pub(crate) allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub(crate) free_memory: unsafe extern "C" fn(*mut c_void),
    /// NULL: every step must be done when `fmi2DoStep` returns.
    pub(crate) step_finished: Option<unsafe extern "C" fn(*mut c_void, RawStatus)>,
    pub(crate) component_environment: *mut c_void,
}

// SAFETY: nothing of it ever changes, and the environment is a `Log`, which threads may share.
unsafe impl Send for Callbacks {}
// SAFETY: as above.
unsafe impl Sync for Callbacks {}

pub(crate) type Get<T> =
    unsafe extern "C" fn(Component, *const ValueReference, usize, *mut T) -> RawStatus;
pub(crate) type Set<T> =
    unsafe extern "C" fn(Component, *const ValueReference, usize, *const T) -> RawStatus;
pub(crate) type Query<T> = unsafe extern "C" fn(Component, c_int, *mut T) -> RawStatus;
pub(crate) type Plain = unsafe extern "C" fn(Component) -> RawStatus;

functions! {
    /// The 34 functions of FMI 2.0 for co-simulation.
    required {
        get_types_platform "fmi2GetTypesPlatform": unsafe extern "C" fn() -> Text,
        get_version "fmi2GetVersion": unsafe extern "C" fn() -> Text,
        instantiate "fmi2Instantiate":
            unsafe extern "C" fn(Text, c_int, Text, Text, *const Callbacks, Boolean, Boolean) -> Component,
        free_instance "fmi2FreeInstance": unsafe extern "C" fn(Component),
        setup_experiment "fmi2SetupExperiment":
            unsafe extern "C" fn(Component, Boolean, f64, f64, Boolean, f64) -> RawStatus,
        enter_initialization_mode "fmi2EnterInitializationMode": Plain,
        exit_initialization_mode "fmi2ExitInitializationMode": Plain,
        terminate "fmi2Terminate": Plain,
        do_step "fmi2DoStep": unsafe extern "C" fn(Component, f64, f64, Boolean) -> RawStatus,
    }
    optional {
        reset "fmi2Reset": Plain,
        get_real "fmi2GetReal": Get<f64>,
        get_integer "fmi2GetInteger": Get<c_int>,
        get_boolean "fmi2GetBoolean": Get<Boolean>,
        get_string "fmi2GetString": Get<Text>,
        set_real "fmi2SetReal": Set<f64>,
        set_integer "fmi2SetInteger": Set<c_int>,
        set_boolean "fmi2SetBoolean": Set<Boolean>,
        set_string "fmi2SetString": Set<Text>,
        get_fmu_state "fmi2GetFMUstate": unsafe extern "C" fn(Component, *mut FmuState) -> RawStatus,
        set_fmu_state "fmi2SetFMUstate": unsafe extern "C" fn(Component, FmuState) -> RawStatus,
        free_fmu_state "fmi2FreeFMUstate": unsafe extern "C" fn(Component, *mut FmuState) -> RawStatus,
        serialized_fmu_state_size "fmi2SerializedFMUstateSize":
            unsafe extern "C" fn(Component, FmuState, *mut usize) -> RawStatus,
        serialize_fmu_state "fmi2SerializeFMUstate":
            unsafe extern "C" fn(Component, FmuState, *mut u8, usize) -> RawStatus,
        deserialize_fmu_state "fmi2DeSerializeFMUstate":
            unsafe extern "C" fn(Component, *const u8, usize, *mut FmuState) -> RawStatus,
        get_real_status "fmi2GetRealStatus": Query<f64>,
        get_boolean_status "fmi2GetBooleanStatus": Query<Boolean>,
    }
    rest {
        "fmi2SetDebugLogging",
        "fmi2GetDirectionalDerivative",
        "fmi2SetRealInputDerivatives",
        "fmi2GetRealOutputDerivatives",
        "fmi2CancelStep",
        "fmi2GetStatus",
        "fmi2GetIntegerStatus",
        "fmi2GetStringStatus",
    }
}

impl Functions {
    pub(crate) fn state_calls(&self) -> StateCalls {
        StateCalls {
            save: ("fmi2GetFMUstate", self.get_fmu_state),
            restore: ("fmi2SetFMUstate", self.set_fmu_state),
            free: ("fmi2FreeFMUstate", self.free_fmu_state),
            size: ("fmi2SerializedFMUstateSize", self.serialized_fmu_state_size),
            write: ("fmi2SerializeFMUstate", self.serialize_fmu_state),
            read: ("fmi2DeSerializeFMUstate", self.deserialize_fmu_state),
        }
    }
}
