//! Sparse algebra over 6x6 blocks: symmetric block matrix, its Cholesky factor, its condition number; LU over blocks of any size.
//!
//! Uses nothing of the solver's own; checked against a dense factorization in the tests below.

mod block_matrix;
mod cholesky;
mod condition;
mod lu;

pub(crate) use block_matrix::{BlockMatrix, BlockPattern};
pub use cholesky::{Factor, Symbolic};
pub use condition::Condition;
pub(crate) use lu::{GeneralFactor, GeneralMatrix};

use thiserror::Error;

/// Why a linear system could not be solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LinearError {
    /// The matrix is not positive definite to working precision.
    #[error(
        "the matrix of {rows} rows is not positive definite to working precision; lower the penalty"
    )]
    NotPositiveDefinite {
        /// Number of scalar rows.
        rows: usize,
    },
    /// The matrix has no inverse to working precision.
    #[error("the matrix of {rows} rows is singular to working precision")]
    Singular {
        /// Number of scalar rows.
        rows: usize,
    },
    /// The factor does not fit into memory.
    #[error("no memory for the sparse factor of {rows} rows; use solver = \"gauss-seidel\"")]
    Memory {
        /// Number of scalar rows.
        rows: usize,
    },
}
