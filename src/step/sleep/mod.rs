//! Spheres at rest fall asleep, and a step then costs nothing for them.
//!
//! | file | what |
//! |---|---|
//! | here | what sleeps in a step, and what wakes before it is solved |
//! | `sleepers` | the balance of forces on what sleeps: what wakes by the solution |
//! | `rest` | what falls asleep at the end of a step |
//!
//! What sleeps stands still: its contacts keep their forces and are no rows of a step, and to what is awake it is fixed. It wakes
//! when something that moves hits it, when a boundary that it touches moves, or when the forces on it change: a step in which
//! they are out of balance by more than the tolerance of forces is solved again with more of what sleeps awake.

mod rest;
mod sleepers;

use std::ops::Range;

use super::prediction::Prediction;
use crate::Vec3;
use crate::contact::cohesion::Hold;
use crate::contact::history::find;
use crate::contact::{ContactId, Partner};
use crate::detection::configuration::Candidate;
use crate::spatial::SpatialVector;
use crate::state::State;
pub(super) use sleepers::{Attempt, Sleepers, undisturbed};

impl Prediction<'_> {
    /// Whether sphere `i` is asleep.
    #[inline]
    pub(super) fn is_asleep(&self, i: usize) -> bool {
        self.asleep.get(i).copied().unwrap_or(false)
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

    /// Wakes the spheres of `state` that something awake hits within the step, or that a boundary which moves touches or would touch.
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
            match key.partner {
                Partner::Sphere { index, .. } => {
                    self.is_asleep(key.sphere as usize) != self.is_asleep(index as usize)
                        && self.hits(candidate)
                        && !is_loaded(state, key)
                }
                Partner::Boundary { .. } => {
                    self.is_asleep(key.sphere as usize)
                        && !self.sleeps(key)
                        && (self.closes(candidate, free) || is_loaded(state, key))
                }
            }
        };
        let stirred = candidates.iter().filter(stirs);
        let stirred = stirred.flat_map(|c| c.key.spheres()).chain(self.roused());
        let stirred: Vec<usize> = stirred.filter(|&i| self.is_asleep(i)).collect();
        stirred.iter().for_each(|&i| self.asleep[i] = false);
        !stirred.is_empty()
    }

    /// Wakes the `spheres` and what is [`Self::around`] them.
    pub(super) fn wake_around(&mut self, spheres: &[usize], rings: usize, state: &State) {
        let reached = self.around(spheres, rings, state);
        for (asleep, reached) in self.asleep.iter_mut().zip(reached) {
            *asleep &= !reached;
        }
    }

    /// Whether each sphere is one of the `spheres`, or loaded contacts of `state` lead to it from them by `rings` of contacts, `[N]`.
    fn around(&self, spheres: &[usize], rings: usize, state: &State) -> Vec<bool> {
        let mut reached = vec![false; self.kinematics.len()];
        spheres.iter().for_each(|&i| reached[i] = true);
        for _ in 0..rings {
            let before = reached.clone();
            for load in state.contacts.iter() {
                if load.key.spheres().any(|i| before[i]) {
                    load.key.spheres().for_each(|i| reached[i] = true);
                }
            }
        }
        reached
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

    /// Whether two spheres of which one sleeps meet within the step, the other faster than what may fall asleep.
    fn hits(&self, candidate: &Candidate) -> bool {
        let speed = |i: usize| self.kinematics.velocity[i].dot(&candidate.normal);
        let Partner::Sphere { index, .. } = candidate.key.partner else {
            return false;
        };
        let approach = speed(index as usize) - speed(candidate.key.sphere as usize);
        approach > self.scene.settings.rest_speed && candidate.gap < self.step * approach
    }

    /// Whether the motion of a boundary in the step closes the gap of a sphere that sleeps.
    fn closes(&self, candidate: &Candidate, free: &[SpatialVector]) -> bool {
        let Partner::Boundary { boundary, .. } = candidate.key.partner else {
            return false;
        };
        let (a, b) = (candidate.key.sphere as usize, usize::from(boundary));
        let point = self.kinematics.position[a] - candidate.normal * self.spheres[a].radius;
        let velocity = match self.body(b) {
            Some((rank, body)) => free[self.kinematics.len() + rank].at(point - body.reference),
            None => self.motions[b].at(point),
        };
        candidate.gap < self.step * candidate.normal.dot(&velocity)
    }
}

fn is_loaded(state: &State, key: ContactId) -> bool {
    let contact = find(&state.contacts, key);
    contact.force(&state.contacts) != Vec3::zeros() || contact.hold(&state.contacts) != Hold::Loose
}
