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

#[cfg(test)]
mod tests {
    use std::borrow::Cow;
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::simulation::Simulation;
    use crate::spatial::SpatialVector;
    use crate::step::{Effort, StepInput, Workspace, stages, step};

    /// Rods lie on a floor; one ball has left, the next one hangs on a spring.
    const SCENE: &str = r#"
[simulation]
duration = 1.0
step = 2e-3
tolerance = { gap = 1e-9, slip = 1e-9, force = 1e-9, opening = 0 }
[[material]]
name = "stone"
density = 2500.0
[pair_default]
friction = 0.4
[[clump]]
name = "rod"
members = [{ position = [0, 0, 0], radius = 1 }, { position = [1.2, 0, 0], radius = 1 }]
[[spheres]]
name = "balls"
material = "stone"
radius = 0.02
positions = [[0, 0, -3.0], [0, 0, 1.0]]
[[spring]]
sphere = "balls[1]"
stiffness = 1000.0
target = [0, 0, 1.0]
[[source]]
name = "rods"
material = "stone"
clump = "rod"
radius = 0.015
capacity = 40
rate = 100
stop = 0.1
seed = 3
region = { box = { min = [-0.1, -0.1, 0.02], max = [0.1, 0.1, 0.1] } }
[[boundary]]
name = "floor"
material = "stone"
faces = [{ rectangle = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] } }]
[[sink]]
name = "drain"
region = { beyond = { point = [0, 0, -1], normal = [0, 0, -1] } }
"#;

    const FRAME: &str = "rotating_frame = { axis = [0, 0, 1], speed = 0.2 }";

    /// That scene, and more of its simulation.
    fn at(time: f64, more: &str) -> Simulation {
        let text = SCENE.replace("[simulation]", &format!("[simulation]\n{more}"));
        let loaded = Scene::from_toml("scene", &text, Path::new(""));
        let loaded = loaded.unwrap_or_else(|error| panic!("{}", error.plain()));
        let mut simulation = Simulation::new(Arc::new(loaded.scene)).expect("a start");
        simulation.advance_to(time).expect("steps");
        simulation
    }

    /// A step of the present ones alone is that of all. Returns the state before it and after.
    fn same_as_among_all(simulation: &Simulation) -> [State; 2] {
        let (scene, start) = (simulation.scene(), simulation.state());
        let input = StepInput {
            dt: 1e-3,
            poses: start.poses.clone(),
            commands: Cow::Borrowed(&start.commands),
        };
        let effort = Effort::default();
        let [mut alone, mut all] = [(); 2].map(|()| (start.clone(), Workspace::default()));
        step(scene, &mut alone.0, &mut alone.1, &input, effort).expect("a step");
        stages(scene, &mut all.0, &mut all.1, &input, effort).expect("a step");
        assert_eq!(alone.1.present.number.len(), 1 + 2 * 10);
        let (alone, all) = (alone.0, all.0);
        let near = |a: &[SpatialVector], b: &[SpatialVector], tolerance: f64| {
            assert_eq!(a.len(), b.len());
            for (i, (a, b)) in a.iter().zip(b).enumerate() {
                let apart = a.plus(b, -1.0);
                let size = apart.linear.norm() + apart.angular.norm();
                assert!(size < tolerance, "{i}: {a:?}, {b:?}");
            }
        };
        let moving = |state: &State| -> Vec<SpatialVector> {
            let spheres = 0..state.kinematics.len();
            let velocity = |i| state.kinematics.spatial_velocity(i);
            spheres.map(velocity).collect()
        };
        near(&moving(&alone), &moving(&all), 1e-6);
        near(&alone.smooth, &all.smooth, 1e-3);
        near(&alone.external, &all.external, 1e-9);
        assert!(moving(&all) != moving(start));
        let places = alone
            .kinematics
            .position
            .iter()
            .zip(&all.kinematics.position);
        assert!(places.into_iter().all(|(a, b)| (a - b).norm() < 1e-9));
        assert_eq!((&alone.calm, &alone.ground), (&all.calm, &all.ground));
        let keys = |state: &State| -> Vec<_> { state.contacts.iter().map(|c| c.key).collect() };
        assert_eq!(keys(&alone), keys(&all));
        assert!(keys(&all).len() > 10);
        [start.clone(), all]
    }

    #[test]
    fn the_present_ones_do_as_they_do_among_all() {
        let [_, after] = same_as_among_all(&at(0.4, FRAME));
        assert!(!after.external.is_empty());
        let [before, after] = same_as_among_all(&at(0.4, "rest_speed = 0.2"));
        assert!(after.calm.iter().any(|&steps| steps > 1) && after.calm != before.calm);
    }

    /// Lists of neighbours number the spheres that are present: they end with others.
    #[test]
    fn others_have_neighbours_of_their_own() {
        let simulation = at(0.4, "");
        let mut state = State::clone(simulation.state());
        let mut present = Present::default();
        let mut neighbors = NeighborList::default();
        let count = |neighbors: &NeighborList| neighbors.pairs.len();
        let mut look = |state: &State, neighbors: &mut NeighborList| {
            neighbors.pairs = vec![(0, 1)];
            let apart = present.apart(simulation.scene(), state, neighbors);
            assert!(apart.is_some());
        };
        look(&state, &mut neighbors);
        assert_eq!(count(&neighbors), 0);
        look(&state, &mut neighbors);
        assert_eq!(count(&neighbors), 1);
        // The last rod comes in the place of the first.
        let spheres = state.kinematics.len();
        state.kinematics.present[2..4].fill(false);
        state.kinematics.present[spheres - 2..].fill(true);
        look(&state, &mut neighbors);
        assert_eq!(count(&neighbors), 0);
    }
}
