//! Bytes as text in UTF-8, seven bits to a byte where base64 has six: after K. Albertson's base122.
//!
//! ```text
//! seven bits   the character of this number, from the highest bit on; the last is filled up with zeros
//! 0, 13, 60    what HTML changes or reads as markup: U+0080 + 128 k + the next seven bits, k the place in this list;
//!              at the end U+0080 + 128 (k + 3)
//! ```

/// Numbers whose characters cannot stand in a page.
const BARRED: [u8; 3] = [0, b'\r', b'<'];

/// Bytes as numbers below 128.
fn sevens(bytes: &[u8]) -> impl Iterator<Item = u8> {
    (0..(8 * bytes.len()).div_ceil(7)).map(|k| {
        let (at, shift) = (7 * k / 8, 7 * k % 8);
        let next = bytes.get(at + 1).copied().unwrap_or(0);
        ((u16::from_be_bytes([bytes[at], next]) << shift) >> 9) as u8
    })
}

/// Code points of the text.
fn codes(bytes: &[u8]) -> impl Iterator<Item = u32> {
    let mut rest = sevens(bytes);
    std::iter::from_fn(move || {
        let own = rest.next()?;
        let place = (0..).zip(BARRED).find(|(_, barred)| *barred == own);
        Some(match (place, place.and_then(|_| rest.next())) {
            (None, _) => own.into(),
            (Some((k, _)), Some(next)) => 128 + 128 * k + u32::from(next),
            (Some((k, _)), None) => 128 + 128 * (k + 3),
        })
    })
}

/// Appends the text of some bytes.
pub(super) fn put(out: &mut String, bytes: &[u8]) {
    // All are characters: they end far below the surrogates.
    out.extend(codes(bytes).filter_map(char::from_u32));
}

/// Bytes that the text takes.
pub(super) fn length(bytes: &[u8]) -> u64 {
    codes(bytes).map(|code| 1 + u64::from(code >= 128)).sum()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// What the page does, in `data.js`.
    fn back(text: &str) -> Vec<u8> {
        let mut sevens = Vec::new();
        for code in text.chars().map(u32::from) {
            if code < 128 {
                sevens.push(code);
                continue;
            }
            let k = code / 128 - 1;
            sevens.push(BARRED[k as usize % 3].into());
            sevens.extend((k < 3).then_some(code % 128));
        }
        let mut out = Vec::new();
        let (mut held, mut bits) = (0_u32, 0);
        for seven in sevens {
            (held, bits) = (held << 7 | seven, bits + 7);
            if bits >= 8 {
                bits -= 8;
                out.push((held >> bits) as u8);
            }
        }
        out
    }

    proptest! {
        #[test]
        fn bytes_come_back(bytes in proptest::collection::vec(prop_oneof![any::<u8>(), Just(0), Just(13), Just(60)], 0..300)) {
            let mut text = String::new();
            put(&mut text, &bytes);
            prop_assert_eq!(back(&text), &bytes[..]);
            prop_assert_eq!(text.len() as u64, length(&bytes));
            prop_assert!(!text.contains(['\0', '\r', '<']));
            prop_assert!(text.len() <= (8 * bytes.len()).div_ceil(7) + 1);
        }
    }
}
