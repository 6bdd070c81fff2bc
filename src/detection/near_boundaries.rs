//! Spheres near boundaries, each with the facets around it.
//!
//! Where a sphere was when its boundaries were looked for is its anchor. As with pairs, it looks for them anew when it has left the
//! distance within which they are known; far from all boundaries that is its radius.

use std::ops::Range;

use super::configuration::Configuration;
use super::detection_distance::{DetectionDistance, SKIN, SOON, STEPS};
use crate::Vec3;
use crate::geometry::{Ball, ClosestPoint, Vicinity};
use crate::memory::make_room;
use crate::parallel::Pool;
use crate::spatial::Pose;
use crate::spatial::extent::{around, corners, larger};

/// Rounding of gaps over the skin, generously.
const ROUNDING: f64 = 1e-6;
/// Up to so many times the distance looked at, boundaries are known by the boxes around them.
const FAR: f64 = 8.0;
/// Distances so many times as long as wanted are too long: too many facets are within.
const LOOSE: f64 = 2.0;

/// A sphere near a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NearBoundary {
    /// The sphere.
    pub sphere: u32,
    /// The boundary.
    pub boundary: u16,
    /// A bound below their gap at the anchor \[m\], and the boundary's [`NearBoundaries::carried`] then.
    gap: f64,
    /// The part of the boundary's frame whose facets are known, and where they are in the list.
    ball: Ball,
    facets: [u32; 2],
}

/// Spheres and boundaries whose gap may be below a skin, ascending.
#[derive(Debug, Clone, Default)]
pub struct NearBoundaries {
    near: Vec<NearBoundary>,
    facets: Vec<u32>,
    /// Where the boundaries of each sphere were looked for \[m\], `[N]`.
    anchor: Vec<Vec3>,
    /// Gap \[m\] up to which those of each sphere are known, and [`Self::fastest`] then, `[N]`.
    known: Vec<f64>,
    present: Vec<bool>,
    /// The largest distance within which boundaries are known \[m\].
    farthest: f64,
    poses: Vec<Pose>,
    /// How far each boundary has moved in all where spheres are \[m\], `[B]`, and the fastest one at any time.
    carried: Vec<f64>,
    fastest: f64,
}

impl NearBoundaries {
    /// All of them, ascending.
    pub(crate) fn all(&self) -> &[NearBoundary] {
        &self.near
    }

