//! Unpacks the archive of a foreign FMU into a folder of its own, trusting nothing in it.

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use tempfile::TempDir;
use zip::ZipArchive;
use zip::read::ZipFile;
use zip::result::ZipError;

use crate::error::ArchiveError;

/// What an archive may ask of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Most entries, files and folders.
    pub entries: usize,
    /// Most bytes of all files together, unpacked.
    pub bytes: u64,
    /// Greatest ratio of unpacked to packed size, judged once [`RATIO_FLOOR`] bytes are unpacked.
    pub ratio: u64,
}

/// Unpacked size \[byte\] below which no ratio is suspicious: a small file of zeros packs very well.
pub const RATIO_FLOOR: u64 = 64 << 20;

impl Default for Limits {
    /// 50,000 entries, 4 GiB, ratio 100: far above real FMUs (deflate packs libraries and text by 2 to 30).
    fn default() -> Self {
        Self {
            entries: 50_000,
            bytes: 4 << 30,
            ratio: 100,
        }
    }
}

/// What became of an archive.
pub(crate) struct Unpacked {
    /// Where it is now; removed when this is dropped.
    pub(crate) folder: TempDir,
    /// Size of all files together \[byte\].
    pub(crate) bytes: u64,
}

/// Unpacks `path` into a new folder.
///
/// # Errors
///
/// Every variant of [`ArchiveError`].
pub(crate) fn unpack(path: &Path, limits: Limits) -> Result<Unpacked, ArchiveError> {
    let file = File::open(path).map_err(ArchiveError::Open)?;
    let packed = file.metadata().map_err(ArchiveError::Open)?.len();
    let mut archive = ZipArchive::new(io::BufReader::new(file)).map_err(in_archive)?;
    if archive.len() > limits.entries {
        return Err(ArchiveError::Limit {
            what: "entries",
            limit: limits.entries as u64,
        });
    }
    // Some packers add a folder twice.
    let agree = !archive.has_duplicate_names() || {
        let start = archive.central_directory_start();
        names_agree(path, start).map_err(ArchiveError::Open)?
    };
    if !agree || archive.has_overlapping_files().map_err(in_archive)? {
        return Err(ArchiveError::Overlap);
    }
    let folder = TempDir::with_prefix("fmu-").map_err(at(&std::env::temp_dir()))?;
    let mut budget = Budget {
        limits,
        packed,
        unpacked: 0,
    };
    for index in 0..archive.len() {
        let entry = archive.by_index(index).map_err(in_archive)?;
        unpack_entry(entry, folder.path(), &mut budget)?;
    }
    Ok(Unpacked {
        folder,
        bytes: budget.unpacked,
    })
}

fn at(path: &Path) -> impl Fn(io::Error) -> ArchiveError {
    let path = path.to_owned();
    move |source| ArchiveError::Io {
        path: path.clone(),
        source,
    }
}

/// Whether entries of one name have one content, by their sizes and checksums in the central directory, which begins at `start`.
fn names_agree(path: &Path, start: u64) -> io::Result<bool> {
    const SIGNATURE: [u8; 4] = *b"PK\x01\x02";
    const CONTENT: std::ops::Range<usize> = 16..28;
    const NAME_LENGTH: usize = 28;
    let mut file = io::BufReader::new(File::open(path)?);
    file.seek(SeekFrom::Start(start))?;
    let mut contents: HashMap<Vec<u8>, Vec<u8>> = HashMap::new();
    let mut header = [0; 46];
    loop {
        match file.read_exact(&mut header) {
            Ok(()) if header.starts_with(&SIGNATURE) => {}
            _ => return Ok(true),
        }
        let length = |at: usize| u16::from_le_bytes([header[at], header[at + 1]]);
        let [name, extra, comment] = [0, 2, 4].map(|k| length(NAME_LENGTH + k));
        let mut text = vec![0; usize::from(name)];
        file.read_exact(&mut text)?;
        file.seek_relative(i64::from(extra) + i64::from(comment))?;
        let content = header[CONTENT].to_vec();
        if contents
            .insert(text, content.clone())
            .is_some_and(|known| known != content)
        {
            return Ok(false);
        }
    }
}

