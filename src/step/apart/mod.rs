//! Spheres that take no part in a step.
//!
//! Two kinds are left out: those that wait outside the scene, and those that sleep far from all that moves. Where they are many, a step
//! is taken by a scene and a state of the others alone, in the same order; what it leaves goes back to the places of all. So the room
//! that a source may fill costs next to nothing while it is empty, and a heap costs what moves in it.
//!
//! | file | what |
//! |---|---|
//! | here | who takes part, and their scene and state |
//! | `zone` | how far bodies that sleep are from what moves |
//! | `outside` | what those do that sleep outside, and how far the step may reach |

mod outside;
mod tests;
mod zone;

use std::mem::swap;

use super::input::StepInput;
use super::output::{StepFailure, Taken};
use crate::Vec3;
use crate::contact::forces::ContactForces;
use crate::detection::broad_phase::NeighborList;
use crate::scene::clump::Clump;
use crate::scene::{Boundary, Motion, Scene};
use crate::spatial::Pose;
use crate::spatial::extent::{around, joined};
use crate::state::{ASLEEP, State};
pub(super) use outside::Outside;
use zone::{BEYOND, moved};

/// Others step alone where at least one of so many spheres is left out: to copy them takes less than those that are left out then.
const SHARE: usize = 8;
/// Rings about what moves that take part, at first and at most.
const DEPTH: u8 = 3;
const DEEPEST: u8 = 32;
/// Edge of the cells of rings over the largest size of a body: contacts may be open a little.
const MARGIN: f64 = 1.01;

/// The spheres of a scene that take part in a step.
#[derive(Debug, Default)]
pub(super) struct Participants {
    /// Their numbers in the scene, ascending; empty where all take part.
    number: Vec<u32>,
    /// The rank of each sphere among them, `[N]`.
    rank: Vec<u32>,
    /// Ring of each sphere, [`BEYOND`] where it takes no part, `[N]`.
    ring: Vec<u8>,
    /// A scene and a state of them alone.
    alone: Option<Box<(Scene, State)>>,
    /// What is left out though it is there.
    pub(super) outside: Outside,
    /// Memory for all contacts.
    contacts: ContactForces,
}

/// How many rings about what moves are to take part.
#[derive(Clone, Copy)]
pub(super) struct Depth(Option<u8>);

impl Depth {
    /// Those that take part at first.
    pub(super) const FIRST: Self = Self(Some(DEPTH));

    /// More of them, in the end all that there is.
    pub(super) fn more(self) -> Self {
        Self(
            self.0
                .map(|depth| 2 * depth)
                .filter(|&depth| depth <= DEEPEST),
        )
    }
}

