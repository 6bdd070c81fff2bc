//! Square matrix of DxD blocks without symmetry, and its sparse LU factor by faer: 6x6 of bodies, 3x3 of contacts.

use faer::ColMut;
use faer::linalg::solvers::Solve;
use faer::sparse::linalg::LuError;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use nalgebra::SMatrix;

use super::LinearError;

/// A block matrix over pairs: each pair has both of its off-diagonal blocks. Keeps its symbolic analysis.
#[derive(Debug, Clone)]
pub(crate) struct GeneralMatrix<const D: usize = 6> {
    /// Block rows of each block column, ascending.
    columns: Vec<Vec<u32>>,
    /// Where the values of each block column start.
    starts: Vec<usize>,
    /// Scalar compressed-column order.
    values: Vec<f64>,
    scalar: SymbolicSparseColMat<usize>,
    analysis: SymbolicLu<usize>,
}

impl<const D: usize> GeneralMatrix<D> {
    /// The zero matrix of `n` blocks coupled by `pairs`, in any order, repeats allowed.
    ///
    /// # Errors
    /// [`LinearError::Memory`] if the analysis does not fit into memory.
    pub(crate) fn new(
        n: usize,
        pairs: impl IntoIterator<Item = (u32, u32)>,
    ) -> Result<Self, LinearError> {
        let mut columns: Vec<Vec<u32>> = (0..n as u32).map(|i| vec![i]).collect();
        for (a, b) in pairs {
            columns[a as usize].push(b);
            columns[b as usize].push(a);
        }
        let (mut starts, mut length) = (Vec::with_capacity(n), 0);
        let (mut ends, mut indices) = (vec![0], Vec::new());
        for rows in &mut columns {
            rows.sort_unstable();
            rows.dedup();
            starts.push(length);
            length += D * D * rows.len();
            for _ in 0..D {
                for &row in &*rows {
                    indices.extend((0..D).map(|r| D * row as usize + r));
                }
                ends.push(indices.len());
            }
        }
        let rows = D * n;
        let scalar = SymbolicSparseColMat::new_checked(rows, rows, ends, None, indices);
        let analysis =
            SymbolicLu::try_new(scalar.as_ref()).map_err(|_| LinearError::Memory { rows })?;
        Ok(Self {
            columns,
            starts,
            values: vec![0.0; length],
            scalar,
            analysis,
        })
    }

    /// Sets every value to zero.
    pub(crate) fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Adds `block` at block row `row`, column `column`. Blocks outside the pattern are a programming error.
    pub(crate) fn add(&mut self, row: usize, column: usize, block: &SMatrix<f64, D, D>) {
        let rows = &self.columns[column];
        let found = rows.binary_search(&(row as u32));
        debug_assert!(
            found.is_ok(),
            "block ({row}, {column}) is not in the pattern"
        );
        let Ok(rank) = found else { return };
        for c in 0..D {
            let at = self.starts[column] + D * (c * rows.len() + rank);
            for r in 0..D {
                self.values[at + r] += block[(r, c)];
            }
        }
    }

    /// The factor, for several right-hand sides.
    ///
    /// # Errors
    /// [`LinearError::Singular`] or [`LinearError::Memory`].
    pub(crate) fn factorize(&self) -> Result<GeneralFactor, LinearError> {
        let rows = D * self.columns.len();
        let view = SparseColMatRef::new(self.scalar.as_ref(), &self.values);
        let factor =
            Lu::try_new_with_symbolic(self.analysis.clone(), view).map_err(
                |error| match error {
                    LuError::SymbolicSingular { .. } => LinearError::Singular { rows },
                    LuError::Generic(_) => LinearError::Memory { rows },
                },
            )?;
        Ok(GeneralFactor { factor, rows })
    }

    /// Solves `K x = b` in place; `x` has `D n` entries.
    ///
    /// # Errors
    /// [`LinearError::Singular`] or [`LinearError::Memory`].
    pub(crate) fn solve(&self, x: &mut [f64]) -> Result<(), LinearError> {
        self.factorize()?.solve(x)
    }
}

/// LU factor of a [`GeneralMatrix`].
#[derive(Debug, Clone)]
pub(crate) struct GeneralFactor {
    factor: Lu<usize, f64>,
    rows: usize,
}

impl GeneralFactor {
    /// Solves `K x = b` in place; `x` has `D n` entries.
    ///
    /// # Errors
    /// [`LinearError::Singular`].
    pub(crate) fn solve(&self, x: &mut [f64]) -> Result<(), LinearError> {
        self.factor
            .solve_in_place(ColMut::from_slice_mut(x).as_mat_mut());
        match x.iter().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(LinearError::Singular { rows: self.rows }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector, Matrix6};

    #[test]
    fn agrees_with_the_dense_factor() {
        let block = |seed: usize| {
            Matrix6::from_fn(|r, c| (seed as f64 + 1.7 * r as f64 - 0.9 * c as f64).sin())
        };
        let mut matrix = GeneralMatrix::new(4, [(0, 3), (2, 1), (3, 1), (1, 3)]).unwrap();
        let mut dense = DMatrix::<f64>::zeros(24, 24);
        let entries = [(0, 3), (3, 0), (2, 1), (1, 2), (3, 1), (1, 3)];
        let mut add = |row: usize, column: usize, m: Matrix6<f64>| {
            matrix.add(row, column, &m);
            let mut view = dense.view_mut((6 * row, 6 * column), (6, 6));
            view += m;
        };
        for i in 0..4 {
            add(i, i, block(i) + Matrix6::identity() * 9.0);
        }
        for (k, (row, column)) in entries.into_iter().enumerate() {
            add(row, column, block(10 + k));
        }
        let b = DVector::from_fn(24, |i, _| (i as f64).cos());
        let expected = dense.lu().solve(&b).unwrap();
        let mut x: Vec<f64> = b.iter().copied().collect();
        matrix.solve(&mut x).unwrap();
        for (found, expected) in x.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-13, "{found} {expected}");
        }
    }
}
