//! Where a sphere may be: wholly inside the region and clear of the boundaries as they stand at t = 0.

use rand_chacha::ChaCha8Rng;

use crate::Vec3;
use crate::geometry::ClosestPoint;
use crate::geometry::region::Region;
use crate::scene::Boundary;
use crate::scene::particles::{Kinematics, Particles};
use crate::spatial::Pose;
use crate::spatial::cell::Cell;

/// How often a sphere is pushed out of what it overlaps before it is put back.
const PUSHES: usize = 4;
/// Relative distance a pushed sphere keeps, above rounding \[-\].
const SLACK: f64 = 1e-9;

/// The free space of a packing.
pub(super) struct FreeSpace<'a> {
    region: &'a Region,
    boundaries: Vec<(&'a Boundary, Pose)>,
    cell: Cell,
    /// Box around the region \[m\].
    pub(super) low: Vec3,
    pub(super) high: Vec3,
}

impl<'a> FreeSpace<'a> {
    /// `None` for an unbounded region.
    pub(super) fn new(region: &'a Region, boundaries: &'a [Boundary], cell: Cell) -> Option<Self> {
        let (low, high) = region.bounds()?;
        let boundaries = boundaries
            .iter()
            .map(|b| (b, b.motion.pose_at(0.0)))
            .collect();
        Some(Self {
            region,
            boundaries,
            cell,
            low,
            high,
        })
    }

    /// Centres \[m\] and radii \[m\] of present spheres that reach into it, copies in a periodic cell included.
    pub(super) fn obstacles(
        &self,
        particles: &Particles,
        initial: &Kinematics,
    ) -> Vec<(Vec3, f64)> {
        let spheres = initial.position.iter().zip(&particles.radius);
        let present = spheres.zip(&initial.present).filter(|(_, is)| **is);
        let copies = present.flat_map(|((&c, &r), _)| {
            let images = self.cell.copies(c, (self.low, self.high), r);
            images.map(move |image| (c + self.cell.shift(image), r))
        });
        let reaches = |(c, r): &(Vec3, f64)| (c - c.sup(&self.low).inf(&self.high)).norm() < *r;
        copies.filter(reaches).collect()
    }

    /// A random place in the region; `None` if the sphere does not fit.
    pub(super) fn random_centre(
        &self,
        radius: f64,
        random: &mut ChaCha8Rng,
        scratch: &mut Vec<ClosestPoint>,
    ) -> Option<Vec3> {
        let place = self.region.random_centre(radius, random)?;
        // Sums may round beyond the border.
        Some(self.region.confine(place, radius, scratch))
    }

    /// Whether the border of the region or a boundary is within `reach` \[m\] of a sphere.
    pub(super) fn borders(
        &self,
        centre: Vec3,
        radius: f64,
        reach: f64,
        scratch: &mut Vec<ClosestPoint>,
    ) -> bool {
        if !self.region.holds(centre, radius + reach) {
            return true;
        }
        self.overlaps(centre, radius, reach, scratch);
        !scratch.is_empty()
    }

    /// The place next to `centre` that admits the sphere, if a few pushes find it.
    pub(super) fn nearest(
        &self,
        centre: Vec3,
        radius: f64,
        scratch: &mut Vec<ClosestPoint>,
    ) -> Option<Vec3> {
        let mut c = centre;
        for _ in 0..PUSHES {
            c = self.region.confine(c, radius, scratch);
            if self.is_clear(c, radius, scratch) {
                return self.region.holds(c, radius).then_some(c);
            }
            for touch in scratch.iter() {
                c += touch.normal * (SLACK * radius - touch.gap).max(0.0);
            }
        }
        None
    }

    /// Whether a sphere overlaps no boundary.
    pub(super) fn is_clear(
        &self,
        centre: Vec3,
        radius: f64,
        scratch: &mut Vec<ClosestPoint>,
    ) -> bool {
        self.overlaps(centre, radius, 0.0, scratch);
        scratch.iter().all(|touch| touch.gap >= 0.0)
    }

    /// What is within `reach` \[m\] of the sphere, with normals in the world.
    fn overlaps(&self, centre: Vec3, radius: f64, reach: f64, out: &mut Vec<ClosestPoint>) {
        out.clear();
        for (boundary, pose) in &self.boundaries {
            boundary.closest_points((&self.cell, pose), (centre, radius), reach, out);
        }
    }
}
