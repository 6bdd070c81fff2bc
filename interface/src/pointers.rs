//! Pointers from C: null, misaligned and impossibly long ones are refused, all else is taken at the importer's word.

use std::ffi::{CStr, CString, c_char, c_int};
use std::marker::PhantomData;
use std::mem::MaybeUninit;

use thiserror::Error;

use crate::abi2::{fmi2CallbackFunctions, fmi2String};
use crate::abi3::{fmi3InstanceEnvironment, fmi3LogMessageCallback};
use crate::log::{Category, Level, Sink, printf};

/// A null pointer, or a value that the argument cannot have.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("argument `{argument}` is {found}, expected {expected}")]
pub struct BadArgument {
    /// Its name in the standard.
    pub argument: &'static str,
    /// What was found.
    pub found: String,
    /// What is allowed.
    pub expected: &'static str,
}

/// A sink that calls the importer's logger. The callbacks are copied: they need not outlive the instantiation.
pub fn sink(callbacks: fmi2CallbackFunctions, name: &str) -> Option<Sink> {
    let logger = callbacks.logger?;
    let environment = callbacks.component_environment;
    let name = c_string(name);
    Some(Box::new(
        move |level: Level, category: Category, message: &str| {
            let (category, message) = (c_string(category.name()), c_string(&printf(message)));
            // SAFETY: the logger is the importer's own, valid as long as the instance; all texts end with NUL and outlive
            // the call; the message holds no printf directive, so no further argument is read.
            unsafe {
                logger(
                    environment,
                    name.as_ptr(),
                    level as c_int,
                    category.as_ptr(),
                    message.as_ptr(),
                )
            };
        },
    ))
}

/// A sink that calls the importer's logger of FMI 3.0, which takes the text as it is.
#[expect(
    clippy::not_unsafe_ptr_arg_deref,
    reason = "the environment is handed back to the importer and not looked at"
)]
pub fn message_sink(
    logger: Option<fmi3LogMessageCallback>,
    environment: fmi3InstanceEnvironment,
) -> Option<Sink> {
    let logger = logger?;
    Some(Box::new(
        move |level: Level, category: Category, message: &str| {
            let message = c_string(&message.replace('\0', " "));
            let category = c_string(category.name());
            // SAFETY: the logger is the importer's own, valid as long as the instance; both texts end with NUL and
            // outlive the call.
            unsafe {
                logger(
                    environment,
                    level as c_int,
                    category.as_ptr(),
                    message.as_ptr(),
                )
            };
        },
    ))
}

/// A C string; a NUL inside cuts it.
#[must_use]
pub fn c_string(text: &str) -> CString {
    let end = text.find('\0').unwrap_or(text.len());
    CString::new(&text[..end]).unwrap_or_default()
}

/// The importer's arguments in one call of a C function: the standard obliges it to lend what they point to for the length
/// of the call. Who makes one vouches for all pointers that are handed to it, so that there is one such place for each
/// function of the interface.
#[derive(Debug, Clone, Copy)]
pub struct Lent<'call>(PhantomData<&'call mut ()>);

#[expect(
    clippy::not_unsafe_ptr_arg_deref,
    reason = "whoever made the token, which is unsafe, has vouched for the pointers"
)]
impl<'call> Lent<'call> {
    /// For the call that is being served.
    ///
    /// # Safety
    /// `'call` ends with the call. Every pointer that is handed to the methods is null or one that the importer has passed to
    /// this call, or that lies in such memory; behind it there are as many values as the standard says, which nobody writes
    /// meanwhile, or for the places of results, reads or writes.
    #[must_use]
    pub unsafe fn new() -> Self {
        Self(PhantomData)
    }

