//! Overlaps of a configuration: true geometry, every pair.
//!
//! ```text
//! o = -g / R       of each pair that overlaps, R the smaller radius of the pair     [-]
//! max = max o      rms = sqrt(sum o^2 / number of pairs that overlap)
//! ```

use sphere_dda::detection::broad_phase::NeighborList;
use sphere_dda::detection::configuration::Configuration;

/// Overlaps over radius of some pairs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Overlaps {
    /// Pairs that overlap.
    pub pairs: u64,
    /// Largest overlap over radius \[-\].
    pub largest: f64,
    squares: f64,
}

impl Overlaps {
    /// All overlapping pairs of `configuration`; `neighbors` is kept between calls for speed.
    pub fn of(configuration: &Configuration, neighbors: &mut NeighborList) -> Self {
        neighbors.ensure(configuration, &[], 0.0);
        let mut closed = Vec::new();
        configuration.candidates(neighbors, |_, _| 0.0, |_, _| 0.0, &mut closed);
        let mut overlaps = Self::default();
        for pair in &closed {
            overlaps.include(-pair.gap / configuration.scale(pair.key));
        }
        overlaps
    }

    /// Takes in a pair that overlaps by `overlap` of its radius; nothing if it does not.
    pub fn include(&mut self, overlap: f64) {
        if overlap > 0.0 {
            self.pairs += 1;
            self.largest = self.largest.max(overlap);
            self.squares += overlap * overlap;
        }
    }

    /// Takes in the pairs of another configuration.
    pub fn merge(&mut self, other: &Self) {
        self.pairs += other.pairs;
        self.largest = self.largest.max(other.largest);
        self.squares += other.squares;
    }

    /// Root of the mean square of overlap over radius \[-\]; 0 without pairs.
    #[must_use]
    pub fn rms(&self) -> f64 {
        if self.pairs == 0 {
            0.0
        } else {
            (self.squares / self.pairs as f64).sqrt()
        }
    }
}

#[cfg(test)]
mod tests {
    use sphere_dda::Vec3;
    use sphere_dda::scene::particles::{Locks, Particles};
    use sphere_dda::spatial::cell::Cell;

    use super::*;

    /// Spheres of radii 2, 1, 1 in a line: the first two overlap by 0.3 (of 1), the others by 0.4, the ends not.
    #[test]
    fn overlaps_are_measured_against_the_smaller_radius() {
        let mut particles = Particles::default();
        for radius in [2.0, 1.0, 1.0] {
            particles.push(radius, 1000.0, 0, Locks::default());
        }
        let position = [0.0, 2.7, 4.3].map(|x| Vec3::x() * x);
        let configuration = Configuration {
            particles: &particles,
            position: &position,
            present: &[true; 3],
            boundaries: &[],
            poses: &[],
            cell: &Cell::default(),
        };
        let found = Overlaps::of(&configuration, &mut NeighborList::default());
        assert_eq!(found.pairs, 2);
        assert!((found.largest - 0.4).abs() < 1e-14);
        assert!((found.rms() - 0.125f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn the_rms_of_all_steps_is_that_of_all_their_pairs() {
        let mut first = Overlaps::default();
        [3.0, -1.0].iter().for_each(|&o| first.include(o));
        let mut second = Overlaps::default();
        [4.0, 0.0, 5.0].iter().for_each(|&o| second.include(o));
        first.merge(&second);
        assert_eq!((first.pairs, first.largest), (3, 5.0));
        assert!((first.rms() - (50.0f64 / 3.0).sqrt()).abs() < 1e-15);
        assert_eq!(Overlaps::default().rms(), 0.0);
    }
}
