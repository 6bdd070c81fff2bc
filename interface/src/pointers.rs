//! Pointers from C: null is refused, all else is taken at the importer's word.
//!
//! The functions are safe to call only from a function of the C interface, with arguments that the importer has just
//! passed: the standard obliges it to lend what it points to for the length of the call.

#![expect(
    clippy::not_unsafe_ptr_arg_deref,
    reason = "the C boundary itself: what C passes can only be believed, and an unsafe block at every argument would say no more"
)]

use std::any::Any;
use std::ffi::{CStr, CString, c_char, c_int};

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

/// The message of a panic.
#[must_use]
pub fn panic_text(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    owned
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("panic without a message")
}

/// A C string; a NUL inside cuts it.
#[must_use]
pub fn c_string(text: &str) -> CString {
    let end = text.find('\0').unwrap_or(text.len());
    CString::new(&text[..end]).unwrap_or_default()
}

/// A text from C.
///
/// # Errors
/// Null, or not UTF-8.
pub fn str_from<'a>(pointer: fmi2String, argument: &'static str) -> Result<&'a str, BadArgument> {
    if pointer.is_null() {
        return Err(null(argument));
    }
    // SAFETY: not null; the importer passes a NUL-terminated text that lives through the call.
    let text = unsafe { CStr::from_ptr(pointer.cast::<c_char>()) };
    text.to_str().map_err(|error| BadArgument {
        argument,
        found: error.to_string(),
        expected: "UTF-8",
    })
}

/// An array from C; of no length it may be null.
///
/// # Errors
/// Null.
pub fn array<'a, T>(
    pointer: *const T,
    length: usize,
    argument: &'static str,
) -> Result<&'a [T], BadArgument> {
    match (pointer.is_null(), length) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(null(argument)),
        // SAFETY: not null; the importer passes `length` values that live through the call.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts(pointer, length) }),
    }
}

/// An array of C that is written.
///
/// # Errors
/// Null.
pub fn array_mut<'a, T>(
    pointer: *mut T,
    length: usize,
    argument: &'static str,
) -> Result<&'a mut [T], BadArgument> {
    match (pointer.is_null(), length) {
        (_, 0) => Ok(&mut []),
        (true, _) => Err(null(argument)),
        // SAFETY: not null; the importer lends `length` values through the call and reads none of them meanwhile.
        (false, _) => Ok(unsafe { std::slice::from_raw_parts_mut(pointer, length) }),
    }
}

/// One value of C that is written.
///
/// # Errors
/// Null.
pub fn value_mut<'a, T>(pointer: *mut T, argument: &'static str) -> Result<&'a mut T, BadArgument> {
    Ok(&mut array_mut(pointer, 1, argument)?[0])
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

    #[test]
    fn null_is_refused_unless_nothing_is_read() {
        let nothing: *const f64 = std::ptr::null();
        assert_eq!(array(nothing, 0, "value"), Ok(&[][..]));
        let refused = array(nothing, 2, "value").unwrap_err().to_string();
        assert_eq!(refused, "argument `value` is null, expected a pointer");
        assert_eq!(array([1.0, 2.0].as_ptr(), 2, "value"), Ok(&[1.0, 2.0][..]));
        assert_eq!(str_from(c"name".as_ptr(), "name"), Ok("name"));
        assert!(str_from(std::ptr::null(), "name").is_err());
        assert!(str_from(c"\xff".as_ptr(), "name").unwrap_err().expected == "UTF-8");
        assert_eq!(c_string("a\0b").as_c_str(), c"a");
    }
}
