//! Height fields: reading ESRI ASCII grids, and the triangles between their nodes.
//!
//! ```text
//! ncols 120            columns of cells, west to east
//! nrows 80             rows of cells, the first one in the north
//! xllcorner 5000000    western border [m], or xllcenter: centre of the westernmost cells
//! yllcorner 400000     southern border [m], or yllcenter
//! cellsize 1           width and depth of a cell [m], or dx and dy
//! NODATA_value -9999   what stands where nothing is known; -9999 if left out
//! 12.5 12.7 ...        ncols x nrows heights [m]
//! ```
//! A value is the height at the centre of its cell. Four neighbouring centres make a square of two triangles; a square
//! with an unknown corner is left out.
//!
//! Source of the format: Esri, *ArcGIS: Esri ASCII raster format*; `dx` and `dy` as GDAL writes them.

use thiserror::Error;

use super::facets::Facets;
use crate::Vec3;

/// Most problems reported for one file.
const MOST_PROBLEMS: usize = 10;
/// Most nodes: six features each must be countable with 32 bits.
const MOST_NODES: usize = 100_000_000;
/// Largest magnitude of a number: beyond it products of a few of them stop being finite.
const LARGEST: f64 = 1e30;
const KEYS: &str = "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize or dx and dy, NODATA_value";

/// What is wrong with a grid file, and where.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("line {line}: found {found}, expected {expected}")]
pub struct GridProblem {
    /// Line, counted from 1.
    pub line: usize,
    /// What stands there.
    pub found: String,
    /// What should stand there.
    pub expected: String,
}

/// Heights at the nodes of a regular grid.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightField {
    /// Nodes from west to east.
    columns: usize,
    /// Nodes from south to north.
    rows: usize,
    /// x and y of the south-western node \[m\].
    origin: [f64; 2],
    /// Distance of the nodes along x and y \[m\].
    spacing: [f64; 2],
    /// Heights \[m\], west to east, rows from north to south as in the file; NaN where unknown.
    heights: Vec<f64>,
}

impl HeightField {
    /// Reads the bytes of an ESRI ASCII grid. Keys in any case and order; numbers separated by any white space.
    ///
    /// # Errors
    /// Every problem of the header, or else the first ten of the values.
    pub fn esri_ascii(bytes: &[u8]) -> Result<Self, Vec<GridProblem>> {
        let text = std::str::from_utf8(bytes).map_err(|e| {
            let before = &bytes[..e.valid_up_to()];
            vec![GridProblem {
                line: 1 + before.iter().filter(|&&b| b == b'\n').count(),
                found: "bytes that are not text".into(),
                expected: "an ESRI ASCII grid: convert rasters of other formats".into(),
            }]
        })?;
        let text = text.trim_start_matches('\u{feff}');
        let mut header = Header::default();
        let first = header.read(text);
        let field = header.field()?;
        field.with_values(text, first, header.unknown())
    }

    /// Height at the node `column` from the west and `row` from the south \[m\]; `None` where it is unknown or there
    /// is no such node.
    #[must_use]
    pub fn height(&self, column: usize, row: usize) -> Option<f64> {
        if column >= self.columns || row >= self.rows {
            return None;
        }
        Some(self.heights[(self.rows - 1 - row) * self.columns + column]).filter(|z| !z.is_nan())
    }

