//! A random packing in two stages, both deterministic.
//!
//! 1. *Drop*, largest sphere first: of some random places in the free space a sphere takes the first without
//!    overlap (random sequential addition, which ends near a solid fraction of 0.3), else that of least overlap.
//! 2. *Relax*: overlapping pairs move apart along the line of their centres until `|c_i - c_j| >= R_i + R_j` for all
//!    of them, exactly. A sphere that is pushed out of the free space is pushed back, or put back. A sphere moves at most half of
//!    its radius in a sweep, so that it passes through no boundary.
//!
//! Overlap removal after W. S. Jodrey and E. M. Tory, *Computer simulation of close random packing of equal spheres*,
//! Physical Review A 32 (1985) 2347, with all pairs of a sweep in turn instead of the worst one.

use rand_chacha::ChaCha8Rng;

use super::free_space::FreeSpace;
use crate::Vec3;
use crate::detection::grid::sphere_pairs;
use crate::geometry::ClosestPoint;
use crate::parallel::Pool;

/// Places tried before a sphere takes the least bad one.
const TRIES: usize = 30;
/// Random places tried to find one that is clear of the boundaries.
const POINTS: usize = 20_000;
/// Pairs are moved to this relative distance, so that the last overlaps end after few sweeps \[-\].
const MARGIN: f64 = 1e-3;
/// Most cells of the search over the number of spheres and one; a cube has no more.
const MOST_CELLS: f64 = 8.0;
/// Distance by which a pair is moved apart over its overlap: more than 1 halves the sweeps.
const PUSH: f64 = 1.4;
/// Longest displacement of a sphere in a sweep over its radius: none passes through a boundary.
const LONGEST: f64 = 0.5;
/// Skin of the list of pairs over the smallest radius.
const SKIN: f64 = 0.3;
/// Most sweeps for all spheres.
const SWEEPS: usize = 3000;
/// Sweeps after each thinning of a packing that was too dense.
const MORE_SWEEPS: usize = 60;
/// Sweeps after which at least a tenth fewer pairs must overlap, unless they are few.
const STALL: usize = 150;
/// Overlapping pairs that are few.
const FEW: usize = 200;
/// Share of the spheres taken out by a thinning.
const THINNING: f64 = 0.03;

/// Why a packing fails.
#[derive(Debug)]
pub(super) enum Jam {
    /// The free space admits no sphere of this radius \[m\], or so few that random points miss them.
    NoPlace { radius: f64 },
    /// These spheres found places together.
    Full { packed: Vec<usize> },
}

/// Spheres of a packing that is not finished.
pub(super) struct Bed {
    /// Centres \[m\], the fixed ones last.
    centre: Vec<Vec3>,
    /// Radii \[m\].
    radius: Vec<f64>,
    /// Which sphere of the task each movable one is.
    sphere: Vec<usize>,
}

impl Bed {
    /// Random places for spheres of these radii \[m\] between fixed ones (centre and radius \[m\]).
    pub(super) fn drop(
        room: &FreeSpace<'_>,
        radii: &[f64],
        fixed: &[(Vec3, f64)],
        random: &mut ChaCha8Rng,
    ) -> Result<Self, Jam> {
        let mut order: Vec<usize> = (0..radii.len()).collect();
        order.sort_by(|&i, &j| radii[j].total_cmp(&radii[i]).then(i.cmp(&j)));
        let largest = fixed.iter().map(|f| f.1).chain(radii.iter().copied());
        let largest = largest.fold(0.0, f64::max);
        let mut grid = Grid::new(room.low, room.high, largest, radii.len() + fixed.len());
        for &(centre, radius) in fixed {
            grid.insert(centre, radius);
        }
        let mut centre = vec![Vec3::zeros(); radii.len()];
        let mut scratch = Vec::new();
        for k in order {
            let radius = radii[k];
            let place = drop_one(room, &grid, radius, random, &mut scratch);
            centre[k] = place.ok_or(Jam::NoPlace { radius })?;
            grid.insert(centre[k], radius);
        }
        centre.extend(fixed.iter().map(|f| f.0));
        Ok(Self {
            centre,
            radius: radii
                .iter()
                .copied()
                .chain(fixed.iter().map(|f| f.1))
                .collect(),
            sphere: (0..radii.len()).collect(),
        })
    }

    /// Centres \[m\] without overlap, in the order of the task.
    pub(super) fn relax(mut self, room: &FreeSpace<'_>) -> Result<Vec<Vec3>, Jam> {
        if self.settle(room, SWEEPS) {
            self.centre.truncate(self.sphere.len());
            return Ok(self.centre);
        }
        while !self.sphere.is_empty() {
            self.thin();
            if self.settle(room, MORE_SWEEPS) {
                break;
            }
        }
        Err(Jam::Full {
            packed: self.sphere,
        })
    }

