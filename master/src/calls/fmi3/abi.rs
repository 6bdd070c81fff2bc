//! The C interface of FMI 3.0 as an importer of co-simulation sees it: the functions that the master calls.

use std::ffi::{c_char, c_void};

use crate::calls::library::{Handle, StateCalls, functions};
use crate::status::RawStatus;

pub(crate) type Text = *const c_char;
pub(crate) type Boolean = u8;
pub(crate) type Get<T> =
    unsafe extern "C" fn(Handle, *const u32, usize, *mut T, usize) -> RawStatus;
pub(crate) type Set<T> =
    unsafe extern "C" fn(Handle, *const u32, usize, *const T, usize) -> RawStatus;
pub(crate) type Plain = unsafe extern "C" fn(Handle) -> RawStatus;
pub(crate) type Logger = unsafe extern "C" fn(*mut c_void, RawStatus, Text, Text);

functions! {
    /// The functions of FMI 3.0 for co-simulation.
    required {
        get_version "fmi3GetVersion": unsafe extern "C" fn() -> Text,
        instantiate "fmi3InstantiateCoSimulation": unsafe extern "C" fn(
            Text, Text, Text, Boolean, Boolean, Boolean, Boolean, *const u32, usize, *mut c_void, Logger,
            Option<unsafe extern "C" fn()>,
        ) -> Handle,
        free_instance "fmi3FreeInstance": unsafe extern "C" fn(Handle),
        enter_initialization_mode "fmi3EnterInitializationMode":
            unsafe extern "C" fn(Handle, Boolean, f64, f64, Boolean, f64) -> RawStatus,
        exit_initialization_mode "fmi3ExitInitializationMode": Plain,
        terminate "fmi3Terminate": Plain,
        do_step "fmi3DoStep": unsafe extern "C" fn(
            Handle, f64, f64, Boolean, *mut Boolean, *mut Boolean, *mut Boolean, *mut f64,
        ) -> RawStatus,
    }
    optional {
        enter_event_mode "fmi3EnterEventMode": Plain,
        update_discrete_states "fmi3UpdateDiscreteStates": unsafe extern "C" fn(
            Handle, *mut Boolean, *mut Boolean, *mut Boolean, *mut Boolean, *mut Boolean, *mut f64,
        ) -> RawStatus,
        enter_step_mode "fmi3EnterStepMode": Plain,
        get_float64 "fmi3GetFloat64": Get<f64>,
        get_float32 "fmi3GetFloat32": Get<f32>,
        get_int8 "fmi3GetInt8": Get<i8>,
        get_uint8 "fmi3GetUInt8": Get<u8>,
        get_int16 "fmi3GetInt16": Get<i16>,
        get_uint16 "fmi3GetUInt16": Get<u16>,
        get_int32 "fmi3GetInt32": Get<i32>,
        get_uint32 "fmi3GetUInt32": Get<u32>,
        get_int64 "fmi3GetInt64": Get<i64>,
        get_uint64 "fmi3GetUInt64": Get<u64>,
        get_boolean "fmi3GetBoolean": Get<Boolean>,
        get_string "fmi3GetString": Get<Text>,
        get_binary "fmi3GetBinary":
            unsafe extern "C" fn(Handle, *const u32, usize, *mut usize, *mut *const u8, usize) -> RawStatus,
        set_float64 "fmi3SetFloat64": Set<f64>,
        set_float32 "fmi3SetFloat32": Set<f32>,
        set_int8 "fmi3SetInt8": Set<i8>,
        set_uint8 "fmi3SetUInt8": Set<u8>,
        set_int16 "fmi3SetInt16": Set<i16>,
        set_uint16 "fmi3SetUInt16": Set<u16>,
        set_int32 "fmi3SetInt32": Set<i32>,
        set_uint32 "fmi3SetUInt32": Set<u32>,
        set_int64 "fmi3SetInt64": Set<i64>,
        set_uint64 "fmi3SetUInt64": Set<u64>,
        set_boolean "fmi3SetBoolean": Set<Boolean>,
        set_string "fmi3SetString": Set<Text>,
        set_binary "fmi3SetBinary":
            unsafe extern "C" fn(Handle, *const u32, usize, *const usize, *const *const u8, usize) -> RawStatus,
        get_state "fmi3GetFMUState": unsafe extern "C" fn(Handle, *mut Handle) -> RawStatus,
        set_state "fmi3SetFMUState": unsafe extern "C" fn(Handle, Handle) -> RawStatus,
        free_state "fmi3FreeFMUState": unsafe extern "C" fn(Handle, *mut Handle) -> RawStatus,
        serialized_state_size "fmi3SerializedFMUStateSize":
            unsafe extern "C" fn(Handle, Handle, *mut usize) -> RawStatus,
        serialize_state "fmi3SerializeFMUState":
            unsafe extern "C" fn(Handle, Handle, *mut u8, usize) -> RawStatus,
        deserialize_state "fmi3DeserializeFMUState":
            unsafe extern "C" fn(Handle, *const u8, usize, *mut Handle) -> RawStatus,
    }
    rest {}
}

impl Functions {
    pub(crate) fn state_calls(&self) -> StateCalls {
        StateCalls {
            save: ("fmi3GetFMUState", self.get_state),
            restore: ("fmi3SetFMUState", self.set_state),
            free: ("fmi3FreeFMUState", self.free_state),
            size: ("fmi3SerializedFMUStateSize", self.serialized_state_size),
            write: ("fmi3SerializeFMUState", self.serialize_state),
            read: ("fmi3DeserializeFMUState", self.deserialize_state),
        }
    }
}
