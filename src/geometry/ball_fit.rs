//! Balls whose union stands for a solid.
//!
//! The balls begin inscribed: the centre `c` lies inside, the radius is the distance of `c` from the surface. Of `N` such balls those are
//! sought that bring the surface of the union nearest to that of the solid,
//!
//! ```text
//! sum_j min_k ( |p_j - c_k| - r_k )^2 -> min        p_j spread evenly over the surface of the solid
//! ```
//!
//! 1. Candidates are the points of a grid inside the solid: inscribed balls of all points, of which some are those of its medial axis.
//! 2. Greedy: one after another that candidate which lowers the sum most.
//! 3. Each centre moves downhill by itself, in steps that shrink from the width of the grid to a hundredth of it; then each ball in turn
//!    is taken away and put where the sum is lowest without it, if that is better.
//! 4. All radii grow by the same length until the union has the volume of the solid: packings of it are as dense as those of the solid,
//!    whose edges stick out of it as far as its balls bulge out of the faces.
//!
//! Inscribed balls about grid points, chosen greedily: X. Garcia, L. T. Akanji, M. J. Blunt, S. K. Matthai, J. P. Latham,
//! *Numerical study of the effects of particle shape and polydispersity on permeability*, Physical Review E 80 (2009), and
//! X. Garcia, J.-P. Latham, J. Xiang, J. P. Harrison, *A clustered overlapping sphere algorithm to represent real particles in
//! discrete element modelling*, Géotechnique 59 (2009). Judged by the surface instead of the volume, as by J.-F. Ferellec,
//! G. R. McDowell, *A simple method to create complex particle shapes for DEM*, Geomechanics and Geoengineering 3 (2008).

use std::f64::consts::PI;

use super::moments::Moments;
use super::solid::Solid;
use crate::Vec3;

/// Points on the surface.
const POINTS: usize = 1000;
/// Points of the grid inside the solid, about.
const CANDIDATES: f64 = 3000.0;
/// Most points of the grid, inside or outside, and how much wider a grid of more becomes \[-\].
const MOST: f64 = 400_000.0;
const COARSER: f64 = 1.2;
/// Smallest radius over the largest: smaller balls would cost short steps and stand for little.
const SMALLEST: f64 = 0.1;
/// Smallest step of a centre over the width of the grid.
const FINEST: f64 = 0.01;
/// Rounds of moves and exchanges, and what a round has to gain \[-\].
const ROUNDS: usize = 8;
const GAIN: f64 = 1e-3;
/// What a move has to gain \[-\].
const LEAST: f64 = 1e-6;

/// Balls that stand for a solid.
#[derive(Debug, Clone, PartialEq)]
pub struct BallFit {
    /// Centres \[m\], `[N]`.
    pub centres: Vec<Vec3>,
    /// Radii \[m\], `[N]`.
    pub radii: Vec<f64>,
    /// By how much they exceed those of inscribed balls \[m\].
    pub grown: f64,
    /// Moments of their union.
    pub union: Moments,
    /// Distance of the surface of the solid from that of the nearest ball \[m\], root mean square.
    pub mean: f64,
    /// The largest of a thousand points \[m\].
    pub largest: f64,
}

/// Most secants to the volume of the solid, and what it may be off by \[-\].
const SECANTS: usize = 8;
const SAME: f64 = 1e-4;

/// A ball.
#[derive(Debug, Clone, Copy)]
struct Ball {
    centre: Vec3,
    radius: f64,
}

impl Ball {
    fn distance(&self, x: &Vec3) -> f64 {
        (x - self.centre).norm() - self.radius
    }

    fn lies_in(&self, other: &Self) -> bool {
        (self.centre - other.centre).norm() + self.radius <= other.radius
    }
}

/// The search for one solid.
struct Search<'a> {
    solid: &'a Solid,
    points: Vec<Vec3>,
    candidates: Vec<Ball>,
    /// Width of the grid \[m\].
    width: f64,
    smallest: f64,
}

