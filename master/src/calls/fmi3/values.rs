//! Values of whole variables: arrays one after another, row by row.

use std::ffi::CStr;
use std::ptr;

use super::abi::{Functions, Get, Set, Text};
use crate::calls::instance::{GET, Instance, SET, c_texts};
use crate::error::ImportError;
use crate::value::{ScalarType, Value};

/// A number of the interface as a value of the master.
trait Number: Copy + Default {
    fn value(self) -> Option<Value>;
    fn from_value(value: &Value) -> Option<Self>;
}

macro_rules! reals {
    ($($real:ty),*) => {$(
        impl Number for $real {
            fn value(self) -> Option<Value> {
                Some(Value::Real(self.into()))
            }

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::Real(value) => Some(*value as Self),
                    _ => None,
                }
            }
        }
    )*};
}
reals!(f64, f32);

macro_rules! integers {
    ($($integer:ty),*) => {$(
        impl Number for $integer {
            fn value(self) -> Option<Value> {
                i64::try_from(self).ok().map(Value::Integer)
            }

            fn from_value(value: &Value) -> Option<Self> {
                match value {
                    Value::Integer(value) => Self::try_from(*value).ok(),
                    _ => None,
                }
            }
        }
    )*};
}
integers!(i8, i16, u16, i32, u32, i64, u64);

/// A byte: a number, or a truth value.
impl Number for u8 {
    fn value(self) -> Option<Value> {
        Some(Value::Integer(self.into()))
    }

    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Integer(value) => Self::try_from(*value).ok(),
            Value::Boolean(value) => Some(Self::from(*value)),
            _ => None,
        }
    }
}

impl Instance<Functions> {
    /// The values of variables of one type, which have `count` elements together.
    pub(crate) fn get_values(
        &mut self,
        scalar: ScalarType,
        references: &[u32],
        count: usize,
    ) -> Result<Vec<Value>, ImportError> {
        let numbers = (references, count);
        match scalar {
            ScalarType::Float64 => self.numbers("fmi3GetFloat64", |f| f.get_float64, numbers),
            ScalarType::Float32 => self.numbers("fmi3GetFloat32", |f| f.get_float32, numbers),
            ScalarType::Int8 => self.numbers("fmi3GetInt8", |f| f.get_int8, numbers),
            ScalarType::UInt8 => self.numbers("fmi3GetUInt8", |f| f.get_uint8, numbers),
            ScalarType::Int16 => self.numbers("fmi3GetInt16", |f| f.get_int16, numbers),
            ScalarType::UInt16 => self.numbers("fmi3GetUInt16", |f| f.get_uint16, numbers),
            ScalarType::Int32 => self.numbers("fmi3GetInt32", |f| f.get_int32, numbers),
            ScalarType::UInt32 => self.numbers("fmi3GetUInt32", |f| f.get_uint32, numbers),
            ScalarType::Int64 | ScalarType::Enumeration => {
                self.numbers("fmi3GetInt64", |f| f.get_int64, numbers)
            }
            ScalarType::UInt64 => self.numbers("fmi3GetUInt64", |f| f.get_uint64, numbers),
            ScalarType::Boolean => {
                let bytes = self.raw("fmi3GetBoolean", |f| f.get_boolean, numbers, 0)?;
                Ok(bytes.into_iter().map(|b| Value::Boolean(b != 0)).collect())
            }
            ScalarType::String => self.texts(numbers),
            ScalarType::Binary => self.binaries(numbers),
            // No variable of the master is a clock.
            ScalarType::Clock => Ok(Vec::new()),
        }
    }

    /// Sets variables of one type: all their elements, one variable after another.
    pub(crate) fn set_values(
        &mut self,
        scalar: ScalarType,
        references: &[u32],
        values: &[Value],
    ) -> Result<(), ImportError> {
        let all = (references, values);
        match scalar {
            ScalarType::Float64 => self.assign("fmi3SetFloat64", |f| f.set_float64, scalar, all),
            ScalarType::Float32 => self.assign("fmi3SetFloat32", |f| f.set_float32, scalar, all),
            ScalarType::Int8 => self.assign("fmi3SetInt8", |f| f.set_int8, scalar, all),
            ScalarType::UInt8 => self.assign("fmi3SetUInt8", |f| f.set_uint8, scalar, all),
            ScalarType::Int16 => self.assign("fmi3SetInt16", |f| f.set_int16, scalar, all),
            ScalarType::UInt16 => self.assign("fmi3SetUInt16", |f| f.set_uint16, scalar, all),
            ScalarType::Int32 => self.assign("fmi3SetInt32", |f| f.set_int32, scalar, all),
            ScalarType::UInt32 => self.assign("fmi3SetUInt32", |f| f.set_uint32, scalar, all),
            ScalarType::Int64 | ScalarType::Enumeration => {
                self.assign("fmi3SetInt64", |f| f.set_int64, scalar, all)
            }
            ScalarType::UInt64 => self.assign("fmi3SetUInt64", |f| f.set_uint64, scalar, all),
            ScalarType::Boolean => self.assign("fmi3SetBoolean", |f| f.set_boolean, scalar, all),
            ScalarType::String => self.set_texts(all),
            ScalarType::Binary => self.set_binaries(all),
            ScalarType::Clock => Ok(()),
        }
    }

