//! Saved states: see [`super::super::saved`].

use sphere_dda_fmi_interface::abi2::*;

use super::super::guard::ANY;
use super::super::saved::{self, SAVEABLE};

/// Saves the state; a state that is passed in is overwritten.
#[unsafe(no_mangle)]
extern "C" fn fmi2GetFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    saved::get((c, "fmi2GetFMUstate", SAVEABLE), state)
}

/// Restores a state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SetFMUstate(c: fmi2Component, state: fmi2FMUstate) -> fmi2Status {
    saved::set((c, "fmi2SetFMUstate", ANY), state)
}

/// Frees a state and sets the pointer to null; a null state is ignored.
#[unsafe(no_mangle)]
extern "C" fn fmi2FreeFMUstate(c: fmi2Component, state: *mut fmi2FMUstate) -> fmi2Status {
    saved::free((c, "fmi2FreeFMUstate", ANY), state)
}

/// Number of bytes of a serialized state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SerializedFMUstateSize(
    c: fmi2Component,
    state: fmi2FMUstate,
    size: *mut usize,
) -> fmi2Status {
    saved::size((c, "fmi2SerializedFMUstateSize", ANY), state, size)
}

/// Copies the bytes of a state.
#[unsafe(no_mangle)]
extern "C" fn fmi2SerializeFMUstate(
    c: fmi2Component,
    state: fmi2FMUstate,
    serialized: *mut fmi2Byte,
    size: usize,
) -> fmi2Status {
    saved::serialize(
        (c, "fmi2SerializeFMUstate", ANY),
        state,
        serialized.cast(),
        size,
    )
}

/// Makes a state of bytes; anything that is no state of this model is refused.
#[unsafe(no_mangle)]
extern "C" fn fmi2DeSerializeFMUstate(
    c: fmi2Component,
    serialized: *const fmi2Byte,
    size: usize,
    state: *mut fmi2FMUstate,
) -> fmi2Status {
    saved::deserialize(
        (c, "fmi2DeSerializeFMUstate", ANY),
        serialized.cast(),
        size,
        state,
    )
}
