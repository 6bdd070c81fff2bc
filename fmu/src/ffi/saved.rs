//! Saved states: an `fmi2FMUstate` or `fmi3FMUState` points to the bytes that its serialized form has. The two versions
//! share them.

use std::ffi::c_void;

use sphere_dda_fmi_interface::handle;
use sphere_dda_fmi_interface::pointers::BadArgument;

use super::guard::{Stages, Status, lend};
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

/// What an `fmi2FMUstate` or `fmi3FMUState` points to.
struct Saved(Vec<u8>);

impl handle::Kind for Saved {
    const MAGIC: u64 = u64::from_le_bytes(*b"SDDAsave");
}

/// The saved state behind a pointer.
fn saved<'a>(state: *mut c_void) -> Result<&'a mut Vec<u8>, Refusal> {
    // SAFETY: the importer uses a state in one call at a time.
    match unsafe { handle::look::<Saved>(state) } {
        Some(saved) => Ok(&mut saved.0),
        None => Err(none(state)),
    }
}

fn none(state: *mut c_void) -> Refusal {
    let found = match state.is_null() {
        true => "null",
        false => "no state, or one that was freed",
    };
    let (argument, expected) = ("FMUstate", "a saved state");
    BadArgument {
        argument,
        found: found.to_owned(),
        expected,
    }
    .into()
}

/// Saves the state; a state that is passed in is overwritten.
pub(super) fn get<S: Status>((c, function, allowed): CallSite, state: *mut *mut c_void) -> S {
    lend(c, function, allowed, |component, lent| {
        let place = lent.variable(state, "FMUstate")?;
        if place.is_null() {
            *place = handle::give(Saved(component.instance.save()?));
        } else {
            let old = saved(*place)?;
            *old = component.instance.save()?;
        }
        Ok(S::OK)
    })
}

/// Restores a state.
pub(super) fn set<S: Status>((c, function, allowed): CallSite, state: *mut c_void) -> S {
    lend(c, function, allowed, |component, _| {
        component.instance.load(saved(state)?)?;
        Ok(S::OK)
    })
}

/// Frees a state and sets the pointer to null; a null state is ignored.
pub(super) fn free<S: Status>((c, function, allowed): CallSite, state: *mut *mut c_void) -> S {
    lend(c, function, allowed, |_, lent| {
        let place = lent.variable(state, "FMUstate")?;
        if !place.is_null() {
            // SAFETY: the importer uses the state in no other call.
            let state = unsafe { handle::take::<Saved>(*place) };
            drop(state.ok_or_else(|| none(*place))?);
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
    lend(c, function, allowed, |_, lent| {
        let bytes = saved(state)?.len();
        lent.place(size, "size")?.write(bytes);
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
    lend(c, function, allowed, |_, lent| {
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
        lent.places(serialized, size, "serializedState")?
            .write_copy_of_slice(bytes);
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
    lend(c, function, allowed, |component, lent| {
        let bytes = lent.array(serialized, size, "serializedState")?;
        let place = lent.place(state, "FMUstate")?;
        component.instance.verify(bytes)?;
        place.write(handle::give(Saved(bytes.to_vec())));
        Ok(S::OK)
    })
}
