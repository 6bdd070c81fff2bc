//! Start files: a settled start, kept so that the next run of the same scene need not settle again.
//!
//! ```text
//! bytes      what
//! 0..8       magic "SPHSTRT\n"
//! 8..12      format version, little endian as all numbers
//! 12..76     hash of the scene and of how it settled, hexadecimal
//! 76..84     length of the start
//! 84..       the start: crate::formats::snapshot
//!            CRC-32 of all before
//! ```

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::formats::durable::{replace_durably, sync};
use crate::formats::error::OutputError;
use crate::formats::snapshot;
use crate::scene::Scene;
use crate::scene_file::digest;
use crate::simulation::Settle;

const MAGIC: &[u8; 8] = b"SPHSTRT\n";
const VERSION: u32 = 1;
const HASH: usize = 64;
const HEADER: usize = MAGIC.len() + 4 + HASH + 8;

/// A settled start and what it belongs to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StartFile {
    /// Hash of the scene and of how it settled, [`StartFile::hash`].
    pub hash: String,
    /// The start: [`crate::simulation::Settled::start`].
    pub start: Vec<u8>,
}

/// A start file that cannot be used.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum StartFileError {
    /// There is none.
    #[error(
        "no start file `{}`; let the scene settle into it once: add --settle SECONDS or --until-rest", path.display()
    )]
    Missing {
        /// The file.
        path: PathBuf,
    },
    /// The operating system refused.
    #[error("cannot read start file `{}`: {source}; check the path and its permissions", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: io::Error,
    },
    /// Something else lies there.
    #[error(
        "`{}` is no start file: it does not begin as every start file does; choose another name, it is left as it is", path.display()
    )]
    Other {
        /// The file.
        path: PathBuf,
    },
    /// It was one.
    #[error("start file `{}` is damaged: {what}; remove it and settle anew", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        what: &'static str,
    },
    /// It is of another format.
    #[error(
        "start file `{}` has format {found}, this version of sphere-dda reads {VERSION}: remove it and settle anew", path.display()
    )]
    Version {
        /// The file.
        path: PathBuf,
        /// What it says.
        found: u32,
    },
}

impl StartFile {
    /// Hash of `scene`, its settings but for duration, solver and threads, and of how it settles: what a start depends on. 64
    /// hexadecimal digits.
    #[must_use]
    pub fn hash(scene: &Scene, settle: Settle) -> String {
        let mut settings = scene.settings.clone();
        settings.duration = 0.0;
        settings.solver = crate::solver::SolverKind::default();
        settings.threads = 1;
        // Postcard fails only when its buffer is too small; a Vec grows.
        let settings = postcard::to_allocvec(&settings).unwrap_or_default();
        digest([
            scene.hash.as_bytes(),
            &settings,
            &settle.time.to_le_bytes(),
            &[u8::from(settle.until_rest)],
            &snapshot::VERSION.to_le_bytes(),
        ])
    }

    /// Reads a start file.
    ///
    /// # Errors
    /// [`StartFileError`]: [`StartFileError::Missing`] if there is none.
    pub fn read(path: &Path) -> Result<Self, StartFileError> {
        let path_buf = || path.to_path_buf();
        let bytes = std::fs::read(path).map_err(|source| match source.kind() {
            io::ErrorKind::NotFound => StartFileError::Missing { path: path_buf() },
            _ => StartFileError::Unreadable {
                path: path_buf(),
                source,
            },
        })?;
        let damaged = |what| StartFileError::Damaged {
            path: path_buf(),
            what,
        };
        let cut = || damaged("it is cut short");
        let rest = bytes
            .strip_prefix(MAGIC)
            .ok_or_else(|| StartFileError::Other { path: path_buf() })?;
        let (version, rest) = rest.split_first_chunk().ok_or_else(cut)?;
        let found = u32::from_le_bytes(*version);
        if found != VERSION {
            return Err(StartFileError::Version {
                path: path_buf(),
                found,
            });
        }
        let (hash, rest) = rest.split_first_chunk::<HASH>().ok_or_else(cut)?;
        let (length, rest) = rest.split_first_chunk().ok_or_else(cut)?;
        let (start, checksum) = usize::try_from(u64::from_le_bytes(*length))
            .ok()
            .and_then(|length| rest.split_at_checked(length))
            .ok_or_else(cut)?;
        if checksum.len() < size_of::<u32>() {
            return Err(cut());
        }
        let sum = crc32fast::hash(&bytes[..HEADER + start.len()]);
        if checksum != sum.to_le_bytes() {
            return Err(damaged("its checksum does not match"));
        }
        Ok(Self {
            hash: String::from_utf8_lossy(hash).into_owned(),
            start: start.to_vec(),
        })
    }

    /// Writes the file; a reader finds the old one or the whole new one.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub fn write(&self, path: &Path) -> Result<(), OutputError> {
        let mut bytes = Vec::with_capacity(HEADER + self.start.len() + size_of::<u32>());
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&VERSION.to_le_bytes());
        let digits = self.hash.bytes().chain(std::iter::repeat(b' '));
        bytes.extend(digits.take(HASH));
        bytes.extend_from_slice(&(self.start.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&self.start);
        let checksum = crc32fast::hash(&bytes);
        bytes.extend_from_slice(&checksum.to_le_bytes());
        replace_durably(path, &bytes)?;
        let folder = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty());
        // Elsewhere directories cannot be opened; renaming is all there is.
        match cfg!(unix) {
            true => sync(folder.unwrap_or(Path::new("."))),
            false => Ok(()),
        }
    }
}
