//! What steps cost and reached.

use serde::{Deserialize, Serialize};

/// A sphere that rigid boundaries press from two sides, itself or by spheres between, which has no answer but to give way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Squeezed {
    /// Its number.
    pub sphere: usize,
    /// Numbers of the boundaries.
    pub boundaries: [u16; 2],
    /// Whether other spheres are between it and one of them.
    pub by_others: bool,
}

/// What one communication step cost and reached.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct StepReport {
    /// Internal steps taken, cut ones included.
    pub internal_steps: u64,
    /// How often a step was halved.
    pub cuts: u64,
    /// Internal steps that did not reach the tolerances and whose best iterate was taken.
    pub unconverged_steps: u64,
    /// Gauss-Seidel sweeps.
    pub sweeps: u64,
    /// Multiplier updates of the augmented-Lagrangian loop.
    pub augmentations: u64,
    /// Factorizations (open-close iterations).
    pub factorizations: u64,
    /// Largest true overlap over radius at the end of any internal step \[-\].
    pub max_overlap: f64,
    /// Largest gap over radius at which a contact carried load at the end of any internal step, impacts left out \[-\].
    pub max_opening: f64,
    /// Largest compression over radius of a contact that gives way at the end of any internal step \[-\]: no error.
    pub max_compression: f64,
    /// Largest gap residual of any solve \[-\].
    pub gap_residual: f64,
    /// Largest slip residual \[-\].
    pub slip_residual: f64,
    /// Largest force residual \[-\].
    pub force_residual: f64,
    /// A sphere that was squeezed in it, if one was.
    pub squeezed: Option<Squeezed>,
    /// How near a contact came to the edge of its state (open, stick, slip) in any internal step: 1 is at the edge, where
    /// derivatives are one-sided, 0 far from it \[-\].
    pub(crate) active_set_closeness: f64,
}

impl StepReport {
    /// Adds what a later communication step cost and reached.
    pub fn add(&mut self, later: &Self) {
        self.internal_steps += later.internal_steps;
        self.cuts += later.cuts;
        self.unconverged_steps += later.unconverged_steps;
        self.sweeps += later.sweeps;
        self.augmentations += later.augmentations;
        self.factorizations += later.factorizations;
        self.max_overlap = self.max_overlap.max(later.max_overlap);
        self.max_opening = self.max_opening.max(later.max_opening);
        self.max_compression = self.max_compression.max(later.max_compression);
        self.gap_residual = self.gap_residual.max(later.gap_residual);
        self.slip_residual = self.slip_residual.max(later.slip_residual);
        self.force_residual = self.force_residual.max(later.force_residual);
        self.squeezed = self.squeezed.or(later.squeezed);
        self.active_set_closeness = self.active_set_closeness.max(later.active_set_closeness);
    }
}
