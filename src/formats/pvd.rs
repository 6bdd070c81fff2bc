//! PVD collections: the list of a series' frames with their times, as ParaView reads it.
//!
//! Paths are relative to the collection's folder, times carry 17 significant digits. A frame is listed once it is complete: its line
//! and the end of the list are written over the end before, in one write. Frames that are dropped replace the file as a whole.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::durable::{replace, sync};
use super::error::OutputError;

const HEAD: &str = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
const TAIL: &str = "</Collection>\n</VTKFile>\n";

/// One frame of a series.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    /// Time \[s\].
    time: f64,
    /// File name, relative to the collection.
    file: String,
}

impl Entry {
    /// Reads back a line of the collection of `series`. Frames are removed by their names, so only names that this
    /// series gives its frames are taken: a list from someone else must not lead to files elsewhere.
    fn parse(line: &str, series: &str) -> Option<Self> {
        let rest = line.strip_prefix("<DataSet timestep=\"")?;
        let (time, rest) = rest.split_once("\" group=\"\" part=\"0\" file=\"")?;
        let file = rest.strip_suffix("\"/>")?;
        is_frame(file, series).then_some(())?;
        Some(Self {
            time: time.parse().ok()?,
            file: file.to_owned(),
        })
    }

    /// As [`Self::parse`] reads it.
    fn line(&self) -> String {
        let Self { time, file } = self;
        format!("<DataSet timestep=\"{time:.16e}\" group=\"\" part=\"0\" file=\"{file}\"/>\n")
    }
}

/// Whether `name` is that of a frame of `series`: `SERIES_DIGITS.vtu`.
pub(crate) fn is_frame(name: &str, series: &str) -> bool {
    name.strip_prefix(series)
        .and_then(|rest| rest.strip_prefix('_')?.strip_suffix(".vtu"))
        .is_some_and(|number| {
            !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
        })
}

/// A series of frames in one folder, times strictly increasing.
#[derive(Debug)]
pub(crate) struct Collection {
    path: PathBuf,
    entries: Vec<Entry>,
    /// Files of the frames written since the last [`Self::sync`].
    fresh: Vec<PathBuf>,
    /// Length of the file as last written \[bytes\]; 0 where that is not known.
    length: u64,
}

impl Collection {
    /// An empty collection that will be written to `path`.
    pub(crate) fn new(path: PathBuf) -> Self {
        Self {
            path,
            entries: Vec::new(),
            fresh: Vec::new(),
            length: 0,
        }
    }

