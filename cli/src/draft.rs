//! Files that are whole or not there: written under another name first.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file on its way to its name; it is removed where it does not come there: a part of it is of no use.
pub(crate) struct Draft<'p> {
    output: &'p Path,
    path: PathBuf,
    is_put: bool,
}

impl<'p> Draft<'p> {
    /// One for `output`, of the same ending, by which programs choose what they write.
    pub(crate) fn of(output: &'p Path) -> Self {
        let mut ending = OsString::from("part");
        if let Some(own) = output.extension() {
            ending.push(".");
            ending.push(own);
        }
        Self {
            output,
            path: output.with_extension(ending),
            is_put: false,
        }
    }

    /// Where it is written.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Gives the file its name, in the place of what has it.
    ///
    /// # Errors
    /// Those of the system.
    pub(crate) fn put(mut self) -> io::Result<()> {
        fs::rename(&self.path, self.output)?;
        self.is_put = true;
        Ok(())
    }
}

impl Drop for Draft<'_> {
    fn drop(&mut self) {
        if !self.is_put {
            // That it cannot be removed changes nothing.
            let _ = fs::remove_file(&self.path);
        }
    }
}
