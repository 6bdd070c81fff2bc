//! Reads friction problems in the text format of Siconos: local (`W`, `q`, `mu`) and global (`M`, `H`, `q`, `b`, `mu`), in two or
//! three dimensions, matrices dense, in blocks or sparse as CSparse prints them.
//!
//! ```text
//! local    u = W r + q                          3D: (n, t1, t2) of each contact; 2D: (n, t)
//! global   M v = q + H r,  u = H^T v + b        becomes W = H^T M^-1 H, q := H^T M^-1 q + b
//! ```
//!
//! A contact of two dimensions gets a second tangent that nothing moves: the solutions and their measure stay the same.

use std::path::{Path, PathBuf};

use sphere_dda::Vec3;
use sphere_dda::nalgebra::{Matrix3, Vector3};
use sphere_dda::problem::friction::FrictionProblem;
use thiserror::Error;

use super::global;
use super::matrix::{Entries, matrix, size};
use super::tokens::{Fault, Tokens};

/// First bytes of an HDF5 file.
const HDF5: &[u8] = b"\x89HDF";

/// A file that is no friction problem.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CorpusError {
    /// The disk refuses.
    #[error("cannot read `{}`: {error}", .path.display())]
    Disk {
        /// Which file.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// HDF5 (fclib) instead of text.
    #[error(
        "`{}` is an HDF5 file, expected Siconos' text format: convert it by `benches/corpus/convert.py FILE -o DIR`", .0.display()
    )]
    Hdf5(PathBuf),
    /// Text that is no problem.
    #[error("`{}`, line {line}: found {found}, expected {expected}", .path.display())]
    Text {
        /// Which file.
        path: PathBuf,
        /// Where, counted from one.
        line: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A folder without problems.
    #[error("`{}` has no problem: expected files that end with .dat", .0.display())]
    Empty(PathBuf),
}

/// A problem as read.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    /// The contacts.
    pub problem: FrictionProblem,
    /// 2 or 3.
    pub dimension: usize,
    /// Whether bodies were eliminated.
    pub global: bool,
}

/// Reads a file.
///
/// # Errors
/// [`CorpusError`].
pub fn read(path: &Path) -> Result<Read, CorpusError> {
    let bytes = std::fs::read(path).map_err(|error| CorpusError::Disk {
        path: path.to_path_buf(),
        error,
    })?;
    if bytes.starts_with(HDF5) {
        return Err(CorpusError::Hdf5(path.to_path_buf()));
    }
    parse(&String::from_utf8_lossy(&bytes)).map_err(|fault| CorpusError::Text {
        path: path.to_path_buf(),
        line: fault.line,
        found: fault.found,
        expected: fault.expected,
    })
}

/// Reads the text of a file.
pub(super) fn parse(text: &str) -> Result<Read, Fault> {
    let mut tokens = Tokens::of(text);
    let dimension = tokens.count("the dimension, 2 or 3")?;
    if dimension != 2 && dimension != 3 {
        return Err(tokens.fault(format!("dimension {dimension}"), "2 or 3"));
    }
    let contacts = size(&mut tokens, "contacts")?;
    let first = matrix(&mut tokens, "W or M")?;
    if first.rows != first.columns {
        let found = format!("{} rows and {} columns", first.rows, first.columns);
        return Err(tokens.fault(found, "a square matrix W or M"));
    }
    let size = dimension * contacts;
    // Some files end with a flag that no reader needs.
    let local = first.rows == size && tokens.left() <= size + contacts + 1;
    let (w, q) = if local {
        let q = tokens.numbers(size, "q")?;
        (first, q)
    } else {
        let h = matrix(&mut tokens, "H")?;
        if [h.rows, h.columns] != [first.rows, size] {
            return Err(tokens.fault(
                format!("H of {} rows and {} columns", h.rows, h.columns),
                &format!(
                    "{} rows as M and {size} columns for {contacts} contacts",
                    first.rows
                ),
            ));
        }
        let q = tokens.numbers(first.rows, "q")?;
        let b = tokens.numbers(size, "b")?;
        global::reduce(&first, &h, &q, b).map_err(|what| tokens.fault(what, "a regular M"))?
    };
    let friction = tokens.numbers(contacts, "mu")?;
    if let Some(mu) = friction.iter().find(|mu| **mu < 0.0) {
        return Err(tokens.fault(format!("mu = {mu}"), "friction coefficients of at least 0"));
    }
    Ok(Read {
        problem: problem(dimension, &w, &q, friction),
        dimension,
        global: !local,
    })
}

/// Entries in axes of `dimension` as 3x3 blocks.
fn problem(dimension: usize, w: &Entries, q: &[f64], friction: Vec<f64>) -> FrictionProblem {
    let contacts = friction.len();
    let mut blocks: Vec<(u32, u32, Matrix3<f64>)> = Vec::new();
    let mut entries = w.entries.clone();
    entries.sort_by_key(|&(row, column, _)| (row / dimension, column / dimension));
    for (row, column, value) in entries {
        let place = ((row / dimension) as u32, (column / dimension) as u32);
        if blocks.last().is_none_or(|last| (last.0, last.1) != place) {
            blocks.push((place.0, place.1, Matrix3::zeros()));
        }
        if let Some((_, _, block)) = blocks.last_mut() {
            block[(row % dimension, column % dimension)] += value;
        }
    }
    if dimension == 2 {
        for (row, column, block) in &mut blocks {
            if row == column {
                // As stiff as the other tangent, so that no scale changes.
                block[(2, 2)] = if block[(1, 1)] > 0.0 {
                    block[(1, 1)]
                } else {
                    1.0
                };
            }
        }
    }
    let free = q.chunks_exact(dimension).take(contacts);
    let free: Vec<Vec3> = free
        .map(|q| Vector3::new(q[0], q[1], q.get(2).copied().unwrap_or(0.0)))
        .collect();
    FrictionProblem::new(blocks, free, friction)
}
