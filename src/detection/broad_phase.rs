//! Broad phase: the pairs that may touch before the next rebuild.
//!
//! Each sphere has a skin of its own. The list keeps every pair whose gap is below the sum of their two, so it serves until
//! the displacement of a sphere since, and what it may still move, exceed its skin: one fast sphere costs the others nothing. What is
//! in the list never shows in results: the narrow phase takes from it the pairs within reach, in canonical order.

use super::configuration::Configuration;
use super::grid::sphere_pairs;
use super::near_boundaries::{NearBoundaries, NearBoundary, ROUNDING, corners};
use super::periodic::periodic_pairs;
use crate::Vec3;
use crate::detection::detection_distance::DetectionDistance;
use crate::spatial::Pose;
use crate::spatial::cell::Image;
use crate::spatial::extent::{around, larger};

/// Skin of a pair, and of a sphere to boundaries, over the smallest radius when nothing moves.
const SKIN: f64 = 0.1;
/// Skin over the reach asked for: how many steps a list should serve in fast motion.
const STEPS: f64 = 4.0;

/// Pairs with a gap below their skins when the list was built.
#[derive(Debug, Clone, Default)]
pub struct NeighborList {
    /// Skin of each sphere, of a pair the sum of two \[m\], `[N]`.
    skin: Vec<DetectionDistance>,
    built_at: Vec<Vec3>,
    built_present: Vec<bool>,
    built_poses: Vec<Pose>,
    /// Sphere pairs `(i, j)`, `i < j`, ascending.
    pub pairs: Vec<(u32, u32)>,
    /// Sphere pairs `(i, j)`, `i < j`, with an image of `j` in a periodic cell, ascending.
    pub images: Vec<(u32, u32, Image)>,
    /// Spheres near boundaries, ascending.
    pub boundaries: NearBoundaries,
    /// Bounds of how much gaps at boundaries have shrunk from when the list was built to where it was ensured last \[m\]: of
    /// any sphere and boundary, and by the motion of each boundary, `[B]`.
    shrunk: f64,
    carried: Vec<f64>,
}

impl NeighborList {
    /// Makes sure that every pair is listed whose gap in `now` is at most what its spheres `reach`, `[N]` or none, and for a
    /// boundary `carried` \[m\] more.
    pub fn ensure(&mut self, now: &Configuration, reach: &[DetectionDistance], carried: f64) {
        self.carry(now);
        if self.built_present != now.present || !self.serves(now, reach, carried) {
            self.build(now, reach, carried);
        }
    }

    /// Whether a sphere, in the configuration where the list was ensured last, may be within `reach` \[m\] of the boundary: false
    /// only if it is clearly not, so that what follows does not depend on when the list was built.
    pub(crate) fn may_touch(&self, now: &Configuration, near: &NearBoundary, reach: f64) -> bool {
        // In a periodic cell another copy of the sphere may be the nearest by now.
        let shrunk = if now.cell.is_open() {
            let i = near.sphere as usize;
            (now.position[i] - self.built_at[i]).norm() + self.carried[usize::from(near.boundary)]
        } else {
            self.shrunk
        };
        near.gap - shrunk <= reach + ROUNDING * self.skin[near.sphere as usize].boundaries
    }

    /// Whether no sphere leaves its skin: pairs against what all have moved in common, or against nothing.
    fn serves(&mut self, now: &Configuration, reach: &[DetectionDistance], carried: f64) -> bool {
        let present = || (0..now.position.len()).filter(|&i| now.present[i]);
        let path = |i: usize| now.position[i] - self.built_at[i];
        let count = present().count().max(1) as f64;
        let common = present().map(path).sum::<Vec3>() / count;
        let carried_so_far = self.carried.iter().copied().fold(0.0, f64::max);
        let mut longest = 0.0;
        let (mut against_none, mut against_all, mut at_boundaries) = (false, false, false);
        for i in present() {
            let (path, skin) = (path(i), self.skin[i]);
            let reach = reach.get(i).copied().unwrap_or_default();
            let length = path.norm();
            longest = larger(longest, length);
            against_none |= length + reach.boundaries > skin.pairs;
            against_all |= (path - common).norm() + reach.pairs > skin.pairs;
            at_boundaries |= length + carried_so_far + reach.boundaries + carried > skin.boundaries;
        }
        self.shrunk = longest + carried_so_far;
        !(against_none && against_all || at_boundaries)
    }

