//! The start of a run: overlaps out by displacement, contact forces at rest.

use super::assemble::Assembly;
use super::failure::failed;
use super::linear_problem::linear_problem;
use super::prediction::Prediction;
use super::resolve::resolve;
use super::solution::{Solution, Solved};
use super::solve::{polish, solve};
use super::workspace::Workspace;
use super::{Effort, StepFailure};
use crate::detection::configuration::Configuration;
use crate::scene::{Method, Scene};
use crate::solver::Report;
use crate::state::State;

/// Force residual at t = 0: forces at rest balance the weight, whatever the steps are asked for \[-\].
const AT_REST: f64 = 1e-8;

/// Removes overlaps at t = 0 by the smallest displacement (in the mass metric) that closes no other gap; leaves the
/// largest overlap found in `state.initial_overlap`. The penalty method keeps its overlaps.
///
/// # Errors
/// [`StepFailure`] if no such displacement is found.
pub fn remove_overlaps(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
) -> Result<(), StepFailure> {
    if overlaps(scene, state, workspace) {
        let mut prediction = Prediction::still(scene, state);
        let (mut assembly, mut solution) = linear_problem(&mut prediction, state, workspace);
        assembly.displace(&mut solution.impulses);
        let how = (&*state, effort(scene));
        resolve(&mut assembly, &mut solution, how, workspace)?;
        prediction.turn_members(&solution.velocity, &mut state.kinematics);
        state.kinematics.position = solution.position;
    }
    Ok(())
}

/// Finds the overlaps of `state`; whether they are to be removed.
pub(super) fn overlaps(scene: &Scene, state: &mut State, workspace: &mut Workspace) -> bool {
    let configuration = Configuration::of(scene, &state.kinematics, &state.poses);
    let neighbors = &mut workspace.neighbors;
    neighbors.ensure(&configuration, &[], 0.0);
    let mut overlapping = Vec::new();
    state.initial_overlap = configuration.overlaps(neighbors, 0.0, &mut overlapping);
    let settings = &scene.settings;
    settings.method == Method::Alm && state.initial_overlap > settings.tolerance.gap
}

/// Contact forces at t = 0 from the acceleration-level problem: closed contacts that neither approach nor part
/// must not accelerate into each other. Leaves them and the smooth accelerations in `state`.
///
/// # Errors
/// [`StepFailure`] if that problem has no solution within the tolerances.
pub fn initial_forces(
    scene: &Scene,
    state: &mut State,
    workspace: &mut Workspace,
) -> Result<(), StepFailure> {
    let mut prediction = Prediction::at_rest(scene, state, 0.5 * scene.settings.step);
    let (mut assembly, mut solution) = linear_problem(&mut prediction, state, workspace);
    let resting = assembly.resting();
    assembly.keep(&resting, &mut solution.impulses);
    solve_forces(&assembly, &mut solution, state.penalty, workspace)?;
    assembly.act(&mut solution);
    let solved = Solved {
        assembly: &assembly,
        solution: &solution,
    };
    solved.commit_forces(state);
    Ok(())
}

/// Solves for forces at rest, with their velocities.
pub(super) fn solve_forces(
    assembly: &Assembly,
    solution: &mut Solution,
    penalty: f64,
    workspace: &mut Workspace,
) -> Result<Report, StepFailure> {
    let scene = assembly.prediction.scene;
    let solver = &mut workspace.solver;
    let how = (penalty, effort(scene), 0.0);
    let report = solve(assembly, solution, how, solver, None);
    if scene.settings.method == Method::Alm {
        if scene.settings.strict && !report.converged {
            return Err(failed(assembly, solution, &report));
        }
        polish(assembly, solution, penalty, solver, AT_REST);
    }
    solution.velocity = assembly.problem.velocities(&solution.impulses);
    assembly.prediction.carry_members(&mut solution.velocity);
    Ok(report)
}

/// There is no shorter step at the start: the best iterate is taken, unless the scene is strict.
pub(super) fn effort(scene: &Scene) -> Effort {
    Effort {
        accept: !scene.settings.strict,
        ..Effort::default()
    }
}
