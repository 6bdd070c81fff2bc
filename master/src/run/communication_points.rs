//! Communication points: `start + k step`, never accumulated, the last exactly `stop`.

use crate::system::System;

use super::error::SimulateError;
use super::options::{MAX_STEPS, Options};

/// Steps between start and stop if neither the caller nor the FMU says how long one is.
const DEFAULT_STEPS: f64 = 500.0;

/// Part of a step by which the duration may miss a whole number of steps and still count as one.
pub(super) const STEP_TOLERANCE: f64 = 1e-9;

/// The communication points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CommunicationPoints {
    /// Start \[s\].
    pub(super) start: f64,
    /// Stop \[s\].
    pub(super) stop: f64,
    /// Length of the steps, but perhaps the last \[s\].
    pub(super) step: f64,
    /// Number of steps.
    pub(super) count: u64,
    /// All steps have the same length.
    even: bool,
}

impl CommunicationPoints {
    pub(super) fn new(system: &System<'_>, options: &Options) -> Result<Self, SimulateError> {
        let default = system.experiment();
        let start = options.start.or(default.start_time).unwrap_or(0.0);
        let stop = options.stop.or(default.stop_time);
        let stop = stop.ok_or(SimulateError::NoStop)?;
        let duration = stop - start;
        let step = options.step.or(default.step_size);
        let step = step.unwrap_or(if duration > 0.0 {
            duration / DEFAULT_STEPS
        } else {
            1.0
        });
        let ratio = duration / step;
        if !(ratio.is_finite() && step > 0.0 && duration >= 0.0 && ratio <= MAX_STEPS) {
            return Err(SimulateError::Times { start, stop, step });
        }
        let even = (ratio - ratio.round()).abs() <= STEP_TOLERANCE * ratio.max(1.0);
        let all_take_any = system.fmus().all(|fmu| fmu.description().takes_any_step());
        if !even && !all_take_any {
            return Err(SimulateError::Uneven { step, duration });
        }
        let count = if even { ratio.round() } else { ratio.ceil() } as u64;
        Ok(Self {
            start,
            stop,
            step,
            count,
            even,
        })
    }

    /// The point after `k` steps \[s\].
    pub(super) fn time(&self, k: u64) -> f64 {
        if k == self.count {
            return self.stop;
        }
        self.start + k as f64 * self.step
    }

    /// Length of the step after point `k` \[s\].
    pub(super) fn length(&self, k: u64) -> f64 {
        if self.even || k + 1 < self.count {
            return self.step;
        }
        self.stop - self.time(k)
    }
}
