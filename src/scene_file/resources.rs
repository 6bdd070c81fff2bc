//! Files a scene refers to: read below the scene's folder only, and remembered, so that a package can carry
//! them and the scene's hash covers them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Component, Path, PathBuf};

use sha2::{Digest, Sha256};

/// A file a scene refers to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Attachment {
    /// Path from the scene's folder, with forward slashes and without `.` and `..`.
    pub path: String,
    /// Its bytes when the scene was read.
    pub content: Vec<u8>,
}

/// The files read so far.
pub(super) struct Resources<'a> {
    folder: &'a Path,
    files: BTreeMap<String, Vec<u8>>,
}

impl<'a> Resources<'a> {
    pub(super) fn new(folder: &'a Path) -> Self {
        Self {
            folder,
            files: BTreeMap::new(),
        }
    }

    /// Reads `file` and gives its normal name, or says what is wrong and what helps.
    pub(super) fn load(&mut self, file: &str) -> Result<String, (String, &'static str)> {
        let name = inside(file).ok_or_else(|| {
            (
                format!("found `{file}`, expected a relative path below the scene's folder"),
                "put the file in the folder of the scene, so that both are copied together",
            )
        })?;
        if !self.files.contains_key(&name) {
            let place = self.folder.join(&name);
            let content = crate::files::read(&place).map_err(|error| {
                let message = format!("cannot read `{}`: {error}", place.display());
                (message, "paths count from the folder of the scene file")
            })?;
            self.files.insert(name.clone(), content);
        }
        Ok(name)
    }

    /// The content of a file by its normal name.
    pub(super) fn get(&self, name: &str) -> Option<&[u8]> {
        self.files.get(name).map(Vec::as_slice)
    }

    /// Where `file` lies on disk.
    pub(super) fn place(&self, file: &str) -> PathBuf {
        self.folder.join(file)
    }

    pub(super) fn into_attachments(self) -> Vec<Attachment> {
        let files = self.files.into_iter();
        files
            .map(|(path, content)| Attachment { path, content })
            .collect()
    }
}

/// The normal form of a relative path that does not leave its folder.
fn inside(file: &str) -> Option<String> {
    let mut parts = Vec::new();
    for component in Path::new(file).components() {
        match component {
            Component::Normal(part) => parts.push(part.to_str()?),
            Component::CurDir => {}
            _ => return None,
        }
    }
    (!parts.is_empty()).then(|| parts.join("/"))
}

/// SHA-256 of the parts, 64 hexadecimal digits: each is preceded by its length, so that no two lists of parts share
/// their bytes.
pub(crate) fn digest<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> String {
    let mut digest = Sha256::new();
    for part in parts {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    let bytes = digest.finalize();
    bytes
        .iter()
        .fold(String::with_capacity(64), |mut hex, byte| {
            // Writing to a String cannot fail.
            let _ = write!(hex, "{byte:02x}");
            hex
        })
}