impl BallFit {
    /// At most `count` balls for `solid`: fewer where more would not bring their surface nearer to its own, `None` for a solid so thin that
    /// none of the grid's points is inside.
    #[must_use]
    pub fn new(solid: &Solid, count: usize) -> Option<Self> {
        let search = Search::new(solid)?;
        let mut balls = Vec::with_capacity(count);
        search.extend(&mut balls, count);
        let mut sum = search.sum(&balls);
        for _ in 0..ROUNDS {
            search.settle(&mut balls);
            search.exchange(&mut balls);
            for k in (0..balls.len()).rev() {
                let others = balls.iter().enumerate().filter(|(j, _)| *j != k);
                if others.map(|(_, other)| other).any(|b| balls[k].lies_in(b)) {
                    balls.remove(k);
                }
            }
            search.extend(&mut balls, count);
            let now = search.sum(&balls);
            if now > (1.0 - GAIN) * sum {
                break;
            }
            sum = now;
        }
        if balls.is_empty() {
            return None;
        }
        let (grown, union) = grow(&mut balls, solid.volume());
        let distances = search.distances(&balls);
        Some(Self {
            centres: balls.iter().map(|ball| ball.centre).collect(),
            radii: balls.iter().map(|ball| ball.radius).collect(),
            grown,
            union,
            mean: (search.sum(&balls) / POINTS as f64).sqrt(),
            largest: distances.into_iter().map(f64::abs).fold(0.0, f64::max),
        })
    }
}

/// Grows all radii by one length until the union has this `volume` \[m^3\]: the length \[m\] and the moments of the union. By secants.
fn grow(balls: &mut [Ball], volume: f64) -> (f64, Moments) {
    let centres: Vec<Vec3> = balls.iter().map(|ball| ball.centre).collect();
    let radii: Vec<f64> = balls.iter().map(|ball| ball.radius).collect();
    let union = |grown: f64| {
        let radii: Vec<f64> = radii.iter().map(|radius| radius + grown).collect();
        Moments::of_many_balls(&centres, &radii)
    };
    let (mut grown, mut found) = (0.0, union(0.0));
    // What the surface of a ball of the same volume gains.
    let mut slope = 3.0 * volume / libm::cbrt(volume / (4.0 / 3.0 * PI));
    for _ in 0..SECANTS {
        if (found.volume / volume - 1.0).abs() < SAME {
            break;
        }
        let by = (volume - found.volume) / slope;
        let next = union(grown + by);
        slope = (next.volume - found.volume) / by;
        (grown, found) = (grown + by, next);
    }
    balls.iter_mut().for_each(|ball| ball.radius += grown);
    (grown, found)
}

impl<'a> Search<'a> {
    /// `None` for a solid that has no volume, or none that is a number.
    fn new(solid: &'a Solid) -> Option<Self> {
        let (low, high) = solid.bounds();
        let size = high - low;
        let mut width = libm::cbrt(solid.volume() / CANDIDATES);
        if !(width > 0.0 && width.is_finite()) {
            return None;
        }
        // Whole cells along each edge, centred in the box: a plate has its middle plane among them.
        let cells = |width: f64| size.map(|side| (side / width).ceil().max(1.0));
        while cells(width).product() > MOST {
            width *= COARSER;
        }
        let counts = cells(width);
        let cell = size.component_div(&counts);
        let [nx, ny, nz] = <[f64; 3]>::from(counts).map(|count| count as usize);
        let places = (0..nx * ny * nz).map(|k| {
            let index = Vec3::new((k % nx) as f64, (k / nx % ny) as f64, (k / nx / ny) as f64);
            low + index.add_scalar(0.5).component_mul(&cell)
        });
        let mut candidates: Vec<Ball> = places
            .filter(|place| solid.contains(*place))
            .map(|centre| Ball {
                centre,
                radius: solid.distance(centre),
            })
            .collect();
        let largest = candidates
            .iter()
            .map(|ball| ball.radius)
            .fold(0.0, f64::max);
        candidates.retain(|ball| ball.radius >= SMALLEST * largest);
        Some(Self {
            solid,
            points: solid.surface_points(POINTS),
            candidates,
            width,
            smallest: SMALLEST * largest,
        })
    }

