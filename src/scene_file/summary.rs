//! What a scene amounts to, and which step and penalty suit it.

use std::fmt;

use super::Overlaps;
use super::bonds::at_start;
use crate::Vec3;
use crate::geometry::Shape;
use crate::scene::{Boundary, Motion, Scene};
use crate::solver::Tolerance;
use crate::spatial::extent::joined;

/// CPU time of one sphere in one step without its sweeps \[s\]: neighbours, closest points, rows, motion.
///
/// Measured, as the next two, by `time sphere-dda run examples/hopper/hopper.toml -o results --stop 0.3` and likewise for
/// the funnel, slopes, feeder, landslide, conveyor, dropped and study/bin: user time over spheres and internal steps, on one
/// thread of a two-core 2.6 GHz x86-64 server. All agree within a factor of two.
const SPHERE_COST: f64 = 1e-6;
/// CPU time of the sweeps of one sphere in one step as long as the suggested one \[s\].
const SWEEPS_COST: f64 = 0.2e-6;
/// How many times more sweeps cost with rolling or twisting resistance \[-\].
const RESISTANCE_FACTOR: f64 = 5.0;
/// Longer steps are not taken to cost more than this many times the sweeps: they are cut instead \[-\].
const MOST_LONGER: f64 = 50.0;
/// Boundaries that a summary lists.
const MOST_BOUNDARIES: usize = 20;

/// Numbers to look at before a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Title of the scene.
    pub title: String,
    /// Number of spheres.
    pub spheres: usize,
    /// The boundaries.
    pub boundaries: Vec<BoundaryExtent>,
    /// Names of the boundaries that are driven from outside.
    pub inputs: Vec<String>,
    /// Number of materials.
    pub materials: usize,
    /// Number of sensors.
    pub sensors: usize,
    /// Number of probed spheres.
    pub probes: usize,
    /// Smallest and largest radius \[m\].
    pub radius: (f64, f64),
    /// Total mass of the spheres \[kg\].
    pub mass: f64,
    /// Lower and upper corner of the box around all spheres that are there at t = 0 \[m\]; `None`: all wait in sources.
    pub extent: Option<(Vec3, Vec3)>,
    /// Overlaps at t = 0.
    pub overlaps: Overlaps,
    /// Bonds made at t = 0 between spheres, and with boundaries; `None`: no pair has `bond`.
    pub bonds: Option<[usize; 2]>,
    /// Tolerances of the scene.
    pub tolerance: Tolerance,
    /// Step of the scene \[s\].
    pub step: f64,
    /// Suggested step \[s\], see `suggested_step`.
    pub suggested_step: f64,
    /// Suggested penalty \[N/m\], see `suggested_penalty`.
    pub suggested_penalty: f64,
    /// Estimated CPU time of one simulated second \[s/s\], see [`cpu_per_second`](Self::cpu_per_second).
    pub(crate) cpu_per_second: f64,
}

/// Where a boundary is at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryExtent {
    /// Name.
    pub name: String,
    /// Lower and upper corner of the box around its bounded faces \[m\]; `None` if it has planes only.
    pub bounds: Option<(Vec3, Vec3)>,
    /// Whether it has planes, which are unbounded.
    pub unbounded: bool,
}

