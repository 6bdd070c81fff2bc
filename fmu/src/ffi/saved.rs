//! Saved states: an `fmi2FMUstate` or `fmi3FMUState` points to the bytes that its serialized form has. The two versions
//! share them.

use std::ffi::c_void;

use sphere_dda_fmi_interface::pointers::{BadArgument, array, array_mut, value_mut};

use super::guard::{Stages, Status, call};
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::refusal::Refusal;

/// The states in which there is something to save.
pub(super) const SAVEABLE: Stages = &[
    LifeCycle::Instantiated,
    LifeCycle::Initialization,
    LifeCycle::StepComplete,
    LifeCycle::StepFailed,
    LifeCycle::Terminated,
];

/// Where a call comes from: instance, function, and the states in which it is allowed.
pub(super) type CallSite<'a> = (*mut c_void, &'a str, Stages);

/// The saved state behind a pointer.
fn saved<'a>(state: *mut c_void) -> Result<&'a mut Vec<u8>, Refusal> {
    Ok(value_mut(state.cast::<Vec<u8>>(), "FMUstate")?)
}

/// Saves the state; a state that is passed in is overwritten.
pub(super) fn get<S: Status>((c, function, allowed): CallSite, state: *mut *mut c_void) -> S {
    call(c, function, allowed, |component| {
        let place = value_mut(state, "FMUstate")?;
        let bytes = component.instance.save()?;
        match saved(*place) {
            Ok(old) => *old = bytes,
            Err(_) => *place = Box::into_raw(Box::new(bytes)).cast(),
        }
        Ok(S::OK)
    })
}

/// Restores a state.
pub(super) fn set<S: Status>((c, function, allowed): CallSite, state: *mut c_void) -> S {
    call(c, function, allowed, |component| {
        component.instance.load(saved(state)?)?;
        Ok(S::OK)
    })
}

/// Frees a state and sets the pointer to null; a null state is ignored.
pub(super) fn free<S: Status>((c, function, allowed): CallSite, state: *mut *mut c_void) -> S {
    call(c, function, allowed, |_| {
        let place = value_mut(state, "FMUstate")?;
        if !place.is_null() {
            // SAFETY: not null, so from `get` or `deserialize`; the pointer is cleared below.
            drop(unsafe { Box::from_raw(place.cast::<Vec<u8>>()) });
            *place = std::ptr::null_mut();
        }
        Ok(S::OK)
    })
}

/// Number of bytes of a serialized state.
pub(super) fn size<S: Status>(
    (c, function, allowed): CallSite,
    state: *mut c_void,
    size: *mut usize,
) -> S {
    call(c, function, allowed, |_| {
        *value_mut(size, "size")? = saved(state)?.len();
        Ok(S::OK)
    })
}

/// Copies the bytes of a state.
pub(super) fn serialize<S: Status>(
    (c, function, allowed): CallSite,
    state: *mut c_void,
    serialized: *mut u8,
    size: usize,
) -> S {
    call(c, function, allowed, |_| {
        let bytes = saved(state)?;
        if size != bytes.len() {
            let expected = "the size of the serialized state";
            return Err(BadArgument {
                argument: "size",
                found: size.to_string(),
                expected,
            }
            .into());
        }
        array_mut(serialized, size, "serializedState")?.copy_from_slice(bytes);
        Ok(S::OK)
    })
}

/// Makes a state of bytes; anything that is no state of this model is refused.
pub(super) fn deserialize<S: Status>(
    (c, function, allowed): CallSite,
    serialized: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> S {
    call(c, function, allowed, |component| {
        let bytes = array(serialized, size, "serializedState")?;
        let place = value_mut(state, "FMUstate")?;
        component.instance.verify(bytes)?;
        *place = Box::into_raw(Box::new(bytes.to_vec())).cast();
        Ok(S::OK)
    })
}