    /// The triangles, with every coordinate multiplied by its `scale` and then moved by `translation` \[m\].
    ///
    /// A square is cut along the diagonal on which the heights run straighter, the nodes beyond its ends included: that
    /// follows ridges and valleys, where a fixed choice puts a dam or a notch into every square. Without these nodes
    /// the lower diagonal is taken.
    /// Map coordinates are moved before the extent of the grid is added: they may be large without loss.
    #[must_use]
    pub fn facets(&self, name: impl Into<String>, scale: [f64; 3], translation: Vec3) -> Facets {
        let at = |k: usize, axis: usize| {
            self.origin[axis] * scale[axis]
                + translation[axis]
                + k as f64 * (self.spacing[axis] * scale[axis])
        };
        const NONE: u32 = u32::MAX;
        let mut vertices: Vec<Vec3> = Vec::new();
        let mut index = vec![NONE; self.columns * self.rows];
        let mut triangles = Vec::new();
        for row in 0..self.rows - 1 {
            for column in 0..self.columns - 1 {
                let nodes = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, j]| [column + i, row + j]);
                let heights = nodes.map(|[i, j]| self.height(i, j));
                let [Some(a), Some(b), Some(c), Some(d)] = heights else {
                    continue;
                };
                let mut corners = [a, b, c, d].into_iter().zip(nodes).map(|(z, [i, j])| {
                    let slot = &mut index[j * self.columns + i];
                    if *slot == NONE {
                        *slot = vertices.len() as u32;
                        let z = z * scale[2] + translation.z;
                        vertices.push(Vec3::new(at(i, 0), at(j, 1), z));
                    }
                    *slot
                });
                let square: [u32; 4] = std::array::from_fn(|_| corners.next().unwrap_or(NONE));
                let [p, q, r, s] = square;
                triangles.extend(if self.is_straighter_rising(column, row) {
                    [[p, q, r], [p, r, s]]
                } else {
                    [[p, q, s], [q, r, s]]
                });
            }
        }
        Facets {
            computed: true,
            ..Facets::mesh(name, vertices, triangles)
        }
    }

    /// Whether the heights run straighter along the diagonal from south-west to north-east of the square whose
    /// south-western node is given than along its other one: smaller second differences at its two ends.
    fn is_straighter_rising(&self, column: usize, row: usize) -> bool {
        // Counted from the node before the square; one that is off the grid wraps to a number that is too large.
        let z = |i: usize, j: usize| {
            self.height((column + i).wrapping_sub(1), (row + j).wrapping_sub(1))
        };
        let run = |line: [Option<f64>; 4]| {
            let ends = [[line[0], line[1], line[2]], [line[1], line[2], line[3]]];
            let kinks = ends.map(|[a, b, c]| Some((a? - 2.0 * b? + c?).abs()));
            let [first, second] = kinks;
            match (first, second) {
                (Some(first), Some(second)) => Some(0.5 * (first + second)),
                _ => first.or(second),
            }
        };
        let rising = [z(0, 0), z(1, 1), z(2, 2), z(3, 3)];
        let falling = [z(0, 3), z(1, 2), z(2, 1), z(3, 0)];
        match (run(rising), run(falling)) {
            (Some(r), Some(f)) if r != f => r < f,
            _ => {
                let middle = |line: [Option<f64>; 4]| line[1].zip(line[2]).map(|(a, b)| a + b);
                middle(rising) <= middle(falling)
            }
        }
    }

    /// Fills in the values, which begin on line `first`.
    fn with_values(
        mut self,
        text: &str,
        first: usize,
        unknown: f64,
    ) -> Result<Self, Vec<GridProblem>> {
        let wanted = self.columns * self.rows;
        let all = format!(
            "ncols x nrows = {} x {} = {wanted} heights",
            self.columns, self.rows
        );
        let mut problems = Vec::new();
        let mut count = 0;
        // The file's size bounds the memory, whatever its header promises.
        self.heights.reserve(wanted.min(text.len()));
        for (k, line) in text.lines().enumerate().skip(first - 1) {
            for word in line.split_whitespace() {
                count += 1;
                let value = word.parse().unwrap_or(f64::INFINITY);
                let is_known = value != unknown && !(value.is_nan() && unknown.is_nan());
                let height = if is_known { value } else { f64::NAN };
                if is_known && !fits(value) && problems.len() < MOST_PROBLEMS {
                    problems.push(GridProblem {
                        line: k + 1,
                        found: format!("`{word}`"),
                        expected: "a height in metres with a decimal point, or NODATA_value".into(),
                    });
                }
                if count == wanted + 1 {
                    problems.push(GridProblem {
                        line: k + 1,
                        found: format!("more heights, from `{word}` on"),
                        expected: format!("no more than {all}: correct ncols and nrows"),
                    });
                }
                if count <= wanted {
                    self.heights.push(height);
                }
            }
        }
        if count < wanted {
            problems.push(GridProblem {
                line: text.lines().count().max(1),
                found: format!("the end after {count} heights"),
                expected: format!("{all}: correct ncols and nrows, or copy the file again"),
            });
        }
        if problems.is_empty() {
            Ok(self)
        } else {
            Err(problems)
        }
    }
}

/// A number of the header, and the line it stands on.
type Entry = Option<(f64, usize)>;

/// The header as read.
#[derive(Default)]
struct Header {
    counts: [Entry; 2],
    /// Lower left corner or centre of the lower left cell, along x and y.
    corner: [Entry; 2],
    centre: [Entry; 2],
    size: Entry,
    sizes: [Entry; 2],
    unknown: Entry,
    problems: Vec<GridProblem>,
}

fn fits(x: f64) -> bool {
    x.abs() <= LARGEST
}

