//! Sparse Cholesky factor `L L^T` by faer, symbolic analysis kept while the pattern stays.

use std::sync::Arc;

use faer::linalg::solvers::Solve;
use faer::sparse::linalg::LltError;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{ColMut, Side};

use super::{BlockMatrix, BlockPattern, LinearError};

/// Fill-reducing order and elimination tree of a pattern.
#[derive(Debug, Clone)]
pub struct Symbolic {
    pattern: Arc<BlockPattern>,
    scalar: SymbolicSparseColMat<usize>,
    analysis: SymbolicLlt<usize>,
}

impl Symbolic {
    /// Analyses `pattern`.
    ///
    /// # Errors
    /// [`LinearError::Memory`] if the analysis does not fit into memory.
    pub fn new(pattern: &Arc<BlockPattern>) -> Result<Self, LinearError> {
        let rows = 6 * pattern.len();
        let mut starts = Vec::with_capacity(rows + 1);
        let mut indices = Vec::new();
        starts.push(0);
        for column in 0..pattern.len() {
            for _ in 0..6 {
                for &row in pattern.column(column) {
                    indices.extend((0..6).map(|r| 6 * row as usize + r));
                }
                starts.push(indices.len());
            }
        }
        let scalar = SymbolicSparseColMat::new_checked(rows, rows, starts, None, indices);
        let analysis = SymbolicLlt::try_new(scalar.as_ref(), Side::Lower)
            .map_err(|_| LinearError::Memory { rows })?;
        Ok(Self {
            pattern: Arc::clone(pattern),
            scalar,
            analysis,
        })
    }

    /// The pattern analysed.
    pub(crate) fn pattern(&self) -> &Arc<BlockPattern> {
        &self.pattern
    }

    /// Factorizes `matrix`, which must have the pattern analysed.
    ///
    /// # Errors
    /// [`LinearError::NotPositiveDefinite`] or [`LinearError::Memory`].
    pub fn factorize(&self, matrix: &BlockMatrix) -> Result<Factor, LinearError> {
        let rows = 6 * self.pattern.len();
        let view = SparseColMatRef::new(self.scalar.as_ref(), matrix.values());
        Llt::try_new_with_symbolic(self.analysis.clone(), view, Side::Lower)
            .map(Factor)
            .map_err(|error| match error {
                LltError::Numeric(_) => LinearError::NotPositiveDefinite { rows },
                LltError::Generic(_) => LinearError::Memory { rows },
            })
    }
}

/// A numeric factor.
#[derive(Debug, Clone)]
pub struct Factor(Llt<usize, f64>);

impl Factor {
    /// Solves `K x = b` in place; `x` has `6 n` entries.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        self.0
            .solve_in_place(ColMut::from_slice_mut(x).as_mat_mut());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector, Matrix6};

    fn block(seed: u32) -> Matrix6<f64> {
        Matrix6::from_fn(|r, c| (f64::from(seed) + 1.7 * r as f64 - 0.9 * c as f64).sin())
    }

    #[test]
    fn agrees_with_the_dense_factor() {
        let pairs = [(0u32, 3u32), (2, 1), (3, 1), (1, 3)];
        let pattern = Arc::new(BlockPattern::new(5, pairs));
        let mut matrix = BlockMatrix::zeros(Arc::clone(&pattern));
        let mut dense = DMatrix::<f64>::zeros(30, 30);
        for i in 0..5 {
            let b = block(i as u32);
            let diagonal = b * b.transpose() + Matrix6::identity() * 20.0;
            matrix.add(i, i, &diagonal);
            dense.view_mut((6 * i, 6 * i), (6, 6)).copy_from(&diagonal);
        }
        for (k, (a, b)) in pairs
            .iter()
            .take(3)
            .map(|&(a, b)| (a as usize, b as usize))
            .enumerate()
        {
            let m = block(10 + k as u32);
            matrix.add(a, b, &m);
            let mut view = dense.view_mut((6 * a, 6 * b), (6, 6));
            view += m;
            let mut view = dense.view_mut((6 * b, 6 * a), (6, 6));
            view += m.transpose();
        }
        let rhs = DVector::from_fn(30, |i, _| (i as f64).cos());
        let expected = dense.cholesky().expect("positive definite").solve(&rhs);
        let mut x: Vec<f64> = rhs.iter().copied().collect();
        let symbolic = Symbolic::new(&pattern).expect("analysis");
        symbolic.factorize(&matrix).expect("factor").solve(&mut x);
        for (found, expected) in x.iter().zip(expected.iter()) {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }

    #[test]
    fn refuses_an_indefinite_matrix() {
        let pattern = Arc::new(BlockPattern::new(1, []));
        let mut matrix = BlockMatrix::zeros(Arc::clone(&pattern));
        matrix.add(0, 0, &-Matrix6::identity());
        let symbolic = Symbolic::new(&pattern).expect("analysis");
        assert!(matches!(
            symbolic.factorize(&matrix),
            Err(LinearError::NotPositiveDefinite { rows: 6 })
        ));
    }
}
