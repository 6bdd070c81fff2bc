//! What the solve of a step finds, and where that leads.

use super::assemble::Assembly;
use super::prediction::Prediction;
use crate::Vec3;
use crate::detection::configuration::Candidate;
use crate::spatial::SpatialVector;

/// What solves the problem of a step.
#[derive(Debug, Default)]
pub(super) struct Solution {
    /// Impulses of the rows \[N s\].
    pub(super) impulses: Vec<Vec3>,
    /// Velocities of the bodies by these impulses, `[N + D + C]`; of a member the way that its clump takes it, over the step.
    pub(super) velocity: Vec<SpatialVector>,
    /// Where they lead the spheres \[m\], `[N]`, and the pairs that overlap there by more than the tolerance: as last verified.
    pub(super) position: Vec<Vec3>,
    pub(super) overlapping: Vec<Candidate>,
}

impl Solution {
    /// Impulses of another start for the same problem, with their velocities.
    pub(super) fn of(assembly: &Assembly, impulses: Vec<Vec3>) -> Self {
        let mut velocity = assembly.problem.velocities(&impulses);
        assembly.prediction.carry_members(&mut velocity);
        Self {
            velocity,
            impulses,
            ..Self::default()
        }
    }

    /// Whether row `k` carries an impulse.
    pub(super) fn loads(&self, k: usize) -> bool {
        self.impulses[k] != Vec3::zeros()
    }
}

/// A step that is solved.
#[derive(Clone, Copy)]
pub(super) struct Solved<'a> {
    pub(super) assembly: &'a Assembly<'a>,
    pub(super) solution: &'a Solution,
}

impl<'a> Solved<'a> {
    /// What the problem was made from.
    pub(super) fn prediction(&self) -> &'a Prediction<'a> {
        self.assembly.prediction
    }
}
