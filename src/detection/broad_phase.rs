//! Broad phase: the pairs that may touch before they are looked for again.
//!
//! Each sphere has a skin of its own around where it was when its pairs were found, its anchor `a`:
//!
//! ```text
//! the list has every pair with   |a_i - a_j| < R_i + s_i + R_j + s_j
//! and serves a sphere while      |x_i - c - a_i| + reach_i < s_i
//! ```
//! with `c` a displacement that all have in common. A sphere that leaves its skin looks for its pairs anew, the others keep
//! theirs: one fast sphere costs the others nothing. What is in the list never shows in results: the narrow phase takes from
//! it the pairs within reach, in canonical order.

use std::ops::Range;

use super::configuration::Configuration;
use super::grid::{FEW, pairs_of, sphere_pairs};
use super::near_boundaries::{NearBoundaries, NearBoundary};
use super::periodic::periodic_pairs;
use crate::Vec3;
use crate::detection::detection_distance::{DetectionDistance, SKIN, SOON, STEPS};
use crate::memory;
use crate::parallel::Pool;
use crate::spatial::cell::Image;

/// Most that a skin is longer than the reach, over the radius: fast spheres look around more often rather than farther.
const ROOM: f64 = 0.25;
/// A skin of so many times what is wanted costs too many pairs.
const LOOSE: f64 = 4.0;
/// A sphere with a longer skin over its radius is fast: it leaves its skin within fewer than [`STEPS`] steps.
const FAST: f64 = ROOM * STEPS / (STEPS - 1.0);
/// If more than one of so many spheres leave their skins, the list is built anew.
const SHARE: usize = 3;

/// Pairs with a gap below their skins where they were found.
#[derive(Debug, Clone, Default)]
pub struct NeighborList {
    /// Skin of each sphere, of a pair the sum of two \[m\], `[N]`.
    skin: Vec<f64>,
    /// Where each sphere's pairs were found, less what all had moved in common until then \[m\], `[N]`.
    anchor: Vec<Vec3>,
    present: Vec<bool>,
    /// What all have moved in common \[m\], and whether that is what they move by.
    common: Vec3,
    alike: bool,
    /// Sphere pairs `(i, j)`, `i < j`, ascending.
    pub pairs: Vec<(u32, u32)>,
    /// Sphere pairs `(i, j)`, `i < j`, with an image of `j` in a periodic cell, ascending.
    pub images: Vec<(u32, u32, Image)>,
    /// Spheres near boundaries, ascending.
    pub boundaries: NearBoundaries,
    /// What finds pairs and contacts.
    pub(crate) pool: Pool,
}

impl NeighborList {
    /// Makes sure that every pair is listed whose gap in `now` is at most what its spheres `reach`, `[N]` or none, and for a
    /// boundary `carried` \[m\] more.
    pub fn ensure(&mut self, now: &Configuration, reach: &[DetectionDistance], carried: f64) {
        let smallest = now.particles.smallest_radius();
        self.boundaries
            .ensure(now, reach, (carried, smallest), &self.pool);
        let stale = self.stale(now, reach, smallest);
        if stale.is_empty() {
            return;
        }
        if stale.len() * SHARE > now.position.len() || !now.cell.is_open() {
            self.build(now, reach, smallest);
        } else {
            self.renew(now, reach, (&stale, smallest));
        }
    }

    /// Forgets all spheres.
    pub(crate) fn forget(&mut self) {
        *self = Self {
            pool: self.pool.clone(),
            ..Self::default()
        };
    }

    /// Pairs without images and near boundaries of these spheres, of a pair the first.
    pub(super) fn of(&self, spheres: Range<usize>) -> (&[(u32, u32)], &[NearBoundary]) {
        let near = self.boundaries.all();
        let ends = [spheres.start, spheres.end];
        let pairs = ends.map(|end| self.pairs.partition_point(|&(i, _)| (i as usize) < end));
        let walls = ends.map(|end| near.partition_point(|near| (near.sphere as usize) < end));
        (&self.pairs[pairs[0]..pairs[1]], &near[walls[0]..walls[1]])
    }