    /// The inscribed ball about a point, if it is large enough.
    fn inscribed(&self, centre: Vec3) -> Option<Ball> {
        let radius = self.solid.distance(centre);
        let large = radius >= self.smallest && self.solid.contains(centre);
        large.then_some(Ball { centre, radius })
    }

    /// Distances of the points from the nearest of these balls \[m\].
    fn distances<'b>(&self, balls: impl IntoIterator<Item = &'b Ball>) -> Vec<f64> {
        let mut least = vec![f64::INFINITY; self.points.len()];
        for ball in balls {
            for (own, x) in least.iter_mut().zip(&self.points) {
                *own = own.min(ball.distance(x));
            }
        }
        least
    }

    fn sum(&self, balls: &[Ball]) -> f64 {
        self.distances(balls).iter().map(|d| d * d).sum()
    }

    /// The sum with one ball more than those that leave these distances, or infinity as soon as it exceeds `bound`.
    fn with(&self, distances: &[f64], ball: &Ball, bound: f64) -> f64 {
        let mut sum = 0.0;
        for (distances, points) in distances.chunks(50).zip(self.points.chunks(50)) {
            let pairs = distances.iter().zip(points);
            sum += pairs
                .map(|(own, x)| own.min(ball.distance(x)).powi(2))
                .sum::<f64>();
            if sum > bound {
                return f64::INFINITY;
            }
        }
        sum
    }

    /// The best candidate beside the balls that leave these distances, if the sum falls below `bound` by it.
    fn best(&self, distances: &[f64], bound: f64) -> Option<(Ball, f64)> {
        let mut best = None;
        let mut least = bound;
        for ball in &self.candidates {
            let sum = self.with(distances, ball, least);
            if sum < least {
                (best, least) = (Some(*ball), sum);
            }
        }
        best.map(|ball| (ball, least))
    }

    /// Adds candidates, one after another, up to `count` balls.
    fn extend(&self, balls: &mut Vec<Ball>, count: usize) {
        while balls.len() < count {
            let distances = self.distances(&*balls);
            let now = distances.iter().map(|d| d * d).sum();
            match self.best(&distances, now) {
                Some((ball, _)) => balls.push(ball),
                None => return,
            }
        }
    }

    fn others(&self, balls: &[Ball], k: usize) -> Vec<f64> {
        let others = balls.iter().enumerate().filter(|(j, _)| *j != k);
        self.distances(others.map(|(_, ball)| ball))
    }

    /// Moves each centre downhill along the axes.
    fn settle(&self, balls: &mut [Ball]) {
        let mut step = self.width;
        while step > FINEST * self.width {
            let mut moved = false;
            for k in 0..balls.len() {
                let others = self.others(balls, k);
                let mut sum = self.with(&others, &balls[k], f64::INFINITY);
                for axis in 0..6 {
                    let mut centre = balls[k].centre;
                    centre[axis / 2] += if axis % 2 == 0 { step } else { -step };
                    let Some(ball) = self.inscribed(centre) else {
                        continue;
                    };
                    let new = self.with(&others, &ball, sum);
                    if new < (1.0 - LEAST) * sum {
                        (balls[k], sum) = (ball, new);
                        moved = true;
                    }
                }
            }
            if !moved {
                step *= 0.5;
            }
        }
    }

    /// Puts each ball in turn where the sum is lowest without it.
    fn exchange(&self, balls: &mut [Ball]) {
        for k in 0..balls.len() {
            let others = self.others(balls, k);
            let now = self.with(&others, &balls[k], f64::INFINITY);
            if let Some((ball, _)) = self.best(&others, (1.0 - GAIN) * now) {
                balls[k] = ball;
            }
        }
    }
}
