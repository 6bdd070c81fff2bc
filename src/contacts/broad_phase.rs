//! Broad phase: the pairs that may touch before the next rebuild.
//!
//! Spheres are sorted by the cell of a uniform grid; five runs of cells hold all forward neighbours of a
//! sphere, and as cells are visited in order each run is a pair of advancing pointers. The list keeps every
//! pair whose gap is below a skin, so it serves until two have moved against each other by what the skin leaves.
//! What is in the list never shows in results: the narrow phase takes from it the pairs within reach, in
//! canonical order.

use super::narrow_phase::Placement;
use super::near_walls::{NearWall, NearWalls, ROUNDING, corners};
use super::periodic::periodic_pairs;
use crate::Vec3;
use crate::cell::Image;
use crate::counting::counting_sort;
use crate::extent::{around, spread};
use crate::motion::Pose;

/// Skin over the smallest radius when nothing moves.
const SKIN: f64 = 0.1;
/// Skin over the reach asked for: how many steps a list should serve in fast motion.
const STEPS: f64 = 4.0;
/// Most cells along an axis; the grid coarsens beyond.
const CELLS: f64 = 1e6;

/// How wide gaps may be \[m\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reach {
    /// Of two spheres.
    pub pairs: f64,
    /// Of a sphere and a boundary.
    pub walls: f64,
}

impl Reach {
    /// Both at least `least`.
    fn at_least(self, least: f64) -> Self {
        Self {
            pairs: self.pairs.max(least),
            walls: self.walls.max(least),
        }
    }

    fn plus(self, other: Self, scale: f64) -> Self {
        Self {
            pairs: self.pairs + scale * other.pairs,
            walls: self.walls + scale * other.walls,
        }
    }

    fn exceeds(self, other: Self) -> bool {
        self.pairs > other.pairs || self.walls > other.walls
    }
}

/// Pairs with a gap below the skin when the list was built.
#[derive(Debug, Clone, Default)]
pub struct NeighborList {
    skin: Reach,
    built_at: Vec<Vec3>,
    built_present: Vec<bool>,
    built_poses: Vec<Pose>,
    /// Sphere pairs `(i, j)`, `i < j`, ascending.
    pub pairs: Vec<(u32, u32)>,
    /// Sphere pairs `(i, j)`, `i < j`, with an image of `j` in a periodic cell, ascending.
    pub images: Vec<(u32, u32, Image)>,
    /// Spheres near boundaries, ascending.
    pub walls: NearWalls,
    /// Bounds of how much gaps at boundaries have shrunk from when the list was built to where it was ensured last \[m\]: of
    /// any sphere and boundary, and by the motion of each boundary, `[B]`.
    shrunk: f64,
    carried: Vec<f64>,
}

impl NeighborList {
    /// Makes sure that every pair with a gap of at most `reach` in `now` is listed.
    pub fn ensure(&mut self, now: &Placement, reach: Reach) {
        let same = self.built_present == now.present;
        self.carry(now);
        let moved = self.moved(now);
        self.shrunk = moved.walls;
        if !same || moved.plus(reach, 1.0).exceeds(self.skin) {
            self.build(now, reach);
        }
    }

    /// Whether a sphere, in the placement where the list was ensured last, may be within `reach` \[m\] of the boundary: false
    /// only if it is clearly not, so that what follows does not depend on when the list was built.
    #[must_use]
    pub fn may_touch(&self, now: &Placement, near: &NearWall, reach: f64) -> bool {
        // In a periodic cell another copy of the sphere may be the nearest by now.
        let shrunk = if now.cell.is_open() {
            let i = near.sphere as usize;
            (now.position[i] - self.built_at[i]).norm() + self.carried[usize::from(near.boundary)]
        } else {
            self.shrunk
        };
        near.gap - shrunk <= reach + ROUNDING * self.skin.walls
    }

    /// Bound of how much any gap can have shrunk since the list was built.
    fn moved(&self, now: &Placement) -> Reach {
        let ways = self.built_at.iter().zip(now.position);
        let (pairs, spheres) = spread(ways.map(|(then, now)| now - then));
        Reach {
            pairs,
            walls: spheres + self.carried.iter().copied().fold(0.0, f64::max),
        }
    }

    /// Notes how far each boundary has moved since the list was built, where spheres are.
    fn carry(&mut self, now: &Placement) {
        self.carried.clear();
        self.carried.resize(now.poses.len(), 0.0);
        if self.built_poses == now.poses {
            return;
        }
        // A rigid displacement is largest at a corner of the box around the spheres.
        let (low, high) = around(now.present_positions());
        let corners = corners(low, high);
        let poses = self.built_poses.iter().zip(now.poses);
        for ((carried, boundary), (then, pose)) in
            self.carried.iter_mut().zip(now.boundaries).zip(poses)
        {
            if then != pose {
                let way = |corner: Vec3| {
                    let x = boundary.to_frame(pose, corner);
                    (boundary.from_frame(then, x) - corner).norm()
                };
                *carried = corners.map(way).into_iter().fold(0.0, f64::max);
            }
        }
    }

