//! Getting and setting values.

use std::ffi::CString;

use sphere_dda_fmi_interface::abi3::*;
use sphere_dda_fmi_interface::pointers::{BadArgument, array, array_mut, c_string, str_from};
use sphere_dda_model_description::fmi3::Kind;

use super::super::guard::{Component, Stages, call};
use crate::runtime::instance::{Element, counted};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;
use crate::table::Value;

use fmi3Status::fmi3OK;

const READABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Error,
    LifeCycle::Terminated,
    LifeCycle::Intermediate,
];
const SETTABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Intermediate,
];

/// References and values as they come from C.
type Pairs<T> = (*const fmi3ValueReference, usize, T, usize);

/// The elements of the variables, exactly as many as the importer has room for.
fn elements(
    component: &mut Component,
    kind: Kind,
    references: &[u32],
    room: usize,
) -> Result<Vec<Element>, Refusal> {
    let found = component.instance.get_arrays(kind, references)?;
    if found.len() == room {
        return Ok(found);
    }
    Err(counted(room, found.len()))
}

/// Reads values of one type; `convert` takes them out of their envelope.
fn get<T>(
    (c, function): (fmi3Instance, &str),
    kind: Kind,
    (vr, nvr, value, room): Pairs<*mut T>,
    convert: impl Fn(Element) -> Option<T>,
) -> fmi3Status {
    call(c, function, READABLE, |component| {
        let found = elements(component, kind, array(vr, nvr, "valueReferences")?, room)?;
        let places = array_mut(value, room, "values")?;
        for (place, value) in places.iter_mut().zip(found.into_iter().filter_map(convert)) {
            *place = value;
        }
        Ok(fmi3OK)
    })
}

/// Sets values of one type; `convert` puts them into an envelope, or knows that no variable takes them.
fn set<T: Copy>(
    (c, function): (fmi3Instance, &str),
    kind: Kind,
    (vr, nvr, value, count): Pairs<*const T>,
    convert: impl Fn(T) -> Result<Value, Refusal>,
) -> fmi3Status {
    call(c, function, SETTABLE, |component| {
        let values = array(value, count, "values")?.iter();
        let values = values
            .map(|&value| convert(value))
            .collect::<Result<_, _>>()?;
        let references = array(vr, nvr, "valueReferences")?;
        component.instance.set_arrays(kind, references, values)?;
        Ok(fmi3OK)
    })
}

/// A getter and a setter of numbers: their names, type in C, kind of variable, and the two conversions.
macro_rules! numbers {
    ($($get:ident $set:ident $type:ty, $kind:ident, $out:expr, $in:expr;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $get(
            instance: fmi3Instance,
            valueReferences: *const fmi3ValueReference,
            nValueReferences: usize,
            values: *mut $type,
            nValues: usize,
        ) -> fmi3Status {
            let pairs = (valueReferences, nValueReferences, values, nValues);
            get((instance, stringify!($get)), Kind::$kind, pairs, $out)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $set(
            instance: fmi3Instance,
            valueReferences: *const fmi3ValueReference,
            nValueReferences: usize,
            values: *const $type,
            nValues: usize,
        ) -> fmi3Status {
            let pairs = (valueReferences, nValueReferences, values, nValues);
            set((instance, stringify!($set)), Kind::$kind, pairs, $in)
        }
    )*};
}

/// No variable has the type: whatever is asked for is refused, by its reference.
fn never<T>(_: Element) -> Option<T> {
    None
}

/// The value of an item: enumerations are the only integers of 64 bits that can be set.
fn item(value: i64) -> Result<Value, Refusal> {
    let narrow = i32::try_from(value).map_err(|_| BadArgument {
        argument: "values",
        found: value.to_string(),
        expected: "the value of an item of the enumeration",
    })?;
    Ok(Value::Integer(narrow))
}

/// As [`never`]: the value is not looked at.
#[expect(clippy::unnecessary_wraps, reason = "one signature for all types")]
fn any<T>(_: T) -> Result<Value, Refusal> {
    Ok(Value::Integer(0))
}

numbers! {
    fmi3GetFloat64 fmi3SetFloat64 f64, Float64,
        |element| match element { Element::Plain(Value::Real(value)) => Some(value), _ => None },
        |value| Ok(Value::Real(value));
    fmi3GetInt32 fmi3SetInt32 i32, Int32,
        |element| match element { Element::Plain(Value::Integer(value)) => Some(value), _ => None },
        |value| Ok(Value::Integer(value));
    fmi3GetInt64 fmi3SetInt64 i64, Int64,
        |element| match element { Element::Long(value) => Some(value), _ => None }, item;
    fmi3GetBoolean fmi3SetBoolean fmi3Boolean, Boolean,
        |element| match element { Element::Plain(Value::Boolean(value)) => Some(value.into()), _ => None },
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
    call(instance, "fmi3GetString", READABLE, |component| {
        let references = array(valueReferences, nValueReferences, "valueReferences")?;
        let found = elements(component, Kind::String, references, nValues)?;
        let places = array_mut(values, nValues, "values")?;
        let text = |element| match element {
            Element::Plain(Value::String(text)) => c_string(&text),
            _ => CString::default(),
        };
        component.strings = found.into_iter().map(text).collect();
        for (place, text) in places.iter_mut().zip(&component.strings) {
            *place = text.as_ptr();
        }
        Ok(fmi3OK)
    })
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
    let pairs = (valueReferences, nValueReferences, values, nValues);
    set((instance, "fmi3SetString"), Kind::String, pairs, |value| {
        Ok(Value::String(str_from(value, "values")?.to_owned()))
    })
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
    call(instance, "fmi3GetBinary", READABLE, |component| {
        let references = array(valueReferences, nValueReferences, "valueReferences")?;
        let found = elements(component, Kind::Binary, references, nValues)?;
        let sizes = array_mut(valueSizes, nValues, "valueSizes")?;
        let places = array_mut(values, nValues, "values")?;
        let bytes = |element| match element {
            Element::Binary(bytes) => Some(bytes),
            _ => None,
        };
        component.binaries = found.into_iter().filter_map(bytes).collect();
        let pairs = places.iter_mut().zip(sizes);
        for ((place, size), bytes) in pairs.zip(&component.binaries) {
            (*place, *size) = (bytes.as_ptr(), bytes.len());
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
    let pairs = (valueReferences, nValueReferences, values, nValues);
    set((instance, "fmi3SetBinary"), Kind::Binary, pairs, any)
}