    /// Spheres whose pairs have to be found anew; the `smallest` radius is known \[m\].
    fn stale(
        &mut self,
        now: &Configuration,
        reach: &[DetectionDistance],
        smallest: f64,
    ) -> Vec<u32> {
        if self.present.len() != now.present.len() {
            *self = Self {
                skin: vec![0.0; now.present.len()],
                anchor: vec![Vec3::zeros(); now.present.len()],
                present: vec![false; now.present.len()],
                boundaries: std::mem::take(&mut self.boundaries),
                pool: self.pool.clone(),
                ..Self::default()
            };
        }
        if !reach.is_empty() {
            // Pairs by the smaller reaches: all move alike, or most stand still.
            let of = |of: fn(&DetectionDistance) -> f64| {
                let sum = |_, spheres: Range<usize>| reach[spheres].iter().map(of).sum::<f64>();
                self.pool.pieces(0..reach.len(), sum, |a, b| a + b)
            };
            self.alike = of(|own| own.pairs) < of(|own| own.boundaries);
        }
        if self.alike {
            let paths = |_, spheres: Range<usize>| {
                let both = spheres.filter(|&i| self.present[i] && now.present[i]);
                both.fold((Vec3::zeros(), 0.0), |(sum, count), i| {
                    (sum + (now.position[i] - self.anchor[i]), count + 1.0)
                })
            };
            let join = |(a, few), (b, more)| (a + b, few + more);
            let all = 0..now.position.len();
            let (sum, count) = self.pool.pieces(all, paths, join);
            self.common = sum / f64::max(count, 1.0);
        }
        let is_stale = |i: usize, share: f64| {
            if !now.present[i] || !self.present[i] {
                return now.present[i] != self.present[i];
            }
            let (skin, wanted) = (
                self.skin[i],
                self.wanted(i, reach, (now.particles.radius[i], smallest)),
            );
            let room = share * (skin - self.reach(i, reach));
            let path = now.position[i] - self.common - self.anchor[i];
            let serves = room > 0.0 && path.norm_squared() < room * room;
            !serves || (!reach.is_empty() && skin > LOOSE * wanted)
        };
        let all_stale = |share: f64| {
            let mut stale = Vec::new();
            let here = |spheres: Range<usize>, stale: &mut Vec<u32>| {
                let here = spheres.filter(|&i| is_stale(i, share));
                stale.extend(here.map(|i| i as u32));
            };
            self.pool.collect(now.position.len(), here, &mut stale);
            stale
        };
        let left = all_stale(1.0);
        // A few fast ones go alone, step after step; at the end of a step all that left do, for the next one asks for more.
        let is_fast = |&i: &u32| self.skin[i as usize] > FAST * now.particles.radius[i as usize];
        if reach.is_empty() || (left.len() <= FEW && left.iter().all(is_fast)) {
            return left;
        }
        all_stale(SOON)
    }

    /// What sphere `i` may come towards others \[m\].
    fn reach(&self, i: usize, reach: &[DetectionDistance]) -> f64 {
        let own = reach.get(i).copied().unwrap_or_default();
        match self.alike {
            true => own.pairs,
            false => own.boundaries,
        }
    }

    /// The skin that sphere `i` should have \[m\]; where nothing is said about its motion, the one it has.
    fn wanted(&self, i: usize, reach: &[DetectionDistance], (radius, smallest): (f64, f64)) -> f64 {
        let wanted = match reach.is_empty() {
            true => self.skin[i],
            false => {
                let own = self.reach(i, reach);
                own + ((STEPS - 1.0) * own).min(ROOM * radius)
            }
        };
        wanted.max(0.5 * SKIN * smallest)
    }

