//! Sensors: mass in a box, mass flow through a plane.
//!
//! A sphere counts with its whole mass where its centre is. For a plane through `a` with unit normal `n` a centre
//! is *beyond* when `(c - a) . n >= 0`; the cumulated mass \[kg\] is
//!
//! ```text
//! M(t) = sum_i m_i (beyond_i(t) - beyond_i(0))
//! ```
//!
//! so that it telescopes over steps: however the time is cut, it equals the mass beyond now minus then, up to the
//! rounding of a sum of masses.

use crate::Vec3;
use crate::particles::Particles;
use crate::region::Region;

/// An oriented plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// A point of it \[m\].
    pub point: Vec3,
    /// Unit normal.
    pub normal: Vec3,
}

impl Plane {
    fn beyond(&self, centre: Vec3) -> bool {
        (centre - self.point).dot(&self.normal) >= 0.0
    }
}

/// Mass \[kg\] of the spheres whose centres pass through `plane` along its normal between `before` and `after`
/// \[m\], `[N]` each; passages against the normal count negative. `mass` \[kg\], `[N]`.
#[must_use]
pub fn crossings(before: &[Vec3], after: &[Vec3], mass: &[f64], plane: Plane) -> f64 {
    let mut sum = 0.0;
    for ((&before, &after), mass) in before.iter().zip(after).zip(mass) {
        match (plane.beyond(before), plane.beyond(after)) {
            (false, true) => sum += mass,
            (true, false) => sum -= mass,
            _ => {}
        }
    }
    sum
}

/// Mass \[kg\] of the spheres whose `centre` \[m\], `[N]`, lies in the region.
#[must_use]
pub fn mass_inside(particles: &Particles, centre: &[Vec3], region: &Region) -> f64 {
    centre
        .iter()
        .zip(&particles.mass)
        .filter(|(c, _)| region.contains(**c))
        .map(|(_, mass)| mass)
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particles::Locks;
    use proptest::prelude::*;

    const PLANE: Plane = Plane {
        point: Vec3::new(0.0, 0.0, 1.0),
        normal: Vec3::new(0.0, 0.0, -1.0),
    };

    fn at(z: f64) -> Vec3 {
        Vec3::new(0.3, -0.2, z)
    }

    #[test]
    fn a_centre_on_the_plane_counts_once() {
        // Down to the plane, rest on it, on below: one passage in all.
        let path = [at(1.5), at(1.0), at(1.0), at(0.5)];
        let passed: Vec<f64> = path
            .windows(2)
            .map(|w| crossings(&w[..1], &w[1..], &[2.5], PLANE))
            .collect();
        assert_eq!(passed, [2.5, 0.0, 0.0]);
        assert_eq!(crossings(&[at(0.5)], &[at(1.5)], &[2.5], PLANE), -2.5);
    }

    proptest! {
        #[test]
        fn crossings_telescope(heights in prop::collection::vec(0.0..2.0_f64, 2..20)) {
            let total: f64 = heights
                .windows(2)
                .map(|w| crossings(&[at(w[0])], &[at(w[1])], &[3.0], PLANE))
                .sum();
            let whole = crossings(&[at(heights[0])], &[at(heights[heights.len() - 1])], &[3.0], PLANE);
            prop_assert_eq!(total, whole);
        }
    }

    #[test]
    fn adjacent_boxes_share_no_sphere() {
        let mut particles = Particles::default();
        for _ in 0..3 {
            particles.push(0.1, 1000.0, 0, Locks::default());
        }
        let centre = [at(0.0), at(1.0), at(2.0)];
        let mass = particles.mass[0];
        let half = Vec3::new(1.0, 1.0, 0.0);
        let inside = |z0: f64, z1: f64| {
            let region = Region::Box {
                min: -half + Vec3::z() * z0,
                max: half + Vec3::z() * z1,
            };
            mass_inside(&particles, &centre, &region)
        };
        assert_eq!(inside(0.0, 1.0), mass);
        assert_eq!(inside(1.0, 2.0), mass);
        assert_eq!(inside(0.0, 3.0), 3.0 * mass);
    }
}
