//! Errors and outcomes of the solver.

use thiserror::Error;

/// Evidence for a step that could not be taken.
#[derive(Debug, Clone, PartialEq, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum StepError {
    /// The tolerances were not reached, also after the step had been cut as often as allowed.
    #[error(
        "step from t = {time} s, dt = {step:e} s: {what} {} stays above {tolerance:e} at {contact} after {cuts} cuts{broken}; \
         loosen tolerance.{what}, or remove `strict = true` to take the best iterate and go on",
        size(*residual)
    )]
    NotConverged {
        /// Start of the step \[s\].
        time: f64,
        /// Last step tried \[s\].
        step: f64,
        /// Which residual: `gap`, `slip` or `force`.
        what: &'static str,
        /// Its value \[-\]; not a number where contacts come and go until the passes end.
        residual: f64,
        /// What was asked for \[-\].
        tolerance: f64,
        /// The worst contact, in words.
        contact: String,
        /// How often the step was halved.
        cuts: u32,
        /// The linear system that ended the solver early, in words; empty if none did.
        broken: Box<str>,
    },
    /// A sphere is squeezed between boundaries whose motion is prescribed.
    #[error(
        "step from t = {time} s: sphere {sphere} is squeezed between {boundaries}; \
         give one of them `stiffness` (N/m) or drive it by force"
    )]
    Pinched {
        /// Start of the step \[s\].
        time: f64,
        /// Sphere index.
        sphere: usize,
        /// The boundaries, in words.
        boundaries: String,
    },
    /// Two bodies would pass through each other within a step.
    #[error(
        "step from t = {time} s, dt = {step:e} s: {contact} move {motion:.2} radii against each other and would pass or miss a contact \
         after {cuts} cuts; reduce simulation.step to {advised:e} s or raise simulation.max_cuts"
    )]
    TooFast {
        /// Start of the step \[s\].
        time: f64,
        /// Last step tried \[s\].
        step: f64,
        /// The pair, in words.
        contact: String,
        /// Relative motion over the smaller radius in that step \[-\].
        motion: f64,
        /// A step in which they move half a radius \[s\].
        advised: f64,
        /// How often the step was halved.
        cuts: u32,
    },
    /// A commanded boundary would jump.
    #[error(
        "input of boundary `{boundary}` moves it by {jump:e} m in one internal step; at most the smallest radius {limit:e} m is allowed: \
         use a smaller communication step or a smoother command"
    )]
    Jump {
        /// Boundary name.
        boundary: String,
        /// Largest displacement per internal step \[m\].
        jump: f64,
        /// Limit \[m\].
        limit: f64,
    },
    /// A commanded orientation is no rotation.
    #[error(
        "boundary.{boundary}.targetOrientation: found {found:.4?} of length {length:.3}, expected a unit quaternion w, x, y, z \
         (length 0.99 to 1.01): divide it by its length; in a table that is interpolated, keep its sign from row to row"
    )]
    Orientation {
        /// Boundary name.
        boundary: String,
        /// The quaternion w, x, y, z.
        found: [f64; 4],
        /// Its length \[-\].
        length: f64,
    },
    /// The caller asked for something impossible.
    #[error("{what}: found {found}, expected {expected}")]
    Argument {
        /// Name of the argument.
        what: &'static str,
        /// Value found.
        found: String,
        /// What is allowed.
        expected: &'static str,
    },
    /// The pose or velocity of a boundary stopped being finite.
    #[error(
        "boundary `{boundary}` has a non-finite {what} at t = {time} s: loads and speeds are too large to compute with"
    )]
    BoundaryNotFinite {
        /// Time \[s\].
        time: f64,
        /// Boundary name.
        boundary: String,
        /// Quantity.
        what: &'static str,
    },
    /// A state stopped being finite.
    #[error("sphere {sphere} has a non-finite {what} at t = {time} s")]
    NotFinite {
        /// Time \[s\].
        time: f64,
        /// Sphere index.
        sphere: usize,
        /// Quantity.
        what: &'static str,
    },
}

/// A residual in three digits.
fn size(residual: f64) -> String {
    match residual.is_nan() {
        true => "of contacts that come and go".to_owned(),
        false => format!("{residual:.2e}"),
    }
}

impl StepError {
    /// The same with its times counted from `by` \[s\] earlier.
    pub(crate) fn later(mut self, by: f64) -> Self {
        match &mut self {
            Self::NotConverged { time, .. }
            | Self::Pinched { time, .. }
            | Self::TooFast { time, .. }
            | Self::BoundaryNotFinite { time, .. }
            | Self::NotFinite { time, .. } => *time += by,
            Self::Jump { .. } | Self::Orientation { .. } | Self::Argument { .. } => {}
        }
        self
    }
}

/// A snapshot that cannot be restored.
#[derive(Debug, Clone, PartialEq, Eq, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum SnapshotError {
    /// Not one of ours, or damaged.
    #[error("not a whole sphere-dda state: {0}")]
    Format(&'static str),
    /// Written by another version of the program.
    #[error(
        "the state has format {found}, this version of sphere-dda reads {expected}: use the version that wrote it"
    )]
    Version {
        /// What the state says.
        found: u32,
        /// What is read.
        expected: u32,
    },
    /// Written for another scene; the hashes are shortened.
    #[error(
        "the state belongs to scene {found}, this is scene {expected}: the scene or a file it names has changed since; \
         restore the old files or start anew"
    )]
    Scene {
        /// What the state says.
        found: String,
        /// The scene's.
        expected: String,
    },
}
