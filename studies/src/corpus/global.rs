//! Bodies out of a global problem: `W = H^T M^-1 H`, `q := H^T M^-1 q + b`.
//!
//! `M` falls apart into bodies, or groups of bodies that it couples: each is inverted by itself.

use sphere_dda::nalgebra::{DMatrix, DVector};

use super::matrix::Entries;

/// Reduces `M v = q + H r`, `u = H^T v + b`.
///
/// # Errors
/// Words for an `M` that has no inverse.
pub(super) fn reduce(
    m: &Entries,
    h: &Entries,
    q: &[f64],
    mut b: Vec<f64>,
) -> Result<(Entries, Vec<f64>), String> {
    let mut w = Entries {
        rows: h.columns,
        columns: h.columns,
        entries: Vec::new(),
    };
    let (group_of, place, groups) = groups(m);
    let mut masses: Vec<DMatrix<f64>> = groups
        .iter()
        .map(|members| DMatrix::zeros(members.len(), members.len()))
        .collect();
    for &(row, column, value) in &m.entries {
        masses[group_of[row]][(place[row], place[column])] += value;
    }
    // What each group feels of which columns of H.
    let mut felt: Vec<Vec<(usize, usize, f64)>> = vec![Vec::new(); groups.len()];
    for &(row, column, value) in &h.entries {
        felt[group_of[row]].push((column, place[row], value));
    }
    for ((members, mass), mut felt) in groups.iter().zip(masses).zip(felt) {
        if felt.is_empty() {
            continue;
        }
        felt.sort_by_key(|entry| entry.0);
        let mut columns: Vec<usize> = felt.iter().map(|entry| entry.0).collect();
        columns.dedup();
        let mut own = DMatrix::zeros(members.len(), columns.len());
        for (column, row, value) in felt {
            let rank = columns.partition_point(|&c| c < column);
            own[(row, rank)] += value;
        }
        let pushed = DVector::from_iterator(members.len(), members.iter().map(|&i| q[i]));
        let factor = mass.lu();
        let (Some(moved), Some(free)) = (factor.solve(&own), factor.solve(&pushed)) else {
            return Err(format!("a singular M at row {}", members[0]));
        };
        let block = own.transpose() * moved;
        let free = own.transpose() * free;
        for (i, &row) in columns.iter().enumerate() {
            b[row] += free[i];
            for (j, &column) in columns.iter().enumerate() {
                w.entries.push((row, column, block[(i, j)]));
            }
        }
    }
    match b.iter().all(|u| u.is_finite()) {
        true => Ok((w, b)),
        false => Err("a singular M".to_owned()),
    }
}

/// Rows that `M` couples: group of each row, place within it, members of each group.
fn groups(m: &Entries) -> (Vec<usize>, Vec<usize>, Vec<Vec<usize>>) {
    let mut root: Vec<usize> = (0..m.rows).collect();
    fn find(root: &mut [usize], mut i: usize) -> usize {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        i
    }
    for &(row, column, _) in &m.entries {
        let (a, b) = (find(&mut root, row), find(&mut root, column));
        root[a.max(b)] = a.min(b);
    }
    let mut group_of = vec![0; m.rows];
    let mut place = vec![0; m.rows];
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for i in 0..m.rows {
        let first = find(&mut root, i);
        if first == i {
            group_of[i] = groups.len();
            groups.push(Vec::new());
        } else {
            group_of[i] = group_of[first];
        }
        let group = &mut groups[group_of[i]];
        place[i] = group.len();
        group.push(i);
    }
    (group_of, place, groups)
}
