//! Collapse of a column: how far a heap runs whose wall is taken away.
//!
//! ```text
//! (r_inf - r_0)/r_0 = 1.24 a,         a < 1.7          a = h_0/r_0
//!                   = 1.6 a^(1/2),    a > 1.7
//! ```
//!
//! Source: G. Lube, H. E. Huppert, R. S. J. Sparks, M. A. Hallworth, *Axisymmetric collapses of granular columns*, Journal of
//! Fluid Mechanics 508 (2004). `r_inf` is where the cover falls to a twentieth of a dense single layer: a slope of 20 degrees is thinner
//! than a grain over its last three, and less is grains that run on alone.

use sphere_dda::simulation::Simulation;

use super::bed::{self, Cost, Friction, GRAIN, Run};
use super::fit::{self, Line};
use crate::Watch;
use crate::error::ReportError;

/// Aspect ratio at which the law changes.
pub const CHANGE: f64 = 1.7;
/// Aspect ratios asked for, and the column's radius over the mean grain.
const COLUMNS: [(f64, f64); 6] = [
    (0.5, 11.0),
    (0.8, 10.0),
    (1.2, 9.0),
    (2.2, 7.0),
    (4.0, 6.0),
    (7.0, 5.0),
];
/// Friction of grains: those of the law's source are no spheres, and spheres without resistance to rolling never stop on a plane.
const GRAINS: Friction = Friction {
    sliding: 0.5,
    rolling: 0.05,
};
/// Friction on floor and wall: rough, so that a front of single grains does not roll off the deposit as on bearings.
const FLOOR: Friction = Friction {
    sliding: 0.5,
    rolling: 0.2,
};
/// Packings of every aspect ratio: the front of one deposit scatters by some percent.
pub(super) const PACKINGS: u64 = 2;
/// Filling, then the longest collapse \[s\].
const TIMES: [f64; 2] = [0.8, 2.0];
/// Kinetic energy \[J/kg\] at which the deposit has come to rest.
const REST: f64 = 1e-4;
/// Solid fraction of a column.
const PACKED: f64 = 0.6;
/// Cover of a dense single layer of equal spheres: that of random close discs.
const COVER: f64 = 0.82;
/// Cover at the front.
const FRONT: f64 = COVER / 20.0;

/// What is left of one column.
#[derive(Debug, Clone, PartialEq)]
pub struct Deposit {
    /// `h_0/r_0` as it stood.
    pub aspect: f64,
    /// `(r_inf - r_0)/r_0`.
    pub runout: f64,
    /// When it had come to rest \[s\].
    pub rest: f64,
}

/// Columns of one aspect ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Number of grains.
    pub grains: usize,
    /// By packing.
    pub deposits: Vec<Deposit>,
}

impl Column {
    /// Mean `h_0/r_0`.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        fit::mean(self.deposits.iter().map(|deposit| deposit.aspect))[0]
    }

    /// Mean run-out `(r_inf - r_0)/r_0` and its standard error.
    #[must_use]
    pub fn runout(&self) -> [f64; 2] {
        fit::mean(self.deposits.iter().map(|deposit| deposit.runout))
    }
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Collapse {
    /// Columns by aspect ratio.
    pub columns: Vec<Column>,
    /// Exponent and prefactor below and above [`CHANGE`].
    pub laws: [(f64, f64); 2],
}

/// What a column costs.
pub(super) const COST: Cost = Cost {
    cases: COLUMNS.len() * PACKINGS as usize,
    seconds: 1.1,
    simulated: 1.3,
};

