//! What is kept between steps for speed and memory and never shows in results.

use crate::Vec3;
use crate::contact::history::Past;
use crate::detection::broad_phase::NeighborList;
use crate::detection::placement::Candidate;
use crate::detection::reach::Reach;
use crate::problem::Problem;
use crate::scene::particles::Kinematics;
use crate::solver::augmented_lagrangian::Workspace;
use crate::spatial::Dof6;
use crate::step::assemble::Mover;
use crate::step::assemble::joint::Held;

/// What is kept between steps for speed and never shows in results.
#[derive(Debug, Default)]
pub struct Scratch {
    pub(super) neighbors: NeighborList,
    pub(super) workspace: Workspace,
    pub(super) memory: Memory,
    pub(super) reach: Vec<Reach>,
    pub(super) kept: Kept,
}

/// The arrays of a stage, kept from step to step for their memory alone.
#[derive(Debug, Default)]
pub(super) struct Memory {
    pub(super) problem: Problem,
    pub(super) candidates: Vec<Candidate>,
    pub(super) closed: Vec<Candidate>,
    pub(super) impact: Vec<bool>,
    pub(super) holds: Vec<Held>,
    pub(super) impulses: Vec<Vec3>,
    pub(super) past: Vec<Past>,
    pub(super) solution: Vec<Dof6>,
    pub(super) position: Vec<Vec3>,
}

/// Arrays kept from step to step for their memory alone.
#[derive(Debug, Default)]
pub(super) struct Kept {
    /// As a step begins.
    pub(super) kinematics: Kinematics,
    pub(super) external: Vec<Dof6>,
    pub(super) movers: Vec<Mover>,
    pub(super) accelerations: Vec<Dof6>,
}
