//! What a solver did, and the best that a loop has found.

use crate::Vec3;
use crate::linalg::LinearError;
use crate::solver::Tolerance;
use crate::solver::residual::Residual;

/// What a solver did.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report {
    /// Whether every residual is within its tolerance.
    pub converged: bool,
    /// Residual reached.
    pub residual: Residual,
    /// Gauss-Seidel sweeps.
    pub sweeps: usize,
    /// Multiplier updates of the augmented-Lagrangian loop.
    pub augmentations: usize,
    /// Linear solves: open-close iterations over all augmentations. An unchanged matrix keeps its factor.
    pub factorizations: usize,
    /// Penalty number at the end \[N/m\]; zero if the augmented-Lagrangian loop did not run.
    pub penalty: f64,
    /// Why the last solve ended early, if a factorization failed.
    pub broken: Option<LinearError>,
}

impl Report {
    /// Adds the work of a second solve; residual, verdict and what broke are those of the second, the penalty the last.
    pub(crate) fn then(self, next: Self) -> Self {
        Self {
            sweeps: self.sweeps + next.sweeps,
            augmentations: self.augmentations + next.augmentations,
            factorizations: self.factorizations + next.factorizations,
            penalty: if next.penalty > 0.0 {
                next.penalty
            } else {
                self.penalty
            },
            ..next
        }
    }
}

/// The best impulses of a loop that may lead away from the solution.
pub(super) struct Best {
    pub(super) excess: f64,
    pub(super) impulses: Vec<Vec3>,
}

impl Best {
    pub(super) fn new(residual: &Residual, tolerance: &Tolerance, impulses: &[Vec3]) -> Self {
        Self {
            excess: residual.excess(tolerance),
            impulses: impulses.to_vec(),
        }
    }

    /// Keeps `impulses` if they are better.
    pub(super) fn offer(&mut self, residual: &Residual, tolerance: &Tolerance, impulses: &[Vec3]) {
        let excess = residual.excess(tolerance);
        if excess < self.excess {
            self.excess = excess;
            self.impulses.copy_from_slice(impulses);
        }
    }
}
