//! Contacts that hold: their attraction beside the impulses that press them, and what holds them after a step.
//!
//! A solver finds `p' = p + f_c dt n`, an ordinary contact, between bodies that the attraction moves: `free` of the problem has it.
//! What a step leaves is `p` again ([`Assembly::act`]).

use super::assemble::Assembly;
use super::prediction::Prediction;
use super::rows::elastic::ElasticContact;
use super::solution::{Solution, Solved};
use crate::Vec3;
use crate::contact::ContactId;
use crate::contact::cohesion::{BondLoad, Cohesion, Hold};
use crate::contact::forces::ContactForces;
use crate::contact::history::Carried;
use crate::contact::spring::ContactSpring;
use crate::detection::configuration::{Candidate, Configuration};
use crate::problem::Law;
use crate::problem::law::split;
use crate::spatial::SpatialVector;

/// Attraction of a rigid bond over what it has carried and a weight of its bodies.
const RESERVE: f64 = 4.0;
/// Share of the cone of its attraction from which on a load calls for more of it, so many times as much, and the least share of the strength.
const FILLED: f64 = 0.7;
const MORE: f64 = 4.0;
const LEAST: f64 = 1e-3;

impl Prediction<'_> {
    /// What holds a candidate together in this step, where `before` did until now: at the start all that touches is attached, and
    /// bonded in a run that has no contacts yet.
    #[inline]
    pub(super) fn hold(&self, candidate: &Candidate, before: Hold) -> Hold {
        if before != Hold::Loose || !self.starts {
            return before;
        }
        let pair = self.pair(candidate.key);
        if pair.cohesion.is_none() && pair.bond.is_none() {
            return Hold::Loose;
        }
        let touches = self.touches(candidate);
        if let Some(bond) = pair.bond.filter(|_| self.makes_bonds)
            && bond.joins(candidate.gap, self.closed(candidate.key))
        {
            let rigid = self.scene.elasticity(candidate.key).is_none();
            return Hold::Bonded {
                rest: match rigid && touches {
                    true => 0.0,
                    false => candidate.gap,
                },
            };
        }
        match pair.cohesion.filter(|_| touches) {
            Some(_) => Hold::Attached,
            None => Hold::Loose,
        }
    }

    /// `spring` of a contact of this reduced radius \[m\] with what holds it.
    pub(super) fn held_spring(
        &self,
        key: ContactId,
        hold: Hold,
        (spring, reduced_radius): (ContactSpring, f64),
    ) -> ContactSpring {
        let pair = self.pair(key);
        if pair.cohesion.is_none() && pair.bond.is_none() {
            return spring;
        }
        let Some(elasticity) = self.scene.elasticity(key) else {
            return spring;
        };
        let neck = |cohesion: Cohesion| cohesion.neck(&elasticity, reduced_radius);
        let curve = pair.cohesion.and_then(neck);
        let bond = pair.bond.zip(match hold {
            Hold::Bonded { rest } => Some(rest),
            Hold::Loose | Hold::Attached => None,
        });
        let bond = bond.map(|(bond, rest)| {
            let particles = &self.scene.particles;
            let beam = (particles.smaller_radius(key), self.centres(key) + rest);
            bond.spring(&elasticity, beam, rest)
        });
        spring.held((curve, hold == Hold::Attached), bond)
    }

    /// Distance \[m\] of the centres of a contact that touches, or of the centre from a boundary.
    fn centres(&self, key: ContactId) -> f64 {
        key.spheres().map(|i| self.scene.particles.radius[i]).sum()
    }

    /// Attraction \[N\] of a contact that has `carried` this in the last step. A rigid bond attracts with a part of its strength that holds
    /// what it carries: the tolerance of forces is a share of it. [`Assembly::filled`] says where that is not enough.
    pub(super) fn attraction(&self, key: ContactId, hold: Hold, carried: &Carried) -> f64 {
        let (pair, particles) = (self.pair(key), &self.scene.particles);
        match hold {
            Hold::Loose => 0.0,
            Hold::Attached => pair
                .cohesion
                .map_or(0.0, |c| c.pull_off(particles.reduced_radius(key))),
            Hold::Bonded { .. } => pair.bond.map_or(0.0, |bond| {
                let whole = bond.strength(particles.smaller_radius(key)).attraction();
                if self.starts || self.scene.elasticity(key).is_some() {
                    return whole;
                }
                let weight = |i: usize| self.weight(self.mover(i).0);
                let weight = key.spheres().map(weight).fold(0.0, f64::max);
                let couple = carried.torque.norm() / particles.reduced_radius(key);
                whole.min(RESERVE * (carried.force.norm() + couple + weight))
            }),
        }
    }

    /// Friction \[-\] of its row, and resistances \[-\] to rolling and twisting: a bond holds until it breaks.
    #[inline]
    pub(super) fn held_friction(&self, key: ContactId, hold: Hold) -> [f64; 3] {
        let pair = self.pair(key);
        let own = [pair.friction, pair.rolling_friction, pair.twisting_friction];
        match hold {
            Hold::Bonded { .. } => own.map(|coefficient| coefficient.max(pair.friction).max(1.0)),
            Hold::Loose | Hold::Attached => own,
        }
    }

    /// Whether a gap is closed but for what a step may leave open.
    fn touches(&self, candidate: &Candidate) -> bool {
        candidate.gap <= self.closed(candidate.key)
    }

    fn closed(&self, key: ContactId) -> f64 {
        let settings = &self.scene.settings;
        settings.closed() * self.scene.particles.smaller_radius(key)
    }
}

