//! Narrow phase: gaps and normals of the pairs within reach, and the true gap after a motion.

use std::ops::Range;

use super::broad_phase::NeighborList;
use super::near_boundaries::NearBoundary;
use crate::detection::configuration::{Candidate, Configuration};
use crate::geometry::ClosestPoint;
use crate::memory;
use crate::spatial::cell::HERE;
use crate::spatial::extent::larger;

impl Configuration<'_> {
    /// Finds every pair of `list` whose gap is at most `reach(key)` \[m\], in canonical order.
    pub fn candidates(
        &self,
        list: &NeighborList,
        reach_pair: impl Fn(u32, u32) -> f64 + Sync,
        reach_wall: impl Fn(u32, u16) -> f64 + Sync,
        found: &mut Vec<Candidate>,
    ) {
        found.clear();
        // Both lists ascend in the sphere, and a sphere's partners are spheres before boundaries: taken in turns they
        // are in canonical order but for the features of one boundary.
        let of_spheres = |spheres: Range<usize>, found: &mut Vec<Candidate>| {
            let (pairs, boundaries) = list.of(spheres);
            let mut boundaries = boundaries.iter().peekable();
            let mut closest_points = Vec::new();
            let mut wall = |near: &NearBoundary, found: &mut Vec<Candidate>| {
                let reach = reach_wall(near.sphere, near.boundary);
                self.touching(list, near, reach, &mut closest_points, found);
            };
            for &(i, j) in pairs {
                while let Some(earlier) = boundaries.next_if(|near| near.sphere < i) {
                    wall(earlier, found);
                }
                let reach = reach_pair(i, j);
                if self.within(i, j, reach) {
                    let pair = self.pair(i, j, HERE);
                    if pair.gap <= reach {
                        memory::push(found, pair);
                    }
                }
            }
            for rest in boundaries {
                wall(rest, found);
            }
        };
        list.pool.collect(self.position.len(), of_spheres, found);
        for &(i, j, image) in &list.images {
            let pair = self.pair(i, j, image);
            if pair.gap <= reach_pair(i, j) {
                memory::push(found, pair);
            }
        }
        if !list.images.is_empty() {
            found.sort_unstable_by_key(|candidate| candidate.key);
        }
    }

    /// The largest overlap of any pair of `list` over the smaller radius \[-\], 0 without any; into `deep` goes what overlaps by
    /// more than `limit` \[-\], in the order of the list.
    pub(crate) fn overlaps(
        &self,
        list: &NeighborList,
        limit: f64,
        deep: &mut Vec<Candidate>,
    ) -> f64 {
        deep.clear();
        let join = |mut a: (f64, Vec<Candidate>), b: (f64, Vec<Candidate>)| {
            a.1.extend(b.1);
            (a.0.max(b.0), a.1)
        };
        let pairs = |_, range: Range<usize>| self.deep(&list.pairs[range], limit);
        let (mut largest, found) = list.pool.pieces(0..list.pairs.len(), pairs, join);
        deep.extend(found);
        for &(i, j, image) in &list.images {
            let pair = self.pair(i, j, image);
            let overlap = -pair.gap / self.scale(pair.key);
            largest = largest.max(overlap);
            if overlap > limit {
                deep.push(pair);
            }
        }
        let near = list.boundaries.all();
        let walls = |_, range: Range<usize>| self.deep_at_boundaries(list, &near[range], limit);
        let (at_boundaries, found) = list.pool.pieces(0..near.len(), walls, join);
        deep.extend(found);
        largest.max(at_boundaries)
    }

    /// Of `pairs` without images, what [`Self::overlaps`] finds.
    fn deep(&self, pairs: &[(u32, u32)], limit: f64) -> (f64, Vec<Candidate>) {
        let (mut largest, mut deep) = (0.0, Vec::new());
        for &(i, j) in pairs {
            if self.within(i, j, 0.0) {
                let [ra, rb] = [i, j].map(|k| self.particles.radius[k as usize]);
                let overlap = (ra + rb - self.apart(i, j)) / ra.min(rb);
                largest = larger(overlap, largest);
                if overlap > limit {
                    deep.push(self.pair(i, j, HERE));
                }
            }
        }
        (largest, deep)
    }

    /// Likewise of spheres near boundaries.
    fn deep_at_boundaries(
        &self,
        list: &NeighborList,
        near: &[NearBoundary],
        limit: f64,
    ) -> (f64, Vec<Candidate>) {
        let (mut closest_points, mut found) = (Vec::new(), Vec::new());
        let (mut largest, mut deep) = (0.0_f64, Vec::new());
        for near in near {
            self.touching(list, near, 0.0, &mut closest_points, &mut found);
            let scale = self.particles.radius[near.sphere as usize];
            for point in found.drain(..) {
                let overlap = -point.gap / scale;
                largest = largest.max(overlap);
                if overlap > limit {
                    deep.push(point);
                }
            }
        }
        (largest, deep)
    }

    /// Whether the gap of two spheres may be at most `reach` \[m\]: without a root, for most pairs are far.
    #[inline]
    fn within(&self, i: u32, j: u32, reach: f64) -> bool {
        let [a, b] = [i as usize, j as usize];
        let limit = (self.particles.radius[a] + self.particles.radius[b] + reach) * (1.0 + 1e-12);
        (self.position[a] - self.position[b]).norm_squared() <= limit * limit
    }

    /// Appends the contacts of a sphere with a boundary of a gap of at most `reach` \[m\], by feature.
    fn touching(
        &self,
        list: &NeighborList,
        near: &NearBoundary,
        reach: f64,
        closest_points: &mut Vec<ClosestPoint>,
        found: &mut Vec<Candidate>,
    ) {
        if !list.boundaries.may_touch(self, near, reach) {
            return;
        }
        let (i, b) = (near.sphere, near.boundary);
        let geometry = &self.boundaries[usize::from(b)].geometry;
        let sphere = (self.seen_by(b, i), self.particles.radius[i as usize]);
        closest_points.clear();
        geometry.touches_near(
            &list.boundaries.vicinity(near),
            sphere,
            reach,
            closest_points,
        );
        closest_points.sort_unstable_by_key(|point| point.feature);
        found.extend(
            closest_points
                .iter()
                .map(|point| self.boundary_candidate(i, b, point)),
        );
    }
}
