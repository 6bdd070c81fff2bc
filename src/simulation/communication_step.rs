//! Communication steps: internal steps, halved where one fails, and what is summed up over them.

use std::sync::Arc;

use super::replay_record::Step;
use super::step_control::Remedy;
use super::step_plan::StepPlan;
use super::{ReplayRecord, Simulation};
use crate::Vec3;
use crate::error::StepError;
use crate::scene::{Measure, Motion, Scene};
use crate::simulation::flow::{Gate, crossings};
use crate::simulation::impulse_totals::{Before, ImpulseTotals};
use crate::simulation::trajectory::{BoundaryPaths, Trajectory, displacement};
use crate::spatial::Wrench;
use crate::state::{SharedState, State, StepControl, StepReport, Wall};
use crate::step::{Effort, REMAINDER, StepFailure, step};

/// A communication step under way: see [`Simulation::begin`].
#[derive(Debug)]
pub struct CommunicationStep {
    before: SharedState,
    /// Where `before` came from, to be given back if the step fails.
    replay: Option<Arc<ReplayRecord>>,
    plan: StepPlan,
    trajectory: Trajectory,
    /// State and totals where commands last changed within the step.
    midway: Option<(SharedState, ImpulseTotals)>,
    totals: ImpulseTotals,
}

impl CommunicationStep {
    /// Whether the end is reached.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.plan.left() == 0
    }
}

/// Most internal steps of a communication step: more would take hours, and is a mistake in its units as a rule.
const MOST_STEPS: f64 = 1e7;

impl Simulation {
    /// Begins a step to exactly `end` \[s\] in equal internal steps, which [`Self::internal_step`] takes one by one:
    /// between them the state can be read and boundaries can be commanded anew. Without that the result is that of
    /// [`Self::advance_to`], bit for bit. Until the end is reached, or the rest is given up, no other step may be taken.
    ///
    /// # Errors
    /// [`StepError`] if `end` is not a finite time after the present, or more than 1e7 internal steps away, or a boundary would
    /// jump; nothing has changed.
    pub fn begin(&mut self, end: f64) -> Result<CommunicationStep, StepError> {
        self.set_out(end, true)
    }

    /// [`Self::begin`] that keeps the replay of the present state only if it is to come `back` where the step fails; its memory
    /// otherwise serves for the copy that a failed step restores: two states in memory instead of three.
    pub(super) fn set_out(&mut self, end: f64, back: bool) -> Result<CommunicationStep, StepError> {
        let start = self.state.time;
        let h = end - start;
        if !(h > 0.0 && h.is_finite()) {
            return Err(StepError::Argument {
                what: "communication step",
                found: format!("{h} s"),
                expected: "a finite time after the current one",
            });
        }
        // Steps that are chosen are not longer.
        let step = self.scene.settings.step;
        if h / step > MOST_STEPS {
            return Err(StepError::Argument {
                what: "communication step",
                found: format!(
                    "{h:e} s, which is {:.0e} internal steps of {step} s",
                    h / step
                ),
                expected: "at most 1e7 of them: take shorter communication steps",
            });
        }
        let state = &self.state;
        let trajectory = Trajectory {
            from: state.poses.clone(),
            since: start,
            end,
            commands: state.commands.clone(),
            rates: state.rates.clone(),
        };
        let plan = StepPlan::new(start, end, state.control.step, self.scene.settings.step);
        self.check_jump(&trajectory.paths(&self.scene), start, end, plan.left())?;
        let replay = self.replay.take();
        let (replay, memory) = match back {
            true => (replay, None),
            false => (
                None,
                replay
                    .and_then(Arc::into_inner)
                    .map(ReplayRecord::into_state),
            ),
        };
        let before = self.state.fork(memory);
        self.state.report = StepReport::default();
        if self.state.last_step == 0.0 {
            self.state.momentum_step = plan.length().min(step);
        }
        // One too short for a mean of its own goes on with the last one.
        if h >= REMAINDER * self.state.last_step {
            self.state
                .walls
                .begin(start, self.scene.output.vtu_interval);
        }
        Ok(CommunicationStep {
            before,
            replay,
            plan,
            trajectory,
            midway: None,
            totals: ImpulseTotals::of(self.scene.boundaries.len()),
        })
    }

