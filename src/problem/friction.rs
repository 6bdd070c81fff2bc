//! Contacts as a problem of impulses alone, bodies eliminated: the form in which contact problems are exchanged (fclib, Siconos).
//!
//! ```text
//! u = W p + q                                   C contacts, axes (n, t1, t2) of each; W in 3x3 blocks [1/kg], q [m/s]
//! 0 <= p_n  perp  u_n >= 0                      gap over time, rebound and compliance are part of q and W
//! p_t = Proj_{|.| <= mu p_n}(p_t - s u_t)       any s > 0
//! ```
//!
//! Their measure of an impulse is the natural map of the cone `K = { |p_t| <= mu p_n }` with De Saxce's velocity (Siconos,
//! `fc3d_compute_error`):
//!
//! ```text
//! error = sqrt(sum over contacts |p - Proj_K(p - u - mu |u_t| n)|^2) / max(|q|, |p|, |u|)
//! ```
//!
//! It mixes N s and m/s, so it depends on the units; it is kept as it is to be comparable. The projection of a measure is
//! onto the cone; the law that solvers work with is [`Law`] as everywhere.

use nalgebra::{Matrix3, Vector3};

use super::{GROUND, Law, Row};
use crate::Vec3;

/// Contacts with a given Delassus operator.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrictionProblem {
    /// Where the blocks of each contact start, `[C + 1]`.
    starts: Vec<usize>,
    /// Contact of each block, ascending within a row.
    columns: Vec<u32>,
    blocks: Vec<Matrix3<f64>>,
    /// Place of the diagonal block of each contact.
    diagonal: Vec<usize>,
    free: Vec<Vec3>,
    friction: Vec<f64>,
}

impl FrictionProblem {
    /// A problem from blocks `(row, column, block)` of `W` \[1/kg\] in any order, those of one place added up, the velocities `q`
    /// without impulses, `[C]` \[m/s\], and friction coefficients, `[C]`. Blocks beyond the contacts are ignored.
    #[must_use]
    pub fn new(
        blocks: impl IntoIterator<Item = (u32, u32, Matrix3<f64>)>,
        free: Vec<Vec3>,
        friction: Vec<f64>,
    ) -> Self {
        let contacts = free.len().min(friction.len());
        let mut entries: Vec<(u32, u32, Matrix3<f64>)> = blocks.into_iter().collect();
        entries.extend((0..contacts as u32).map(|k| (k, k, Matrix3::zeros())));
        entries.retain(|entry| (entry.0.max(entry.1) as usize) < contacts);
        entries.sort_by_key(|entry| (entry.0, entry.1));
        let mut problem = Self {
            starts: vec![0],
            free,
            friction,
            ..Self::default()
        };
        let mut last = None;
        for (row, column, block) in entries {
            if last == Some((row, column)) {
                if let Some(sum) = problem.blocks.last_mut() {
                    *sum += block;
                }
                continue;
            }
            problem
                .starts
                .resize(row as usize + 1, problem.columns.len());
            if row == column {
                problem.diagonal.push(problem.columns.len());
            }
            problem.columns.push(column);
            problem.blocks.push(block);
            last = Some((row, column));
        }
        problem.starts.resize(contacts + 1, problem.columns.len());
        problem
    }

    /// How many contacts.
    #[must_use]
    pub fn contacts(&self) -> usize {
        self.friction.len()
    }

