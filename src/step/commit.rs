//! From a solution to the next state: motion, contact forces, wrenches, work.

use std::iter::repeat;
use std::ops::Range;

use nalgebra::UnitQuaternion;

use super::assemble::joint::JointConstraint;
use super::assembly::Assembly;
use super::external;
use crate::Vec3;
use crate::contact::{ContactForce, Partner};
use crate::integrator::Integrator;
use crate::problem::{GROUND, Law};
use crate::scene::Scene;
use crate::spatial::{Pose, SpatialVector, Wrench, turned};
use crate::state::{BodyState, EnergyLedger, State};
use crate::step::prediction::Prediction;

/// Of pieces of the spheres: centres and orientations.
type Places<'a> = (&'a mut [Vec3], &'a mut [UnitQuaternion<f64>]);
/// Likewise velocities and spins.
type Velocities<'a> = (&'a mut [Vec3], &'a mut [Vec3]);

impl Assembly<'_> {
    /// Counts as impacts the contacts that an impact has hit through others: their impulses are more than twice what they
    /// carried before and what loads bring in a step. As persisting forces they would shift the half step.
    pub(super) fn spread_impacts(&mut self, state: &State) {
        let struck = |(k, p): (usize, &Vec3)| *p != Vec3::zeros() && self.is_impact(k);
        if !self.impulses.iter().enumerate().any(struck) {
            return;
        }
        let step = self.inputs.step;
        let first = self.first_joint();
        for (k, joint) in self.joints.iter_mut().enumerate() {
            let load = self.inputs.weight(self.problem.rows.bodies(first + k)[0]);
            let before = joint.limit.force.abs();
            let handed_on = self.impulses[first + k].norm() > 2.0 * step * (before + load);
            joint.impact |= joint.limit.stops() && handed_on;
        }
        for (k, (impact, past)) in self.impact.iter_mut().zip(&self.past).enumerate() {
            let size = self.impulses[k].norm();
            let before = past.force(&state.contacts).norm();
            // Most carry what they did.
            if size <= 2.0 * step * before {
                continue;
            }
            let bodies = self.problem.rows.bodies(k);
            let load = bodies.map(|body| self.inputs.weight(body));
            let load = load[0].max(load[1]);
            *impact |= size > 2.0 * step * (before + load);
        }
    }

    /// Contact forces and boundary wrenches into `state`.
    pub(super) fn store(&self, state: &mut State) {
        let step = self.inputs.step;
        let boundaries = &self.inputs.scene.boundaries;
        state.contacts.clear();
        state.wrenches = vec![Wrench::default(); boundaries.len()];
        state.smooth_wrenches.clone_from(&state.wrenches);
        let couples = self.couples();
        for (k, candidate) in self.candidates.iter().enumerate() {
            let force = self.impulses[k] / step;
            let couple = couples.get(k).copied();
            if force == Vec3::zeros() {
                continue;
            }
            let load = ContactForce {
                key: candidate.key,
                normal: candidate.normal,
                force,
            };
            state.contacts.push(load, couple);
            if let Partner::Boundary { boundary, .. } = candidate.key.partner {
                let b = usize::from(boundary);
                let row = self.problem.rows.get(k);
                let pose = &self.inputs.poses[0][b];
                let centre = self.inputs.kinematics.position[row.a as usize];
                let centre = boundaries[b].copy_near(&self.inputs.scene.cell, pose, centre);
                let point = centre + row.arm_a;
                let pivot = boundaries[b].point_of_action + self.inputs.poses[0][b].translation;
                let wrench = Wrench {
                    force: -force,
                    torque: -(point - pivot).cross(&force) - couple.unwrap_or_default(),
                };
                state.wrenches[b].add(&wrench, 1.0);
                if !self.impact[k] {
                    state.smooth_wrenches[b].add(&wrench, 1.0);
                }
            }
        }
    }

    /// Couple \[N m\] of each contact's resistance on A, `[contacts]`; empty where there is no resistance.
    fn couples(&self) -> Vec<Vec3> {
        if !self.inputs.scene.pairs.resists() {
            return Vec::new();
        }
        let mut couples = vec![Vec3::zeros(); self.candidates.len()];
        for (k, impulse) in self.impulses.iter().enumerate() {
            if let Some(row) = self.problem.rows.general(k)
                && let Law::Resistance { contact, .. } = row.law
            {
                couples[contact as usize] = impulse * (row.radius / self.inputs.step);
            }
        }
        couples
    }

    pub(super) fn spring_forces(&self) -> Vec<Vec3> {
        self.impulses[self.candidates.len()..][..self.inputs.targets.len()]
            .iter()
            .map(|p| p / self.inputs.step)
            .collect()
    }

    /// Velocities before the step, `[N + D]`.
    pub(super) fn before(&self) -> Vec<SpatialVector> {
        (0..self.problem.free.len())
            .map(|i| self.before_of(i))
            .collect()
    }

    /// Velocity of one body before the step.
    fn before_of(&self, i: usize) -> SpatialVector {
        let kinematics = self.inputs.kinematics;
        match i.checked_sub(kinematics.len()) {
            None => kinematics.spatial_velocity(i),
            Some(rank) => self.inputs.bodies[rank].velocity,
        }
    }

    /// What the driven bodies carry on after `solution`, and the work of their dampers \[J\], `[D]`.
    pub(super) fn finished(
        &self,
        solution: &[SpatialVector],
        ends: &[Pose],
    ) -> Vec<(BodyState, f64)> {
        let spheres = self.inputs.kinematics.len();
        let bodies = self.inputs.bodies.iter().enumerate();
        bodies
            .map(|(d, body)| {
                let [mut contacts, mut smooth] = [SpatialVector::ZERO; 2];
                let mut joint_forces = [0.0; 3];
                let rank = (spheres + d) as u32;
                for (k, &p) in self.impulses.iter().enumerate() {
                    let bodies = self.problem.rows.bodies(k);
                    let Some(side) = bodies.iter().position(|&body| body == rank) else {
                        continue;
                    };
                    let grip = self.problem.rows.get(k).jacobian()[side];
                    let push = grip.momentum([p, -p][side]);
                    if let Some(JointConstraint { limit, .. }) = self.joint(k) {
                        let force = p.dot(&limit.direction) / self.inputs.step;
                        joint_forces[limit.slot()] = force * limit.lever;
                    }
                    contacts = contacts.plus(&push, 1.0);
                    if !self.is_impact(k) {
                        smooth = smooth.plus(&push, 1.0);
                    }
                }
                let settings = &self.inputs.scene.settings;
                let impulses = [&contacts, &smooth];
                let end = &ends[body.boundary];
                body.finish(
                    settings,
                    &solution[spheres + d],
                    impulses,
                    joint_forces,
                    end,
                    self.inputs.step,
                )
            })
            .collect()
    }

    /// Acceleration by external forces and all contacts that are no impacts, `[N]`: what `solution` has over the free motion,
    /// less what impacts gave.
    pub(super) fn persisting_acceleration(
        &self,
        solution: &[SpatialVector],
        acceleration: &mut Vec<SpatialVector>,
    ) {
        let mobility = self.inputs.scene.settings.integrator.mobility();
        let rate = 1.0 / (mobility * self.inputs.step);
        // Driven bodies keep their own account.
        let external = self
            .inputs
            .external
            .iter()
            .chain(repeat(&SpatialVector::ZERO));
        let changes = solution.iter().zip(&self.problem.free).zip(external);
        acceleration.clear();
        acceleration
            .extend(changes.map(|((v, free), external)| external.plus(&v.plus(free, -1.0), rate)));
        for (k, impulse) in self.impulses.iter().enumerate() {
            if *impulse != Vec3::zeros() && self.is_impact(k) {
                let row = self.problem.rows.get(k);
                self.problem.apply(&row, acceleration, impulse * -rate);
            }
        }
        acceleration.truncate(self.inputs.kinematics.len());
    }

    /// Writes the solution into `state`: motion, forces, work; boundaries end at `ends`. `spare` is memory.
    pub(super) fn commit(
        &self,
        state: &mut State,
        solution: &[SpatialVector],
        ends: &[Pose],
        spare: &mut Vec<SpatialVector>,
    ) {
        self.persisting_acceleration(solution, spare);
        let finished = self.finished(solution, ends);
        self.work(state, solution);
        self.body_work(state, solution, &finished, ends);
        self.store(state);
        state.springs = self.spring_forces();
        self.advance(state, solution, spare);
        std::mem::swap(&mut state.smooth, spare);
        for (carried, (after, _)) in state.bodies.iter_mut().zip(finished) {
            *carried = after;
        }
    }

    /// Moves the spheres. What of the change of their kinetic energy external forces and [`Self::work`] do not account for is
    /// the numerical_work.
    fn advance(&self, state: &mut State, solution: &[SpatialVector], smooth: &[SpatialVector]) {
        let (scene, step) = (self.inputs.scene, self.inputs.step);
        let (particles, integrator) = (&scene.particles, scene.settings.integrator);
        let kinetic =
            |i: usize, v: &SpatialVector| particles.kinetic_energy(i, &v.linear, &v.angular);
        let (start, end) = (self.inputs.kinematics, &mut state.kinematics);
        let places = (&mut end.position[..], &mut end.orientation[..]);
        let velocities = (&mut end.velocity[..], &mut end.spin[..]);
        let carried = &state.smooth[..];
        let advance = |first: usize, (places, velocities): (Places, Velocities)| {
            let places = places.0.iter_mut().zip(places.1);
            let velocities = velocities.0.iter_mut().zip(velocities.1);
            let mut numerical_work = 0.0;
            for (i, (place, motion)) in (first..).zip(places.zip(velocities)) {
                let ((position, orientation), (velocity, spin)) = (place, motion);
                let (v1, external) = (&solution[i], &self.inputs.external[i]);
                let before = start.spatial_velocity(i);
                let after = integrator.finish(&before, v1, scene.settings.dynamic_coefficient);
                let old = integrator.reported(&before, &carried[i], step);
                let new = integrator.reported(&after, &smooth[i], step);
                let power = particles.mass[i] * external.linear.dot(&v1.linear)
                    + particles.inertia(i) * external.angular.dot(&v1.angular);
                numerical_work += kinetic(i, &new) - kinetic(i, &old) - step * power;
                *position = start.position[i] + v1.linear * step;
                *orientation = turned(&start.orientation[i], &v1.angular, step);
                (*velocity, *spin) = (after.linear, after.angular);
            }
            numerical_work
        };
        let spheres = (places, velocities);
        let numerical_work = self.pool.pieces(spheres, advance, |a, b| a + b);
        state.work.numerical_work += numerical_work;
    }

    /// Adds the step's work. Lasting forces act along the displacement `dt v1`; an impact's work is `p . (u^- + u1)/2`. What
    /// contacts take across their normals is friction, along those of impacts the impact's loss. Along the normals of lasting
    /// contacts nothing is lost but by the scheme: that and all else of the change of kinetic energy is the numerical_work.
    fn work(&self, state: &mut State, solution: &[SpatialVector]) {
        let (scene, step) = (self.inputs.scene, self.inputs.step);
        let all = 0..self.impulses.len();
        let of = |_, rows| self.work_of(rows, solution);
        state.work = state.work + self.pool.pieces(all, of, |a, b| a + b);
        for load in &scene.loads {
            let arm = self.inputs.kinematics.orientation[load.sphere] * load.arm;
            state.work.loads += step * load.force.dot(&solution[load.sphere].at(arm));
        }
    }

    /// What the contacts and springs `range` of the rows do.
    fn work_of(&self, range: Range<usize>, solution: &[SpatialVector]) -> EnergyLedger {
        let mut work = EnergyLedger::default();
        // Work on the spheres that is accounted for.
        let mut known = 0.0;
        let rows = &self.problem.rows;
        for k in range {
            let p = &self.impulses[k];
            if *p == Vec3::zeros() || self.joint(k).is_some() {
                continue;
            }
            let general = rows.general(k);
            let law = general.map(|row| row.law);
            if law == Some(Law::Bilateral) {
                let spring = p.dot(&rows.relative(k, |i| solution[i]));
                work.springs += spring;
                known += spring;
                continue;
            }
            let impact = self.is_impact(k);
            let velocity = |i: usize| match impact {
                true => self.mean(solution, i),
                false => solution[i],
            };
            let (u, n) = (rows.relative(k, velocity), rows.normal(k));
            let couple = matches!(law, Some(Law::Resistance { .. }));
            // A couple of resistance is friction as a whole.
            let p_n = if couple { 0.0 } else { p.dot(&n) };
            let friction = -(p - n * p_n).dot(&u);
            work.friction += friction;
            known -= friction;
            if impact {
                let loss = -p_n * u.dot(&n);
                work.impact += loss;
                known -= loss;
            }
            // Of a prescribed motion, and of a belt also where its boundary is driven.
            if let Some(row) = general {
                let boundary = -p.dot(&row.prescribed_velocity);
                work.boundaries += boundary;
                known += boundary;
            }
            if let Some(driven) = self.driven_side(k) {
                let [_, grip] = rows.get(k).jacobian();
                known += p.dot(&grip.velocity(&velocity(driven)));
            }
        }
        work.numerical_work -= known;
        work
    }

    /// Adds the work on driven bodies, as [`Self::work`] does for spheres. Their weight acts along the way of the centre of mass.
    fn body_work(
        &self,
        state: &mut State,
        solution: &[SpatialVector],
        finished: &[(BodyState, f64)],
        ends: &[Pose],
    ) {
        if self.inputs.bodies.is_empty() {
            return;
        }
        let (scene, step) = (self.inputs.scene, self.inputs.step);
        let integrator = scene.settings.integrator;
        let spheres = self.inputs.kinematics.len();
        let work = &mut state.work;
        for (k, p) in self.impulses.iter().enumerate() {
            let (joint, driven) = (self.joint(k), self.driven_side(k));
            if joint.is_none() && driven.is_none() {
                continue;
            }
            let row = self.problem.rows.get(k);
            let impact = self.is_impact(k);
            let velocity = |i: usize| match impact {
                true => self.mean(solution, i),
                false => solution[i],
            };
            if let Some(joint) = joint {
                let done = p.dot(&row.relative(velocity));
                work.numerical_work -= done;
                match joint.limit.stops() {
                    true => work.impact -= done,
                    false => work.springs += done,
                }
            } else if let Some(driven) = driven {
                let [_, grip] = row.jacobian();
                work.numerical_work += p.dot(&grip.velocity(&velocity(driven)));
            }
        }
        let bodies = self.inputs.bodies.iter().zip(&state.bodies).zip(finished);
        for (d, ((body, before), (after, damped))) in bodies.enumerate() {
            let poses = [&self.inputs.poses[0][body.boundary], &ends[body.boundary]];
            let [old, new] = [(before, poses[0], state.last_step), (after, poses[1], step)].map(
                |(carried, pose, last)| {
                    let (momentum, lasting) = (&carried.momentum, &carried.smooth);
                    body.kinetic_energy(pose, &integrator.reported(momentum, lasting, last))
                },
            );
            let at_action = body.action_velocity(&self.mean(solution, spheres + d));
            let power =
                body.load.linear.dot(&at_action.linear) + body.load.angular.dot(&at_action.angular);
            work.loads += step * power;
            work.dampers += damped;
            let weight = body.weight_work(self.inputs.gravity, poses);
            work.numerical_work += new - old - step * power - damped - weight;
        }
    }

    /// The driven body that row `k` has as its body B.
    fn driven_side(&self, k: usize) -> Option<usize> {
        let [_, b] = self.problem.rows.bodies(k);
        (b != GROUND && b as usize >= self.inputs.kinematics.len()).then_some(b as usize)
    }

    /// Mean velocity of a body over the step: what an impact works with.
    fn mean(&self, solution: &[SpatialVector], i: usize) -> SpatialVector {
        match self.inputs.scene.settings.integrator {
            Integrator::Moreau => SpatialVector::ZERO
                .plus(&self.before_of(i), 0.5)
                .plus(&solution[i], 0.5),
            Integrator::Shi => solution[i],
        }
    }
}

impl Prediction<'_> {
    /// External forces, and the work of a gravity that changes, into the `state` after a step of `dt` \[s\].
    pub(super) fn book(&self, scene: &Scene, state: &mut State, dt: f64) {
        external::keep(scene, state, &self.external);
        let [from, to] = [0.0, dt].map(|after| state.gravity_at(scene, state.time + after));
        if from != to {
            let ends = self
                .kinematics
                .position
                .iter()
                .zip(&state.kinematics.position);
            let middle: Vec<Vec3> = ends.map(|(a, b)| (a + b) * 0.5).collect();
            state.lift(scene, &middle, to - from);
            let heavy = self.bodies.iter().filter_map(|body| {
                let poses = [&self.standing[body.boundary], &state.poses[body.boundary]];
                body.weight_moment(poses)
            });
            let moment: Vec3 = heavy.sum();
            state.work.gravity -= moment.dot(&(to - from));
        }
    }
}