impl Participants {
    /// Those that take part in a step of `state` by `input`, if others are left out; other ones than before have `neighbors` of their own.
    pub(super) fn apart(
        &mut self,
        scene: &Scene,
        (state, input): (&State, &StepInput),
        neighbors: &mut NeighborList,
        depth: Depth,
    ) -> Option<Apart<'_>> {
        let rests = match depth.0 {
            Some(depth) => self.make_rings(scene, (state, input), depth),
            None => false,
        };
        let all = scene.sources.is_empty() && scene.sinks.is_empty();
        if all && !rests && self.number.is_empty() {
            return None;
        }
        let present = &state.kinematics.present;
        if !rests {
            let ring = present
                .iter()
                .map(|present| if *present { 0 } else { BEYOND });
            self.ring.clear();
            self.ring.extend(ring);
        }
        let count = self.ring.iter().filter(|&&ring| ring != BEYOND).count();
        let mut held = held(scene);
        let apart = count > 0
            && (present.len() - count) * SHARE >= present.len()
            && held.all(|i| present[i]);
        let numbers = (0..).zip(&self.ring);
        let numbers = numbers.filter(|(_, ring)| apart && **ring != BEYOND);
        let numbers = numbers.map(|(i, _)| i);
        if !numbers.clone().eq(self.number.iter().copied()) {
            neighbors.forget();
            self.number.clear();
            self.number.extend(numbers);
            if apart {
                self.leave_others_out(scene, state);
            }
        }
        self.outside.clear();
        if apart && rests {
            gather(&self.number, &self.ring, &mut self.outside.ring);
            self.outside.add_up(scene, state, &self.ring);
        }
        let alone = self.alone.as_deref_mut().filter(|_| apart)?;
        Some(Apart {
            number: &self.number,
            rank: &self.rank,
            alone,
            contacts: &mut self.contacts,
            outside: std::mem::take(&mut self.outside),
        })
    }

    /// Finds the ring of every sphere, up to `depth`. Returns whether there are any: in other scenes no sphere sleeps by itself, or few do.
    fn make_rings(
        &mut self,
        scene: &Scene,
        (state, input): (&State, &StepInput),
        depth: u8,
    ) -> bool {
        let steady = scene.settings.is_steady() && state.gravity != Vec3::zeros();
        if !steady || !scene.cell.is_open() || !state.walls.list.is_empty() {
            return false;
        }
        let (kinematics, particles) = (&state.kinematics, &scene.particles);
        // One that has just fallen asleep wants to know its forces.
        let sleeps = |i: usize| state.calm.get(i).is_some_and(|&calm| calm == ASLEEP);
        let present = || (0..particles.len()).filter(|&i| kinematics.present[i]);
        if 2 * present().filter(|&i| sleeps(i)).count() < present().count() {
            return false;
        }
        let centre = |i: usize| match particles.clump(i) {
            Some(c) => scene.clumps[c].place(kinematics).0,
            None => kinematics.position[i],
        };
        let largest = particles.largest_radius();
        let reaches = scene.clumps.iter().map(|clump| clump.shape.reach());
        let size = 2.0 * reaches.fold(largest, f64::max) + scene.holding_distance(largest);
        let zone = &mut self.outside.zone;
        let places = present().map(|i| kinematics.position[i]);
        zone.restart(MARGIN * size, around(places), particles.len());
        for (b, boundary) in scene.boundaries.iter().enumerate() {
            let (from, command) = (&state.poses[b], &input.commands[b]);
            let driven = matches!(boundary.motion, Motion::Driven(_));
            let to = match driven {
                true => from.advanced(&state.twists[b], input.dt),
                false => input.poses[b],
            };
            if driven || *from != to || boundary.surface_velocity(from, command) != Vec3::zeros() {
                let Some(bounds) = swept(boundary, from, &to) else {
                    return false;
                };
                zone.mark(bounds);
            }
        }
        for i in present().filter(|&i| !sleeps(i)) {
            let from = centre(i);
            let to = from + kinematics.velocity[i] * input.dt;
            zone.mark((from.inf(&to), from.sup(&to)));
        }
        let pushed = (0..).zip(&state.applied_forces);
        let pushed = pushed.filter(|(_, force)| **force != Vec3::zeros());
        for i in held(scene).chain(pushed.map(|(i, _)| i)) {
            zone.mark((centre(i), centre(i)));
        }
        zone.spread(depth);
        self.ring.clear();
        self.ring
            .extend((0..particles.len()).map(|i| match kinematics.present[i] {
                true => zone.ring_at(centre(i)),
                false => BEYOND,
            }));
        true
    }

    /// Makes the scene of those that take part.
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
        let takes_part = |clump: &&Clump| self.ring[clump.members.start] != BEYOND;
        let there = scene.clumps.iter().filter(takes_part);
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

/// Spheres with loads and springs.
fn held(scene: &Scene) -> impl Iterator<Item = usize> {
    let loads = scene.loads.iter().map(|load| load.sphere);
    loads.chain(scene.springs.iter().map(|spring| spring.sphere))
}

