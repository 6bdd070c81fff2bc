//! A scene as a model: the scene, its variable table and the guid that ties both to a description.

use std::path::Path;
use std::sync::Arc;

use sphere_dda::scene::{Attachment, Scene, SceneError};
use thiserror::Error;

use crate::description;
use crate::variables::Table;

/// Name of the scene file inside `resources/` of an FMU.
pub const SCENE_FILE: &str = "scene.toml";

/// What exporter and instance build from a scene file, each for itself.
#[derive(Debug, Clone)]
pub struct Model {
    /// The scene.
    pub scene: Arc<Scene>,
    /// Its variables.
    pub table: Table,
    /// Fingerprint of scene, table and version.
    pub guid: String,
    /// Text of the scene file.
    pub text: String,
    /// The files it refers to.
    pub files: Vec<Attachment>,
    /// Findings about the scene that do not stop it.
    pub warnings: Vec<String>,
}

impl Model {
    /// Reads a scene file and the files it refers to.
    ///
    /// # Errors
    /// [`ModelError::Scene`] with all problems of the scene, [`ModelError::Description`] if a name cannot be written
    /// to XML.
    pub fn read(path: &Path) -> Result<Self, ModelError> {
        let loaded = Scene::from_file(path).map_err(Box::new)?;
        let table = Table::new(&loaded.scene);
        let guid = description::guid(&loaded.scene, &table)?;
        Ok(Self {
            table,
            guid,
            warnings: loaded
                .warnings
                .iter()
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
    /// A name or title does not fit into XML.
    #[error("model description: {0}; change the name or title in the scene")]
    Description(#[from] sphere_dda_model_description::Error),
}
