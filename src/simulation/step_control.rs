//! How long the next internal step is, and whether there is anything left to step.
//!
//! Between `smallest_step` and `step` the internal step goes where simulated time is cheapest: a step costs its sweeps, and beside them as
//! much as [`BESIDE`] sweeps. How sweeps grow with the step depends on the scene (a bed of a thousand spheres: faster than the step;
//! a deep bed, whose few hardest contacts decide: hardly), so that it is tried: after [`WINDOW`] steps of one length the next ones
//! are longer or shorter, and while simulated time gets cheaper this continues. What counts are sweeps, which are part of the
//! state, and not times: the same steps on every machine.
//!
//! A scene in which all spheres sleep and nothing else moves takes no steps at all: time goes on, forces stay.

use super::Simulation;
use crate::scene::gravity::GravityMotion;
use crate::scene::{Scene, Settings};
use crate::simulation::trajectory::BoundaryPaths;
use crate::solver::SolverKind;
use crate::state::{ASLEEP, StepControl, StepReport};
use crate::step::{Effort, StepFailure, StepOutput};

/// Sweeps that cost as much as all else in a step (measured on `examples/dropped`).
const BESIDE: f64 = 48.0;
/// Steps of one length.
const WINDOW: u32 = 12;
/// Factor from one length to the next.
const CHANGE: f64 = 1.25;
/// By how much simulated time must get cheaper for steps to get shorter still.
const CHEAPER: f64 = 0.95;
/// Sweeps of a single step after which it is shortened at once.
const TOO_MANY: f64 = 600.0;
/// Most sweeps of a step that can be cut instead.
const PATIENCE: usize = 1000;
/// Steps without failure after which those that had to be cut below the shortest get twice as long.
const RECOVERY: u32 = 4;
/// How often a step that does not converge is cut before its best iterate is taken.
const CUTS: u32 = 3;
/// As often where a chain of spheres seems to be squeezed: in a shorter step it may find its way out.
const JAM_CUTS: u32 = 2;
/// Steps after such a one in which another is taken without being cut.
const ACCEPTING: u32 = 20;
/// How often a step of bounded sweeps is cut at most: its work is bounded too.
const BOUNDED_CUTS: u32 = 2;
impl StepReport {
    /// Adds what an internal step cost and reached.
    pub(super) fn include(&mut self, outcome: &StepOutput) {
        let solver = &outcome.solver;
        self.internal_steps += 1;
        self.unconverged_steps += u64::from(outcome.unconverged);
        self.sweeps += solver.sweeps as u64;
        self.augmentations += solver.augmentations as u64;
        self.factorizations += solver.factorizations as u64;
        self.squeezed = outcome.squeezed.or(self.squeezed);
        self.max_overlap = self.max_overlap.max(outcome.max_overlap);
        self.max_opening = self.max_opening.max(outcome.max_opening);
        self.max_compression = self.max_compression.max(outcome.max_compression);
        self.active_set_closeness = self.active_set_closeness.max(outcome.active_set_closeness);
        self.gap_residual = self.gap_residual.max(solver.residual.gap);
        self.slip_residual = self.slip_residual.max(solver.residual.slip);
        self.force_residual = self.force_residual.max(solver.residual.force);
    }
}

/// What becomes of a step that failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Remedy {
    /// Two steps of half its length.
    Cut,
    /// It is taken as it is.
    Accept,
    /// The run ends.
    GiveUp,
}

impl StepControl {
    /// At the start of a run.
    pub(super) fn of(settings: &Settings) -> Self {
        Self {
            step: settings.step,
            ..Self::default()
        }
    }

    /// How far a step of `dt` \[s\] goes that has been cut `cuts` times.
    pub(super) fn effort(&self, settings: &Settings, dt: f64, cuts: u32) -> Effort {
        // Shorter steps come before factorizations; a strict scene ends where there are none.
        let can_cut = settings
            .smallest_step
            .is_some_and(|smallest| match settings.strict {
                true => dt > smallest && cuts < settings.max_cuts,
                false => cuts < settings.max_cuts.min(CUTS),
            });
        let patient = can_cut && settings.solver != SolverKind::Direct;
        Effort {
            sweeps: patient.then_some(PATIENCE),
            accept: !settings.strict && self.accepting > 0,
            pass: false,
        }
    }

    /// The effort of a step that failed like this and is taken as it is. What is squeezed is not solved as long as it is rigid.
    pub(super) fn last_effort(failure: &StepFailure) -> Effort {
        Effort {
            sweeps: failure.pinched.map(|_| PATIENCE),
            accept: true,
            pass: true,
        }
    }

    /// How often a step that failed like this may be cut, and the shortest step \[s\] that is: what has no solution has none in
    /// ever shorter steps either.
    fn limits(settings: &Settings, failure: &StepFailure) -> (u32, f64) {
        let converged = failure.residual <= failure.tolerance;
        let most = match (settings.sweeps, settings.strict, failure.passed) {
            (Some(_), ..) => BOUNDED_CUTS,
            (None, false, None) if failure.pinched.is_some_and(|one| !one.by_others) => 0,
            (None, false, None) if failure.pinched.is_some() => JAM_CUTS,
            (None, false, None) => CUTS,
            (None, false, Some(_)) if !converged => CUTS,
            _ => u32::MAX,
        };
        let most = most.min(settings.max_cuts);
        let shortest = match (settings.smallest_step, settings.strict) {
            (Some(smallest), false) => smallest * 0.5_f64.powi(most as i32),
            _ => 0.0,
        };
        (most, shortest)
    }

