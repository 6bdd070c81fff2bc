//! Solve and verify, again and again, until the true geometry agrees.

use super::assemble::Assembly;
use super::correction::Correction;
use super::failure::{failed, failed_to_converge};
use super::rebounds::Rebounds;
use super::solution::Solution;
use super::solve::{reserve_share, solve};
use super::squeeze::soften;
use super::verify::verify;
use super::workspace::Workspace;
use super::{Effort, StepFailure, StepOutput};
use crate::scene::Method;
use crate::solver::{Report, SolverKind};
use crate::state::{Squeezed, State};

/// Passes of re-linearisation and late contacts before the step is cut.
const PASSES: usize = 30;
/// Passes whose errors may use the reserve: one that such a solution spoils gets a better one.
const LOOSE_PASSES: usize = 2;
/// How often what is squeezed gives way in a pass.
const SOFTENINGS: usize = 4;
/// A solve in which something gives way, or rebounds were given up, may take so many times the sweeps of one that can be cut.
const GIVING_WAY: usize = 4;
/// Sweeps that show whether rebounds have a solution.
const TRIAL_SWEEPS: usize = 1000;

/// Solves until the true geometry agrees: gaps are re-linearised, late contacts join.
///
/// # Errors
/// [`StepFailure`] if the tolerances cannot be met within `effort`.
pub(super) fn resolve(
    assembly: &mut Assembly,
    solution: &mut Solution,
    (state, effort): (&State, Effort),
    workspace: &mut Workspace,
) -> Result<StepOutput, StepFailure> {
    let mut passes = Passes::new(assembly, solution, (state.penalty, effort));
    loop {
        match passes.next(assembly, solution, workspace)? {
            Pass::Accepted(output) => return Ok(output),
            Pass::Corrected(correction) => {
                correction.apply(assembly, solution, state, None);
            }
        }
    }
}

/// Passes of solve and verify.
pub(super) struct Passes {
    penalty: f64,
    effort: Effort,
    count: usize,
    /// Share of the reserve that errors of the first passes may use.
    share: f64,
    total: Report,
    /// Most sweeps of all passes, and of one.
    budget: Option<usize>,
    sweep_limit: Option<usize>,
    /// A sphere that gives way: it overlaps by more than the tolerance, though its problem is solved.
    squeezed: Option<Squeezed>,
    rebounds: Rebounds,
}

/// How a pass ends.
pub(super) enum Pass {
    /// The true geometry agrees, or the solution is taken as it is.
    Accepted(StepOutput),
    /// The problem is to be corrected before the next pass.
    Corrected(Correction),
}

impl Passes {
    pub(super) fn new(
        assembly: &mut Assembly,
        solution: &Solution,
        (penalty, effort): (f64, Effort),
    ) -> Self {
        let settings = &assembly.prediction.scene.settings;
        Self {
            penalty,
            effort,
            count: 0,
            share: reserve_share(assembly),
            total: Report::default(),
            budget: settings.sweeps.filter(|_| assembly.moves),
            sweep_limit: effort.sweeps.filter(|_| assembly.moves),
            squeezed: effort.accept.then(|| soften(assembly, solution)).flatten(),
            rebounds: Rebounds::default(),
        }
    }

    /// What the solves have done so far.
    pub(super) fn report(&self) -> &Report {
        &self.total
    }

    /// Whether a solve without limits, which takes long where there is no solution, is to come after one that shows whether rebounds
    /// have one.
    fn tries_rebounds(&self, assembly: &Assembly) -> bool {
        let solver = assembly.prediction.scene.settings.solver;
        solver != SolverKind::Direct && self.rebounds.are_left(assembly)
    }

    /// Gives up what impacts demand where the last solve, with this `share` of the reserve, left rows unsolved; `None` where nothing
    /// is left to give up.
    fn give_up(&mut self, assembly: &Assembly, share: f64) -> Option<Correction> {
        if self.count >= PASSES {
            return None;
        }
        let tolerance = assembly.prediction.scene.settings.linear_tolerance(share);
        let unsolved: Vec<usize> = self.total.residual.unsolved(&tolerance).collect();
        self.rebounds.give_up(assembly, &unsolved)
    }

