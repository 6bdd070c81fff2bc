//! Where files are read from: the disk, or those that a host without one was given.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

static HELD: OnceLock<BTreeMap<PathBuf, Vec<u8>>> = OnceLock::new();

/// Gives a host without a disk the files that there are; only the first call counts.
pub fn hold(files: BTreeMap<PathBuf, Vec<u8>>) {
    // The files of a component do not change.
    let _ = HELD.set(files);
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
