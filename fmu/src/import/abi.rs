//! The C interface of FMI 2.0 as an importer sees it.
//!
//! Types follow `fmi2TypesPlatform.h` ("default") and `fmi2FunctionTypes.h`. Enumerations cross the border
//! as integers: a foreign library may return a number that no enumeration has.

use std::ffi::{c_char, c_int, c_void};

pub(super) use sphere_dda_fmi_interface::abi2::{
    FMI2_CO_SIMULATION as CO_SIMULATION, FMI2_LAST_SUCCESSFUL_TIME as LAST_SUCCESSFUL_TIME,
    FMI2_TERMINATED as TERMINATED, fmi2Boolean as Boolean, fmi2Component as Component,
    fmi2FMUstate as FmuState, fmi2String as Text, fmi2ValueReference as ValueReference,
};

/// `fmi2Status` as it arrives: perhaps none of the enumeration.
pub(super) type RawStatus = c_int;

/// `fmi2CallbackLogger`, with one argument in place of the variable ones: see [`super::logger`].
pub(super) type Logger =
    unsafe extern "C" fn(*mut c_void, Text, RawStatus, Text, Text, *const c_void);

/// `fmi2CallbackFunctions`. The library keeps a pointer to it until the instance is freed.
#[repr(C)]
pub(super) struct Callbacks {
    pub(super) logger: Logger,
    pub(super) allocate_memory: unsafe extern "C" fn(usize, usize) -> *mut c_void,
    pub(super) free_memory: unsafe extern "C" fn(*mut c_void),
    /// NULL: every step must be done when `fmi2DoStep` returns.
    pub(super) step_finished: Option<unsafe extern "C" fn(*mut c_void, RawStatus)>,
    pub(super) component_environment: *mut c_void,
}

// SAFETY: nothing of it ever changes, and the environment is a `Log`, which threads may share.
unsafe impl Send for Callbacks {}
// SAFETY: as above.
unsafe impl Sync for Callbacks {}

pub(super) type Get<T> =
    unsafe extern "C" fn(Component, *const ValueReference, usize, *mut T) -> RawStatus;
pub(super) type Set<T> =
    unsafe extern "C" fn(Component, *const ValueReference, usize, *const T) -> RawStatus;
pub(super) type Derivatives<P> =
    unsafe extern "C" fn(Component, *const ValueReference, usize, *const c_int, P) -> RawStatus;
pub(super) type Query<T> = unsafe extern "C" fn(Component, c_int, *mut T) -> RawStatus;
pub(super) type Plain = unsafe extern "C" fn(Component) -> RawStatus;

/// Declares the table of functions: name in C, field, type. Those that no simulation can do without are
/// `required`; a missing `optional` one is an error only when it is called; one of the `rest` serves steps that return
/// before they are done, which this importer never asks for, and is looked up only to tell whether it is there.
macro_rules! functions {
    (
        required { $($required:ident $required_name:literal: $required_type:ty,)* }
        optional { $($optional:ident $optional_name:literal: $optional_type:ty,)* }
        rest { $($rest_name:literal: $rest_type:ty,)* }
    ) => {
        /// The 34 functions of FMI 2.0 for co-simulation.
        pub(super) struct Functions {
            $(pub(super) $required: $required_type,)*
            $(pub(super) $optional: Option<$optional_type>,)*
            /// Names of the optional functions that the library does not have.
            pub(super) missing: Vec<&'static str>,
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
            /// Symbols of these names must have the types that FMI 2.0 gives them, and no function may be
            /// called after `library` is closed.
            pub(super) unsafe fn resolve(library: &libloading::Library) -> Result<Self, &'static str> {
                let mut missing = Vec::new();
                $({
                    // SAFETY: the caller vouches for the type.
                    let symbol = unsafe { library.get::<$rest_type>($rest_name) };
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

functions! {
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
        set_debug_logging "fmi2SetDebugLogging":
            unsafe extern "C" fn(Component, Boolean, usize, *const Text) -> RawStatus,
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
            unsafe extern "C" fn(Component, FmuState, *mut c_char, usize) -> RawStatus,
        deserialize_fmu_state "fmi2DeSerializeFMUstate":
            unsafe extern "C" fn(Component, *const c_char, usize, *mut FmuState) -> RawStatus,
        get_directional_derivative "fmi2GetDirectionalDerivative": unsafe extern "C" fn(
            Component, *const ValueReference, usize, *const ValueReference, usize, *const f64, *mut f64,
        ) -> RawStatus,
        set_real_input_derivatives "fmi2SetRealInputDerivatives": Derivatives<*const f64>,
        get_real_output_derivatives "fmi2GetRealOutputDerivatives": Derivatives<*mut f64>,
        get_real_status "fmi2GetRealStatus": Query<f64>,
        get_boolean_status "fmi2GetBooleanStatus": Query<Boolean>,
    }
    rest {
        "fmi2CancelStep": Plain,
        "fmi2GetStatus": Query<RawStatus>,
        "fmi2GetIntegerStatus": Query<c_int>,
        "fmi2GetStringStatus": Query<Text>,
    }
}
