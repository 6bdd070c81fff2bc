//! Checkpoints: `checkpoint_000860.state` is the [`crate::formats::snapshot`] of a run after 860 communication steps.
//!
//! One that exists says that all rows and frames up to its time are on the disk: it is written after them, under
//! another name, and gets its own when everything has arrived. No checkpoint is written any more once something of the
//! run could not be: a run that is resumed from the last one writes it anew.

use super::directory::Directory;
use crate::formats::durable::replace_durably;
use crate::formats::error::OutputError;

/// How many are kept while a run goes on, so that a damaged one can be passed over.
pub const KEPT: usize = 3;

/// A state to be written.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// Number of communication steps since t = 0.
    pub number: u64,
    /// The state: [`crate::simulation::Simulation::snapshot`].
    pub snapshot: Vec<u8>,
    /// How many are kept, this one included; older ones are removed.
    pub keep: usize,
}

impl Checkpoint {
    /// Writes the file and removes those that are too many.
    ///
    /// # Errors
    /// [`OutputError::Io`].
    pub(super) fn write(&self, directory: &Directory) -> Result<(), OutputError> {
        replace_durably(&directory.path().join(name(self.number)), &self.snapshot)?;
        directory.sync()?;
        let (_, old) = split(list(directory)?, self.keep);
        directory.remove(&old)
    }
}

fn split(mut names: Vec<String>, at: usize) -> (Vec<String>, Vec<String>) {
    let rest = names.split_off(at.min(names.len()));
    (names, rest)
}

/// Names of the checkpoints in a directory, newest first.
///
/// # Errors
/// [`OutputError::Io`].
pub(super) fn list(directory: &Directory) -> Result<Vec<String>, OutputError> {
    let mut names = directory.names()?;
    names.retain(|name| number(name).is_some());
    names.sort_by_key(|name| std::cmp::Reverse(number(name)));
    Ok(names)
}

/// The number in a checkpoint's name; `None` if it is the name of something else.
pub(super) fn number(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("checkpoint_")?.strip_suffix(".state")?;
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|_| plain)
}

fn name(number: u64) -> String {
    format!("checkpoint_{number:06}.state")
}
