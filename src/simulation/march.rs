//! Internal steps of a communication step: equal, halved where one fails, landing exactly on its end.

use std::sync::Arc;

use super::{Simulation, StepReport, Wrench};
use crate::Vec3;
use crate::contacts::{Key, Partner};
use crate::drive::{Drive, displacement};
use crate::error::StepError;
use crate::motion::{Command, Motion, Pose};
use crate::observe::sensors::flow::{Gate, crossings};
use crate::scene::{Integrator, Measure, Scene};
use crate::state::State;
use crate::step::{StepFailure, step};

/// A communication step under way: see [`Simulation::begin`].
#[derive(Debug)]
pub struct March {
    before: State,
    start: f64,
    end: f64,
    steps: u64,
    done: u64,
    /// Where the boundaries stood, and when, as their commands last changed.
    from: Vec<Pose>,
    since: f64,
    commands: Vec<Command>,
    sums: Sums,
}

/// What is averaged over a communication step.
#[derive(Debug)]
struct Sums {
    /// Impulse on each boundary, `[B]`.
    impulse: Vec<Wrench>,
    /// Impulse of the body forces \[N s\].
    body_force: Vec3,
}

impl March {
    /// Whether the end is reached.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.done == self.steps
    }

    fn drive<'a>(&self, scene: &'a Scene) -> Drive<'a> {
        let (from, commands) = (&self.from, &self.commands);
        Drive::new(&scene.boundaries, commands, from, self.since, self.end)
    }
}

impl Simulation {
    /// Begins a step to exactly `end` \[s\] in equal internal steps, which [`Self::internal_step`] takes one by one:
    /// between them the state can be read and boundaries can be commanded anew. Without that the result is that of
    /// [`Self::advance_to`], bit for bit. Until the end is reached, or the rest is given up, no other step may be taken.
    ///
    /// # Errors
    /// [`StepError`] if `end` is not a finite time after the present, or a boundary would jump; nothing has changed.
    pub fn begin(&mut self, end: f64) -> Result<March, StepError> {
        let start = self.state.time;
        let h = end - start;
        if !(h > 0.0 && h.is_finite()) {
            return Err(StepError::Argument {
                what: "communication step",
                found: format!("{h} s"),
                expected: "a finite time after the current one",
            });
        }
        let march = March {
            before: self.state.clone(),
            start,
            end,
            // The margin keeps a communication step that is n internal steps but for rounding at n.
            steps: (h / self.scene.settings.step * (1.0 - 1e-9))
                .ceil()
                .max(1.0) as u64,
            done: 0,
            from: self.state.poses.clone(),
            since: start,
            commands: self.state.commands.clone(),
            sums: Sums {
                impulse: vec![Wrench::default(); self.scene.boundaries.len()],
                body_force: Vec3::zeros(),
            },
        };
        let drive = march.drive(&self.scene);
        self.check_jump(&drive, start, end, march.steps)?;
        self.state.report = StepReport::default();
        Ok(march)
    }

    /// Takes the next internal step of `march`, halved where it fails. Averages are over what has been taken of the
    /// communication step. Commands given since the last internal step hold from here to its end.
    ///
    /// # Errors
    /// As [`Self::advance_to`]: the state is as before [`Self::begin`].
    pub fn internal_step(&mut self, march: &mut March) -> Result<(), StepError> {
        let result = self.take(march);
        if result.is_err() {
            self.state.clone_from(&march.before);
        }
        result
    }

    fn take(&mut self, march: &mut March) -> Result<(), StepError> {
        if march.is_done() {
            return Ok(());
        }
        let scene = Arc::clone(&self.scene);
        let changed = march.commands != self.state.commands;
        if changed {
            march.since = self.state.time;
            march.from.clone_from(&self.state.poses);
            march.commands.clone_from(&self.state.commands);
        }
        let drive = march.drive(&scene);
        if changed {
            self.check_jump(&drive, march.since, march.end, march.steps - march.done)?;
        }
        march.done += 1;
        let (start, h) = (march.start, march.end - march.start);
        let target = if march.is_done() {
            march.end
        } else {
            start + h * (march.done as f64 / march.steps as f64)
        };
        self.step_to(&scene, &drive, target, 0, &mut march.sums)?;
        self.average(march);
        Ok(())
    }

