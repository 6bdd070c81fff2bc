//! Fourth stage of a step: impulses that solve its problem.

use std::mem::{swap, take};

use super::Effort;
use super::assemble::Assembly;
use super::solution::Solution;
use crate::scene::{Method, Settings};
use crate::solver::augmented_lagrangian::SolverWorkspace;
use crate::solver::residual::{Scale, evaluate};
use crate::solver::{self, Params, Report, SMOOTHING, SolverKind};

/// Sweeps of every step where contacts keep their gaps. At rest one would do, and leave the same error in each step: a bed
/// creeps by their sum.
const STANDING_SWEEPS: usize = 3;
/// Share of the gap tolerance left to the linear problem; the rest is for curvature and rounding.
const LINEAR_SHARE: f64 = 0.9;

/// Solves the problem as it stands from the impulses of `solution`, with `penalty` \[N/m\] to begin with; by `sweeps` at most,
/// if so many are given.
pub(super) fn solve(
    assembly: &Assembly,
    solution: &mut Solution,
    (penalty, effort): (f64, Effort),
    workspace: &mut SolverWorkspace,
    sweeps: Option<usize>,
) -> Report {
    let mut params = params(&assembly.prediction.scene.settings, penalty);
    params.accept = effort.accept;
    if let Some(sweeps) = sweeps {
        params.kind = SolverKind::GaussSeidel;
        params.max_sweeps = sweeps;
    }
    workspace.velocity = take(&mut solution.velocity);
    let report = solver::solve(
        &assembly.problem,
        &params,
        workspace,
        &mut solution.impulses,
    );
    solution.velocity = take(&mut workspace.velocity);
    report
}

/// Brings forces that are solved already to the residual `force` as far as Gauss-Seidel gets.
pub(super) fn polish(
    assembly: &Assembly,
    solution: &mut Solution,
    penalty: f64,
    workspace: &mut SolverWorkspace,
    force: f64,
) {
    let mut params = params(&assembly.prediction.scene.settings, penalty);
    params.kind = SolverKind::GaussSeidel;
    params.tolerance.force = params.tolerance.force.min(force);
    let mut before = solution.impulses.clone();
    let scales = Scale::of(&assembly.problem);
    let coarse = evaluate(&assembly.problem, &scales, &before).force;
    let report = solver::solve(
        &assembly.problem,
        &params,
        workspace,
        &mut solution.impulses,
    );
    if !report.converged && report.residual.force > coarse {
        swap(&mut solution.impulses, &mut before);
    }
}

fn params(settings: &Settings, penalty: f64) -> Params {
    let mut tolerance = settings.tolerance;
    tolerance.gap *= LINEAR_SHARE;
    let penalty_method = settings.method == Method::Penalty;
    Params {
        kind: settings.solver,
        tolerance,
        accept: false,
        min_sweeps: match settings.opening > 0.0 {
            true => STANDING_SWEEPS,
            false => 1,
        },
        max_sweeps: settings.max_iterations,
        max_factorizations: settings.max_iterations.div_ceil(20),
        // Contact springs carry the penalty themselves: nothing is left to augment.
        penalty: match penalty_method {
            true => f64::INFINITY,
            false => penalty,
        },
        adapt_penalty: settings.adapt_penalty && !penalty_method,
        // A penalty held by the scene asks for the paper's loop and nothing else.
        smoothing: if settings.adapt_penalty { SMOOTHING } else { 0 },
    }
}
