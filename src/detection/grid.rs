//! Pairs of spheres that are near each other, by a hierarchical grid.
//!
//! Spheres go by size into levels, each of sizes within a factor of two and with a uniform grid of its own. Within a level they
//! are sorted by cell: five runs of cells hold all forward neighbours of a sphere, and as cells are visited in order each run
//! is a pair of advancing pointers. A sphere of a coarser level looks into the cells of the finer ones that it reaches.

use crate::Vec3;
use crate::sorting::counting_sort;
use crate::spatial::extent::around;

/// Most cells along an axis; the grid coarsens beyond.
const CELLS: f64 = 1e6;
/// The coarsest level; a sphere of any size beyond is in it.
const LEVELS: usize = 40;

/// All pairs `i < j` of present spheres whose distance is below the sum of their `size` \[m\], `[N]`, ascending.
pub(crate) fn sphere_pairs(position: &[Vec3], present: &[bool], size: &[f64]) -> Vec<(u32, u32)> {
    pairs_up_to(usize::MAX, position, present, size)
}

/// As [`sphere_pairs`]; the search ends where there are more than `most` pairs.
pub(crate) fn pairs_up_to(
    most: usize,
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
) -> Vec<(u32, u32)> {
    let spheres = || (0..position.len()).filter(|&i| present[i]);
    let smallest = spheres().map(|i| size[i]).fold(f64::INFINITY, f64::min);
    let mut levels: Vec<Vec<u32>> = Vec::new();
    for i in spheres() {
        let level = ((size[i] / smallest).log2() as usize).min(LEVELS);
        if level >= levels.len() {
            levels.resize_with(level + 1, Vec::new);
        }
        levels[level].push(i as u32);
    }
    let levels = levels.into_iter().filter(|level| !level.is_empty());
    let grids: Vec<Grid> = levels
        .map(|level| Grid::new(position, size, level))
        .collect();
    let mut pairs = Vec::new();
    for (k, grid) in grids.iter().enumerate() {
        grid.pairs(most, &mut pairs);
        for finer in &grids[..k] {
            finer.pairs_with(grid, most, &mut pairs);
        }
    }
    drop(grids);
    ascending(&pairs)
}

/// A sphere of a level.
#[derive(Clone, Copy)]
struct Member {
    index: u32,
    position: Vec3,
    size: f64,
}

impl Member {
    /// The pair with `other`, if they are near.
    fn pair(&self, other: &Self) -> Option<(u32, u32)> {
        let reach = self.size + other.size;
        let near = (self.position - other.position).norm_squared() < reach * reach;
        let [i, j] = [self.index, other.index];
        near.then(|| (i.min(j), i.max(j)))
    }
}

/// The spheres of a level, sorted by cell.
struct Grid {
    low: Vec3,
    /// Edge of a cell \[m\]: two spheres that are near each other are in neighbouring ones.
    cell: f64,
    /// Cells along each axis, with an empty layer on either side that keeps runs of cells from wrapping around.
    count: [i64; 3],
    /// Cell of each member, ascending.
    cells: Vec<i64>,
    members: Vec<Member>,
    largest: f64,
}

impl Grid {
    fn new(position: &[Vec3], size: &[f64], level: Vec<u32>) -> Self {
        let (low, high) = around(level.iter().map(|&i| position[i as usize]));
        let largest = level.iter().map(|&i| size[i as usize]);
        let largest = largest.fold(0.0, f64::max);
        let mut grid = Self {
            low,
            cell: (2.0 * largest).max((high - low).max() / CELLS),
            count: [0; 3],
            cells: Vec::new(),
            members: Vec::new(),
            largest,
        };
        grid.count = grid.place(high).map(|last| last + 2);
        let mut order: Vec<(i64, u32)> = level
            .into_iter()
            .map(|i| (grid.key(grid.place(position[i as usize])), i))
            .collect();
        order.sort_unstable();
        // In the order of the cells, so that neighbours are near in memory too.
        grid.cells = order.iter().map(|(key, _)| *key).collect();
        let member = |&(_, index): &(i64, u32)| Member {
            index,
            position: position[index as usize],
            size: size[index as usize],
        };
        grid.members = order.iter().map(member).collect();
        grid
    }

