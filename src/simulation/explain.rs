//! Failures of steps in the scene's words.

use super::Simulation;
use crate::contact::{ContactId, Partner};
use crate::error::StepError;
use crate::step::StepFailure;

impl Simulation {
    /// A failure in the scene's words.
    pub(super) fn explain(&self, failure: StepFailure, step: f64, cuts: u32) -> StepError {
        let time = self.state.time;
        if let Some((sphere, between)) = failure.pinched {
            let [a, b] = between.map(|b| &self.scene.boundaries[usize::from(b)].name);
            let boundaries = format!("`{a}` and `{b}`");
            return StepError::Pinched {
                time,
                sphere,
                boundaries,
            };
        }
        if let Some(passed) = failure.passed {
            return StepError::TooFast {
                time,
                step,
                contact: self.name(passed.contact),
                motion: passed.motion,
                advised: 0.5 * step / passed.motion,
                cuts,
            };
        }
        let contact = failure
            .contact
            .map_or_else(|| "the re-linearised gaps".to_owned(), |key| self.name(key));
        StepError::NotConverged {
            time,
            step,
            what: failure.what,
            residual: failure.residual,
            tolerance: failure.tolerance,
            contact,
            cuts,
            broken: failure
                .broken
                .map_or_else(String::new, |why| format!(" ({why})"))
                .into(),
        }
    }

    /// A pair in the scene's words.
    fn name(&self, key: ContactId) -> String {
        match key.partner {
            Partner::Sphere { index, .. } => format!("spheres {} and {index}", key.sphere),
            Partner::Boundary { boundary, .. } => format!(
                "sphere {} on boundary `{}`",
                key.sphere,
                self.scene.boundaries[usize::from(boundary)].name
            ),
        }
    }
}
