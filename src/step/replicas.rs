//! The step replica the step: its derivative along a direction of its data.
//!
//! A [`ReplicaPair`] is the same step from two states, a little to either side. What is smooth and closed-form (geometry, commands,
//! inertia, the way into the state) is done with each of the two, and half their difference is the derivative: error
//! of second order in a displacement of `3e-5` radii. The contact solve is not repeated: half the difference of the two problems goes
//! through the tangent of the solution, [`crate::solver::tangent`], pass by pass as gaps are re-linearised, and both get the
//! impulses of the solution changed by that.

use super::StepInput;
use super::assembly::Assembly;
use crate::linalg::LinearError;
use crate::solver::tangent::{Change, respond};
use crate::spatial::SpatialVector;
use crate::state::State;

/// A state replica the one that takes the step, and its own step.
#[derive(Debug)]
pub struct Replica<'a> {
    /// The state; on success it takes the step too.
    pub state: &'a mut State,
    /// Its own step.
    pub input: StepInput<'a>,
}

/// The step to either side, below and above.
pub(super) struct ReplicaPair<'a> {
    pub(super) stages: [Assembly<'a>; 2],
}

/// Lets replicas follow the solution of `stage`.
///
/// # Errors
/// [`LinearError`] if the tangent of the solution is singular.
pub(super) fn follow(stage: &Assembly, replicas: &mut [ReplicaPair]) -> Result<(), LinearError> {
    if replicas.is_empty() {
        return Ok(());
    }
    let velocity = stage.problem.velocities(&stage.impulses);
    let changes: Vec<Change> = replicas
        .iter()
        .map(|twin| change(stage, &velocity, twin))
        .collect();
    let responses = respond(&stage.problem, &stage.impulses, &changes)?;
    for (twin, response) in replicas.iter_mut().zip(responses) {
        for (side, sign) in twin.stages.iter_mut().zip([-1.0, 1.0]) {
            let changed = stage.impulses.iter().zip(&response);
            side.impulses = changed.map(|(p, change)| p + change * sign).collect();
        }
    }
    Ok(())
}

/// Half the difference of the twin's problems.
fn change(stage: &Assembly, velocity: &[SpatialVector], twin: &ReplicaPair) -> Change {
    let [below, above] = &twin.stages;
    let [low, high] = [below, above].map(|side| side.problem.velocities(&stage.impulses));
    let rows = || below.problem.rows.iter().zip(above.problem.rows.iter());
    let zero = SpatialVector::ZERO;
    Change {
        velocity: low
            .iter()
            .zip(&high)
            .map(|(low, high)| zero.plus(high, 0.5).plus(low, -0.5))
            .collect(),
        normal: rows()
            .map(|(low, high)| (high.normal - low.normal) * 0.5)
            .collect(),
        approach: rows()
            .map(|(low, high)| {
                let [low, high] = [low, high].map(|row| row.relative_velocity(velocity) + row.bias);
                (high - low) * 0.5
            })
            .collect(),
    }
}

impl ReplicaPair<'_> {
    /// Counts as impacts what `stage` does.
    pub(super) fn agree(&mut self, stage: &Assembly) {
        for side in &mut self.stages {
            side.impact.clone_from(&stage.impact);
            for (own, joint) in side.joints.iter_mut().zip(&stage.joints) {
                own.impact = joint.impact;
            }
        }
    }
}
