//! The guid that ties a description to a library.

use sha2::{Digest, Sha256};

/// A guid in the usual form, `{8-4-4-4-12}` hexadecimal digits: the hash of `parts`.
#[must_use]
pub fn guid(parts: &[&[u8]]) -> String {
    let mut digest = Sha256::new();
    for part in parts {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    let hash = digest.finalize();
    let mut text = String::from("{");
    for (k, byte) in hash.iter().take(16).enumerate() {
        if matches!(k, 4 | 6 | 8 | 10) {
            text.push('-');
        }
        text += &format!("{byte:02x}");
    }
    text + "}"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_guid_has_the_usual_form_and_keeps_its_parts_apart() {
        let one = guid(&[b"ab", b"c"]);
        assert_eq!(one.len(), 38);
        let groups: Vec<usize> = one
            .trim_matches(['{', '}'])
            .split('-')
            .map(str::len)
            .collect();
        assert_eq!(groups, [8, 4, 4, 4, 12]);
        assert_eq!(one, guid(&[b"ab", b"c"]));
        assert_ne!(one, guid(&[b"a", b"bc"]));
    }
}
