//! Pairs of spheres that are near each other, by a hierarchical grid.
//!
//! Spheres go by size into levels, each of sizes within a factor of two and with a uniform grid of its own. Within a level they
//! are sorted by cell, so that a row of neighbouring cells is a run of members. A sphere looks into the cells ahead of its own,
//! and into those of the coarser levels around it.
//!
//! ```text
//! number of cell (x, y, z) = x + y a + z b       modulo the number of cells, where they are scattered
//! ```
//! `a`, `b` are the counts along the axes where the box around the spheres has few cells. In a larger one, where most are empty,
//! they scatter the rows over as many cells as there are spheres: then far spheres share a cell, which costs tests alone.

use std::ops::Range;

use crate::Vec3;
use crate::parallel::Pool;
use crate::sorting::{counting_sort, first_places};
use crate::spatial::extent::{around, larger};

/// The coarsest level; a sphere of any size beyond is in it.
const LEVELS: usize = 40;
/// Most cells for each sphere before they are scattered, and the fewest that are.
const CELLS: usize = 4;
const FEWEST: usize = 1024;
/// Edge of a cell over the largest diameter, so that rounding cannot put near spheres two cells apart.
const MARGIN: f64 = 1.0 + 1e-5;
/// How often the cells around chosen spheres may be doubled in length sooner than they are scattered.
const DOUBLINGS: u32 = 4;
/// From one of so many spheres on they look around in a grid of all.
const RARE: usize = 16;
/// So many spheres look at all others sooner than a grid is made.
pub(super) const FEW: usize = 4;

/// All pairs `i < j` of present spheres whose distance is below the sum of their `size` \[m\], `[N]`, ascending.
pub(crate) fn sphere_pairs(
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
    pool: &Pool,
) -> Vec<(u32, u32)> {
    pairs_up_to(usize::MAX, position, present, size, pool)
}

/// As [`sphere_pairs`]; the search ends where there are more than `most` pairs.
pub(crate) fn pairs_up_to(
    most: usize,
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
    pool: &Pool,
) -> Vec<(u32, u32)> {
    let grids = Grids::new(members(position, present, size), 0);
    let mut pairs = Vec::new();
    for (k, grid) in grids.0.iter().enumerate() {
        let coarser = &grids.0[k + 1..];
        let of_cells = |cells, pairs: &mut Vec<_>| grid.pairs(cells, coarser, most, pairs);
        pool.collect(grid.cells(), of_cells, &mut pairs);
    }
    drop(grids);
    ascending(&pairs, position.len())
}

/// The pairs of [`sphere_pairs`] that have one of `chosen` in them.
pub(super) fn pairs_of(
    chosen: &[u32],
    position: &[Vec3],
    present: &[bool],
    size: &[f64],
    pool: &Pool,
) -> Vec<(u32, u32)> {
    let chosen = chosen.iter().filter(|&&i| present[i as usize]);
    let chosen = chosen.map(|&i| Member::new(i, position, size));
    let chosen: Vec<Member> = chosen.collect();
    let mut pairs = Vec::new();
    let all = members(position, present, size);
    if chosen.len() <= FEW {
        let mut search = Search::default();
        search.others.extend(all);
        chosen
            .iter()
            .for_each(|own| search.test(own, 0, &mut pairs));
    } else if chosen.len() * RARE > position.len() {
        let grids = Grids::new(all, DOUBLINGS);
        let around = |own: Range<usize>, pairs: &mut Vec<_>| {
            let mut search = Search::default();
            for own in &chosen[own] {
                search.around(own, &grids.0, pairs);
            }
        };
        pool.collect(chosen.len(), around, &mut pairs);
    } else {
        // All others look whether one is near: no grid of all is made.
        let grids = Grids::new(chosen.into_iter(), DOUBLINGS);
        let beside: Vec<Vec<bool>> = grids.0.iter().map(Grid::beside).collect();
        let is_near = |own: &Member| {
            let mut grids = grids.0.iter().zip(&beside);
            grids.any(|(grid, beside)| grid.may_be_near(own, beside))
        };
        let around = |others: Range<usize>, pairs: &mut Vec<_>| {
            let mut search = Search::default();
            for j in others.filter(|&j| present[j]) {
                let own = Member::new(j as u32, position, size);
                if is_near(&own) {
                    search.around(&own, &grids.0, pairs);
                }
            }
        };
        pool.collect(position.len(), around, &mut pairs);
    }
    pool.sort(&mut pairs);
    pairs.dedup();
    pairs
}

