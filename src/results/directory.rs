//! A run's directory: who may write in it, what lies in it, and what it says about the run.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::Options;
use super::frames::Series;
use super::names::number;
use crate::formats::durable::{DRAFT, replace, sync};
use crate::formats::error::OutputError;
use crate::formats::pvd::is_frame;
use crate::formats::vtu::Precision;
use crate::scene::Scene;

/// How long a process that was just killed may take to let go of its files.
const PATIENCE: Duration = Duration::from_secs(1);

/// A run's directory, in which no other process writes while this lives.
#[derive(Debug)]
pub(crate) struct Directory {
    path: PathBuf,
    /// Held open: the system lets go of the lock when the process ends, however it does.
    _lock: File,
}

impl Directory {
    /// Creates the directory where it is missing, with its parents, and locks it. A file system without locks
    /// gives no protection, but no error either.
    ///
    /// # Errors
    /// [`OutputError::Busy`] if another run writes to it; [`OutputError::Io`].
    pub(crate) fn claim(path: &Path) -> Result<Self, OutputError> {
        Self::claim_within(PATIENCE, path)
    }

    /// As [`Self::claim`], which waits a moment where another run writes, after a longest `wait`.
    ///
    /// # Errors
    /// As [`Self::claim`].
    pub(crate) fn claim_within(wait: Duration, path: &Path) -> Result<Self, OutputError> {
        fs::create_dir_all(path).map_err(OutputError::io("create", path))?;
        let name = path.join(".lock");
        // What another program keeps in a file of this name stays.
        let mut options = File::options();
        options.write(true).create(true).truncate(false);
        let lock = options
            .open(&name)
            .map_err(OutputError::io("create", &name))?;
        let began = Instant::now();
        while let Err(fs::TryLockError::WouldBlock) = lock.try_lock() {
            if began.elapsed() >= wait {
                return Err(OutputError::Busy {
                    path: path.to_path_buf(),
                });
            }
            std::thread::sleep(PATIENCE / 50);
        }
        Ok(Self {
            path: path.to_path_buf(),
            _lock: lock,
        })
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Whether the run that `about` describes lies here, or an earlier end of it; false if there is none.
    ///
    /// # Errors
    /// [`OutputError::OtherRun`], [`OutputError::Io`]; [`OutputError::Changed`] if `run.json` is no JSON.
    pub(crate) fn holds(&self, about: &Value) -> Result<bool, OutputError> {
        let path = self.path.join(ABOUT);
        let text = match fs::read(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
            text => text.map_err(OutputError::io("read", &path))?,
        };
        // Both from text, so that numbers are rounded alike.
        let values = serde_json::from_slice::<Value>(&text)
            .and_then(|found| Ok((found, about.to_string().parse::<Value>()?)));
        let (found, expected) = values.map_err(|error| OutputError::Changed {
            path,
            found: error.to_string(),
            expected: "the description of a run".to_owned(),
        })?;
        let differences = differences(&found, &expected);
        if differences.is_empty() {
            return Ok(true);
        }
        Err(OutputError::OtherRun {
            path: self.path.clone(),
            differences: differences.join("; "),
        })
    }

    /// The content of one of the files.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn read(&self, name: &str) -> Result<Vec<u8>, OutputError> {
        let path = self.path.join(name);
        fs::read(&path).map_err(OutputError::io("read", &path))
    }

