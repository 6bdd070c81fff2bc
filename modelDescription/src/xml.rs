//! XML text to typed data and back, safe against hostile text.
//!
//! An FMU comes from elsewhere, so its description is untrusted. A first pass
//! over the text checks that it is well formed and inside fixed limits; serde
//! sees it only then. No entity is ever expanded: a document type is refused.

use std::num::NonZeroUsize;

use quick_xml::Reader;
use quick_xml::de::Deserializer;
use quick_xml::events::{BytesStart, Event};
use quick_xml::se::Serializer;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Longest text that is read, in bytes. A description of a million scalar
/// variables is about 200 MiB.
pub const MAX_BYTES: usize = 512 << 20;

/// Deepest nesting of elements that is read. The schema needs 5 levels; the rest
/// is for vendor annotations.
pub const MAX_DEPTH: usize = 64;

/// Most attributes of one element that are read. The schema needs 13. Looking
/// for duplicates costs the square of the number.
pub const MAX_ATTRIBUTES: usize = 256;

/// Most XML events skipped between two items of one list. The schema needs none.
const MAX_SKIPPED_EVENTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(1 << 20);

/// Why a description could not be read or written.
///
/// Lines and columns count from 1; a column is a byte.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The text is longer than [`MAX_BYTES`].
    #[error("the text has {found} bytes, expected at most {limit}")]
    TooLarge {
        /// Length of the text, in bytes.
        found: usize,
        /// [`MAX_BYTES`].
        limit: usize,
    },
    /// The text has a document type declaration. It is refused because it can
    /// define entities that grow without bound or read other files.
    #[error("line {line}, column {column}: found a DOCTYPE, expected none")]
    Doctype {
        /// Line of the declaration.
        line: usize,
        /// Column of the declaration.
        column: usize,
    },
    /// The text is not well-formed XML.
    #[error(
        "line {line}, column {column}: not well-formed XML: found {found}, expected {expected}"
    )]
    Malformed {
        /// Line of the fault.
        line: usize,
        /// Column of the fault.
        column: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// Elements are nested deeper than [`MAX_DEPTH`], or one has more attributes
    /// than [`MAX_ATTRIBUTES`].
    #[error(
        "line {line}, column {column}: found more than {limit} {what}, expected at most {limit}"
    )]
    Limit {
        /// Line of the element that goes past the limit.
        line: usize,
        /// Column of that element.
        column: usize,
        /// What there is too much of.
        what: &'static str,
        /// The largest number that is read.
        limit: usize,
    },
    /// The document is not a model description.
    #[error("root element: found `{found}`, expected `{expected}`")]
    Root {
        /// Name of the root element.
        found: String,
        /// Name it should have.
        expected: &'static str,
    },
    /// The description is of another version of the standard.
    #[error("attribute `{attribute}`: found `{found}`, expected `{expected}`")]
    Version {
        /// Name of the attribute.
        attribute: &'static str,
        /// Value of the attribute; empty if it is absent.
        found: String,
        /// The version that is read.
        expected: &'static str,
    },
    /// An element or attribute is missing, stands twice or has a wrong value.
    #[error("line {line}, column {column}, near `{near}`: {problem}")]
    Content {
        /// Line of the tag read last.
        line: usize,
        /// Column of that tag.
        column: usize,
        /// Beginning of that tag.
        near: String,
        /// What is missing, or what was found and what was expected.
        problem: String,
    },
    /// A text of the description has a character that XML cannot carry.
    #[error("near `{near}`: found the character {found:?}, expected one that XML 1.0 allows")]
    Character {
        /// The written text before the character.
        near: String,
        /// The character.
        found: char,
    },
    /// The description could not be turned into XML.
    #[error("writing failed: {problem}")]
    Write {
        /// What the serializer said.
        problem: String,
    },
}

/// Reads the document `root` of the given version.
///
/// # Errors
///
/// Every variant of [`Error`] that is about reading.
pub(crate) fn read<T: DeserializeOwned>(
    text: &str,
    root: &'static str,
    version: &'static str,
) -> Result<T, Error> {
    let expected = Expected {
        root,
        attribute: "fmiVersion",
        version,
    };
    read_expected(text, expected)
}

