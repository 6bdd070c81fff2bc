//! Saved states: an `fmi2FMUstate` or `fmi3FMUState` points to a state in memory, or to the bytes that it was made of. The two
//! versions share them.

use std::cell::OnceCell;
use std::ffi::c_void;

use sphere_dda_fmi_interface::handle;
use sphere_dda_fmi_interface::pointers::BadArgument;

use super::guard::{Stages, Status, lend};
use crate::runtime::instance::{Instance, Kept};
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
enum Saved {
    /// A state in memory, and its serialized form once that is asked for.
    Kept(Box<Kept>, OnceCell<Vec<u8>>),
    /// A state that was deserialized.
    Serialized(Vec<u8>),
}

impl handle::Kind for Saved {
    const MAGIC: u64 = u64::from_le_bytes(*b"SDDAsave");
}

impl Saved {
    fn of(instance: &Instance) -> Self {
        Self::Kept(Box::new(instance.keep()), OnceCell::new())
    }

    fn bytes(&self) -> Result<&[u8], Refusal> {
        match self {
            Self::Serialized(bytes) => Ok(bytes),
            Self::Kept(kept, bytes) => match bytes.get() {
                Some(bytes) => Ok(bytes),
                None => {
                    let encoded = kept.encode()?;
                    Ok(bytes.get_or_init(|| encoded))
                }
            },
        }
    }
}

/// The saved state behind a pointer.
fn saved<'a>(state: *mut c_void) -> Result<&'a mut Saved, Refusal> {
    // SAFETY: the importer uses a state in one call at a time.
    unsafe { handle::look::<Saved>(state) }.ok_or_else(|| none(state))
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
            *place = handle::give(Saved::of(&component.instance));
        } else {
            *saved(*place)? = Saved::of(&component.instance);
        }
        Ok(S::OK)
    })
}

/// Restores a state.
pub(super) fn set<S: Status>((c, function, allowed): CallSite, state: *mut c_void) -> S {
    lend(c, function, allowed, |component, _| {
        match saved(state)? {
            Saved::Kept(kept, _) => component.instance.restore(kept)?,
            Saved::Serialized(bytes) => component.instance.load(bytes)?,
        }
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
        let bytes = saved(state)?.bytes()?.len();
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
        let bytes = saved(state)?.bytes()?;
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
        place.write(handle::give(Saved::Serialized(bytes.to_vec())));
        Ok(S::OK)
    })
}