impl Summary {
    /// Summarises a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let particles = &scene.particles;
        let step = scene.settings.step.min(scene.settings.communication_step);
        let driven = scene.boundaries.iter().filter(|b| b.is_commanded());
        let bonded = (scene.pairs.all()).any(|(a, b)| scene.pairs.get(a, b).bond.is_some());
        Self {
            title: scene.title.clone(),
            spheres: scene.particles.len(),
            boundaries: scene.boundaries.iter().map(BoundaryExtent::of).collect(),
            inputs: driven.map(|b| b.name.clone()).collect(),
            materials: scene.materials.len(),
            sensors: scene.sensors.len(),
            probes: scene.probes.len(),
            radius: (particles.smallest_radius(), particles.largest_radius()),
            mass: scene.particles.mass.iter().sum(),
            extent: spheres_extent(scene),
            overlaps: Overlaps::of(scene),
            bonds: bonded.then(|| bonds(scene)),
            tolerance: scene.settings.tolerance,
            step,
            suggested_step: Self::suggested_step(scene),
            suggested_penalty: Self::suggested_penalty(scene, step),
            cpu_per_second: Self::cpu_per_second(scene),
        }
    }

    /// `T = N / dt (a + b max(1, dt/dt_s))` \[s/s\], an estimate of the CPU time of one simulated second, good to a factor of
    /// about three: `N` spheres, those that wait in sources included, `dt` the step, `dt_s` the suggested one. What every sphere costs
    /// in every step is `a`; sweeps cost `b`, and more of them are needed in longer steps. Rolling and twisting resistance
    /// multiply `b`.
    pub(crate) fn cpu_per_second(scene: &Scene) -> f64 {
        let step = scene.settings.step.min(scene.settings.communication_step);
        let longer = (step / Self::suggested_step(scene)).clamp(1.0, MOST_LONGER);
        let sweeps = match scene.pairs.resists() {
            true => SWEEPS_COST * RESISTANCE_FACTOR,
            false => SWEEPS_COST,
        };
        scene.particles.len() as f64 / step * (SPHERE_COST + sweeps * longer)
    }

    /// `dt = min( sqrt(tol R / (c g)), 0.15 R / v )` \[s\], the cheapest step that satisfies the gap tolerance `tol`
    /// with forces that mean something: `c = 0.2`, `R` the smallest radius, `g` the largest gravity, `v` the largest speed of
    /// a sphere or boundary in the scene plus that of a fall through the spheres' extent along gravity.
    pub(crate) fn suggested_step(scene: &Scene) -> f64 {
        Self::step_for(scene, scene.settings.tolerance.gap)
    }

    /// [`suggested_step`](Self::suggested_step) for another gap tolerance \[-\].
    pub(super) fn step_for(scene: &Scene, gap: f64) -> f64 {
        let radius = scene.particles.smallest_radius();
        let settings = &scene.settings;
        let g = settings.gravity_motion.largest(settings.gravity);
        let spheres = scene.initial.velocity.iter().map(|v| v.norm());
        let boundaries = scene.boundaries.iter().map(|b| top_speed(&b.motion));
        let heights = || scene.initial.position.iter().map(|c| c.dot(&g));
        let fall = heights().fold(f64::MIN, f64::max) - heights().fold(f64::MAX, f64::min);
        let speed = spheres.chain(boundaries).fold(0.0, f64::max) + (2.0 * fall.max(0.0)).sqrt();
        let accurate = (gap * radius / (0.2 * g.norm())).sqrt();
        accurate
            .min(0.15 * radius / speed)
            .min(scene.settings.duration)
    }

    /// `P = 10 m / dt^2` \[N/m\] with the heaviest sphere `m`: an augmentation then shrinks the gap of every sphere
    /// that rests alone on a boundary by `1/(1 + P dt^2/m) <= 1/11`.
    pub(crate) fn suggested_penalty(scene: &Scene, step: f64) -> f64 {
        10.0 * scene.particles.mass.iter().copied().fold(0.0, f64::max) / (step * step)
    }
}

impl BoundaryExtent {
    fn of(boundary: &Boundary) -> Self {
        let shapes = boundary.geometry.shapes().iter();
        let mut planes = shapes.filter(|shape| matches!(shape, Shape::HalfSpace(_)));
        Self {
            name: boundary.name.clone(),
            bounds: boundary.geometry.finite_bounds(),
            unbounded: planes.next().is_some(),
        }
    }
}

/// Numbers of bonds made at t = 0 between spheres, and with boundaries.
fn bonds(scene: &Scene) -> [usize; 2] {
    let made = at_start(scene).into_iter().filter(|bond| bond.joined);
    let (spheres, boundaries): (Vec<_>, Vec<_>) = made.partition(|bond| bond.of_spheres);
    [spheres.len(), boundaries.len()]
}

/// Lower and upper corner of the box around all spheres that are there at t = 0 \[m\].
pub(super) fn spheres_extent(scene: &Scene) -> Option<(Vec3, Vec3)> {
    let initial = &scene.initial;
    let spheres = initial.position.iter().zip(&scene.particles.radius);
    let there = spheres.zip(&initial.present).filter(|(_, there)| **there);
    there
        .map(|((c, r), _)| (c.add_scalar(-r), c.add_scalar(*r)))
        .reduce(joined)
}

