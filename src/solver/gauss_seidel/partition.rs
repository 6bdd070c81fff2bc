//! Where bodies lie in a kernel: in layers of cells along the longest side of the scene, and cut into parts of whole layers.
//!
//! Contacts inside a part touch no other part, those between parts `k` and `k + 1` only these two: all parts are swept side by
//! side, then every second border, then the others. What lies in which part depends on the positions alone, so that results
//! are the same for any number of threads.

use std::ops::Range;

use crate::Vec3;
use crate::parallel::Pool;
use crate::sorting::first_places;
use crate::spatial::extent::{around, joined};

/// Below this many spheres there is one part, in the order of the scene: a sweep is too short to share.
pub(crate) const SMALL: usize = 2 * PART;
/// Spheres of a part at least, on the average.
const PART: usize = 640;
/// Most parts.
pub(super) const PARTS: usize = 32;
/// Most cells over the number of spheres.
const CELLS_PER_SPHERE: usize = 4;
/// A body that is in no sphere's place.
const NO_SEAT: u32 = u32::MAX;
/// Cells along an axis at most.
const CELLS: f64 = 512.0;

/// The order of the bodies.
#[derive(Debug, Clone, Default)]
pub(crate) struct Partition {
    now: Order,
    /// The order before, for its memory and to be compared with.
    before: Order,
    /// Sphere at each place, `[N]`; empty where all are in the order of the scene.
    sphere: Vec<u32>,
    /// Cell of each sphere, `[N]`.
    cell: Vec<u32>,
    /// First place of each cell.
    first: Vec<u32>,
}

/// Where bodies are.
#[derive(Debug, Clone, PartialEq, Default)]
struct Order {
    /// Place of each sphere, and its part, `[N]`; empty where all are in the order of the scene.
    place: Vec<u32>,
    part: Vec<u8>,
    /// First place of each part, and the end of the last.
    starts: Vec<u32>,
    /// Of each body behind the spheres the sphere in whose place it is, `[M]`; [`NO_SEAT`] where it has its own behind all parts.
    seats: Vec<u32>,
}

impl Order {
    fn clear(&mut self) {
        self.place.clear();
        self.part.clear();
        self.starts.clear();
        self.seats.clear();
    }
}

impl Partition {
    /// Lays out spheres of the given centres \[m\], `[N]`, with cells of `edge` \[m\], and the bodies behind them, `[M]`: in the place of
    /// a sphere that does not move by itself, or behind all parts. Returns whether that is another order than before.
    pub(crate) fn arrange(
        &mut self,
        (centres, edge): (&[Vec3], f64),
        seats: impl Iterator<Item = Option<usize>>,
        pool: &Pool,
    ) -> bool {
        std::mem::swap(&mut self.now, &mut self.before);
        self.forget();
        let n = centres.len();
        if n >= SMALL {
            self.lay_out(centres, edge, pool);
            let seat = |sphere: Option<usize>| sphere.map_or(NO_SEAT, |i| i as u32);
            self.now.seats.extend(seats.map(seat));
        }
        self.now != self.before
    }

    /// Puts the spheres into places and parts.
    fn lay_out(&mut self, centres: &[Vec3], edge: f64, pool: &Pool) {
        let n = centres.len();
        let piece = |_, range: Range<usize>| around(centres[range].iter().copied());
        let (low, high) = pool.pieces(0..n, piece, joined);
        let size = high - low;
        let edge = edge.max(size.max() / CELLS);
        let axes = {
            let long = size.imax();
            [long, (long + 1) % 3, (long + 2) % 3]
        };
        // No more cells than spheres but for a few: on a wide scene of small spheres they grow.
        let cells = |edge: f64| axes.map(|axis| (size[axis] / edge) as usize + 1);
        let mut edge = edge;
        while cells(edge).iter().product::<usize>() > CELLS_PER_SPHERE * n {
            edge *= 1.25;
        }
        let counts = cells(edge);
        let index = |x: &Vec3, k: usize| {
            let along = ((x[axes[k]] - low[axes[k]]) / edge) as usize;
            along.min(counts[k] - 1)
        };
        let layer = counts[1] * counts[2];
        self.cell.resize(n, 0);
        pool.fill(&mut self.cell[..], |i| {
            let [x, y, z] = [0, 1, 2].map(|k| index(&centres[i], k));
            ((x * counts[1] + y) * counts[2] + z) as u32
        });
        let cells = counts[0] * layer;
        first_places(self.cell.iter().copied(), cells, &mut self.first);
        // Parts end where a layer does, as near to equal shares as can be: of a power of two, so that threads have equal shares too.
        let share = n as f64 / f64::from(1 << (n / PART).clamp(1, PARTS).ilog2());
        let starts = &mut self.now.starts;
        starts.push(0);
        for k in 0..counts[0] {
            let [start, end] = [k, k + 1].map(|k| self.first[k * layer]);
            let middle = 0.5 * (f64::from(start) + f64::from(end));
            if starts.len() as f64 * share <= middle && start > starts[starts.len() - 1] {
                starts.push(start);
            }
        }
        starts.push(n as u32);
        self.sphere.resize(n, 0);
        for (i, &cell) in self.cell.iter().enumerate() {
            let next = &mut self.first[cell as usize];
            let part = starts.partition_point(|start| start <= next) - 1;
            self.now.place.push(*next);
            self.now.part.push(part as u8);
            self.sphere[*next as usize] = i as u32;
            *next += 1;
        }
    }

