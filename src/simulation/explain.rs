//! Failures of steps in the scene's words.

use super::Simulation;
use crate::contact::{ContactId, Partner};
use crate::error::StepError;
use crate::scene::Scene;
use crate::state::Squeezed;
use crate::step::StepFailure;

impl Squeezed {
    /// What a user can do about it, in the words of its scene.
    #[must_use]
    pub fn advice(self, scene: &Scene) -> String {
        format!(
            "sphere {} is squeezed between {}; give one of them `stiffness` (N/m) or drive it by force",
            self.sphere,
            boundaries(scene, self)
        )
    }
}

fn boundaries(scene: &Scene, squeezed: Squeezed) -> String {
    let name = |b: u16| scene.boundaries.get(usize::from(b)).map_or("", |b| &b.name);
    let [a, b] = squeezed.boundaries.map(name);
    match squeezed.by_others {
        true => format!("`{a}` and `{b}` (with other spheres)"),
        false => format!("`{a}` and `{b}`"),
    }
}

impl Simulation {
    /// A failure in the scene's words.
    pub(super) fn explain(&self, failure: StepFailure, step: f64, cuts: u32) -> StepError {
        let time = self.state.time;
        if let Some(squeezed) = failure.pinched {
            return self.pinched(squeezed);
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

    /// A failure of a part of a step in which a sphere is squeezed: over a short part boundaries hardly
    /// approach each other, and what they press out of their way passes them.
    pub(super) fn explain_part(&self, error: StepError, whole: Option<Squeezed>) -> StepError {
        match (error, whole) {
            (StepError::NotConverged { .. } | StepError::TooFast { .. }, Some(squeezed)) => {
                self.pinched(squeezed)
            }
            (error, _) => error,
        }
    }

    fn pinched(&self, squeezed: Squeezed) -> StepError {
        StepError::Pinched {
            time: self.state.time,
            sphere: squeezed.sphere,
            boundaries: boundaries(&self.scene, squeezed),
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
