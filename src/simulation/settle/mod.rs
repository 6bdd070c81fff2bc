//! Settling: a scene comes to rest before its t = 0.
//!
//! Boundaries stay where they are at t = 0, driven bodies move unless they are held, sources and sinks do nothing, and the
//! spheres fall and roll, slowed a little, for rolling without resistance ends nowhere. It goes in passes:
//!
//! ```text
//! 1  coarse     to coarse tolerances, until at rest or for its share of the time
//! 2  fine       with the scene's gaps
//! 3+ balance    from the forces at rest of the pass before, until what accelerates is below 1e-7 of the loads
//! ```
//!
//! After each but the first every velocity is set to zero and the contact forces are solved anew. All passes together take
//! no more than the time that is given.
//!
//! The spheres are at rest when no speed, of a centre or of a surface about it, exceeds
//!
//! ```text
//! v_rest = 1e-3 sqrt(a R_min) + 2 tol R_min / dt + a dt
//! ```
//!
//! for a time of `sqrt(R_min / a)`, that of a fall by half a radius: nothing is only turning round. `a` \[m/s^2\] is gravity,
//! where there is none the loads over the mass of the spheres. The second term is what the larger of the gap and the slip
//! tolerance leaves undetermined, the third what a step of free fall adds.

mod error;
mod fastest;
mod pass;
mod progress;
mod scenes;
mod start_loads;

use std::ops::ControlFlow;

use crate::error::StepError;
use crate::scene::Scene;
pub use error::SettleError;
pub use fastest::Fastest;
pub use pass::{Pass, PassKind, SettleProgress};
use progress::Progress;
use scenes::{COARSE, FINE, LOOSE, held, still};
use start_loads::StartLoads;

/// How long a scene settles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settle {
    /// Longest time of all passes together \[s\], > 0.
    pub time: f64,
    /// Whether the first pass ends as soon as the spheres are at rest; else it takes its share of the time.
    pub until_rest: bool,
}

/// A settled scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// The start, for [`Scene::start_from`]: a checkpoint of the scene at t = 0.
    pub start: Vec<u8>,
    /// Time simulated in all passes \[s\], at most [`Settle::time`].
    pub time: f64,
    /// Number of passes.
    pub passes: u32,
    /// Largest speed at the end \[m/s\], before all were set to zero.
    pub speed: f64,
    /// What had it; `None`: nothing moved.
    pub fastest: Option<Fastest>,
    /// The speed below which a sphere is at rest \[m/s\].
    pub rest_speed: f64,
    /// Whether the spheres were at rest.
    pub at_rest: bool,
    /// Sum of the forces that still accelerate spheres, over the sum of the loads \[-\].
    pub unbalanced: f64,
    /// Why a pass that would have balanced the forces better was given up; the start is that of the pass before.
    pub given_up: Option<SettleError>,
}

impl Settled {
    /// Settles `scene`. `watch` receives the progress after every communication step and may end it early.
    ///
    /// # Errors
    /// [`SettleError::Step`] with the pass and the step that could not be taken; [`SettleError::Argument`] if the time is not
    /// one.
    pub fn new(
        scene: &Scene,
        settle: Settle,
        watch: impl FnMut(&SettleProgress<'_>) -> ControlFlow<()>,
    ) -> Result<Self, SettleError> {
        if !(settle.time > 0.0 && settle.time.is_finite()) {
            return Err(SettleError::Argument(StepError::Argument {
                what: "settling time",
                found: format!("{} s", settle.time),
                expected: "a finite time > 0",
            }));
        }
        let still = still(scene);
        let mut progress = Progress::new(scene, settle.time, watch);
        let began = progress.begin(held(&still, COARSE), PassKind::Coarse, 0.0)?;
        let load = StartLoads::of(&began);
        let length = (LAST * load.pause).max(scene.settings.communication_step);
        let way_down = settle.time - (FINE_PASSES * length).min(FINE_SHARE * settle.time);
        let coarse = progress.run(began, &load, way_down, settle.until_rest)?;

        let mut near = held(&still, FINE);
        near.settings.step = near.settings.step.min(load.easy_step(scene));
        let step = near.settings.step;
        let smallest = &mut near.settings.smallest_step;
        *smallest = smallest.map(|least| least.min(step));
        let mut settled = Self {
            start: Vec::new(),
            time: progress.time,
            passes: 1,
            speed: coarse.speed,
            fastest: None,
            rest_speed: coarse.rest_speed,
            at_rest: coarse.speed <= coarse.rest_speed,
            unbalanced: f64::INFINITY,
            given_up: None,
        };
        let mut last = coarse.simulation;
        let mut kind = PassKind::Fine;
        // A start displaces overlapping spheres and no boundaries: between a floor and a body that presses nothing is left to displace.
        let mut overlap = match still.driven().next() {
            Some(_) => COARSE.gap,
            None => 0.0,
        };
        for _ in 0..STRETCHES {
            last.stopped(&mut near);
            let stretch = progress
                .begin(near.clone(), kind, overlap)
                .and_then(|began| progress.run(began, &load, length, false));
            let fine = match stretch {
                Ok(fine) => fine,
                // The pass before has left a start already.
                Err(error) if kind == PassKind::Balance => {
                    settled.given_up = Some(error);
                    break;
                }
                Err(error) => return Err(error),
            };
            settled.time = progress.time;
            settled.passes = progress.pass.number;
            settled.at_rest = fine.speed <= fine.rest_speed;
            (settled.speed, settled.rest_speed) = (fine.speed, fine.rest_speed);
            settled.fastest = fine.mover.map(|mover| fine.simulation.describe(mover));
            last = progress.stop(&fine.simulation, &still)?;
            settled.unbalanced = load.unbalanced(&last);
            if settled.unbalanced <= BALANCED || fine.ended || progress.is_over() {
                break;
            }
            near.settings.tolerance.slip = LOOSE.slip;
            near.settings.tolerance.force = LOOSE.force;
            kind = PassKind::Balance;
            overlap = 0.0;
        }
        // Bodies that were held are free from t = 0.
        if scene.driven().any(|(_, body)| body.hold_while_settling) {
            last = progress.stop(&last, scene)?;
        }
        settled.start = last.snapshot();
        Ok(settled)
    }
}

/// Most passes after the first.
const STRETCHES: usize = 12;
/// Unbalanced forces over the loads at rest \[-\].
const BALANCED: f64 = 1e-7;
/// Length of a pass after the first over the time that counts as rest: loose spheres find their places.
const LAST: f64 = 40.0;
/// What the first pass leaves to the others: so many of them, but no more than this share of the time.
const FINE_PASSES: f64 = 4.0;
const FINE_SHARE: f64 = 1.0 / 3.0;
