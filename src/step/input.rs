//! How far a step goes before it fails.

/// How far a step goes before it fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Most Gauss-Seidel sweeps of a solve, where the step can be cut instead; `None`: every solver as long as it may.
    pub sweeps: Option<usize>,
    /// Whether the best iterate of a solve that does not converge is taken.
    pub accept: bool,
    /// Whether bodies may move so far against each other that they could pass.
    pub pass: bool,
}
