//! Names: the structured naming convention and C identifiers.
//!
//! The grammar is that of FMI 2.0, section 2.2.9, unchanged in FMI 3.0:
//!
//! ```text
//! name            = identifier | "der(" identifier [ "," unsignedInteger ] ")"
//! identifier      = B-name [ arrayIndices ] { "." B-name [ arrayIndices ] }
//! B-name          = nondigit { digit | nondigit } | Q-name
//! Q-name          = "'" ( Q-char | escape ) { Q-char | escape } "'"
//! arrayIndices    = "[" unsignedInteger { "," unsignedInteger } "]"
//! ```

use thiserror::Error;

/// Where and why a name is not a structured name.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
#[error("byte {offset} of the name: found {found}, expected {expected}")]
pub struct NameError {
    /// Byte offset in the name, from 0.
    pub offset: usize,
    /// What stands there.
    pub found: String,
    /// What the grammar allows there.
    pub expected: &'static str,
}

/// Checks `name` against the grammar of structured names.
///
/// # Errors
///
/// [`NameError`] at the first byte that the grammar does not allow.
///
/// # Example
///
/// ```
/// use sphere_dda_model_description::names::check_structured;
///
/// assert!(check_structured("boundary.'gate #2'.force[1]").is_ok());
/// assert!(check_structured("der(pipe[3,4].T[14],2)").is_ok());
/// assert!(check_structured("pipe[3, 4]").is_err());
/// ```
pub fn check_structured(name: &str) -> Result<(), NameError> {
    let mut parser = Parser {
        text: name.as_bytes(),
        at: 0,
    };
    if name.starts_with("der(") {
        parser.at = "der(".len();
        parser.identifier()?;
        if parser.take(b',') {
            parser.unsigned_integer()?;
        }
        if !parser.take(b')') {
            return Err(parser.error("`,` and an order, or `)`"));
        }
    } else {
        parser.identifier()?;
    }
    if parser.at < parser.text.len() {
        return Err(parser.error("`.`, `[`, a letter, a digit, `_` or the end"));
    }
    Ok(())
}

/// Whether `text` is a C identifier: a letter or `_`, then letters, digits, `_`.
pub fn is_c_identifier(text: &str) -> bool {
    text.bytes().next().is_some_and(is_nondigit)
        && text
            .bytes()
            .all(|byte| is_nondigit(byte) || byte.is_ascii_digit())
}

fn is_nondigit(byte: u8) -> bool {
    byte == b'_' || byte.is_ascii_alphabetic()
}

struct Parser<'a> {
    text: &'a [u8],
    at: usize,
}

impl Parser<'_> {
    fn identifier(&mut self) -> Result<(), NameError> {
        loop {
            self.base_name()?;
            if self.take(b'[') {
                self.array_indices()?;
            }
            if !self.take(b'.') {
                return Ok(());
            }
        }
    }

    fn base_name(&mut self) -> Result<(), NameError> {
        if self.take(b'\'') {
            return self.quoted_name();
        }
        if !self.peek().is_some_and(is_nondigit) {
            return Err(self.error("a letter, `_` or a quoted name"));
        }
        while self
            .peek()
            .is_some_and(|b| is_nondigit(b) || b.is_ascii_digit())
        {
            self.at += 1;
        }
        Ok(())
    }

    /// What follows the opening quote.
    fn quoted_name(&mut self) -> Result<(), NameError> {
        let start = self.at;
        loop {
            match self.peek() {
                Some(b'\'') if self.at > start => {
                    self.at += 1;
                    return Ok(());
                }
                Some(b'\\') => {
                    self.at += 1;
                    match self.peek() {
                        Some(
                            b'\'' | b'"' | b'?' | b'\\' | b'a' | b'b' | b'f' | b'n' | b'r' | b't'
                            | b'v',
                        ) => self.at += 1,
                        _ => return Err(self.error("an escaped character of C")),
                    }
                }
                // The grammar lists all printable ASCII but `'`, `"`, `\` and `` ` ``.
                Some(b' '..=b'~') if !matches!(self.peek(), Some(b'\'' | b'"' | b'`')) => {
                    self.at += 1;
                }
                _ => return Err(self.error("a character allowed in quotes, or `'` after one")),
            }
        }
    }

    /// What follows the opening bracket.
    fn array_indices(&mut self) -> Result<(), NameError> {
        loop {
            self.unsigned_integer()?;
            if self.take(b']') {
                return Ok(());
            }
            if !self.take(b',') {
                return Err(self.error("a digit, `,` or `]`"));
            }
        }
    }

    fn unsigned_integer(&mut self) -> Result<(), NameError> {
        if !self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            return Err(self.error("a digit"));
        }
        while self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        Ok(())
    }

    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    fn error(&self, expected: &'static str) -> NameError {
        let found = match self.peek() {
            None => "the end".to_owned(),
            Some(byte) if byte.is_ascii() => format!("{:?}", char::from(byte)),
            Some(_) => "a character beyond ASCII".to_owned(),
        };
        NameError {
            offset: self.at,
            found,
            expected,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{check_structured, is_c_identifier};

    #[test]
    fn legal_structured_names() {
        for name in [
            "x",
            "_x1",
            "vehicle.engine.speed",
            "v_minrobot.axis.'motor #234'",
            "der(pipe[3,4].T[14],2)",
            "der(x)",
            "der.x",
            "derivative",
            "a.b.mod[3,4].'#123'.c",
            "rpms[0]",
            r"'it\'s'",
            r"'\\'",
            "'x'[1].y",
        ] {
            assert_eq!(check_structured(name), Ok(()), "{name}");
        }
    }

    #[test]
    fn illegal_structured_names() {
        for (name, offset) in [
            ("", 0),
            ("1x", 0),
            ("a b", 1),
            ("a..b", 2),
            ("a.", 2),
            (".a", 0),
            ("a[]", 2),
            ("a[1, 2]", 4),
            ("a[1", 3),
            ("a[-1]", 2),
            ("a[1]b", 4),
            ("''", 1),
            ("'a", 2),
            (r"'\x'", 2),
            ("'a\"b'", 2),
            ("'a`b'", 2),
            ("der(x", 5),
            ("der(x,)", 6),
            ("der(der(x))", 7),
            ("der(x).y", 6),
            ("größe", 2),
            ("'größe'", 3),
            ("a-b", 1),
        ] {
            let error = check_structured(name).expect_err(name);
            assert_eq!(error.offset, offset, "{name}: {error}");
        }
    }

    #[test]
    fn c_identifiers() {
        for text in ["a", "_", "A_1", "sphere_dda"] {
            assert!(is_c_identifier(text), "{text}");
        }
        for text in ["", "1a", "a-b", "a.b", "ä"] {
            assert!(!is_c_identifier(text), "{text}");
        }
    }
}
