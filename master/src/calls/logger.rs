//! Collects the messages of a foreign library.
//!
//! # A variadic callback without C
//!
//! The logger of FMI is variadic, like `printf`, and stable Rust cannot define such a function. The collector is
//! an ordinary function instead. That is sound where the calling convention of a variadic call hands over its
//! arguments as an ordinary call does and lets the caller clean up, which holds for System V x86-64 (the extra
//! count of vector registers in `al` is ignored), System V AArch64 and Windows x64. The first variable argument,
//! if it is a pointer, is there just the next ordinary one: it is read only if the format has `%s` as its one
//! directive, the way most libraries pass a finished text. Apple's AArch64 puts it elsewhere, so there it is
//! never read. Any other format is shown as it is, its arguments left out.

use std::ffi::{CStr, c_char, c_void};
use std::sync::{Mutex, PoisonError};

use crate::status::{RawStatus, Status};

use super::watch::{CallEvent, Message, Watch};

/// A text of the interface.
type Text = *const c_char;

/// Most messages that one instance keeps until they are taken; later ones are counted only.
const CAPACITY: usize = 10_000;
/// Most characters of a message that are kept.
const LONGEST: usize = 10_000;

#[derive(Debug, Default)]
struct Messages {
    kept: Vec<Message>,
    dropped: usize,
}

/// Where the callback puts messages: the `componentEnvironment` of one instance.
#[derive(Debug, Default)]
pub(crate) struct Log {
    messages: Mutex<Messages>,
    /// Name of the instance, which messages of FMI 3.0 do not tell.
    name: String,
    watch: Watch,
}

impl Log {
    pub(crate) fn new(name: &str, watch: Watch) -> Self {
        Self {
            name: name.to_owned(),
            watch,
            ..Self::default()
        }
    }

    /// This function is called next.
    pub(crate) fn calling(&self, function: &str) {
        self.watch.calling(function);
    }

    /// Keeps a message of the library.
    fn collect(&self, mut message: Message) {
        message.text = printable(&message.text);
        self.push(message);
    }

    /// Keeps a message that is printable.
    pub(crate) fn push(&self, message: Message) {
        self.watch.report(|| CallEvent::Logged(message.clone()));
        let mut messages = self.messages.lock().unwrap_or_else(PoisonError::into_inner);
        if messages.kept.len() < CAPACITY {
            messages.kept.push(message);
        } else {
            messages.dropped += 1;
        }
    }

    /// Takes all messages, and how many more there were.
    pub(crate) fn take(&self) -> (Vec<Message>, usize) {
        let mut messages = self.messages.lock().unwrap_or_else(PoisonError::into_inner);
        let taken = std::mem::take(&mut *messages);
        (taken.kept, taken.dropped)
    }

    /// The texts of the last few messages, oldest first; they stay.
    pub(crate) fn tail(&self, count: usize) -> Vec<String> {
        let messages = self.messages.lock().unwrap_or_else(PoisonError::into_inner);
        let first = messages.kept.len().saturating_sub(count);
        let tail = messages.kept.iter().skip(first);
        tail.map(|message| message.text.clone()).collect()
    }
}

/// A text that no terminal obeys, and not a book: control characters are escaped, but for line breaks and tabs.
fn printable(text: &str) -> String {
    let escaped = |c: char| match c {
        '\n' | '\t' => c.to_string(),
        c if c.is_control() => c.escape_default().to_string(),
        c => c.to_string(),
    };
    let mut characters = text.chars();
    let mut kept: String = characters.by_ref().take(LONGEST).map(escaped).collect();
    match characters.count() {
        0 => kept,
        more => {
            kept += &format!(" ... ({more} more characters)");
            kept
        }
    }
}

/// The callback of FMI 3.0, which gets finished texts.
///
/// # Safety
///
/// `environment` is a [`Log`] that outlives the call or NULL, the texts are NUL-terminated or NULL.
pub(crate) unsafe extern "C" fn collect_finished(
    environment: *mut c_void,
    status: RawStatus,
    category: Text,
    message: Text,
) {
    // SAFETY: `environment` is what the importer passed: a `Log`, shared and never mutated but through its mutex.
    let Some(log) = (unsafe { environment.cast::<Log>().as_ref() }) else {
        return;
    };
    // SAFETY: texts of the interface are NUL-terminated.
    let (category, message) = unsafe { (text(category), text(message)) };
    log.collect(Message {
        instance: log.name.clone(),
        status: Status::from_raw(status),
        category,
        text: message.trim_end().to_owned(),
    });
}