    fn build(&mut self, now: &Placement, reach: Reach) {
        let smallest = now
            .particles
            .radius
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        self.skin = Reach::default()
            .plus(reach, STEPS)
            .at_least(SKIN * smallest);
        self.built_at.clear();
        self.built_at.extend_from_slice(now.position);
        self.built_present.clear();
        self.built_present.extend_from_slice(now.present);
        self.built_poses.clear();
        self.built_poses.extend_from_slice(now.poses);
        let radius = &now.particles.radius;
        // The old lists give their memory back before there are new ones.
        (self.pairs, self.images) = (Vec::new(), Vec::new());
        if now.cell.is_open() {
            self.pairs = sphere_pairs(now.position, now.present, radius, self.skin.pairs);
        } else {
            self.images =
                periodic_pairs(now.cell, now.position, now.present, radius, self.skin.pairs);
        }
        self.walls.build(now, self.skin.walls);
        self.shrunk = 0.0;
        self.carried.fill(0.0);
    }
}

/// All pairs `i < j` of present spheres whose gap is below `skin` \[m\], ascending.
#[must_use]
pub fn sphere_pairs(
    position: &[Vec3],
    present: &[bool],
    radius: &[f64],
    skin: f64,
) -> Vec<(u32, u32)> {
    let spheres = || {
        (0_u32..)
            .zip(position)
            .filter(|(i, _)| present[*i as usize])
    };
    let (low, high) = around(spheres().map(|(_, p)| *p));
    let largest = radius.iter().copied().fold(0.0, f64::max);
    let cell = (2.0 * largest + skin).max((high - low).max() / CELLS);
    // One empty layer on either side keeps the runs of cells from wrapping around.
    let index = |x: f64, low: f64| ((x - low) / cell) as i64 + 1;
    let [nx, ny] = [0, 1].map(|k| index(high[k], low[k]) + 2);
    let mut cells: Vec<(i64, u32)> = spheres()
        .map(|(i, p)| {
            let [x, y, z] = std::array::from_fn(|k| index(p[k], low[k]));
            ((z * ny + y) * nx + x, i)
        })
        .collect();
    cells.sort_unstable();
    // In the order of the cells, so that neighbours are near in memory too.
    let places = cells.iter().map(|&(_, i)| {
        let i = i as usize;
        (position[i], radius[i])
    });
    let places: Vec<(Vec3, f64)> = places.collect();

    let mut pairs = Vec::new();
    let mut test = |own: usize, other: usize| {
        let [(x, r), (y, s)] = [places[own], places[other]];
        let reach = r + s + skin;
        if (x - y).norm_squared() < reach * reach {
            let [i, j] = [own, other].map(|rank| cells[rank].1);
            pairs.push((i.min(j), i.max(j)));
        }
    };
    // Rows of three cells ahead of the own one, as offsets of their middle.
    let rows = [nx, nx * ny - nx, nx * ny, nx * ny + nx];
    let mut starts = [0; 4];
    for (rank, &(key, _)) in cells.iter().enumerate() {
        let beside = cells[rank + 1..].iter();
        for (k, _) in (rank + 1..).zip(beside.take_while(|(other, _)| *other <= key + 1)) {
            test(rank, k);
        }
        for (start, offset) in starts.iter_mut().zip(rows) {
            while *start < cells.len() && cells[*start].0 < key + offset - 1 {
                *start += 1;
            }
            let row = cells[*start..].iter();
            for (k, _) in (*start..).zip(row.take_while(|(other, _)| *other <= key + offset + 1)) {
                test(rank, k);
            }
        }
    }
    drop((cells, places));
    ascending(&pairs)
}

/// `pairs` in ascending order.
fn ascending(pairs: &[(u32, u32)]) -> Vec<(u32, u32)> {
    let (mut ends, mut sorted) = (Vec::new(), Vec::new());
    counting_sort(pairs.iter().copied(), |pair| pair.0, &mut ends, &mut sorted);
    let mut first = 0;
    for end in ends {
        sorted[first as usize..end as usize].sort_unstable();
        first = end;
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_grid_finds_what_all_pairs_find(
            spheres in prop::collection::vec((prop::array::uniform3(-3.0..3.0f64), 0.05..0.6f64), 0..60),
            skin in 0.0..0.3f64,
        ) {
            let position: Vec<Vec3> = spheres.iter().map(|(p, _)| Vec3::from(*p)).collect();
            let radius: Vec<f64> = spheres.iter().map(|(_, r)| *r).collect();
            let present: Vec<bool> = (0..position.len()).map(|i| i % 7 != 3).collect();
            let mut expected = Vec::new();
            for i in 0..position.len() {
                for j in i + 1..position.len() {
                    let both = present[i] && present[j];
                    if both && (position[i] - position[j]).norm() < radius[i] + radius[j] + skin {
                        expected.push((i as u32, j as u32));
                    }
                }
            }
            prop_assert_eq!(sphere_pairs(&position, &present, &radius, skin), expected);
        }
    }
}
