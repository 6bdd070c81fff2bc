//! Triaxial compression: the peak friction angle of a dense sample against the friction between its grains.
//!
//! ```text
//! sin phi = (s1 - s3)/(s1 + s3)       s1, s3: stress on the top and mean stress on the side walls [Pa]
//! ```
//!
//! A box of six frictionless walls without gravity. Grains without friction are compacted by servo walls on five sides; the dense sample
//! gets its friction, the top comes down at constant speed, the servo walls at the sides hold the confining pressure. The inertial number
//! `rate d sqrt(density/s3)` is 1e-3.
//!
//! Beads without friction have an angle of 5.76 degrees in the limit of slow shear, and it grows with the rate: P.-E. Peyneau,
//! J.-N. Roux, *Frictionless bead packs have macroscopic friction, but no dilatancy*, Physical Review E 78, 011307 (2008). From there
//! the strength rises with the friction coefficient and saturates: F. Göncü, S. Luding, *Effect of particle friction and polydispersity on
//! the macroscopic stress-strain relations of granular materials*, Acta Geotechnica 8 (2013).

use sphere_dda::Vec3;
use sphere_dda::simulation::Simulation;

use super::bed::{self, Cost, Friction, GRAIN, Run};
use crate::error::ReportError;
use crate::{Watch, parallel};

/// Friction coefficients.
const FRICTIONS: [f64; 4] = [0.0, 0.1, 0.3, 0.5];
/// Edge of the loose sample over the mean grain.
const EDGE: f64 = 11.0;
/// Solid fraction of the loose sample.
const LOOSE: f64 = 0.5;
/// Confining pressure \[Pa\].
const PRESSURE: f64 = 1e3;
/// Time to compact \[s\].
const COMPACTION: f64 = 0.4;
/// Inertial number of the test.
const INERTIA: f64 = 1e-3;
/// Axial strain at the end.
const STRAIN: f64 = 0.08;
/// What the walls stand off the dense sample at first \[m\]: it starts without forces, which its new friction would have to carry.
const CLEARANCE: f64 = 1e-3 * GRAIN;
/// Looks of which an angle is the mean.
const MEAN: usize = 5;

/// One test.
#[derive(Debug, Clone, PartialEq)]
pub struct Test {
    /// Friction coefficient between the grains.
    pub friction: f64,
    /// Number of grains.
    pub grains: usize,
    /// Solid fraction at the start and at the end.
    pub solid: [f64; 2],
    /// Largest friction angle \[degrees\].
    pub peak: f64,
    /// Mean friction angle over the last fifth of the strain \[degrees\].
    pub end: f64,
    /// Mobilised friction angle \[degrees\] by axial strain.
    pub history: Vec<(f64, f64)>,
    /// Mean over the test of the side walls' stress over the wanted one, less one.
    pub servo: f64,
}

/// What the compaction costs.
pub(super) const COMPACTING: Cost = Cost {
    cases: 1,
    seconds: 1.6,
    simulated: 0.4,
};

/// What a test costs.
pub(super) const TEST: Cost = Cost {
    cases: FRICTIONS.len(),
    seconds: 1.8,
    simulated: 1.3,
};

/// Runs every friction coefficient.
///
/// # Errors
/// What a run says.
pub fn run(share: f64, threads: usize, watch: &dyn Watch) -> Result<Vec<Test>, ReportError> {
    let run = Run::new("triaxial compaction", watch, COMPACTING);
    let edge = EDGE * share.cbrt() * GRAIN;
    let count = (6.0 / std::f64::consts::PI * LOOSE * (edge / GRAIN).powi(3)) as usize;
    let loose = Walls {
        low: Vec3::zeros(),
        high: Vec3::repeat(edge),
    };
    let region = format!("{{ box = {{ min = [0.0, 0.0, 0.0], max = [{edge}, {edge}, {edge}] }} }}");
    let grains = bed::grains(&region, count, 1);
    let mut sample = run.begin(bed::scene(
        "triaxial.toml",
        &text(0.0, &grains, &loose, &servo("0.0, 0.0, -1.0", SIDES)),
    )?)?;
    run.wait(&mut sample, COMPACTION)?;
    let dense = Walls::of(&sample);
    let jobs: Vec<_> = FRICTIONS
        .iter()
        .map(|&friction| {
            let (sample, dense) = (&sample, &dense);
            move || test(friction, sample, dense, watch)
        })
        .collect();
    parallel::run(threads, jobs).into_iter().collect()
}

/// Names of the walls, bottom and top last.
const WALLS: [&str; 6] = ["west", "east", "south", "north", "bottom", "top"];
/// Walls beside the top.
const SIDES: &str = r#"["west", "east"], ["south", "north"]"#;

/// Corners of the box \[m\].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Walls {
    low: Vec3,
    high: Vec3,
}

impl Walls {
    /// Where the walls of a sample are.
    fn of(sample: &Simulation) -> Self {
        let at = |b: usize| {
            let boundary = &sample.scene().boundaries[b];
            boundary.point_of_action + sample.boundary_pose(b).translation
        };
        Self {
            low: Vec3::new(at(0).x, at(2).y, at(4).z),
            high: Vec3::new(at(1).x, at(3).y, at(5).z),
        }
    }

    /// Every wall `by` \[m\] farther out.
    fn moved_apart(&self, by: f64) -> Self {
        Self {
            low: self.low.add_scalar(-by),
            high: self.high.add_scalar(by),
        }
    }

    fn edges(&self) -> Vec3 {
        self.high - self.low
    }
}