    /// Whether at most `sweeps` sweeps end all overlaps.
    fn settle(&mut self, room: &FreeSpace<'_>, sweeps: usize) -> bool {
        let smallest = self.radius.iter().copied().fold(f64::INFINITY, f64::min);
        let skin = SKIN * smallest;
        let number = self.sphere.len();
        let mut pairs = Vec::new();
        let mut at_border = vec![false; number];
        let mut built: Vec<Vec3> = Vec::new();
        let mut scratch = Vec::new();
        let mut last = usize::MAX;
        for sweep in 0..sweeps {
            let steps = built.iter().zip(&self.centre);
            let moved = steps.map(|(a, b)| (a - b).norm_squared());
            let moved = moved.fold(0.0, f64::max).sqrt();
            if built.is_empty() || 2.0 * moved > skin {
                pairs = self.pairs(skin);
                pairs.retain(|&(i, _)| (i as usize) < number);
                for (k, border) in at_border.iter_mut().enumerate() {
                    *border = room.borders(self.centre[k], self.radius[k], skin, &mut scratch);
                }
                built.clone_from(&self.centre);
            }
            let before = self.centre[..number].to_vec();
            let n = self.separate(&pairs);
            if sweep % STALL == 0 {
                if n > FEW && n as f64 > 0.9 * last as f64 {
                    return false;
                }
                last = n;
            }
            if n == 0 {
                self.centre[..number].copy_from_slice(&before);
                if self.is_free(&pairs) {
                    return true;
                }
                self.separate(&pairs);
            }
            let far = |k: usize, x: Vec3| at_border[k] || (x - built[k]).norm() >= skin;
            self.confine(room, &before, far, &mut scratch);
        }
        false
    }

    /// Pairs with a gap below `skin` \[m\].
    fn pairs(&self, skin: f64) -> Vec<(u32, u32)> {
        let all = vec![true; self.centre.len()];
        let sizes: Vec<f64> = self.radius.iter().map(|r| r + 0.5 * skin).collect();
        sphere_pairs(&self.centre, &all, &sizes, &Pool::default())
    }

    /// Moves overlapping pairs apart, one after the other; returns how many overlapped.
    fn separate(&mut self, pairs: &[(u32, u32)]) -> usize {
        let number = self.sphere.len();
        let mut overlapping = 0;
        for &(i, j) in pairs {
            let (i, j) = (i as usize, j as usize);
            let touching = self.radius[i] + self.radius[j];
            let target = touching * (1.0 + MARGIN);
            let arm = self.centre[i] - self.centre[j];
            let square = arm.norm_squared();
            if square >= target * target {
                continue;
            }
            let distance = square.sqrt();
            overlapping += usize::from(distance < touching);
            // Two in one place part in a direction of their own.
            let normal = if distance > 0.0 {
                arm / distance
            } else {
                direction(i)
            };
            let share = if j < number {
                self.radius[j] / touching
            } else {
                1.0
            };
            let push = PUSH * (target - distance);
            self.centre[i] += normal * (share * push);
            if j < number {
                self.centre[j] -= normal * ((1.0 - share) * push);
            }
        }
        overlapping
    }

    /// Whether no pair overlaps.
    fn is_free(&self, pairs: &[(u32, u32)]) -> bool {
        pairs.iter().all(|&(i, j)| {
            let (i, j) = (i as usize, j as usize);
            (self.centre[i] - self.centre[j]).norm() >= self.radius[i] + self.radius[j]
        })
    }

    /// Shortens long moves and keeps the spheres in the free space; `may_leave` says whose new place is to be checked.
    fn confine(
        &mut self,
        room: &FreeSpace<'_>,
        before: &[Vec3],
        may_leave: impl Fn(usize, Vec3) -> bool,
        scratch: &mut Vec<ClosestPoint>,
    ) {
        for (k, &from) in before.iter().enumerate() {
            let (centre, radius) = (&mut self.centre[k], self.radius[k]);
            let step = *centre - from;
            let length = step.norm();
            if length > LONGEST * radius {
                *centre = from + step * (LONGEST * radius / length);
            }
            if length > 0.0 && may_leave(k, *centre) {
                *centre = room.nearest(*centre, radius, scratch).unwrap_or(from);
            }
        }
    }