/// Largest speed of the point of action \[m/s\].
fn top_speed(motion: &Motion) -> f64 {
    match motion {
        Motion::Constant(twist) => twist.linear.norm(),
        Motion::Sinusoid {
            translation,
            frequency,
            ..
        } => translation.norm() * std::f64::consts::TAU * frequency,
        Motion::Table {
            time, translation, ..
        } => {
            let pieces = time.windows(2).zip(translation.windows(2));
            let speeds = pieces.map(|(t, x)| (x[1] - x[0]).norm() / (t[1] - t[0]));
            speeds.fold(0.0, f64::max)
        }
        Motion::Fixed | Motion::Input(_) => 0.0,
        Motion::Driven(body) => body.twist.linear.norm(),
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let inputs = match self.inputs.as_slice() {
            [] => "none driven from outside".to_owned(),
            names => format!("driven from outside: {}", names.join(", ")),
        };
        let extent = match self.extent {
            Some(extent) => Extent(extent).to_string(),
            None => "none: all spheres wait in sources".to_owned(),
        };
        let [smallest, largest] = [self.radius.0, self.radius.1].map(metres);
        let (step, suggested, gap) = (self.step, self.suggested_step, self.tolerance.gap);
        let row = |label: &str, value: String| format!("  {label:<17} {value}");
        let mut lines = vec![
            row(
                "spheres",
                format!("{}, radius {smallest} to {largest} m", self.spheres),
            ),
            row("mass", format!("{} kg", metres(self.mass))),
            row("extent", extent),
            row("boundaries", format!("{}, {inputs}", self.boundaries.len())),
        ];
        if !self.title.is_empty() {
            lines.insert(0, self.title.clone());
        }
        let boundaries = self.boundaries.iter().take(MOST_BOUNDARIES);
        lines.extend(boundaries.map(|boundary| format!("    {boundary}")));
        if self.boundaries.len() > MOST_BOUNDARIES {
            let more = self.boundaries.len() - MOST_BOUNDARIES;
            lines.push(format!("    and {more} more"));
        }
        let step =
            format!("{step:.3e} s; suggested {suggested:.1e} s for a gap tolerance of {gap:e}");
        let penalty = format!("suggested {:.1e} N/m for this step", self.suggested_penalty);
        let cost = format!(
            "about {:.1e} s of CPU time per simulated second (estimate, within a factor of 3)",
            self.cpu_per_second
        );
        lines.extend([
            row("materials", self.materials.to_string()),
            row("sensors", self.sensors.to_string()),
            row("probes", self.probes.to_string()),
            row("initial overlaps", self.overlaps.to_string()),
        ]);
        lines.extend(self.bonds.map(|[spheres, boundaries]| {
            let made =
                format!("{spheres} between spheres, {boundaries} with boundaries, at the start");
            row("bonds", made)
        }));
        lines.extend([
            row("step", step),
            row("penalty", penalty),
            row("cost", cost),
        ]);
        f.write_str(&lines.join("\n"))
    }
}

/// A box as the summary writes it.
struct Extent((Vec3, Vec3));

impl fmt::Display for Extent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let corner = |x: Vec3| format!("({}, {}, {})", metres(x.x), metres(x.y), metres(x.z));
        let (low, high) = self.0;
        let size = high - low;
        let size = [size.x, size.y, size.z].map(|x| format!("{}", rounded(x, 3)));
        write!(
            f,
            "{} to {} m, {} m",
            corner(low),
            corner(high),
            size.join(" x ")
        )
    }
}

impl fmt::Display for BoundaryExtent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<16}", self.name)?;
        match (self.bounds, self.unbounded) {
            (Some(bounds), false) => write!(f, "{}", Extent(bounds)),
            (Some(bounds), true) => write!(f, "{}, and an unbounded plane", Extent(bounds)),
            (None, _) => write!(f, "unbounded plane"),
        }
    }
}

impl fmt::Display for Overlaps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |n: usize, worst: Option<f64>| {
            worst.map_or("0".to_owned(), |r| format!("{n} (largest {r:.2e} R)"))
        };
        let pairs = part(self.pairs.len(), self.worst_pair().map(|o| o.ratio));
        let boundaries = part(
            self.boundaries.len(),
            self.worst_boundary().map(|o| o.ratio),
        );
        write!(f, "{pairs} between spheres, {boundaries} with boundaries")
    }
}

/// Six significant digits without trailing zeros.
pub(super) fn metres(x: f64) -> String {
    format!("{}", rounded(x, 6))
}

fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}