    /// Means over what has been taken of the communication step.
    fn average(&mut self, march: &March) {
        let h = self.state.time - march.start;
        let means = self.state.mean_wrenches.iter_mut();
        for (mean, impulse) in means.zip(&march.sums.impulse) {
            mean.force = impulse.force / h;
            mean.torque = impulse.torque / h;
        }
        self.state.mean_body_force = march.sums.body_force / h;
        let totals = self.state.passed.iter().zip(&march.before.passed);
        self.state.flow = totals.map(|(now, then)| (now - then) / h).collect();
    }

    /// One internal step to `target`, or two half steps if it fails.
    fn step_to(
        &mut self,
        scene: &Scene,
        drive: &Drive,
        target: f64,
        cuts: u32,
        sums: &mut Sums,
    ) -> Result<(), StepError> {
        let start = self.state.time;
        let dt = target - start;
        let before = self.state.kinematics.position.clone();
        let persisting = self.state.persisting_wrenches.clone();
        let body_force = self.state.body_force;
        match step(
            scene,
            &mut self.state,
            &mut self.scratch,
            dt,
            drive.poses(target),
        ) {
            Ok(outcome) => {
                self.state.time = target;
                self.state.report.include(&outcome);
                self.check_finite()?;
                let shift = self.shift(dt);
                for (b, sum) in sums.impulse.iter_mut().enumerate() {
                    sum.add(&self.state.wrenches[b], dt);
                    // A step of another length moves the half step by persisting forces: their share.
                    sum.add(&self.state.persisting_wrenches[b], shift);
                    sum.add(&persisting[b], -shift);
                }
                let now = self.state.body_force;
                sums.body_force += now * dt + (now - body_force) * shift;
                self.count_crossings(&before);
                self.exchange();
                Ok(())
            }
            Err(failure) if cuts >= scene.settings.max_cuts => Err(self.explain(failure, dt, cuts)),
            Err(_) => {
                self.state.report.cuts += 1;
                let half = start + 0.5 * dt;
                self.step_to(scene, drive, half, cuts + 1, sums)?;
                self.step_to(scene, drive, target, cuts + 1, sums)
            }
        }
    }

    /// Time \[s\] by which the half step after a step of `dt` lies earlier than half a `simulation.step` before its end.
    pub(super) fn shift(&self, dt: f64) -> f64 {
        match self.scene.settings.integrator {
            Integrator::Moreau => 0.5 * (dt - self.scene.settings.step),
            Integrator::Shi => 0.0,
        }
    }

    fn count_crossings(&mut self, before: &[Vec3]) {
        for (sensor, passed) in self.scene.sensors.iter().zip(&mut self.state.passed) {
            if let Measure::MassFlow {
                point,
                normal,
                outline,
            } = &sensor.measure
            {
                let gate = Gate {
                    point: *point,
                    normal: *normal,
                    outline,
                };
                let after = &self.state.kinematics;
                let mass = &self.scene.particles.mass;
                *passed += crossings(
                    before,
                    &after.position,
                    mass,
                    &after.present,
                    gate,
                    &self.scene.cell,
                );
            }
        }
    }

    fn check_finite(&self) -> Result<(), StepError> {
        let kinematics = &self.state.kinematics;
        for sphere in 0..kinematics.len() {
            let kinds = [
                ("position", kinematics.position[sphere]),
                ("velocity", kinematics.velocity[sphere]),
                ("angular velocity", kinematics.spin[sphere]),
            ];
            for (what, value) in kinds {
                if !value.iter().all(|x| x.is_finite()) {
                    return Err(StepError::NotFinite {
                        time: self.state.time,
                        sphere,
                        what,
                    });
                }
            }
        }
        Ok(())
    }

    /// An input boundary must not move farther than the smallest radius in one internal step.
    fn check_jump(&self, drive: &Drive, start: f64, end: f64, steps: u64) -> Result<(), StepError> {
        let limit = self
            .scene
            .particles
            .radius
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let poses = drive.poses(start + (end - start) / steps as f64);
        for ((boundary, from), to) in self
            .scene
            .boundaries
            .iter()
            .zip(&self.state.poses)
            .zip(&poses)
        {
            if !matches!(boundary.motion, Motion::Input(_)) || from == to {
                continue;
            }
            let jump = displacement(boundary, from, to);
            if jump > limit {
                return Err(StepError::Jump {
                    boundary: boundary.name.clone(),
                    jump,
                    limit,
                });
            }
        }
        Ok(())
    }

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
    fn name(&self, key: Key) -> String {
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
