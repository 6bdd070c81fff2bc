//! What stands behind `accuracy`: tolerances, and the lengths between which internal steps are chosen.
//!
//! With the smallest radius `R` and gravity `g`, a step is at most a share `c` of the time in which a
//! sphere falls by half its radius, `c sqrt(R/g)`, and at least a part of that; only steps that fail are
//! cut further. `g` is the largest gravity of a table, and where there is none at all the force of a load or on a driven body
//! over the mass that it moves. Centrifugal acceleration adds to `g`, and the pressure `p` of a servo boundary gives a
//! sphere of mass `m` on it `a = p pi R^2 / m` in place of `g`, where that is more. Between the two
//! bounds the step with the least cost of simulated time is chosen ([`crate::simulation`]).
//!
//! | | overlap `gap` | `opening` | `slip` | `force` | longest step |
//! |---|---|---|---|---|---|
//! | fast | 5e-4 | 2e-3 | 3.5e-3 | 0.1 | 0.15 sqrt(R/g) |
//! | standard | 1e-4 | 1e-3 | 7e-4 | 0.1 | 0.1 sqrt(R/g) |
//! | reference | 1e-6 | 1e-5 | 7e-6 | 1e-2 | 0.03 sqrt(R/g) |
//!
//! An error of an impulse moves a sphere 3.5 times farther across a contact than along it (`w_t = 3.5 w_n`), and the linear gap
//! is solved within 3.6 `gap` (the reserve of [`crate::scene::Settings`]): `slip` is half of what both would make it. Their cost and errors on scenes nobody tuned: `docs/newcomers.md`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::solver::Tolerance;

/// Slip over overlap.
const SLIP: f64 = 7.0;

/// How accurate a run is, and so how dear.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Accuracy {
    /// For drives and controllers: resultants.
    Fast,
    /// For forces and flows that are compared.
    #[default]
    Standard,
    /// To judge the others by.
    Reference,
}

impl Accuracy {
    /// All of them, from the cheapest.
    pub const ALL: [Self; 3] = [Self::Fast, Self::Standard, Self::Reference];

    /// Its name in scene files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Standard => "standard",
            Self::Reference => "reference",
        }
    }

    /// Tolerances of every step \[-\].
    pub(crate) fn tolerance(self) -> Tolerance {
        let (gap, force) = match self {
            Self::Fast => (5e-4, 1e-1),
            Self::Standard => (1e-4, 1e-1),
            Self::Reference => (1e-6, 1e-2),
        };
        Tolerance {
            gap,
            slip: SLIP * gap,
            force,
        }
    }

    /// Largest opening of a loaded contact \[-\] with the gap tolerance `gap` \[-\].
    #[must_use]
    pub fn opening_of(self, gap: f64) -> f64 {
        let factor = match self {
            Self::Fast => 4.0,
            Self::Standard | Self::Reference => 10.0,
        };
        (factor * gap).min(0.1)
    }

    /// Longest internal step over `sqrt(R/g)`, and the longest over the shortest that is chosen \[-\].
    fn steps(self) -> (f64, f64) {
        match self {
            Self::Fast => (0.15, 4.0),
            Self::Standard => (0.1, 4.0),
            Self::Reference => (0.03, 10.0),
        }
    }

    /// Longest and shortest internal step \[s\] where the loads move a sphere by half its radius in the time `fall` \[s\]; if
    /// they never do, a hundredth of `duration` \[s\] and its parts.
    pub(crate) fn step_range(self, fall: f64, duration: f64) -> (f64, f64) {
        let (share, range) = self.steps();
        let longest = match fall.is_finite() && fall > 0.0 {
            true => (share * fall).min(duration),
            false => 0.01 * duration,
        };
        (longest, longest / range)
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above `time` \[s\].
pub(crate) fn round_time(time: f64) -> f64 {
    let exponent = time.log10().floor() as i32;
    let candidates = (exponent - 1..=exponent + 1).flat_map(|e| [1, 2, 5].map(|m| (m, e)));
    let values = candidates.filter_map(|(m, e)| format!("{m}e{e}").parse::<f64>().ok());
    values
        .filter(|value| *value <= time * (1.0 + 1e-9))
        .fold(f64::MIN_POSITIVE, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_rounded_down_to_round_numbers() {
        for (time, rounded) in [(3.2e-3, 2e-3), (1e-3, 1e-3), (9.9e-4, 5e-4), (0.5, 0.5)] {
            assert_eq!(round_time(time), rounded);
        }
    }

    #[test]
    fn finer_accuracy_has_finer_tolerances_and_no_longer_steps() {
        for pair in Accuracy::ALL.windows(2) {
            let [coarse, fine] = [pair[0], pair[1]].map(|a| a.tolerance());
            assert!(fine.gap < coarse.gap && fine.slip < coarse.slip);
            assert!(fine.force <= coarse.force);
            let [coarse, fine] = [pair[0], pair[1]].map(|a| a.step_range(0.03, 1.0));
            assert!(fine.0 <= coarse.0 && fine.1 <= coarse.1);
        }
    }

    /// Without loads, or without spheres at first, there is a step all the same.
    #[test]
    fn every_scene_has_a_step() {
        for fall in [0.0, f64::INFINITY, 0.03] {
            for accuracy in Accuracy::ALL {
                let (longest, shortest) = accuracy.step_range(fall, 2.0);
                assert!(longest.is_finite() && 0.0 < shortest && shortest < longest);
            }
        }
    }
}