    /// What becomes of a step of `dt` \[s\] that has been cut `cuts` times and failed.
    pub(super) fn remedy(
        settings: &Settings,
        failure: &StepFailure,
        (dt, cuts): (f64, u32),
    ) -> Remedy {
        let (most, shortest) = Self::limits(settings, failure);
        match (cuts < most && dt > shortest, settings.strict) {
            (true, _) => Remedy::Cut,
            (false, true) => Remedy::GiveUp,
            (false, false) => Remedy::Accept,
        }
    }

    /// After a step of `dt` \[s\].
    pub(super) fn learn(&mut self, settings: &Settings, dt: f64, outcome: &StepOutput) {
        self.accepting = match outcome.unconverged && settings.sweeps.is_none() {
            true => ACCEPTING,
            false => self.accepting.saturating_sub(1),
        };
        let Some(smallest) = settings.smallest_step else {
            self.step = settings.step;
            return;
        };
        let sweeps = outcome.solver.sweeps as f64;
        self.taken += 1;
        self.time += dt;
        self.cost += BESIDE + sweeps;
        if self.step < smallest {
            if self.taken >= RECOVERY {
                self.turn((2.0 * self.step).min(smallest), 0.0);
            }
            return;
        }
        let hard = sweeps > TOO_MANY;
        if self.taken < WINDOW && !hard {
            return;
        }
        let rate = self.cost / self.time;
        let worse = match self.shorter {
            true => rate > CHEAPER * self.rate,
            false => rate > self.rate,
        };
        if hard {
            self.shorter = true;
        } else if self.rate > 0.0 && worse {
            self.shorter = !self.shorter;
        }
        let change = match self.shorter {
            true => 1.0 / CHANGE,
            false => CHANGE,
        };
        self.turn((self.step * change).clamp(smallest, settings.step), rate);
    }

    /// After a step of `dt` \[s\] that failed and had to be halved.
    pub(super) fn cut(&mut self, settings: &Settings, failure: &StepFailure, dt: f64) {
        if settings.smallest_step.is_some() {
            let (_, shortest) = Self::limits(settings, failure);
            self.shorter = true;
            self.turn((0.5 * dt).max(shortest), 0.0);
        }
    }

    /// Goes on with steps of another length after those that cost `rate`.
    fn turn(&mut self, step: f64, rate: f64) {
        *self = Self {
            step,
            rate,
            accepting: self.accepting,
            shorter: self.shorter,
            ..Self::default()
        };
    }
}

impl Simulation {
    /// Takes the step to `target` \[s\] at rest, if the scene rests and nothing from outside moves it until then.
    pub(super) fn rest_to(&mut self, scene: &Scene, paths: &BoundaryPaths, target: f64) -> bool {
        let state = &self.state;
        let mut spheres = state.calm.iter().zip(&state.kinematics.present);
        let rests =
            !state.calm.is_empty() && spheres.all(|(count, present)| *count == ASLEEP || !present);
        if !rests || !self.is_left_alone(scene, paths, target) {
            return false;
        }
        self.state.last_step = target - self.state.time;
        self.state.time = target;
        self.state.report.include(&StepOutput::default());
        true
    }

