//! The problem at t = 0: of displacements that remove overlaps, and of forces at rest.

use super::assemble::Assembly;
use super::external;
use super::rows::elastic::ElasticContact;
use super::rows::joint::JointConstraint;
use super::solution::Solved;
use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::detection::configuration::Configuration;
use crate::problem::{Law, Row, retain};
use crate::state::State;

impl Assembly<'_> {
    /// Leaves contacts without friction, for a displacement. Those that give way may overlap, but not more than they do.
    pub(super) fn displace(&mut self, impulses: &mut Vec<Vec3>) {
        self.release(|_| true);
        self.attraction.clear();
        self.holds.clear();
        self.problem.rows.truncate(self.candidates.len());
        impulses.truncate(self.candidates.len());
        let frictionless = |_, row: &mut Row| row.law = Law::Contact { mu: 0.0 };
        self.problem.rows.update_all(frictionless);
        for (k, _) in self.elastic.iter().enumerate().filter(|(_, e)| e.is_some()) {
            let gap = self.candidates[k].gap.max(0.0) / self.prediction.step;
            self.problem.rows.update(k, |row| {
                row.bias = row.normal * gap;
                (row.compliance_n, row.compliance_t) = (0.0, 0.0);
            });
        }
        self.moves = false;
    }

    /// Whether each row is kept: of the candidates those that are closed and neither approach nor part.
    pub(super) fn resting(&self) -> Vec<bool> {
        let velocity = self.prediction.velocities();
        let settings = &self.prediction.scene.settings;
        let external = self.prediction.external.iter().map(|a| a.linear.norm());
        let acceleration = external.fold(self.prediction.mean_acceleration, f64::max);
        let creep = acceleration.max(self.prediction.gravity_size) * self.prediction.step;
        let closed = settings.closed();
        let rests = |k: usize| {
            let row = self.problem.rows.get(k);
            let at_rest = row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep;
            let pressed = self.elastic(k).is_some_and(ElasticContact::is_resolved)
                && self.candidates[k].gap < 0.0;
            let bonded = self.holds.get(k).is_some_and(Hold::is_bond);
            pressed || bonded || at_rest && self.candidates[k].gap <= closed * row.radius
        };
        let stop_rests = |joint: &JointConstraint, row: &Row| {
            joint.limit.distance <= closed * row.radius
                && row.normal.dot(&row.relative_velocity(&velocity)).abs() <= 1e-3 * creep
        };
        (0..self.problem.rows.len())
            .map(|k| match (self.contact_of(k), self.joint(k)) {
                (Some(contact), _) => rests(contact),
                (None, Some(joint)) if joint.limit.stops() => {
                    stop_rests(joint, &self.problem.rows.get(k))
                }
                _ => true,
            })
            .collect()
    }

    /// Keeps these rows. Their contacts may not accelerate into each other: with zero gap, less what sliding over a curved
    /// surface opens or closes by itself, `g(t) = g + dt n.u + ...`.
    pub(super) fn keep(&mut self, keep: &[bool], impulses: &mut Vec<Vec3>) {
        self.release(|k| !keep[k]);
        let velocity = self.prediction.velocities();
        let first = self.first_joint();
        for (k, joint) in (first..).zip(&mut self.joints) {
            if joint.limit.stops() {
                self.problem.rows.update(k, |row| row.bias = Vec3::zeros());
                joint.impact = false;
            }
        }
        retain(&mut self.joints, &keep[first..]);
        // Of every row how many before it are kept.
        let ranks: Vec<u32> = keep
            .iter()
            .scan(0, |kept, &keep| {
                Some(std::mem::replace(kept, *kept + u32::from(keep)))
            })
            .collect();
        let rows = &mut self.problem.rows;
        rows.bind(|contact| *contact = ranks[*contact as usize]);
        let step = self.prediction.step;
        let mut position = Vec::new();
        let mut ways = velocity.clone();
        self.prediction.carry_members(&mut ways);
        self.prediction.end_positions(&ways, &mut position);
        let (scene, kinematics) = (self.prediction.scene, &self.prediction.kinematics);
        let slid = Configuration {
            position: &position,
            ..Configuration::of(scene, kinematics, &self.prediction.poses[0])
        };
        for (k, candidate) in self.candidates.iter().enumerate() {
            if self.elastic(k).is_none() {
                self.problem.rows.update(k, |row| {
                    let linear = step * row.normal.dot(&row.relative_velocity(&velocity));
                    let curved = slid.follow(candidate).gap - candidate.gap - linear;
                    row.bias = row.normal * (2.0 * curved / step);
                });
            }
        }
        self.impact.fill(false);
        retain(impulses, keep);
        self.problem.rows.retain(keep);
        retain(&mut self.candidates, keep);
        retain(&mut self.elastic, keep);
        retain(&mut self.past, keep);
        retain(&mut self.attraction, keep);
        retain(&mut self.holds, keep);
        self.impact.truncate(self.candidates.len());
    }
}

impl Solved<'_> {
    /// Forces at t = 0 into `state`.
    pub(super) fn commit_forces(&self, state: &mut State) {
        let prediction = self.prediction();
        self.store(state, &self.remains());
        state.springs = self.spring_forces();
        self.smooth_acceleration(&mut state.smooth, false);
        let (external, clumps) = (&prediction.external, &prediction.clumps);
        external::keep(prediction.scene, state, external, clumps);
        let at_rest = self.finished(&prediction.poses[0]);
        for (carried, (found, _)) in state.bodies.iter_mut().zip(at_rest) {
            carried.smooth = found.smooth;
            carried.joint_forces = found.joint_forces;
        }
    }
}
