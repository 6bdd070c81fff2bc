//! Derivatives by the commands of boundaries held over the last communication step.
//!
//! Two companions of the simulation take the step again with a command a little below and above, each internal step through the
//! tangent of the contact solve ([`crate::step::Beside`]): contacts keep their states, and what is measured at the end is
//! compared. The step is chained with its internal steps: positions, velocities, orientations, persisting forces, driven
//! bodies and mean wrenches of one go into the next.

use super::{Companion, Simulation};
use crate::Vec3;
use crate::boundaries::Boundary;
use crate::error::StepError;
use crate::motion::{Command, InputKind, Motion, Pose};
use crate::observe::Observation;
use crate::observe::quantities::values;

/// Displacement of the companions over the smallest radius \[-\]: between rounding and curvature, both below 1e-9.
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
    /// Derivative of all quantities ([`crate::observe::quantities`]) at the end of the last communication step by each of
    /// `directions`, in their units over that of the direction. Counts and the solver's report have none, which is
    /// given as 0. At a kink, where a contact is at the edge of its state, it is one-sided.
    ///
    /// # Errors
    /// [`StepError::Argument`] before the first step or if a direction is of no such boundary, [`StepError::NotConverged`]
    /// if the tangent of the contact solve is singular.
    pub fn sensitivities(&self, directions: &[Direction]) -> Result<Vec<Vec<f64>>, StepError> {
        self.sensitivities_of(directions, |simulation| {
            values(&Observation::of(simulation))
        })
    }

    /// As [`Self::sensitivities`], of whatever numbers `measure` reads off a simulation.
    ///
    /// # Errors
    /// As [`Self::sensitivities`].
    pub fn sensitivities_of(
        &self,
        directions: &[Direction],
        measure: impl Fn(&Self) -> Vec<f64>,
    ) -> Result<Vec<Vec<f64>>, StepError> {
        let Some(origin) = self.origin() else {
            return Err(StepError::Argument {
                what: "derivatives",
                found: "no step".to_owned(),
                expected: "a communication step before them",
            });
        };
        let mut sizes = Vec::with_capacity(directions.len());
        let mut pairs = Vec::with_capacity(directions.len());
        for direction in directions {
            let b = direction.boundary;
            let Some(boundary) = self.scene.boundaries.get(b).filter(|b| b.is_commanded()) else {
                return Err(StepError::Argument {
                    what: "boundary",
                    found: b.to_string(),
                    expected: "the index of a boundary with an input",
                });
            };
            let h = origin.course.length();
            let size = self.size(boundary, &origin.state.poses[b], &direction.change, h);
            sizes.push(size);
            pairs.push([-size, size].map(|size| {
                let mut course = origin.course.clone();
                course.commands[b] = course.commands[b].plus(&direction.change, size);
                Companion::new(self, origin, course)
            }));
        }
        self.replay(origin, &mut pairs, |_, _| {})?;
        let columns = pairs.iter().zip(&sizes).map(|(pair, size)| {
            let [below, above] = [0, 1].map(|k| measure(&pair[k].simulation));
            let both = below.iter().zip(&above);
            both.map(|(a, b)| (b - a) / (2.0 * size)).collect()
        });
        Ok(columns.collect())
    }

    /// Units of `change` that displace `boundary`, or what it pushes, by [`SMALL`] radii within `h` \[s\].
    fn size(&self, boundary: &Boundary, pose: &Pose, change: &Command, h: f64) -> f64 {
        let radius = &self.scene.particles.radius;
        let smallest = radius.iter().copied().fold(f64::INFINITY, f64::min);
        let pivot = boundary.point_of_action + pose.translation;
        // What turns moves the spheres, or its own corners, at this distance.
        let lever = match boundary.geometry.bounds() {
            Some((low, high)) => (high - low).norm() + (low - boundary.point_of_action).norm(),
            None => {
                let spheres = self.state.kinematics.position.iter();
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
                .map_or(1.0, |servo| servo.area.of(&self.scene, &self.state.poses)),
            _ => 1.0,
        };
        let length = |v: Vec3| v.norm();
        let displacement = length(change.translation)
            + length(change.rotation) * turn
            + length(change.velocity) * speed
            + length(change.angular_velocity) * turn * speed
            + length(change.force) * force
            + length(change.torque) * force / lever
            + length(change.surface_velocity) * speed
            + change.scalar.abs() * scalar
            + change.pressure.abs() * area * force;
        match displacement > 0.0 {
            true => SMALL * smallest.min(1.0) / displacement,
            false => 1.0,
        }
    }
}