    /// A text.
    ///
    /// # Errors
    /// Null, or not UTF-8.
    pub fn text(
        self,
        pointer: fmi2String,
        argument: &'static str,
    ) -> Result<&'call str, BadArgument> {
        if pointer.is_null() {
            return Err(null(argument));
        }
        // SAFETY: not null; by the contract of `new` a text that ends with NUL and lives through the call.
        let text = unsafe { CStr::from_ptr(pointer.cast::<c_char>()) };
        text.to_str().map_err(|error| BadArgument {
            argument,
            found: error.to_string(),
            expected: "UTF-8",
        })
    }

    /// An array that is read; of no length it may be null.
    ///
    /// # Errors
    /// Null, misaligned, or longer than memory can be.
    pub fn array<T: Copy>(
        self,
        pointer: *const T,
        length: usize,
        argument: &'static str,
    ) -> Result<&'call [T], BadArgument> {
        if length == 0 {
            return Ok(&[]);
        }
        possible(pointer, length, argument)?;
        // SAFETY: not null, aligned, not too long; by the contract of `new` there are `length` values through the call.
        Ok(unsafe { std::slice::from_raw_parts(pointer, length) })
    }

    /// The places of results, which may hold anything yet.
    ///
    /// # Errors
    /// As [`Self::array`].
    pub fn places<T: Copy>(
        self,
        pointer: *mut T,
        length: usize,
        argument: &'static str,
    ) -> Result<&'call mut [MaybeUninit<T>], BadArgument> {
        if length == 0 {
            return Ok(&mut []);
        }
        possible(pointer, length, argument)?;
        // SAFETY: as in `array`; nobody else uses the places during the call, and nothing is assumed of what they hold.
        Ok(unsafe { std::slice::from_raw_parts_mut(pointer.cast(), length) })
    }

    /// The place of one result.
    ///
    /// # Errors
    /// As [`Self::array`].
    pub fn place<T: Copy>(
        self,
        pointer: *mut T,
        argument: &'static str,
    ) -> Result<&'call mut MaybeUninit<T>, BadArgument> {
        Ok(&mut self.places(pointer, 1, argument)?[0])
    }

    /// One value that the importer has set and that may be replaced.
    ///
    /// # Errors
    /// As [`Self::array`].
    pub fn variable<T: Copy>(
        self,
        pointer: *mut T,
        argument: &'static str,
    ) -> Result<&'call mut T, BadArgument> {
        possible(pointer, 1, argument)?;
        // SAFETY: not null and aligned; by the contract of `new` it points to a value that only this call uses.
        Ok(unsafe { &mut *pointer })
    }
}

/// Whether there can be `length` values at a pointer.
fn possible<T>(
    pointer: *const T,
    length: usize,
    argument: &'static str,
) -> Result<(), BadArgument> {
    if pointer.is_null() {
        return Err(null(argument));
    }
    let refuse = |found: String, expected| BadArgument {
        argument,
        found,
        expected,
    };
    if !pointer.is_aligned() {
        let found = format!("{:#x}", pointer.addr());
        return Err(refuse(found, "an address that fits the type of its values"));
    }
    let bytes = length.checked_mul(size_of::<T>());
    if bytes.is_none_or(|bytes| bytes > isize::MAX.unsigned_abs()) {
        let found = format!("an array of {length} values");
        return Err(refuse(found, "one that fits into memory"));
    }
    Ok(())
}

fn null(argument: &'static str) -> BadArgument {
    BadArgument {
        argument,
        found: "null".to_owned(),
        expected: "a pointer",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tests hand over what lives until their end.
    fn lent<'a>() -> Lent<'a> {
        // SAFETY: all pointers below are null, refused, or of arrays and texts that outlive their use.
        unsafe { Lent::new() }
    }

    #[test]
    fn null_is_refused_unless_nothing_is_read() {
        let nothing: *const f64 = std::ptr::null();
        assert_eq!(lent().array(nothing, 0, "value"), Ok(&[][..]));
        let refused = lent().array(nothing, 2, "value").unwrap_err().to_string();
        assert_eq!(refused, "argument `value` is null, expected a pointer");
        let values = [1.0, 2.0];
        assert_eq!(lent().array(values.as_ptr(), 2, "value"), Ok(&values[..]));
        assert_eq!(lent().text(c"name".as_ptr(), "name"), Ok("name"));
        assert!(lent().text(std::ptr::null(), "name").is_err());
        let text = lent().text(c"\xff".as_ptr(), "name");
        assert!(text.unwrap_err().expected == "UTF-8");
        assert_eq!(c_string("a\0b").as_c_str(), c"a");
    }

    #[test]
    fn pointers_that_no_array_has_are_refused() {
        let mut values = [1.0_f64, 2.0];
        let odd = values.as_ptr().wrapping_byte_add(4);
        let refused = lent().array(odd, 1, "value").unwrap_err();
        assert_eq!(
            refused.expected,
            "an address that fits the type of its values"
        );
        assert!(lent().places(odd.cast_mut(), 1, "value").is_err());
        assert!(lent().variable(odd.cast_mut(), "value").is_err());
        for length in [isize::MAX as usize / 8 + 1, usize::MAX] {
            let refused = lent().array(values.as_ptr(), length, "value").unwrap_err();
            assert_eq!(refused.expected, "one that fits into memory");
            assert!(lent().places(values.as_mut_ptr(), length, "value").is_err());
        }
    }

    #[test]
    fn results_are_written_to_their_places() {
        let mut values = [MaybeUninit::<f64>::uninit(); 2];
        let pointer = values.as_mut_ptr().cast::<f64>();
        let places = lent().places(pointer, 2, "value").unwrap();
        places.write_copy_of_slice(&[1.0, 2.0]);
        lent().place(pointer, "value").unwrap().write(3.0);
        assert_eq!(lent().array(pointer, 2, "value"), Ok(&[3.0, 2.0][..]));
        *lent().variable(pointer, "value").unwrap() += 1.0;
        assert_eq!(lent().array(pointer, 1, "value"), Ok(&[4.0][..]));
    }
}
