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

/// Share of a sphere's motion in a step by which the gaps of the step may be wrong, within their tolerances.
const MOTION_SHARE: f64 = 0.1;

/// Solves the problem as it stands from the impulses of `solution`, with `penalty` \[N/m\] to begin with and
/// errors that may use a `share` of the reserve; by `sweeps` at most, if so many are given.
pub(super) fn solve(
    assembly: &Assembly,
    solution: &mut Solution,
    (penalty, effort, share): (f64, Effort, f64),
    workspace: &mut SolverWorkspace,
    sweeps: Option<usize>,
) -> Report {
    let mut params = params(&assembly.prediction.scene.settings, penalty, share);
    params.accept = effort.accept;
    if let Some(sweeps) = sweeps {
        params.kind = SolverKind::GaussSeidel;
        params.max_sweeps = sweeps;
        params.accept = false;
    }
    workspace.velocity = take(&mut solution.velocity);
    let report = solver::solve(
        &assembly.problem,
        &params,
        workspace,
        &mut solution.impulses,
    );
    solution.velocity = take(&mut workspace.velocity);
    assembly.prediction.carry_members(&mut solution.velocity);
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
    let mut params = params(&assembly.prediction.scene.settings, penalty, 0.0);
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

/// Share of the reserve that errors of this step may use: as much as [`MOTION_SHARE`] of the mean motion of the spheres within
/// it, and as the contacts that give way, which have no reserve, are part of all. Forces of what rests are as good as without
/// reserve, whatever else moves.
pub(super) fn reserve_share(assembly: &Assembly) -> f64 {
    let prediction = assembly.prediction;
    let reserve = prediction.scene.settings.reserve();
    if reserve == 0.0 {
        return 0.0;
    }
    let radius = &prediction.scene.particles.radius;
    let whole = MOTION_SHARE * prediction.step / reserve;
    let share = |i: usize| (whole * prediction.velocity(i).linear.norm() / radius[i]).min(1.0);
    let moving = (0..radius.len()).map(share).sum::<f64>() / radius.len().max(1) as f64;
    moving * rigid_share(assembly)
}

/// Share of the contacts that are rigid.
fn rigid_share(assembly: &Assembly) -> f64 {
    let compressed = (0..assembly.elastic.len()).filter(|&k| assembly.compressed(k).is_some());
    1.0 - compressed.count() as f64 / assembly.candidates.len().max(1) as f64
}

fn params(settings: &Settings, penalty: f64, share: f64) -> Params {
    let penalty_method = settings.method == Method::Penalty;
    Params {
        kind: settings.solver,
        tolerance: settings.linear_tolerance(share),
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
