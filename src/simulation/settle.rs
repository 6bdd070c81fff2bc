//! Settling: a scene comes to rest before its t = 0.
//!
//! Boundaries stay where they are at t = 0, driven bodies move, sources and sinks do nothing, and the spheres fall and roll,
//! slowed a little, for rolling without resistance ends nowhere: first to coarse tolerances, then with the scene's gaps. Then
//! every velocity is set to zero and the contact forces are solved anew. Spheres that these forces still accelerate get
//! another stretch, until the sum of what accelerates is below 1e-7 of the weight.
//!
//! The spheres are at rest when no speed, of a centre or of a surface about it, exceeds
//!
//! ```text
//! v_rest = 1e-3 sqrt(|g| R_min) + 2 tol R_min / dt + |g| dt
//! ```
//!
//! for a time of `sqrt(R_min / |g|)`, that of a fall by half a radius: nothing is only turning round. The second term is
//! what the larger of the gap and the slip tolerance leaves undetermined, the third what a step of free fall adds.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::Simulation;
use crate::drive::displacement;
use crate::error::StepError;
use crate::gravity::GravityMotion;
use crate::motion::{Motion, Twist};
use crate::particles::Kinematics;
use crate::problem::Dof6;
use crate::scene::{Scene, Tolerance};

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
    /// Sum of the forces that still accelerate spheres, over the weight of all \[-\].
    pub unbalanced: f64,
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
        let began = Simulation::new(Arc::new(held(scene, COARSE)))?;
        let coarse = Stretch::run(began, settle, COARSE_DAMPING, &mut watch)?;
        let (_, patience) = rest(scene);
        let stretch = Settle {
            time: (LAST * patience).max(scene.settings.communication_step),
            until_rest: false,
        };
        let mut near = held(scene, FINE);
        near.settings.step = near.settings.step.min(easy_step(scene));
        let mut settled = Self {
            start: Vec::new(),
            time: coarse.simulation.time(),
            speed: coarse.speed,
            rest_speed: coarse.rest_speed,
            at_rest: coarse.speed <= coarse.rest_speed,
            unbalanced: f64::INFINITY,
        };
        let mut last = coarse.simulation;
        for _ in 0..STRETCHES {
            last.stopped(&mut near);
            let began = Simulation::new(Arc::new(near.clone()))?;
            let fine = Stretch::run(began, stretch, FINE_DAMPING, &mut watch)?;
            settled.time += fine.simulation.time();
            settled.at_rest = fine.speed <= fine.rest_speed;
            (settled.speed, settled.rest_speed) = (fine.speed, fine.rest_speed);
            let mut start = scene.clone();
            fine.simulation.stopped(&mut start);
            last = Simulation::new(Arc::new(start))?;
            settled.unbalanced = last.unbalanced();
            if settled.unbalanced <= BALANCED || fine.ended {
                break;
            }
            near.settings.tolerance.slip = LOOSE.slip;
            near.settings.tolerance.force = LOOSE.force;
        }
        settled.start = last.snapshot();
        Ok(settled)
    }
}

/// Tolerances on the way down, and in the last stretch, which brings the gaps to the scene's: the way to rest need not be
/// exact, and the forces at rest are solved anew.
const COARSE: Tolerance = Tolerance {
    gap: 1e-3,
    slip: 1e-3,
    force: 1e-1,
};
const FINE: Tolerance = Tolerance {
    gap: 0.0,
    slip: 1e-4,
    force: 1e-1,
};
/// Of all stretches but the first, which start from the exact forces at rest: whatever a step leaves of slip adds up to creep,
/// and a pile that creeps never balances.
const LOOSE: Tolerance = Tolerance {
    gap: 0.0,
    slip: 1e-6,
    force: 1e-2,
};
/// Most stretches.
const STRETCHES: usize = 12;
/// Unbalanced forces over the weight at rest \[-\].
const BALANCED: f64 = 1e-7;
/// A time \[s\] in which no body turns: over it a displacement is a speed.
const INSTANT: f64 = 1e-9;
/// Time in which velocities fall to 1/e on the way down and in the last stretches, over the time that counts as rest.
const COARSE_DAMPING: f64 = 20.0;
const FINE_DAMPING: f64 = 2.0;
/// Length of the last stretch over the time that counts as rest: loose spheres find their places.
const LAST: f64 = 40.0;

/// The scene with gravity, boundaries and targets of springs held as at t = 0, without sources and sinks, and with tolerances no
/// finer than `least`.
fn held(scene: &Scene, least: Tolerance) -> Scene {
    let hold = |motion: &mut Motion| {
        if matches!(motion, Motion::Driven(_)) {
            return;
        }
        let pose = motion.pose_at(0.0);
        *motion = Motion::Table {
            time: vec![0.0],
            translation: vec![pose.translation],
            rotation: vec![pose.rotation.scaled_axis()],
        };
    };
    let mut scene = scene.clone();
    scene.settings.gravity_motion = GravityMotion::Fixed;
    scene
        .boundaries
        .iter_mut()
        .for_each(|boundary| hold(&mut boundary.motion));
    scene
        .springs
        .iter_mut()
        .for_each(|spring| hold(&mut spring.motion));
    let tolerance = &mut scene.settings.tolerance;
    tolerance.gap = tolerance.gap.max(least.gap);
    tolerance.slip = tolerance.slip.max(least.slip);
    tolerance.force = tolerance.force.max(least.force);
    scene.sources.clear();
    scene.sinks.clear();
    scene
}

