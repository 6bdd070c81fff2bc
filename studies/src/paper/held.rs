//! Whole examples by exactly the paper's loop: penalty held, no sweeps between the multiplier updates.

use std::sync::Arc;

use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Method;
use sphere_dda::scene::materials::{Pair, PairTable};
use sphere_dda::simulation::Simulation;

use super::column::{Column, Stop};
use super::stepping::{Case, Example, Tally};
use crate::Part;
use crate::error::ReportError;

/// Augmentations of a step beyond which an example is left out.
pub const MOST: u64 = 1000;

/// Linear solves allowed for each of these augmentations.
const SOLVES: usize = 3;

/// One example at one held penalty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// The scene.
    pub example: Example,
    /// Factor on the paper's penalty.
    pub factor: f64,
    /// With the scene's friction, or without any.
    pub friction: bool,
}

/// How far it came.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    /// Left out: one sphere alone needs this many.
    Predicted(f64),
    /// Left out: the step that ends at this time \[s\] needs more than [`MOST`].
    Stopped {
        /// End of that step \[s\].
        time: f64,
        /// Augmentations of the steps before it.
        before: Tally,
    },
    /// Every step needed less.
    Whole {
        /// Number of steps.
        steps: u64,
        /// Their augmentations.
        augmentations: Tally,
        /// Their linear solves.
        solves: Tally,
        /// Largest overlap over radius at the end of any step \[-\].
        overlap: f64,
    },
}

impl Held {
    /// Cost of a run until `end` \[s\], in seconds of one core as recorded.
    #[must_use]
    pub fn cost(&self, end: f64) -> f64 {
        let whole = match (self.example, self.friction) {
            (Example::Slopes, true) if self.factor >= 100.0 => 86.0,
            (Example::Slopes, false) => 11.0,
            _ => 0.3,
        };
        whole * end / self.example.end()
    }

    /// Runs it until `end` \[s\], or until a step needs more than [`MOST`] augmentations.
    ///
    /// # Errors
    /// A damaged scene, or [`ReportError::Interrupted`].
    pub fn run(&self, end: f64, part: &Part<'_>) -> Result<Outcome, ReportError> {
        let column = Column::of(self.example, 1)?;
        let alone = column.predicted(self.factor * column.penalty, Stop::Force);
        if alone > MOST as f64 {
            return Ok(Outcome::Predicted(alone));
        }
        let case = Case {
            example: self.example,
            integrator: Integrator::Shi,
            method: Method::Alm,
            factor: self.factor,
            end,
        };
        let mut scene = case.scene()?;
        if !self.friction {
            scene.pairs = PairTable::new(scene.materials.len(), Pair::default());
        }
        let settings = &mut scene.settings;
        settings.adapt_penalty = false;
        settings.max_cuts = 0;
        // Two linear solves an augmentation are the rule where contacts keep their states; a solve counts as 20 iterations.
        settings.max_iterations = 20 * SOLVES * MOST as usize;
        let step = settings.communication_step;
        // The contact forces at t = 0 are a solve as any other.
        let Ok(mut simulation) = Simulation::new(Arc::new(scene)) else {
            return Ok(Outcome::Stopped {
                time: 0.0,
                before: Tally::default(),
            });
        };
        let (mut augmentations, mut solves) = (Tally::default(), Tally::default());
        let mut overlap = 0.0f64;
        let steps = (end / step).round() as u64;
        for k in 1..=steps {
            if part.watch.stop() {
                return Err(ReportError::Interrupted);
            }
            part.reached((k - 1) as f64 / steps as f64);
            let time = k as f64 * step;
            match simulation.advance_to(time) {
                Ok(report) if report.augmentations <= MOST => {
                    augmentations.include(report.augmentations);
                    solves.include(report.factorizations);
                    overlap = overlap.max(report.max_overlap);
                }
                // A step that fails has spent the work of more than `MOST` augmentations.
                _ => {
                    return Ok(Outcome::Stopped {
                        time,
                        before: augmentations,
                    });
                }
            }
        }
        Ok(Outcome::Whole {
            steps,
            augmentations,
            solves,
            overlap,
        })
    }
}
