//! Sinks take spheres out of the scene, sources put them into it: at the end of every internal step, sinks first.
//!
//! What a source owes at time `t` is `rate (min(t, stop) - start)`, in spheres or in mass. It emits the first of its
//! waiting spheres whenever that much is due and a random place in its region is free; a source that finds no room or
//! has no sphere left forgoes what is due beyond that one sphere, as a choked feeder does.
//!
//! A new sphere has the source's velocity at `t`. Momentum and energy of the scene change by those of the spheres that
//! come and go; contact forces do not notice.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::Simulation;
use crate::Vec3;
use crate::contact::ContactId;
use crate::geometry::ClosestPoint;
use crate::random::rotation;
use crate::scene::{Source, Supply};
use crate::spatial::SpatialVector;
use crate::spatial::Twist;
use crate::spatial::cell::Cell;
use crate::step::{release, release_clump};

/// Places tried for one sphere before its source waits for the next step.
const TRIES: u32 = 200;
/// Share of a sphere by which what is due may fall short of it, for rounding.
const EARLY: f64 = 1e-9;

impl Source {
    /// What is due since its start, at time `t` \[s\]: spheres, or mass \[kg\].
    pub(super) fn due(&self, t: f64) -> f64 {
        let (Supply::Spheres(rate) | Supply::Mass(rate)) = self.supply;
        rate * (t.min(self.stop) - self.start).max(0.0)
    }

    /// What one sphere of `mass` \[kg\] counts.
    fn cost(&self, mass: f64) -> f64 {
        match self.supply {
            Supply::Spheres(_) => 1.0,
            Supply::Mass(_) => mass,
        }
    }
}

impl Simulation {
    /// Empties the sinks, then feeds from the sources.
    pub(super) fn exchange(&mut self) {
        for sink in 0..self.scene.sinks.len() {
            self.drain(sink);
        }
        for source in 0..self.scene.sources.len() {
            self.feed(source);
        }
    }

    /// Takes the spheres, and the clumps by their centres of mass, in a sink out of the scene; one that is held by a spring or pushed by a load stays.
    fn drain(&mut self, sink: usize) {
        let scene = &self.scene;
        let held = |i: usize| {
            scene.springs.iter().any(|spring| spring.sphere == i)
                || scene.loads.iter().any(|load| load.sphere == i)
        };
        let state = &mut *self.state;
        let kinematics = &mut state.kinematics;
        let mut taken = false;
        for i in 0..kinematics.len() {
            if !kinematics.present[i] {
                continue;
            }
            let region = &scene.sinks[sink].region;
            let (whole, centre) = match scene.particles.clump(i).map(|c| &scene.clumps[c]) {
                None => (i..i + 1, kinematics.position[i]),
                Some(clump) if clump.members.start == i => {
                    (clump.members.clone(), clump.place(kinematics).0)
                }
                // It goes with the first of its clump.
                Some(_) => continue,
            };
            let inside = region.contains_copy(&scene.cell, centre);
            if !inside || whole.clone().any(held) {
                continue;
            }
            taken = true;
            for i in whole {
                kinematics.present[i] = false;
                kinematics.velocity[i] = Vec3::zeros();
                kinematics.spin[i] = Vec3::zeros();
                state.smooth[i] = SpatialVector::ZERO;
                if let Some(calm) = state.calm.get_mut(i) {
                    *calm = 0;
                }
                if let Some(external) = state.external.get_mut(i) {
                    *external = SpatialVector::ZERO;
                }
                state.removed[sink] += scene.particles.mass[i];
            }
            let home = scene.sources.iter().position(|s| s.spheres.contains(&i));
            if let Some(source) = scene.sinks[sink].recycle.or(home) {
                state.reserves[source].waiting.push_back(i as u32);
            }
        }
        if taken {
            let (present, calm) = (&kinematics.present, &mut state.calm);
            let stays = |key: &ContactId| key.spheres().all(|i| present[i]);
            if !calm.is_empty() {
                // What it touched has lost a support.
                let lost = state.contacts.iter().filter(|load| !stays(&load.key));
                lost.flat_map(|load| load.key.spheres())
                    .for_each(|i| calm[i] = 0);
            }
            state.contacts.retain(stays);
        }
    }

