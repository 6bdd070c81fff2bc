//! What is kept between steps for speed and memory and never shows in results.

use super::apart::Participants;
use super::assemble::{Assembly, AssemblyArrays};
use super::commit::Balance;
use super::failed::FailedSteps;
use super::prediction::PredictionArrays;
use super::solution::Solution;
use crate::detection::broad_phase::NeighborList;
use crate::detection::detection_distance::DetectionDistance;
use crate::solver::augmented_lagrangian::SolverWorkspace;
use crate::spatial::SpatialVector;

/// What is kept between steps for speed and never shows in results.
#[derive(Debug, Default)]
pub struct Workspace {
    pub(super) neighbors: NeighborList,
    pub(super) participants: Participants,
    pub(super) solver: SolverWorkspace,
    pub(super) reach: Vec<DetectionDistance>,
    pub(super) prediction: PredictionArrays,
    pub(super) assembly: AssemblyArrays,
    pub(super) solution: Solution,
    pub(super) balance: Balance,
    pub(super) accelerations: Vec<SpatialVector>,
    /// Steps that missed their tolerances, if someone asked for them.
    pub(crate) failed: FailedSteps,
}

impl Workspace {
    /// Forgets what it has of the scene, which is another one from now on.
    pub(crate) fn forget_scene(&mut self) {
        self.participants = Participants::default();
        self.neighbors.forget();
    }

    /// Takes the arrays of a step that is done.
    pub(super) fn keep(&mut self, assembly: Assembly, solution: Solution) {
        self.assembly = assembly.into_arrays();
        self.solution = solution;
    }
}
