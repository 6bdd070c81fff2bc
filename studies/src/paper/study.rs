//! What the study of the paper is asked for, and what it finds.

use super::conditioning::Point;
use super::held::{Held, Outcome};
use super::stepping::{Example, Record};

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Share of each run's duration, 0 to 1; below 1 it is a trial, and the report says so.
    pub duration: f64,
    /// Threads; they do not change the report.
    pub threads: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            duration: 1.0,
            threads: 2,
        }
    }
}

/// All that was run.
#[derive(Debug, Clone)]
pub(crate) struct Study {
    pub(super) duration: f64,
    /// Example, integrator, method in this order of nesting.
    pub(super) records: Vec<Record>,
    /// Per example: its sweep of penalties.
    pub(super) sweeps: Vec<(Example, Vec<Point>)>,
    /// One sphere and a stack, with each example's numbers.
    pub(super) stacks: Vec<StackRow>,
    /// Whole examples at held penalties.
    pub(super) held: Vec<(Held, Outcome)>,
}

/// Numbers of spheres in a stack.
pub(super) const STACKS: [usize; 2] = [1, 10];

/// A stack at one penalty.
#[derive(Debug, Clone)]
pub(super) struct StackRow {
    pub(super) example: Example,
    pub(super) spheres: usize,
    pub(super) factor: f64,
    pub(super) contraction: f64,
    /// Augmentations to the gap tolerance: predicted, counted.
    pub(super) gap: (f64, u64),
    /// Augmentations to the force tolerance: predicted, counted.
    pub(super) force: (f64, u64),
    /// Error of the forces then \[-\].
    pub(super) error: f64,
    /// Augmentations and error of the forces \[-\] of the library's own step.
    pub(super) adapted: (u64, f64),
    /// Overlap over radius of the penalty method: closed form, found.
    pub(super) penalty: (f64, Option<f64>),
}

impl Study {
    /// The paper's penalty \[N/m\].
    pub(super) fn penalty(&self, example: Example) -> f64 {
        let mut records = self.records.iter().filter(|r| r.case.example == example);
        let penalty = records.next().and_then(|r| r.scene.settings.penalty);
        penalty.unwrap_or(f64::NAN)
    }
}