    /// Solves and verifies once more.
    ///
    /// # Errors
    /// As [`resolve`].
    pub(super) fn next(
        &mut self,
        assembly: &mut Assembly,
        solution: &mut Solution,
        workspace: &mut Workspace,
    ) -> Result<Pass, StepFailure> {
        let settings = &assembly.prediction.scene.settings;
        let accept = self.effort.accept;
        self.count += 1;
        let limit = self.budget.map(|budget| budget - self.total.sweeps);
        let patience = match self.rebounds.are_given_up() {
            true => GIVING_WAY,
            false => 1,
        };
        let limit = limit.or(self.sweep_limit.map(|sweeps| patience * sweeps));
        let tries = limit.is_none() && self.tries_rebounds(assembly);
        let share = match self.count <= LOOSE_PASSES {
            true => self.share,
            false => 0.0,
        };
        let how = (self.penalty, self.effort, share);
        let start = (accept || tries).then(|| solution.impulses.clone());
        let first = limit.or(tries.then_some(TRIAL_SWEEPS.min(settings.max_iterations)));
        let report = solve(assembly, solution, how, &mut workspace.solver, first);
        self.total = self.total.then(report);
        let budget = self.budget;
        let spent = |total: &Report| budget.is_some_and(|most| total.sweeps >= most);
        let unsolved = !self.total.converged && !spent(&self.total);
        if let Some(start) = start.as_ref().filter(|_| unsolved) {
            if let Some(correction) = self.give_up(assembly, share) {
                solution.impulses.clone_from(start);
                return Ok(Pass::Corrected(correction));
            }
            if tries {
                let report = solve(assembly, solution, how, &mut workspace.solver, None);
                self.total = self.total.then(report);
            }
        }
        let start = start.filter(|_| accept);
        for start in start.iter().cycle().take(SOFTENINGS) {
            if self.total.converged || spent(&self.total) {
                break;
            }
            let Some(squeezed) = soften(assembly, solution) else {
                break;
            };
            self.squeezed = Some(squeezed);
            // Forces have grown without bound: those from before lead back sooner.
            solution.impulses.clone_from(start);
            let limit = self.budget.map(|budget| budget - self.total.sweeps);
            let limit = limit.or(self.sweep_limit.map(|sweeps| GIVING_WAY * sweeps));
            let report = solve(assembly, solution, how, &mut workspace.solver, limit);
            self.total = self.total.then(report);
        }
        let as_it_is = spent(&self.total) || (accept && !self.total.converged);
        if !self.total.converged && !as_it_is {
            return Err(failed(assembly, solution, &self.total));
        }
        let filled = assembly.filled(&solution.impulses);
        if !filled.is_empty() && !as_it_is && self.count < PASSES {
            return Ok(Pass::Corrected(Correction {
                filled,
                ..Correction::default()
            }));
        }
        let how = (as_it_is, self.effort.pass);
        let verdict = verify(assembly, solution, workspace, how);
        let verdict = verdict.map_err(|passed| StepFailure {
            passed: Some(passed),
            ..failed(assembly, solution, &self.total)
        })?;
        let gaps = (verdict.max_overlap, verdict.max_opening);
        let alm = settings.method == Method::Alm;
        let overlaps = alm && assembly.moves && gaps.0 > settings.tolerance.gap;
        let compression = verdict.max_compression;
        let output = StepOutput::of(self.total, [gaps.0, gaps.1, compression]);
        let correction = match verdict.correction {
            None if !as_it_is => self.rebounds.limit(assembly, solution),
            correction => correction,
        };
        match correction {
            Some(correction) if self.count < PASSES => Ok(Pass::Corrected(correction)),
            Some(_) if !accept => Err(failed_to_converge(assembly, solution, gaps)),
            correction => Ok(Pass::Accepted(StepOutput {
                unconverged: overlaps
                    || correction.is_some()
                    || !self.total.converged
                    || self.squeezed.is_some(),
                squeezed: self.squeezed,
                ..output
            })),
        }
    }
}
