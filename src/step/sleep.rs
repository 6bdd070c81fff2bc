//! Spheres at rest: islands of them fall asleep, and a step then costs nothing for them.
//!
//! An island, spheres that hang together by loaded contacts or in one clump, falls asleep where for ten steps or more none of its spheres nor the
//! surfaces of its contacts has moved faster than `rest_speed`, no boundary that it touches has moved, and no sphere has
//! gathered more than a thousandth of the speed that gravity would have brought in this time: forces balance. The island must
//! touch a boundary, which takes the momentum that is left. Its contacts keep their
//! forces and are no rows of a step. It wakes as a whole when something awake touches it or would within the step, or when a
//! boundary that it touches moves.

use std::ops::Range;

use petgraph::unionfind::UnionFind;

use super::prediction::Prediction;
use super::solution::Solved;
use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::history::find;
use crate::contact::{ContactForce, ContactId, Partner};
use crate::detection::configuration::Candidate;
use crate::scene::Scene;
use crate::spatial::{SpatialVector, Wrench};
use crate::state::{ASLEEP, State};

/// Steps without motion after which an island may fall asleep.
const CALM: u32 = 10;
/// Largest share of gravity that may be without balance: the speed over what gravity would have brought since motion ended.
const BALANCE: f64 = 1e-3;
/// Surface speed of a spin that no contact feels, over that of all other motion.
const SPIN: f64 = 10.0;

impl Prediction<'_> {
    /// Whether sphere `i` is asleep.
    #[inline]
    pub(super) fn is_asleep(&self, i: usize) -> bool {
        self.asleep.get(i).copied().unwrap_or(false)
    }

    /// Whether sphere `i` is asleep and stays where it is: a contact that was found late may have moved it.
    pub(super) fn stays(&self, i: usize, velocity: &[SpatialVector]) -> bool {
        self.is_asleep(i) && velocity[self.mover(i).0 as usize] == SpatialVector::ZERO
    }

    /// Whether all of a contact is asleep: its force stays, and it is no row.
    pub(super) fn sleeps(&self, key: ContactId) -> bool {
        self.is_asleep(key.sphere as usize)
            && match key.partner {
                Partner::Sphere { index, .. } => self.is_asleep(index as usize),
                Partner::Boundary { boundary, .. } => !self.moves(usize::from(boundary)),
            }
    }

    /// Whether a boundary or its surface moves in the step, or may.
    fn moves(&self, boundary: usize) -> bool {
        let [start, end] = self.poses.each_ref().map(|poses| &poses[boundary]);
        start != end || self.surfaces[boundary] != Vec3::zeros() || self.body(boundary).is_some()
    }

    /// Wakes the islands of `state` that something awake, or a boundary that moves, touches or would touch within the step.
    /// Returns whether there was one.
    pub(super) fn wake(
        &mut self,
        candidates: &[Candidate],
        free: &[SpatialVector],
        state: &State,
    ) -> bool {
        if self.asleep.is_empty() {
            return false;
        }
        let stirs = |candidate: &&Candidate| {
            let key = candidate.key;
            let touched = match key.partner {
                Partner::Sphere { index, .. } => {
                    self.is_asleep(key.sphere as usize) != self.is_asleep(index as usize)
                }
                Partner::Boundary { .. } => {
                    self.is_asleep(key.sphere as usize) && !self.sleeps(key)
                }
            };
            touched && (self.closes(candidate, free) || is_loaded(state, key))
        };
        let stirred = candidates
            .iter()
            .filter(stirs)
            .flat_map(|c| c.key.spheres());
        let stirred: Vec<usize> = stirred
            .chain(self.roused())
            .filter(|&i| self.is_asleep(i))
            .collect();
        if stirred.is_empty() {
            return false;
        }
        let islands = islands(self.scene, state).into_labeling();
        let woken: Vec<usize> = stirred.iter().map(|&i| islands[i]).collect();
        for (asleep, island) in self.asleep.iter_mut().zip(&islands) {
            *asleep &= !woken.contains(island);
        }
        true
    }

    /// Members of clumps of which some are awake.
    fn roused(&self) -> impl Iterator<Item = usize> {
        let members = self.scene.clumps.iter().map(|clump| &clump.members);
        let awake = |members: &Range<usize>| members.clone().any(|i| !self.is_asleep(i));
        members
            .filter(move |&members| awake(members))
            .cloned()
            .flatten()
    }

    /// Whether the free motion of the step closes the gap.
    fn closes(&self, candidate: &Candidate, free: &[SpatialVector]) -> bool {
        let (n, a) = (candidate.normal, candidate.key.sphere as usize);
        let partner = match candidate.key.partner {
            Partner::Sphere { index, .. } => free[index as usize].linear,
            Partner::Boundary { boundary, .. } => {
                let (b, own) = (usize::from(boundary), &self.spheres[a]);
                let point = self.kinematics.position[a] - n * own.radius;
                match self.body(b) {
                    Some((rank, body)) => {
                        free[self.kinematics.len() + rank].at(point - body.reference)
                    }
                    None => self.motions[b].at(point),
                }
            }
        };
        candidate.gap + self.step * n.dot(&(free[a].linear - partner)) < 0.0
    }
}

