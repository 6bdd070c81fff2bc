//! PVD collections: the list of a series' frames with their times, as ParaView reads it.
//!
//! Paths are relative to the collection's folder, times carry 17 significant digits. The file is replaced as a
//! whole after each change, so it only ever lists frames that are complete.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::error::OutputError;
use super::vtu::replace;

/// One frame of a series.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    /// Time \[s\].
    time: f64,
    /// File name, relative to the collection.
    file: String,
}

/// A series of frames in one folder, times strictly increasing.
#[derive(Debug)]
pub struct Collection {
    path: PathBuf,
    entries: Vec<Entry>,
}

impl Collection {
    /// An empty collection that will be written to `path`.
    #[must_use]
    pub fn new(path: PathBuf) -> Self {
        Self {
            path,
            entries: Vec::new(),
        }
    }

    /// Writes the frame `file` of `time` \[s\] and then the collection. Frames of this or a later time are
    /// dropped first: whoever comes back to an earlier time rewrites history.
    ///
    /// # Errors
    /// [`OutputError::Io`]; the collection on disk then still lists complete frames only.
    pub fn push(&mut self, time: f64, file: &str, bytes: &[u8]) -> Result<(), OutputError> {
        self.drop_from(|entry| entry.time >= time)?;
        replace(&self.folder().join(file), bytes)?;
        self.entries.push(Entry {
            time,
            file: file.to_owned(),
        });
        self.save()
    }

    /// Drops the frames later than `time` \[s\], and their files.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        self.drop_from(|entry| entry.time > time)
    }

    /// Number of frames listed.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether no frame is listed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    fn drop_from(&mut self, late: impl Fn(&Entry) -> bool) -> Result<(), OutputError> {
        let kept = self.entries.partition_point(|entry| !late(entry));
        if kept == self.entries.len() {
            return Ok(());
        }
        let dropped = self.entries.split_off(kept);
        // The list first: a run killed in between leaves unlisted files, not dangling names.
        self.save()?;
        for entry in dropped {
            let path = self.folder().join(entry.file);
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(OutputError::io("remove", &path)(error));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn save(&self) -> Result<(), OutputError> {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
        );
        for Entry { time, file } in &self.entries {
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "<DataSet timestep=\"{time:.16e}\" group=\"\" part=\"0\" file=\"{file}\"/>"
            );
        }
        text.push_str("</Collection>\n</VTKFile>\n");
        replace(&self.path, text.as_bytes())
    }
}