    /// Finds all pairs.
    fn build(&mut self, now: &Configuration, reach: &[DetectionDistance], smallest: f64) {
        for i in 0..self.skin.len() {
            self.skin[i] = self.wanted(i, reach, (now.particles.radius[i], smallest));
        }
        self.anchor.copy_from_slice(now.position);
        self.present.copy_from_slice(now.present);
        self.common = Vec3::zeros();
        let sizes = self.sizes(now);
        // The old lists give their memory back before there are new ones.
        (self.pairs, self.images) = (Vec::new(), Vec::new());
        if now.cell.is_open() {
            self.pairs = sphere_pairs(now.position, now.present, &sizes, &self.pool);
        } else {
            self.images = periodic_pairs(now.cell, now.position, now.present, &sizes, &self.pool);
        }
        if !now.particles.clump.is_empty() {
            let apart = |i, j| !now.particles.are_one(i, j);
            self.pairs.retain(|&(i, j)| apart(i, j));
            self.images.retain(|&(i, j, _)| apart(i, j));
        }
    }

    /// Finds the pairs of the spheres that are `stale`, ascending.
    fn renew(
        &mut self,
        now: &Configuration,
        reach: &[DetectionDistance],
        (stale, smallest): (&[u32], f64),
    ) {
        let mut kept = vec![true; self.skin.len()];
        for i in stale.iter().map(|&i| i as usize) {
            self.skin[i] = self.wanted(i, reach, (now.particles.radius[i], smallest));
            self.anchor[i] = now.position[i] - self.common;
            self.present[i] = now.present[i];
            kept[i] = false;
        }
        self.pairs
            .retain(|&(i, j)| kept[i as usize] && kept[j as usize]);
        let mut found = pairs_of(
            stale,
            &self.anchor,
            &self.present,
            &self.sizes(now),
            &self.pool,
        );
        if !now.particles.clump.is_empty() {
            found.retain(|&(i, j)| !now.particles.are_one(i, j));
        }
        merge(&mut self.pairs, &found);
    }

    fn sizes(&self, now: &Configuration) -> Vec<f64> {
        let sizes = now.particles.radius.iter().zip(&self.skin);
        sizes.map(|(radius, skin)| radius + skin).collect()
    }
}

