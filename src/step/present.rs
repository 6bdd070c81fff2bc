//! Spheres that wait outside the scene take no part in a step.
//!
//! Where many are absent, a step is taken by a scene and a state of those alone that are present, in the same order; what it leaves
//! goes back to the places of all. So the room that a source may fill costs next to nothing while it is empty, and how much there is
//! does not show in results.

use std::mem::swap;

use super::{StepFailure, StepOutput};
use crate::detection::broad_phase::NeighborList;
use crate::scene::Scene;
use crate::scene::clump::Clump;
use crate::spatial::SpatialVector;
use crate::state::State;

/// The present ones step alone where at least one of so many spheres is absent: to copy them takes less than the absent ones then.
const SHARE: usize = 8;

/// The spheres of a scene that are present.
#[derive(Debug, Default)]
pub(super) struct Present {
    /// Their numbers in the scene, ascending; empty where all take part.
    number: Vec<u32>,
    /// The rank of each sphere among them, `[N]`.
    rank: Vec<u32>,
    /// A scene and a state of them alone.
    alone: Option<Box<(Scene, State)>>,
}

impl Present {
    /// Those that are present, if they are to step without the others; other ones than before have `neighbors` of their own.
    pub(super) fn apart(
        &mut self,
        scene: &Scene,
        state: &State,
        neighbors: &mut NeighborList,
    ) -> Option<Apart<'_>> {
        if scene.sources.is_empty() && scene.sinks.is_empty() {
            return None;
        }
        let present = &state.kinematics.present;
        let count = present.iter().filter(|present| **present).count();
        let loads = scene.loads.iter().map(|load| load.sphere);
        let mut held = loads.chain(scene.springs.iter().map(|spring| spring.sphere));
        let apart = count > 0
            && (present.len() - count) * SHARE >= present.len()
            && held.all(|i| present[i]);
        let there = (0..).zip(present).filter(|(_, present)| apart && **present);
        let numbers = there.map(|(i, _)| i);
        if !numbers.clone().eq(self.number.iter().copied()) {
            neighbors.forget();
            self.number.clear();
            self.number.extend(numbers);
            if apart {
                self.leave_others_out(scene, state);
            }
        }
        let alone = self.alone.as_deref_mut().filter(|_| apart)?;
        Some(Apart {
            number: &self.number,
            rank: &self.rank,
            alone,
        })
    }

    /// Makes the scene of those that are present.
    fn leave_others_out(&mut self, scene: &Scene, state: &State) {
        self.rank.clear();
        self.rank.resize(scene.particles.len(), u32::MAX);
        for (rank, &i) in (0..).zip(&self.number) {
            self.rank[i as usize] = rank;
        }
        let (alone, _) = &mut **self
            .alone
            .get_or_insert_with(|| Box::new((Scene::clone(scene), state.clone())));
        let (from, to) = (&scene.particles, &mut alone.particles);
        let number = &self.number;
        gather(number, &from.radius, &mut to.radius);
        gather(number, &from.mass, &mut to.mass);
        gather(number, &from.material, &mut to.material);
        gather(number, &from.locks, &mut to.locks);
        let rank = |i: usize| self.rank[i] as usize;
        alone.loads.clone_from(&scene.loads);
        alone
            .loads
            .iter_mut()
            .for_each(|load| load.sphere = rank(load.sphere));
        alone.springs.clone_from(&scene.springs);
        alone
            .springs
            .iter_mut()
            .for_each(|spring| spring.sphere = rank(spring.sphere));
        let present = &state.kinematics.present;
        let there = scene
            .clumps
            .iter()
            .filter(|clump| present[clump.members.start]);
        alone.clumps.clear();
        alone.clumps.extend(there.map(|clump| {
            let first = rank(clump.members.start);
            Clump {
                members: first..first + clump.members.len(),
                shape: clump.shape.clone(),
            }
        }));
        to.clump.clear();
        if !from.clump.is_empty() {
            to.clump.resize(number.len(), None);
            for (c, clump) in (0..).zip(&alone.clumps) {
                to.clump[clump.members.clone()].fill(Some(c));
            }
        }
    }
}

/// Those that step without the others.
pub(super) struct Apart<'a> {
    number: &'a [u32],
    rank: &'a [u32],
    alone: &'a mut (Scene, State),
}

