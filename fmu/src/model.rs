//! A scene as a model: the scene, its variable table and the guid that ties both to a description.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

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
    /// The scene file.
    path: PathBuf,
    /// The scene before it settled to [`Self::start`].
    unsettled: Arc<Scene>,
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
        let start = match sphere_dda::files::read(&path) {
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
        Self::read_with(path, &[], start)
    }

    /// As [`Self::read`], with other defaults of the scene's parameters.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_with(
        path: &Path,
        values: &[(String, f64)],
        start: Option<Vec<u8>>,
    ) -> Result<Self, ModelError> {
        let mut loaded = Scene::from_file_with(path, values).map_err(Box::new)?;
        let mut unsettled = None;
        if let Some(start) = &start {
            unsettled = Some(Arc::new(loaded.scene.clone()));
            loaded.scene.start_from(start)?;
        }
        let scene = Arc::new(loaded.scene);
        let table = Table::new(&scene)?;
        if let Some(name) = table.repeated() {
            return Err(ModelError::Name(name.to_owned()));
        }
        // One for both versions, so that a saved state of one is a state of the other. States hold settings: where these have
        // another field, the model is another.
        let layout = postcard::to_stdvec(&(&table, Settings::default()))?;
        let guid = guid(&[VERSION.as_bytes(), scene.hash.as_bytes(), &layout]);
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
            path: path.to_path_buf(),
            unsettled: unsettled.unwrap_or_else(|| Arc::clone(&scene)),
            scene,
            text: loaded.text,
            files: loaded.attachments,
        })
    }

    /// The scene with `values` of its parameters, in their order: read anew from its file, so that it is the scene whose text
    /// has these values.
    ///
    /// # Errors
    /// [`ModelError::Scene`]; [`ModelError::Shape`] if its variables would be others; [`ModelError::Settled`] if the model has a
    /// start that would not be one of this scene.
    pub fn scene_with(&self, values: &[f64]) -> Result<Arc<Scene>, ModelError> {
        let parameters = self.scene.parameters.iter().zip(values);
        let changed = parameters.filter(|(own, value)| own.value != **value);
        let changed: Vec<(String, f64)> = changed
            .map(|(own, value)| (own.name.clone(), *value))
            .collect();
        if changed.is_empty() {
            return Ok(Arc::clone(&self.scene));
        }
        let mut scene = Scene::from_file_with(&self.path, &changed)
            .map_err(Box::new)?
            .scene;
        if !Table::new(&scene)?.is_like(&self.table) {
            return Err(ModelError::Shape {
                set: told(&changed),
                found: scene.particles.len(),
                expected: self.scene.particles.len(),
            });
        }
        if let Some(start) = &self.start {
            let own = self.unsettled.tuned(&scene);
            let same = own.particles == scene.particles
                && own.initial == scene.initial
                && own.cell == scene.cell
                && own.boundaries == scene.boundaries
                && own.springs == scene.springs;
            if !same {
                return Err(ModelError::Settled(told(&changed)));
            }
            scene.start_from_that_of(start, &self.unsettled.hash)?;
        }
        Ok(Arc::new(scene))
    }
}

/// `friction=0.4 count=3`, as a command line sets them.
fn told(values: &[(String, f64)]) -> String {
    let each = values.iter().map(|(name, value)| format!("{name}={value}"));
    each.collect::<Vec<_>>().join(" ")
}

/// Why a scene file makes no model.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The scene is refused.
    #[error("{}", .0.plain())]
    Scene(#[from] Box<SceneError>),
    /// A parameter of the scene is called as another variable is.
    #[error(
        "parameter `{0}`: a variable of every FMU of this scene has the same name; give the parameter another one"
    )]
    Name(String),
    /// Other values of parameters make other variables.
    #[error(
        "with {set} the scene has room for {found} spheres, expected {expected}: the variables of an FMU are fixed; export the \
         scene again with --set"
    )]
    Shape {
        /// The values.
        set: String,
        /// Spheres of the scene with them.
        found: usize,
        /// Spheres of this model.
        expected: usize,
    },
    /// Other values of parameters do not go with the settled start.
    #[error(
        "with {0} the spheres that have settled in this FMU would have other sizes, masses, places or boundaries: export the scene \
         again with --set, so that it settles with these values"
    )]
    Settled(String),
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