/// The callback of FMI 2.0.
///
/// # Safety
///
/// `environment` is a [`Log`] that outlives the call or NULL, the texts are NUL-terminated or NULL, and the
/// variable arguments fit the format.
pub(crate) unsafe extern "C" fn collect(
    environment: *mut c_void,
    instance: Text,
    status: RawStatus,
    category: Text,
    format: Text,
    first: *const c_void,
) {
    // SAFETY: `environment` is what the importer passed: a `Log`, shared and never mutated but through its mutex.
    let Some(log) = (unsafe { environment.cast::<Log>().as_ref() }) else {
        return;
    };
    // SAFETY: texts of the interface are NUL-terminated.
    let format = unsafe { text(format) };
    let text = match sole_text_directive(&format) {
        Some((before, after)) if !cfg!(all(target_vendor = "apple", target_arch = "aarch64")) => {
            // SAFETY: the format promises a text as the first variable argument; see the module's documentation.
            let argument = unsafe { text(first.cast::<c_char>()) };
            format!("{}{argument}{}", unescape(before), unescape(after))
        }
        _ => unescape(&format),
    };
    log.collect(Message {
        // SAFETY: as above.
        instance: unsafe { self::text(instance) },
        status: Status::from_raw(status),
        // SAFETY: as above.
        category: unsafe { self::text(category) },
        text: text.trim_end().to_owned(),
    });
}

/// A copy of a C text; empty for NULL, invalid UTF-8 replaced.
///
/// # Safety
///
/// `text` is NUL-terminated or NULL.
pub(crate) unsafe fn text(text: Text) -> String {
    if text.is_null() {
        return String::new();
    }
    // SAFETY: not NULL, and NUL-terminated by the caller's word.
    unsafe { CStr::from_ptr(text) }
        .to_string_lossy()
        .into_owned()
}

/// What stands before and after `%s`, if that is the only directive.
fn sole_text_directive(format: &str) -> Option<(&str, &str)> {
    let at = first_directive(format)?;
    let after = format.get(at..)?.strip_prefix("%s")?;
    match first_directive(after) {
        Some(_) => None,
        None => Some((format.get(..at)?, after)),
    }
}

/// Where the first `%` stands that is not half of `%%`.
fn first_directive(format: &str) -> Option<usize> {
    let mut at = 0;
    while let Some(found) = format.get(at..)?.find('%') {
        at += found;
        if !format.get(at..)?.starts_with("%%") {
            return Some(at);
        }
        at += 2;
    }
    None
}

fn unescape(format: &str) -> String {
    format.replace("%%", "%")
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, Log, Watch, first_directive, printable, sole_text_directive, unescape};
    use crate::calls::Message;

    #[test]
    fn a_long_message_is_cut() {
        let found = printable(&"ü".repeat(LONGEST + 3));
        assert!(found.ends_with("üü ... (3 more characters)"));
        assert_eq!(printable("short"), "short");
    }

    #[test]
    fn a_terminal_obeys_no_message() {
        let log = Log::new("x", Watch::default());
        log.collect(Message {
            instance: "x".to_owned(),
            status: None,
            category: String::new(),
            text: "\u{1b}[31mred\n\tü".to_owned(),
        });
        assert_eq!(log.tail(1), ["\\u{1b}[31mred\n\tü"]);
    }

    #[test]
    fn directives_of_formats() {
        assert_eq!(first_directive("50%% of %d"), Some(8));
        assert_eq!(first_directive("100%%"), None);
        assert_eq!(first_directive("%"), Some(0));
        assert_eq!(sole_text_directive("%s"), Some(("", "")));
        assert_eq!(sole_text_directive("5%% %s %%"), Some(("5%% ", " %%")));
        assert_eq!(sole_text_directive("%s %d"), None);
        assert_eq!(sole_text_directive("%d %s"), None);
        assert_eq!(sole_text_directive("%-10s"), None);
        assert_eq!(unescape("5 %% of %d"), "5 % of %d");
    }
}