/// A sphere of a level.
#[derive(Clone, Copy, Default)]
struct Member {
    position: Vec3,
    size: f64,
    index: u32,
}

impl Member {
    fn new(index: u32, position: &[Vec3], size: &[f64]) -> Self {
        let i = index as usize;
        Self {
            position: position[i],
            size: size[i],
            index,
        }
    }
}

/// All that are present.
fn members<'a>(
    position: &'a [Vec3],
    present: &'a [bool],
    size: &'a [f64],
) -> impl Iterator<Item = Member> + Clone + 'a {
    let spheres = (0..).zip(present).filter(|(_, present)| **present);
    spheres.map(|(i, _)| Member::new(i, position, size))
}

/// What a sphere is tested against.
#[derive(Default)]
struct Search {
    others: Vec<Member>,
    near: Vec<u32>,
}

impl Search {
    /// Adds the pairs of `own` with the spheres of the `grids`.
    fn around(&mut self, own: &Member, grids: &[Grid], pairs: &mut Vec<(u32, u32)>) {
        self.others.clear();
        for grid in grids {
            grid.around(own, &mut self.others);
        }
        self.test(own, 0, pairs);
    }

    /// Adds the pairs of `own` with those of the others from `first` on that are near.
    fn test(&mut self, own: &Member, first: usize, pairs: &mut Vec<(u32, u32)>) {
        let others = &self.others[first..];
        if self.near.len() < others.len() {
            self.near.resize(others.len(), 0);
        }
        // Without a branch for each: which ones are near is hard to foresee.
        let mut count = 0;
        for other in others {
            let reach = own.size + other.size;
            let squared = (own.position - other.position).norm_squared();
            self.near[count] = other.index;
            count += usize::from(squared < reach * reach);
        }
        let i = own.index;
        let near = self.near[..count].iter().filter(|&&j| j != i);
        pairs.extend(near.map(|&j| (i.min(j), i.max(j))));
    }
}

/// The levels that have spheres, from the finest on.
struct Grids(Vec<Grid>);

impl Grids {
    fn new(members: impl Iterator<Item = Member> + Clone, doublings: u32) -> Self {
        let sizes = members.clone().map(|own| own.size);
        let smallest = sizes.fold(f64::INFINITY, f64::min);
        // The exponent of a number is its logarithm, rounded down.
        let exponent = |x: f64| (x.to_bits() >> 52) as usize;
        let mut levels: Vec<Vec<Member>> = Vec::new();
        for own in members {
            let level = exponent(own.size / smallest).saturating_sub(exponent(1.0));
            let level = level.min(LEVELS);
            if level >= levels.len() {
                levels.resize_with(level + 1, Vec::new);
            }
            levels[level].push(own);
        }
        let levels = levels.into_iter().filter(|level| !level.is_empty());
        Self(levels.map(|level| Grid::new(level, doublings)).collect())
    }
}

/// The spheres of a level, sorted by cell.
struct Grid {
    low: Vec3,
    /// One over the edge of a cell \[1/m\]: two spheres that are near each other are in neighbouring ones.
    per_length: f64,
    /// Cells along each axis, with an empty layer on either side; none where cells are scattered.
    count: Option<[i32; 3]>,
    /// Between the numbers of cells beside each other along y and z.
    stride: [u32; 2],
    /// The bits that count in the number of a cell.
    mask: u32,
    /// Where the members of each cell begin, and the end of the last.
    first: Vec<u32>,
    members: Vec<Member>,
    largest: f64,
}

