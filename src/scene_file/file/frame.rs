//! Gravity as a function of time, and the frame of reference.

use schemars::JsonSchema;
use serde::Deserialize;

use super::Vector;

/// `gravity_motion`: gravity as a function of time, a table with one key.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum GravityMotion {
    /// Its direction turns at constant speed.
    Rotation(Turning),
    /// Piecewise linear in time; then `gravity` is not given.
    Table(GravityTable),
}

/// A direction that turns.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turning {
    /// Axis, any length > 0.
    pub axis: Vector,
    /// Angular speed about it, right hand \[rad/s\].
    pub speed: f64,
}

/// Gravity by a time table, held constant outside: either `csv`, or `time` with `gravity`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GravityTable {
    /// Times \[s\], strictly increasing.
    pub time: Option<Vec<f64>>,
    /// Gravity \[m/s^2\], one per time.
    pub gravity: Option<Vec<Vector>>,
    /// CSV file with columns time \[s\], x, y, z \[m/s^2\].
    pub csv: Option<String>,
}

/// `rotating_frame`: positions, velocities, boundaries and gravity are those seen from a frame that turns about a fixed
/// axis; centrifugal and Coriolis forces act. Gravity that is fixed in the world turns the other way in it.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RotatingFrame {
    /// Axis, any length > 0.
    pub axis: Vector,
    /// Angular speed of the frame about it, right hand \[rad/s\].
    pub speed: f64,
    /// A point of the axis \[m\].
    #[serde(default)]
    pub point: Vector,
}