    /// The collection that an earlier process has written to `path`; empty if there is no such file.
    ///
    /// # Errors
    /// [`OutputError::Io`]; [`OutputError::Changed`] if it is not as [`Self::push`] writes it.
    pub(crate) fn open(path: PathBuf) -> Result<Self, OutputError> {
        let text = match fs::read_to_string(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::new(path)),
            text => text.map_err(OutputError::io("read", &path))?,
        };
        let lines = text.strip_prefix(HEAD).and_then(|t| t.strip_suffix(TAIL));
        let series = path.file_stem().and_then(OsStr::to_str).unwrap_or_default();
        let parse = |line| Entry::parse(line, series);
        match lines.and_then(|lines| lines.lines().map(parse).collect()) {
            Some(entries) => Ok(Self {
                entries,
                length: text.len() as u64,
                ..Self::new(path)
            }),
            None => Err(OutputError::Changed {
                path,
                found: "another text".to_owned(),
                expected: "a list of frames as sphere-dda writes it".to_owned(),
            }),
        }
    }

    /// Writes the frame `file` of `time` \[s\] and then the collection. Frames of this or a later time are
    /// dropped first: whoever comes back to an earlier time rewrites history.
    ///
    /// # Errors
    /// [`OutputError::Io`]; the collection on disk then still lists complete frames only.
    pub(crate) fn push(&mut self, time: f64, file: &str, bytes: &[u8]) -> Result<(), OutputError> {
        self.drop_from(|entry| entry.time >= time)?;
        let path = self.folder().join(file);
        replace(&path, bytes)?;
        self.fresh.push(path);
        let entry = Entry {
            time,
            file: file.to_owned(),
        };
        let line = entry.line();
        self.entries.push(entry);
        match self.append(&line) {
            Ok(true) => Ok(()),
            Ok(false) => self.save(),
            Err(error) => Err(OutputError::io("write", &self.path)(error)),
        }
    }

    /// Writes a line over the end of the list; not where the file is not as it was left.
    fn append(&mut self, line: &str) -> io::Result<bool> {
        if self.length == 0 {
            return Ok(false);
        }
        let mut file = match fs::OpenOptions::new().write(true).open(&self.path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
            file => file?,
        };
        if file.metadata()?.len() != self.length {
            return Ok(false);
        }
        let end = self.length - TAIL.len() as u64;
        file.seek(SeekFrom::Start(end))?;
        let text = format!("{line}{TAIL}");
        file.write_all(text.as_bytes())?;
        self.length = end + text.len() as u64;
        Ok(true)
    }

    /// Drops the frames later than `time` \[s\], and their files.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn rollback(&mut self, time: f64) -> Result<(), OutputError> {
        self.drop_from(|entry| entry.time > time)
    }

    /// Waits until all frames and the collection have reached the disk; their names do with their folder's.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn sync(&mut self) -> Result<(), OutputError> {
        for path in std::mem::take(&mut self.fresh) {
            sync(&path)?;
        }
        if self.entries.is_empty() {
            return Ok(());
        }
        sync(&self.path)
    }

    /// Times \[s\] of the frames.
    pub(crate) fn times(&self) -> impl Iterator<Item = f64> {
        self.entries.iter().map(|entry| entry.time)
    }

    /// Names of the frames' files.
    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|entry| entry.file.as_str())
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
        self.fresh
            .retain(|path| !dropped.iter().any(|entry| path.ends_with(&entry.file)));
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

    fn save(&mut self) -> Result<(), OutputError> {
        let lines: String = self.entries.iter().map(Entry::line).collect();
        let text = format!("{HEAD}{lines}{TAIL}");
        replace(&self.path, text.as_bytes())?;
        self.length = text.len() as u64;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fault: names in a collection that lead out of its folder were removed by `--resume`.
    #[test]
    fn a_list_from_someone_else_removes_no_file_elsewhere() {
        let folder = tempfile::tempdir().unwrap();
        let outside = folder.path().join("kept.vtu");
        fs::write(&outside, "kept").unwrap();
        let run = folder.path().join("run");
        fs::create_dir(&run).unwrap();
        let path = run.join("spheres.pvd");
        for name in [
            outside.to_str().unwrap(),
            "../kept.vtu",
            "spheres_/../../kept.vtu",
            "kept.vtu",
        ] {
            let line =
                format!("<DataSet timestep=\"1.0e0\" group=\"\" part=\"0\" file=\"{name}\"/>\n");
            fs::write(&path, format!("{HEAD}{line}{TAIL}")).unwrap();
            let opened = Collection::open(path.clone());
            let refused = matches!(&opened, Err(OutputError::Changed { .. }));
            if let Ok(mut collection) = opened {
                collection.rollback(0.5).unwrap();
            }
            assert!(refused, "{name} was taken");
            assert!(outside.exists(), "{name} removed a file elsewhere");
        }
    }

    #[test]
    fn a_series_reads_back_what_it_wrote() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("spheres.pvd");
        let mut collection = Collection::new(path.clone());
        collection.push(0.0, "spheres_000000.vtu", b"a").unwrap();
        collection.push(0.1, "spheres_000001.vtu", b"b").unwrap();
        let mut again = Collection::open(path).unwrap();
        assert_eq!(again.times().collect::<Vec<_>>(), [0.0, 0.1]);
        again.rollback(0.05).unwrap();
        assert!(!folder.path().join("spheres_000001.vtu").exists());
        assert!(folder.path().join("spheres_000000.vtu").exists());
    }

    /// Fault: every frame wrote the whole list anew. The list appended to is that written as a whole, and one that someone
    /// else has changed is written anew.
    #[test]
    fn a_list_grows_by_its_lines() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("spheres.pvd");
        let mut list = Collection::new(path.clone());
        let frame = |k: usize| format!("spheres_{k:04}.vtu");
        for k in 0..5 {
            list.push(k as f64, &frame(k), b"frame").unwrap();
            let opened = Collection::open(path.clone()).unwrap();
            assert_eq!(opened.entries, list.entries);
            assert_eq!(opened.length, list.length);
        }
        let same_file = || fs::File::open(&path).unwrap();
        let before = same_file();
        list.push(5.0, &frame(5), b"frame").unwrap();
        assert_eq!(before.metadata().unwrap().len(), list.length);
        fs::write(&path, "cut short").unwrap();
        list.push(6.0, &frame(6), b"frame").unwrap();
        assert_eq!(Collection::open(path).unwrap().entries, list.entries);
    }
}