impl Grid {
    /// Of the spheres of a `level`, with cells that may grow by so many `doublings` where they are many.
    fn new(level: Vec<Member>, doublings: u32) -> Self {
        let (low, high) = around(level.iter().map(|own| own.position));
        let largest = level.iter().map(|own| own.size).fold(0.0, f64::max);
        let mut grid = Self {
            low,
            per_length: 1.0 / (2.0 * largest * MARGIN),
            count: None,
            stride: [0; 2],
            mask: u32::MAX,
            first: Vec::new(),
            members: Vec::new(),
            largest,
        };
        let most = (CELLS * level.len() + FEWEST) as f64;
        let finest = grid.per_length;
        let mut box_of = |doubled: u32| {
            grid.per_length = finest / f64::from(1 << doubled);
            let count = grid.place(high).map(|last| last.saturating_add(2));
            let cells = count.iter().map(|&n| f64::from(n)).product::<f64>();
            (cells <= most).then_some((count, cells as usize))
        };
        let cells = match (0..=doublings).find_map(&mut box_of) {
            Some((count, cells)) => {
                grid.count = Some(count);
                grid.stride = [count[0] as u32, (count[0] * count[1]) as u32];
                cells
            }
            None => {
                let cells = (2 * level.len()).next_power_of_two().max(FEWEST);
                grid.per_length = finest;
                grid.mask = cells as u32 - 1;
                // Multiples of these fractions are far from whole numbers and from each other: rows of cells that are searched
                // together have no cell in common.
                grid.stride = [0.618, 0.2764].map(|share| (share * cells as f64) as u32 | 1);
                cells
            }
        };
        let place = |own: &Member| grid.key(grid.place(own.position));
        let keys: Vec<u32> = level.iter().map(place).collect();
        let mut first = Vec::new();
        first_places(keys.iter().map(|key| key + 1), cells + 1, &mut first);
        grid.members.resize(level.len(), Member::default());
        for (key, own) in keys.iter().zip(level) {
            let next = &mut first[*key as usize + 1];
            grid.members[*next as usize] = own;
            *next += 1;
        }
        // Where a cell ended is where the next one begins.
        first.truncate(cells + 1);
        grid.first = first;
        grid
    }

    /// The cell of `x` along each axis, at least 0; those of the level's own spheres are above.
    fn place(&self, x: Vec3) -> [i32; 3] {
        let cell = |k: usize| (x[k] - self.low[k]) * self.per_length + 1.0;
        std::array::from_fn(|k| larger(cell(k), 0.0) as i32)
    }

    /// The number of a cell.
    fn key(&self, [x, y, z]: [i32; 3]) -> u32 {
        let [x, y, z] = [x, y, z].map(|k| k as u32);
        let row = y.wrapping_mul(self.stride[0]);
        let layer = z.wrapping_mul(self.stride[1]);
        x.wrapping_add(row).wrapping_add(layer) & self.mask
    }

    /// Appends the members of the `length` cells from this number on.
    fn run(&self, key: u32, length: u32, others: &mut Vec<Member>) {
        let cells = self.first.len() as u32 - 1;
        let (from, length) = (key & self.mask, length.min(cells));
        let to = from + length;
        let [begin, end] = [from, to.min(cells)].map(|key| self.first[key as usize] as usize);
        others.extend_from_slice(&self.members[begin..end]);
        if to > cells {
            let end = self.first[(to - cells) as usize] as usize;
            others.extend_from_slice(&self.members[..end]);
        }
    }

    /// How many cells.
    fn cells(&self) -> usize {
        self.first.len() - 1
    }

    /// Adds pairs of the members of `cells` within the level, and with the `coarser` ones.
    fn pairs(
        &self,
        cells: Range<usize>,
        coarser: &[Self],
        most: usize,
        pairs: &mut Vec<(u32, u32)>,
    ) {
        let mut search = Search::default();
        let [row, layer] = self.stride;
        // Rows of three cells ahead of the own one, as offsets of their first.
        let rows = [row, layer.wrapping_sub(row), layer, layer.wrapping_add(row)];
        let rows = rows.map(|middle| middle.wrapping_sub(1));
        let ends = self.first[cells.start..=cells.end].windows(2);
        for (key, ends) in (cells.start as u32..).zip(ends) {
            let members = &self.members[ends[0] as usize..ends[1] as usize];
            if members.is_empty() {
                continue;
            }
            search.others.clear();
            self.run(key, 2, &mut search.others);
            for offset in rows {
                self.run(key.wrapping_add(offset), 3, &mut search.others);
            }
            let all = search.others.len();
            for (rank, own) in members.iter().enumerate() {
                if pairs.len() > most {
                    return;
                }
                for coarser in coarser {
                    coarser.around(own, &mut search.others);
                }
                search.test(own, rank + 1, pairs);
                search.others.truncate(all);
            }
        }
    }

    /// Whether each cell or one beside it has members.
    fn beside(&self) -> Vec<bool> {
        let mut beside = vec![false; self.cells()];
        for own in &self.members {
            let middle = self.key(self.place(own.position));
            for layer in [self.stride[1].wrapping_neg(), 0, self.stride[1]] {
                for row in [self.stride[0].wrapping_neg(), 0, self.stride[0]] {
                    for step in [u32::MAX, 0, 1] {
                        let key = middle.wrapping_add(layer).wrapping_add(row);
                        beside[(key.wrapping_add(step) & self.mask) as usize] = true;
                    }
                }
            }
        }
        beside
    }

