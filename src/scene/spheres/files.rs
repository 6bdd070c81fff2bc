//! Spheres from files: tables, frames of results, checkpoints.

use super::Start;
use crate::Vec3;
use crate::scene::columns::Columns;
use crate::scene::document::Document;

const COLUMNS: [&str; 10] = ["x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz"];

/// The rows of a table, with their radii if it has such a column.
pub(super) fn csv(
    document: &mut Document<'_>,
    path: &str,
    name: &str,
    content: &[u8],
) -> Option<(Vec<Start>, Option<Vec<f64>>)> {
    let table = Columns::read(document, path, name, content, &COLUMNS, 3)?;
    let starts = table.rows.iter().map(|row| {
        let value = |k: usize| row[k].unwrap_or(0.0);
        let vector = |k: usize| Vec3::new(value(k), value(k + 1), value(k + 2));
        Start {
            velocity: vector(4),
            spin: vector(7),
            ..Start::at(vector(0))
        }
    });
    let radii: Option<Vec<f64>> = table.rows.iter().map(|row| row[3]).collect();
    let mut good = true;
    for (radius, line) in radii.iter().flatten().zip(&table.lines) {
        if *radius <= 0.0 {
            let found = format!("{radius} in `{name}` line {line}, column `radius`");
            good = document.demand(false, path, found, "a radius > 0 [m]");
        }
    }
    good.then(|| (starts.collect(), radii))
}
