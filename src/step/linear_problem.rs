//! The problem that a step begins with: candidates, their rows, a warm start.

use std::mem::take;

use super::assemble::{Assembly, assemble};
use super::detect::detect;
use super::prediction::Prediction;
use super::solution::Solution;
use super::workspace::Workspace;
use crate::state::State;

/// Candidates and problem of a prediction, with the impulses that the solve starts from.
pub(super) fn linear_problem<'a>(
    prediction: &'a mut Prediction<'_>,
    state: &State,
    workspace: &mut Workspace,
) -> (Assembly<'a>, Solution) {
    let settings = &prediction.scene.settings;
    let kernel = &mut workspace.solver.kernel;
    prediction.pool = kernel.pool(settings.threads, settings.registers);
    let mut arrays = take(&mut workspace.assembly);
    let mut solution = take(&mut workspace.solution);
    loop {
        prediction.bodies(&mut arrays.problem);
        let (free, candidates) = (&arrays.problem.free, &mut arrays.candidates);
        detect(prediction, free, workspace, candidates);
        if !prediction.wake(candidates, free, state) {
            break;
        }
    }
    let prediction = &*prediction;
    if !prediction.asleep.is_empty() {
        let candidates = &mut arrays.candidates;
        candidates.retain(|candidate| !prediction.sleeps(candidate.key));
    }
    let impulses = &mut solution.impulses;
    let assembly = assemble(prediction, arrays, state, None, impulses);
    (assembly, solution)
}
