//! Saved states: save, restore, turn into bytes and back.

use std::ptr;
use std::sync::Arc;

use crate::error::ImportError;
use crate::status::Phase;

use super::instance::{ALIVE, Instance};
use super::library::{Handle, Interface};
use super::logger::Log;

/// A state saved by `save_state` of an instance. It belongs to that instance, which frees it at its end if
/// `free_state` did not.
#[derive(Debug)]
pub struct SavedState {
    raw: Handle,
    phase: Phase,
    owner: Arc<Log>,
}

impl<F: Interface> Instance<F> {
    /// `fmi2GetFMUstate`, `fmi3GetFMUState`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Null`].
    pub fn save_state(&mut self) -> Result<SavedState, ImportError> {
        let (function, call) = self.library.functions.states().save;
        let call = self.library.optional(function, call)?;
        let mut raw = ptr::null_mut();
        self.call(function, ALIVE, |component| {
            // SAFETY: `raw` is there for the call; NULL asks for a new state.
            unsafe { call(component, &raw mut raw) }
        })?;
        self.hold(function, raw, self.phase)
    }

    /// `fmi2SetFMUstate`, `fmi3SetFMUState`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::ForeignState`].
    pub fn restore_state(&mut self, state: &SavedState) -> Result<(), ImportError> {
        let (function, call) = self.library.functions.states().restore;
        let call = self.library.optional(function, call)?;
        self.own(function, state)?;
        self.call(function, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed.
            unsafe { call(component, state.raw) }
        })?;
        self.phase = state.phase;
        Ok(())
    }

    /// `fmi2FreeFMUstate`, `fmi3FreeFMUState`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::ForeignState`].
    pub fn free_state(&mut self, state: SavedState) -> Result<(), ImportError> {
        let (function, call) = self.library.functions.states().free;
        let call = self.library.optional(function, call)?;
        self.own(function, &state)?;
        self.states.retain(|&held| held != state.raw);
        let mut raw = state.raw;
        self.call(function, ALIVE, |component| {
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
        let calls = self.library.functions.states();
        let size_of = self.library.optional(calls.size.0, calls.size.1)?;
        let write = self.library.optional(calls.write.0, calls.write.1)?;
        self.own(calls.write.0, state)?;
        let mut size = 0;
        self.call(calls.size.0, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed; `size` is there for the call.
            unsafe { size_of(component, state.raw, &raw mut size) }
        })?;
        let mut bytes = vec![0_u8; size];
        self.call(calls.write.0, ALIVE, |component| {
            // SAFETY: as above; the buffer has the size that was asked for.
            unsafe { write(component, state.raw, bytes.as_mut_ptr(), size) }
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
        let (function, call) = self.library.functions.states().read;
        let call = self.library.optional(function, call)?;
        let mut raw = ptr::null_mut();
        self.call(function, ALIVE, |component| {
            // SAFETY: the buffer has that many bytes; `raw` is there for the call.
            unsafe { call(component, bytes.as_ptr(), bytes.len(), &raw mut raw) }
        })?;
        self.hold(function, raw, Phase::Stepping)
    }

    fn hold(
        &mut self,
        function: &'static str,
        raw: Handle,
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