    /// Takes the next internal step of `communication`, halved where it fails. Averages are over what has been taken of the
    /// communication step. Commands given since the last internal step hold from here to its end.
    ///
    /// # Errors
    /// As [`Self::advance_to`]: the state is as before [`Self::begin`], and so is its [`Self::replay_record`].
    pub fn internal_step(
        &mut self,
        communication: &mut CommunicationStep,
    ) -> Result<(), StepError> {
        let result = self.take(communication);
        if result.is_err() {
            self.put_back(communication);
        }
        result
    }

    /// Gives `communication` up: the state is as before [`Self::begin`], and so is its [`Self::replay_record`].
    pub fn put_back(&mut self, communication: &mut CommunicationStep) {
        self.state = communication.before.clone();
        self.replay = communication.replay.take();
    }

    fn take(&mut self, communication: &mut CommunicationStep) -> Result<(), StepError> {
        if communication.is_done() {
            return Ok(());
        }
        let scene = Arc::clone(&self.scene);
        self.take_commands(communication)?;
        let paths = communication.trajectory.paths(&scene);
        let chosen = scene.settings.smallest_step.is_some();
        let wanted = chosen.then_some(self.state.control.step);
        let next = communication.plan.next(self.state.time, wanted);
        self.step_to(&scene, &paths, next, 0, &mut communication.totals)?;
        self.average(&communication.totals);
        let h = self.state.time - communication.plan.start();
        let totals = self.state.passed.iter().zip(&communication.before.passed);
        self.state.flow = totals.map(|(now, then)| (now - then) / h).collect();
        Ok(())
    }

    /// Lets commands, forces and gravity given since the last internal step hold from here to the end of the communication step.
    fn take_commands(&mut self, communication: &mut CommunicationStep) -> Result<(), StepError> {
        let (state, trajectory) = (&self.state, &mut communication.trajectory);
        let midway = communication.midway.as_ref().map(|(state, _)| state);
        let before: &State = midway.unwrap_or(&communication.before);
        if trajectory.commands == state.commands
            && trajectory.rates == state.rates
            && before.applied_forces == state.applied_forces
            && before.gravity == state.gravity
        {
            return Ok(());
        }
        trajectory.since = state.time;
        trajectory.from.clone_from(&state.poses);
        trajectory.commands.clone_from(&state.commands);
        trajectory.rates.clone_from(&state.rates);
        let memory = communication.midway.take().map(|(state, _)| state);
        let now = self.state.fork(memory);
        communication.midway = Some((now, communication.totals.clone()));
        let left = communication.plan.left();
        let paths = communication.trajectory.paths(&self.scene);
        self.check_jump(&paths, self.state.time, communication.trajectory.end, left)
    }

    /// All that is left of a communication step, and its end.
    ///
    /// # Errors
    /// As [`Self::internal_step`].
    pub fn finish(&mut self, mut communication: CommunicationStep) -> Result<(), StepError> {
        while !communication.is_done() {
            self.internal_step(&mut communication)?;
        }
        self.end(communication);
        Ok(())
    }

    /// Ends a communication step where its last internal step has ended. Derivatives of commands end with it, and
    /// [`Self::directional_derivatives`] are those of this step.
    pub fn end(&mut self, communication: CommunicationStep) {
        self.state.rates.clear();
        self.carry_over(&communication);
        let none = ImpulseTotals::of(self.scene.boundaries.len());
        let averages = communication.before.mean_wrenches.clone();
        let (mut state, before) = communication.midway.unwrap_or((communication.before, none));
        state.momentum_step = self.state.momentum_step;
        let mut totals = communication.totals;
        totals.taken.drain(..before.taken.len());
        let step = Step {
            state,
            start: communication.plan.start(),
            trajectory: communication.trajectory,
            taken: totals.taken,
            averages,
            before,
        };
        self.replay = Some(Arc::new(ReplayRecord::Step(Box::new(step))));
    }

