//! Where files are read from: the disk, or those that a host without one was given.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

static HELD: OnceLock<BTreeMap<PathBuf, Vec<u8>>> = OnceLock::new();

/// Gives a host without a disk the files that there are: the first call asks for them, they do not change.
pub fn hold(files: impl FnOnce() -> BTreeMap<PathBuf, Vec<u8>>) {
    HELD.get_or_init(files);
}

/// Reads a file.
///
/// # Errors
/// Those of the disk; [`io::ErrorKind::NotFound`] of a file that is not [`hold`].
pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    match HELD.get() {
        None => std::fs::read(path),
        Some(files) => files
            .get(path)
            .cloned()
            .ok_or(io::ErrorKind::NotFound.into()),
    }
}
