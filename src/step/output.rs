//! What a step leaves, or why it failed.

use crate::linalg::LinearError;
use crate::solver::Report;
use crate::state::Squeezed;

/// Cost and quality of one internal step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StepOutput {
    /// The solver's report, summed over passes.
    pub solver: Report,
    /// Largest true overlap over radius at the end \[-\].
    pub max_overlap: f64,
    /// Largest gap over radius at which a contact carries load at the end \[-\].
    pub max_opening: f64,
    /// Largest compression over radius of a contact that gives way at the end \[-\].
    pub max_compression: f64,
    /// How near a contact is to the edge of its state \[-\]: `state::StepReport::active_set_closeness`.
    pub active_set_closeness: f64,
    /// Whether the tolerances were not met and the best iterate was taken.
    pub unconverged: bool,
    /// A sphere whose contacts with boundaries give way.
    pub squeezed: Option<Squeezed>,
}

impl StepOutput {
    pub(super) fn of(
        solver: Report,
        [max_overlap, max_opening, max_compression]: [f64; 3],
    ) -> Self {
        Self {
            solver,
            max_overlap,
            max_opening,
            max_compression,
            active_set_closeness: solver.residual.active_set_closeness,
            unconverged: false,
            squeezed: None,
        }
    }
}

/// How a step ends that does not fail.
#[derive(Debug, PartialEq)]
pub(crate) enum Taken {
    /// With the next state.
    Done(StepOutput),
    /// Without, for something would reach what takes no part; what the solver has done.
    Outgrown(Report),
}

/// Why an internal step failed; the caller may cut it.
#[derive(Debug, Clone, PartialEq)]
pub struct StepFailure {
    /// Which residual: `gap`, `slip` or `force`.
    pub what: &'static str,
    /// Its value \[-\].
    pub residual: f64,
    /// What was asked for \[-\].
    pub tolerance: f64,
    /// The worst contact, if there is one.
    pub contact: Option<crate::contact::ContactId>,
    /// A sphere that two rigid boundaries squeeze, and the boundaries.
    pub pinched: Option<Squeezed>,
    /// Two bodies that would pass through each other within the step.
    pub passed: Option<Tunnelling>,
    /// The linear system that ended the solver early.
    pub broken: Option<Box<LinearError>>,
}

impl StepFailure {
    /// The spheres of contacts at which the step failed, as far as is known.
    pub(super) fn spheres(&self) -> Vec<usize> {
        let passed = self.passed.map(|passed| passed.contact);
        let contacts = self.contact.into_iter().chain(passed);
        contacts.flat_map(|contact| contact.spheres()).collect()
    }
}

/// Two bodies that move so far against each other in a step that the gaps at its ends do not decide what happens between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tunnelling {
    /// The pair; of a boundary's features none in particular.
    pub contact: crate::contact::ContactId,
    /// Relative motion over the smaller radius \[-\].
    pub motion: f64,
}