    fn is_left_alone(&self, scene: &Scene, paths: &BoundaryPaths, target: f64) -> bool {
        let state = &self.state;
        let still = |b: usize| {
            let surface = scene.boundaries[b].surface_velocity(&state.poses[b], &state.commands[b]);
            surface.norm_squared() == 0.0
        };
        scene.settings.gravity_motion == GravityMotion::default()
            && scene.settings.rotating_frame.is_none()
            && scene.springs.is_empty()
            && scene.driven().next().is_none()
            && state
                .reserves
                .iter()
                .all(|reserve| reserve.waiting.is_empty())
            && (0..scene.boundaries.len()).all(still)
            && paths.poses(target) == state.poses
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{ContactId, Partner};
    use crate::solver::Report;
    use crate::step::Tunnelling;

    /// Mean length \[s\] of the last of many steps that take `sweeps` of their length.
    fn length(sweeps: impl Fn(f64) -> f64) -> f64 {
        let settings = Settings {
            step: 1e-2,
            smallest_step: Some(1e-6),
            ..Settings::default()
        };
        let mut control = StepControl::of(&settings);
        let mut lengths = Vec::new();
        for _ in 0..4000 {
            let outcome = StepOutput {
                solver: Report {
                    sweeps: sweeps(control.step) as usize,
                    ..Report::default()
                },
                ..StepOutput::default()
            };
            lengths.push(control.step);
            control.learn(&settings, control.step, &outcome);
        }
        lengths[3000..].iter().sum::<f64>() / 1000.0
    }

    /// `(B + c dt^a)/dt` is least where `c dt^a = B/(a - 1)`; where sweeps hardly grow, at the longest step.
    #[test]
    fn steps_end_where_time_is_cheapest() {
        for (power, best) in [(2.0, 1e-4), (1.5, 3e-4), (3.0, 2e-5)] {
            let at_best = BESIDE / (power - 1.0);
            let sweeps = |dt: f64| at_best * (dt / best).powf(power);
            let cost = |dt: f64| (BESIDE + sweeps(dt)) / dt;
            let dearer = cost(length(sweeps)) / cost(best);
            assert!(dearer < 1.1, "power {power}: {dearer} times the least cost");
        }
        let found = length(|dt| 20.0 * (dt / 1e-4).powf(0.2));
        assert!(found > 0.7e-2, "{found} s");
    }

    /// Sweeps are bounded where a step can be cut instead, and only there.
    #[test]
    fn sweeps_are_bounded_where_steps_can_be_cut() {
        let settings = Settings {
            smallest_step: Some(1e-5),
            strict: true,
            ..Settings::default()
        };
        let control = StepControl::of(&settings);
        let sweeps = |settings: &Settings, dt, cuts| control.effort(settings, dt, cuts).sweeps;
        assert_eq!(sweeps(&settings, 2e-5, 0), Some(PATIENCE));
        assert_eq!(sweeps(&settings, 1e-5, 0), None);
        assert_eq!(sweeps(&settings, 2e-5, settings.max_cuts), None);
        let loose = Settings {
            strict: false,
            ..settings.clone()
        };
        assert_eq!(sweeps(&loose, 1e-5, 0), Some(PATIENCE));
        assert_eq!(sweeps(&loose, 2e-5, CUTS), None);
        let direct = Settings {
            solver: SolverKind::Direct,
            ..settings
        };
        assert_eq!(sweeps(&direct, 2e-5, 0), None);
        assert_eq!(sweeps(&Settings::default(), 2e-5, 0), None);
    }

    fn failure(residual: f64) -> StepFailure {
        StepFailure {
            what: "force",
            residual,
            tolerance: 0.1,
            contact: None,
            pinched: None,
            passed: None,
            broken: None,
        }
    }

    /// A step that fails is cut at first; in the end it is taken as it is, unless the scene is strict.
    #[test]
    fn every_failure_ends() {
        let failure = failure(1.0);
        for strict in [true, false] {
            let settings = Settings {
                strict,
                ..Settings::default()
            };
            let remedy = |cuts| StepControl::remedy(&settings, &failure, (1e-3, cuts));
            assert_eq!(remedy(0), Remedy::Cut);
            let last = match strict {
                true => Remedy::GiveUp,
                false => Remedy::Accept,
            };
            assert_eq!(remedy(settings.max_cuts), last);
        }
    }

    /// Bodies that pass are kept apart by shorter steps where these have a solution; a best iterate is not cut for ever.
    #[test]
    fn a_best_iterate_that_lets_bodies_pass_is_cut_a_few_times() {
        let failure = |residual| StepFailure {
            passed: Some(Tunnelling {
                contact: ContactId {
                    sphere: 0,
                    partner: Partner::Sphere {
                        index: 1,
                        image: Default::default(),
                    },
                },
                motion: 2.0,
            }),
            ..failure(residual)
        };
        let settings = Settings {
            strict: false,
            ..Settings::default()
        };
        let remedy =
            |residual, cuts| StepControl::remedy(&settings, &failure(residual), (1e-3, cuts));
        assert_eq!(remedy(0.05, settings.max_cuts - 1), Remedy::Cut);
        for unconverged in [1.0, f64::NAN] {
            assert_eq!(remedy(unconverged, CUTS - 1), Remedy::Cut);
            assert_eq!(remedy(unconverged, CUTS), Remedy::Accept);
        }
        let chosen = Settings {
            smallest_step: Some(1e-3),
            ..settings
        };
        let remedy = |dt| StepControl::remedy(&chosen, &failure(1.0), (dt, 0));
        let shortest = 1e-3 * 0.5_f64.powi(CUTS as i32);
        assert_eq!(
            [remedy(2.0 * shortest), remedy(shortest)],
            [Remedy::Cut, Remedy::Accept]
        );
        let mut control = StepControl::of(&chosen);
        control.cut(&chosen, &failure(1.0), shortest);
        assert_eq!(control.step, shortest);
    }

    /// Steps cut below the shortest one get longer again, whatever they cost.
    #[test]
    fn steps_recover_from_cuts() {
        let settings = Settings {
            step: 1e-2,
            smallest_step: Some(1e-3),
            strict: false,
            ..Settings::default()
        };
        let mut control = StepControl::of(&settings);
        control.cut(&settings, &failure(1.0), 1e-3);
        assert_eq!(control.step, 5e-4);
        let hard = StepOutput {
            solver: Report {
                sweeps: 5000,
                ..Report::default()
            },
            ..StepOutput::default()
        };
        for _ in 0..40 {
            control.learn(&settings, control.step, &hard);
        }
        assert!(control.step >= 1e-3);
    }
}