/// What a document begins with.
#[derive(Debug, Clone, Copy)]
pub struct Expected {
    /// Name of the root element, without prefix.
    pub root: &'static str,
    /// The attribute that tells the version.
    pub attribute: &'static str,
    /// The version that is read; empty: any, also none.
    pub version: &'static str,
}

/// Reads the document that begins as `expected`.
///
/// # Errors
///
/// Every variant of [`Error`] that is about reading.
pub fn read_expected<T: DeserializeOwned>(text: &str, expected: Expected) -> Result<T, Error> {
    if text.len() > MAX_BYTES {
        return Err(Error::TooLarge {
            found: text.len(),
            limit: MAX_BYTES,
        });
    }
    // A byte order mark is legal in front of UTF-8 and common on Windows.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    Scan { text, expected }.run()?;

    let mut deserializer = Deserializer::from_str(text);
    deserializer
        .recursion_limit(MAX_DEPTH)
        .event_buffer_size(Some(MAX_SKIPPED_EVENTS));
    T::deserialize(&mut deserializer).map_err(|error| {
        let end = deserializer.get_ref().get_ref().buffer_position();
        let tag = tag_before(text, usize::try_from(end).unwrap_or(usize::MAX));
        let (line, column) = line_and_column(text, tag);
        Error::Content {
            line,
            column,
            near: excerpt(&text[tag..]),
            problem: error.to_string(),
        }
    })
}

/// Writes `value` as the document `root`, indented by two blanks.
///
/// # Errors
///
/// [`Error::Character`] and [`Error::Write`].
pub fn write<T: Serialize>(value: &T, root: &str) -> Result<String, Error> {
    let failed = |error: quick_xml::SeError| Error::Write {
        problem: error.to_string(),
    };
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let mut serializer = Serializer::with_root(&mut text, Some(root)).map_err(failed)?;
    serializer.indent(' ', 2);
    value.serialize(serializer).map_err(failed)?;
    text.push('\n');
    match forbidden_character(&text) {
        None => Ok(text),
        Some((at, found)) => Err(Error::Character {
            near: ending(&text[tag_before(&text, at)..at]),
            found,
        }),
    }
}

/// The first pass: well-formedness, limits, root and version.
struct Scan<'a> {
    text: &'a str,
    expected: Expected,
}