    /// The remainder of a step is no shock: where a communication step is shorter than [`REMAINDER`] of the internal step before
    /// it, what is left of velocities would come out as a force without bound. The forces before it stand, and what they miss
    /// of the impulse goes into the means of the next step.
    fn carry_over(&mut self, communication: &CommunicationStep) {
        let (state, before) = (&mut self.state, &communication.before);
        if communication.plan.length() >= REMAINDER * before.last_step {
            state.owed.fill(Wrench::default());
            return;
        }
        state.wrenches.clone_from(&before.wrenches);
        state.mean_wrenches.clone_from(&before.mean_wrenches);
        state.contacts.clone_from(&before.contacts);
        state.broken_bonds = before.broken_bonds;
        for (b, owed) in state.owed.iter_mut().enumerate() {
            owed.add(&communication.totals.impulse[b], 1.0);
            owed.add(&before.mean_wrenches[b], -communication.plan.length());
        }
    }

    /// Means over what has been taken of the communication step.
    pub(super) fn average(&mut self, totals: &ImpulseTotals) {
        let h = totals.length;
        let state = &mut *self.state;
        let means = state.mean_wrenches.iter_mut();
        for (mean, (impulse, owed)) in means.zip(totals.impulse.iter().zip(&state.owed)) {
            mean.force = (impulse.force + owed.force) / h;
            mean.torque = (impulse.torque + owed.torque) / h;
        }
        state.mean_body_force = totals.body_force / h;
    }

    /// One internal step of `dt` to `target` \[s\], or two of half its length if it fails.
    fn step_to(
        &mut self,
        scene: &Scene,
        paths: &BoundaryPaths,
        (target, dt): (f64, f64),
        cuts: u32,
        totals: &mut ImpulseTotals,
    ) -> Result<(), StepError> {
        if self.rest_to(scene, paths, target) {
            totals.stand(&self.state, (target, dt));
            self.state.walls.stand(dt);
            return Ok(());
        }
        let settings = &scene.settings;
        let effort = self.state.control.effort(settings, dt, cuts);
        let Err(failure) = self.try_step(scene, paths, (target, dt), effort, totals)? else {
            return Ok(());
        };
        match StepControl::remedy(settings, &failure, (dt, cuts)) {
            Remedy::GiveUp => Err(self.explain(failure, dt, cuts)),
            Remedy::Cut => {
                self.state.report.cuts += 1;
                self.state.control.cut(settings, &failure, dt);
                let half = 0.5 * dt;
                let middle = self.state.time + half;
                let mut part = |end| self.step_to(scene, paths, (end, half), cuts + 1, totals);
                let parts = part(middle).and_then(|()| part(target));
                parts.map_err(|error| self.explain_part(error, failure.pinched))
            }
            Remedy::Accept => {
                let effort = StepControl::last_effort(&failure);
                self.try_step(scene, paths, (target, dt), effort, totals)?
                    .map_err(|failure| self.explain(failure, dt, cuts))
            }
        }
    }

    /// One internal step of `dt` to `target` \[s\]; one that fails changes nothing.
    fn try_step(
        &mut self,
        scene: &Scene,
        paths: &BoundaryPaths,
        (target, dt): (f64, f64),
        effort: Effort,
        totals: &mut ImpulseTotals,
    ) -> Result<Result<(), StepFailure>, StepError> {
        let before = Before::of(scene, &self.state);
        let integrator = scene.settings.integrator;
        let input = paths.step_input(integrator, self.state.time, (target, dt));
        let taken = step(scene, &mut self.state, &mut self.workspace, &input, effort);
        let outcome = match taken {
            Ok(outcome) => outcome,
            Err(failure) => return Ok(Err(failure)),
        };
        self.state.time = target;
        self.state.report.include(&outcome);
        self.state.control.learn(&scene.settings, dt, &outcome);
        self.check_finite()?;
        self.book(&before, dt, totals);
        totals.taken.push((target, dt));
        self.exchange();
        Ok(Ok(()))
    }

