//! A scene that starts from another state than its file's.

use crate::error::SnapshotError;
use crate::formats::snapshot;
use crate::scene::Scene;
use crate::scene_file::digest;
use crate::state::State;

impl Scene {
    /// Starts from another state of the spheres than the file's: from a [`crate::simulation::Settled::start`], or any
    /// snapshot of this scene, of which placement, velocities and contact forces are taken; driven bodies start at rest where
    /// they were. The hash changes with it.
    ///
    /// # Errors
    /// [`SnapshotError`] if the blob is damaged or belongs to another scene or version; the scene is unchanged.
    pub fn start_from(&mut self, blob: &[u8]) -> Result<(), SnapshotError> {
        let own = self.hash.clone();
        self.start_from_that_of(blob, &own)
    }

    /// As [`Self::start_from`], from the start of the scene with this `hash`, whose spheres and boundaries are the same.
    ///
    /// # Errors
    /// As [`Self::start_from`].
    pub fn start_from_that_of(&mut self, blob: &[u8], hash: &str) -> Result<(), SnapshotError> {
        let state: State = snapshot::restore(blob, hash)?;
        // The state has the velocities of the half step before.
        (_, self.initial) = snapshot::spheres(blob)?;
        let driven: Vec<usize> = self.driven().map(|(b, _)| b).collect();
        self.start_bodies(&state.poses, driven.into_iter().zip(&state.bodies));
        self.initial_contacts = state.contacts;
        self.hash = digest([self.hash.as_bytes(), blob]);
        Ok(())
    }
}
