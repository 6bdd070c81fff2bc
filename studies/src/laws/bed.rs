//! Beds of grains that the laws are measured on: filling, runs, what is read from a state.

use std::cell::Cell;
use std::path::Path;
use std::sync::Arc;

use sphere_dda::Vec3;
use sphere_dda::scene::Scene;
use sphere_dda::scene::particles::Kinematics;
use sphere_dda::simulation::Simulation;

use crate::error::ReportError;
use crate::{Part, Watch, parallel};

/// Gravity \[m/s^2\].
pub(super) const G: f64 = 9.81;
/// Mean diameter of the grains \[m\]; radii vary by a tenth, uniformly.
pub(super) const GRAIN: f64 = 0.01;
/// Density of the grains \[kg/m^3\].
pub(super) const DENSITY: f64 = 2500.0;
/// Internal step \[s\].
pub(super) const STEP: f64 = 1e-3;
/// Time between two looks at a run \[s\].
pub(super) const LOOK: f64 = 0.01;

/// Friction of a pair of materials.
#[derive(Debug, Clone, Copy)]
pub(super) struct Friction {
    /// Coulomb's coefficient \[-\].
    pub(super) sliding: f64,
    /// Coefficient of rolling resistance \[-\].
    pub(super) rolling: f64,
}

impl Friction {
    /// Without resistance to rolling.
    pub(super) const fn sliding(sliding: f64) -> Self {
        Self {
            sliding,
            rolling: 0.0,
        }
    }
}

/// Head of every scene: settings, weight downwards by `gravity` \[m/s^2\], materials, friction between grains and on walls.
#[must_use]
pub(super) fn head(title: &str, gravity: f64, grains: Friction, walls: Friction) -> String {
    let pair = |with: &str, friction: Friction| {
        let Friction { sliding, rolling } = friction;
        format!(
            "[[pair]]\nmaterials = [\"grain\", \"{with}\"]\nfriction = {sliding}\nrolling_friction = {rolling}\n"
        )
    };
    format!(
        "title = \"{title}\"\n\
         [simulation]\nduration = 10.0\nstep = {STEP}\nfixed_step = true\nstrict = true\ncommunication_step = {LOOK}\ngravity = [0.0, 0.0, -{gravity:?}]\n\
         tolerance = {{ gap = 1e-3, slip = 1e-3, force = 1e-1, opening = 0 }}\n\
         [[material]]\nname = \"grain\"\ndensity = {DENSITY}\n\
         [[material]]\nname = \"wall\"\n"
    ) + &pair("grain", grains)
        + &pair("wall", walls)
}

/// `count` grains packed at random into `region`.
#[must_use]
pub(super) fn grains(region: &str, count: usize, seed: u64) -> String {
    let (min, max) = (0.45 * GRAIN, 0.55 * GRAIN);
    format!(
        "[[spheres]]\nname = \"grains\"\nmaterial = \"grain\"\nseed = {seed}\n\
         size = {{ uniform = {{ min = {min}, max = {max} }} }}\n\
         packing = {{ region = {region}, count = {count} }}\n"
    )
}

/// A boundary of the wall's material.
#[must_use]
pub(super) fn boundary(name: &str, faces: &str, rest: &str) -> String {
    format!("[[boundary]]\nname = \"{name}\"\nmaterial = \"wall\"\nfaces = [{faces}]\n{rest}\n")
}

/// The scene of a text.
///
/// # Errors
/// [`ReportError::Scene`] if the text is wrong.
pub(super) fn scene(name: &str, text: &str) -> Result<Scene, ReportError> {
    Ok(Scene::from_toml(name, text, Path::new(""))?.scene)
}

/// Runs every case with every packing, 1 to `packings`, on at most `threads` threads; what is found, by case.
///
/// # Errors
/// What the first run that fails says.
pub(super) fn by_packing<C: Copy + Send, T: Send>(
    threads: usize,
    cases: &[C],
    packings: u64,
    run: impl Fn(C, u64) -> Result<T, ReportError> + Sync,
) -> Result<Vec<Vec<T>>, ReportError> {
    let run = &run;
    let jobs = cases
        .iter()
        .flat_map(|&case| (1..=packings).map(move |packing| move || run(case, packing)));
    let mut found = parallel::run(threads, jobs.collect()).into_iter();
    cases
        .iter()
        .map(|_| found.by_ref().take(packings as usize).collect())
        .collect()
}