    fn forget(&mut self) {
        self.now.clear();
        self.sphere.clear();
    }

    /// Forgets an order of another number of spheres.
    pub(super) fn fit(&mut self, spheres: usize) {
        if self.now.place.len() != spheres {
            self.forget();
        }
    }

    /// How many parts there are.
    pub(super) fn parts(&self) -> usize {
        self.now.starts.len().saturating_sub(1).max(1)
    }

    /// Spheres of part `k` of `n` in all.
    pub(super) fn part(&self, k: usize, n: usize) -> std::ops::Range<usize> {
        match self.now.starts.get(k..k + 2) {
            Some(&[start, end]) => start as usize..end as usize,
            _ => 0..n,
        }
    }

    /// Sphere at `place`.
    pub(super) fn sphere(&self, place: usize) -> usize {
        self.sphere.get(place).map_or(place, |&i| i as usize)
    }

    /// Place of body `i` behind `spheres` spheres or among them, and its part; `None` behind all parts.
    pub(super) fn seat(&self, i: usize, spheres: usize) -> Option<(usize, usize)> {
        match i.checked_sub(spheres) {
            None => Some(self.place(i)),
            Some(own) => match self.now.seats.get(own) {
                None | Some(&NO_SEAT) => None,
                Some(&sphere) => Some(self.place(sphere as usize)),
            },
        }
    }

    /// Place of sphere `i`, and its part.
    pub(super) fn place(&self, i: usize) -> (usize, usize) {
        match self.now.place.get(i) {
            None => (i, 0),
            Some(&place) => (place as usize, usize::from(self.now.part[i])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_an_order_in_whole_layers() {
        let side = 24;
        let centres: Vec<Vec3> = (0..side * side * side)
            .map(|i| {
                let [x, y, z] = [i % side, i / side % side, i / side / side].map(|k| k as f64);
                Vec3::new(z + 0.1 * (i % 7) as f64, y, 1.5 * x)
            })
            .collect();
        let (mut layout, pool) = (Partition::default(), Pool::default());
        let seats = [None, Some(77)];
        assert!(layout.arrange((&centres, 1.0), seats.into_iter(), &pool));
        let n = centres.len();
        let mut seen = vec![false; n];
        for i in 0..n {
            let (place, part) = layout.place(i);
            assert!(layout.part(part, n).contains(&place));
            assert!(!std::mem::replace(&mut seen[place], true));
            assert_eq!(layout.sphere(place), i);
        }
        // 24 layers of 576 spheres, and 16 parts.
        assert_eq!(layout.parts(), 16);
        let sizes = (0..16).map(|k| layout.part(k, n).len());
        assert_eq!([sizes.clone().min(), sizes.max()], [Some(576), Some(1152)]);
        assert_eq!(
            [3, n, n + 1].map(|i| layout.seat(i, n)),
            [Some(layout.place(3)), None, Some(layout.place(77))]
        );
        for (i, x) in centres.iter().enumerate() {
            for (j, y) in centres.iter().enumerate().skip(i).take(700) {
                let parts = [layout.place(i).1, layout.place(j).1];
                assert!((x - y).norm() > 1.6 || parts[0].abs_diff(parts[1]) <= 1);
            }
        }
        assert!(!layout.arrange((&centres, 1.0), seats.into_iter(), &pool));
        assert!(layout.arrange((&centres, 1.0), [None, Some(78)].into_iter(), &pool));
        let swapped: Vec<Vec3> = centres.iter().rev().copied().collect();
        assert!(layout.arrange((&swapped, 1.0), seats.into_iter(), &pool));
        assert!(layout.arrange((&centres[..100], 1.0), seats.into_iter(), &pool));
        assert_eq!(layout.seat(101, 100), None);
        assert_eq!((layout.parts(), layout.place(7)), (1, (7, 0)));
        assert_eq!(layout.sphere(7), 7);
    }
}