    /// The facets of its boundary around a sphere.
    pub(crate) fn vicinity(&self, near: &NearBoundary) -> Vicinity<'_> {
        let [first, end] = near.facets.map(|k| k as usize);
        Vicinity::new(near.ball, &self.facets[first..end])
    }

    /// Whether a sphere, in the configuration where the list was ensured last, may be within `reach` \[m\] of the boundary: false
    /// only if it is clearly not, so that what follows does not depend on when the list was built.
    pub(crate) fn may_touch(&self, now: &Configuration, near: &NearBoundary, reach: f64) -> bool {
        let i = near.sphere as usize;
        let room = near.gap - self.carried[usize::from(near.boundary)] - reach;
        let path = (now.position[i] - self.anchor[i]).norm();
        path >= room - ROUNDING * (self.farthest + path)
    }

    /// Makes sure that all are known that have a gap of at most what their sphere may `reach`, `[N]` or none, and `carried` \[m\]
    /// more in `now`, whose `smallest` radius is known \[m\].
    pub(super) fn ensure(
        &mut self,
        now: &Configuration,
        reach: &[DetectionDistance],
        (carried, smallest): (f64, f64),
        pool: &Pool,
    ) {
        if self.known.len() != now.position.len() || self.poses.len() != now.poses.len() {
            *self = Self {
                anchor: vec![Vec3::zeros(); now.position.len()],
                known: vec![0.0; now.position.len()],
                present: vec![false; now.position.len()],
                poses: now.poses.to_vec(),
                carried: vec![0.0; now.poses.len()],
                ..Self::default()
            };
        }
        self.carry(now);
        let wanted = |i: usize, moved: f64| match reach.get(i) {
            Some(own) => (STEPS * (own.boundaries + carried)).max(SKIN * smallest),
            // Nothing is said about its motion: as far as it has moved.
            None => moved.max(SKIN * smallest),
        };
        let is_stale = |i: usize, share: f64| {
            if !now.present[i] || !self.present[i] {
                return now.present[i] != self.present[i];
            }
            let known = self.known[i] - self.fastest;
            let own = reach.get(i).copied().unwrap_or_default();
            let room = share * (known - own.boundaries - carried);
            let path = now.position[i] - self.anchor[i];
            !(room > 0.0 && path.norm_squared() < room * room)
        };
        let is_loose = |near: &&NearBoundary| {
            let i = near.sphere as usize;
            let most = LOOSE * larger(wanted(i, 0.0), now.particles.radius[i]);
            near.facets[0] < near.facets[1] && self.known[i] - self.fastest > most
        };
        let loose = || {
            self.near
                .iter()
                .filter(|_| !reach.is_empty())
                .filter(is_loose)
        };
        let spheres = 0..now.position.len();
        let some = |_, mut spheres: Range<usize>| spheres.any(|i| is_stale(i, 1.0));
        if loose().next().is_none() && !pool.pieces(spheres.clone(), some, |a, b| a || b) {
            return;
        }
        let mut stale = vec![false; spheres.len()];
        pool.fill(&mut stale[..], |i| is_stale(i, SOON));
        loose().for_each(|near| stale[near.sphere as usize] = true);
        let stale: Vec<usize> = spheres.filter(|&i| stale[i]).collect();
        let (near, facets) = (
            std::mem::take(&mut self.near),
            std::mem::take(&mut self.facets),
        );
        make_room(&mut self.near, near.len());
        make_room(&mut self.facets, facets.len());
        let mut others = near.iter().peekable();
        let boxes = boxes(now);
        let mut closest_points = Vec::new();
        for i in stale {
            while let Some(near) = others.next_if(|near| (near.sphere as usize) < i) {
                self.keep(near, &facets);
            }
            while others.next_if(|near| near.sphere as usize == i).is_some() {}
            let moved = match self.present[i] {
                true => (now.position[i] - self.anchor[i]).norm(),
                false => 0.0,
            };
            (self.anchor[i], self.present[i]) = (now.position[i], now.present[i]);
            if now.present[i] {
                let known = self.search(now, (i, wanted(i, moved)), &boxes, &mut closest_points);
                self.known[i] = known + self.fastest;
                self.farthest = larger(self.farthest, known);
            }
        }
        others.for_each(|near| self.keep(near, &facets));
    }

    /// Takes over one with its `facets`.
    fn keep(&mut self, near: &NearBoundary, facets: &[u32]) {
        let first = self.facets.len() as u32;
        let [from, to] = near.facets;
        self.facets
            .extend_from_slice(&facets[from as usize..to as usize]);
        let facets = [first, first + to - from];
        self.near.push(NearBoundary { facets, ..*near });
    }

    /// Adds what is near sphere `i`: all that may have a gap of at most `skin` \[m\]. Returns the gap \[m\] up to which there is
    /// nothing else.
    fn search(
        &mut self,
        now: &Configuration,
        (i, skin): (usize, f64),
        boxes: &[Option<(Vec3, Vec3)>],
        closest_points: &mut Vec<ClosestPoint>,
    ) -> f64 {
        let (x, radius) = (now.position[i], now.particles.radius[i]);
        // In a periodic cell another copy of the sphere may be the nearest soon.
        let far = match now.cell.is_open() {
            true => larger(skin, radius),
            false => skin,
        };
        let mut known = FAR * far;
        let near = radius + far * (1.0 + ROUNDING);
        for (b, bounds) in boxes.iter().enumerate() {
            if let Some((low, high)) = bounds {
                let outside = (low - x).sup(&(x - high)).max();
                if outside > near {
                    known = known.min(outside - radius);
                    continue;
                }
            }
            let (sphere, boundary) = (i as u32, b as u16);
            let there = (now.seen_by(boundary, sphere), radius);
            let geometry = &now.boundaries[b].geometry;
            let first = self.facets.len();
            let mut look = |distance: f64| {
                self.facets.truncate(first);
                let ball = geometry.facets_near(there.0, radius + distance, &mut self.facets);
                let around = Vicinity::new(ball, &self.facets[first..]);
                (
                    ball,
                    geometry.least_gap(&around, there, distance, closest_points),
                )
            };
            // Few facets are within the skin; what has none is looked at once.
            let has_facets = geometry.has_facets();
            let nearest = if has_facets { skin } else { far };
            let (ball, gap) = look(nearest);
            if gap > skin {
                let gap = if nearest < far { look(far).1 } else { gap };
                self.facets.truncate(first);
                // Bounds below the gaps of farther facets may be less than what is known already.
                known = known.min(gap.min(far).max(skin));
                continue;
            }
            if has_facets {
                known = known.min(skin);
            }
            self.near.push(NearBoundary {
                sphere,
                boundary,
                gap: gap + self.carried[b],
                ball,
                facets: [first, self.facets.len()].map(|k| k as u32),
            });
        }
        known
    }

    /// Notes how far each boundary has moved since the last time, where spheres are or were when they looked for it.
    fn carry(&mut self, now: &Configuration) {
        if self.poses == now.poses {
            return;
        }
        // A rigid displacement is largest at a corner of the box around the spheres.
        let (low, high) = around(now.present_positions());
        let margin = Vec3::repeat(self.farthest);
        let corners = corners((low - margin, high + margin));
        let mut longest = 0.0;
        let poses = self.poses.iter().zip(now.poses);
        for ((carried, boundary), (then, pose)) in
            self.carried.iter_mut().zip(now.boundaries).zip(poses)
        {
            if let Some(displacement) = pose.displacement(then, boundary.point_of_action) {
                let paths = corners.map(|corner| displacement.at(corner).norm());
                let path = paths.into_iter().fold(0.0, larger);
                *carried += path;
                longest = larger(longest, path);
            }
        }
        self.fastest += longest;
        self.poses.copy_from_slice(now.poses);
    }
}

