//! Structure of the VTU files, and what is refused.

use sphere_dda::Vec3;
use sphere_dda::formats::error::OutputError;
use sphere_dda::formats::vtu::{Array, Cell, Grid, Precision, encode};

/// Walks the blocks of a VTU file as meshio does: no gaps, every offset a tag's, the newline at the end.
pub(crate) fn check_blocks(bytes: &[u8]) {
    let start = b"<AppendedData encoding=\"raw\">_";
    let end = b"\n</AppendedData>\n</VTKFile>\n";
    let from = bytes.windows(start.len()).position(|w| w == start).unwrap() + start.len();
    assert!(bytes.ends_with(end));
    let header = std::str::from_utf8(&bytes[..from]).unwrap();
    let offsets: Vec<usize> = header
        .split("offset=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap().parse().unwrap())
        .collect();
    let data = &bytes[from..bytes.len() - end.len()];
    let (mut at, mut walked) = (0, Vec::new());
    while at < data.len() {
        walked.push(at);
        at += 8 + u64::from_le_bytes(data[at..at + 8].try_into().unwrap()) as usize;
    }
    assert_eq!(at, data.len());
    walked.reverse();
    assert_eq!(offsets, walked, "blocks in reverse order of the tags");
}

fn grid(points: usize) -> Grid {
    Grid {
        points: vec![Vec3::new(1.0, 2.0, 3.0); points],
        cell: Cell::Vertex,
        connectivity: (0..points as u32).collect(),
        point_data: vec![
            Array::scalar("a", "m", (0..points).map(|i| i as f64)),
            Array::vector("b", "", vec![Vec3::x(); points]),
        ],
        cell_data: vec![Array::integer("c", 0..points as i32)],
    }
}

#[test]
fn blocks_follow_each_other_without_gaps() {
    for points in [1, 2, 7] {
        for precision in [Precision::Single, Precision::Double] {
            check_blocks(&encode(&grid(points), 0.25, precision, "x").unwrap());
        }
    }
}

#[test]
fn values_that_readers_would_swallow_are_refused() {
    for (value, precision) in [
        (f64::NAN, Precision::Single),
        (f64::NAN, Precision::Double),
        (f64::INFINITY, Precision::Double),
        (1e39, Precision::Single),
    ] {
        let mut broken = grid(3);
        broken.point_data[0] = Array::scalar("a", "m", [0.0, value, 0.0]);
        let error = encode(&broken, 0.0, precision, "x.vtu").unwrap_err();
        assert!(
            matches!(error, OutputError::NotFinite { index: 1, .. }),
            "{error}"
        );
        assert!(error.to_string().contains("`a`"), "{error}");
    }
    let mut broken = grid(1);
    broken.points[0].y = f64::NAN;
    assert!(encode(&broken, 0.0, Precision::Single, "x").is_err());
    assert!(encode(&grid(1), f64::NAN, Precision::Single, "x").is_err());
}

#[test]
fn grids_that_do_not_fit_are_refused() {
    let refused = |grid: &Grid| encode(grid, 0.0, Precision::Single, "x").unwrap_err();
    assert!(matches!(refused(&grid(0)), OutputError::Empty { .. }));
    let mut short = grid(3);
    short.point_data[1] = Array::vector("b", "", vec![Vec3::x(); 2]);
    assert!(matches!(
        refused(&short),
        OutputError::Shape {
            found: 6,
            expected: 9,
            ..
        }
    ));
    let mut dangling = grid(3);
    dangling.connectivity[2] = 3;
    assert!(matches!(refused(&dangling), OutputError::Shape { .. }));
    let mut torn = grid(3);
    torn.cell = Cell::Line;
    assert!(matches!(refused(&torn), OutputError::Shape { .. }));
}