/// Adds what was `found` to `pairs`; both ascend and have none in common.
fn merge(pairs: &mut Vec<(u32, u32)>, found: &[(u32, u32)]) {
    let (mut old, mut new) = (pairs.len(), found.len());
    let mut all = old + new;
    memory::resize(pairs, all, (0, 0));
    // From the end, where there is room.
    while new > 0 {
        let older = old > 0 && pairs[old - 1] > found[new - 1];
        let from = if older { &mut old } else { &mut new };
        *from -= 1;
        let from = *from;
        all -= 1;
        pairs[all] = if older { pairs[from] } else { found[from] };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::particles::Particles;
    use crate::spatial::cell::Cell;
    use proptest::prelude::*;

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
        // Gaps of 0.04 and 0.454 are within its reach, those of 0.77 are beyond its skin.
        assert_eq!(own.count(), 6 + 12);
        let others = |pairs: &[(u32, u32)]| {
            let of_others = |(i, j): &&(u32, u32)| *i != fast && *j != fast;
            pairs.iter().filter(of_others).copied().collect::<Vec<_>>()
        };
        assert_eq!(others(&moving), others(&resting));
    }

    /// Where a few fast spheres leave their skins the others keep theirs; where others do, those join them that would soon follow, but
    /// for the end of a step.
    #[test]
    fn a_few_fast_ones_go_alone() {
        let count = 100;
        let particles = Particles {
            radius: vec![0.48; count],
            ..Particles::default()
        };
        let (present, cell) = (vec![true; count], Cell::default());
        let start: Vec<Vec3> = (0..count).map(|k| Vec3::x() * k as f64).collect();
        let skin = 0.5 * SKIN * 0.48;
        // The first are fast, some of the others leave their skins, and every second of those has gone most of its way.
        let renewed = |fast: usize, slow: usize, ends: bool| {
            let mut reach = vec![DetectionDistance::default(); count];
            let mut end = start.clone();
            for (k, x) in end.iter_mut().enumerate() {
                let path = if k < fast {
                    reach[k] = DetectionDistance {
                        pairs: 0.5,
                        boundaries: 0.5,
                    };
                    0.7
                } else if k < fast + slow {
                    1.5 * skin
                } else {
                    0.7 * skin * (k % 2) as f64
                };
                *x += Vec3::y() * path;
            }
            let mut list = NeighborList::default();
            let then = if ends { &[] } else { &reach[..] };
            for (position, reach) in [(&start, &reach[..]), (&end, then)] {
                let now = Configuration {
                    particles: &particles,
                    position,
                    present: &present,
                    boundaries: &[],
                    poses: &[],
                    cell: &cell,
                };
                list.ensure(&now, reach, 0.0);
            }
            let moved = |k: &usize| list.anchor[*k] != start[*k];
            (0..count).filter(moved).count()
        };
        assert_eq!([0, 1, FEW].map(|fast| renewed(fast, 0, false)), [0, 1, FEW]);
        let joined = [(FEW + 1, 0), (1, 1)].map(|(fast, slow)| renewed(fast, slow, false));
        assert!(joined.iter().all(|&joined| joined > count / 2));
        assert_eq!(
            [(FEW + 1, 0), (1, 1)].map(|(fast, slow)| renewed(fast, slow, true)),
            [FEW + 1, 2]
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

        /// While spheres drift together and apart, slowly and fast, come and go, and the list is kept, renewed or built anew.
        #[test]
        fn every_pair_within_reach_is_listed(
            places in prop::collection::vec(prop::array::uniform3(0.0..1.5_f64), 40),
            radius in prop::collection::vec(0.02..0.2_f64, 40),
            ways in prop::collection::vec((prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), 40), -4.0..-0.5_f64, 0_usize..80), 12),
            drift in prop::array::uniform3(-0.3..0.3_f64),
        ) {
            let particles = Particles { radius, ..Particles::default() };
            let mut position: Vec<Vec3> = places.into_iter().map(Vec3::from).collect();
            let (mut present, cell) = (vec![true; 40], Cell::default());
            let mut list = NeighborList::default();
            for (k, (steps, exponent, changed)) in ways.iter().enumerate() {
                // Every fourth sphere is slower by far than the fastest.
                let length = |i: usize| 10_f64.powf(exponent - (i % 4) as f64);
                for (i, (x, step)) in position.iter_mut().zip(steps).enumerate() {
                    *x += Vec3::from(*step) * length(i) + Vec3::from(drift);
                }
                if let Some(present) = present.get_mut(*changed) {
                    *present = !*present;
                }
                let now = Configuration {
                    particles: &particles,
                    position: &position,
                    present: &present,
                    boundaries: &[],
                    poses: &[],
                    cell: &cell,
                };
                // Nothing is said about the motion at the end of a step.
                let reach: Vec<DetectionDistance> = match k % 2 {
                    0 => (0..40).map(|i| DetectionDistance { pairs: length(i), boundaries: length(i) + 0.5 }).collect(),
                    _ => Vec::new(),
                };
                list.ensure(&now, &reach, 0.0);
                prop_assert!(list.pairs.is_sorted_by(|a, b| a < b));
                for i in 0..40_u32 {
                    for j in i + 1..40 {
                        let [a, b] = [i, j].map(|k| k as usize);
                        let own = |k: usize| reach.get(k).map_or(0.0, |own| own.pairs);
                        let gap = (position[a] - position[b]).norm() - particles.radius[a] - particles.radius[b];
                        let within = present[a] && present[b] && gap <= own(a) + own(b);
                        prop_assert!(!within || list.pairs.binary_search(&(i, j)).is_ok(), "{i} {j} {gap}");
                    }
                }
            }
        }
    }
}
