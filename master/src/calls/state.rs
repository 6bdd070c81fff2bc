//! Saved states: save, restore, turn into bytes and back.

use std::collections::BTreeMap;
use std::ptr;
use std::sync::Arc;

use crate::error::ImportError;
use crate::status::Phase;
use crate::value::Value;

use super::instance::{ALIVE, Instance};
use super::library::{Handle, Interface};
use super::logger::Log;

/// A state saved by `save_state` of an instance. It belongs to that instance, which frees it at its end if
/// `free_state` did not.
#[derive(Debug)]
pub struct SavedState {
    kept: Kept,
    owner: Arc<Log>,
    /// What the FMU had told, if it has an event mode.
    pub(super) agenda: Agenda,
    /// What its discrete inputs were set to then, by value reference.
    pub(super) inputs: BTreeMap<u32, Vec<Value>>,
}

/// What an FMU with an event mode has told of its future.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Agenda {
    /// Time of its next event, if one is known \[s\].
    pub(super) next_event: Option<f64>,
    /// It wants to end the simulation.
    pub(super) terminated: bool,
}

/// Where a state is.
#[derive(Debug)]
enum Kept {
    /// In this process, with the phase that the instance was in.
    Here(Handle, Phase),
    /// In the process of the instance, under this number.
    There(u64),
}

impl SavedState {
    /// A state that the process of an instance keeps under this number; `owner` is what is here of the instance.
    pub(crate) fn there(number: u64, owner: &Arc<Log>) -> Self {
        Self {
            kept: Kept::There(number),
            owner: Arc::clone(owner),
            agenda: Agenda::default(),
            inputs: BTreeMap::new(),
        }
    }

    /// Its number in the process of the instance that `owner` is here of.
    pub(crate) fn number(&self, owner: &Arc<Log>) -> Option<u64> {
        match self.kept {
            Kept::There(number) if Arc::ptr_eq(&self.owner, owner) => Some(number),
            _ => None,
        }
    }
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
        let (raw, phase) = self.own(function, state)?;
        self.call(function, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed.
            unsafe { call(component, raw) }
        })?;
        self.phase = phase;
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
        let (mut raw, _) = self.own(function, &state)?;
        self.states.retain(|&held| held != raw);
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
        let (raw, _) = self.own(calls.write.0, state)?;
        let mut size = 0;
        self.call(calls.size.0, ALIVE, |component| {
            // SAFETY: a state of this instance that is not freed; `size` is there for the call.
            unsafe { size_of(component, raw, &raw mut size) }
        })?;
        let mut bytes = vec![0_u8; size];
        self.call(calls.write.0, ALIVE, |component| {
            // SAFETY: as above; the buffer has the size that was asked for.
            unsafe { write(component, raw, bytes.as_mut_ptr(), size) }
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
            kept: Kept::Here(raw, phase),
            owner: Arc::clone(&self.log),
            agenda: Agenda::default(),
            inputs: BTreeMap::new(),
        })
    }

    fn own(
        &self,
        function: &'static str,
        state: &SavedState,
    ) -> Result<(Handle, Phase), ImportError> {
        match state.kept {
            Kept::Here(raw, phase)
                if Arc::ptr_eq(&self.log, &state.owner) && self.states.contains(&raw) =>
            {
                Ok((raw, phase))
            }
            _ => Err(ImportError::ForeignState { function }),
        }
    }
}
