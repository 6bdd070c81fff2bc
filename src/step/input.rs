//! What a step is asked for.

use std::borrow::Cow;

use crate::scene::Command;
use crate::spatial::Pose;

/// How far a step goes before it fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effort {
    /// Most Gauss-Seidel sweeps of a solve, where the step can be cut instead; `None`: every solver as long as it may.
    pub sweeps: Option<usize>,
    /// Whether the best iterate of a solve that does not converge is taken.
    pub accept: bool,
    /// Whether bodies may move so far against each other that they could pass.
    pub pass: bool,
}

/// An internal step: how long, where to, and under which commands.
#[derive(Debug, Clone)]
pub struct StepInput<'a> {
    /// Length \[s\].
    pub dt: f64,
    /// Poses of the boundaries at its end, `[B]`; those of driven bodies follow from the step.
    pub poses: Vec<Pose>,
    /// Commands within it, `[B]`: loads, surface velocities and pressures.
    pub commands: Cow<'a, [Command]>,
}

#[cfg(test)]
impl StepInput<'static> {
    /// A step of `dt` \[s\] from `state` in which nothing moves that is prescribed.
    pub(crate) fn still(state: &crate::state::State, dt: f64) -> Self {
        Self {
            dt,
            poses: state.poses.clone(),
            commands: Cow::Owned(state.commands.clone()),
        }
    }
}
