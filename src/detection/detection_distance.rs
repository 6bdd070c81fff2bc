//! How far a sphere may come in a step.

use crate::Vec3;
use crate::spatial::extent::{around, larger};

/// Skin of a pair, and of a sphere to boundaries, over the smallest radius when nothing moves.
pub(super) const SKIN: f64 = 0.1;
/// Skin over the reach asked for: how many steps a list should serve in fast motion.
pub(super) const STEPS: f64 = 4.0;
/// Where one sphere leaves its skin, those join it that have this share of theirs behind them: they would soon follow.
pub(super) const SOON: f64 = 0.5;

/// How far a sphere may move \[m\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DetectionDistance {
    /// Against a motion that all spheres have in common.
    pub pairs: f64,
    /// In all.
    pub boundaries: f64,
}

impl DetectionDistance {
    /// Of every sphere that has one of two `velocities` \[m/s\] for a `step` \[s\], `[N]`, and `more(i)` \[m\]; what all have in
    /// common is the middle of all velocities.
    pub(crate) fn of(
        velocities: impl Iterator<Item = [Vec3; 2]> + Clone,
        step: f64,
        more: impl Fn(usize) -> f64,
        reach: &mut Vec<Self>,
    ) {
        let (low, high) = around(velocities.clone().flatten());
        let common = (low + high) * 0.5;
        let length = |velocities: [Vec3; 2]| {
            let squared = velocities.map(|v| v.norm_squared());
            step * larger(squared[0], squared[1]).sqrt()
        };
        reach.clear();
        reach.extend(velocities.enumerate().map(|(i, velocities)| Self {
            pairs: length(velocities.map(|v| v - common)) + more(i),
            boundaries: length(velocities) + more(i),
        }));
    }

    /// The largest of each.
    pub(crate) fn largest(reach: &[Self]) -> Self {
        reach.iter().fold(Self::default(), |largest, own| Self {
            pairs: larger(own.pairs, largest.pairs),
            boundaries: larger(own.boundaries, largest.boundaries),
        })
    }
}
