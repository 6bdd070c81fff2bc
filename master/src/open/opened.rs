//! An FMU before its library is loaded: a folder and a model description.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use sphere_dda_model_description::{MAX_BYTES, names};
use tempfile::TempDir;

use crate::error::ImportError;

use super::archive::{self, Limits, Unpacked};
use super::description::Description;

/// Folders of all FMUs that this process has unpacked.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes what all FMUs were unpacked to, for a process that ends without dropping them, by a signal for example. None of them may be
/// used after it.
pub fn remove_unpacked() {
    let mut folders = FOLDERS.lock().unwrap_or_else(PoisonError::into_inner);
    for folder in folders.drain(..) {
        // Most are gone: dropped with their FMU.
        let _gone = fs::remove_dir_all(folder);
    }
}

/// Where an archive is unpacked.
#[derive(Debug)]
pub(crate) enum Folder {
    /// In a folder of this process; removed when this is dropped.
    Own(TempDir),
    /// In one that another process removes.
    OfAnother(PathBuf),
}

impl Folder {
    pub(crate) fn path(&self) -> &Path {
        match self {
            Self::Own(folder) => folder.path(),
            Self::OfAnother(path) => path,
        }
    }
}

/// An unpacked FMU. Its folder is removed when nothing holds it any more.
#[derive(Debug)]
pub(crate) struct Opened {
    pub(crate) path: PathBuf,
    pub(crate) folder: Arc<Folder>,
    /// Size of all its files, unpacked \[byte\].
    pub(crate) bytes: u64,
    pub(crate) description: Description,
}

impl Opened {
    /// Unpacks the archive at `path` and reads its description, which must offer co-simulation.
    pub(crate) fn within(path: &Path, limits: Limits) -> Result<Self, ImportError> {
        let path = path.to_owned();
        let Unpacked { folder, bytes } = match archive::unpack(&path, limits) {
            Ok(unpacked) => unpacked,
            Err(source) => return Err(ImportError::Archive { path, source }),
        };
        FOLDERS
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(folder.path().to_owned());
        Self::read(path, Folder::Own(folder), bytes)
    }

    /// Reads the description of what is unpacked in `folder`, `bytes` in all, from the archive at `path`.
    pub(crate) fn read(path: PathBuf, folder: Folder, bytes: u64) -> Result<Self, ImportError> {
        let text = match text(&folder.path().join("modelDescription.xml")) {
            Ok(text) => text,
            Err(problem) => return Err(ImportError::NoDescription { path, problem }),
        };
        let description = match Description::from_xml(&text) {
            Ok(description) => description,
            Err(source) => return Err(ImportError::Description { path, source }),
        };
        if !description.offers_co_simulation() {
            return Err(ImportError::NoCoSimulation { path });
        }
        if !names::is_c_identifier(description.model_identifier()) {
            let found = description.model_identifier().to_owned();
            return Err(ImportError::ModelIdentifier { path, found });
        }
        Ok(Self {
            path,
            folder: Arc::new(folder),
            bytes,
            description,
        })
    }

    /// The folder of its resources.
    pub(crate) fn resources(&self) -> PathBuf {
        self.folder.path().join("resources")
    }
}

/// The text of a file that is not too long for XML.
pub(crate) fn text(path: &Path) -> io::Result<String> {
    let length = fs::metadata(path)?.len();
    if length > MAX_BYTES as u64 {
        return Err(io::Error::other(format!(
            "found {length} bytes, expected at most {MAX_BYTES}"
        )));
    }
    fs::read_to_string(path)
}
