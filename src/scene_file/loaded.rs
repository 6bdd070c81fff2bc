//! What reading a scene file gives.

use super::diagnostic::Diagnostic;
use super::resources::Attachment;
use crate::scene::Scene;

/// A scene with what a package needs to carry it elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// Name of the scene file, as problems call it.
    pub name: String,
    /// Text of the scene file.
    pub text: String,
    /// Files it refers to, sorted by path, each once.
    pub attachments: Vec<Attachment>,
    /// What runs, but probably not as meant.
    pub warnings: Vec<Diagnostic>,
}
