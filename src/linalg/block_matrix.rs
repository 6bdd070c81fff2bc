//! Symmetric matrix of 6x6 blocks, lower triangle, compressed by block columns.

use std::sync::Arc;

use nalgebra::Matrix6;

/// Which blocks of the lower triangle are stored. The diagonal always is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockPattern {
    /// Start of each block column in `rows`, `[n + 1]`.
    starts: Vec<usize>,
    /// Block rows of each column, ascending, the diagonal first.
    rows: Vec<u32>,
}

impl BlockPattern {
    /// The pattern of `n` bodies coupled by `pairs` (in any order, repeats allowed, diagonal ignored).
    pub(crate) fn new(n: usize, pairs: impl IntoIterator<Item = (u32, u32)>) -> Self {
        let mut lower: Vec<(u32, u32)> = pairs
            .into_iter()
            .filter(|(a, b)| a != b)
            .map(|(a, b)| (a.min(b), a.max(b)))
            .collect();
        lower.sort_unstable();
        lower.dedup();
        let mut starts = Vec::with_capacity(n + 1);
        let mut rows = Vec::with_capacity(n + lower.len());
        let mut next = lower.into_iter().peekable();
        for column in 0..n as u32 {
            starts.push(rows.len());
            rows.push(column);
            while let Some((_, row)) = next.next_if(|(c, _)| *c == column) {
                rows.push(row);
            }
        }
        starts.push(rows.len());
        Self { starts, rows }
    }

    /// Number of block columns.
    pub(crate) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Block rows stored in column `c`.
    pub(super) fn column(&self, c: usize) -> &[u32] {
        &self.rows[self.starts[c]..self.starts[c + 1]]
    }
}

/// A symmetric block matrix with the values in scalar compressed-column order.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockMatrix {
    pattern: Arc<BlockPattern>,
    /// `[36 * blocks]`; block column `c` of `k` blocks holds six scalar columns of `6 k` values.
    values: Vec<f64>,
}

impl BlockMatrix {
    /// The zero matrix on `pattern`.
    pub(crate) fn zeros(pattern: Arc<BlockPattern>) -> Self {
        let values = vec![0.0; 36 * pattern.rows.len()];
        Self { pattern, values }
    }

    /// The pattern.
    #[must_use]
    pub fn pattern(&self) -> &Arc<BlockPattern> {
        &self.pattern
    }

    /// The values in scalar compressed-column order.
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// Sets every value to zero, keeping the pattern.
    pub(crate) fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Adds `block` at block row `row`, column `column`; of the pair `(row, column)`, `(column, row)` only
    /// one must be added, the matrix is symmetric. Blocks outside the pattern are a programming error.
    pub(crate) fn add(&mut self, row: usize, column: usize, block: &Matrix6<f64>) {
        if row < column {
            self.add(column, row, &block.transpose());
            return;
        }
        let start = self.pattern.starts[column];
        let rows = self.pattern.column(column);
        let found = rows.binary_search(&(row as u32));
        debug_assert!(
            found.is_ok(),
            "block ({row}, {column}) is not in the pattern"
        );
        let Ok(rank) = found else { return };
        let height = 6 * rows.len();
        for c in 0..6 {
            let at = 36 * start + c * height + 6 * rank;
            for r in 0..6 {
                self.values[at + r] += block[(r, c)];
            }
        }
    }

    /// `K x`; `x` has `6 n` entries.
    pub(crate) fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for column in 0..self.pattern.len() {
            let rows = self.pattern.column(column);
            let height = 6 * rows.len();
            for c in 0..6 {
                let start = 36 * self.pattern.starts[column] + c * height;
                let at = 6 * column + c;
                for (rank, &row) in rows.iter().enumerate() {
                    for r in 0..6 {
                        let value = self.values[start + 6 * rank + r];
                        let to = 6 * row as usize + r;
                        y[to] += value * x[at];
                        if row as usize != column {
                            y[at] += value * x[to];
                        }
                    }
                }
            }
        }
        y
    }
}
