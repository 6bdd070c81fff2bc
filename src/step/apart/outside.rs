//! What is left out of a step because it sleeps, and what it does to the rest.
//!
//! Of `d` rings about what moves, what sleeps in the last one takes part as an obstacle alone, for its own contacts may lead out of the
//! step; what sleeps in the last but one may be touched; only what is further in may wake. Else the step is taken anew with more.

use super::zone::Zone;
use crate::Vec3;
use crate::contact::forces::Beside;
use crate::contact::{ContactForce, Partner};
use crate::scene::Scene;
use crate::scene::particles::Locks;
use crate::spatial::{SpatialVector, Wrench};
use crate::state::State;

/// What is left out of a step.
#[derive(Debug, Default)]
pub(crate) struct Outside {
    /// Where the step may change something.
    pub(super) zone: Zone,
    /// Ring of each sphere that takes part; empty where nothing that sleeps is left out.
    pub(super) ring: Vec<u8>,
    /// What the contacts do that are left out, and those that sleep in the last ring, to the boundaries, `[B]`; empty likewise.
    pub(crate) wrenches: Vec<Wrench>,
    /// External forces on what is left out \[N\].
    pub(crate) body_force: Vec3,
}

impl Outside {
    /// Forgets what it was.
    pub(super) fn clear(&mut self) {
        self.ring.clear();
        self.wrenches.clear();
        self.body_force = Vec3::zeros();
    }

    /// Whether there is nothing that sleeps outside.
    pub(crate) fn is_empty(&self) -> bool {
        self.ring.is_empty()
    }

    /// Whether sphere `i` is an obstacle alone.
    pub(crate) fn is_obstacle(&self, i: usize) -> bool {
        self.ring
            .get(i)
            .is_some_and(|&ring| ring >= self.zone.depth())
    }

    /// Whether a body with sphere `i` may move from one place to another \[m\], as it would without contacts or not: all that it can touch
    /// takes part.
    pub(crate) fn admits(&self, i: usize, [from, to]: [Vec3; 2], free: Vec3) -> bool {
        let awake = |ring: u8| ring + 2 <= self.zone.depth();
        let way = (from.inf(&free), from.sup(&free));
        awake(self.ring[i]) && awake(self.zone.ring_at(to)) && self.zone.is_beside((to, to), way)
    }

    /// Whether a boundary may end in one box \[m\] that was taken to end in another.
    pub(crate) fn admits_boundary(&self, found: (Vec3, Vec3), taken: (Vec3, Vec3)) -> bool {
        self.zone.is_beside(found, taken)
    }

    /// Adds up what spheres do that do not take part, or as obstacles alone. `ring` is that of all spheres.
    pub(super) fn add_up(&mut self, scene: &Scene, state: &State, ring: &[u8]) {
        let depth = self.zone.depth();
        let sums = Sums {
            scene,
            state,
            settled: |i: usize| ring[i] >= depth,
            absent: |i: usize| ring[i] > depth,
        };
        self.wrenches.clear();
        self.wrenches.resize(state.poses.len(), Wrench::default());
        self.body_force = sums.weights(&mut self.wrenches);
        sums.contacts(&mut self.wrenches);
    }
}

/// Sums of forces on boundaries.
struct Sums<'a, F, G> {
    scene: &'a Scene,
    state: &'a State,
    /// Whether what is out of balance on a sphere that is present is of these sums, and whether the sphere takes no part.
    settled: F,
    absent: G,
}