    /// The cell of `x` along each axis; of what lies outside, one outside.
    fn place(&self, x: Vec3) -> [i64; 3] {
        let cell = |k: usize| ((x[k] - self.low[k]) / self.cell).clamp(-1.0, 2.0 * CELLS);
        std::array::from_fn(|k| cell(k) as i64 + 1)
    }

    /// The number of a cell.
    fn key(&self, [x, y, z]: [i64; 3]) -> i64 {
        (z * self.count[1] + y) * self.count[0] + x
    }

    /// Pairs within the level.
    fn pairs(&self, most: usize, pairs: &mut Vec<(u32, u32)>) {
        let [nx, ny, _] = self.count;
        let (cells, members) = (&self.cells[..], &self.members[..]);
        // Rows of three cells ahead of the own one, as offsets of their middle.
        let rows = [nx, nx * ny - nx, nx * ny, nx * ny + nx];
        let mut starts = [0; 4];
        for (rank, (key, own)) in cells.iter().zip(members).enumerate() {
            if pairs.len() > most {
                return;
            }
            let ahead = cells[rank + 1..].iter().zip(&members[rank + 1..]);
            let beside = ahead.take_while(|(other, _)| **other <= key + 1);
            pairs.extend(beside.filter_map(|(_, other)| own.pair(other)));
            for (start, offset) in starts.iter_mut().zip(rows) {
                while *start < cells.len() && cells[*start] < key + offset - 1 {
                    *start += 1;
                }
                let row = cells[*start..].iter().zip(&members[*start..]);
                let row = row.take_while(|(other, _)| **other <= key + offset + 1);
                pairs.extend(row.filter_map(|(_, other)| own.pair(other)));
            }
        }
    }

    /// Pairs with the spheres of a coarser level.
    fn pairs_with(&self, coarser: &Self, most: usize, pairs: &mut Vec<(u32, u32)>) {
        for big in &coarser.members {
            if pairs.len() > most {
                return;
            }
            let reach = Vec3::repeat(big.size + self.largest);
            let (from, to) = (
                self.place(big.position - reach),
                self.place(big.position + reach),
            );
            let within = |k: usize| from[k].max(1)..=to[k].min(self.count[k] - 2);
            let rows = |k: usize| (within(k).end() - within(k).start() + 1).max(0);
            if rows(1).saturating_mul(rows(2)) > self.members.len() as i64 {
                pairs.extend(self.members.iter().filter_map(|own| own.pair(big)));
                continue;
            }
            for (y, z) in within(2).flat_map(|z| within(1).map(move |y| (y, z))) {
                let [first, last] =
                    [*within(0).start(), *within(0).end()].map(|x| self.key([x, y, z]));
                let start = self.cells.partition_point(|key| *key < first);
                let row = self.cells[start..].iter().zip(&self.members[start..]);
                let row = row.take_while(|(key, _)| **key <= last);
                pairs.extend(row.filter_map(|(_, own)| own.pair(big)));
            }
        }
    }
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

    /// A large sphere farther from the small ones than whole numbers of their cells go.
    #[test]
    fn levels_may_be_as_far_apart_as_numbers_go() {
        let position = [0.0, 1e-3, 1e300].map(|x| Vec3::new(x, 0.0, 0.0));
        assert_eq!(
            sphere_pairs(&position, &[true; 3], &[1e-3, 1e-3, 1.0]),
            [(0, 1)]
        );
    }

    proptest! {
        /// Sizes over three decades: several levels.
        #[test]
        fn the_grid_finds_what_all_pairs_find(
            spheres in prop::collection::vec((prop::array::uniform3(-3.0..3.0f64), -5.0..1.0f64), 0..80),
        ) {
            let position: Vec<Vec3> = spheres.iter().map(|(p, _)| Vec3::from(*p)).collect();
            let size: Vec<f64> = spheres.iter().map(|(_, s)| s.exp()).collect();
            let present: Vec<bool> = (0..position.len()).map(|i| i % 7 != 3).collect();
            let mut expected = Vec::new();
            for i in 0..position.len() {
                for j in i + 1..position.len() {
                    let both = present[i] && present[j];
                    if both && (position[i] - position[j]).norm() < size[i] + size[j] {
                        expected.push((i as u32, j as u32));
                    }
                }
            }
            prop_assert_eq!(sphere_pairs(&position, &present, &size), expected);
        }
    }
}