impl Scan<'_> {
    fn run(&self) -> Result<(), Error> {
        if let Some((at, found)) = forbidden_character(self.text) {
            return Err(self.malformed(at, format!("{found:?}"), "a character of XML 1.0"));
        }
        let mut reader = Reader::from_str(self.text);
        let mut depth = 0_usize;
        let mut seen_root = false;
        loop {
            let at = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
            let event = reader.read_event().map_err(|error| {
                let at = usize::try_from(reader.error_position()).unwrap_or(usize::MAX);
                self.malformed(at, error.to_string(), "well-formed XML")
            })?;
            match event {
                Event::Start(tag) => {
                    self.element(at, &tag, depth, &mut seen_root)?;
                    depth += 1;
                }
                Event::Empty(tag) => {
                    self.element(at, &tag, depth, &mut seen_root)?;
                }
                // The reader itself refuses an end tag that does not match.
                Event::End(_) => depth = depth.saturating_sub(1),
                Event::DocType(_) => {
                    let (line, column) = line_and_column(self.text, at);
                    return Err(Error::Doctype { line, column });
                }
                Event::Text(content) if depth == 0 && content.trim_ascii().is_empty() => {}
                Event::Text(_) | Event::CData(_) | Event::GeneralRef(_) if depth == 0 => {
                    return Err(self.malformed(at, "text".to_owned(), "one root element"));
                }
                Event::Eof if depth > 0 => {
                    return Err(self.malformed(at, "the end of the text".to_owned(), "an end tag"));
                }
                Event::Eof if !seen_root => {
                    return Err(self.malformed(at, "no element".to_owned(), "one root element"));
                }
                Event::Eof => return Ok(()),
                _ => {}
            }
        }
    }

    fn element(
        &self,
        at: usize,
        tag: &BytesStart<'_>,
        depth: usize,
        seen_root: &mut bool,
    ) -> Result<(), Error> {
        let Expected {
            root,
            attribute: version_attribute,
            version,
        } = self.expected;
        if depth >= MAX_DEPTH {
            return Err(self.limit(at, "nested elements", MAX_DEPTH));
        }
        let mut found_version = None;
        for (count, attribute) in tag.attributes().enumerate() {
            if count >= MAX_ATTRIBUTES {
                return Err(self.limit(at, "attributes of one element", MAX_ATTRIBUTES));
            }
            let attribute =
                attribute.map_err(|error| self.malformed(at, error.to_string(), "attributes"))?;
            if depth == 0 && attribute.key.as_ref() == version_attribute {
                found_version = Some(attribute.value.into_owned());
            }
        }
        if depth > 0 {
            return Ok(());
        }
        if *seen_root {
            return Err(self.malformed(at, "a second root".to_owned(), "one root element"));
        }
        *seen_root = true;
        let name = tag.local_name();
        if name.as_ref() != root {
            return Err(Error::Root {
                found: excerpt(name.as_ref()),
                expected: root,
            });
        }
        match found_version {
            _ if version.is_empty() => Ok(()),
            Some(found) if is_release_of(found.trim_ascii(), version) => Ok(()),
            found => Err(Error::Version {
                attribute: version_attribute,
                found: excerpt(&found.unwrap_or_default()),
                expected: version,
            }),
        }
    }

    fn malformed(&self, at: usize, found: String, expected: &str) -> Error {
        let (line, column) = line_and_column(self.text, at);
        Error::Malformed {
            line,
            column,
            found,
            expected: expected.to_owned(),
        }
    }

    fn limit(&self, at: usize, what: &'static str, limit: usize) -> Error {
        let (line, column) = line_and_column(self.text, at);
        Error::Limit {
            line,
            column,
            what,
            limit,
        }
    }
}

/// Whether `found` is the version or a patch release of it, as `3.0.2` is of `3.0`.
pub(crate) fn is_release_of(found: &str, version: &str) -> bool {
    match found.strip_prefix(version) {
        Some("") => true,
        Some(rest) => rest.strip_prefix('.').is_some_and(|patch| {
            !patch.is_empty() && patch.bytes().all(|digit| digit.is_ascii_digit())
        }),
        None => false,
    }
}

/// The first character that XML 1.0 does not allow, with its byte offset.
fn forbidden_character(text: &str) -> Option<(usize, char)> {
    text.char_indices().find(|(_, character)| {
        matches!(character, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}')
            || matches!(character, '\u{fffe}' | '\u{ffff}')
    })
}

/// Byte offset of the last `<` before `end`, 0 if there is none.
fn tag_before(text: &str, end: usize) -> usize {
    let end = end.min(text.len());
    text.as_bytes()[..end]
        .iter()
        .rposition(|&byte| byte == b'<')
        .unwrap_or(0)
}

/// Line and column, from 1, of a byte offset.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text.as_bytes()[..offset.min(text.len())];
    let line_start = before
        .iter()
        .rposition(|&byte| byte == b'\n')
        .map_or(0, |at| at + 1);
    let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
    (line, 1 + before.len() - line_start)
}

/// Most characters of the text that a message shows.
const LENGTH: usize = 100;

/// The last characters of `text`, for a message.
fn ending(text: &str) -> String {
    let start = text.char_indices().rev().take(LENGTH).last();
    text[start.map_or(0, |(at, _)| at)..].to_owned()
}

/// The first characters of `text` on one line, for a message.
fn excerpt(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    let mut shown: String = line.chars().take(LENGTH).collect();
    if shown.len() < line.len() {
        shown.push('…');
    }
    shown
}
