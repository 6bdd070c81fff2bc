//! What is kept between steps for speed and memory and never shows in results.

use crate::Vec3;
use crate::contact::history::HistoryIndex;
use crate::detection::broad_phase::NeighborList;
use crate::detection::configuration::Candidate;
use crate::detection::detection_distance::DetectionDistance;
use crate::problem::Problem;
use crate::scene::particles::Kinematics;
use crate::solver::augmented_lagrangian::SolverWorkspace;
use crate::spatial::SpatialVector;
use crate::step::assemble::SphereMotion;
use crate::step::assemble::joint::JointConstraint;

/// What is kept between steps for speed and never shows in results.
#[derive(Debug, Default)]
pub struct Workspace {
    pub(super) neighbors: NeighborList,
    pub(super) workspace: SolverWorkspace,
    pub(super) memory: AssemblyArrays,
    pub(super) reach: Vec<DetectionDistance>,
    pub(super) kept: PredictionArrays,
}

/// The arrays of a stage, kept from step to step for their memory alone.
#[derive(Debug, Default)]
pub(super) struct AssemblyArrays {
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    pub(super) closed: Vec<Candidate>,
    pub(super) impact: Vec<bool>,
    pub(super) joints: Vec<JointConstraint>,
    pub(super) impulses: Vec<Vec3>,
    pub(super) past: Vec<HistoryIndex>,
    pub(super) solution: Vec<SpatialVector>,
    pub(super) position: Vec<Vec3>,
}

/// Arrays kept from step to step for their memory alone.
#[derive(Debug, Default)]
pub(super) struct PredictionArrays {
    /// As a step begins.
    pub(super) kinematics: Kinematics,
    pub(super) external: Vec<SpatialVector>,
    pub(super) spheres: Vec<SphereMotion>,
    pub(super) accelerations: Vec<SpatialVector>,
}
