//! Settling: a scene comes to rest before its t = 0.
//!
//! Boundaries stay where they are at t = 0, sources and sinks do nothing, and the spheres fall, roll and rest as in a
//! run, gaps held to the scene's tolerance, forces and slips to coarser ones. Then every velocity is set to zero and the contact forces are solved anew: the scene starts from rest, in
//! equilibrium if the spheres had come to rest.
//!
//! The spheres are at rest when no speed, of a centre or of a surface about it, exceeds
//!
//! ```text
//! v_rest = 1e-3 sqrt(|g| R_min) + 2 tol R_min / dt
//! ```
//!
//! for a time of `sqrt(R_min / |g|)`, that of a fall by half a radius: nothing is only turning round. The second term is
//! what the gap tolerance leaves undetermined.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::Simulation;
use crate::Vec3;
use crate::error::StepError;
use crate::motion::Motion;
use crate::scene::Scene;

/// Share of `sqrt(|g| R)` that counts as rest.
const STILL: f64 = 1e-3;

/// How long a scene settles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settle {
    /// Longest time \[s\], > 0.
    pub time: f64,
    /// Whether to stop as soon as the spheres are at rest.
    pub until_rest: bool,
}

/// A settled scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// The start, for [`Scene::start_from`]: a checkpoint of the scene at t = 0.
    pub start: Vec<u8>,
    /// How long it took \[s\].
    pub time: f64,
    /// Largest speed at the end \[m/s\], before all were set to zero.
    pub speed: f64,
    /// The speed below which a sphere is at rest \[m/s\].
    pub rest_speed: f64,
    /// Whether the spheres were at rest.
    pub at_rest: bool,
}

impl Settled {
    /// Settles `scene`. `watch` sees the simulation after every communication step and may end it early.
    ///
    /// # Errors
    /// [`StepError`] of the step that could not be taken; [`StepError::Argument`] if the time is not one.
    pub fn new(
        scene: &Scene,
        settle: Settle,
        mut watch: impl FnMut(&Simulation) -> ControlFlow<()>,
    ) -> Result<Self, StepError> {
        if !(settle.time > 0.0 && settle.time.is_finite()) {
            return Err(StepError::Argument {
                what: "settling time",
                found: format!("{} s", settle.time),
                expected: "a finite time > 0",
            });
        }
        let mut simulation = Simulation::new(Arc::new(held(scene)))?;
        let (rest_speed, patience) = rest(scene);
        let step = scene.settings.communication_step;
        let mut moved_at = 0.0;
        let mut speed;
        let mut k = 0_u32;
        loop {
            speed = simulation.fastest();
            if speed > rest_speed {
                moved_at = simulation.time();
            }
            let at_rest = simulation.time() - moved_at >= patience;
            if simulation.time() >= settle.time || (settle.until_rest && at_rest) {
                break;
            }
            k += 1;
            simulation.advance_to((f64::from(k) * step).min(settle.time))?;
            if watch(&simulation).is_break() {
                break;
            }
        }
        let time = simulation.time();
        let mut start = scene.clone();
        start.initial = simulation.state.kinematics;
        start.initial.velocity.fill(Vec3::zeros());
        start.initial.spin.fill(Vec3::zeros());
        start.initial_contacts = simulation.state.contacts;
        let rested = Simulation::new(Arc::new(start))?;
        Ok(Self {
            start: rested.snapshot(),
            time,
            speed,
            rest_speed,
            at_rest: speed <= rest_speed,
        })
    }
}

/// Force and slip tolerances while settling: the way to rest need not be exact, the forces at rest are solved anew.
const FORCE: f64 = 1e-2;
const SLIP: f64 = 1e-4;

/// The scene with boundaries and targets of springs held as at t = 0, without sources and sinks.
fn held(scene: &Scene) -> Scene {
    let hold = |motion: &mut Motion| {
        let pose = motion.pose_at(0.0);
        *motion = Motion::Table {
            time: vec![0.0],
            translation: vec![pose.translation],
            rotation: vec![pose.rotation.scaled_axis()],
        };
    };
    let mut scene = scene.clone();
    scene
        .boundaries
        .iter_mut()
        .for_each(|boundary| hold(&mut boundary.motion));
    scene
        .springs
        .iter_mut()
        .for_each(|spring| hold(&mut spring.motion));
    let tolerance = &mut scene.settings.tolerance;
    tolerance.force = tolerance.force.max(FORCE);
    tolerance.slip = tolerance.slip.max(SLIP);
    scene.sources.clear();
    scene.sinks.clear();
    scene
}

/// Speed of rest \[m/s\] and how long it must last \[s\].
fn rest(scene: &Scene) -> (f64, f64) {
    let settings = &scene.settings;
    let gravity = settings.gravity.norm();
    let smallest = scene
        .particles
        .radius
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let undetermined = 2.0 * settings.tolerance.gap * smallest / settings.step;
    let speed = STILL * (gravity * smallest).sqrt() + undetermined;
    let patience = if gravity > 0.0 {
        (smallest / gravity).sqrt()
    } else {
        settings.communication_step
    };
    (speed, patience)
}

impl Simulation {
    /// Largest speed \[m/s\] of a centre or of a surface about its centre.
    fn fastest(&self) -> f64 {
        let radius = &self.scene.particles.radius;
        let spheres = (0..radius.len()).map(|i| {
            let twist = self.velocity(i);
            twist.linear.norm().max(radius[i] * twist.angular.norm())
        });
        spheres.fold(0.0, f64::max)
    }
}
