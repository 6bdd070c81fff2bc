//! A communication step under way.

use sphere_dda::Vec3;
use sphere_dda::scene::{Command, CommandDerivatives};
use sphere_dda::simulation::CommunicationStep;

/// A communication step under way.
pub(super) struct StepInProgress {
    pub(super) communication: CommunicationStep,
    pub(super) point: f64,
    pub(super) h: f64,
    pub(super) end: f64,
    /// As they were at its beginning.
    pub(super) commands: Vec<Command>,
    /// Likewise.
    pub(super) rates: Vec<CommandDerivatives>,
    /// Likewise.
    pub(super) forces: Vec<Vec3>,
}
