//! Mass flow: spheres whose centres pass through a plane or a convex polygon.
//!
//! A sphere counts with its whole mass where its centre is. For a plane through `a` with unit normal `n` a centre
//! is *beyond* when `(c - a) . n >= 0`. A step carries it through the polygon when one end of its straight path is
//! beyond, the other is not, and the path runs inside the outline. The cumulated mass \[kg\] is the sum over steps
//!
//! ```text
//! M(t) = sum_steps sum_i m_i (beyond_i(after) - beyond_i(before)) inside_i
//! ```
//!
//! Without an outline `inside = 1` and the sum telescopes: however the time is cut, it equals the mass beyond now minus
//! then, up to the rounding of a sum of masses.
//!
//! Polygons that share an edge, corner for corner, share no path and leave none out. The path runs inside where it
//! passes every edge on the inner side; the side is the exact sign of a determinant (Shewchuk 1997, crate `robust`)
//! of the edge and the path alone. A path that meets the edge's line is counted on the left of the edge walked from its
//! lexicographically smaller corner: as if every path were shifted by the same infinitesimal amount.

use robust::{Coord3D, orient3d};

use crate::Vec3;
use crate::spatial::cell::{Cell, Image};
use crate::spatial::extent::around;

/// What a mass flow passes through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gate<'a> {
    /// A point of the plane \[m\].
    pub point: Vec3,
    /// Unit normal: passages along it count positive.
    pub normal: Vec3,
    /// Corners \[m\] of a convex polygon in the plane, turning about the normal (right hand); empty: the whole plane.
    pub outline: &'a [Vec3],
}

impl Gate<'_> {
    fn beyond(&self, centre: Vec3) -> bool {
        (centre - self.point).dot(&self.normal) >= 0.0
    }

    /// Images of the path between two centres \[m\] that may pass: through an outline in the cell, or through a plane and its
    /// copies along the periodic axis that it is square to.
    fn images(
        &self,
        cell: &Cell,
        before: Vec3,
        after: Vec3,
    ) -> impl Iterator<Item = Image> + use<> {
        let reach = (after - before).amax();
        if self.outline.is_empty() {
            let across = [0, 1, 2].map(|k| self.normal[k].abs() > 0.5);
            return cell
                .along(across)
                .copies(before, (self.point, self.point), reach);
        }
        cell.copies(before, around(self.outline.iter().copied()), reach)
    }

    /// Whether the path from a centre that is not beyond to one that is passes inside the outline.
    fn encloses(&self, low: Vec3, high: Vec3) -> bool {
        let next = self.outline.iter().cycle().skip(1);
        self.outline
            .iter()
            .zip(next)
            .all(|(&from, &to)| passes_left(from, to, low, high))
    }
}

/// Whether the line from `low` to `high` passes the edge on its left, seen against the line.
fn passes_left(from: Vec3, to: Vec3, low: Vec3, high: Vec3) -> bool {
    let at = |v: Vec3| Coord3D {
        x: v.x,
        y: v.y,
        z: v.z,
    };
    // Positive where `high` lies below the plane of `from`, `to`, `low`, which turn clockwise seen from there.
    let side = -orient3d(at(from), at(to), at(low), at(high));
    side > 0.0 || (side == 0.0 && from.as_slice() < to.as_slice())
}