/// What cases of a kind cost, as recorded with an eighth of the grains: shares of the whole are much the same.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cost {
    /// Number of cases.
    pub(super) cases: usize,
    /// Seconds of one core, of each.
    pub(super) seconds: f64,
    /// Simulated time \[s\], of each.
    pub(super) simulated: f64,
}

impl Cost {
    /// Of all cases.
    pub(super) fn sum(costs: &[Self]) -> f64 {
        costs.iter().map(|c| c.cases as f64 * c.seconds).sum()
    }
}

/// A case of the study: its name in messages, and who watches.
pub(super) struct Run<'a> {
    /// Name.
    pub(super) name: &'a str,
    part: Part<'a>,
    simulated: f64,
    looks: Cell<u64>,
}

impl<'a> Run<'a> {
    /// A case that begins.
    pub(super) fn new(name: &'a str, watch: &'a dyn Watch, cost: Cost) -> Self {
        Self {
            name,
            part: Part::new(watch, cost.seconds),
            simulated: cost.simulated,
            looks: Cell::new(0),
        }
    }

    /// Begins a scene.
    ///
    /// # Errors
    /// [`ReportError::Step`] if its start cannot be solved.
    pub(super) fn begin(&self, scene: Scene) -> Result<Simulation, ReportError> {
        Simulation::new(Arc::new(scene)).map_err(|error| self.failed(error))
    }

    /// Advances to `end` \[s\], looking every [`LOOK`]; `look` ends it early by `false`.
    ///
    /// # Errors
    /// [`ReportError::Step`], or [`ReportError::Interrupted`].
    pub(super) fn advance(
        &self,
        simulation: &mut Simulation,
        end: f64,
        mut look: impl FnMut(&mut Simulation) -> Result<bool, ReportError>,
    ) -> Result<(), ReportError> {
        let start = simulation.time();
        let looks = ((end - start) / LOOK).round() as u64;
        for k in 1..=looks {
            if self.part.watch.stop() {
                return Err(ReportError::Interrupted);
            }
            self.part
                .reached(self.looks.get() as f64 * LOOK / self.simulated);
            self.looks.set(self.looks.get() + 1);
            simulation
                .advance_to(start + k as f64 * LOOK)
                .map_err(|error| self.failed(error))?;
            if !look(simulation)? {
                break;
            }
        }
        Ok(())
    }

    /// Advances to `end` \[s\].
    ///
    /// # Errors
    /// As [`Self::advance`].
    pub(super) fn wait(&self, simulation: &mut Simulation, end: f64) -> Result<(), ReportError> {
        self.advance(simulation, end, |_| Ok(true))
    }

    /// An error of the solver with the case's name.
    pub(super) fn failed(&self, error: sphere_dda::error::StepError) -> ReportError {
        ReportError::Step {
            case: self.name.to_owned(),
            error,
        }
    }
}

/// Centres \[m\] and masses \[kg\] of the grains in the scene.
pub(super) fn places(simulation: &Simulation) -> impl Iterator<Item = (Vec3, f64)> {
    let (kinematics, particles) = (simulation.kinematics(), &simulation.scene().particles);
    (0..particles.len())
        .filter(|&i| kinematics.present[i])
        .map(|i| (kinematics.position[i], particles.mass[i]))
}

/// Where the grains of `simulation` are, without velocities.
#[must_use]
pub(super) fn at_rest(simulation: &Simulation) -> Kinematics {
    let mut kinematics = simulation.kinematics().clone();
    kinematics.stop();
    kinematics
}

/// Kinetic energy \[J/kg\] of the grains.
#[must_use]
pub(super) fn agitation(simulation: &Simulation) -> f64 {
    let particles = &simulation.scene().particles;
    let (mut energy, mut mass) = (0.0, 0.0);
    for i in (0..particles.len()).filter(|&i| simulation.kinematics().present[i]) {
        energy += 0.5 * particles.mass[i] * simulation.velocity(i).linear.norm_squared();
        mass += particles.mass[i];
    }
    energy / mass
}
