//! Contact forces summed over bodies.
//!
//! A force acts on a sphere's surface where the normal meets it, at `-R n` from the centre of body A and `+R n` from that
//! of B; its torque is about the centre, and a couple of rolling or twisting resistance adds to it. What a boundary gets as a wrench is the step's own account
//! ([`super::BoundaryState::wrench`]); here its contacts are counted.

use super::Observation;
use crate::contact::{Contact, Partner};
use crate::problem::law::split;
use crate::scene::Method;
use crate::spatial::Wrench;

/// All loaded contacts of one body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyLoad {
    /// Force \[N\] and torque about the centre \[N m\] on a sphere; zero for boundaries.
    pub wrench: Wrench,
    /// Number of loaded contacts.
    pub count: u64,
    /// Largest normal force of one of them \[N\].
    pub max_normal_force: f64,
    /// Power \[W\] of the forces on a boundary's belt; zero for spheres.
    pub(crate) belt_power: f64,
}

impl BodyLoad {
    fn count(&mut self, contact: &Contact) {
        self.count += 1;
        self.max_normal_force = self
            .max_normal_force
            .max(contact.force.dot(&contact.normal));
    }

    fn sphere(&mut self, contact: &Contact, radius: f64, sign: f64) {
        self.count(contact);
        self.wrench.force += sign * contact.force;
        // Of the two signs of `-R n x f` on A and `R n x (-f)` on B the torques turn out equal.
        self.wrench.torque -= contact.normal.cross(&contact.force) * radius;
        self.wrench.torque += sign * contact.torque;
    }
}

/// The loads of a state.
#[derive(Debug, Clone, PartialEq)]
pub struct Loads {
    /// Those of the spheres that were asked for, in their order.
    pub spheres: Vec<BodyLoad>,
    /// `[B]`.
    pub boundaries: Vec<BodyLoad>,
    /// Number of loaded contacts.
    pub contacts: u64,
    /// Largest overlap over the smaller radius of its pair \[-\], contacts that give way left out.
    pub max_overlap: f64,
}

/// Rank of a sphere that nobody asked for.
const NOT_ASKED: u32 = u32::MAX;

impl Loads {
    /// Sums the contacts of a state, in one pass; of the spheres `of` alone, by index.
    #[must_use]
    pub fn new(state: &Observation, of: impl IntoIterator<Item = usize>) -> Self {
        let radius = &state.scene.particles.radius;
        let asked: Vec<usize> = of.into_iter().collect();
        let mut rank = vec![NOT_ASKED; radius.len()];
        for (k, &sphere) in asked.iter().enumerate() {
            rank[sphere] = k as u32;
        }
        let mut loads = Self {
            spheres: vec![BodyLoad::default(); asked.len()],
            boundaries: vec![BodyLoad::default(); state.scene.boundaries.len()],
            contacts: 0,
            max_overlap: 0.0,
        };
        for contact in state.active_contacts() {
            loads.contacts += 1;
            let a = contact.key.sphere as usize;
            if rank[a] != NOT_ASKED {
                loads.spheres[rank[a] as usize].sphere(contact, radius[a], 1.0);
            }
            let mut smaller = radius[a];
            match contact.key.partner {
                Partner::Sphere { index, .. } => {
                    let b = index as usize;
                    smaller = smaller.min(radius[b]);
                    if rank[b] != NOT_ASKED {
                        loads.spheres[rank[b] as usize].sphere(contact, radius[b], -1.0);
                    }
                }
                Partner::Boundary { boundary, .. } => {
                    let b = usize::from(boundary);
                    let belt = split(state.boundaries[b].surface_velocity, contact.normal).1;
                    loads.boundaries[b].count(contact);
                    loads.boundaries[b].belt_power -= contact.force.dot(&belt);
                }
            }
            // The penalty method's springs are not of the materials.
            let scene = state.scene;
            let rigid = || {
                scene.settings.method == Method::Penalty || scene.elasticity(contact.key).is_none()
            };
            if contact.gap < 0.0 && rigid() {
                loads.max_overlap = loads.max_overlap.max(-contact.gap / smaller);
            }
        }
        // A sphere that was asked for twice was summed up once, at its last place.
        for (k, &sphere) in asked.iter().enumerate() {
            loads.spheres[k] = loads.spheres[rank[sphere] as usize];
        }
        loads
    }
}
