//! Lexical forms of the XML Schema types that attributes carry.
//!
//! Rust's own `Display` and `FromStr` differ from the schema in small ways that
//! importers notice: infinity is `INF`, a boolean may be `1`, blanks around a
//! number are legal, and `1e300` must not become three hundred digits.

use serde::{Deserialize, Deserializer, Serializer};

/// A value with a lexical form in XML Schema.
pub trait Lexical: Sized {
    /// What the schema calls the type, for messages.
    const EXPECTED: &'static str;

    /// The value of `text`, which has no blanks at its ends.
    fn parse(text: &str) -> Option<Self>;

    /// The canonical text of the value.
    fn print(&self) -> String;
}

impl Lexical for f64 {
    const EXPECTED: &'static str = "a real number (xs:double)";

    fn parse(text: &str) -> Option<Self> {
        match text {
            "INF" | "+INF" => Some(f64::INFINITY),
            "-INF" => Some(f64::NEG_INFINITY),
            "NaN" => Some(f64::NAN),
            // `FromStr` would also take `infinity` and `nan` in any case.
            _ if text.bytes().any(|b| b.is_ascii_digit()) => text.parse().ok(),
            _ => None,
        }
    }

    fn print(&self) -> String {
        if self.is_nan() {
            "NaN".to_owned()
        } else if self.is_infinite() {
            if *self > 0.0 { "INF" } else { "-INF" }.to_owned()
        } else {
            // `Debug` is the shortest text that reads back to the same bits, and
            // unlike `Display` it uses an exponent for very large and small values.
            format!("{self:?}")
        }
    }
}

impl Lexical for bool {
    const EXPECTED: &'static str = "`true`, `false`, `1` or `0` (xs:boolean)";

    fn parse(text: &str) -> Option<Self> {
        match text {
            "true" | "1" => Some(true),
            "false" | "0" => Some(false),
            _ => None,
        }
    }

    fn print(&self) -> String {
        self.to_string()
    }
}

impl Lexical for i32 {
    const EXPECTED: &'static str = "an integer of 32 bits (xs:int)";

    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn print(&self) -> String {
        self.to_string()
    }
}

impl Lexical for i64 {
    const EXPECTED: &'static str = "an integer of 64 bits (xs:long)";

    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn print(&self) -> String {
        self.to_string()
    }
}

impl Lexical for u32 {
    const EXPECTED: &'static str = "an unsigned integer of 32 bits (xs:unsignedInt)";

    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn print(&self) -> String {
        self.to_string()
    }
}

impl Lexical for u64 {
    const EXPECTED: &'static str = "an unsigned integer of 64 bits (xs:unsignedLong)";

    fn parse(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn print(&self) -> String {
        self.to_string()
    }
}

impl Lexical for Vec<u32> {
    const EXPECTED: &'static str = "a list of unsigned integers separated by blanks";

    fn parse(text: &str) -> Option<Self> {
        text.split_ascii_whitespace().map(u32::parse).collect()
    }

    fn print(&self) -> String {
        let items: Vec<String> = self.iter().map(u32::print).collect();
        items.join(" ")
    }
}

/// Writes a required attribute.
pub fn serialize<T: Lexical, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&value.print())
}

/// Reads a required attribute.
pub fn deserialize<'de, T: Lexical, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let text = String::deserialize(deserializer)?;
    let trimmed = text.trim_ascii();
    T::parse(trimmed).ok_or_else(|| {
        let shown: String = trimmed.chars().take(60).collect();
        serde::de::Error::custom(format!("found `{shown}`, expected {}", T::EXPECTED))
    })
}

/// Optional attributes: absent is `None`.
pub mod optional {
    use super::Lexical;
    use serde::{Deserializer, Serializer};

    /// Writes an attribute; the field skips `None` itself.
    pub fn serialize<T: Lexical, S: Serializer>(
        value: &Option<T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        match value {
            Some(value) => super::serialize(value, serializer),
            None => serializer.serialize_none(),
        }
    }

    /// Reads an attribute that is there; serde's `default` covers its absence.
    pub fn deserialize<'de, T: Lexical, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<T>, D::Error> {
        super::deserialize(deserializer).map(Some)
    }
}

/// Whether a flag has the schema's default and need not be written.
pub fn is_false(value: &bool) -> bool {
    !value
}

/// Whether an integer has the schema's default 0 and need not be written.
pub fn is_zero<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

#[cfg(test)]
mod tests {
    use super::Lexical;

    #[test]
    fn doubles_read_back_to_the_same_bits() {
        for value in [
            0.0,
            -0.0,
            0.1,
            1.0 / 3.0,
            1e300,
            5e-324,
            -2.5e-7,
            f64::MAX,
            f64::INFINITY,
        ] {
            let text = value.print();
            let back = f64::parse(&text).map(f64::to_bits);
            assert_eq!(back, Some(value.to_bits()), "{text}");
            assert!(text.len() <= 24, "{text}");
        }
        assert!(f64::parse(&f64::NAN.print()).is_some_and(f64::is_nan));
    }

    #[test]
    fn only_forms_of_the_schema_are_numbers() {
        for text in ["", "inf", "nan", "infinity", "1,5", "0x10", "1.0f"] {
            assert_eq!(f64::parse(text), None, "{text:?}");
        }
        assert_eq!(f64::parse(".5"), Some(0.5));
        assert_eq!(f64::parse("+1.E2"), Some(100.0));
        assert_eq!(bool::parse("True"), None);
        assert_eq!(i32::parse("2147483648"), None);
        assert_eq!(u32::parse("-1"), None);
        assert_eq!(<Vec<u32>>::parse(" 1  2\t3 "), Some(vec![1, 2, 3]));
        assert_eq!(<Vec<u32>>::parse(""), Some(vec![]));
    }
}
