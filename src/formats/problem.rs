//! Friction problems as text, in the format of Siconos (`frictionContact_printInFile`), which reads them as they are:
//!
//! ```text
//! 3                            dimension
//! C                            contacts
//! 1  3C  3C                    storage: blocks; rows and columns of W
//! B  C  C                      blocks; rows and columns of blocks
//! 3 6 ... 3C   3 6 ... 3C      where each block row and column ends
//! C+1  B                       lengths of the next two lists
//! starts, columns              of the blocks, row by row
//! b, w11 w21 w31 w12 ...       B times: number of the block, its nine numbers column by column [1/kg]
//! q                            3C numbers, (n, t1, t2) of each contact [m/s]
//! mu                           C numbers
//! # ...                        notes, ignored by readers
//! ```
//!
//! Numbers are the shortest decimals that give the same bits back.

use std::fmt::Write as _;
use std::path::Path;

use super::durable::replace;
use super::error::OutputError;
use crate::problem::friction::FrictionProblem;

/// The text of a problem; each note becomes a line that readers ignore.
#[must_use]
pub fn text(problem: &FrictionProblem, notes: &[String]) -> String {
    let contacts = problem.contacts();
    let mut out = format!("3\n{contacts}\n1\n{0}\n{0}\n", 3 * contacts);
    let blocks = problem.blocks();
    let line = |numbers: &mut dyn Iterator<Item = usize>| -> String {
        let words: Vec<String> = numbers.map(|n| n.to_string()).collect();
        words.join("\t") + "\n"
    };
    let ends = line(&mut (1..=contacts).map(|k| 3 * k));
    out += &format!("{blocks}\n{contacts}\n{contacts}\n{ends}{ends}");
    out += &format!("{}\n{blocks}\n", contacts + 1);
    let mut start = 0;
    let starts = (0..=contacts).map(|k| {
        let here = start;
        start += if k < contacts {
            problem.row(k).len()
        } else {
            0
        };
        here
    });
    out += &line(&mut { starts });
    let columns = (0..contacts).flat_map(|k| problem.row(k).map(|(j, _)| j));
    out += &line(&mut { columns });
    let all = (0..contacts).flat_map(|k| problem.row(k));
    for (b, (_, block)) in all.enumerate() {
        out += &format!("{b}\n");
        // Column by column, as the matrix is kept.
        for w in block {
            let _ = writeln!(out, "{w:e}");
        }
    }
    let numbers = |values: &mut dyn Iterator<Item = f64>| -> String {
        let words: Vec<String> = values.map(|x| format!("{x:e}")).collect();
        words.join(" ") + "\n"
    };
    out += &numbers(&mut problem.free().iter().flat_map(|q| [q.x, q.y, q.z]));
    out += &numbers(&mut problem.friction().iter().copied());
    for note in notes.iter().flat_map(|note| note.lines()) {
        out += &format!("# {note}\n");
    }
    out
}

/// Writes a problem to `path`, whole or not at all.
///
/// # Errors
/// [`OutputError::Io`].
pub fn write(path: &Path, problem: &FrictionProblem, notes: &[String]) -> Result<(), OutputError> {
    replace(path, text(problem, notes).as_bytes())
}