    fn raw<T: Clone>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<Get<T>>,
        (references, count): (&[u32], usize),
        before: T,
    ) -> Result<Vec<T>, ImportError> {
        let call = self.optional(function, pick)?;
        let mut values = vec![before; count];
        self.call(function, GET, |instance| {
            // SAFETY: a list of references, and one of as many values as their variables have elements.
            unsafe {
                call(
                    instance,
                    references.as_ptr(),
                    references.len(),
                    values.as_mut_ptr(),
                    count,
                )
            }
        })?;
        Ok(values)
    }

    fn numbers<T: Number + std::fmt::Display>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<Get<T>>,
        list: (&[u32], usize),
    ) -> Result<Vec<Value>, ImportError> {
        let values = self.raw(function, pick, list, T::default())?;
        let value = |number: T| {
            number.value().ok_or_else(|| ImportError::Range {
                function,
                found: number.to_string(),
                expected: "a signed integer of 64 bits".to_owned(),
            })
        };
        values.into_iter().map(value).collect()
    }

    fn texts(&mut self, list: (&[u32], usize)) -> Result<Vec<Value>, ImportError> {
        const FUNCTION: &str = "fmi3GetString";
        let pointers = self.raw(FUNCTION, |f| f.get_string, list, ptr::null())?;
        let copy = |(k, pointer): (usize, Text)| {
            if pointer.is_null() {
                return Err(null(FUNCTION, k));
            }
            // SAFETY: the FMU keeps the text until the next call, which comes after this.
            let text = unsafe { CStr::from_ptr(pointer) };
            Ok(Value::String(text.to_string_lossy().into_owned()))
        };
        pointers.into_iter().enumerate().map(copy).collect()
    }

    fn binaries(
        &mut self,
        (references, count): (&[u32], usize),
    ) -> Result<Vec<Value>, ImportError> {
        const FUNCTION: &str = "fmi3GetBinary";
        let call = self.optional(FUNCTION, |f| f.get_binary)?;
        let mut sizes = vec![0_usize; count];
        let mut pointers = vec![ptr::null(); count];
        self.call(FUNCTION, GET, |instance| {
            // SAFETY: a list of references, and two of as many values as their variables have elements.
            unsafe {
                call(
                    instance,
                    references.as_ptr(),
                    references.len(),
                    sizes.as_mut_ptr(),
                    pointers.as_mut_ptr(),
                    count,
                )
            }
        })?;
        let copy = |(k, (pointer, size)): (usize, (*const u8, usize))| {
            if size == 0 {
                return Ok(Value::Binary(Vec::new()));
            }
            if pointer.is_null() {
                return Err(null(FUNCTION, k));
            }
            // SAFETY: the FMU keeps that many bytes until the next call, which comes after this.
            let bytes = unsafe { std::slice::from_raw_parts(pointer, size) };
            Ok(Value::Binary(bytes.to_vec()))
        };
        let pairs = pointers.into_iter().zip(sizes).enumerate();
        pairs.map(copy).collect()
    }

    fn assign<T: Number>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<Set<T>>,
        expected: ScalarType,
        (references, values): (&[u32], &[Value]),
    ) -> Result<(), ImportError> {
        let number = |value: &Value| {
            T::from_value(value).ok_or_else(|| ImportError::Range {
                function,
                found: value.to_string(),
                expected: expected.to_string(),
            })
        };
        let numbers: Vec<T> = values.iter().map(number).collect::<Result<_, _>>()?;
        self.put(function, pick, references, &numbers)
    }

    fn put<T>(
        &mut self,
        function: &'static str,
        pick: impl FnOnce(&Functions) -> Option<Set<T>>,
        references: &[u32],
        values: &[T],
    ) -> Result<(), ImportError> {
        let call = self.optional(function, pick)?;
        self.call(function, SET, |instance| {
            // SAFETY: a list of references, and one of as many values as their variables have elements.
            unsafe {
                call(
                    instance,
                    references.as_ptr(),
                    references.len(),
                    values.as_ptr(),
                    values.len(),
                )
            }
        })
    }

    fn set_texts(&mut self, (references, values): (&[u32], &[Value])) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi3SetString";
        let texts: Vec<&str> = values
            .iter()
            .map(|value| match value {
                Value::String(text) => text,
                _ => "",
            })
            .collect();
        let texts = c_texts(FUNCTION, &texts)?;
        let pointers: Vec<_> = texts.iter().map(|text| text.as_ptr()).collect();
        self.put(FUNCTION, |f| f.set_string, references, &pointers)
    }

    fn set_binaries(
        &mut self,
        (references, values): (&[u32], &[Value]),
    ) -> Result<(), ImportError> {
        const FUNCTION: &str = "fmi3SetBinary";
        let bytes = values.iter().map(|value| match value {
            Value::Binary(bytes) => &**bytes,
            _ => &[],
        });
        let (pointers, sizes): (Vec<*const u8>, Vec<usize>) =
            bytes.map(|bytes| (bytes.as_ptr(), bytes.len())).unzip();
        let call = self.optional(FUNCTION, |f| f.set_binary)?;
        self.call(FUNCTION, SET, |instance| {
            // SAFETY: lists of one length; each pointer leads to as many bytes as its size says.
            unsafe {
                call(
                    instance,
                    references.as_ptr(),
                    references.len(),
                    sizes.as_ptr(),
                    pointers.as_ptr(),
                    pointers.len(),
                )
            }
        })
    }
}

fn null(function: &'static str, element: usize) -> ImportError {
    ImportError::Null {
        function,
        what: format!("value {} of the call", element + 1),
    }
}
