//! Derivatives by the commands of boundaries held over the last communication step.
//!
//! Two replicas of the simulation take the step again with a command a little below and above, each internal step through the
//! tangent of the contact solve ([`crate::step::Replica`]): contacts keep their states, and what is measured at the end is
//! compared. The step is chained with its internal steps: positions, velocities, orientations, smooth forces, driven
//! bodies and mean wrenches of one go into the next.

use super::Simulation;
use super::replay::ReplayedSimulation;
use crate::Vec3;
use crate::error::StepError;
use crate::scene::{Command, InputKind, Motion};
use crate::simulation::ReplayRecord;
use crate::state::State;

/// Displacement of the replicas over the smallest radius \[-\]: between rounding and curvature, both below 1e-9.
const SMALL: f64 = 3e-5;

/// A direction in which the command of a boundary changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction {
    /// Index of the boundary.
    pub boundary: usize,
    /// What is added to its command for each unit of the direction.
    pub change: Command,
}

impl Simulation {
    /// As [`Self::directional_derivatives`], of whatever numbers `measure` reads off a simulation.
    ///
    /// # Errors
    /// As [`Self::directional_derivatives`].
    pub fn directional_derivatives_of(
        &self,
        directions: &[Direction],
        measure: impl Fn(&Self) -> Vec<f64>,
    ) -> Result<Vec<Vec<f64>>, StepError> {
        let replay = self.came_from()?;
        let h = match replay {
            ReplayRecord::Start(_) => self.scene.settings.step,
            ReplayRecord::Step(step) => step.trajectory.length(),
        };
        let sizes: Vec<f64> = directions
            .iter()
            .map(|direction| self.size(replay.state(), direction, h))
            .collect::<Result<_, _>>()?;
        let changed = |k: usize, commands: &mut [Command], sign: f64| {
            let (b, change) = (directions[k].boundary, &directions[k].change);
            commands[b] = commands[b].plus(change, sign * sizes[k]);
        };
        let ends: Vec<[Self; 2]> = match replay {
            ReplayRecord::Step(step) => {
                let mut pairs: Vec<[ReplayedSimulation; 2]> = (0..directions.len())
                    .map(|k| {
                        [-1.0, 1.0].map(|sign| {
                            let mut trajectory = step.trajectory.clone();
                            changed(k, &mut trajectory.commands, sign);
                            ReplayedSimulation::of(self, step, trajectory)
                        })
                    })
                    .collect();
                self.replay(step, &mut pairs, |_, _| {})?;
                let pairs = pairs.into_iter();
                pairs.map(|pair| pair.map(|c| c.simulation)).collect()
            }
            ReplayRecord::Start(state) => {
                let mut pairs: Vec<[Self; 2]> = (0..directions.len())
                    .map(|k| {
                        [-1.0, 1.0].map(|sign| {
                            let mut state = state.clone();
                            changed(k, &mut state.commands, sign);
                            state.place(&self.scene);
                            self.at(state)
                        })
                    })
                    .collect();
                let mut states: Vec<[&mut State; 2]> = pairs
                    .iter_mut()
                    .map(|pair| pair.each_mut().map(|simulation| &mut *simulation.state))
                    .collect();
                self.start_again(state, &mut states)?;
                pairs
            }
        };
        let columns = ends.iter().zip(&sizes).map(|(pair, size)| {
            let [below, above] = pair.each_ref().map(&measure);
            let both = below.iter().zip(&above);
            both.map(|(a, b)| (b - a) / (2.0 * size)).collect()
        });
        Ok(columns.collect())
    }

    /// Units of a direction that displace its boundary, or what it pushes, by [`SMALL`] radii within `h` \[s\] from `state`.
    fn size(&self, state: &State, direction: &Direction, h: f64) -> Result<f64, StepError> {
        let (b, change) = (direction.boundary, &direction.change);
        let Some(boundary) = self.scene.boundaries.get(b).filter(|b| b.is_commanded()) else {
            return Err(StepError::Argument {
                what: "boundary",
                found: b.to_string(),
                expected: "the index of a boundary with an input",
            });
        };
        let smallest = self.scene.particles.smallest_radius();
        let pivot = boundary.point_of_action + state.poses[b].translation;
        // What turns moves the spheres, or its own corners, at this distance.
        let lever = match boundary.geometry.bounds() {
            Some((low, high)) => (high - low).norm() + (low - boundary.point_of_action).norm(),
            None => {
                let spheres = state.kinematics.position.iter();
                spheres.map(|x| (x - pivot).norm()).fold(smallest, f64::max)
            }
        };
        let mass = match &boundary.motion {
            Motion::Driven(body) => body.mass,
            _ => 1.0,
        };
        let (speed, turn, force) = (h, lever, h * h / mass);
        let scalar = match boundary.motion.input() {
            Some(InputKind::SlideSpeed { .. }) => speed,
            Some(InputKind::Hinge { .. }) => turn,
            Some(InputKind::HingeSpeed { .. }) => turn * speed,
            Some(InputKind::SlideForce { .. }) => force,
            Some(InputKind::HingeTorque { .. }) => force / lever,
            _ => 1.0,
        };
        let area = match &boundary.motion {
            Motion::Driven(body) => body
                .servo
                .as_ref()
                .map_or(1.0, |servo| servo.area.of(&self.scene, &state.poses)),
            _ => 1.0,
        };
        let length = |v: Vec3| v.norm();
        let displacement = length(change.translation)
            + length(change.rotation) * turn
            + length(change.position)
            + 2.0 * change.orientation.norm() * turn
            + length(change.velocity) * speed
            + length(change.angular_velocity) * turn * speed
            + length(change.force) * force
            + length(change.torque) * force / lever
            + length(change.surface_velocity) * speed
            + change.scalar.abs() * scalar
            + change.pressure.abs() * area * force;
        Ok(match displacement > 0.0 {
            true => SMALL * smallest.min(1.0) / displacement,
            false => 1.0,
        })
    }
}
