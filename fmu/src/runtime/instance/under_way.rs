//! A communication step under way.

use sphere_dda::scene::Command;
use sphere_dda::simulation::March;

/// A communication step under way.
pub(super) struct Walk {
    pub(super) march: March,
    pub(super) point: f64,
    pub(super) h: f64,
    pub(super) end: f64,
    /// As they were at its beginning.
    pub(super) commands: Vec<Command>,
}