/// Box around a boundary on its way between two poses \[m\]; `None` if it has none.
pub(super) fn swept(boundary: &Boundary, from: &Pose, to: &Pose) -> Option<(Vec3, Vec3)> {
    let (own, pivot) = (boundary.geometry.bounds()?, boundary.point_of_action);
    let at = |pose: &Pose| moved(own, |x| boundary.from_frame(pose, x));
    let (low, high) = joined(at(from), at(to));
    // Between them points are beside their chords, by less than this.
    let half = 0.5 * (to.rotation * from.rotation.inverse()).angle();
    let reach = (own.0 - pivot)
        .sup(&(pivot - own.0))
        .sup(&(own.1 - pivot).abs())
        .norm();
    let beside = Vec3::repeat(reach * (1.0 - half.cos()));
    Some((low - beside, high + beside))
}

/// Those that step without the others.
pub(super) struct Apart<'a> {
    number: &'a [u32],
    rank: &'a [u32],
    alone: &'a mut (Scene, State),
    contacts: &'a mut ContactForces,
    outside: Outside,
}

impl Apart<'_> {
    /// Lets `step` take them from `state`, which gets what it leaves unless it fails or others would take part.
    pub(super) fn step(
        self,
        state: &mut State,
        step: impl FnOnce(&Scene, &mut State, Outside) -> Result<Taken, StepFailure>,
    ) -> Result<Taken, StepFailure> {
        let Self {
            number,
            rank,
            alone: (scene, alone),
            contacts,
            outside,
        } = self;
        swap_all_but_spheres(state, alone);
        alone.gather(state, (number, rank));
        let mut result = step(scene, alone, outside);
        swap_all_but_spheres(state, alone);
        let squeezed = match &mut result {
            Ok(Taken::Outgrown(_)) => return result,
            Ok(Taken::Done(output)) => {
                alone.scatter(state, (number, rank), contacts);
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

/// Swaps what is not an entry a sphere or contact.
fn swap_all_but_spheres(a: &mut State, b: &mut State) {
    swap(a, b);
    swap(&mut a.kinematics, &mut b.kinematics);
    swap(&mut a.contacts, &mut b.contacts);
    swap(&mut a.smooth, &mut b.smooth);
    swap(&mut a.external, &mut b.external);
    swap(&mut a.applied_forces, &mut b.applied_forces);
    swap(&mut a.calm, &mut b.calm);
    swap(&mut a.ground, &mut b.ground);
}

impl State {
    /// Takes the spheres of these numbers from `all`, and their contacts with each other; `rank` are their places here.
    fn gather(&mut self, all: &Self, (number, rank): (&[u32], &[u32])) {
        all.contacts.gather(rank, &mut self.contacts);
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

    /// Gives what a step has changed to the spheres of these numbers in `all`. `spare` is memory.
    fn scatter(&self, all: &mut Self, numbers: (&[u32], &[u32]), spare: &mut ContactForces) {
        all.contacts.scatter(numbers, &self.contacts, spare);
        let (number, _) = numbers;
        let (from, to) = (&self.kinematics, &mut all.kinematics);
        let places = (number, to.len());
        scatter(places, &from.position, &mut to.position);
        scatter(places, &from.orientation, &mut to.orientation);
        scatter(places, &from.velocity, &mut to.velocity);
        scatter(places, &from.spin, &mut to.spin);
        scatter(places, &self.smooth, &mut all.smooth);
        scatter(places, &self.external, &mut all.external);
        scatter(places, &self.calm, &mut all.calm);
        scatter(places, &self.ground, &mut all.ground);
    }
}

/// Into `to` the entries `number` of `from`, if it has any.
fn gather<T: Copy>(number: &[u32], from: &[T], to: &mut Vec<T>) {
    to.clear();
    if !from.is_empty() {
        to.extend(number.iter().map(|&i| from[i as usize]));
    }
}

/// The entries of `from` into those of this `number` of `to`, which then has `count`; none where there are none.
fn scatter<T: Copy + Default>((number, count): (&[u32], usize), from: &[T], to: &mut Vec<T>) {
    if from.is_empty() {
        return to.clear();
    }
    to.resize(count, T::default());
    for (&i, own) in number.iter().zip(from) {
        to[i as usize] = *own;
    }
}
