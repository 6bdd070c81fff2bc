//! What reading a scene file gives.

use super::diagnostic::Diagnostic;
use super::fitted::Fitted;
use super::resources::Attachment;
use super::source_text::SourceText;
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
    /// Clumps whose spheres were fitted to a mesh.
    pub fitted: Vec<Fitted>,
    /// What runs, but probably not as meant.
    pub warnings: Vec<Diagnostic>,
}

impl Loaded {
    /// The warnings with the places in the text that they point at.
    pub fn reports(&self) -> impl Iterator<Item = miette::Report> {
        self.warnings.iter().map(|warning| {
            let source = SourceText::new(&self.name, self.text.clone());
            miette::Report::new(warning.clone()).with_source_code(source)
        })
    }
}
