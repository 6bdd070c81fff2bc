//! Files that are replaced whole: a reader finds the old one or the new one.

use std::fs::{self, File};
use std::path::Path;

use super::error::OutputError;

/// Ending of a file that is being written.
pub(crate) const DRAFT: &str = ".tmp";

/// Writes `bytes` to `path` such that a reader finds the old file or the whole new one, never a part:
/// `path.tmp` first, then a rename.
///
/// # Errors
/// [`OutputError::Io`].
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    put(path, bytes, |_| Ok(()))
}

/// As [`replace`], and a reader finds one of the two also after a loss of power.
///
/// # Errors
/// [`OutputError::Io`].
pub(crate) fn replace_durably(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    put(path, bytes, sync)
}

fn put(
    path: &Path,
    bytes: &[u8],
    settle: impl Fn(&Path) -> Result<(), OutputError>,
) -> Result<(), OutputError> {
    let mut name = path.as_os_str().to_owned();
    name.push(DRAFT);
    let draft = Path::new(&name);
    fs::write(draft, bytes).map_err(OutputError::io("write", draft))?;
    settle(draft)?;
    fs::rename(draft, path).map_err(OutputError::io("replace", path))
}

/// Waits until what was written to a file, or a directory's list of names, has reached the disk.
///
/// # Errors
/// [`OutputError::Io`].
pub(crate) fn sync(path: &Path) -> Result<(), OutputError> {
    File::open(path)
        .and_then(|file| file.sync_all())
        .map_err(OutputError::io("write", path))
}