    /// Takes out those that overlap most.
    fn thin(&mut self) {
        let number = self.sphere.len();
        let mut depth = vec![0.0; number];
        for (i, j) in self.pairs(0.0) {
            let (i, j) = (i as usize, j as usize);
            let arm = self.centre[i] - self.centre[j];
            let overlap = self.radius[i] + self.radius[j] - arm.norm();
            for k in [i, j].into_iter().filter(|&k| k < number) {
                depth[k] += overlap / self.radius[k];
            }
        }
        let mut order: Vec<usize> = (0..number).collect();
        order.sort_by(|&i, &j| depth[j].total_cmp(&depth[i]).then(i.cmp(&j)));
        let mut kept = vec![true; self.centre.len()];
        for &k in &order[..(THINNING * number as f64).ceil() as usize] {
            kept[k] = false;
        }
        let mut flags = kept.iter();
        self.sphere.retain(|_| flags.next().is_some_and(|k| *k));
        let mut flags = kept.iter();
        self.centre.retain(|_| flags.next().is_some_and(|k| *k));
        let mut flags = kept.iter();
        self.radius.retain(|_| flags.next().is_some_and(|k| *k));
    }
}

/// The best of some random places.
fn drop_one(
    room: &FreeSpace<'_>,
    grid: &Grid,
    radius: f64,
    random: &mut ChaCha8Rng,
    scratch: &mut Vec<ClosestPoint>,
) -> Option<Vec3> {
    let mut best: Option<(f64, Vec3)> = None;
    let mut tries = 0;
    for _ in 0..POINTS {
        let place = room.random_centre(radius, random, scratch)?;
        if !room.is_clear(place, radius, scratch) {
            continue;
        }
        let limit = best.map_or(f64::INFINITY, |(overlap, _)| overlap);
        if let Some(overlap) = grid.overlap(place, radius, limit) {
            if overlap <= 0.0 {
                return Some(place);
            }
            best = Some((overlap, place));
        }
        tries += 1;
        if tries == TRIES {
            break;
        }
    }
    best.map(|(_, place)| place)
}

/// A direction that differs from sphere to sphere.
fn direction(k: usize) -> Vec3 {
    let [x, y, z] = [7, 11, 13].map(|n| (k % n) as f64 + 0.5 - 0.5 * n as f64);
    Vec3::new(x, y, z + 0.25).normalize()
}

/// Spheres by the cell of their centre.
struct Grid {
    low: Vec3,
    cell: f64,
    counts: [usize; 3],
    /// First sphere of each cell, and the next one of the same cell after each sphere.
    first: Vec<u32>,
    next: Vec<u32>,
    spheres: Vec<(Vec3, f64)>,
}

impl Grid {
    const NONE: u32 = u32::MAX;

    fn new(low: Vec3, high: Vec3, largest: f64, number: usize) -> Self {
        let side = high - low;
        // No more cells than a few per sphere, however small the spheres are in the region.
        let coarse = (side.product() / (number as f64 + 1.0)).cbrt();
        let mut cell = (2.0 * largest).max(coarse).max(1e-6 * side.amax());
        let along = |cell: f64| [0, 1, 2].map(|k| (side[k] / cell) as usize + 1);
        let cells = |cell: f64| along(cell).iter().map(|n| *n as f64).product::<f64>();
        // The cubic root of a flat or slender region is far smaller than its sides.
        while cells(cell) > MOST_CELLS * (number as f64 + 1.0) {
            cell *= 2.0;
        }
        let counts = along(cell);
        Self {
            low,
            cell,
            counts,
            first: vec![Self::NONE; counts.iter().product()],
            next: Vec::with_capacity(number),
            spheres: Vec::with_capacity(number),
        }
    }

    /// Cell along an axis; what lies outside belongs to the cells at the border.
    fn index(&self, x: f64, axis: usize) -> usize {
        (((x - self.low[axis]) / self.cell).max(0.0) as usize).min(self.counts[axis] - 1)
    }

    fn insert(&mut self, centre: Vec3, radius: f64) {
        let [x, y, z] = [0, 1, 2].map(|k| self.index(centre[k], k));
        let cell = (z * self.counts[1] + y) * self.counts[0] + x;
        self.next.push(self.first[cell]);
        self.first[cell] = self.spheres.len() as u32;
        self.spheres.push((centre, radius));
    }

    /// Largest overlap \[m\] with a sphere of the grid, 0 if there is none; `None` where it is not below `limit`.
    fn overlap(&self, centre: Vec3, radius: f64, limit: f64) -> Option<f64> {
        let around = [0, 1, 2].map(|k| {
            let reach = self.cell;
            self.index(centre[k] - reach, k)..=self.index(centre[k] + reach, k)
        });
        let mut worst = 0.0;
        for z in around[2].clone() {
            for y in around[1].clone() {
                for x in around[0].clone() {
                    let mut k = self.first[(z * self.counts[1] + y) * self.counts[0] + x];
                    while k != Self::NONE {
                        let (other, size) = self.spheres[k as usize];
                        let reach = radius + size;
                        let square = (centre - other).norm_squared();
                        if square < reach * reach {
                            worst = f64::max(worst, reach - square.sqrt());
                            if worst >= limit {
                                return None;
                            }
                        }
                        k = self.next[k as usize];
                    }
                }
            }
        }
        Some(worst)
    }
}
