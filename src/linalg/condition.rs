//! Condition number of a symmetric positive definite block matrix in the 2-norm.
//!
//! `kappa = l_max / l_min`, both eigenvalues as Rayleigh quotients `x^T K x / x^T x`: `l_max` by power iteration, `l_min` by
//! inverse iteration with the factor at hand. A quotient is never outside `[l_min, l_max]`, so the estimate is a lower
//! bound but for rounding; its error is of second order in that of the eigenvector.
//! Source: G. H. Golub, C. F. Van Loan, *Matrix Computations*, 4th ed., sections 7.3, 8.2.

use super::{BlockMatrix, Factor};

/// Most iterations for one eigenvalue.
const MOST: usize = 20_000;
/// An eigenvalue that changes by less than this share in an iteration is taken: near rounding, since where the next
/// eigenvalue is close each iteration gains little.
const SETTLED: f64 = 1e-13;

/// Extreme eigenvalues of a matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Estimate of the largest eigenvalue, from below.
    pub largest: f64,
    /// Estimate of the smallest eigenvalue, from above.
    pub smallest: f64,
    /// Iterations spent on both.
    pub iterations: usize,
}

impl Condition {
    /// Estimates the extreme eigenvalues of `matrix`, whose Cholesky factor is `factor`.
    #[must_use]
    pub fn of(matrix: &BlockMatrix, factor: &Factor) -> Self {
        let (largest, up) = iterate(matrix, |x| x.copy_from_slice(&matrix.multiply(x)));
        let (smallest, down) = iterate(matrix, |x| factor.solve(x));
        Self {
            largest,
            smallest,
            iterations: up + down,
        }
    }

    /// The condition number \[-\]; 1 for an empty matrix.
    #[must_use]
    pub fn number(&self) -> f64 {
        if self.smallest > 0.0 {
            self.largest / self.smallest
        } else {
            1.0
        }
    }
}

/// Applies `next` and normalises until the Rayleigh quotient settles; returns it and the iterations taken.
fn iterate(matrix: &BlockMatrix, next: impl Fn(&mut [f64])) -> (f64, usize) {
    // No symmetry of a scene is likely to make this start orthogonal to an eigenvector.
    let mut x: Vec<f64> = (0..6 * matrix.pattern().len())
        .map(|k| 1.0 + 0.5 * (1.3 * k as f64 + 0.7 * (k as f64).sqrt()).sin())
        .collect();
    let mut quotient = 0.0;
    for iteration in 1..=MOST {
        next(&mut x);
        let length = dot(&x, &x).sqrt();
        if length == 0.0 {
            return (0.0, iteration);
        }
        x.iter_mut().for_each(|v| *v /= length);
        let now = dot(&x, &matrix.multiply(&x));
        if (now - quotient).abs() <= SETTLED * now {
            return (now, iteration);
        }
        quotient = now;
    }
    (quotient, MOST)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{DMatrix, Matrix6};

    use super::*;
    use crate::linalg::{BlockPattern, Symbolic};

    fn estimate(matrix: &BlockMatrix) -> Condition {
        let symbolic = Symbolic::new(matrix.pattern()).expect("analysis");
        Condition::of(matrix, &symbolic.factorize(matrix).expect("factor"))
    }

    /// A chain of masses 1 kg on springs of stiffness k, one end fixed, along each axis:
    /// l_j = 1 + k (2 - 2 cos((2 j - 1) pi / (2 n + 1))), j = 1..n.
    #[test]
    fn a_chain_of_springs_has_its_closed_form() {
        let (n, k) = (7usize, 30.0);
        let pattern = Arc::new(BlockPattern::new(n, (1..n as u32).map(|i| (i - 1, i))));
        let mut matrix = BlockMatrix::zeros(pattern);
        for i in 0..n {
            let springs = if i + 1 < n { 2.0 } else { 1.0 };
            matrix.add(i, i, &(Matrix6::identity() * (1.0 + springs * k)));
            if i > 0 {
                matrix.add(i, i - 1, &(Matrix6::identity() * -k));
            }
        }
        let eigenvalue = |j: usize| {
            let angle = (2 * j - 1) as f64 * std::f64::consts::PI / (2 * n + 1) as f64;
            1.0 + k * (2.0 - 2.0 * angle.cos())
        };
        let condition = estimate(&matrix);
        assert!((condition.smallest / eigenvalue(1) - 1.0).abs() < 1e-7);
        assert!((condition.largest / eigenvalue(n) - 1.0).abs() < 1e-6);
        assert!((condition.number() * eigenvalue(1) / eigenvalue(n) - 1.0).abs() < 1e-6);
    }

    /// A full pattern with blocks that have nothing in common, against the dense singular values.
    #[test]
    fn agrees_with_the_dense_singular_values() {
        let n = 5usize;
        let pairs = (0..n as u32).flat_map(|i| (0..i).map(move |j| (i, j)));
        let mut matrix = BlockMatrix::zeros(Arc::new(BlockPattern::new(n, pairs)));
        let root = DMatrix::from_fn(6 * n, 6 * n, |r, c| {
            (1.0 + 7.3 * r as f64 + 2.9 * c as f64 * (1.0 + r as f64)).sin()
        });
        let dense = &root * root.transpose() + DMatrix::identity(6 * n, 6 * n) * 0.3;
        for i in 0..n {
            for j in 0..=i {
                let block = dense.fixed_view::<6, 6>(6 * i, 6 * j).into_owned();
                matrix.add(i, j, &block);
            }
        }
        let singular = dense.singular_values();
        let condition = estimate(&matrix);
        assert!((condition.largest / singular.max() - 1.0).abs() < 1e-5);
        assert!((condition.smallest / singular.min() - 1.0).abs() < 1e-5);
    }

    /// Six decades of a single stiffness: the estimate grows with it, as (1 + k) / 1.
    #[test]
    fn one_stiff_direction_among_six() {
        for k in [1e-3, 1.0, 1e3, 1e6] {
            let mut matrix = BlockMatrix::zeros(Arc::new(BlockPattern::new(1, [])));
            let mut block = Matrix6::identity();
            block[(2, 2)] += k;
            matrix.add(0, 0, &block);
            let number = estimate(&matrix).number();
            assert!((number / (1.0 + k) - 1.0).abs() < 1e-6, "{k}: {number}");
        }
    }
}
