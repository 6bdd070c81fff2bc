//! Values of variables of FMI 2.0 by their value references.

use std::ffi::{c_char, c_int};
use std::ptr;

use super::abi::{self, Functions};
use crate::calls::instance::{GET, Instance, SET, c_texts};
use crate::calls::logger;
use crate::error::ImportError;

impl Instance<Functions> {
    /// `fmi2GetReal`, in the units of the variables.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls.
    pub fn get_real(&mut self, references: &[u32]) -> Result<Vec<f64>, ImportError> {
        self.get("fmi2GetReal", |f| f.get_real, references, f64::NAN)
    }

    /// `fmi2GetInteger`, also for enumerations.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls.
    pub fn get_integer(&mut self, references: &[u32]) -> Result<Vec<i32>, ImportError> {
        self.get("fmi2GetInteger", |f| f.get_integer, references, 0)
    }

    /// `fmi2GetBoolean`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls.
    pub fn get_boolean(&mut self, references: &[u32]) -> Result<Vec<bool>, ImportError> {
        let values = self.get("fmi2GetBoolean", |f| f.get_boolean, references, 0)?;
        Ok(values.into_iter().map(|value| value != 0).collect())
    }

    /// `fmi2GetString`; the texts are copied at once.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Null`] for a text that is not there.
    pub fn get_string(&mut self, references: &[u32]) -> Result<Vec<String>, ImportError> {
        const FUNCTION: &str = "fmi2GetString";
        let pointers = self.get(FUNCTION, |f| f.get_string, references, ptr::null())?;
        let copy = |(pointer, reference): (*const c_char, &u32)| {
            if pointer.is_null() {
                return Err(ImportError::Null {
                    function: FUNCTION,
                    what: format!("value reference {reference}"),
                });
            }
            // SAFETY: the FMU keeps the text until the next call, which comes after this.
            Ok(unsafe { logger::text(pointer) })
        };
        pointers.into_iter().zip(references).map(copy).collect()
    }

    /// `fmi2SetReal`, in the units of the variables.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Length`].
    pub fn set_real(&mut self, references: &[u32], values: &[f64]) -> Result<(), ImportError> {
        self.set("fmi2SetReal", |f| f.set_real, references, values)
    }

    /// `fmi2SetInteger`, also for enumerations.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Length`].
    pub fn set_integer(&mut self, references: &[u32], values: &[i32]) -> Result<(), ImportError> {
        self.set("fmi2SetInteger", |f| f.set_integer, references, values)
    }

    /// `fmi2SetBoolean`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Length`].
    pub fn set_boolean(&mut self, references: &[u32], values: &[bool]) -> Result<(), ImportError> {
        let values: Vec<c_int> = values.iter().map(|&value| c_int::from(value)).collect();
        self.set("fmi2SetBoolean", |f| f.set_boolean, references, &values)
    }

    /// `fmi2SetString`.
    ///
    /// # Errors
    ///
    /// [`ImportError::Call`] and the other errors of calls, [`ImportError::Length`], [`ImportError::Nul`].
    pub fn set_string(&mut self, references: &[u32], values: &[&str]) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi2SetString";
        let texts = c_texts(FUNCTION, values)?;
        let pointers: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        self.set(FUNCTION, |f| f.set_string, references, &pointers)
    }

    fn get<T: Clone>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<abi::Get<T>>,
        references: &[u32],
        before: T,
    ) -> Result<Vec<T>, ImportError> {
        if references.is_empty() {
            return Ok(Vec::new());
        }
        let call = self.optional(function, pick)?;
        let mut values = vec![before; references.len()];
        self.call(function, GET, |component| {
            // SAFETY: two lists of one length.
            unsafe {
                call(
                    component,
                    references.as_ptr(),
                    references.len(),
                    values.as_mut_ptr(),
                )
            }
        })?;
        Ok(values)
    }

    fn set<T>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<abi::Set<T>>,
        references: &[u32],
        values: &[T],
    ) -> Result<(), ImportError> {
        same_length(function, references, values.len())?;
        if references.is_empty() {
            return Ok(());
        }
        let call = self.optional(function, pick)?;
        self.call(function, SET, |component| {
            // SAFETY: two lists of one length.
            unsafe {
                call(
                    component,
                    references.as_ptr(),
                    references.len(),
                    values.as_ptr(),
                )
            }
        })
    }
}

fn same_length(
    function: &'static str,
    references: &[u32],
    found: usize,
) -> Result<(), ImportError> {
    if found == references.len() {
        return Ok(());
    }
    Err(ImportError::Length {
        function,
        found,
        expected: references.len(),
    })
}
