//! What reads damaged input.

mod archive;
mod calls;
mod files;
mod scene;
mod state;
mod xml;

/// Something that reads bytes.
pub(crate) trait Target {
    /// Its name on the command line.
    fn name(&self) -> &'static str;

    /// Sound inputs.
    fn corpus(&self) -> Vec<Vec<u8>>;

    /// Reads `input` and uses what comes of it; whether it was taken.
    fn attempt(&self, input: &[u8]) -> bool;
}

/// All of them.
pub(crate) fn all() -> Vec<Box<dyn Target>> {
    vec![
        Box::new(scene::Scenes),
        Box::new(files::Files),
        Box::new(state::States::default()),
        Box::new(xml::Xml),
        Box::new(archive::Archives),
        Box::new(calls::Calls),
    ]
}
