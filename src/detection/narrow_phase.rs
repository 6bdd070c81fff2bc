//! Narrow phase: gaps and normals of the pairs within reach, and the true gap after a motion.

use std::ops::Range;

use super::broad_phase::NeighborList;
use super::near_walls::NearWall;
use crate::Vec3;
use crate::contact::{Contact, Key, Load, Partner};
use crate::geometry::Touch;
use crate::parallel::Pool;
use crate::scene::particles::{Kinematics, Particles};
use crate::scene::{Boundary, Scene};
use crate::spatial::Pose;
use crate::spatial::cell::{Cell, HERE, Image};
use crate::spatial::extent::larger;

/// Where everything is at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Placement<'a> {
    /// The spheres.
    pub particles: &'a Particles,
    /// Their centres \[m\], `[N]`.
    pub position: &'a [Vec3],
    /// Which of them are in the scene, `[N]`.
    pub present: &'a [bool],
    /// The boundaries, `[B]`.
    pub boundaries: &'a [Boundary],
    /// Their poses, `[B]`.
    pub poses: &'a [Pose],
    /// The periodic cell.
    pub cell: &'a Cell,
}

/// A pair within reach at the start of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// Identity.
    pub key: Key,
    /// Unit normal from B to A.
    pub normal: Vec3,
    /// Gap \[m\].
    pub gap: f64,
    /// Largest curvature of the constant-gap surface of the pair \[1/m\].
    pub curvature: f64,
}

impl<'a> Placement<'a> {
    /// Everything where `kinematics` and `poses` have it.
    #[must_use]
    pub fn of(scene: &'a Scene, kinematics: &'a Kinematics, poses: &'a [Pose]) -> Self {
        Self {
            particles: &scene.particles,
            position: &kinematics.position,
            present: &kinematics.present,
            boundaries: &scene.boundaries,
            poses,
            cell: &scene.cell,
        }
    }
}

