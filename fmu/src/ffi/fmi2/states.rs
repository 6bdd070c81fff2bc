//! Saved states: an `fmi2FMUstate` points to the bytes that its serialized form has.

use sphere_dda_fmi_interface::abi2::*;
use sphere_dda_fmi_interface::pointers::{BadArgument, array, array_mut, value_mut};

use super::super::guard::{ANY, Stages, call};
use crate::instance::Stage;
use crate::refusal::Refusal;

use fmi2Status::fmi2OK;

const SAVEABLE: Stages = &[
    Stage::Instantiated,
    Stage::Initialization,
    Stage::StepComplete,
    Stage::StepFailed,
    Stage::Terminated,
];

/// The saved state behind a pointer.
fn saved<'a>(state: fmi2FMUstate) -> Result<&'a mut Vec<u8>, Refusal> {
    Ok(value_mut(state.cast::<Vec<u8>>(), "FMUstate")?)
}

/// Saves the state; a state that is passed in is overwritten.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    call(c, "fmi2GetFMUstate", SAVEABLE, |component| {
        let place = value_mut(state, "FMUstate")?;
        let bytes = component.instance.save()?;
        match saved(*place) {
            Ok(old) => *old = bytes,
            Err(_) => *place = Box::into_raw(Box::new(bytes)).cast(),
        }
        Ok(fmi2OK)
    })
}

/// Restores a state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetFMUstate(c: fmi2Component, state: fmi2FMUstate) -> fmi2Status {
    call(c, "fmi2SetFMUstate", ANY, |component| {
        component.instance.load(saved(state)?)?;
        Ok(fmi2OK)
    })
}

/// Frees a state and sets the pointer to null; a null state is ignored.
#[unsafe(no_mangle)]
extern "C" fn fmi2FreeFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    call(c, "fmi2FreeFMUstate", ANY, |_| {
        let place = value_mut(state, "FMUstate")?;
        if !place.is_null() {
            // SAFETY: not null, so from fmi2GetFMUstate or fmi2DeSerializeFMUstate; the pointer is cleared below.
            drop(unsafe { Box::from_raw(place.cast::<Vec<u8>>()) });
            *place = std::ptr::null_mut();
        }
        Ok(fmi2OK)
    })
}

/// Number of bytes of a serialized state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SerializedFMUstateSize(
    c: fmi2Component,
    state: fmi2FMUstate,
    size: *mut usize,
) -> fmi2Status {
    call(c, "fmi2SerializedFMUstateSize", ANY, |_| {
        *value_mut(size, "size")? = saved(state)?.len();
        Ok(fmi2OK)
    })
}

/// Copies the bytes of a state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SerializeFMUstate(
    c: fmi2Component,
    state: fmi2FMUstate,
    serialized: *mut fmi2Byte,
    size: usize,
) -> fmi2Status {
    call(c, "fmi2SerializeFMUstate", ANY, |_| {
        let bytes = saved(state)?;
        if size != bytes.len() {
            let expected = "the size of fmi2SerializedFMUstateSize";
            return Err(BadArgument {
                argument: "size",
                found: size.to_string(),
                expected,
            }
            .into());
        }
        array_mut(serialized.cast::<u8>(), size, "serializedState")?.copy_from_slice(bytes);
        Ok(fmi2OK)
    })
}

/// Makes a state of bytes; anything that is no state of this model is refused.
#[unsafe(no_mangle)]
extern "C" fn fmi2DeSerializeFMUstate(
    c: fmi2Component,
    serialized: *const fmi2Byte,
    size: usize,
    state: *mut fmi2FMUstate,
) -> fmi2Status {
    call(c, "fmi2DeSerializeFMUstate", ANY, |component| {
        let bytes = array(serialized.cast::<u8>(), size, "serializedState")?;
        let place = value_mut(state, "FMUstate")?;
        component.instance.verify(bytes)?;
        *place = Box::into_raw(Box::new(bytes.to_vec())).cast();
        Ok(fmi2OK)
    })
}
