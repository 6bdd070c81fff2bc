//! Saved states: save, restore, turn into bytes and back.

use std::ptr;
use std::sync::Arc;

use super::{ALIVE, Instance};
use crate::import::abi::FmuState;
use crate::import::logger::Log;
use crate::import::{ImportError, Phase};

/// A state saved by [`Instance::save_state`]. It belongs to that instance, which frees it at its end if
/// [`Instance::free_state`] did not.
#[derive(Debug)]
pub struct SavedState {
    raw: FmuState,
    phase: Phase,
    owner: Arc<Log>,
}

impl Instance {
    /// `fmi2GetFMUstate`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Null`].
    pub fn save_state(&mut self) -> Result<SavedState, ImportError> {
        const FUNCTION: &str = "fmi2GetFMUstate";
        let call = self.optional(FUNCTION, |f| f.get_fmu_state)?;
        let mut raw = ptr::null_mut();
        self.call(FUNCTION, ALIVE, |component| {
            // SAFETY: `raw` is there for the call; NULL asks for a new state.
            unsafe { call(component, &raw mut raw) }
        })?;
        self.hold(FUNCTION, raw, self.phase)
    }

    /// `fmi2SetFMUstate`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::ForeignState`].
    pub fn restore_state(&mut self, state: &SavedState) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi2SetFMUstate";
        let call = self.optional(FUNCTION, |f| f.set_fmu_state)?;
        self.own(FUNCTION, state)?;
        self.call(FUNCTION, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed.
            unsafe { call(component, state.raw) }
        })?;
        self.phase = state.phase;
        Ok(())
    }

    /// `fmi2FreeFMUstate`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::ForeignState`].
    pub fn free_state(&mut self, state: SavedState) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi2FreeFMUstate";
        let call = self.optional(FUNCTION, |f| f.free_fmu_state)?;
        self.own(FUNCTION, &state)?;
        self.states.retain(|&held| held != state.raw);
        let mut raw = state.raw;
        self.call(FUNCTION, ALIVE, |component| {
            // SAFETY: a state of this instance, held no longer.
            unsafe { call(component, &raw mut raw) }
        })
    }

    /// `fmi2SerializedFMUstateSize` and `fmi2SerializeFMUstate`: the state as bytes, for another process.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::ForeignState`].
    pub fn serialize_state(&mut self, state: &SavedState) -> Result<Vec<u8>, ImportError> {
        const SIZE: &str = "fmi2SerializedFMUstateSize";
        const WRITE: &str = "fmi2SerializeFMUstate";
        let size_of = self.optional(SIZE, |f| f.serialized_fmu_state_size)?;
        let write = self.optional(WRITE, |f| f.serialize_fmu_state)?;
        self.own(WRITE, state)?;
        let mut size = 0;
        self.call(SIZE, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed; `size` is there for the call.
            unsafe { size_of(component, state.raw, &raw mut size) }
        })?;
        let mut bytes = vec![0_u8; size];
        self.call(WRITE, ALIVE, |component| {
            // SAFETY: as above; the buffer has the size that was asked for.
            unsafe { write(component, state.raw, bytes.as_mut_ptr().cast(), size) }
        })?;
        Ok(bytes)
    }

    /// `fmi2DeSerializeFMUstate`: a state from the bytes of [`serialize_state`](Self::serialize_state), taken as
    /// one saved at a communication point.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Null`].
    pub fn deserialize_state(&mut self, bytes: &[u8]) -> Result<SavedState, ImportError> {
        const FUNCTION: &str = "fmi2DeSerializeFMUstate";
        let call = self.optional(FUNCTION, |f| f.deserialize_fmu_state)?;
        let mut raw = ptr::null_mut();
        self.call(FUNCTION, ALIVE, |component| {
            // SAFETY: the buffer has that many bytes; `raw` is there for the call.
            unsafe { call(component, bytes.as_ptr().cast(), bytes.len(), &raw mut raw) }
        })?;
        self.hold(FUNCTION, raw, Phase::Stepping)
    }

    fn hold(
        &mut self,
        function: &'static str,
        raw: FmuState,
        phase: Phase,
    ) -> Result<SavedState, ImportError> {
        if raw.is_null() {
            return Err(ImportError::Null {
                function,
                what: "the state".to_owned(),
            });
        }
        self.states.push(raw);
        Ok(SavedState {
            raw,
            phase,
            owner: Arc::clone(&self.log),
        })
    }

    fn own(&self, function: &'static str, state: &SavedState) -> Result<(), ImportError> {
        if Arc::ptr_eq(&self.log, &state.owner) && self.states.contains(&state.raw) {
            return Ok(());
        }
        Err(ImportError::ForeignState { function })
    }
}