impl Solved<'_> {
    /// Leaves in the `acceleration` of spheres that sleep no external one: their contacts, which are no rows, balance it.
    pub(super) fn still(&self, acceleration: &mut [SpatialVector]) {
        let prediction = self.prediction();
        for i in (0..prediction.asleep.len()).filter(|&i| prediction.asleep[i]) {
            acceleration[i] = match prediction.stays(i, &self.solution.velocity) {
                true => SpatialVector::ZERO,
                false => acceleration[i].plus(&prediction.external[i], -1.0),
            };
        }
    }

    /// Counts steps without motion and lets islands fall asleep, at the end of a step.
    pub(super) fn rest(&self, state: &mut State) {
        let prediction = self.prediction();
        let scene = prediction.scene;
        if !may_rest(scene) {
            return;
        }
        state.calm.resize(scene.particles.len(), 0);
        let mut calm = self.calm_spheres(state);
        for spring in &scene.springs {
            calm[spring.sphere] = false;
        }
        let slow = scene.settings.rest_speed;
        for load in state.contacts.iter() {
            if self.slip(state, load) > slow || !self.is_on_ground(load.key) {
                load.key.spheres().for_each(|i| calm[i] = false);
            }
        }
        for clump in &scene.clumps {
            // A clump is calm as a whole, and a member that another one has moved is awake.
            let members = clump.members.clone();
            let whole = members.clone().all(|i| calm[i]);
            calm[members].fill(whole);
        }
        let mut due = false;
        for (i, count) in state.calm.iter_mut().enumerate() {
            if *count == ASLEEP && prediction.stays(i, &self.solution.velocity) {
                continue;
            }
            // One that was woken counts anew.
            let before = if *count == ASLEEP { 0 } else { *count };
            *count = if calm[i] {
                (before + 1).min(ASLEEP - 1)
            } else {
                0
            };
            due |= *count >= CALM;
        }
        if due {
            self.fall_asleep(state);
        }
    }

    /// Whether each sphere is slow.
    fn calm_spheres(&self, state: &State) -> Vec<bool> {
        let scene = self.prediction().scene;
        let (slow, radius) = (scene.settings.rest_speed, &scene.particles.radius);
        let calm = |i: usize| {
            let v = self.reported(state, i);
            state.kinematics.present[i]
                && v.linear.norm() <= slow
                && v.angular.norm() * radius[i] <= SPIN * slow
        };
        (0..radius.len()).map(calm).collect()
    }

    /// Whether sphere `i` has been slow for long enough, and is slower than forces without balance would make it.
    fn balances(&self, state: &State, i: usize) -> bool {
        let prediction = self.prediction();
        let pull = match prediction.gravity_size {
            0.0 => prediction.mean_acceleration,
            gravity => gravity,
        };
        let time = f64::from(state.calm[i]) * prediction.step;
        let speed = self.reported(state, i).linear.norm();
        state.calm[i] >= CALM && speed <= BALANCE * pull * time
    }

    fn reported(&self, state: &State, i: usize) -> SpatialVector {
        let integrator = self.prediction().scene.settings.integrator;
        let velocity = state.kinematics.spatial_velocity(i);
        integrator.reported(&velocity, &state.smooth[i], self.prediction().step)
    }

    /// Speed of the surfaces of a contact against each other, on a boundary at rest \[m/s\].
    fn slip(&self, state: &State, load: &ContactForce) -> f64 {
        let radius = &self.prediction().scene.particles.radius;
        let one = |i: usize| {
            let v = self.reported(state, i);
            (v.linear, v.angular * radius[i])
        };
        let (own, spin) = one(load.key.sphere as usize);
        let (apart, turning) = match load.key.partner {
            Partner::Sphere { index, .. } => {
                let (other, turning) = one(index as usize);
                (own - other, spin + turning)
            }
            Partner::Boundary { .. } => (own, spin),
        };
        (apart - turning.cross(&load.normal)).norm()
    }

    /// Whether a contact is between spheres or with a boundary that does not move.
    fn is_on_ground(&self, key: ContactId) -> bool {
        match key.partner {
            Partner::Sphere { .. } => true,
            Partner::Boundary { boundary, .. } => !self.prediction().moves(usize::from(boundary)),
        }
    }

    /// Lets the islands fall asleep whose spheres are all calm.
    fn fall_asleep(&self, state: &mut State) {
        let islands = islands(self.prediction().scene, state).into_labeling();
        // Of each island whether all of it is calm, and its strongest contact with a boundary.
        let mut calm = vec![true; islands.len()];
        for (i, island) in islands.iter().enumerate() {
            calm[*island] &= state.calm[i] == ASLEEP || self.balances(state, i);
        }
        let mut ground: Vec<Option<(ContactForce, f64)>> = vec![None; islands.len()];
        for load in state.contacts.iter() {
            if let Partner::Boundary { .. } = load.key.partner {
                let size = load.force.norm();
                let known = &mut ground[islands[load.key.sphere as usize]];
                if known.is_none_or(|(_, most)| size > most) {
                    *known = Some((*load, size));
                }
            }
        }
        for (i, island) in islands.iter().enumerate() {
            if let Some((load, _)) = &ground[*island]
                && calm[*island]
                && state.calm[i] != ASLEEP
            {
                self.stop(state, i, load);
                state.calm[i] = ASLEEP;
            }
        }
    }

    /// Stops sphere `i`. The boundary of the contact `ground` takes its momentum, the ledger its kinetic energy. Those of a clump go with
    /// its first member.
    fn stop(&self, state: &mut State, i: usize, ground: &ContactForce) {
        let Partner::Boundary { boundary, .. } = ground.key.partner else {
            return;
        };
        let boundary = usize::from(boundary);
        let scene = self.prediction().scene;
        if let Some((centre, momentum, energy)) = self.carries(state, i) {
            let reference = scene.boundaries[boundary].point_of_action;
            let pivot = reference + state.poses[boundary].translation;
            let impulse = Wrench {
                force: momentum.linear,
                torque: (centre - pivot).cross(&momentum.linear) + momentum.angular,
            };
            state.owed[boundary].add(&impulse, 1.0);
            self.strike(state, ground, momentum.linear);
            state.work.numerical_work -= energy;
        }
        state.kinematics.velocity[i] = Vec3::zeros();
        state.kinematics.spin[i] = Vec3::zeros();
        state.smooth[i] = SpatialVector::ZERO;
    }

    /// Centre \[m\], momentum and kinetic energy \[J\] of the body that has sphere `i` as its first member.
    fn carries(&self, state: &State, i: usize) -> Option<(Vec3, SpatialVector, f64)> {
        let scene = self.prediction().scene;
        let (particles, v) = (&scene.particles, self.reported(state, i));
        let Some(c) = particles.clump(i) else {
            let momentum = SpatialVector {
                linear: v.linear * particles.mass[i],
                angular: v.angular * particles.inertia(i),
            };
            let energy = particles.kinetic_energy(i, &v.linear, &v.angular);
            return Some((state.kinematics.position[i], momentum, energy));
        };
        let clump = &scene.clumps[c];
        if clump.members.start != i {
            return None;
        }
        let (centre, rotation) = clump.place(&state.kinematics);
        let own = clump.of_member(rotation, &v);
        let momentum = clump.shape.momentum(rotation, &own);
        let energy = clump.shape.kinetic_energy(rotation, &own).iter().sum();
        Some((centre, momentum, energy))
    }
}

/// Whether spheres may fall asleep in a scene.
fn may_rest(scene: &Scene) -> bool {
    scene.settings.rest_speed > 0.0 && scene.settings.is_steady()
}

fn is_loaded(state: &State, key: ContactId) -> bool {
    let contact = find(&state.contacts, key);
    contact.force(&state.contacts) != Vec3::zeros() || contact.hold(&state.contacts) != Hold::Loose
}

/// Spheres that hang together by loaded contacts, or in one clump.
fn islands(scene: &Scene, state: &State) -> UnionFind<usize> {
    let mut islands = UnionFind::new(state.kinematics.len());
    for members in scene.clumps.iter().map(|clump| clump.members.clone()) {
        let first = members.start;
        members.for_each(|i| {
            islands.union(first, i);
        });
    }
    for load in state.contacts.iter() {
        if let Partner::Sphere { index, .. } = load.key.partner {
            islands.union(load.key.sphere as usize, index as usize);
        }
    }
    islands
}
