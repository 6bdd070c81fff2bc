//! Saved states: see [`super::super::saved`].

use sphere_dda_fmi_interface::abi3::*;

use super::super::guard::ANY;
use super::super::saved::{self, SAVEABLE};

/// Saves the state; a state that is passed in is overwritten.
#[unsafe(no_mangle)]
extern "C" fn fmi3GetFMUState(c: fmi3Instance, state: *mut fmi3FMUState) -> fmi3Status {
    saved::get((c, "fmi3GetFMUState", SAVEABLE), state)
}

/// Restores a state.
#[unsafe(no_mangle)]
extern "C" fn fmi3SetFMUState(c: fmi3Instance, state: fmi3FMUState) -> fmi3Status {
    saved::set((c, "fmi3SetFMUState", ANY), state)
}

/// Frees a state and sets the pointer to null; a null state is ignored.
#[unsafe(no_mangle)]
extern "C" fn fmi3FreeFMUState(c: fmi3Instance, state: *mut fmi3FMUState) -> fmi3Status {
    saved::free((c, "fmi3FreeFMUState", ANY), state)
}

/// Number of bytes of a serialized state.
#[unsafe(no_mangle)]
extern "C" fn fmi3SerializedFMUStateSize(
    c: fmi3Instance,
    state: fmi3FMUState,
    size: *mut usize,
) -> fmi3Status {
    saved::size((c, "fmi3SerializedFMUStateSize", ANY), state, size)
}

/// Copies the bytes of a state.
#[unsafe(no_mangle)]
extern "C" fn fmi3SerializeFMUState(
    c: fmi3Instance,
    state: fmi3FMUState,
    serialized: *mut fmi3Byte,
    size: usize,
) -> fmi3Status {
    saved::serialize((c, "fmi3SerializeFMUState", ANY), state, serialized, size)
}

/// Makes a state of bytes; anything that is no state of this model is refused.
#[unsafe(no_mangle)]
extern "C" fn fmi3DeserializeFMUState(
    c: fmi3Instance,
    serialized: *const fmi3Byte,
    size: usize,
    state: *mut fmi3FMUState,
) -> fmi3Status {
    saved::deserialize((c, "fmi3DeserializeFMUState", ANY), serialized, size, state)
}
