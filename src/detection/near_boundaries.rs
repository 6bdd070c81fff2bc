//! Spheres near boundaries, each with the facets around it.

use super::configuration::Configuration;
use super::detection_distance::DetectionDistance;
use crate::Vec3;
use crate::geometry::{Cube, Vicinity};
use crate::spatial::extent::around;

/// Rounding of gaps over the skin, generously.
pub(super) const ROUNDING: f64 = 1e-6;

/// A sphere near a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NearBoundary {
    /// The sphere.
    pub sphere: u32,
    /// The boundary.
    pub boundary: u16,
    /// A bound below their gap when the list was built \[m\].
    pub(super) gap: f64,
    /// The part of the boundary's frame whose facets are known, and where they are in the list.
    cube: Cube,
    facets: [u32; 2],
}

/// Spheres and boundaries whose gap may be below a skin, ascending.
#[derive(Debug, Clone, Default)]
pub struct NearBoundaries {
    near: Vec<NearBoundary>,
    facets: Vec<u32>,
}

impl NearBoundaries {
    /// All of them, ascending.
    pub(crate) fn iter(&self) -> std::slice::Iter<'_, NearBoundary> {
        self.near.iter()
    }

    /// The facets of its boundary around a sphere.
    pub(crate) fn vicinity(&self, near: &NearBoundary) -> Vicinity<'_> {
        let [first, end] = near.facets.map(|k| k as usize);
        Vicinity::new(near.cube, &self.facets[first..end])
    }

    /// Finds all that may have a gap of at most the sphere's `skin`, `[N]`, in `now`.
    pub(super) fn build(&mut self, now: &Configuration, skin: &[DetectionDistance]) {
        self.near.clear();
        self.facets.clear();
        let boxes = boxes(now);
        let mut closest_points = Vec::new();
        let spheres = now.position.iter().zip(&now.particles.radius);
        for (i, (&x, &radius)) in spheres.enumerate().filter(|(i, _)| now.present[*i]) {
            let skin = skin[i].boundaries;
            let near = radius + skin * (1.0 + ROUNDING);
            for (b, bounds) in boxes.iter().enumerate() {
                let misses = |(low, high): &(Vec3, Vec3)| {
                    let outside = |k: usize| x[k] + near < low[k] || x[k] - near > high[k];
                    outside(0) || outside(1) || outside(2)
                };
                if bounds.as_ref().is_some_and(misses) {
                    continue;
                }
                let (sphere, boundary) = (i as u32, b as u16);
                let centre = now.seen_by(boundary, sphere);
                let geometry = &now.boundaries[b].geometry;
                let first = self.facets.len();
                let cube = geometry.facets_near(centre, radius + skin, &mut self.facets);
                let known = Vicinity::new(cube, &self.facets[first..]);
                let gap = geometry.least_gap(&known, (centre, radius), skin, &mut closest_points);
                match gap <= skin {
                    false => self.facets.truncate(first),
                    true => self.near.push(NearBoundary {
                        sphere,
                        boundary,
                        gap,
                        cube,
                        facets: [first, self.facets.len()].map(|k| k as u32),
                    }),
                }
            }
        }
    }
}

/// Boxes \[m\] around the boundaries, `[B]`: `None` where any sphere may be near.
fn boxes(now: &Configuration) -> Vec<Option<(Vec3, Vec3)>> {
    let boundaries = now.boundaries.iter().zip(now.poses);
    let boxes = boundaries.map(|(boundary, pose)| {
        let (min, max) = boundary.geometry.bounds().filter(|_| now.cell.is_open())?;
        let corners = corners(min, max).map(|corner| boundary.from_frame(pose, corner));
        Some(around(corners.into_iter()))
    });
    boxes.collect()
}

/// The corners of a box.
pub(super) fn corners(low: Vec3, high: Vec3) -> [Vec3; 8] {
    std::array::from_fn(|k| {
        Vec3::from_fn(|axis, _| {
            if k >> axis & 1 == 0 {
                low[axis]
            } else {
                high[axis]
            }
        })
    })
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