/// Boxes \[m\] around the boundaries, `[B]`: `None` where any sphere may be near.
fn boxes(now: &Configuration) -> Vec<Option<(Vec3, Vec3)>> {
    let boundaries = now.boundaries.iter().zip(now.poses);
    let boxes = boundaries.map(|(boundary, pose)| {
        let (min, max) = boundary.geometry.bounds().filter(|_| now.cell.is_open())?;
        let corners = corners((min, max)).map(|corner| boundary.from_frame(pose, corner));
        Some(around(corners.into_iter()))
    });
    boxes.collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::contact::Partner;
    use crate::detection::broad_phase::NeighborList;
    use crate::detection::configuration::Candidate;
    use crate::geometry::{Facets, Geometry, HalfSpace, Revolution, Shape};
    use crate::scene::Boundary;
    use crate::scene::Motion;
    use crate::scene::particles::Particles;
    use crate::spatial::Pose;
    use crate::spatial::cell::Cell;

    /// Cells of a side of the bumpy floor.
    const CELLS: usize = 5;

    fn boundary(shapes: Vec<Shape>) -> Boundary {
        Boundary {
            name: String::new(),
            material: 0,
            geometry: Geometry::new(shapes).expect("a geometry"),
            motion: Motion::Fixed,
            point_of_action: Vec3::new(0.3, 0.2, 0.1),
            stiffness: None,
            belt: None,
            wall_fields: false,
        }
    }

    /// A floor of triangles over the square of side 1, a plate above it, and other shapes.
    fn boundaries(heights: &[f64]) -> Vec<Boundary> {
        let side = CELLS + 1;
        let share = |k: usize| k as f64 / CELLS as f64;
        let vertex = |k: usize| Vec3::new(share(k % side), share(k / side), heights[k]);
        let pairs = (0..CELLS * CELLS).flat_map(|k| {
            let a = (k / CELLS * side + k % CELLS) as u32;
            let [b, c, d] = [1, side as u32 + 1, side as u32].map(|step| a + step);
            [[a, b, c], [a, c, d]]
        });
        let vertices = (0..side * side).map(vertex).collect();
        let floor = Facets::mesh("floor", vertices, pairs.collect());
        let (x, y) = (Vec3::x() * 0.6, Vec3::y() * 0.6);
        let plate = Facets::rectangle(Vec3::new(0.2, 0.2, 0.5), x, y).expect("a plate");
        let plane = HalfSpace::new(Vec3::zeros(), Vec3::x()).expect("a plane");
        let foot = Vec3::new(0.5, 0.5, 0.0);
        let tube = Revolution::cylinder(foot, Vec3::z(), 0.45, 0.8).expect("a tube");
        vec![
            boundary(vec![floor.into()]),
            boundary(vec![plate.into(), tube.into()]),
            boundary(vec![plane.into()]),
        ]
    }

    /// The contacts of every sphere with every boundary, by the whole geometry.
    fn direct(now: &Configuration, reach: impl Fn(u32) -> f64) -> Vec<(u32, u16, u32, f64, Vec3)> {
        let mut found = Vec::new();
        for (i, radius) in (0..).zip(&now.particles.radius) {
            for (b, boundary) in (0..).zip(now.boundaries) {
                let (centre, mut closest_points) = (now.seen_by(b, i), Vec::new());
                let geometry = &boundary.geometry;
                geometry.closest_points(centre, *radius, reach(i), &mut closest_points);
                closest_points.sort_by_key(|point| point.feature);
                let rotation = now.poses[usize::from(b)].rotation;
                let own = closest_points
                    .iter()
                    .map(|point| (i, b, point.feature, point.gap, rotation * point.normal));
                found.extend(own);
            }
        }
        found
    }

    fn at_boundaries(found: &[Candidate]) -> Vec<(u32, u16, u32, f64, Vec3)> {
        let boundary = |found: &Candidate| match found.key.partner {
            Partner::Boundary { boundary, feature } => {
                Some((found.key.sphere, boundary, feature, found.gap, found.normal))
            }
            Partner::Sphere { .. } => None,
        };
        found.iter().filter_map(boundary).collect()
    }

    fn vectors(largest: f64, count: usize) -> impl Strategy<Value = Vec<Vec3>> {
        let vector = prop::array::uniform3(-largest..largest).prop_map(Vec3::from);
        prop::collection::vec(vector, count)
    }

    /// Balls that touch each other along the axes and three planes, in more than one piece.
    #[test]
    fn contacts_are_the_same_on_any_number_of_threads() {
        const SIDE: usize = 12;
        let count = SIDE.pow(3);
        let particles = Particles {
            radius: vec![0.5; count],
            ..Particles::default()
        };
        let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
        let plane = |axis: Vec3| HalfSpace::new(axis * -0.5, axis).expect("a plane");
        let planes = axes.map(|axis| boundary(vec![plane(axis).into()]));
        let (present, poses, cell) = (vec![true; count], [Pose::default(); 3], Cell::default());
        let at =
            |k: usize| Vec3::from([k % SIDE, k / SIDE % SIDE, k / SIDE / SIDE].map(|k| k as f64));
        let lattice: Vec<Vec3> = (0..count).map(at).collect();
        let closer: Vec<Vec3> = lattice
            .iter()
            .map(|x| x * 0.99 - Vec3::repeat(0.01))
            .collect();
        // The last one comes to the first plane, far from the others.
        let mut apart = lattice.clone();
        apart[count - 1] = Vec3::new(0.0, 20.0, 20.0);
        let reach = vec![DetectionDistance::default(); count];
        let (pairs, walls) = (3 * SIDE * SIDE * (SIDE - 1), 3 * SIDE * SIDE);
        for threads in [1, 2, 3] {
            let pool = Pool::new(threads);
            let mut list = NeighborList::default();
            list.pool = pool.clone();
            let mut look = |position: &[Vec3]| {
                let now = Configuration {
                    particles: &particles,
                    position,
                    present: &present,
                    boundaries: &planes,
                    poses: &poses,
                    cell: &cell,
                };
                let (mut found, mut deep) = (Vec::new(), Vec::new());
                list.ensure(&now, &reach, 0.0);
                now.candidates(&list, |_, _| 1e-9, |_, _| 1e-9, &mut found);
                let largest = now.overlaps(&list, 1e-9, &mut deep);
                assert!(found.windows(2).all(|two| two[0].key < two[1].key));
                (found.len(), deep.len(), largest)
            };
            pool.within(|| {
                assert_eq!(look(&lattice), (pairs + walls, 0, 0.0));
                let (found, deep, largest) = look(&closer);
                assert_eq!((found, deep), (pairs + walls, pairs + walls));
                assert!((largest - 0.02).abs() < 1e-12);
                assert_eq!(look(&apart), (pairs - 3 + walls + 1, 0, 0.0));
            });
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

        /// Bit for bit, while spheres and boundaries move, slowly and fast, and the list is kept or built anew.
        #[test]
        fn known_facets_give_the_contacts_of_the_whole_mesh(
            heights in prop::collection::vec(0.0..0.15_f64, (CELLS + 1) * (CELLS + 1)),
            places in vectors(0.6, 12),
            ways in prop::collection::vec((vectors(1.0, 12), vectors(1.0, 6), -4.0..-0.7_f64), 8),
            radius in prop::collection::vec(0.03..0.12_f64, 12),
            flat: bool,
        ) {
            let heights = match flat {
                true => vec![0.1; heights.len()],
                false => heights,
            };
            let boundaries = boundaries(&heights);
            let particles = Particles { radius, ..Particles::default() };
            let cell = Cell::default();
            let mut position: Vec<Vec3> = places.iter().map(|x| x + Vec3::new(0.5, 0.5, 0.3)).collect();
            let mut poses = vec![Pose::default(); boundaries.len()];
            let mut list = NeighborList::default();
            for (steps, turns, exponent) in ways {
                let length = 10_f64.powf(exponent);
                for (x, step) in position.iter_mut().zip(&steps) {
                    *x += step * length;
                }
                for (b, pose) in poses.iter_mut().enumerate().skip(1) {
                    let [s, turn] = [2 * b, 2 * b + 1].map(|k| turns[k] * (0.3 * length));
                    *pose = Pose::from_rotation_vector(pose.translation + s, pose.rotation_vector() + turn);
                }
                let now = Configuration {
                    particles: &particles,
                    position: &position,
                    present: &[true; 12],
                    boundaries: &boundaries,
                    poses: &poses,
                    cell: &cell,
                };
                let reach = |i: u32| length * f64::from(i % 4) / 3.0;
                list.ensure(&now, &[DetectionDistance { pairs: 0.0, boundaries: length }; 12], 0.0);
                let mut found = Vec::new();
                now.candidates(&list, |_, _| 0.0, |i, _| reach(i), &mut found);
                prop_assert_eq!(at_boundaries(&found), direct(&now, reach));
            }
        }
    }
}
