//! Reads back a result folder: what [`super::writer`] has written, also while it still writes.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;
use thiserror::Error;

use super::frames::{Series, Surface, frame};
use crate::formats::error::OutputError;
use crate::formats::pvd::Collection;
use crate::formats::vtu::{Contents, VtuError, decode_contents};
use crate::observe::Observation;

/// Why a result folder is not read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FolderError {
    /// There is nothing of that name, or no folder.
    #[error("`{}` is no folder; expected the folder of `sphere-dda run SCENE -o FOLDER`", path.display())]
    NoFolder {
        /// The path.
        path: PathBuf,
    },
    /// A folder of something else.
    #[error(
        "`{}` is no result folder: found no `{missing}`, expected the folder of `sphere-dda run SCENE -o FOLDER`{hint}", path.display()
    )]
    Other {
        /// The folder.
        path: PathBuf,
        /// The file that a run writes.
        missing: &'static str,
        /// Where the results may be instead; empty, or a clause.
        hint: String,
    },
    /// A run that writes no frames.
    #[error(
        "`{}` has no frames: expected `vtu_interval` in the scene's [output] to be greater than 0 and the run to have begun", path.display()
    )]
    Empty {
        /// The folder.
        path: PathBuf,
    },
    /// A list of frames that no run wrote.
    #[error(transparent)]
    List(#[from] OutputError),
    /// A file cannot be read.
    #[error("cannot read `{}`: {source}; check the file and its permissions", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: io::Error,
    },
    /// `run.json` is damaged.
    #[error("`{}` is no JSON: {source}; restore it, or run the scene again", path.display())]
    About {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: serde_json::Error,
    },
    /// A frame is damaged.
    #[error("frame `{}`: {source}; restore it, or run the scene again", path.display())]
    Frame {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: VtuError,
    },
}

/// The grids of one time; a series without anything to show is absent.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Frame {
    /// Time \[s\].
    pub time: f64,
    /// See [`super::frames`] for the arrays of each.
    pub spheres: Option<Contents>,
    /// Contacts that carry a force or overlap.
    pub contacts: Option<Contents>,
    /// Triangles of the boundaries.
    pub boundaries: Option<Contents>,
    /// Triangles of the clumps that show their meshes.
    pub clumps: Option<Contents>,
}

impl Frame {
    /// The present state of a simulation as a frame.
    #[must_use]
    pub fn of(state: &Observation, surface: &Surface) -> Self {
        let mut out = Self {
            time: state.time,
            ..Self::default()
        };
        for (series, grid) in frame(state, surface) {
            *out.of_series(series) = Some(Contents::from(&grid));
        }
        out
    }

    fn of_series(&mut self, series: Series) -> &mut Option<Contents> {
        match series {
            Series::Spheres => &mut self.spheres,
            Series::Contacts => &mut self.contacts,
            Series::Boundaries => &mut self.boundaries,
            Series::Clumps => &mut self.clumps,
        }
    }
}

/// A result folder and its frames.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    about: Value,
    times: Vec<f64>,
    series: Vec<(Series, Vec<String>)>,
}

impl Folder {
    /// Opens a folder and lists the frames that all its series have.
    ///
    /// # Errors
    /// [`FolderError`].
    pub fn open(path: &Path) -> Result<Self, FolderError> {
        let owned = || path.to_path_buf();
        if !path.is_dir() {
            return Err(FolderError::NoFolder { path: owned() });
        }
        let other = |missing| FolderError::Other {
            path: owned(),
            missing,
            hint: hint(path),
        };
        let name = path.join("run.json");
        let text = fs::read(&name).map_err(|source| match source.kind() {
            io::ErrorKind::NotFound => other("run.json"),
            _ => FolderError::Unreadable {
                path: name.clone(),
                source,
            },
        })?;
        let about = serde_json::from_slice(&text)
            .map_err(|source| FolderError::About { path: name, source })?;
        let mut times: Option<Vec<f64>> = None;
        let mut series = Vec::new();
        for one in Series::ALL {
            let list = path.join(format!("{}.pvd", one.name()));
            if !list.exists() {
                continue;
            }
            let list = Collection::open(list)?;
            let own: Vec<f64> = list.times().collect();
            // A run that goes on may have written one more of one series than of another.
            times = Some(match times {
                None => own,
                Some(known) => {
                    let shared = known.iter().zip(&own).take_while(|(a, b)| a == b).count();
                    known[..shared].to_vec()
                }
            });
            series.push((one, list.files().map(str::to_owned).collect()));
        }
        let times = times.unwrap_or_default();
        if times.is_empty() {
            return Err(FolderError::Empty { path: owned() });
        }
        Ok(Self {
            path: owned(),
            about,
            times,
            series,
        })
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// `run.json`.
    #[must_use]
    pub fn about(&self) -> &Value {
        &self.about
    }

    /// Times \[s\] of the frames, ascending, at least one.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The history's file, if there is one.
    #[must_use]
    pub fn history(&self) -> Option<PathBuf> {
        let path = self.path.join("history.csv");
        path.exists().then_some(path)
    }

    /// Reads frame `index` of [`Self::times`].
    ///
    /// # Errors
    /// [`FolderError::Unreadable`], [`FolderError::Frame`].
    pub fn frame(&self, index: usize) -> Result<Frame, FolderError> {
        let mut out = Frame {
            time: self.times[index],
            ..Frame::default()
        };
        for (series, files) in &self.series {
            let path = self.path.join(&files[index]);
            let bytes = fs::read(&path).map_err(|source| FolderError::Unreadable {
                path: path.clone(),
                source,
            })?;
            let contents =
                decode_contents(&bytes).map_err(|source| FolderError::Frame { path, source })?;
            *out.of_series(*series) = Some(contents);
        }
        Ok(out)
    }
}

/// Where the results may be that were looked for here: an FMU writes into a folder below that of its parameter.
fn hint(path: &Path) -> String {
    let below = fs::read_dir(path).into_iter().flatten().flatten();
    let mut found: Vec<PathBuf> = below
        .map(|entry| entry.path())
        .filter(|path| path.join("run.json").exists())
        .collect();
    found.sort();
    match found.first() {
        Some(found) => format!("; `{}` is one", found.display()),
        None => String::new(),
    }
}
