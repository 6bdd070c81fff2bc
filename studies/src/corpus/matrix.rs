//! Matrices as Siconos writes them: dense, in blocks, or sparse as CSparse prints them.

use super::tokens::{Fault, Tokens};

/// Most rows of a matrix: more is a damaged file.
const MOST: usize = 10_000_000;

/// Entries of a matrix, in any order; those of one place add up.
#[derive(Debug, Clone, Default)]
pub(super) struct Entries {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) entries: Vec<(usize, usize, f64)>,
}

impl Entries {
    fn push(&mut self, tokens: &Tokens, place: [usize; 2], value: f64) -> Result<(), Fault> {
        let [row, column] = place;
        if row >= self.rows || column >= self.columns {
            let expected = format!("a place within {} by {}", self.rows, self.columns);
            return Err(tokens.fault(format!("an entry at ({row}, {column})"), &expected));
        }
        if value != 0.0 {
            self.entries.push((row, column, value));
        }
        Ok(())
    }
}

/// Reads a matrix; `what` is its name.
pub(super) fn matrix(tokens: &mut Tokens, what: &str) -> Result<Entries, Fault> {
    let storage = tokens.count(&format!("the storage of {what}"))?;
    let rows = size(tokens, what)?;
    let columns = size(tokens, what)?;
    let mut matrix = Entries {
        rows,
        columns,
        ..Entries::default()
    };
    match storage {
        0 => dense(tokens, what, &mut matrix)?,
        1 => blocks(tokens, what, &mut matrix)?,
        2 => sparse(tokens, what, &mut matrix)?,
        other => {
            let expected = "0 (dense), 1 (blocks) or 2 (sparse)";
            return Err(tokens.fault(format!("storage {other} of {what}"), expected));
        }
    }
    Ok(matrix)
}

pub(super) fn size(tokens: &mut Tokens, what: &str) -> Result<usize, Fault> {
    let size = tokens.count(&format!("rows or columns of {what}"))?;
    match size <= MOST {
        true => Ok(size),
        false => Err(tokens.fault(format!("{size} rows or columns of {what}"), "at most 1e7")),
    }
}

/// Its size again, then column by column.
fn dense(tokens: &mut Tokens, what: &str, matrix: &mut Entries) -> Result<(), Fault> {
    let again = [size(tokens, what)?, size(tokens, what)?];
    if again != [matrix.rows, matrix.columns] {
        let expected = format!("{} by {} as two lines before", matrix.rows, matrix.columns);
        return Err(tokens.fault(format!("{} by {}", again[0], again[1]), &expected));
    }
    let values = tokens.numbers(matrix.rows.saturating_mul(matrix.columns), what)?;
    for (k, value) in values.into_iter().enumerate() {
        matrix.push(tokens, [k % matrix.rows, k / matrix.rows], value)?;
    }
    Ok(())
}

/// Blocks row by row, each column by column.
fn blocks(tokens: &mut Tokens, what: &str, matrix: &mut Entries) -> Result<(), Fault> {
    let count = tokens.count("the number of blocks")?;
    if count == 0 {
        return Ok(());
    }
    let [rows, columns] = [size(tokens, what)?, size(tokens, what)?];
    let row_ends = ends(tokens, rows, matrix.rows)?;
    let column_ends = ends(tokens, columns, matrix.columns)?;
    let [starts, places] = [size(tokens, what)?, size(tokens, what)?];
    if starts == 0 || starts > rows + 1 || places != count {
        let expected = format!("at most {} starts, and columns of {count} blocks", rows + 1);
        return Err(tokens.fault(format!("{starts} starts and {places} columns"), &expected));
    }
    let starts = list(tokens, starts, "starts of block rows")?;
    let places = list(tokens, places, "block columns")?;
    let mut number = 0;
    for (row, range) in starts.windows(2).enumerate() {
        for b in range[0]..range[1] {
            let Some(&column) = places.get(b).filter(|column| **column < columns) else {
                let expected = format!("{count} blocks in {columns} block columns");
                return Err(tokens.fault(format!("block {b}"), &expected));
            };
            let found = tokens.count("the number of a block")?;
            if found != b || b != number {
                return Err(tokens.fault(format!("block {found}"), &format!("block {number}")));
            }
            number += 1;
            for j in start(&column_ends, column)..column_ends[column] {
                for i in start(&row_ends, row)..row_ends[row] {
                    let value = tokens.number(what)?;
                    matrix.push(tokens, [i, j], value)?;
                }
            }
        }
    }
    Ok(())
}

fn start(ends: &[usize], k: usize) -> usize {
    if k == 0 { 0 } else { ends[k - 1] }
}

fn list(tokens: &mut Tokens, count: usize, what: &str) -> Result<Vec<usize>, Fault> {
    if count > tokens.left() {
        let found = format!("{} more words", tokens.left());
        return Err(tokens.fault(found, &format!("{count} {what}")));
    }
    (0..count).map(|_| tokens.count(what)).collect()
}

/// Where block rows or columns end: ascending, the last at the end of the matrix.
fn ends(tokens: &mut Tokens, count: usize, size: usize) -> Result<Vec<usize>, Fault> {
    let ends = list(tokens, count, "ends of block rows or columns")?;
    if ends.is_sorted() && ends.last() == Some(&size) {
        return Ok(ends);
    }
    let expected = format!("ascending ends, the last at {size}");
    Err(tokens.fault("ends of block rows or columns".to_owned(), &expected))
}

/// A title; then triplets `row column : value`, or columns of `row : value`.
fn sparse(tokens: &mut Tokens, what: &str, matrix: &mut Entries) -> Result<(), Fault> {
    tokens.count("the origin of a sparse matrix")?;
    let title = tokens.word("the title of a sparse matrix")?;
    if title != "CSparse" {
        return Err(tokens.fault(format!("`{title}`"), "a title that begins with CSparse"));
    }
    tokens.skip_line();
    let triplet = tokens.peek() == Some("triplet:");
    let mut count = None;
    if triplet {
        tokens.word("triplet:")?;
    }
    tokens.word("the size of a sparse matrix")?;
    let line = loop {
        let word = tokens.word("nnz:")?;
        if word == "nnz:" {
            break tokens.word("the number of entries")?;
        }
    };
    let number = line.trim_end_matches(',');
    count = count.or_else(|| number.parse::<usize>().ok());
    let Some(count) = count else {
        return Err(tokens.fault(format!("`{line}`"), "the number of entries"));
    };
    tokens.skip_line();
    let mut column = 0;
    let mut found = 0;
    while found < count {
        if tokens.peek() == Some("col") {
            tokens.word("col")?;
            column = tokens.count("a column")?;
            tokens.skip_line();
            continue;
        }
        let row = tokens.count("a row of an entry")?;
        if triplet {
            column = tokens.count("a column of an entry")?;
        }
        let colon = tokens.word(":")?;
        if colon != ":" {
            return Err(tokens.fault(format!("`{colon}`"), "`:` and the value of an entry"));
        }
        let value = tokens.number(what)?;
        matrix.push(tokens, [row, column], value)?;
        found += 1;
    }
    // Columns at the end may be empty.
    while tokens.peek() == Some("col") {
        tokens.word("col")?;
        tokens.skip_line();
    }
    Ok(())
}