impl<F: Fn(usize) -> bool, G: Fn(usize) -> bool> Sums<'_, F, G> {
    /// Adds the weights to what acts on the boundaries on which spheres sleep. Returns the weight of those that take no part \[N\].
    fn weights(&self, wrenches: &mut [Wrench]) -> Vec3 {
        let (state, particles) = (self.state, &self.scene.particles);
        let gravity = state.gravity_at(self.scene, state.time);
        let mut absent = Vec3::zeros();
        // Of spheres that move freely, mass [kg] and its moment [kg m] on each boundary.
        let mut on = vec![(0.0, Vec3::zeros()); wrenches.len()];
        for i in (0..particles.len()).filter(|&i| state.kinematics.present[i] && (self.settled)(i))
        {
            // The members of a clump share its mass such that their weights are its own.
            let (x, mass) = (state.kinematics.position[i], particles.mass[i]);
            let felt = particles.free(i)[0].component_mul(&gravity) * mass;
            if (self.absent)(i) {
                absent += felt;
            }
            if self.is_free(i) {
                let (total, moment) = &mut on[usize::from(state.ground[i])];
                *total += mass;
                *moment += x * mass;
            } else {
                let weight = SpatialVector {
                    linear: felt,
                    ..SpatialVector::ZERO
                };
                self.add(wrenches, i, (x, &weight));
            }
        }
        for (b, (mass, moment)) in on.into_iter().enumerate() {
            let weight = Wrench {
                force: gravity * mass,
                torque: (moment - self.pivot(b) * mass).cross(&gravity),
            };
            wrenches[b].add(&weight, 1.0);
        }
        absent
    }

    /// Adds what contacts do to boundaries, and to spheres and so to the boundaries on which these sleep.
    fn contacts(&self, wrenches: &mut [Wrench]) {
        let (state, particles) = (self.state, &self.scene.particles);
        for (k, load) in state.contacts.iter().enumerate() {
            let a = load.key.sphere as usize;
            let acts = match load.key.partner {
                Partner::Sphere { index, .. } => self.acts_outside(a, index as usize),
                Partner::Boundary { .. } => (self.settled)(a),
            };
            if !acts {
                continue;
            }
            let beside = state.contacts.beside(k);
            if let Partner::Boundary { boundary, .. } = load.key.partner
                && (self.absent)(a)
            {
                self.bear(wrenches, usize::from(boundary), (load, &beside));
            }
            let mut give = |i: usize, side: f64| {
                let arm = load.normal * (-side * particles.radius[i]);
                let couple = beside.torque.unwrap_or_default();
                let force = SpatialVector {
                    linear: load.force * side,
                    angular: (arm.cross(&load.force) + couple) * side,
                };
                if (self.settled)(i) {
                    self.add(wrenches, i, (state.kinematics.position[i], &force));
                }
            };
            give(a, 1.0);
            if let Partner::Sphere { index, .. } = load.key.partner {
                give(index as usize, -1.0);
            }
        }
    }

    /// Whether what two spheres do to each other is of these sums: it is nothing in all where they sleep on the same boundary.
    fn acts_outside(&self, a: usize, b: usize) -> bool {
        match ((self.settled)(a), (self.settled)(b)) {
            (true, true) => {
                let ground = &self.state.ground;
                ground[a] != ground[b] || !self.is_free(a) || !self.is_free(b)
            }
            (a, b) => a || b,
        }
    }

    /// Whether sphere `i` has no locked degrees of freedom.
    fn is_free(&self, i: usize) -> bool {
        self.scene.particles.locks[i] == Locks::default()
    }

    /// Adds what a contact does to its boundary.
    fn bear(&self, wrenches: &mut [Wrench], b: usize, (load, beside): (&ContactForce, &Beside)) {
        let i = load.key.sphere as usize;
        let (x, radius) = (
            self.state.kinematics.position[i],
            self.scene.particles.radius[i],
        );
        let wrench = beside.on_boundary(load, (x, radius), self.pivot(b));
        wrenches[b].add(&wrench, 1.0);
    }

    /// Adds what sphere `i` at its place \[m\] is out of balance by to what acts on the boundary on which it sleeps.
    fn add(&self, wrenches: &mut [Wrench], i: usize, (x, force): (Vec3, &SpatialVector)) {
        let b = usize::from(self.state.ground[i]);
        let [linear, angular] = self.scene.particles.free(i);
        let felt = force.component_mul(&SpatialVector { linear, angular });
        wrenches[b].add(&felt.about(x - self.pivot(b)), 1.0);
    }

    /// About which the wrench on a boundary is \[m\].
    fn pivot(&self, b: usize) -> Vec3 {
        self.scene.boundaries[b].point_of_action + self.state.poses[b].translation
    }
}
