//! Whether a ray meets a boundary.
//!
//! For advice about a scene, not for mechanics: surfaces of revolution are taken as their triangles
//! ([`Geometry::tessellate`]), which lie up to 0.12 % of the radius inside them.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};

use super::{Geometry, HalfSpace, Shape};
use crate::Vec3;
use crate::spatial::extent::passed;

/// Barycentric coordinates this far outside still count, so that no ray slips between two triangles \[-\].
const RIM: f64 = 1e-9;

type Leaf = GeomWithData<Rectangle<[f64; 3]>, [Vec3; 3]>;

/// The surface of a geometry, ready for rays in its own frame.
#[derive(Debug)]
pub(crate) struct Rays {
    tree: RTree<Leaf>,
    planes: Vec<HalfSpace>,
}

impl Rays {
    pub(crate) fn new(geometry: &Geometry) -> Self {
        let planes = geometry.shapes().iter().filter_map(|shape| match shape {
            Shape::HalfSpace(plane) => Some(*plane),
            Shape::Facets(_) | Shape::Revolution(_) => None,
        });
        let surface = geometry.tessellate((Vec3::zeros(), Vec3::zeros()));
        let leaves = surface.triangles.iter().map(|triangle| {
            let corners = triangle.map(|k| surface.points[k as usize]);
            let [a, b, c] = corners;
            let (min, max) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
            GeomWithData::new(Rectangle::from_corners(min.into(), max.into()), corners)
        });
        Self {
            tree: RTree::bulk_load(leaves.collect()),
            planes: planes.collect(),
        }
    }

    /// Whether the ray from `x` \[m\] along `direction` (any length) meets the surface; one that starts inside a
    /// half-space does.
    pub(crate) fn is_hit(&self, x: Vec3, direction: Vec3) -> bool {
        let on_plane = |plane: &HalfSpace| {
            (x - plane.point).dot(&plane.normal) < 0.0 || direction.dot(&plane.normal) < 0.0
        };
        let mut crossed = self
            .tree
            .locate_with_selection_function(Ray { x, direction });
        self.planes.iter().any(on_plane) || crossed.any(|leaf| meets(&leaf.data, x, direction))
    }
}

/// Selects the boxes that a ray passes.
struct Ray {
    x: Vec3,
    direction: Vec3,
}

impl Ray {
    fn passes(&self, bounds: &AABB<[f64; 3]>) -> bool {
        let corners = (bounds.lower().into(), bounds.upper().into());
        passed(corners, self.x, self.direction)
    }
}

impl SelectionFunction<Leaf> for Ray {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 3]>) -> bool {
        self.passes(envelope)
    }

    fn should_unpack_leaf(&self, leaf: &Leaf) -> bool {
        self.passes(&leaf.envelope())
    }
}

/// Moeller and Trumbore (1997). A ray in the triangle's plane does not hit it.
fn meets(&[a, b, c]: &[Vec3; 3], x: Vec3, direction: Vec3) -> bool {
    let (u, v) = (b - a, c - a);
    let p = direction.cross(&v);
    let det = u.dot(&p);
    if det == 0.0 {
        return false;
    }
    let s = (x - a) / det;
    let q = s.cross(&u);
    let (first, second) = (s.dot(&p), direction.dot(&q));
    first >= -RIM && second >= -RIM && first + second <= 1.0 + RIM && v.dot(&q) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::Rays;
    use crate::Vec3;
    use crate::geometry::{Facets, Geometry, HalfSpace, Revolution, Shape};

    fn rays(shape: impl Into<Shape>) -> Rays {
        Rays::new(&Geometry::new(vec![shape.into()]).unwrap())
    }

    #[test]
    fn a_ray_meets_what_lies_in_its_way_and_nothing_behind_it() {
        let square = Facets::rectangle(Vec3::zeros(), Vec3::x(), Vec3::y()).unwrap();
        let square = rays(square);
        // Also on the diagonal that its two triangles share.
        for (x, y) in [(0.5, 0.5), (0.2, 0.7), (0.0, 1.0)] {
            assert!(square.is_hit(Vec3::new(x, y, 2.0), -Vec3::z()));
            assert!(!square.is_hit(Vec3::new(x, y, 2.0), Vec3::z()));
        }
        assert!(!square.is_hit(Vec3::new(1.5, 0.5, 2.0), -Vec3::z()));
        assert!(square.is_hit(Vec3::new(1.5, 0.5, 1.0), Vec3::new(-1.0, 0.0, -1.0)));
    }

    #[test]
    fn a_ray_meets_a_funnel_beside_its_mouth_and_a_plane_from_its_free_side() {
        let cone = Revolution::frustum(Vec3::zeros(), Vec3::z(), 0.5, 2.0, 1.0).unwrap();
        let cone = rays(cone);
        assert!(!cone.is_hit(Vec3::new(0.1, 0.2, 3.0), -Vec3::z()));
        assert!(cone.is_hit(Vec3::new(1.1, 0.2, 3.0), -Vec3::z()));
        assert!(cone.is_hit(Vec3::new(0.1, 0.2, 0.5), Vec3::x()));
        let floor = rays(HalfSpace::new(Vec3::zeros(), Vec3::z()).unwrap());
        assert!(floor.is_hit(Vec3::z(), -Vec3::z()) && !floor.is_hit(Vec3::z(), Vec3::x()));
        assert!(floor.is_hit(-Vec3::z(), -Vec3::z()));
    }
}