/// Runs every column.
///
/// # Errors
/// What a run says.
pub fn run(share: f64, threads: usize, watch: &dyn Watch) -> Result<Collapse, ReportError> {
    let columns = COLUMNS.map(|(aspect, radius)| (aspect, radius * share.cbrt()));
    let deposits = bed::by_packing(threads, &columns, PACKINGS, |(aspect, radius), packing| {
        collapsed(aspect, radius, packing, watch)
    })?;
    let columns = columns.into_iter().zip(deposits);
    let columns: Vec<Column> = columns
        .map(|((aspect, radius), deposits)| Column {
            grains: count(aspect, radius),
            deposits,
        })
        .collect();
    let law = |low: bool| {
        let points = columns.iter().map(|c| (c.aspect(), c.runout()[0]));
        let points: Vec<(f64, f64)> = points.filter(|(a, _)| (*a < CHANGE) == low).collect();
        let line = Line::power(&points);
        (line.slope, line.intercept.exp())
    };
    Ok(Collapse {
        laws: [law(true), law(false)],
        columns,
    })
}

/// Grains of a column whose radius is so many of them.
fn count(aspect: f64, radius: f64) -> usize {
    (6.0 * PACKED * aspect * radius.powi(3)) as usize
}

/// The scene of a column of `radius` and `height` \[m\], with or without its wall.
fn text([radius, height]: [f64; 2], (grains, packing): (usize, u64), wall: bool) -> String {
    let region = format!(
        "{{ cylinder = {{ base = [0.0, 0.0, 0.0], radius = {radius}, height = {} }} }}",
        1.7 * height
    );
    let mut text = bed::head("Column collapse", bed::G, GRAINS, FLOOR)
        + &bed::grains(&region, grains, packing)
        + &bed::boundary(
            "floor",
            "{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] } }",
            "",
        );
    if wall {
        let faces = format!(
            "{{ cylinder = {{ base = [0.0, 0.0, -0.01], radius = {radius}, height = {} }} }}",
            1.8 * height + 0.02
        );
        text += &bed::boundary("wall", &faces, "");
    }
    text
}

fn collapsed(
    aspect: f64,
    radius: f64,
    packing: u64,
    watch: &dyn Watch,
) -> Result<Deposit, ReportError> {
    let name = format!("column of aspect {aspect}, packing {packing}");
    let run = Run::new(&name, watch, COST);
    let grains = count(aspect, radius);
    let size @ [radius, height] = [radius * GRAIN, aspect * radius * GRAIN];
    let scene = |wall| bed::scene("collapse.toml", &text(size, (grains, packing), wall));
    let mut standing = run.begin(scene(true)?)?;
    run.wait(&mut standing, TIMES[0])?;
    let mean = bed::places(&standing).map(|(x, _)| x.z).sum::<f64>() / grains as f64;
    let mut open = scene(false)?;
    open.initial = bed::at_rest(&standing);
    let mut heap = run.begin(open)?;
    // The time of a fall from the column's top: before it nothing has ended.
    let least = (2.0 * height / bed::G).sqrt() + 0.2;
    run.advance(&mut heap, TIMES[1], |heap| {
        Ok(heap.time() < least || bed::agitation(heap) > REST)
    })?;
    let deposit = Deposit {
        aspect: 2.0 * mean / radius,
        runout: front(&heap) / radius - 1.0,
        rest: heap.time(),
    };
    watch.note(&format!("{name}: runs {:.3} of its radius", deposit.runout));
    Ok(deposit)
}

/// Where the cover falls to [`FRONT`] \[m\].
fn front(heap: &Simulation) -> f64 {
    let centre = bed::places(heap).map(|(x, _)| x).sum::<sphere_dda::Vec3>()
        / bed::places(heap).count() as f64;
    let ring = GRAIN;
    let cover = |k: usize| {
        let (inner, outer) = (ring * k as f64, ring * (k + 1) as f64);
        let inside = bed::places(heap).filter(|(x, _)| {
            let r = (x.x - centre.x).hypot(x.y - centre.y);
            (inner..outer).contains(&r)
        });
        inside.count() as f64 * 0.25 * GRAIN * GRAIN / (outer * outer - inner * inner)
    };
    let (mut k, mut before) = (0, cover(0).max(COVER));
    loop {
        let now = cover(k);
        if now < FRONT {
            let share = (before - FRONT) / (before - now);
            return ring * (k as f64 - 0.5 + share);
        }
        (before, k) = (now, k + 1);
    }
}