    /// Emits what is due.
    fn feed(&mut self, source: usize) {
        let scene = std::sync::Arc::clone(&self.scene);
        let given = &scene.sources[source];
        let due = given.due(self.state.time);
        let mut room: Option<Neighbourhood> = None;
        loop {
            let reserve = &self.state.reserves[source];
            let Some(&next) = reserve.waiting.front() else {
                self.state.reserves[source].spent = due;
                return;
            };
            let i = next as usize;
            let mass = scene.grain(i).map(|i| scene.particles.mass[i]).sum();
            let cost = given.cost(mass);
            if due - reserve.spent < cost * (1.0 - EARLY) {
                return;
            }
            let room = room.get_or_insert_with(|| Neighbourhood::around(self, given));
            let clump = scene.particles.clump(i).map(|clump| &scene.clumps[clump]);
            let reach = clump.map_or(scene.particles.radius[i], |clump| clump.shape.reach());
            let place = room.place(self, source, reach);
            let reserve = &mut self.state.reserves[source];
            let Some(place) = place else {
                reserve.spent = due - cost;
                return;
            };
            reserve.spent += cost;
            reserve.waiting.pop_front();
            self.emit(i, place, source);
            for i in scene.grain(i) {
                room.add(self.state.kinematics.position[i], scene.particles.radius[i]);
            }
            self.state.emitted[source] += mass;
        }
    }

    /// Puts sphere `i` or the clump that it begins into the scene with the source's velocity at the present time.
    fn emit(&mut self, i: usize, place: Vec3, source: usize) {
        let (scene, state) = (&self.scene, &mut *self.state);
        let given = &scene.sources[source];
        let Twist { linear, angular } = given.twist;
        let kinematics = &mut state.kinematics;
        kinematics.present[scene.grain(i)].fill(true);
        match scene.particles.clump(i) {
            None => {
                kinematics.position[i] = place;
                kinematics.velocity[i] = linear;
                kinematics.spin[i] = angular;
                release(scene, state, i);
            }
            Some(clump) => {
                let mut random = next_stream(given.seed, &mut state.reserves[source].draws);
                let velocity = SpatialVector { linear, angular };
                let rotation = rotation(&mut random);
                scene.clumps[clump].put((place, rotation), &velocity, kinematics);
                release_clump(scene, state, clump);
            }
        }
    }
}

/// What occupies and surrounds a source's region.
struct Neighbourhood {
    /// Box around the region and the largest sphere that reaches into it \[m\].
    near: Option<(Vec3, Vec3)>,
    cell: Cell,
    /// Centre \[m\] and radius \[m\] of the spheres there, copies in a periodic cell included.
    spheres: Vec<(Vec3, f64)>,
}

impl Neighbourhood {
    fn around(simulation: &Simulation, source: &Source) -> Self {
        let particles = &simulation.scene.particles;
        let kinematics = &simulation.state.kinematics;
        let largest = particles.largest_radius();
        let near = source
            .region
            .bounds()
            .map(|(min, max)| (min.add_scalar(-largest), max.add_scalar(largest)));
        let mut room = Self {
            near,
            cell: simulation.scene.cell,
            spheres: Vec::new(),
        };
        let spheres = kinematics.position.iter().zip(&particles.radius);
        let present = spheres.zip(&kinematics.present).filter(|(_, is)| **is);
        present.for_each(|((&x, &r), _)| room.add(x, r));
        room
    }

    /// Takes in a sphere, wherever it or a copy of it occupies the region.
    fn add(&mut self, x: Vec3, radius: f64) {
        let (min, max) = self.near.unwrap_or((x, x));
        for image in self.cell.copies(x, (min, max), 0.0) {
            let x = x + self.cell.shift(image);
            if (0..3).all(|k| min[k] <= x[k] && x[k] <= max[k]) {
                self.spheres.push((x, radius));
            }
        }
    }

    /// A random free place for a sphere of `radius` \[m\], if one is found.
    fn place(&self, simulation: &mut Simulation, source: usize, radius: f64) -> Option<Vec3> {
        let scene = std::sync::Arc::clone(&simulation.scene);
        let given = &scene.sources[source];
        let mut closest_points = Vec::new();
        for _ in 0..TRIES {
            let draws = &mut simulation.state.reserves[source].draws;
            let mut random = next_stream(given.seed, draws);
            let place = given.region.random_centre(radius, &mut random)?;
            let free = self
                .spheres
                .iter()
                .all(|(x, r)| (x - place).norm_squared() >= (r + radius).powi(2));
            if free && !touches_any(simulation, place, radius, &mut closest_points) {
                return Some(place);
            }
        }
        None
    }
}

/// One stream of the generator per draw: their number is all of its state.
fn next_stream(seed: u64, draws: &mut u64) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(*draws);
    *draws += 1;
    random
}

/// Whether a sphere of `radius` \[m\] at `place` \[m\] would overlap a boundary where it stands now.
fn touches_any(
    simulation: &Simulation,
    place: Vec3,
    radius: f64,
    closest_points: &mut Vec<ClosestPoint>,
) -> bool {
    let boundaries = simulation.scene.boundaries.iter();
    boundaries
        .zip(&simulation.state.poses)
        .any(|(boundary, pose)| {
            closest_points.clear();
            let cell = &simulation.scene.cell;
            boundary.closest_points((cell, pose), (place, radius), 0.0, closest_points);
            !closest_points.is_empty()
        })
}
