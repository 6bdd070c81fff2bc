//! Volume, centroid and inertia of a solid.

use nalgebra::Matrix3;

use crate::Vec3;

/// Moments of a solid of density one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// Volume \[m^3\].
    pub volume: f64,
    /// Centroid \[m\].
    pub centroid: Vec3,
    /// Inertia about the centroid over the density \[m^5\].
    pub inertia: Matrix3<f64>,
}

impl Moments {
    /// Those of the integrals `int dV` \[m^3\], `int x dV` \[m^4\], `int x x^T dV` \[m^5\] about `origin` \[m\].
    pub(super) fn of_integrals(
        origin: Vec3,
        (volume, first, second): (f64, Vec3, Matrix3<f64>),
    ) -> Self {
        let centroid = first / volume;
        let second = second - centroid * centroid.transpose() * volume;
        Self {
            volume,
            centroid: origin + centroid,
            inertia: Matrix3::identity() * second.trace() - second,
        }
    }

    /// Principal moments of inertia over the density \[m^5\], ascending.
    #[must_use]
    pub fn principal(&self) -> Vec3 {
        let mut moments = self.inertia.symmetric_eigenvalues();
        moments.as_mut_slice().sort_by(f64::total_cmp);
        moments
    }
}
