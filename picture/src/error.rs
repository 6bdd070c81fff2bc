//! Why something cannot be drawn.

use thiserror::Error;

/// A number that a drawing needs is missing or not finite.
#[derive(Debug, Error)]
#[error("`{name}`: found {found}, expected {expected}")]
pub struct DrawingError {
    /// Title of the plot or picture.
    pub name: String,
    /// What was found.
    pub found: String,
    /// What is needed.
    pub expected: &'static str,
}
