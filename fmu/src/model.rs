//! A scene as a model: the scene, its variable table and the guid that ties both to a description.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::{fs, io};

use sphere_dda::error::SnapshotError;
use sphere_dda::scene::{Scene, Settings};
use sphere_dda::scene_file::{Attachment, SceneError};
use sphere_dda_fmi_interface::guid::guid;
use thiserror::Error;

use crate::table::{Table, UnknownOutputs};
use crate::version::VERSION;

/// Name of the scene file inside `resources/` of an FMU.
pub const SCENE_FILE: &str = "scene.toml";

/// Name of the settled start inside `resources/` of an FMU.
pub const START_FILE: &str = "start.state";

/// What exporter and instance build from a scene file, each for itself.
#[derive(Debug, Clone)]
pub struct Model {
    /// The scene.
    pub scene: Arc<Scene>,
    /// Its variables.
    pub table: Arc<Table>,
    /// Fingerprint of version, scene and variables, which is also the instantiation token of FMI 3.0.
    pub guid: String,
    /// Text of the scene file.
    pub text: String,
    /// The files it refers to.
    pub files: Vec<Attachment>,
    /// What the scene starts from instead of its own placement.
    pub start: Option<Vec<u8>>,
    /// Findings about the scene that do not stop it.
    pub warnings: Vec<String>,
}

impl Model {
    /// Reads the folder `resources` of an FMU.
    ///
    /// # Errors
    /// As [`Self::read`], and [`ModelError::Unreadable`].
    pub fn of_resources(resources: &Path) -> Result<Self, ModelError> {
        let path = resources.join(START_FILE);
        let start = match fs::read(&path) {
            Ok(start) => Some(start),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(source) => return Err(ModelError::Unreadable { path, source }),
        };
        Self::read(&resources.join(SCENE_FILE), start)
    }

    /// Reads a scene file and the files it refers to; the scene starts from `start`, if it is given.
    ///
    /// # Errors
    /// [`ModelError::Scene`] with all problems of the scene, [`ModelError::Start`] if the start belongs to another scene.
    pub fn read(path: &Path, start: Option<Vec<u8>>) -> Result<Self, ModelError> {
        let mut loaded = Scene::from_file(path).map_err(Box::new)?;
        if let Some(start) = &start {
            loaded.scene.start_from(start)?;
        }
        let table = Table::new(&loaded.scene)?;
        // One for both versions, so that a saved state of one is a state of the other. States hold settings: where these have
        // another field, the model is another.
        let layout = postcard::to_stdvec(&(&table, Settings::default()))?;
        let guid = guid(&[VERSION.as_bytes(), loaded.scene.hash.as_bytes(), &layout]);
        Ok(Self {
            table: Arc::new(table),
            guid,
            start,
            warnings: loaded
                .warnings
                .iter()
                .filter(|problem| problem.is_warning())
                .map(|problem| problem.plain(&loaded.name))
                .collect(),
            scene: Arc::new(loaded.scene),
            text: loaded.text,
            files: loaded.attachments,
        })
    }
}

/// Why a scene file makes no model.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The scene is refused.
    #[error("{}", .0.plain())]
    Scene(#[from] Box<SceneError>),
    /// The start does not fit the scene.
    #[error("settled start: {0}; export the scene again")]
    Start(#[from] SnapshotError),
    /// The start cannot be read.
    #[error("cannot read `{}`: {source}; unpack the FMU again", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// The scene names outputs that there are not.
    #[error(transparent)]
    Outputs(#[from] UnknownOutputs),
    /// The variables cannot be hashed.
    #[error("variables: {0}; this is a fault of sphere-dda")]
    Variables(#[from] postcard::Error),
}
