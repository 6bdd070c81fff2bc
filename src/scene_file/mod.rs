//! Scene files: [`mod@file`] is the TOML as typed, [`Scene::from_file`] turns it into a validated [`Scene`] in one step.
//!
//! Everything wrong with a scene is reported at once as a [`SceneError`]: line, key path, value found, value
//! allowed. Files that a scene names (meshes, CSV) lie beside or below it and are returned with it.

mod advice;
mod bodies;
mod bonds;
mod build;
mod cell;
mod checks;
mod clumps;
mod cohesion;
mod columns;
mod decode;
mod diagnostic;
mod document;
mod driven;
mod edits;
pub mod file;
mod fitted;
mod frame;
mod identity;
mod keys;
mod loaded;
mod names;
mod overlap;
mod pairs;
mod parameters;
mod quantities;
mod regions;
mod resources;
mod schema;
mod settings;
mod sizes;
mod source_text;
mod sources;
mod spheres;
mod summary;
mod units;
mod values;
mod wording;

use std::path::Path;

pub use diagnostic::{Diagnostic, SceneError};
pub use fitted::Fitted;
pub use loaded::Loaded;
pub use overlap::{Overlap, Overlaps};
pub use resources::Attachment;
pub(crate) use resources::digest;
pub use schema::json_schema;
pub use summary::Summary;

use crate::scene::Scene;

impl Scene {
    /// Reads a scene file; the files it names are looked for in its folder.
    ///
    /// # Errors
    /// All problems of the scene, or the one of reading the file.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Loaded, SceneError> {
        Self::from_file_with(path, &[])
    }

    /// As [`Self::from_file`], with other values of its parameters: the same scene as one whose text has these as their
    /// `default`, its hash included.
    ///
    /// # Errors
    /// As [`Self::from_file`]; parameters that the scene does not have, values outside their bounds.
    pub fn from_file_with(
        path: impl AsRef<Path>,
        values: &[(String, f64)],
    ) -> Result<Loaded, SceneError> {
        let path = path.as_ref();
        let name = path.display().to_string();
        match crate::files::read(path).map(String::from_utf8) {
            Ok(Ok(text)) => {
                let folder = path.parent().unwrap_or(Path::new(""));
                build::load(&name, &text, folder, values)
            }
            Ok(Err(error)) => Err(SceneError::unreadable(
                &name,
                &error.to_string(),
                "save it as UTF-8 text",
            )),
            Err(error) => Err(SceneError::unreadable(
                &name,
                &error.to_string(),
                "check the path and its permissions",
            )),
        }
    }

    /// Reads a scene from its text; `name` is what problems call it, `folder` where the files it names lie.
    ///
    /// # Errors
    /// All problems of the scene.
    pub fn from_toml(name: &str, text: &str, folder: &Path) -> Result<Loaded, SceneError> {
        build::load(name, text, folder, &[])
    }
}
