//! What a scene amounts to, and which step and penalty suit it.

use std::fmt;

use super::{Overlaps, Scene, Tolerance};
use crate::Vec3;
use crate::motion::Motion;

/// Numbers to look at before a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Title of the scene.
    pub title: String,
    /// Number of spheres.
    pub spheres: usize,
    /// Number of boundaries.
    pub boundaries: usize,
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
    /// Lower and upper corner of the box around all spheres \[m\].
    pub extent: (Vec3, Vec3),
    /// Overlaps at t = 0.
    pub overlaps: Overlaps,
    /// Tolerances of the scene.
    pub tolerance: Tolerance,
    /// Step of the scene \[s\].
    pub step: f64,
    /// Suggested step \[s\], see [`suggested_step`](Self::suggested_step).
    pub suggested_step: f64,
    /// Suggested penalty \[N/m\], see [`suggested_penalty`](Self::suggested_penalty).
    pub suggested_penalty: f64,
}

impl Summary {
    /// Summarises a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let radius = &scene.particles.radius;
        let step = scene.settings.step.min(scene.settings.communication_step);
        let corner = |sign: f64, pick: fn(f64, f64) -> f64| {
            let reach = scene
                .initial
                .position
                .iter()
                .zip(radius)
                .map(|(c, r)| c.add_scalar(sign * r));
            reach.reduce(|a, b| a.zip_map(&b, pick)).unwrap_or_default()
        };
        let extent = (corner(-1.0, f64::min), corner(1.0, f64::max));
        let driven = scene.boundaries.iter().filter(|b| b.is_commanded());
        Self {
            title: scene.title.clone(),
            spheres: scene.particles.len(),
            boundaries: scene.boundaries.len(),
            inputs: driven.map(|b| b.name.clone()).collect(),
            materials: scene.materials.len(),
            sensors: scene.sensors.len(),
            probes: scene.probes.len(),
            radius: (
                radius.iter().copied().fold(f64::INFINITY, f64::min),
                radius.iter().copied().fold(0.0, f64::max),
            ),
            mass: scene.particles.mass.iter().sum(),
            extent,
            overlaps: Overlaps::of(scene),
            tolerance: scene.settings.tolerance,
            step,
            suggested_step: Self::suggested_step(scene),
            suggested_penalty: Self::suggested_penalty(scene, step),
        }
    }

    /// `dt = min( sqrt(tol R / (c g)), 0.15 R / v )` \[s\], the cheapest step that meets the gap tolerance `tol`
    /// with forces that mean something: `c = 0.2`, `R` the smallest radius, `g` gravity, `v` the largest speed of
    /// a sphere or wall in the scene plus that of a fall through the spheres' extent along gravity.
    #[must_use]
    pub fn suggested_step(scene: &Scene) -> f64 {
        let radius = scene
            .particles
            .radius
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        let g = scene.settings.gravity;
        let spheres = scene.initial.velocity.iter().map(|v| v.norm());
        let walls = scene.boundaries.iter().map(|b| top_speed(&b.motion));
        let heights = || scene.initial.position.iter().map(|c| c.dot(&g));
        let fall = heights().fold(f64::MIN, f64::max) - heights().fold(f64::MAX, f64::min);
        let speed = spheres.chain(walls).fold(0.0, f64::max) + (2.0 * fall.max(0.0)).sqrt();
        let accurate = (scene.settings.tolerance.gap * radius / (0.2 * g.norm())).sqrt();
        accurate
            .min(0.15 * radius / speed)
            .min(scene.settings.duration)
    }

    /// `P = 10 m / dt^2` \[N/m\] with the heaviest sphere `m`: an augmentation then shrinks the gap of every sphere
    /// that rests alone on a wall by `1/(1 + P dt^2/m) <= 1/11`.
    #[must_use]
    pub fn suggested_penalty(scene: &Scene, step: f64) -> f64 {
        10.0 * scene.particles.mass.iter().copied().fold(0.0, f64::max) / (step * step)
    }
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
        let (low, high) = self.extent;
        let inputs = match self.inputs.as_slice() {
            [] => "none driven from outside".to_owned(),
            names => format!("driven from outside: {}", names.join(", ")),
        };
        if !self.title.is_empty() {
            writeln!(f, "{}", self.title)?;
        }
        writeln!(
            f,
            "  spheres           {}, radius {} to {} m",
            self.spheres,
            short(self.radius.0),
            short(self.radius.1)
        )?;
        writeln!(f, "  mass              {} kg", short(self.mass))?;
        writeln!(
            f,
            "  extent            ({}, {}, {}) to ({}, {}, {}) m",
            short(low.x),
            short(low.y),
            short(low.z),
            short(high.x),
            short(high.y),
            short(high.z)
        )?;
        writeln!(f, "  boundaries        {}, {inputs}", self.boundaries)?;
        writeln!(f, "  materials         {}", self.materials)?;
        writeln!(f, "  sensors, probes   {}, {}", self.sensors, self.probes)?;
        writeln!(f, "  initial overlaps  {}", self.overlaps)?;
        writeln!(
            f,
            "  step              {:.3e} s; suggested {:.1e} s for a gap tolerance of {:e}",
            self.step, self.suggested_step, self.tolerance.gap
        )?;
        write!(
            f,
            "  penalty           suggested {:.1e} N/m for this step",
            self.suggested_penalty
        )
    }
}

impl fmt::Display for Overlaps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |n: usize, worst: Option<f64>| {
            worst.map_or("0".to_owned(), |r| format!("{n} (largest {r:.2e} R)"))
        };
        let pairs = part(self.pairs.len(), self.worst_pair().map(|o| o.ratio));
        let walls = part(self.walls.len(), self.worst_wall().map(|o| o.ratio));
        write!(f, "{pairs} between spheres, {walls} with boundaries")
    }
}

/// Six significant digits without trailing zeros.
fn short(x: f64) -> String {
    let rounded = format!("{x:.5e}").parse::<f64>().unwrap_or(x);
    format!("{rounded}")
}
