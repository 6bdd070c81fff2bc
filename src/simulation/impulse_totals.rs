//! What is summed up over a communication step.

use serde::{Deserialize, Serialize};

use crate::Vec3;
use crate::scene::{Measure, Scene};
use crate::spatial::Wrench;
use crate::state::{State, TriangleLoads};

/// What is summed up over a communication step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct ImpulseTotals {
    /// Impulse on each boundary, `[B]`.
    pub(super) impulse: Vec<Wrench>,
    /// Sum of the internal steps \[s\].
    pub(super) length: f64,
    /// Impulse of the body forces \[N s\].
    pub(super) body_force: Vec3,
    /// Ends and lengths of the internal steps taken \[s\].
    pub(super) taken: Vec<(f64, f64)>,
}

impl ImpulseTotals {
    pub(super) fn of(boundaries: usize) -> Self {
        Self {
            impulse: vec![Wrench::default(); boundaries],
            length: 0.0,
            body_force: Vec3::zeros(),
            taken: Vec::new(),
        }
    }

    /// Adds a step of length `dt` to `target` \[s\] in which nothing moves.
    pub(super) fn stand(&mut self, state: &State, (target, dt): (f64, f64)) {
        for (sum, wrench) in self.impulse.iter_mut().zip(&state.wrenches) {
            sum.add(wrench, dt);
        }
        self.length += dt;
        self.body_force += state.body_force * dt;
        self.taken.push((target, dt));
    }

    pub(super) fn fits(&self, boundaries: usize) -> bool {
        self.impulse.len() == boundaries
    }
}

/// What an internal step began with.
#[derive(Debug)]
pub(super) struct Before {
    /// Empty where no sensor asks.
    pub(super) position: Vec<Vec3>,
    pub(super) smooth: Vec<Wrench>,
    pub(super) walls: Vec<TriangleLoads>,
    pub(super) body_force: Vec3,
}

impl Before {
    pub(super) fn of(scene: &Scene, state: &State) -> Self {
        Self {
            position: match flows(scene) {
                true => state.kinematics.position.clone(),
                false => Vec::new(),
            },
            smooth: state.smooth_wrenches.clone(),
            walls: state
                .walls
                .list
                .iter()
                .map(|wall| wall.smooth.clone())
                .collect(),
            body_force: state.body_force,
        }
    }
}

/// Whether there are sensors that must know where spheres were.
fn flows(scene: &Scene) -> bool {
    let mut sensors = scene.sensors.iter();
    sensors.any(|sensor| matches!(sensor.measure, Measure::MassFlow { .. }))
}
