//! What a solver of friction problems is to reach, and what it has done.

use crate::Vec3;
use crate::linalg::LinearError;
use crate::problem::friction::FrictionProblem;

/// What a solver of friction problems has done.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrictionReport {
    /// Whether the tolerance is reached.
    pub converged: bool,
    /// Siconos' measure of the impulses \[-\].
    pub error: f64,
    /// Sweeps of Gauss-Seidel.
    pub sweeps: usize,
    /// Factorizations.
    pub factorizations: usize,
    /// Why the last try of Newton ended early, if a factorization failed.
    pub broken: Option<LinearError>,
}

/// What is to be reached.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    pub(super) tolerance: f64,
}

impl FrictionReport {
    /// With error and verdict of the impulses.
    pub(super) fn close(
        mut self,
        problem: &FrictionProblem,
        goal: Goal,
        impulses: &[Vec3],
    ) -> Self {
        self.error = problem.error(impulses);
        self.converged = self.error <= goal.tolerance;
        self
    }

    /// Adds the work of a second solve; error and verdict are those of the second.
    pub(super) fn then(self, next: Self) -> Self {
        Self {
            sweeps: self.sweeps + next.sweeps,
            factorizations: self.factorizations + next.factorizations,
            ..next
        }
    }
}
