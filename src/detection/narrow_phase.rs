//! Narrow phase: gaps and normals of the pairs within reach, and the true gap after a motion.

use std::ops::Range;

use super::broad_phase::NeighborList;
use super::near_boundaries::NearBoundary;
use crate::detection::configuration::{Candidate, Configuration};
use crate::geometry::ClosestPoint;
use crate::parallel::Pool;
use crate::spatial::cell::HERE;
use crate::spatial::extent::larger;

impl Configuration<'_> {
    /// Finds every pair of `list` whose gap is at most `reach(key)` \[m\], in canonical order.
    pub fn candidates(
        &self,
        list: &NeighborList,
        reach_pair: impl Fn(u32, u32) -> f64,
        reach_wall: impl Fn(u32, u16) -> f64,
        found: &mut Vec<Candidate>,
    ) {
        found.clear();
        // Both lists ascend in the sphere, and a sphere's partners are spheres before boundaries: taken in turns they
        // are in canonical order but for the features of one boundary.
        let mut boundaries = list.boundaries.iter().peekable();
        let mut closest_points = Vec::new();
        let mut wall = |near: &NearBoundary, found: &mut Vec<Candidate>| {
            let reach = reach_wall(near.sphere, near.boundary);
            self.touching(list, near, reach, &mut closest_points, found);
        };
        for &(i, j) in &list.pairs {
            while let Some(earlier) = boundaries.next_if(|near| near.sphere < i) {
                wall(earlier, found);
            }
            let reach = reach_pair(i, j);
            if self.within(i, j, reach) {
                let pair = self.pair(i, j, HERE);
                if pair.gap <= reach {
                    found.push(pair);
                }
            }
        }
        for rest in boundaries {
            wall(rest, found);
        }
        for &(i, j, image) in &list.images {
            let pair = self.pair(i, j, image);
            if pair.gap <= reach_pair(i, j) {
                found.push(pair);
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
        pool: &Pool,
        deep: &mut Vec<Candidate>,
    ) -> f64 {
        deep.clear();
        let here = |_, range: Range<usize>| self.deep(&list.pairs[range], limit);
        let (mut largest, found) = pool.pieces(0..list.pairs.len(), here, |mut a, b| {
            a.1.extend(b.1);
            (a.0.max(b.0), a.1)
        });
        deep.extend(found);
        let mut include = |gap: f64, scale: f64| {
            let overlap = -gap / scale;
            largest = largest.max(overlap);
            overlap > limit
        };
        for &(i, j, image) in &list.images {
            let pair = self.pair(i, j, image);
            if include(pair.gap, self.scale(pair.key)) {
                deep.push(pair);
            }
        }
        let (mut closest_points, mut found) = (Vec::new(), Vec::new());
        for near in list.boundaries.iter() {
            self.touching(list, near, 0.0, &mut closest_points, &mut found);
            for point in found.drain(..) {
                if include(point.gap, self.particles.radius[near.sphere as usize]) {
                    deep.push(point);
                }
            }
        }
        largest
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