impl Header {
    /// Reads lines until one does not begin with a word; returns that line's number.
    fn read(&mut self, text: &str) -> usize {
        for (k, line) in text.lines().enumerate() {
            let line_number = k + 1;
            let mut words = line.split_whitespace();
            let Some(key) = words.next() else { continue };
            if !key.starts_with(char::is_alphabetic) || key.parse::<f64>().is_ok() {
                return line_number;
            }
            let lower = key.to_ascii_lowercase();
            let slot = match lower.as_str() {
                "ncols" => &mut self.counts[0],
                "nrows" => &mut self.counts[1],
                "xllcorner" => &mut self.corner[0],
                "yllcorner" => &mut self.corner[1],
                "xllcenter" => &mut self.centre[0],
                "yllcenter" => &mut self.centre[1],
                "cellsize" => &mut self.size,
                "dx" => &mut self.sizes[0],
                "dy" => &mut self.sizes[1],
                "nodata_value" => &mut self.unknown,
                _ => {
                    let shown: String = key.chars().take(40).collect();
                    self.refuse(line_number, format!("`{shown}`"), KEYS);
                    if self.problems.len() >= MOST_PROBLEMS {
                        return line_number;
                    }
                    continue;
                }
            };
            let value = words.next().unwrap_or("nothing");
            let number = value.parse::<f64>().ok();
            let good = number.filter(|x| fits(*x) || (lower == "nodata_value" && x.is_nan()));
            if slot.is_some() {
                self.refuse(line_number, format!("`{key}` again"), "each key once");
            } else if let (Some(number), None) = (good, words.next()) {
                *slot = Some((number, line_number));
            } else {
                // Present, though wrong: it is not reported as missing too.
                *slot = Some((2.0, line_number));
                let found = format!("`{}`", line.trim());
                self.refuse(line_number, found, "the key and one number, at most 1e30");
            }
        }
        text.lines().count() + 1
    }

    fn refuse(&mut self, line: usize, found: String, expected: impl Into<String>) {
        self.problems.push(GridProblem {
            line,
            found,
            expected: expected.into(),
        });
    }

    fn unknown(&self) -> f64 {
        self.unknown.map_or(-9999.0, |(value, _)| value)
    }

    /// A grid without its values.
    fn field(&mut self) -> Result<HeightField, Vec<GridProblem>> {
        let mut missing = Vec::new();
        for (entry, key) in [(self.counts[0], "ncols"), (self.counts[1], "nrows")] {
            match entry {
                None => missing.push(key),
                Some((n, line)) if n.fract() != 0.0 || n < 2.0 || n > MOST_NODES as f64 => {
                    let expected = format!("a whole number from 2 to {MOST_NODES}");
                    self.refuse(line, format!("{key} {n}"), expected);
                }
                Some(_) => {}
            }
        }
        if self.sizes.iter().all(Option::is_none) {
            self.sizes = [self.size; 2];
        } else if let Some((_, line)) = self.size {
            self.refuse(
                line,
                "cellsize together with dx or dy".into(),
                "one of the two",
            );
        }
        for axis in [0, 1] {
            match self.sizes[axis] {
                None => missing.push(["cellsize or dx", "cellsize or dy"][axis]),
                Some((size, line)) if size <= 0.0 => {
                    self.refuse(line, format!("a cell of {size}"), "a size > 0");
                }
                Some(_) => {}
            }
            match (self.corner[axis], self.centre[axis]) {
                (None, None) => {
                    missing.push(["xllcorner or xllcenter", "yllcorner or yllcenter"][axis]);
                }
                (Some(_), Some((_, line))) => {
                    let found = format!("{}llcenter together with {0}llcorner", ["x", "y"][axis]);
                    self.refuse(line, found, "one of the two");
                }
                _ => {}
            }
        }
        if !missing.is_empty() {
            let found = format!("a header without {}", missing.join(", "));
            self.refuse(1, found, format!("an ESRI ASCII grid: {KEYS}"));
        }
        let [columns, rows] = self
            .counts
            .map(|entry| entry.map_or(2.0, |(n, _)| n) as usize);
        if self.problems.is_empty() && columns.saturating_mul(rows) > MOST_NODES {
            let line = self.counts[1].map_or(1, |(_, line)| line);
            let found = format!("{columns} x {rows} cells");
            let expected = format!("at most {MOST_NODES}: cut or coarsen the grid");
            self.refuse(line, found, expected);
        }
        if !self.problems.is_empty() {
            return Err(std::mem::take(&mut self.problems));
        }
        let spacing = self.sizes.map(|entry| entry.map_or(1.0, |(size, _)| size));
        let origin = std::array::from_fn(|axis| {
            let centre = self.centre[axis].map(|(x, _)| x);
            let corner = self.corner[axis].map(|(x, _)| x + 0.5 * spacing[axis]);
            centre.or(corner).unwrap_or(0.0)
        });
        Ok(HeightField {
            columns,
            rows,
            origin,
            spacing,
            heights: Vec::new(),
        })
    }
}