/// Step \[s\] in which a weight moves a sphere by ten gap tolerances, `sqrt(10 tol R / |g|)`: small steps reach small gaps
/// with the least work.
fn easy_step(scene: &Scene) -> f64 {
    let settings = &scene.settings;
    (10.0 * settings.tolerance.gap * smallest(scene) / settings.gravity.norm()).sqrt()
}

/// Smallest radius \[m\].
fn smallest(scene: &Scene) -> f64 {
    let radius = scene.particles.radius.iter();
    radius.copied().fold(f64::INFINITY, f64::min)
}

/// A run that settles.
struct Stretch {
    simulation: Simulation,
    /// Largest speed at its end \[m/s\].
    speed: f64,
    rest_speed: f64,
    /// Whether who watches has ended it.
    ended: bool,
}

impl Stretch {
    fn run(
        mut simulation: Simulation,
        settle: Settle,
        damping: f64,
        watch: &mut impl FnMut(&Simulation) -> ControlFlow<()>,
    ) -> Result<Self, StepError> {
        let (rest_speed, patience) = rest(&simulation.scene);
        let step = simulation.scene.settings.communication_step;
        let mut moved_at = 0.0;
        let mut k = 0_u32;
        loop {
            let speed = simulation.fastest();
            if speed > rest_speed {
                moved_at = simulation.time();
            }
            let at_rest = simulation.time() - moved_at >= patience;
            let over = simulation.time() >= settle.time || (settle.until_rest && at_rest);
            let ended = !over && watch(&simulation).is_break();
            if over || ended {
                return Ok(Self {
                    simulation,
                    speed,
                    rest_speed,
                    ended,
                });
            }
            k += 1;
            simulation.advance_to((f64::from(k) * step).min(settle.time))?;
            simulation.slow((-step / (damping * patience)).exp());
        }
    }
}

/// Speed of rest \[m/s\] and how long it must last \[s\].
fn rest(scene: &Scene) -> (f64, f64) {
    let settings = &scene.settings;
    let gravity = settings.gravity.norm();
    let smallest = smallest(scene);
    let tolerance = settings.tolerance.gap.max(settings.tolerance.slip);
    let undetermined = 2.0 * tolerance * smallest / settings.step;
    let speed = STILL * (gravity * smallest).sqrt() + undetermined + gravity * settings.step;
    let patience = if gravity > 0.0 {
        (smallest / gravity).sqrt()
    } else {
        settings.communication_step
    };
    (speed, patience)
}

impl Simulation {
    /// Lets `scene` start with the spheres and driven bodies where they are, without velocities, and with their contacts.
    fn stopped(&self, scene: &mut Scene) {
        scene.initial.clone_from(&self.state.kinematics);
        scene.initial.stop();
        scene.initial_contacts.clone_from(&self.state.contacts);
        for (boundary, pose) in scene.boundaries.iter_mut().zip(&self.state.poses) {
            if let Motion::Driven(body) = &mut boundary.motion {
                body.pose = *pose;
                body.twist = Twist::default();
            }
        }
    }

    /// Multiplies every velocity by `share`.
    fn slow(&mut self, share: f64) {
        let Kinematics { velocity, spin, .. } = &mut self.state.kinematics;
        for v in velocity.iter_mut().chain(spin) {
            *v *= share;
        }
        for body in &mut self.state.bodies {
            body.momentum = Dof6::ZERO.plus(&body.momentum, share);
            body.velocity = Dof6::ZERO.plus(&body.velocity, share);
        }
    }

    /// Sum of the forces that accelerate spheres, over the weight of all \[-\].
    fn unbalanced(&self) -> f64 {
        let mass = &self.scene.particles.mass;
        let forces = mass.iter().zip(&self.state.persisting);
        let sum: f64 = forces.map(|(m, a)| m * a.linear.norm()).sum();
        let weight = mass.iter().sum::<f64>() * self.scene.settings.gravity.norm();
        if sum > 0.0 { sum / weight } else { 0.0 }
    }

    /// Largest speed \[m/s\] of a centre or of a surface about its centre, or of a driven body.
    fn fastest(&self) -> f64 {
        let radius = &self.scene.particles.radius;
        let driven = self.scene.driven().map(|(b, _)| {
            let (pose, twist) = (&self.state.poses[b], self.boundary_twist(b));
            displacement(
                &self.scene.boundaries[b],
                pose,
                &pose.advanced(&twist, INSTANT),
            ) / INSTANT
        });
        let spheres = (0..radius.len()).map(|i| {
            let twist = self.velocity(i);
            twist.linear.norm().max(radius[i] * twist.angular.norm())
        });
        spheres.chain(driven).fold(0.0, f64::max)
    }
}