fn in_archive(source: ZipError) -> ArchiveError {
    ArchiveError::Zip {
        place: "archive".to_owned(),
        source,
    }
}

/// Writes a file or folder below `folder`.
fn unpack_entry<R: Read>(
    mut entry: ZipFile<'_, R>,
    folder: &Path,
    budget: &mut Budget,
) -> Result<(), ArchiveError> {
    let raw = String::from_utf8_lossy(entry.name_raw()).into_owned();
    if entry.is_symlink() {
        return Err(ArchiveError::SymbolicLink { name: raw });
    }
    let Some(relative) = inner_path(&raw) else {
        return Err(ArchiveError::Escape { name: raw });
    };
    let target = folder.join(relative);
    if entry.is_dir() || raw.ends_with('\\') {
        return fs::create_dir_all(&target).map_err(at(&target));
    }
    if let Some(parent) = target.parent() {
        fs::create_dir_all(parent).map_err(at(parent))?;
    }
    let mut out = File::create_new(&target).map_err(at(&target))?;
    // A declared size can lie: what counts is what comes out.
    let most = budget.left().saturating_add(1);
    let copied = io::copy(&mut entry.by_ref().take(most), &mut out);
    budget.take(copied.map_err(|source| match source.raw_os_error() {
        Some(_) => at(&target)(source),
        None => ArchiveError::Zip {
            place: format!("entry {raw:?}"),
            source: ZipError::Io(source),
        },
    })?)
}

struct Budget {
    limits: Limits,
    packed: u64,
    unpacked: u64,
}

impl Budget {
    /// Largest total \[byte\] that the ratio allows.
    fn by_ratio(&self) -> u64 {
        self.packed
            .saturating_mul(self.limits.ratio)
            .max(RATIO_FLOOR)
    }

    fn left(&self) -> u64 {
        self.limits.bytes.min(self.by_ratio()) - self.unpacked
    }

    fn take(&mut self, bytes: u64) -> Result<(), ArchiveError> {
        let total = self.unpacked.saturating_add(bytes);
        if total > self.limits.bytes {
            return Err(ArchiveError::Limit {
                what: "bytes unpacked",
                limit: self.limits.bytes,
            });
        }
        if total > self.by_ratio() {
            return Err(ArchiveError::Limit {
                what: "unpacked bytes per packed byte",
                limit: self.limits.ratio,
            });
        }
        self.unpacked = total;
        Ok(())
    }
}

/// The entry's path below the archive, or `None` if it would leave it, on this system or another.
pub(crate) fn inner_path(name: &str) -> Option<PathBuf> {
    let absolute = name.starts_with(['/', '\\']);
    let forbidden = name.contains(['\0', ':']);
    if name.is_empty() || absolute || forbidden {
        return None;
    }
    // Some packers on Windows write backslashes.
    let mut path = PathBuf::new();
    for part in name.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => return None,
            part => path.push(part),
        }
    }
    Some(path)
}

#[cfg(test)]
mod tests {
    use super::inner_path;
    use std::path::PathBuf;

    #[test]
    fn paths_stay_inside() {
        for (name, path) in [
            ("modelDescription.xml", "modelDescription.xml"),
            ("binaries/linux64/a.so", "binaries/linux64/a.so"),
            ("binaries\\win64\\a.dll", "binaries/win64/a.dll"),
            ("./resources//x", "resources/x"),
            ("resources/a..b", "resources/a..b"),
        ] {
            assert_eq!(inner_path(name), Some(PathBuf::from(path)), "{name}");
        }
        for name in [
            "",
            "/etc/passwd",
            "\\windows\\x",
            "../x",
            "a/../../x",
            "a\\..\\..\\x",
            "C:\\x",
            "C:x",
            "resources/x:stream",
            "a\0b",
        ] {
            assert_eq!(inner_path(name), None, "{name:?}");
        }
    }
}
