//! Spheres beyond a boundary, by geometry alone.
//!
//! A sphere is beyond a boundary while its centre lies behind one of its half-spaces, or has crossed its sheets (facets,
//! cones, cylinders) an odd number of times, counted on the straight path of each step. So its overlap was larger than its
//! radius. Boundaries are those that do not move. Surfaces of revolution count by their triangulation, which lies inside
//! the surface by less than 0.13 % of its radius.

use sphere_dda::Vec3;
use sphere_dda::geometry::{Geometry, GeometryError, HalfSpace, Shape};
use sphere_dda::scene::Boundary;

/// Two crossings nearer than this share of a path are one, met at the edge between two triangles.
const SAME: f64 = 1e-9;

/// One boundary's surfaces.
#[derive(Debug, Clone)]
struct Surface {
    half_spaces: Vec<HalfSpace>,
    triangles: Vec<[Vec3; 3]>,
}

/// Follows spheres through the boundaries of a scene.
#[derive(Debug, Clone)]
pub struct Beyond {
    surfaces: Vec<Surface>,
    /// Whether each sphere has crossed each boundary's sheets an odd number of times, `[N][B]`.
    crossed: Vec<Vec<bool>>,
    position: Vec<Vec3>,
}

impl Beyond {
    /// Spheres that start at `position` \[m\], on the right side of every sheet.
    ///
    /// # Errors
    /// [`GeometryError`] if a boundary's sheets make no geometry of their own.
    pub fn new(boundaries: &[Boundary], position: &[Vec3]) -> Result<Self, GeometryError> {
        let surface = |boundary: &Boundary| {
            let mut half_spaces = Vec::new();
            let mut sheets = Vec::new();
            for shape in boundary.geometry.shapes() {
                match shape {
                    Shape::HalfSpace(plane) => half_spaces.push(*plane),
                    sheet => sheets.push(sheet.clone()),
                }
            }
            // The extent matters for half-spaces only.
            let drawn = Geometry::new(sheets)?.tessellate((Vec3::zeros(), Vec3::zeros()));
            let corner = |k: u32| drawn.points[k as usize];
            Ok(Surface {
                half_spaces,
                triangles: drawn.triangles.iter().map(|t| t.map(corner)).collect(),
            })
        };
        Ok(Self {
            surfaces: boundaries.iter().map(surface).collect::<Result<_, _>>()?,
            crossed: vec![vec![false; boundaries.len()]; position.len()],
            position: position.to_vec(),
        })
    }

    /// Spheres have moved straight to `position` \[m\], `[N]`.
    pub fn follow(&mut self, position: &[Vec3]) {
        let paths = self.position.iter().zip(position);
        for (crossed, (&from, &to)) in self.crossed.iter_mut().zip(paths) {
            for (crossed, surface) in crossed.iter_mut().zip(&self.surfaces) {
                let mut at: Vec<f64> = surface
                    .triangles
                    .iter()
                    .filter_map(|triangle| crossing(triangle, from, to))
                    .collect();
                at.sort_by(f64::total_cmp);
                at.dedup_by(|b, a| *b - *a < SAME);
                *crossed ^= at.len() % 2 == 1;
            }
        }
        self.position.copy_from_slice(position);
    }

    /// Whether sphere `i` is beyond any boundary.
    #[must_use]
    pub fn is_beyond(&self, i: usize) -> bool {
        let x = self.position[i];
        let mut surfaces = self.surfaces.iter().zip(&self.crossed[i]);
        surfaces.any(|(surface, &crossed)| {
            let behind = |plane: &HalfSpace| (x - plane.point).dot(&plane.normal) < 0.0;
            crossed || surface.half_spaces.iter().any(behind)
        })
    }

    /// Number of spheres beyond any boundary.
    #[must_use]
    pub fn count(&self) -> usize {
        (0..self.position.len())
            .filter(|&i| self.is_beyond(i))
            .count()
    }
}

/// Where on the way from `from` (0, excluded) to `to` (1, included) a triangle is crossed.
///
/// Source: T. Moeller, B. Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997.
fn crossing(&[a, b, c]: &[Vec3; 3], from: Vec3, to: Vec3) -> Option<f64> {
    let (e1, e2, path) = (b - a, c - a, to - from);
    let p = path.cross(&e2);
    let determinant = e1.dot(&p);
    if determinant == 0.0 {
        return None;
    }
    let s = (from - a) / determinant;
    let u = s.dot(&p);
    let q = s.cross(&e1);
    let v = path.dot(&q);
    let t = e2.dot(&q);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t <= 1.0).then_some(t)
}

#[cfg(test)]
mod tests {
    use sphere_dda::geometry::Facets;
    use sphere_dda::scene::Motion;

    use super::*;

    fn boundary(shape: impl Into<Shape>) -> Boundary {
        Boundary {
            name: "b".into(),
            material: 0,
            geometry: Geometry::new(vec![shape.into()]).expect("a geometry"),
            motion: Motion::Fixed,
            point_of_action: Vec3::zeros(),
            stiffness: None,
            belt: None,
            wall_fields: false,
        }
    }

    /// A square sheet 0 <= x, y <= 1 at z = 0: through it, round it, back again, and exactly through its diagonal, where
    /// its two triangles meet.
    #[test]
    fn a_sheet_is_crossed_through_and_not_around() {
        let sheet = Facets::rectangle(Vec3::zeros(), Vec3::x(), Vec3::y()).expect("a square");
        let start = [
            Vec3::new(0.3, 0.6, 1.0),
            Vec3::new(0.5, 0.5, 1.0),
            Vec3::new(1.5, 0.5, 1.0),
            Vec3::new(0.3, 0.6, 0.5),
        ];
        let mut beyond = Beyond::new(&[boundary(sheet)], &start).expect("a sheet");
        let below = start.map(|x| Vec3::new(x.x, x.y, -1.0));
        let to = [below[0], below[1], below[2], start[3]];
        beyond.follow(&to);
        let found: Vec<bool> = (0..4).map(|i| beyond.is_beyond(i)).collect();
        assert_eq!(found, [true, true, false, false]);
        assert_eq!(beyond.count(), 2);
        // Round the edge without crossing: still beyond. Back through the sheet: no longer.
        beyond.follow(&[Vec3::new(5.0, 0.6, -1.0), start[1], below[2], start[3]]);
        beyond.follow(&[Vec3::new(5.0, 0.6, 1.0), start[1], below[2], start[3]]);
        assert!(beyond.is_beyond(0) && !beyond.is_beyond(1));
    }

    #[test]
    fn a_half_space_is_solid() {
        let plane = HalfSpace::new(Vec3::zeros(), Vec3::z()).expect("a plane");
        let start = [Vec3::z(), Vec3::z() * 2.0];
        let mut beyond = Beyond::new(&[boundary(plane)], &start).expect("a plane");
        beyond.follow(&[Vec3::z() * -1e-3, Vec3::z() * 1e-3]);
        assert!(beyond.is_beyond(0) && !beyond.is_beyond(1));
    }
}