impl Assembly<'_> {
    /// Lets contacts that hold attract their bodies, and adds that to the impulses that press them.
    pub(super) fn attract(&mut self, contacts: &ContactForces, impulses: &mut [Vec3]) {
        self.attraction.clear();
        self.holds.clear();
        if !self.prediction.scene.pairs.coheres() {
            return;
        }
        for (k, candidate) in self.candidates.iter().enumerate() {
            let hold = self.prediction.hold(candidate, self.past[k].hold(contacts));
            let neck = self.elastic(k).and_then(|e| e.attraction(candidate.gap));
            let carried = self.past[k].carried(contacts);
            let force =
                neck.unwrap_or_else(|| self.prediction.attraction(candidate.key, hold, &carried));
            self.holds.push(hold);
            self.attraction.push(force);
        }
        self.pull(|_| true, -1.0);
        for (k, pressing) in impulses.iter_mut().enumerate() {
            if let Some(impulse) = self.attracting(k) {
                *pressing += impulse;
            }
        }
    }

    /// Impulse \[N s\] by which contact `k` is attracted, with a minus.
    fn attracting(&self, k: usize) -> Option<Vec3> {
        let force = self.attraction.get(k).filter(|force| **force > 0.0)?;
        Some(self.candidates[k].normal * (force * self.prediction.step))
    }

    /// The rigid bonds that what `impulses` press and turn fills the cones of, with the attraction \[N\] that they need.
    pub(super) fn filled(&self, impulses: &[Vec3]) -> Vec<(usize, f64)> {
        let mut filled = Vec::new();
        if !self.holds.iter().any(Hold::is_bond) {
            return filled;
        }
        let mut couples = vec![0.0_f64; self.candidates.len()];
        for (k, impulse) in impulses.iter().enumerate() {
            if let Some(Law::Resistance {
                contact,
                rolling,
                twisting,
            }) = self.problem.rows.general(k).map(|row| row.law)
            {
                let (along, across) = split(*impulse, self.problem.rows.normal(k));
                let needed = (across.norm() / rolling).max(along.abs() / twisting);
                couples[contact as usize] = needed;
            }
        }
        for k in (0..self.candidates.len()).filter(|&k| self.holds[k].is_bond()) {
            let key = self.candidates[k].key;
            let prediction = self.prediction;
            let Some(bond) = prediction
                .pair(key)
                .bond
                .filter(|_| self.elastic(k).is_none())
            else {
                continue;
            };
            let radius = prediction.scene.particles.smaller_radius(key);
            let (now, whole) = (self.attraction[k], bond.strength(radius).attraction());
            let (along, across) = split(impulses[k], self.candidates[k].normal);
            let attracting = now * prediction.step;
            let pulls = along < (1.0 - FILLED) * attracting;
            if now < whole && (pulls || across.norm().max(couples[k]) > FILLED * along) {
                filled.push((k, (MORE * now).clamp(LEAST * whole, whole)));
            }
        }
        filled
    }

    /// Lets contact `k` attract with `force` \[N\]: what acts stays.
    pub(super) fn attract_with(&mut self, (k, force): (usize, f64), impulses: &mut [Vec3]) {
        self.pull(|i| i == k, 1.0);
        let more = force - self.attraction[k];
        self.attraction[k] = force;
        self.pull(|i| i == k, -1.0);
        impulses[k] += self.candidates[k].normal * (more * self.prediction.step);
    }

    /// Lets contact `k`, which adheres, attract with what it has at a `gap` \[m\].
    pub(super) fn weaken(&mut self, k: usize, gap: f64) {
        let Some(force) = self.elastic(k).and_then(|e| e.attraction(gap)) else {
            return;
        };
        if force != self.attraction[k] {
            self.pull(|i| i == k, 1.0);
            self.attraction[k] = force;
            self.pull(|i| i == k, -1.0);
        }
    }

    /// Takes the attraction of the contacts that `of` names out of the motion of the bodies without contacts.
    pub(super) fn release(&mut self, of: impl Fn(usize) -> bool) {
        self.pull(of, 1.0);
    }

    /// Gives the bodies of the contacts that `of` names `share` of what attracts them, with a minus.
    fn pull(&mut self, of: impl Fn(usize) -> bool, share: f64) {
        let mut free = std::mem::take(&mut self.problem.free);
        for k in (0..self.attraction.len()).filter(|&k| of(k)) {
            if let Some(impulse) = self.attracting(k) {
                let row = self.problem.rows.get(k);
                self.problem.apply(&row, &mut free, impulse * share);
            }
        }
        self.problem.free = free;
    }

    /// From the impulses that press contacts to those that act on bodies.
    pub(super) fn act(&mut self, solution: &mut Solution) {
        self.release(|_| true);
        for k in 0..self.attraction.len() {
            if let Some(impulse) = self.attracting(k) {
                solution.impulses[k] -= impulse;
            }
        }
    }

    /// Decides what holds the contacts after the step that `solution` is, and leaves in it what acts.
    pub(super) fn hold_on(&mut self, solution: &mut Solution) {
        if self.holds.is_empty() {
            return;
        }
        let (mut position, prediction) = (Vec::new(), self.prediction);
        prediction.end_positions(&solution.velocity, &mut position);
        let poses = prediction.end_poses(&solution.velocity);
        let end = Configuration {
            position: &position,
            poses: &poses,
            ..self.start()
        };
        let after = self.holds_after(&solution.impulses, &end);
        self.take_holds(after);
        self.act(solution);
    }

    /// Takes what holds the contacts after the step.
    pub(super) fn take_holds(&mut self, after: Vec<Hold>) {
        let bonded = |holds: &[Hold]| holds.iter().filter(|hold| hold.is_bond()).count();
        self.broken_bonds = bonded(&self.holds).saturating_sub(bonded(&after)) as u64;
        self.holds = after;
    }

    /// What holds the contacts after a step, in which `impulses` press them and `end` is where it leads.
    pub(super) fn holds_after(&self, impulses: &[Vec3], end: &Configuration) -> Vec<Hold> {
        let prediction = self.prediction;
        let couples = self.couples(impulses);
        let after = |(k, (candidate, hold)): (usize, (&Candidate, &Hold))| {
            let pair = prediction.pair(candidate.key);
            let strength = pair.bond.filter(|_| hold.is_bond());
            if let Some(bond) = strength {
                let strength =
                    bond.strength(prediction.scene.particles.smaller_radius(candidate.key));
                let load = self.bond_load(k, impulses[k], couples[k]);
                if !strength.breaks(&load, pair.friction) {
                    return *hold;
                }
            }
            let Some(cohesion) = pair.cohesion else {
                return Hold::Loose;
            };
            let pressed = impulses[k] != Vec3::zeros();
            if let Some(fold) = self.elastic(k).and_then(ElasticContact::fold) {
                // Elastic surfaces adhere as soon as they touch, until their neck parts.
                let least = match *hold {
                    Hold::Attached => fold,
                    Hold::Loose | Hold::Bonded { .. } => 0.0,
                };
                return match -end.gap(candidate) > least {
                    true => Hold::Attached,
                    false => Hold::Loose,
                };
            }
            let range = || {
                cohesion
                    .rupture_distance
                    .max(prediction.closed(candidate.key))
            };
            let near = || end.gap(candidate) <= range();
            let lasts = pressed && !self.impact[k];
            match lasts || (pressed || *hold != Hold::Loose) && near() {
                true => Hold::Attached,
                false => Hold::Loose,
            }
        };
        let all = self.candidates.iter().zip(&self.holds).enumerate();
        all.map(after).collect()
    }

    /// What the bond of contact `k` carries.
    fn bond_load(&self, k: usize, impulse: Vec3, couple: Vec3) -> BondLoad {
        let normal = self.candidates[k].normal;
        let (along, across) = split(impulse / self.prediction.step, normal);
        let (twisting, bending) = split(couple, normal);
        BondLoad {
            normal: along - self.attraction[k],
            shear: across.norm(),
            bending: bending.norm(),
            twisting: twisting.abs(),
        }
    }

    /// Couple \[N m\] of each contact's resistance on A, `[contacts]`.
    pub(super) fn couples(&self, impulses: &[Vec3]) -> Vec<Vec3> {
        let mut couples = vec![Vec3::zeros(); self.candidates.len()];
        for (k, impulse) in impulses.iter().enumerate() {
            if let Some(row) = self.problem.rows.general(k)
                && let Law::Resistance { contact, .. } = row.law
            {
                couples[contact as usize] = impulse * (row.radius / self.prediction.step);
            }
        }
        couples
    }
}

impl Solved<'_> {
    /// Impulse \[N s\] that presses contact `k`: what acts on A, and against the attraction.
    pub(super) fn pressing(&self, k: usize) -> Vec3 {
        let acting = self.solution.impulses[k];
        self.assembly
            .attracting(k)
            .map_or(acting, |impulse| acting + impulse)
    }

    /// Work \[J\] of the attraction of contact `k` while the gap changes with the `velocity` of the bodies.
    pub(super) fn work_of_attraction(
        &self,
        k: usize,
        velocity: impl Fn(usize) -> SpatialVector,
    ) -> f64 {
        let rows = &self.assembly.problem.rows;
        let attracting = self.assembly.attracting(k);
        attracting.map_or(0.0, |impulse| -impulse.dot(&rows.relative(k, velocity)))
    }
}
