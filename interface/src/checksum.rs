//! SHA-256 of files, in the form of `sha256sum`.

use sha2::{Digest, Sha256};

/// SHA-256 of `content`, 64 hexadecimal digits.
#[must_use]
pub fn sha256(content: &[u8]) -> String {
    let hash = Sha256::digest(content);
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The lines that `sha256sum --check` reads: of each file its checksum and path.
#[must_use]
pub fn lines<'f>(files: impl IntoIterator<Item = (&'f str, &'f [u8])>) -> String {
    let files = files.into_iter();
    files
        .map(|(path, content)| format!("{}  {path}\n", sha256(content)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of FIPS 180-2.
    #[test]
    fn abc_has_its_hash() {
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), expected);
        assert_eq!(lines([("a/b", &b"abc"[..])]), format!("{expected}  a/b\n"));
    }
}