impl Apart<'_> {
    /// Lets `step` take them from `state`, which gets what it leaves unless it fails.
    pub(super) fn step(
        self,
        state: &mut State,
        step: impl FnOnce(&Scene, &mut State) -> Result<StepOutput, StepFailure>,
    ) -> Result<StepOutput, StepFailure> {
        let Self {
            number,
            rank,
            alone: (scene, alone),
        } = self;
        swap_all_but_spheres(state, alone);
        alone.contacts.renumber(rank);
        alone.gather(state, number);
        let mut result = step(scene, alone);
        alone.contacts.renumber(number);
        swap_all_but_spheres(state, alone);
        let squeezed = match &mut result {
            Ok(output) => {
                alone.scatter(state, number);
                &mut output.squeezed
            }
            Err(failure) => {
                let passed = failure.passed.iter_mut().map(|passed| &mut passed.contact);
                let contacts = failure.contact.iter_mut().chain(passed);
                contacts.for_each(|contact| contact.renumber(number));
                &mut failure.pinched
            }
        };
        if let Some(squeezed) = squeezed {
            squeezed.sphere = number[squeezed.sphere] as usize;
        }
        result
    }
}

/// Swaps what is not an entry a sphere.
fn swap_all_but_spheres(a: &mut State, b: &mut State) {
    swap(a, b);
    swap(&mut a.kinematics, &mut b.kinematics);
    swap(&mut a.smooth, &mut b.smooth);
    swap(&mut a.external, &mut b.external);
    swap(&mut a.applied_forces, &mut b.applied_forces);
    swap(&mut a.calm, &mut b.calm);
    swap(&mut a.ground, &mut b.ground);
}

impl State {
    /// Takes the spheres of these numbers from `all`.
    fn gather(&mut self, all: &Self, number: &[u32]) {
        let (from, to) = (&all.kinematics, &mut self.kinematics);
        gather(number, &from.position, &mut to.position);
        gather(number, &from.orientation, &mut to.orientation);
        gather(number, &from.velocity, &mut to.velocity);
        gather(number, &from.spin, &mut to.spin);
        gather(number, &from.present, &mut to.present);
        gather(number, &all.smooth, &mut self.smooth);
        gather(number, &all.external, &mut self.external);
        gather(number, &all.applied_forces, &mut self.applied_forces);
        gather(number, &all.calm, &mut self.calm);
        gather(number, &all.ground, &mut self.ground);
    }

    /// Gives what a step has changed to the spheres of these numbers in `all`.
    fn scatter(&self, all: &mut Self, number: &[u32]) {
        let (from, to) = (&self.kinematics, &mut all.kinematics);
        let count = to.position.len();
        scatter(number, &from.position, &mut to.position);
        scatter(number, &from.orientation, &mut to.orientation);
        scatter(number, &from.velocity, &mut to.velocity);
        scatter(number, &from.spin, &mut to.spin);
        scatter(number, &self.smooth, &mut all.smooth);
        fit(
            &self.external,
            &mut all.external,
            (count, SpatialVector::ZERO),
        );
        scatter(number, &self.external, &mut all.external);
        fit(&self.calm, &mut all.calm, (count, 0));
        scatter(number, &self.calm, &mut all.calm);
        fit(&self.ground, &mut all.ground, (count, 0));
        scatter(number, &self.ground, &mut all.ground);
    }
}

/// Into `to` the entries `number` of `from`, if it has any.
fn gather<T: Copy>(number: &[u32], from: &[T], to: &mut Vec<T>) {
    to.clear();
    if !from.is_empty() {
        to.extend(number.iter().map(|&i| from[i as usize]));
    }
}

/// The entries of `from` into those of `to` of this `number`.
fn scatter<T: Copy>(number: &[u32], from: &[T], to: &mut [T]) {
    for (&i, own) in number.iter().zip(from) {
        to[i as usize] = *own;
    }
}

/// Makes `all` as long as there are spheres where the step has entries for some, and empty where it has none.
fn fit<T: Copy>(some: &[T], all: &mut Vec<T>, (count, empty): (usize, T)) {
    match some.is_empty() {
        true => all.clear(),
        false => all.resize(count, empty),
    }
}