/// A servo wall that pushes along `axis` between two pairs of walls. Its damper is that of a wall which takes a hundredth of
/// the force at the speed of the test.
fn servo(axis: &str, between: &str) -> String {
    format!(
        "body = {{ mass = 1.0, joint = {{ slide = [{axis}] }}, damping = 20.0, \
         servo = {{ pressure = {PRESSURE}, between = [{between}] }} }}"
    )
}

/// The grains of a sample where they are, at rest.
fn placed(sample: &Simulation) -> String {
    let radii = &sample.scene().particles.radius;
    let places: Vec<[f64; 3]> = bed::places(sample).map(|(x, _)| x.into()).collect();
    format!(
        "[[spheres]]\nname = \"grains\"\nmaterial = \"grain\"\nradius = {radii:?}\npositions = {places:?}\n"
    )
}

/// The scene of a box with `grains`, its top with the keys `top`.
fn text(friction: f64, grains: &str, walls: &Walls, top: &str) -> String {
    let mut text = bed::head(
        "Triaxial compression",
        0.0,
        Friction::sliding(friction),
        Friction::sliding(0.0),
    ) + grains;
    for (k, name) in WALLS.iter().enumerate() {
        let (axis, sign) = (k / 2, if k % 2 == 0 { 1.0 } else { -1.0 });
        let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
        point[axis] = if k % 2 == 0 {
            walls.low[axis]
        } else {
            walls.high[axis]
        };
        normal[axis] = sign;
        let faces = format!("{{ plane = {{ point = {point:?}, normal = {normal:?} }} }}");
        let [x, y, z] = normal;
        let rest = match axis {
            0 => servo(
                &format!("{x}, {y}, {z}"),
                r#"["south", "north"], ["bottom", "top"]"#,
            ),
            1 => servo(
                &format!("{x}, {y}, {z}"),
                r#"["west", "east"], ["bottom", "top"]"#,
            ),
            _ if sign < 0.0 => top.to_owned(),
            _ => String::new(),
        };
        text += &bed::boundary(
            name,
            &faces,
            &format!("point_of_action = {point:?}\n{rest}"),
        );
    }
    text
}

fn test(
    friction: f64,
    sample: &Simulation,
    dense: &Walls,
    watch: &dyn Watch,
) -> Result<Test, ReportError> {
    let name = format!("triaxial test at friction {friction}");
    let run = Run::new(&name, watch, TEST);
    let grains = sample.scene().particles.len();
    let rate = INERTIA / (GRAIN * (bed::DENSITY / PRESSURE).sqrt());
    let height = dense.edges().z;
    let top = format!(
        "motion = {{ constant = {{ velocity = [0.0, 0.0, {}] }} }}",
        -rate * height
    );
    let clear = dense.moved_apart(CLEARANCE);
    let scene = bed::scene(
        "triaxial.toml",
        &text(friction, &placed(sample), &clear, &top),
    )?;
    let mut simulation = run.begin(scene)?;
    let volume = bed::places(&simulation)
        .map(|(_, m)| m / bed::DENSITY)
        .sum::<f64>();
    let fill = |walls: &Walls| volume / walls.edges().product();
    let mut stresses = Vec::new();
    run.advance(&mut simulation, STRAIN / rate, |now| {
        let edges = Walls::of(now).edges();
        let force = |b: usize| now.mean_wrench(b).force;
        let axial = force(5).z / (edges.x * edges.y);
        let x = 0.5 * (force(1).x - force(0).x) / (edges.y * edges.z);
        let y = 0.5 * (force(3).y - force(2).y) / (edges.x * edges.z);
        stresses.push([1.0 - edges.z / height, axial, 0.5 * (x + y)]);
        Ok(true)
    })?;
    let history = angles(&stresses);
    let last = history.len() * 4 / 5;
    let test = Test {
        friction,
        grains,
        solid: [fill(dense), fill(&Walls::of(&simulation))],
        peak: history.iter().fold(0.0, |most, p| p.1.max(most)),
        end: history[last..].iter().map(|p| p.1).sum::<f64>() / (history.len() - last) as f64,
        servo: stresses.iter().map(|s| s[2]).sum::<f64>() / stresses.len() as f64 / PRESSURE - 1.0,
        history,
    };
    watch.note(&format!(
        "{name}: {:.1} degrees at the peak, {:.1} at the end",
        test.peak, test.end
    ));
    Ok(test)
}

/// Friction angles \[degrees\] by strain, of the mean stresses over [`MEAN`] looks, from strain, axial and lateral stress.
fn angles(stresses: &[[f64; 3]]) -> Vec<(f64, f64)> {
    let means = stresses.windows(MEAN).map(|looks| {
        let mean = |k: usize| looks.iter().map(|s| s[k]).sum::<f64>() / MEAN as f64;
        let (strain, axial, lateral) = (mean(0), mean(1), mean(2));
        let sine = (axial - lateral) / (axial + lateral);
        (strain, sine.asin().to_degrees())
    });
    means.collect()
}

#[cfg(test)]
mod tests {
    use super::angles;

    /// s1 = 3 s3 is an angle of 30 degrees, s1 = s3 none; a window of looks counts by its mean.
    #[test]
    fn angles_are_those_of_mohr_circles() {
        let looks: Vec<[f64; 3]> = (0..10)
            .map(|k| [0.01 * f64::from(k), if k < 5 { 1.0 } else { 3.0 }, 1.0])
            .collect();
        let angles = angles(&looks);
        assert_eq!(angles.len(), 6);
        assert_eq!(angles[0].1, 0.0);
        assert!((angles[5].1 - 30.0).abs() < 1e-12);
        // Three of five looks at 3: the mean stress is 2.2.
        assert!((angles[3].1 - (1.2_f64 / 3.2).asin().to_degrees()).abs() < 1e-12);
        assert!((angles[3].0 - 0.05).abs() < 1e-15);
    }
}
