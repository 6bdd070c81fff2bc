//! Getting and setting values.

use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_model_description::value::{ScalarType, Value};

use super::super::guard::{Stages, lend};
use super::super::values::Function;
use crate::runtime::instance::Call;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::version::Version;

use fmi3Status::fmi3OK;

pub(super) const READABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Error,
    LifeCycle::Terminated,
    LifeCycle::Intermediate,
];
pub(super) const SETTABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Intermediate,
];

fn function(
    component: fmi3Instance,
    name: &'static str,
    allowed: Stages,
    scalar: ScalarType,
) -> Function {
    Function {
        component,
        name,
        allowed,
        version: Version::Three,
        scalar,
    }
}

/// A getter and a setter of numbers: their names, type in C, type of the variables, and the two conversions.
macro_rules! numbers {
    ($($get:ident $set:ident $type:ty, $scalar:ident, $out:expr, $in:expr;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $get(
            instance: fmi3Instance,
            valueReferences: *const fmi3ValueReference,
            nValueReferences: usize,
            values: *mut $type,
            nValues: usize,
        ) -> fmi3Status {
            let get = function(instance, stringify!($get), READABLE, ScalarType::$scalar);
            get.get((valueReferences, nValueReferences), (values, nValues), $out)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $set(
            instance: fmi3Instance,
            valueReferences: *const fmi3ValueReference,
            nValueReferences: usize,
            values: *const $type,
            nValues: usize,
        ) -> fmi3Status {
            let set = function(instance, stringify!($set), SETTABLE, ScalarType::$scalar);
            set.set((valueReferences, nValueReferences), (values, nValues), $in)
        }
    )*};
}

/// No variable has the type: whatever is asked for is refused, by its reference.
pub(super) fn never<T>(_: Value) -> Option<T> {
    None
}

/// As [`never`]: the value is not looked at.
#[expect(clippy::unnecessary_wraps, reason = "one signature for all types")]
fn any<T>(_: T) -> Result<Value, Refusal> {
    Ok(Value::Integer(0))
}

numbers! {
    fmi3GetFloat64 fmi3SetFloat64 f64, Float64,
        |value| match value { Value::Real(value) => Some(value), _ => None },
        |value| Ok(Value::Real(value));
    fmi3GetInt32 fmi3SetInt32 i32, Int32,
        |value| match value { Value::Integer(value) => i32::try_from(value).ok(), _ => None },
        |value| Ok(Value::Integer(value.into()));
    fmi3GetInt64 fmi3SetInt64 i64, Int64,
        |value| match value { Value::Integer(value) => Some(value), _ => None },
        |value| Ok(Value::Integer(value));
    fmi3GetBoolean fmi3SetBoolean fmi3Boolean, Boolean,
        |value| match value { Value::Boolean(value) => Some(value.into()), _ => None },
        |value| Ok(Value::Boolean(value != 0));
    fmi3GetFloat32 fmi3SetFloat32 f32, Float32, never, any;
    fmi3GetInt8 fmi3SetInt8 i8, Int8, never, any;
    fmi3GetUInt8 fmi3SetUInt8 u8, UInt8, never, any;
    fmi3GetInt16 fmi3SetInt16 i16, Int16, never, any;
    fmi3GetUInt16 fmi3SetUInt16 u16, UInt16, never, any;
    fmi3GetUInt32 fmi3SetUInt32 u32, UInt32, never, any;
    fmi3GetUInt64 fmi3SetUInt64 u64, UInt64, never, any;
}

/// Reads texts; they live until the next `fmi3GetString` of the instance.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetString(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *mut fmi3String,
    nValues: usize,
) -> fmi3Status {
    let get = function(instance, "fmi3GetString", READABLE, ScalarType::String);
    get.get_texts((valueReferences, nValueReferences), (values, nValues))
}

/// Sets texts.
#[unsafe(no_mangle)]
extern "C" fn fmi3SetString(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    values: *const fmi3String,
    nValues: usize,
) -> fmi3Status {
    let set = function(instance, "fmi3SetString", SETTABLE, ScalarType::String);
    set.set_texts((valueReferences, nValueReferences), (values, nValues))
}

/// Reads binaries; they live until the next `fmi3GetBinary` of the instance.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetBinary(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    valueSizes: *mut usize,
    values: *mut fmi3Binary,
    nValues: usize,
) -> fmi3Status {
    lend(instance, "fmi3GetBinary", READABLE, |component, lent| {
        let references = lent.array(valueReferences, nValueReferences, "valueReferences")?;
        let (version, scalar) = (Version::Three, ScalarType::Binary);
        let mut found = Vec::new();
        let mut give = |value| {
            if let Value::Binary(bytes) = value {
                found.push(bytes);
            }
        };
        let of = Call { version, scalar };
        component.instance.get(of, references, nValues, &mut give)?;
        let sizes = lent.places(valueSizes, nValues, "valueSizes")?;
        let places = lent.places(values, nValues, "values")?;
        component.binaries = found;
        let pairs = places.iter_mut().zip(sizes);
        for ((place, size), bytes) in pairs.zip(&component.binaries) {
            place.write(bytes.as_ptr());
            size.write(bytes.len());
        }
        Ok(fmi3OK)
    })
}

/// Sets binaries: there is none to set.
#[unsafe(no_mangle)]
extern "C" fn fmi3SetBinary(
    instance: fmi3Instance,
    valueReferences: *const fmi3ValueReference,
    nValueReferences: usize,
    _valueSizes: *const usize,
    values: *const fmi3Binary,
    nValues: usize,
) -> fmi3Status {
    let set = function(instance, "fmi3SetBinary", SETTABLE, ScalarType::Binary);
    set.set((valueReferences, nValueReferences), (values, nValues), any)
}