    /// Writes `run.json`.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn describe(&self, about: &Value) -> Result<(), OutputError> {
        let path = self.path.join(ABOUT);
        let text = serde_json::to_vec_pretty(about)
            .map_err(|error| OutputError::io("describe the run in", &path)(error.into()))?;
        replace(&path, &text)
    }

    /// Refuses a directory that holds a run.
    ///
    /// # Errors
    /// [`OutputError::Exists`], [`OutputError::Io`].
    pub(crate) fn expect_empty(&self) -> Result<(), OutputError> {
        // Drafts are what a run leaves that was killed before it wrote anything.
        match self
            .names()?
            .into_iter()
            .find(|name| !name.ends_with(DRAFT))
        {
            Some(found) => Err(OutputError::Exists {
                path: self.path.clone(),
                found,
            }),
            None => Ok(()),
        }
    }

    /// Removes the files of an earlier run for the one that `about` describes; files of other names stay.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn clear(&self, about: &Value) -> Result<(), OutputError> {
        // A run killed in here must neither be resumed from the old run's checkpoints, nor be taken for the old run,
        // nor leave a collection that lists frames which are gone: they go first, in this order.
        let (checkpoints, others): (Vec<String>, _) = self
            .names()?
            .into_iter()
            .partition(|name| number(name).is_some());
        let (collections, others): (Vec<String>, Vec<String>) = others
            .into_iter()
            .filter(|name| !name.starts_with(ABOUT))
            .partition(|name| name.ends_with(".pvd"));
        self.remove(&checkpoints)?;
        self.describe(about)?;
        self.remove(&collections)?;
        self.remove(&others)
    }

    /// Removes frames that none of the `listed` names is, and drafts: what a killed run leaves.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn sweep(&self, listed: &[&str]) -> Result<(), OutputError> {
        let mut loose = self.names()?;
        loose.retain(|name| {
            let frame = name.ends_with(".vtu") && !listed.contains(&name.as_str());
            frame || name.ends_with(DRAFT)
        });
        self.remove(&loose)
    }

    /// Removes files.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn remove(&self, names: &[String]) -> Result<(), OutputError> {
        if names.is_empty() {
            return Ok(());
        }
        for name in names {
            let path = self.path.join(name);
            fs::remove_file(&path).map_err(OutputError::io("remove", &path))?;
        }
        self.sync()
    }

    /// Waits until names that were added, replaced or removed have reached the disk.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn sync(&self) -> Result<(), OutputError> {
        // Elsewhere directories cannot be opened; renaming is all there is.
        if cfg!(unix) { sync(&self.path) } else { Ok(()) }
    }

    /// Names of the files of a run that lie here, sorted.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(crate) fn names(&self) -> Result<Vec<String>, OutputError> {
        let list = |entries: fs::ReadDir| -> io::Result<Vec<String>> {
            let mut names = Vec::new();
            for entry in entries {
                let entry = entry?;
                if !entry.file_type()?.is_dir() {
                    names.push(entry.file_name().to_string_lossy().into_owned());
                }
            }
            Ok(names)
        };
        let mut names = fs::read_dir(&self.path)
            .and_then(list)
            .map_err(OutputError::io("list", &self.path))?;
        names.retain(|name| is_result(name));
        names.sort();
        Ok(names)
    }
}

/// The file that says what the run is.
const ABOUT: &str = "run.json";

/// The page of `sphere-dda view`: an old one must not stay beside a new run.
const PAGE: &str = "view.html";

/// Whether a file name is one of those a run writes, or is written of it.
fn is_result(name: &str) -> bool {
    let name = name.strip_suffix(DRAFT).unwrap_or(name);
    let of_series = |name: &str| {
        Series::ALL.iter().any(|series| {
            let series = series.name();
            is_frame(name, series) || name.strip_prefix(series) == Some(".pvd")
        })
    };
    matches!(name, ABOUT | "history.csv" | "view.py" | PAGE)
        || number(name).is_some()
        || of_series(name)
}

/// What `run.json` says about a run.
pub(crate) fn about(scene: &Scene, options: &Options) -> Value {
    json!({
        "generator": env!("CARGO_PKG_NAME"),
        "version": env!("CARGO_PKG_VERSION"),
        "title": scene.title,
        "scene_hash": scene.hash,
        "spheres": scene.particles.len(),
        "materials": scene.materials.iter().map(|m| &m.name).collect::<Vec<_>>(),
        "boundaries": scene.boundaries.iter().map(|b| &b.name).collect::<Vec<_>>(),
        "settings": scene.settings,
        "output": {
            "frame_interval": options.frame_interval,
            "row_interval": options.row_interval,
            "float64": options.precision == Precision::Double,
        },
    })
}

/// In what a run differs from the one that is to go on with it, one entry per key. A later end is no difference, nor are
/// other threads.
fn differences(found: &Value, expected: &Value) -> Vec<String> {
    const HASH: &str = "scene_hash";
    if found[HASH] != expected[HASH] {
        // Everything else follows from the scene.
        let change = difference(HASH, &found[HASH], &expected[HASH]);
        return vec![format!(
            "{change} (the scene or a file it names has changed)"
        )];
    }
    let mut list = Vec::new();
    compare("", found, expected, &mut list);
    list
}

fn compare(key: &str, found: &Value, expected: &Value, list: &mut Vec<String>) {
    let none = serde_json::Map::new();
    match (found, expected) {
        (Value::Object(_), Value::Object(_)) => {
            let [found, expected] = [found, expected].map(|v| v.as_object().unwrap_or(&none));
            let others = expected.keys().filter(|name| !found.contains_key(*name));
            for name in found.keys().chain(others) {
                let [a, b] = [found, expected].map(|v| v.get(name).unwrap_or(&Value::Null));
                let path = if key.is_empty() {
                    name.clone()
                } else {
                    format!("{key}.{name}")
                };
                compare(&path, a, b, list);
            }
        }
        _ if key == "settings.threads" => {}
        _ if key == "settings.duration" && found.as_f64() <= expected.as_f64() => {}
        _ if found != expected => list.push(difference(key, found, expected)),
        _ => {}
    }
}

fn difference(key: &str, found: &Value, expected: &Value) -> String {
    format!("{key} is {found}, now {expected}")
}