    /// Sums up what an internal step of `dt` \[s\] has done.
    pub(super) fn book(&mut self, before: &Before, dt: f64, totals: &mut ImpulseTotals) {
        totals.length += dt;
        let settings = &self.scene.settings;
        let shift = settings.integrator.shift(dt, self.state.momentum_step);
        for (b, sum) in totals.impulse.iter_mut().enumerate() {
            sum.add(&self.state.wrenches[b], dt);
            // A step of another length moves the half step by smooth forces: their share.
            sum.add(&self.state.smooth_wrenches[b], shift);
            sum.add(&before.smooth[b], -shift);
        }
        for (wall, before) in self.state.walls.list.iter_mut().zip(&before.walls) {
            Wall::press(&mut wall.triangles, &wall.loads, dt);
            Wall::press(&mut wall.triangles, &wall.smooth, shift);
            Wall::press(&mut wall.triangles, before, -shift);
        }
        let now = self.state.body_force;
        totals.body_force += now * dt + (now - before.body_force) * shift;
        self.count_crossings(&before.position);
    }

    fn count_crossings(&mut self, before: &[Vec3]) {
        let state = &mut *self.state;
        for (sensor, passed) in self.scene.sensors.iter().zip(&mut state.passed) {
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
                let after = &state.kinematics;
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
        // Zero times all numbers is zero, unless one of them is none.
        let moving = kinematics.velocity.iter().zip(&kinematics.spin);
        let spheres = kinematics.position.iter().zip(moving);
        let zeros = spheres.map(|(x, (v, w))| (x + v + w).sum() * 0.0);
        if zeros.sum::<f64>() == 0.0 {
            return self.check_finite_boundaries();
        }
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

    fn check_finite_boundaries(&self) -> Result<(), StepError> {
        let state = &self.state;
        let not_finite = |boundary: usize, what| StepError::BoundaryNotFinite {
            time: state.time,
            boundary: self.scene.boundaries[boundary].name.clone(),
            what,
        };
        for (b, pose) in state.poses.iter().enumerate() {
            let mut numbers = pose.translation.iter().chain(pose.rotation.coords.iter());
            if !numbers.all(|x| x.is_finite()) {
                return Err(not_finite(b, "pose"));
            }
        }
        for ((b, _), body) in self.scene.driven().zip(&state.bodies) {
            let velocity = &body.velocity;
            let mut numbers = velocity.linear.iter().chain(velocity.angular.iter());
            if !numbers.all(|x| x.is_finite()) {
                return Err(not_finite(b, "velocity"));
            }
        }
        Ok(())
    }

    /// An input boundary must not move farther than the smallest radius in one internal step.
    fn check_jump(
        &self,
        paths: &BoundaryPaths,
        start: f64,
        end: f64,
        steps: u64,
    ) -> Result<(), StepError> {
        let limit = self.scene.particles.smallest_radius();
        // With a constant twist every internal step is as long as the first.
        let looked_at = if paths.bends() { steps } else { 1 };
        let mut before = self.state.poses.clone();
        for k in 1..=looked_at {
            let poses = paths.poses(start + (end - start) * (k as f64 / steps as f64));
            let ways = before.iter().zip(&poses);
            for (boundary, (from, to)) in self.scene.boundaries.iter().zip(ways) {
                if !matches!(boundary.motion, Motion::Input(_)) || from == to {
                    continue;
                }
                let spheres = &self.state.kinematics;
                let spheres = spheres.position.iter().zip(&spheres.present);
                let present = spheres.filter(|(_, present)| **present).map(|(x, _)| *x);
                let jump = displacement(boundary, [from, to], present);
                if jump > limit || jump.is_nan() {
                    return Err(StepError::Jump {
                        boundary: boundary.name.clone(),
                        jump,
                        limit,
                    });
                }
            }
            before = poses;
        }
        Ok(())
    }
}