/// Mass \[kg\] of the spheres whose centres pass through `gate` along its normal between `before` and `after`
/// \[m\], `[N]` each; passages against the normal count negative. `mass` \[kg\] and `present`, `[N]`. In a periodic cell the
/// gate has copies, and a passage through any of them counts.
#[must_use]
pub fn crossings(
    before: &[Vec3],
    after: &[Vec3],
    mass: &[f64],
    present: &[bool],
    gate: Gate,
    cell: &Cell,
) -> f64 {
    let mut sum = 0.0;
    let paths = before.iter().zip(after).zip(mass).zip(present);
    for (((&from, &to), mass), _) in paths.filter(|(_, present)| **present) {
        for image in gate.images(cell, from, to) {
            let [before, after] = [from, to].map(|x| x + cell.shift(image));
            match (gate.beyond(before), gate.beyond(after)) {
                (false, true) if gate.encloses(before, after) => sum += mass,
                (true, false) if gate.encloses(after, before) => sum -= mass,
                _ => {}
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use robust::{Coord, orient2d};

    const DOWN: Gate = Gate {
        point: Vec3::new(0.0, 0.0, 1.0),
        normal: Vec3::new(0.0, 0.0, -1.0),
        outline: &[],
    };

    fn at(z: f64) -> Vec3 {
        Vec3::new(0.3, -0.2, z)
    }

    fn one(before: Vec3, after: Vec3, mass: f64, gate: Gate) -> f64 {
        crossings(
            &[before],
            &[after],
            &[mass],
            &[true],
            gate,
            &Cell::default(),
        )
    }

    #[test]
    fn a_centre_on_the_plane_counts_once() {
        // Down to the plane, rest on it, on below: one passage in all.
        let path = [at(1.5), at(1.0), at(1.0), at(0.5)];
        let passed: Vec<f64> = path
            .windows(2)
            .map(|w| one(w[0], w[1], 2.5, DOWN))
            .collect();
        assert_eq!(passed, [2.5, 0.0, 0.0]);
        assert_eq!(one(at(0.5), at(1.5), 2.5, DOWN), -2.5);
    }

    #[test]
    fn an_absent_sphere_never_passes() {
        let ends = [[at(1.5); 2], [at(0.5); 2]];
        assert_eq!(
            crossings(
                &ends[0],
                &ends[1],
                &[2.5, 4.0],
                &[false, true],
                DOWN,
                &Cell::default()
            ),
            4.0
        );
    }

    #[test]
    fn a_triangle_counts_by_where_its_plane_is_crossed() {
        // The path ends outside of the triangle, but crosses the plane z = 0 at x = 0.25, y = 0.25; and the reverse.
        let corners = [Vec3::zeros(), Vec3::x(), Vec3::y()];
        let up = Gate {
            point: corners[0],
            normal: Vec3::z(),
            outline: &corners,
        };
        let (low, high) = (Vec3::new(0.25, -0.75, -1.0), Vec3::new(0.25, 1.25, 1.0));
        assert_eq!(one(low, high, 3.0, up), 3.0);
        assert_eq!(one(high, low, 3.0, up), -3.0);
        let aside = Vec3::new(0.5, 0.5, 0.0);
        assert_eq!(one(low + aside, high + aside, 3.0, up), 0.0);
        let above = Vec3::z() * 5.0;
        assert_eq!(one(low + above, high + above, 3.0, up), 0.0);
        // Corners in the opposite order: the normal they turn about is -z.
        let turned: Vec<Vec3> = corners.iter().rev().copied().collect();
        let down = Gate {
            normal: -Vec3::z(),
            outline: &turned,
            ..up
        };
        assert_eq!(one(low, high, 3.0, down), -3.0);
    }

    /// A rectangle cut into tiles along lines that need not be straight: each quadrilateral cell along a random
    /// diagonal into two triangles, the whole laid into space by `place`. Of a cell that is not convex, one diagonal
    /// lies outside: its triangles would overlap, so the cell is cut along the other.
    fn tiles(
        nodes: &[[[f64; 2]; 4]; 4],
        diagonal: &[bool],
        place: impl Fn([f64; 2]) -> Vec3,
    ) -> Vec<[Vec3; 3]> {
        let at = |[x, y]: [f64; 2]| Coord { x, y };
        let turns = |[a, b, c]: [[f64; 2]; 3]| orient2d(at(a), at(b), at(c)) > 0.0;
        let mut tiles = Vec::new();
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let [a, b, c, d] = [
                nodes[i][j],
                nodes[i + 1][j],
                nodes[i + 1][j + 1],
                nodes[i][j + 1],
            ];
            let mut cuts = [[[a, b, d], [b, c, d]], [[a, b, c], [a, c, d]]];
            if diagonal[3 * i + j] {
                cuts.reverse();
            }
            let cut = cuts.into_iter().find(|cut| cut.iter().copied().all(turns));
            let cut = cut.expect("a cell whose edges do not cross has a diagonal inside");
            tiles.extend(cut.map(|tile| tile.map(&place)));
        }
        tiles
    }

    /// Nodes of 3 x 3 unit cells, the inner ones moved by `shift`.
    fn nodes(shift: [[f64; 2]; 4]) -> [[[f64; 2]; 4]; 4] {
        let mut nodes = [[[0.0; 2]; 4]; 4];
        for (i, row) in nodes.iter_mut().enumerate() {
            for (j, node) in row.iter_mut().enumerate() {
                *node = [i as f64, j as f64];
            }
        }
        for (k, by) in shift.iter().enumerate() {
            let node = &mut nodes[1 + k / 2][1 + k % 2];
            *node = [node[0] + by[0], node[1] + by[1]];
        }
        nodes
    }

    /// A path through such a corner counted twice: the tiles of the test overlapped there, the sums were right.
    #[test]
    fn a_path_through_the_inner_corner_of_a_cell_that_is_not_convex_counts_once() {
        let nodes = nodes([
            [-0.21589804557143985, 0.2947794327934827],
            [0.28056448018179725, -0.2972888529415158],
            [0.0, 0.0],
            [-0.2202023164221808, 0.13662880217315565],
        ]);
        let place = |p: [f64; 2]| Vec3::new(p[0], p[1], 0.0);
        let corner = place(nodes[1][2]);
        let (low, high) = (corner - Vec3::z(), corner + Vec3::z());
        for middle in [false, true] {
            let mut diagonal = [false; 9];
            diagonal[4] = middle;
            let tiles = tiles(&nodes, &diagonal, place);
            let through = |from, to| -> f64 {
                let gate = |tile| Gate {
                    point: Vec3::zeros(),
                    normal: Vec3::z(),
                    outline: tile,
                };
                let each = tiles.iter().map(|tile| one(from, to, 1.0, gate(tile)));
                each.sum()
            };
            assert_eq!([through(low, high), through(high, low)], [1.0, -1.0]);
        }
    }

    proptest! {
        #[test]
        fn crossings_telescope(heights in prop::collection::vec(0.0..2.0_f64, 2..20)) {
            let total: f64 = heights
                .windows(2)
                .map(|w| one(at(w[0]), at(w[1]), 3.0, DOWN))
                .sum();
            let whole = one(at(heights[0]), at(heights[heights.len() - 1]), 3.0, DOWN);
            prop_assert_eq!(total, whole);
        }

        /// Every path through the tiled rectangle passes exactly one tile: paths through nodes and along edges too.
        #[test]
        fn tiles_share_no_sphere_and_leave_none_out(
            shift in prop::array::uniform4(prop::array::uniform2(-0.3..0.3_f64)),
            diagonal in prop::collection::vec(any::<bool>(), 9),
            slope in prop::array::uniform2(-1.0..1.0_f64),
            ends in prop::array::uniform2(prop::array::uniform2(0.0..3.0_f64)),
            pick in 0usize..4,
            upwards in any::<bool>(),
        ) {
            let nodes = nodes(shift);
            let place = |p: [f64; 2]| Vec3::new(p[0], p[1], slope[0] * p[0] + slope[1] * p[1]);
            let normal = Vec3::new(-slope[0], -slope[1], 1.0).normalize();
            // A free path; one through an inner node; one through the middle of an edge; one above an edge from end to end.
            let inner = nodes[1][2];
            let [from, to] = match pick {
                0 => ends,
                1 => [inner, inner],
                2 => [[0.5 * (inner[0] + nodes[1][1][0]), 0.5 * (inner[1] + nodes[1][1][1])]; 2],
                _ => [inner, nodes[2][2]],
            };
            let (low, high) = (place(from) - normal, place(to) + normal);
            let (low, high) = if pick == 0 { (low, high) } else {
                (place(from) - Vec3::z(), place(to) + Vec3::z())
            };
            let tiles = tiles(&nodes, &diagonal, place);
            let sum: f64 = tiles.iter().map(|tile| {
                let gate = Gate { point: Vec3::zeros(), normal, outline: tile };
                if upwards { one(low, high, 1.0, gate) } else { -one(high, low, 1.0, gate) }
            }).sum();
            // A free path that leans may cross the plane outside of the rectangle.
            let t = (low.dot(&normal)) / (low - high).dot(&normal);
            let met = low + (high - low) * t;
            let inside = (0..2).all(|k| (1e-9..3.0 - 1e-9).contains(&met[k]));
            let outside = (0..2).any(|k| !(-1e-9..3.0 + 1e-9).contains(&met[k]));
            prop_assume!(inside || outside);
            prop_assert_eq!(sum, if inside { 1.0 } else { 0.0 });
        }
    }
}