    /// Whether `own` may be near a member, by what cells are [`Self::beside`] some.
    fn may_be_near(&self, own: &Member, beside: &[bool]) -> bool {
        if own.size > self.largest {
            return true;
        }
        let place = self.place(own.position);
        let outside = |count: [i32; 3]| (0..3).any(|k| place[k] >= count[k]);
        !self.count.is_some_and(outside) && beside[self.key(place) as usize]
    }

    /// Appends the members that may be near `own`.
    fn around(&self, own: &Member, others: &mut Vec<Member>) {
        let reach = Vec3::repeat((own.size + self.largest) * MARGIN);
        let from = self.place(own.position - reach);
        let mut to = self.place(own.position + reach);
        if let Some(count) = self.count {
            to = std::array::from_fn(|k| to[k].min(count[k] - 1));
        }
        let [x, y, z] = std::array::from_fn(|k| i64::from(to[k]) - i64::from(from[k]) + 1);
        if x.min(y).min(z) <= 0 {
            return;
        }
        if y.saturating_mul(z) > self.members.len() as i64 {
            return others.extend_from_slice(&self.members);
        }
        for z in from[2]..=to[2] {
            let first = self.key([from[0], from[1], z]);
            for y in 0..y as u32 {
                let key = first.wrapping_add(y.wrapping_mul(self.stride[0]));
                self.run(key, x as u32, others);
            }
        }
    }
}

/// `pairs` of so many `spheres` in ascending order.
fn ascending(pairs: &[(u32, u32)], spheres: usize) -> Vec<(u32, u32)> {
    let (mut ends, mut sorted) = (Vec::new(), Vec::new());
    let first = (|pair: &(u32, u32)| pair.0, spheres);
    counting_sort(pairs.iter().copied(), first, &mut ends, &mut sorted);
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
            sphere_pairs(&position, &[true; 3], &[1e-3, 1e-3, 1.0], &Pool::default()),
            [(0, 1)]
        );
    }

    /// One of `every` so many spheres.
    fn chosen(every: usize, position: &[Vec3]) -> Vec<u32> {
        (0..position.len() as u32).step_by(every).collect()
    }

    /// Those of `pairs` that have one of them.
    fn theirs(every: usize, pairs: &[(u32, u32)]) -> Vec<(u32, u32)> {
        let is_chosen = |i: u32| (i as usize).is_multiple_of(every);
        let own = pairs.iter().filter(|(i, j)| is_chosen(*i) || is_chosen(*j));
        own.copied().collect()
    }

    proptest! {
        /// Sizes over three decades: several levels.
        #[test]
        fn the_grid_finds_what_all_pairs_find(
            spheres in prop::collection::vec((prop::array::uniform3(-3.0..3.0f64), -5.0..1.0f64), 0..200),
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
            prop_assert_eq!(&sphere_pairs(&position, &present, &size, &Pool::default()), &expected);
            // Of some of the spheres, few or many.
            for every in [3, 12, 30, 40, 55] {
                prop_assert_eq!(pairs_of(&chosen(every, &position), &position, &present, &size, &Pool::default()), theirs(every, &expected));
            }
        }

        /// Far apart, so that the cells of the box around them are more than there may be.
        #[test]
        fn scattered_cells_find_what_all_pairs_find(
            spheres in prop::collection::vec((prop::array::uniform3(-9.0..9.0f64), -1.0..2.5f64), 0..300),
            far in 1.0..1e7_f64,
        ) {
            let place = |(k, (p, _)): (usize, &([f64; 3], f64))| Vec3::from(*p) * if k % 50 == 7 { far } else { 1.0 };
            let position: Vec<Vec3> = spheres.iter().enumerate().map(place).collect();
            let size: Vec<f64> = spheres.iter().map(|(_, s)| 0.05 * s.exp()).collect();
            let mut expected = Vec::new();
            for i in 0..position.len() {
                for j in i + 1..position.len() {
                    if (position[i] - position[j]).norm() < size[i] + size[j] {
                        expected.push((i as u32, j as u32));
                    }
                }
            }
            let present = vec![true; position.len()];
            prop_assert_eq!(&sphere_pairs(&position, &present, &size, &Pool::default()), &expected);
            for every in [3, 12, 30, 40, 55] {
                prop_assert_eq!(pairs_of(&chosen(every, &position), &position, &present, &size, &Pool::default()), theirs(every, &expected));
            }
        }
    }
}
