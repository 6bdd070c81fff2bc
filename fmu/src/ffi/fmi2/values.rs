//! Getting and setting values.

use sphere_dda_fmi_interface::abi2::*;
use sphere_dda_model_description::value::{ScalarType, Value};

use super::super::guard::{ANY, Stages};
use super::super::values::Function;
use super::SETTABLE;
use crate::version::Version;

fn function(
    component: fmi2Component,
    name: &'static str,
    allowed: Stages,
    scalar: ScalarType,
) -> Function {
    Function {
        component,
        name,
        allowed,
        version: Version::Two,
        scalar,
    }
}

/// A getter and a setter: their names, type in C, type of the variables, and the two conversions.
macro_rules! numbers {
    ($($get:ident $set:ident $type:ty, $scalar:ident, $out:expr, $in:expr;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $get(
            c: fmi2Component,
            vr: *const fmi2ValueReference,
            nvr: usize,
            value: *mut $type,
        ) -> fmi2Status {
            let get = function(c, stringify!($get), ANY, ScalarType::$scalar);
            get.get((vr, nvr), (value, nvr), $out)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $set(
            c: fmi2Component,
            vr: *const fmi2ValueReference,
            nvr: usize,
            value: *const $type,
        ) -> fmi2Status {
            let set = function(c, stringify!($set), SETTABLE, ScalarType::$scalar);
            set.set((vr, nvr), (value, nvr), $in)
        }
    )*};
}

numbers! {
    fmi2GetReal fmi2SetReal fmi2Real, Float64,
        |value| match value { Value::Real(value) => Some(value), _ => None },
        |value| Ok(Value::Real(value));
    fmi2GetInteger fmi2SetInteger fmi2Integer, Int32,
        |value| match value { Value::Integer(value) => fmi2Integer::try_from(value).ok(), _ => None },
        |value| Ok(Value::Integer(value.into()));
    fmi2GetBoolean fmi2SetBoolean fmi2Boolean, Boolean,
        |value| match value { Value::Boolean(value) => Some(value.into()), _ => None },
        |value| Ok(Value::Boolean(value != FMI2_FALSE));
}

/// Reads texts; they live until the next `fmi2GetString` of the instance.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2String,
) -> fmi2Status {
    function(c, "fmi2GetString", ANY, ScalarType::String).get_texts((vr, nvr), (value, nvr))
}

/// Sets texts.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2String,
) -> fmi2Status {
    function(c, "fmi2SetString", SETTABLE, ScalarType::String).set_texts((vr, nvr), (value, nvr))
}