impl Placement<'_> {
    /// Centres of the spheres that are in the scene \[m\].
    pub fn present_positions(&self) -> impl Iterator<Item = Vec3> {
        let spheres = self.position.iter().zip(self.present);
        spheres.filter(|(_, present)| **present).map(|(x, _)| *x)
    }

    /// Radius of the smaller partner \[m\]: the scale of a pair's overlap.
    #[must_use]
    pub fn scale(&self, key: Key) -> f64 {
        let radius = self.particles.radius[key.sphere as usize];
        match key.partner {
            Partner::Sphere { index, .. } => radius.min(self.particles.radius[index as usize]),
            Partner::Boundary { .. } => radius,
        }
    }

    fn pair(&self, i: u32, j: u32, image: Image) -> Candidate {
        let [a, b] = [i as usize, j as usize];
        let [ra, rb] = [a, b].map(|k| self.particles.radius[k]);
        let mut other = self.position[b];
        if image != HERE {
            other += self.cell.shift(image);
        }
        let distance = self.position[a] - other;
        let length = distance.norm();
        // Concentric centres have no normal: take a fixed one, so that the step goes on to resolve them.
        let normal = if length > 0.0 {
            distance / length
        } else {
            Vec3::z()
        };
        Candidate {
            key: Key {
                sphere: i,
                partner: Partner::Sphere { index: j, image },
            },
            normal,
            gap: length - ra - rb,
            curvature: 1.0 / (ra + rb),
        }
    }

    fn wall(&self, sphere: u32, boundary: u16, touch: &Touch) -> Candidate {
        let pose = &self.poses[usize::from(boundary)];
        Candidate {
            key: Key {
                sphere,
                partner: Partner::Boundary {
                    boundary,
                    feature: touch.feature,
                },
            },
            normal: pose.rotation * touch.normal,
            gap: touch.gap,
            curvature: touch.curvature,
        }
    }

    /// The centre of sphere `i` in the frame of a boundary \[m\], by the copy that is nearest to it.
    pub(super) fn seen_by(&self, boundary: u16, i: u32) -> Vec3 {
        let b = usize::from(boundary);
        let (wall, pose) = (&self.boundaries[b], &self.poses[b]);
        wall.to_frame(
            pose,
            wall.copy_near(self.cell, pose, self.position[i as usize]),
        )
    }

    /// The pair of `candidate`, seen at this placement: the same feature, the same side.
    #[must_use]
    pub fn follow(&self, candidate: &Candidate) -> Candidate {
        let i = candidate.key.sphere;
        match candidate.key.partner {
            Partner::Sphere { index, image } => self.pair(i, index, image),
            Partner::Boundary { boundary, feature } => {
                let touch = self.follow_wall(i, boundary, feature, candidate.normal);
                self.wall(i, boundary, &touch)
            }
        }
    }

    /// A feature of a boundary as sphere `i` meets it here, on the side of `normal`; in the boundary's frame.
    fn follow_wall(&self, i: u32, boundary: u16, feature: u32, normal: Vec3) -> Touch {
        let b = usize::from(boundary);
        let normal = self.poses[b].rotation.inverse() * normal;
        let centre = self.seen_by(boundary, i);
        let radius = self.particles.radius[i as usize];
        let geometry = &self.boundaries[b].geometry;
        geometry.follow(feature, normal, centre, radius)
    }

    /// Where the contact is that carried `load` and `torque` \[N m\].
    #[must_use]
    pub fn contact(&self, load: &Load, torque: Vec3) -> Contact {
        let i = load.key.sphere;
        let (point, gap) = match load.key.partner {
            Partner::Sphere { index, image } => {
                let pair = self.pair(i, index, image);
                let b = index as usize;
                let other = self.position[b] + self.cell.shift(image);
                (other + pair.normal * self.particles.radius[b], pair.gap)
            }
            Partner::Boundary { boundary, feature } => {
                let touch = self.follow_wall(i, boundary, feature, load.normal);
                let b = usize::from(boundary);
                let point = self.boundaries[b].from_frame(&self.poses[b], touch.point);
                (point, touch.gap)
            }
        };
        Contact {
            key: load.key,
            point,
            normal: load.normal,
            gap,
            force: load.force,
            torque,
        }
    }

    /// The longest way \[m\] of points fixed to boundary `b`, where spheres are, while it moves to `to`.
    #[must_use]
    pub fn carried(&self, b: usize, to: &Pose) -> f64 {
        if &self.poses[b] == to {
            return 0.0;
        }
        let mut ways = self.present_positions().map(|x| self.way_at(b, to, x));
        if self.poses[b].rotation == to.rotation {
            // A translation carries all alike, but for rounding.
            return ways.next().map_or(0.0, |way| way * (1.0 + 1e-9));
        }
        ways.fold(0.0, f64::max)
    }

    /// Way \[m\] of the point fixed to boundary `b` that is at `x` while it moves to `to`.
    #[must_use]
    pub fn way_at(&self, b: usize, to: &Pose, x: Vec3) -> f64 {
        let (wall, from) = (&self.boundaries[b], &self.poses[b]);
        if from == to {
            return 0.0;
        }
        let x = wall.copy_near(self.cell, from, x);
        (wall.from_frame(to, wall.to_frame(from, x)) - x).norm()
    }

    /// Gap \[m\] of [`Self::follow`].
    #[must_use]
    pub fn gap(&self, candidate: &Candidate) -> f64 {
        match candidate.key.partner {
            Partner::Sphere { index, image } => {
                let i = candidate.key.sphere;
                let [ra, rb] = [i, index].map(|k| self.particles.radius[k as usize]);
                let apart = match image {
                    HERE => self.apart(i, index),
                    image => self.between(i, index, image).norm(),
                };
                apart - ra - rb
            }
            Partner::Boundary { boundary, feature } => {
                let i = candidate.key.sphere;
                let touch = self.follow_wall(i, boundary, feature, candidate.normal);
                touch.gap
            }
        }
    }

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
        let mut walls = list.walls.iter().peekable();
        let mut touches = Vec::new();
        let mut wall = |near: &NearWall, found: &mut Vec<Candidate>| {
            let reach = reach_wall(near.sphere, near.boundary);
            self.touching(list, near, reach, &mut touches, found);
        };
        for &(i, j) in &list.pairs {
            while let Some(earlier) = walls.next_if(|near| near.sphere < i) {
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
        for rest in walls {
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
        let (mut touches, mut found) = (Vec::new(), Vec::new());
        for near in list.walls.iter() {
            self.touching(list, near, 0.0, &mut touches, &mut found);
            for touch in found.drain(..) {
                if include(touch.gap, self.particles.radius[near.sphere as usize]) {
                    deep.push(touch);
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

    /// Distance of the centres of spheres `i` and `j` \[m\].
    #[inline]
    fn apart(&self, i: u32, j: u32) -> f64 {
        (self.position[i as usize] - self.position[j as usize]).norm()
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
        near: &NearWall,
        reach: f64,
        touches: &mut Vec<Touch>,
        found: &mut Vec<Candidate>,
    ) {
        if !list.may_touch(self, near, reach) {
            return;
        }
        let (i, b) = (near.sphere, near.boundary);
        let geometry = &self.boundaries[usize::from(b)].geometry;
        let sphere = (self.seen_by(b, i), self.particles.radius[i as usize]);
        touches.clear();
        geometry.touches_near(&list.walls.vicinity(near), sphere, reach, touches);
        touches.sort_unstable_by_key(|touch| touch.feature);
        found.extend(touches.iter().map(|touch| self.wall(i, b, touch)));
    }
}