    /// Number of 3x3 blocks.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.blocks.len()
    }

    /// `q` \[m/s\], `[C]`.
    #[must_use]
    pub fn free(&self) -> &[Vec3] {
        &self.free
    }

    /// Friction coefficients, `[C]`.
    #[must_use]
    pub fn friction(&self) -> &[f64] {
        &self.friction
    }

    /// Blocks of contact `k`'s row with their columns, ascending.
    ///
    /// # Panics
    /// If there are fewer contacts.
    pub fn row(&self, k: usize) -> impl ExactSizeIterator<Item = (usize, &Matrix3<f64>)> {
        let range = self.starts[k]..self.starts[k + 1];
        let columns = self.columns[range.clone()].iter();
        columns.map(|&j| j as usize).zip(&self.blocks[range])
    }

    /// The diagonal block of contact `k` \[1/kg\].
    ///
    /// # Panics
    /// If there are fewer contacts.
    #[must_use]
    pub fn own(&self, k: usize) -> &Matrix3<f64> {
        &self.blocks[self.diagonal[k]]
    }

    /// Velocity of contact `k` \[m/s\] for impulses, `[C]` \[N s\].
    #[must_use]
    #[inline]
    pub fn velocity(&self, k: usize, impulses: &[Vec3]) -> Vec3 {
        let row = self.row(k);
        row.fold(self.free[k], |u, (j, block)| u + block * impulses[j])
    }

    /// Velocities `W p + q`, `[C]` \[m/s\].
    #[must_use]
    pub fn velocities(&self, impulses: &[Vec3]) -> Vec<Vec3> {
        let all = 0..self.contacts();
        all.map(|k| self.velocity(k, impulses)).collect()
    }

    /// The measure of Siconos, see above \[-\]; where `q`, `p` and `u` vanish it is not divided.
    #[must_use]
    pub fn error(&self, impulses: &[Vec3]) -> f64 {
        let mut squares = [0.0; 4];
        for (k, (&p, &mu)) in impulses.iter().zip(&self.friction).enumerate() {
            let u = self.velocity(k, impulses);
            let off = p - onto_cone(p - u - Vec3::x() * (mu * u.yz().norm()), mu);
            for (sum, vector) in squares.iter_mut().zip([off, p, u, self.free[k]]) {
                *sum += vector.norm_squared();
            }
        }
        let [off, sizes @ ..] = squares.map(f64::sqrt);
        let size = sizes.into_iter().fold(0.0, f64::max);
        if size > f64::EPSILON { off / size } else { off }
    }

    /// The contact law of contact `k` as a row in its own axes.
    pub(crate) fn law_row(&self, k: usize) -> Row {
        let zero = Vec3::zeros();
        Row {
            a: 0,
            b: GROUND,
            normal: Vec3::x(),
            arm_a: zero,
            arm_b: zero,
            prescribed_velocity: zero,
            bias: zero,
            compliance_n: 0.0,
            compliance_t: 0.0,
            law: Law::Contact {
                mu: self.friction[k],
            },
            radius: 1.0,
            impulse_scale: 0.0,
        }
    }
}

/// The point of the cone `|p_t| <= mu p_n` nearest to `y`.
fn onto_cone(y: Vec3, mu: f64) -> Vec3 {
    let across = y.yz().norm();
    if mu * across <= -y.x {
        return Vec3::zeros();
    }
    if across <= mu * y.x {
        return y;
    }
    let along = (mu * across + y.x) / (mu * mu + 1.0);
    let share = mu * along / across;
    Vector3::new(along, share * y.y, share * y.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = Vec3> {
        prop::array::uniform3(-10.0..10.0f64).prop_map(Vec3::from)
    }

    proptest! {
        /// Moreau's decomposition: what the cone leaves is orthogonal, and in the polar cone.
        #[test]
        fn the_cone_and_its_polar_share_a_vector(y in vector(), mu in 0.0..2.0f64) {
            let p = onto_cone(y, mu);
            let rest = y - p;
            prop_assert!(p.yz().norm() <= mu * p.x + 1e-12);
            prop_assert!(rest.dot(&p).abs() < 1e-9);
            prop_assert!(mu * rest.yz().norm() <= -rest.x + 1e-9);
        }

        /// Where the law holds, the measure vanishes, and the other way round it does not.
        #[test]
        fn the_measure_vanishes_at_solutions_alone(p_n in 0.1..5.0f64, mu in 0.1..1.0f64, slide in 0.1..3.0f64, angle in 0.0..6.0f64) {
            let along = Vec3::new(0.0, angle.cos(), angle.sin());
            let solution = Vec3::x() * p_n - along * (mu * p_n);
            let w = Matrix3::from_diagonal_element(0.5);
            let problem = FrictionProblem::new([(0, 0, w)], vec![along * slide - w * solution], vec![mu]);
            prop_assert!(problem.error(&[solution]) < 1e-12);
            prop_assert!(problem.error(&[solution * 1.01]) > 1e-4);
        }
    }

    #[test]
    fn blocks_of_one_place_are_added_and_rows_without_any_are_zero() {
        let one = Matrix3::identity();
        let problem = FrictionProblem::new(
            [(2, 0, one), (0, 0, one), (2, 0, one), (7, 0, one)],
            vec![Vec3::x(); 3],
            vec![0.5; 3],
        );
        let places = |k: usize| {
            problem
                .row(k)
                .map(|(j, b)| (j, b.trace()))
                .collect::<Vec<_>>()
        };
        assert_eq!(places(0), [(0, 3.0)]);
        assert_eq!(places(1), [(1, 0.0)]);
        assert_eq!(places(2), [(0, 6.0), (2, 0.0)]);
        assert_eq!((problem.blocks(), problem.own(0)), (4, &one));
    }
}
