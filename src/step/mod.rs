//! One internal time step: `predict -> detect -> assemble -> (solve -> verify -> correct)* -> commit`.
//!
//! | stage | file | output |
//! |---|---|---|
//! | predict | `prediction`, `apart` | who takes part; motion without contacts: `Prediction` |
//! | detect | `detect`, `sleep` | candidates within reach of the step; what wakes |
//! | assemble | `assemble`, `rows` | the [`Problem`], who its rows are, a warm start: `Assembly` |
//! | solve | `solve`, `squeeze`, [`crate::solver`] | impulses and velocities: `Solution`; what has no rigid answer gives way |
//! | verify | `verify`, `tunnelling`, `rebounds` | true gaps at the end, energy of impacts: accepted, failed, or a `Correction` of the problem |
//! | commit | `commit`, `sleep` | motion, forces and energy of the next [`State`], which nothing has touched before; what falls asleep |
//!
//! `initial` does likewise at t = 0; `replicas` runs the same stages with replicas of the state, for derivatives.

mod apart;
mod assemble;
mod at_rest;
mod boundary_motion;
mod clump;
mod cohesion;
mod commit;
mod correction;
mod detect;
pub mod driven;
pub mod external;
mod failed;
mod failure;
mod initial;
mod input;
mod linear_problem;
mod members;
mod output;
mod prediction;
mod rebounds;
mod replicas;
mod resolve;
mod rows;
mod sleep;
mod solution;
mod solve;
mod sphere_motion;
mod squeeze;
mod tunnelling;
mod verify;
mod workspace;

pub(crate) use clump::release_clump;
pub(crate) use commit::REMAINDER;
pub(crate) use external::release;
pub use failed::FailedStep;
pub use initial::{initial_forces, remove_overlaps};
pub use input::{Effort, StepInput};
pub use output::{StepFailure, StepOutput, Tunnelling};
pub use replicas::{Replica, start_with_replicas, step_with_replicas};
pub use workspace::Workspace;

use std::mem::take;

use crate::problem::{Impulses, Problem};
use crate::scene::Scene;
use crate::solver::Report;
use crate::solver::gauss_seidel::SMALL;
use crate::state::State;
use apart::Depth;
use commit::{commit, spread_impacts};
use linear_problem::linear_problem;
use output::Taken;
use prediction::{Prediction, PredictionArrays, predict};
use resolve::resolve;
use sleep::{Attempt, Sleepers, undisturbed};
use solution::Solved;

/// Takes `state` from `state.time` to `state.time + dt` of `input`. On failure `state` is unchanged.
///
/// # Errors
/// [`StepFailure`] with the worst contact if the tolerances cannot be met.
pub fn step(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    input: &StepInput,
    effort: Effort,
) -> Result<StepOutput, StepFailure> {
    let (threads, registers) = (scene.settings.threads, scene.settings.registers);
    let pool = workspace.solver.kernel.pool(threads, registers);
    workspace.neighbors.pool = pool.clone();
    let run = |workspace: &mut Workspace, scene: &Scene, state: &mut State| {
        let mut step = || stages(scene, state, workspace, input, effort);
        match scene.particles.len() {
            0..SMALL => step(),
            _ => pool.within(step),
        }
    };
    let mut participants = take(&mut workspace.participants);
    let (mut depth, mut spent) = (Depth::FIRST, Report::default());
    let output = loop {
        let neighbors = &mut workspace.neighbors;
        let taken = match participants.apart(scene, (state, input), neighbors, depth) {
            Some(apart) => apart.step(state, |scene, state, outside| {
                workspace.prediction.outside = outside;
                run(workspace, scene, state)
            }),
            None => run(workspace, scene, state),
        };
        participants.outside = take(&mut workspace.prediction.outside);
        match taken {
            Ok(Taken::Outgrown(report)) => {
                spent = spent.then(report);
                depth = depth.more();
            }
            Ok(Taken::Done(output)) => {
                let solver = spent.then(output.solver);
                break Ok(StepOutput { solver, ..output });
            }
            Err(failure) => break Err(failure),
        }
    };
    workspace.participants = participants;
    output
}

/// The stages in order, from detection on again where the solution moves what sleeps.
fn stages(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
    input: &StepInput,
    effort: Effort,
) -> Result<Taken, StepFailure> {
    let arrays = take(&mut workspace.prediction);
    let mut prediction = predict(scene, state, input, (arrays, &workspace.neighbors.pool));
    let taken = undisturbed(&mut prediction, state, |prediction, state| {
        attempt(prediction, state, workspace, effort)
    })?;
    if let Taken::Done(output) = &taken
        && output.solver.penalty > 0.0
        && output.solver.penalty.is_finite()
    {
        state.penalty = output.solver.penalty;
    }
    workspace.prediction = prediction.into_arrays();
    Ok(taken)
}

/// Stages from detection on.
fn attempt(
    prediction: &mut Prediction,
    state: &mut State,
    workspace: &mut Workspace,
    effort: Effort,
) -> Attempt {
    let (mut assembly, mut solution) = linear_problem(prediction, state, workspace);
    let resolved = resolve(&mut assembly, &mut solution, (state, effort), workspace);
    if let Some(outgrown) = Attempt::leads_out(&assembly, &solution, &resolved) {
        workspace.keep(assembly, solution);
        return outgrown;
    }
    if let Some(disturbed) = Attempt::failed_beside_sleepers(&assembly, &resolved, (state, effort))
    {
        workspace.keep(assembly, solution);
        return disturbed;
    }
    let what = (&assembly, &solution);
    let when = (state.time, assembly.prediction.step);
    workspace.failed.note(when, what, &resolved);
    let output = match resolved {
        Ok(output) => output,
        Err(failure) => return Attempt::Done(Err(failure)),
    };
    assembly.hold_on(&mut solution);
    spread_impacts(
        &mut assembly,
        &solution,
        (state, output.unconverged),
        &mut workspace.balance,
    );
    let solved = Solved {
        assembly: &assembly,
        solution: &solution,
    };
    let sleepers = Sleepers::of(&solved, state);
    let ends = sleepers.ends(output);
    if matches!(ends, Attempt::Done(_)) {
        commit(&solved, state, &sleepers, &mut workspace.accelerations);
    }
    workspace.keep(assembly, solution);
    ends
}

/// The problem that a step from `state` by `input` begins with, and the impulses \[N s\] it starts from: candidates within
/// reach, gaps not yet re-linearised.
#[must_use]
pub fn problem(scene: &Scene, state: &State, input: &StepInput) -> (Problem, Impulses) {
    let mut workspace = Workspace::default();
    let memory = (PredictionArrays::default(), &workspace.neighbors.pool);
    let mut prediction = predict(scene, state, input, memory);
    let (assembly, solution) = linear_problem(&mut prediction, state, &mut workspace);
    (assembly.problem, solution.impulses)
}
