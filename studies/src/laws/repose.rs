//! Angle of repose: what stays on a rough floor when one wall of a box is taken away.
//!
//! A box with frictionless front and back, a rough floor of held grains and a left wall is filled; its right wall
//! goes, the grains run off the edge, and a line through the surface that stays has the angle of repose. It grows with the friction
//! coefficient and lies between 15 and 25 degrees for spheres without rolling resistance: Y. C. Zhou, B. H. Xu, A. B. Yu,
//! P. Zulli, *An experimental and numerical study of the angle of repose of coarse spheres*, Powder Technology 125 (2002).

use std::fmt::Write as _;

use sphere_dda::simulation::Simulation;

use super::bed::{self, Cost, Friction, GRAIN, Run};
use super::fit::{self, Line};
use crate::Watch;
use crate::error::ReportError;

/// Friction coefficients.
const FRICTIONS: [f64; 5] = [0.2, 0.3, 0.4, 0.5, 0.6];
/// Packings of every friction coefficient: one heap alone scatters by a degree, which is more than the rise between the largest two.
pub(super) const PACKINGS: u64 = 8;
/// Length, width and filling height of the box over the mean grain.
const BOX: [f64; 3] = [30.0, 6.0, 15.0];
/// Filling, then the longest outflow \[s\].
const TIMES: [f64; 2] = [0.7, 3.0];
/// Kinetic energy \[J/kg\] at which the slope has come to rest.
const REST: f64 = 1e-5;
/// Solid fraction of the filling.
const PACKED: f64 = 0.58;

/// A heap.
#[derive(Debug, Clone, PartialEq)]
pub struct Heap {
    /// Angle \[degrees\].
    pub angle: f64,
    /// Coefficient of determination of the line.
    pub r2: f64,
    /// Height of the surface by distance from the left wall \[m\].
    pub surface: Vec<(f64, f64)>,
    /// When it had come to rest \[s\].
    pub rest: f64,
}

/// The heaps of a friction coefficient.
#[derive(Debug, Clone, PartialEq)]
pub struct Slope {
    /// Friction coefficient.
    pub friction: f64,
    /// By packing.
    pub heaps: Vec<Heap>,
}

impl Slope {
    /// Mean angle and its standard error \[degrees\].
    #[must_use]
    pub fn angle(&self) -> [f64; 2] {
        fit::mean(self.heaps.iter().map(|heap| heap.angle))
    }
}

/// What a heap costs.
pub(super) const COST: Cost = Cost {
    cases: FRICTIONS.len() * PACKINGS as usize,
    seconds: 3.2,
    simulated: 2.6,
};

/// Runs every friction coefficient.
///
/// # Errors
/// What a run says.
pub fn run(share: f64, threads: usize, watch: &dyn Watch) -> Result<Vec<Slope>, ReportError> {
    let heaps = bed::by_packing(threads, &FRICTIONS, PACKINGS, |friction, packing| {
        heap(friction, packing, share, watch)
    })?;
    let slopes = FRICTIONS.into_iter().zip(heaps);
    Ok(slopes
        .map(|(friction, heaps)| Slope { friction, heaps })
        .collect())
}

fn text(friction: f64, seed: u64, [length, width, height]: [f64; 3], wall: bool) -> String {
    let d = GRAIN;
    let (l, w, h) = (length * d, width * d, height * d);
    let count = (6.0 / std::f64::consts::PI * PACKED * length * width * height) as usize;
    let region = format!(
        "{{ box = {{ min = [0.0, 0.0, {d}], max = [{l}, {w}, {}] }} }}",
        1.9 * h
    );
    let face = |corner: [f64; 3], u: [f64; 3], v: [f64; 3]| {
        format!("{{ rectangle = {{ corner = {corner:?}, u = {u:?}, v = {v:?} }} }}")
    };
    let tall = 2.0 * h;
    let mut text = bed::head(
        "Angle of repose",
        bed::G,
        Friction::sliding(friction),
        Friction::sliding(0.0),
    ) + &bed::grains(&region, count, seed);
    let (columns, rows) = (length as usize, width as usize);
    let mut places = String::new();
    for k in 0..columns * rows {
        let x = (k % columns) as f64 * d + 0.5 * d;
        let y = (k / columns) as f64 * d + 0.5 * d;
        let _ = write!(places, "[{x}, {y}, {}], ", 0.5 * d);
    }
    let _ = write!(
        text,
        "[[spheres]]\nname = \"rough\"\nmaterial = \"grain\"\nradius = {}\nlock = [\"translations\", \"rotations\"]\npositions = [{places}]\n",
        0.5 * d
    );
    text += &bed::boundary(
        "left",
        &face([0.0, 0.0, 0.0], [0.0, w, 0.0], [0.0, 0.0, tall]),
        "",
    );
    let sides = [
        face([0.0, 0.0, 0.0], [2.0 * l, 0.0, 0.0], [0.0, 0.0, tall]),
        face([0.0, w, 0.0], [2.0 * l, 0.0, 0.0], [0.0, 0.0, tall]),
    ];
    text += &bed::boundary("sides", &sides.join(", "), "");
    if wall {
        text += &bed::boundary(
            "right",
            &face([l, 0.0, 0.0], [0.0, w, 0.0], [0.0, 0.0, tall]),
            "",
        );
    }
    text + "[[sink]]\nname = \"off\"\nregion = { beyond = { point = [0.0, 0.0, -0.02], normal = [0.0, 0.0, -1.0] } }\n"
}

fn heap(friction: f64, seed: u64, share: f64, watch: &dyn Watch) -> Result<Heap, ReportError> {
    let name = format!("repose at friction {friction}, packing {seed}");
    let run = Run::new(&name, watch, COST);
    let size = BOX.map(|side| (side * share.cbrt()).round());
    let mut full = run.begin(bed::scene(
        "repose.toml",
        &text(friction, seed, size, true),
    )?)?;
    run.wait(&mut full, TIMES[0])?;
    let mut scene = bed::scene("repose.toml", &text(friction, seed, size, false))?;
    scene.initial = bed::at_rest(&full);
    let mut heap = run.begin(scene)?;
    run.advance(&mut heap, TIMES[1], |heap| {
        Ok(heap.time() < 0.5 || bed::agitation(heap) > REST)
    })?;
    let surface = surface(&heap, size[0]);
    // The wall's and the edge's own grains are not the slope.
    let inner = 2..surface.len().saturating_sub(3);
    let line = Line::through(&surface[inner]);
    let measured = Heap {
        angle: (-line.slope).atan().to_degrees(),
        r2: line.r2,
        rest: heap.time(),
        surface,
    };
    watch.note(&format!("{name}: {:.1} degrees", measured.angle));
    Ok(measured)
}

/// Mean height of the highest grains in slices of one and a half grains, by distance from the left wall \[m\].
fn surface(heap: &Simulation, length: f64) -> Vec<(f64, f64)> {
    let slice = 1.5 * GRAIN;
    let slices = (length * GRAIN / slice) as usize;
    let mut surface = Vec::new();
    for k in 0..slices {
        let inside = bed::places(heap)
            .filter(|(x, _)| (slice * k as f64..slice * (k + 1) as f64).contains(&x.x));
        let mut heights: Vec<f64> = inside.map(|(x, _)| x.z + 0.5 * GRAIN).collect();
        heights.sort_by(|a, b| b.total_cmp(a));
        heights.truncate(5);
        if !heights.is_empty() {
            let mean = heights.iter().sum::<f64>() / heights.len() as f64;
            surface.push((slice * (k as f64 + 0.5), mean));
        }
    }
    surface
}
