//! How far bodies that sleep are from what moves.
//!
//! Space is divided into cells no smaller than the largest body. What moves is in ring 0, and the cells that touch those of ring `r`
//! and are in no ring before are ring `r + 1`: bodies that touch are at most one ring apart. Cells repeat after some count along
//! each axis, so that few are enough however far the bodies are apart: one more ring than needed is no error.

use crate::Vec3;
use crate::spatial::extent::{corners, joined};

/// The ring of cells beyond all.
pub(super) const BEYOND: u8 = u8::MAX;
/// Most cells for each sphere, and the fewest that are.
const CELLS: usize = 8;
const FEWEST: usize = 4096;

/// A box of cells, the last ones included.
type Cells = [[i64; 3]; 2];

/// The cells about what moves.
#[derive(Debug, Default)]
pub(crate) struct Zone {
    /// One over the edge of a cell \[1/m\].
    per_edge: f64,
    /// After how many cells they repeat along each axis: powers of two.
    counts: [i64; 3],
    /// Ring of every cell.
    ring: Vec<u8>,
    /// Cells of the last ring.
    last: Vec<[i64; 3]>,
    /// How many rings there are beyond what moves.
    depth: u8,
}

impl Zone {
    /// Forgets what it was: cells of this `edge` \[m\] for so many `spheres` in a box \[m\], none in a ring.
    pub(super) fn restart(&mut self, edge: f64, (low, high): (Vec3, Vec3), spheres: usize) {
        let most = FEWEST.max(CELLS * spheres) as i64;
        let along = |axis: usize| ((high[axis] - low[axis]) / edge).min(most as f64) as i64;
        let mut counts =
            [0, 1, 2].map(|axis| (along(axis).max(4) as u64).next_power_of_two() as i64);
        while counts.iter().fold(1_i64, |all, n| all.saturating_mul(*n)) > most {
            let longest = counts.iter_mut().max();
            longest.into_iter().for_each(|count| *count /= 2);
        }
        (self.per_edge, self.counts, self.depth) = (1.0 / edge, counts, 0);
        self.last.clear();
        self.ring.clear();
        let all = counts.iter().product::<i64>();
        self.ring.resize(all as usize, BEYOND);
    }

    /// Puts the cells of a box \[m\] into ring 0.
    pub(super) fn mark(&mut self, (low, high): (Vec3, Vec3)) {
        let [low, high] = self.cells((low, high));
        let along = |k: usize| low[k]..=high[k].min(low[k] + self.counts[k] - 1);
        let [xs, ys, zs] = [0, 1, 2].map(along);
        for x in xs {
            for y in ys.clone() {
                for z in zs.clone() {
                    self.enter([x, y, z], 0);
                }
            }
        }
    }

    /// Makes so many rings more.
    pub(super) fn spread(&mut self, depth: u8) {
        for ring in 1..=depth {
            let before = std::mem::take(&mut self.last);
            for [x, y, z] in before {
                for (x, y, z) in beside(x, y, z) {
                    self.enter([x, y, z], ring);
                }
            }
        }
        self.depth = depth;
    }

    /// Ring of the cell that has `x` \[m\] in it.
    pub(super) fn ring_at(&self, x: Vec3) -> u8 {
        self.ring[self.place(self.cell(x))]
    }

    /// How many rings there are beyond what moves.
    pub(super) fn depth(&self) -> u8 {
        self.depth
    }

    /// Whether the cells of one box \[m\] are those of another or beside them.
    pub(super) fn is_beside(&self, one: (Vec3, Vec3), other: (Vec3, Vec3)) -> bool {
        let ([low, high], [from, to]) = (self.cells(one), self.cells(other));
        (0..3).all(|k| low[k] >= from[k] - 1 && high[k] <= to[k] + 1)
    }

    fn enter(&mut self, cell: [i64; 3], ring: u8) {
        let place = self.place(cell);
        let own = &mut self.ring[place];
        if *own == BEYOND {
            *own = ring;
            self.last.push(cell);
        }
    }

    fn cells(&self, (low, high): (Vec3, Vec3)) -> Cells {
        [low, high].map(|x| self.cell(x))
    }

    fn cell(&self, x: Vec3) -> [i64; 3] {
        // What is very far away is in the last of all cells.
        const FAR: f64 = 1e12;
        // Down, without a call: processors of the baseline have no instruction for `floor`.
        let along = |x: f64| {
            let x = (x * self.per_edge).clamp(-FAR, FAR);
            let towards_zero = x as i64;
            towards_zero - i64::from(x < towards_zero as f64)
        };
        [along(x.x), along(x.y), along(x.z)]
    }

    fn place(&self, cell: [i64; 3]) -> usize {
        let along = |k: usize| cell[k] & (self.counts[k] - 1);
        let [x, y, z] = [along(0), along(1), along(2)];
        ((z * self.counts[1] + y) * self.counts[0] + x) as usize
    }
}

/// A cell and the 26 around it.
fn beside(x: i64, y: i64, z: i64) -> impl Iterator<Item = (i64, i64, i64)> {
    let near = |k: i64| k - 1..=k + 1;
    near(x).flat_map(move |x| near(y).flat_map(move |y| near(z).map(move |z| (x, y, z))))
}

/// Box around the images of a box's corners.
pub(super) fn moved(bounds: (Vec3, Vec3), to: impl Fn(Vec3) -> Vec3) -> (Vec3, Vec3) {
    let images = corners(bounds).map(|x| (to(x), to(x)));
    images.into_iter().reduce(joined).unwrap_or(bounds)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    /// Of a zone about some points in a box: rings count cells, and points less than an edge apart are at most one ring apart.
    #[test]
    fn rings_count_cells_from_what_moves() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let mut point = |size: f64| Vec3::from_fn(|_, _| size * random.random_range(-1.0..1.0));
        let moving: Vec<Vec3> = (0..3).map(|_| point(1.0)).collect();
        let mut zone = Zone::default();
        for (low, high) in [(-1.0, 1.0), (-1.0, 4.0), (-1e6, 1e9)]
            .map(|(low, high)| (Vec3::repeat(low), Vec3::repeat(high)))
        {
            zone.restart(0.1, (low, high), 100);
            moving.iter().for_each(|&x| zone.mark((x, x)));
            zone.spread(5);
            assert!(zone.ring.len() <= FEWEST && zone.depth() == 5);
            for _ in 0..2000 {
                let (x, way) = (point(1.0), point(0.1 / f64::sqrt(3.0)));
                let apart = |a: [i64; 3], b: [i64; 3]| {
                    (0..3).map(|k| (a[k] - b[k]).abs()).fold(0, i64::max)
                };
                let near = moving
                    .iter()
                    .map(|&m| apart(zone.cell(x), zone.cell(m)))
                    .min();
                let rings = |x: Vec3| i64::from(zone.ring_at(x).min(6));
                let ring = rings(x);
                assert!(near.is_some_and(|near| ring <= near), "{ring} of {near:?}");
                assert!((rings(x + way) - ring).abs() <= 1);
            }
        }
    }
}
