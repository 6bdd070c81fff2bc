//! How far a sphere may come in a step.

use std::ops::Range;

use crate::Vec3;
use crate::parallel::Pool;
use crate::spatial::extent::larger;

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
    /// Into `reach`, `[N]`, that of every sphere that has one of two `velocities(i)` \[m/s\] for a `step` \[s\], and `more(i)` \[m\];
    /// what all have in common is the mean of all velocities.
    pub(crate) fn of(
        velocities: impl Fn(usize) -> [Vec3; 2] + Sync,
        step: f64,
        more: impl Fn(usize) -> f64 + Sync,
        (reach, pool): (&mut [Self], &Pool),
    ) {
        let sum = |_, spheres: Range<usize>| spheres.flat_map(&velocities).sum::<Vec3>();
        let sum = pool.pieces(0..reach.len(), sum, |a, b| a + b);
        let common = sum / f64::max(2.0 * reach.len() as f64, 1.0);
        let length = |velocities: [Vec3; 2]| {
            let squared = velocities.map(|v| v.norm_squared());
            step * larger(squared[0], squared[1]).sqrt()
        };
        pool.fill(reach, |i| Self {
            pairs: length(velocities(i).map(|v| v - common)) + more(i),
            boundaries: length(velocities(i)) + more(i),
        });
    }

    /// The largest of each.
    pub(crate) fn largest(reach: &[Self]) -> Self {
        reach.iter().fold(Self::default(), |largest, own| Self {
            pairs: larger(own.pairs, largest.pairs),
            boundaries: larger(own.boundaries, largest.boundaries),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second half of many has another velocity than the first: what they have in common is the mean, whatever each piece has.
    #[test]
    fn the_common_motion_is_that_of_all_pieces() {
        let mut reach = vec![DetectionDistance::default(); 2048];
        let velocities = |i: usize| match i {
            1024.. => [Vec3::x() * 1.5; 2],
            _ => [Vec3::x() * 2.0, Vec3::x() * 3.0],
        };
        DetectionDistance::of(velocities, 0.1, |_| 1.0, (&mut reach, &Pool::default()));
        let expected = DetectionDistance {
            pairs: 1.1,
            boundaries: 1.3,
        };
        assert_eq!(reach[0], expected);
        assert_eq!(DetectionDistance::largest(&reach), expected);
    }
}
