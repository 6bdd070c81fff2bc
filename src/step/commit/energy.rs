//! The energy ledger of a solved step.

use std::ops::Range;

use crate::Vec3;
use crate::contact::forces::ContactForces;
use crate::detection::configuration::Configuration;
use crate::integrator::Integrator;
use crate::problem::Law;
use crate::spatial::{Pose, SpatialVector};
use crate::state::{BodyState, EnergyLedger, State};
use crate::step::rows::elastic::ElasticContact;
use crate::step::solution::Solved;

impl Solved<'_> {
    /// Adds the step's work. Lasting forces act along the displacement `dt v1`; an impact's work is `p . (u^- + u1)/2`. What
    /// contacts take across their normals is friction, along those of impacts the impact's loss. Along the normals of lasting
    /// contacts nothing is lost but by the scheme: that and all else of the change of kinetic energy is the numerical_work.
    pub(super) fn work(&self, state: &mut State) {
        let (scene, step) = (self.prediction().scene, self.prediction().step);
        let all = 0..self.solution.impulses.len();
        let end = self.end();
        let of = |_, rows| self.work_of(rows, end.as_ref(), &state.contacts);
        state.work = state.work + self.assembly.pool.pieces(all, of, |a, b| a + b);
        for load in &scene.loads {
            let arm = self.prediction().kinematics.orientation[load.sphere] * load.arm;
            state.work.loads += step * load.force.dot(&self.solution.velocity[load.sphere].at(arm));
        }
    }

    /// Where the spheres and the boundaries end, if some contacts give way.
    fn end(&self) -> Option<(Vec<Vec3>, Vec<Pose>)> {
        let (prediction, velocity) = (self.prediction(), &self.solution.velocity);
        prediction.gives_way.then(|| {
            let mut position = Vec::new();
            prediction.end_positions(velocity, &mut position);
            (position, prediction.end_poses(velocity))
        })
    }

    /// What the contacts and springs `range` of the rows do; `end` as [`Self::end`], `contacts` are those before.
    fn work_of(
        &self,
        range: Range<usize>,
        end: Option<&(Vec<Vec3>, Vec<Pose>)>,
        contacts: &ContactForces,
    ) -> EnergyLedger {
        let mut work = EnergyLedger::default();
        // Work on the spheres that is accounted for.
        let mut known = 0.0;
        let rows = &self.assembly.problem.rows;
        for k in range {
            let p = &self.solution.impulses[k];
            // What the shear spring gives back.
            let mut returned = 0.0;
            if let (Some(elastic), Some(end)) = (self.assembly.elastic(k), end) {
                let [spring, lost] = self.work_of_spring(k, elastic, end);
                returned = self.assembly.past[k].stored(contacts) - self.spring_state(k).energy();
                work.contacts += spring + returned;
                work.impact += lost;
                known += spring - lost;
                if *p == Vec3::zeros() {
                    work.friction += returned;
                }
            }
            if *p == Vec3::zeros() || self.assembly.joint(k).is_some() {
                continue;
            }
            let general = rows.general(k);
            let law = general.map(|row| row.law);
            if law == Some(Law::Bilateral) {
                let spring = p.dot(&rows.relative(k, |i| self.solution.velocity[i]));
                work.springs += spring;
                known += spring;
                continue;
            }
            let impact = self.assembly.is_impact(k);
            let velocity = |i: usize| match impact {
                true => self.mean(i),
                false => self.solution.velocity[i],
            };
            let (mut u, n) = (rows.relative(k, velocity), rows.normal(k));
            // Friction works on the slip of the step's middle.
            if let Some(row) = general.filter(|row| row.is_contact() && row.is_rigid()) {
                u += row.across();
            }
            let couple = matches!(law, Some(Law::Resistance { .. }));
            // A couple of resistance is friction as a whole.
            let p_n = if couple { 0.0 } else { p.dot(&n) };
            let friction = -(p - n * p_n).dot(&u);
            work.friction += friction + returned;
            known -= friction;
            if impact && rows.compliance(k) == 0.0 {
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
            if let Some(driven) = self.assembly.driven_side(k) {
                let [_, grip] = rows.get(k).jacobian();
                known += p.dot(&grip.velocity(&velocity(driven)));
            }
        }
        work.numerical_work -= known;
        work
    }

    /// Work of the normal spring of a contact and what its damper loses \[J\]. A contact that a step does not press any more loses
    /// what its spring still holds.
    fn work_of_spring(
        &self,
        k: usize,
        elastic: &ElasticContact,
        (position, poses): &(Vec<Vec3>, Vec<Pose>),
    ) -> [f64; 2] {
        let (assembly, rows) = (self.assembly, &self.assembly.problem.rows);
        let candidate = &assembly.candidates[k];
        let end = Configuration {
            position,
            poses,
            ..assembly.start()
        };
        let spring = elastic.energy(candidate.gap) - elastic.energy(end.gap(candidate));
        let lost = match (self.solution.loads(k), rows.compliance(k) == 0.0) {
            (false, _) => spring,
            (true, true) => 0.0,
            (true, false) => {
                let speed = |velocity: &dyn Fn(usize) -> SpatialVector| {
                    rows.relative(k, velocity).dot(&rows.normal(k))
                };
                let before = speed(&|i| self.prediction().velocity(i));
                elastic.damped([before, speed(&|i| self.solution.velocity[i])])
            }
        };
        [spring, lost]
    }

    /// Adds the work on driven bodies, as [`Self::work`] does for spheres. Their weight acts along the path of the centre of mass.
    pub(super) fn body_work(
        &self,
        state: &mut State,
        finished: &[(BodyState, f64)],
        ends: &[Pose],
    ) {
        if self.prediction().bodies.is_empty() {
            return;
        }
        let (scene, step) = (self.prediction().scene, self.prediction().step);
        let integrator = scene.settings.integrator;
        let spheres = self.prediction().kinematics.len();
        let work = &mut state.work;
        for (k, p) in self.solution.impulses.iter().enumerate() {
            let (joint, driven) = (self.assembly.joint(k), self.assembly.driven_side(k));
            if joint.is_none() && driven.is_none() {
                continue;
            }
            let row = self.assembly.problem.rows.get(k);
            let impact = self.assembly.is_impact(k);
            let velocity = |i: usize| match impact {
                true => self.mean(i),
                false => self.solution.velocity[i],
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
        let bodies = self
            .prediction()
            .bodies
            .iter()
            .zip(&state.bodies)
            .zip(finished);
        for (d, ((body, before), (after, damped))) in bodies.enumerate() {
            let poses = [
                &self.prediction().poses[0][body.boundary],
                &ends[body.boundary],
            ];
            let [old, new] = [(before, poses[0], state.last_step), (after, poses[1], step)].map(
                |(carried, pose, last)| {
                    let (momentum, lasting) = (&carried.momentum, &carried.smooth);
                    body.kinetic_energy(pose, &integrator.reported(momentum, lasting, last))
                },
            );
            let at_action = body.action_velocity(&self.mean(spheres + d));
            let power =
                body.load.linear.dot(&at_action.linear) + body.load.angular.dot(&at_action.angular);
            work.loads += step * power;
            work.dampers += damped;
            let weight = body.weight_work(self.prediction().gravity, poses);
            work.numerical_work += new - old - step * power - damped - weight;
        }
    }

    /// Mean velocity of a body over the step: what an impact works with.
    fn mean(&self, i: usize) -> SpatialVector {
        match self.prediction().scene.settings.integrator {
            Integrator::Moreau => SpatialVector::ZERO
                .plus(&self.prediction().velocity(i), 0.5)
                .plus(&self.solution.velocity[i], 0.5),
            Integrator::Shi => self.solution.velocity[i],
        }
    }

    /// Adds the work of a gravity that changes to the `state` after the step, whose time is still that before.
    pub(super) fn gravity_work(&self, state: &mut State) {
        let (scene, dt) = (self.prediction().scene, self.prediction().step);
        let [from, to] = [0.0, dt].map(|after| state.gravity_at(scene, state.time + after));
        if from != to {
            let ends = self
                .prediction()
                .kinematics
                .position
                .iter()
                .zip(&state.kinematics.position);
            let middle: Vec<Vec3> = ends.map(|(a, b)| (a + b) * 0.5).collect();
            state.lift(scene, &middle, to - from);
            let heavy = self.prediction().bodies.iter().filter_map(|body| {
                let poses = [
                    &self.prediction().poses[0][body.boundary],
                    &state.poses[body.boundary],
                ];
                body.weight_moment(poses)
            });
            let moment: Vec3 = heavy.sum();
            state.work.gravity -= moment.dot(&(to - from));
        }
    }
}
