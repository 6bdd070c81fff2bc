//! Times of a run: its communication points, and the intervals of its outputs.
//!
//! Communication point `k` is the product `k step`, never a sum, so that a run that begins at any of them passes the
//! same numbers to the last bit; the last point is the stop time itself.

/// Share of a step or interval by which a time may miss it, for rounding.
const EARLY: f64 = 1e-6;
/// Share of a step by which a duration may exceed a whole number of steps, for rounding.
const ROUNDING: f64 = 1e-9;

/// The communication points of a run from t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CommunicationPoints {
    step: f64,
    stop: f64,
    count: u64,
}

impl CommunicationPoints {
    /// A run to `stop` \[s\] in communication steps of `step` \[s\], both greater than 0; the last step may be shorter.
    #[must_use]
    pub fn new(step: f64, stop: f64) -> Self {
        // A duration that is n steps but for rounding takes n.
        let count = (stop / step * (1.0 - ROUNDING)).ceil().max(1.0) as u64;
        Self { step, stop, count }
    }

    /// Number of communication steps.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Time \[s\] after `k` communication steps.
    #[must_use]
    pub fn point(&self, k: u64) -> f64 {
        if k >= self.count {
            self.stop
        } else {
            k as f64 * self.step
        }
    }

    /// After how many communication steps the run is at exactly `time` \[s\]; `None` if it never is.
    #[must_use]
    pub fn number(&self, time: f64) -> Option<u64> {
        let near = (time / self.step).round().max(0.0) as u64;
        [near, self.count]
            .into_iter()
            .find(|&k| k <= self.count && self.point(k) == time)
    }

    /// The last communication point that runs to any later stop time have too, as a number of steps: from here a run
    /// can be made longer and equal the one that was long from the start.
    #[must_use]
    pub fn extensible(&self) -> u64 {
        if self.stop == self.count as f64 * self.step {
            self.count
        } else {
            self.count - 1
        }
    }
}

/// Number of the interval \[s\] that `time` \[s\] lies in.
pub(crate) fn tick(time: f64, interval: f64) -> u64 {
    (time / interval + EARLY).floor().max(0.0) as u64
}

/// Whether an output is due at `time` \[s\], the last one being of time `last` \[s\]: the first time at or after each
/// multiple of `interval` \[s\], or every time if that is 0.
#[must_use]
pub fn due(time: f64, interval: f64, last: Option<f64>) -> bool {
    last.is_none_or(|last| {
        if interval > 0.0 {
            tick(time, interval) > tick(last, interval)
        } else {
            time > last
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_products_and_end_at_the_stop_time() {
        // Whole steps, whole but for rounding (3 * 0.1 > 0.3), a short last step, less than one step.
        for (step, stop, count, extensible) in [
            (0.25, 1.0, 4, 4),
            (0.1, 0.3, 3, 2),
            (0.01, 0.305, 31, 30),
            (0.5, 0.1, 1, 0),
        ] {
            let clock = CommunicationPoints::new(step, stop);
            assert_eq!((clock.count(), clock.extensible()), (count, extensible));
            assert_eq!(clock.point(count), stop);
            for k in 0..count {
                assert_eq!(clock.point(k), k as f64 * step);
                assert_eq!(clock.number(clock.point(k)), Some(k));
            }
            assert_eq!(clock.number(stop), Some(count));
            assert_eq!(clock.number(0.5 * step + 0.001), None);
            assert_eq!(clock.number(stop + step), None);
            let longer = CommunicationPoints::new(step, stop + 7.0);
            assert_eq!(longer.point(extensible), clock.point(extensible));
        }
    }
}