    /// Notes how far each boundary has moved since the list was built, where spheres are.
    fn carry(&mut self, now: &Configuration) {
        self.carried.clear();
        self.carried.resize(now.poses.len(), 0.0);
        if self.built_poses == now.poses {
            return;
        }
        // A rigid displacement is largest at a corner of the box around the spheres.
        let (low, high) = around(now.present_positions());
        let corners = corners(low, high);
        let poses = self.built_poses.iter().zip(now.poses);
        for ((carried, boundary), (then, pose)) in
            self.carried.iter_mut().zip(now.boundaries).zip(poses)
        {
            if then != pose {
                let path = |corner: Vec3| {
                    let x = boundary.to_frame(pose, corner);
                    (boundary.from_frame(then, x) - corner).norm()
                };
                *carried = corners.map(path).into_iter().fold(0.0, f64::max);
            }
        }
    }

    fn build(&mut self, now: &Configuration, reach: &[DetectionDistance], carried: f64) {
        let radius = &now.particles.radius;
        let smallest = now.particles.smallest_radius();
        // Pairs by the smaller reaches: all move alike, or most stand still.
        let [alike, still] = [
            |own: &DetectionDistance| own.pairs,
            |own: &DetectionDistance| own.boundaries,
        ]
        .map(|of| reach.iter().map(of).sum::<f64>());
        let skin = |i: usize| {
            let own = reach.get(i).copied().unwrap_or_default();
            let pairs = if alike < still {
                own.pairs
            } else {
                own.boundaries
            };
            DetectionDistance {
                pairs: (STEPS * pairs).max(0.5 * SKIN * smallest),
                boundaries: (STEPS * (own.boundaries + carried)).max(SKIN * smallest),
            }
        };
        self.skin.clear();
        self.skin.extend((0..radius.len()).map(skin));
        self.built_at.clear();
        self.built_at.extend_from_slice(now.position);
        self.built_present.clear();
        self.built_present.extend_from_slice(now.present);
        self.built_poses.clear();
        self.built_poses.extend_from_slice(now.poses);
        let sizes = radius.iter().zip(&self.skin);
        let sizes: Vec<f64> = sizes.map(|(radius, skin)| radius + skin.pairs).collect();
        // The old lists give their memory back before there are new ones.
        (self.pairs, self.images) = (Vec::new(), Vec::new());
        if now.cell.is_open() {
            self.pairs = sphere_pairs(now.position, now.present, &sizes);
        } else {
            self.images = periodic_pairs(now.cell, now.position, now.present, &sizes);
        }
        self.boundaries.build(now, &self.skin);
        self.shrunk = 0.0;
        self.carried.fill(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::particles::Particles;
    use crate::spatial::cell::Cell;

    /// A lattice at rest in which one sphere flies: its own pairs are listed, and of the others those of a lattice at rest.
    #[test]
    fn a_fast_sphere_costs_the_others_nothing() {
        let side = 10_u32;
        let at = |k: u32| Vec3::from([k % side, k / side % side, k / side / side].map(f64::from));
        let position: Vec<Vec3> = (0..side.pow(3)).map(at).collect();
        let count = position.len();
        let particles = Particles {
            radius: vec![0.48; count],
            ..Particles::default()
        };
        let (present, cell) = (vec![true; count], Cell::default());
        let now = Configuration {
            particles: &particles,
            position: &position,
            present: &present,
            boundaries: &[],
            poses: &[],
            cell: &cell,
        };
        let mut reach = vec![DetectionDistance::default(); count];
        let pairs = |reach: &[DetectionDistance]| {
            let mut list = NeighborList::default();
            list.ensure(&now, reach, 0.0);
            list.pairs
        };
        let resting = pairs(&reach);
        assert_eq!(resting.len() as u32, 3 * side * side * (side - 1));
        let fast = 555;
        reach[fast as usize] = DetectionDistance {
            pairs: 0.5,
            boundaries: 0.5,
        };
        let moving = pairs(&reach);
        let own = moving.iter().filter(|(i, j)| *i == fast || *j == fast);
        assert!(own.count() > 26);
        let others = |pairs: &[(u32, u32)]| {
            let of_others = |(i, j): &&(u32, u32)| *i != fast && *j != fast;
            pairs.iter().filter(of_others).copied().collect::<Vec<_>>()
        };
        assert_eq!(others(&moving), others(&resting));
    }
}
