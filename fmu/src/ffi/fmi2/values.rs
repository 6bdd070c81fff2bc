//! Getting and setting values.

use sphere_dda_fmi_interface::abi2::*;
use sphere_dda_fmi_interface::pointers::{array, array_mut, c_string, str_from};
use sphere_dda_model_description::fmi2::BaseType;

use super::super::guard::{ANY, call};
use super::SETTABLE;
use crate::runtime::refusal::Refusal;
use crate::table::Value;

use fmi2Status::fmi2OK;

/// Reads values of one type; `convert` takes them out of their envelope.
fn get<T>(
    (c, function): (fmi2Component, &str),
    (vr, nvr): (*const fmi2ValueReference, usize),
    (value, base): (*mut T, BaseType),
    convert: impl Fn(Value) -> Option<T>,
) -> fmi2Status {
    call(c, function, ANY, |component| {
        let values = component.instance.get(base, array(vr, nvr, "vr")?)?;
        let places = array_mut(value, nvr, "value")?;
        for (place, value) in places
            .iter_mut()
            .zip(values.into_iter().filter_map(convert))
        {
            *place = value;
        }
        Ok(fmi2OK)
    })
}

/// Reads reals.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Real,
) -> fmi2Status {
    get(
        (c, "fmi2GetReal"),
        (vr, nvr),
        (value, BaseType::Real),
        |value| match value {
            Value::Real(value) => Some(value),
            _ => None,
        },
    )
}

/// Reads integers.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetInteger(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Integer,
) -> fmi2Status {
    get(
        (c, "fmi2GetInteger"),
        (vr, nvr),
        (value, BaseType::Integer),
        |value| match value {
            Value::Integer(value) => Some(value),
            _ => None,
        },
    )
}

/// Reads truth values.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetBoolean(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2Boolean,
) -> fmi2Status {
    get(
        (c, "fmi2GetBoolean"),
        (vr, nvr),
        (value, BaseType::Boolean),
        |value| match value {
            Value::Boolean(value) => Some(fmi2Boolean::from(value)),
            _ => None,
        },
    )
}

/// Reads texts; they live until the next `fmi2GetString` of the instance.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *mut fmi2String,
) -> fmi2Status {
    call(c, "fmi2GetString", ANY, |component| {
        let values = component
            .instance
            .get(BaseType::String, array(vr, nvr, "vr")?)?;
        let places = array_mut(value, nvr, "value")?;
        let text = |value| {
            if let Value::String(text) = value {
                c_string(&text)
            } else {
                c_string("")
            }
        };
        component.strings = values.into_iter().map(text).collect();
        for (place, text) in places.iter_mut().zip(&component.strings) {
            *place = text.as_ptr();
        }
        Ok(fmi2OK)
    })
}

/// Sets values of one type; `convert` puts them into an envelope.
fn set<T: Copy>(
    (c, function): (fmi2Component, &str),
    (vr, nvr): (*const fmi2ValueReference, usize),
    value: *const T,
    convert: impl Fn(T) -> Result<Value, Refusal>,
) -> fmi2Status {
    call(c, function, SETTABLE, |component| {
        let pairs = array(vr, nvr, "vr")?
            .iter()
            .zip(array(value, nvr, "value")?);
        let values: Vec<(u32, Value)> = pairs
            .map(|(&vr, &value)| Ok((vr, convert(value)?)))
            .collect::<Result<_, Refusal>>()?;
        component.instance.set(values)?;
        Ok(fmi2OK)
    })
}

/// Sets reals.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetReal(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Real,
) -> fmi2Status {
    set((c, "fmi2SetReal"), (vr, nvr), value, |value| {
        Ok(Value::Real(value))
    })
}

/// Sets integers.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetInteger(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Integer,
) -> fmi2Status {
    set((c, "fmi2SetInteger"), (vr, nvr), value, |value| {
        Ok(Value::Integer(value))
    })
}

/// Sets truth values.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetBoolean(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2Boolean,
) -> fmi2Status {
    set((c, "fmi2SetBoolean"), (vr, nvr), value, |value| {
        Ok(Value::Boolean(value != FMI2_FALSE))
    })
}

/// Sets texts.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetString(
    c: fmi2Component,
    vr: *const fmi2ValueReference,
    nvr: usize,
    value: *const fmi2String,
) -> fmi2Status {
    set((c, "fmi2SetString"), (vr, nvr), value, |value| {
        Ok(Value::String(str_from(value, "value")?.to_owned()))
    })
}
