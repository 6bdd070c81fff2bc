//! Steps that fail or end unconverged, kept with their problems where someone asks for them: to be written down and studied.

use super::assemble::Assembly;
use super::solution::Solution;
use super::{StepFailure, StepOutput};
use crate::problem::{Impulses, Problem};

/// An internal step that failed, or whose best iterate was taken.
#[derive(Debug, Clone, PartialEq)]
pub struct FailedStep {
    /// Time at its beginning \[s\].
    pub time: f64,
    /// Its length \[s\].
    pub step: f64,
    /// What it missed.
    pub why: String,
    /// Its problem as it was last solved.
    pub problem: Problem,
    /// The impulses that the solver left, `[C]` \[N s\].
    pub impulses: Impulses,
}

/// Those of a run, up to a number of them.
#[derive(Debug, Default)]
pub(crate) struct FailedSteps {
    /// How many more may be kept.
    room: usize,
    steps: Vec<FailedStep>,
    /// How many more there were.
    omitted: u64,
}

impl FailedSteps {
    /// Keeps that many from now on.
    pub(crate) fn keep(&mut self, most: usize) {
        self.room = most;
    }

    /// Those kept since the last call, and how many more there were in all.
    pub(crate) fn take(&mut self) -> (Vec<FailedStep>, u64) {
        (std::mem::take(&mut self.steps), self.omitted)
    }

    /// Keeps a step if it missed its tolerances.
    pub(super) fn note(
        &mut self,
        (time, step): (f64, f64),
        (assembly, solution): (&Assembly, &Solution),
        result: &Result<StepOutput, StepFailure>,
    ) {
        let why = match result {
            Ok(output) if !output.unconverged => return,
            Ok(output) => {
                let residual = &output.solver.residual;
                format!(
                    "best iterate taken: residuals gap {:.1e}, slip {:.1e}, force {:.1e}",
                    residual.gap, residual.slip, residual.force
                )
            }
            Err(failure) => reason(failure),
        };
        let Some(room) = self.room.checked_sub(1) else {
            self.omitted += 1;
            return;
        };
        self.room = room;
        self.steps.push(FailedStep {
            time,
            step,
            why,
            problem: assembly.problem.clone(),
            impulses: solution.impulses.clone(),
        });
    }
}

fn reason(failure: &StepFailure) -> String {
    let StepFailure {
        what,
        residual,
        tolerance,
        ..
    } = failure;
    let missed = format!("failed: {what} residual {residual:.1e}, tolerance {tolerance:.1e}");
    match (&failure.passed, &failure.pinched) {
        (Some(_), _) => "failed: bodies could pass each other within the step".to_owned(),
        (None, Some(_)) => format!("{missed}; a sphere is squeezed between boundaries"),
        (None, None) => missed,
    }
}
