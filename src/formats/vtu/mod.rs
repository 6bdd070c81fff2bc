//! VTU files (VTK XML unstructured grids) that ParaView, VTK and meshio all read whole.
//!
//! One piece, one cell type, raw appended data, uncompressed, little endian, `UInt64` block headers:
//!
//! ```text
//! <VTKFile ..><UnstructuredGrid><FieldData/><Piece><Points/><Cells/><PointData/><CellData/></Piece></UnstructuredGrid>
//! <AppendedData encoding="raw">_[length, bytes][length, bytes]...\n</AppendedData></VTKFile>
//! ```
//!
//! Three readers' habits shape the bytes. meshio cuts the appended data at its last newline, so one is
//! written before the end tag. meshio walks the blocks without gaps, so there are none. meshio replaces the
//! offsets one by one and looks the next one up among replaced and unreplaced alike, first match in document
//! order; so the blocks are stored in **reverse** order of their tags: the unreplaced one then comes first.
//!
//! Source: VTK file formats, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

mod read;

use std::fmt::Write as _;

pub(crate) use read::Cloud;
pub use read::{Contents, Field, VtuError, decode, decode_contents};

use super::error::OutputError;
use crate::Vec3;

/// Cell type of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cell {
    /// `VTK_VERTEX`: one point.
    Vertex,
    /// `VTK_LINE`: two points.
    Line,
    /// `VTK_TRIANGLE`: three points.
    Triangle,
}

impl Cell {
    /// Points of one cell.
    pub(crate) fn points(self) -> usize {
        match self {
            Self::Vertex => 1,
            Self::Line => 2,
            Self::Triangle => 3,
        }
    }

    /// VTK's number of the type.
    fn code(self) -> u8 {
        match self {
            Self::Vertex => 1,
            Self::Line => 3,
            Self::Triangle => 5,
        }
    }
}

/// Entries of an array, components innermost.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Written as Float32 or Float64, see [`Precision`].
    Real(Vec<f64>),
    /// Written as Int32.
    Integer(Vec<i32>),
}

/// A named array over the points or cells of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// Name shown by readers.
    pub name: &'static str,
    /// Unit, as the information key `UNITS_LABEL` of VTK; empty where there is none.
    pub unit: &'static str,
    /// Components per point or cell: 1, 3 (vector) or 4 (quaternion w, x, y, z).
    pub components: usize,
    /// `[components * points]` or `[components * cells]`.
    pub values: Values,
}

impl Array {
    /// One real number per entry.
    #[must_use]
    pub fn scalar(
        name: &'static str,
        unit: &'static str,
        values: impl IntoIterator<Item = f64>,
    ) -> Self {
        Self {
            name,
            unit,
            components: 1,
            values: Values::Real(values.into_iter().collect()),
        }
    }

    /// One vector per entry.
    #[must_use]
    pub fn vector(
        name: &'static str,
        unit: &'static str,
        values: impl IntoIterator<Item = Vec3>,
    ) -> Self {
        Self {
            name,
            unit,
            components: 3,
            values: Values::Real(values.into_iter().flat_map(<[f64; 3]>::from).collect()),
        }
    }

    /// One integer per entry.
    #[must_use]
    pub fn integer(name: &'static str, values: impl IntoIterator<Item = i32>) -> Self {
        Self {
            name,
            unit: "",
            components: 1,
            values: Values::Integer(values.into_iter().collect()),
        }
    }

    /// Number of entries, components counted singly.
    fn len(&self) -> usize {
        match &self.values {
            Values::Real(values) => values.len(),
            Values::Integer(values) => values.len(),
        }
    }
}

/// An unstructured grid of cells of one type.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Points \[m\], `[P]`.
    pub points: Vec<Vec3>,
    /// Type of every cell.
    pub cell: Cell,
    /// Point indices, `[C * cell.points()]`.
    pub connectivity: Vec<u32>,
    /// Arrays over the points.
    pub point_data: Vec<Array>,
    /// Arrays over the cells.
    pub cell_data: Vec<Array>,
}

impl Grid {
    /// Number of cells `C`.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.connectivity.len() / self.cell.points()
    }
}

/// Precision of coordinates and real arrays; the time is always Float64.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// Float32: enough to look at, half the size.
    #[default]
    Single,
    /// Float64: the solver's own numbers.
    Double,
}

/// The bytes of a VTU file of `grid` at `time` \[s\]. `place` names the file in errors.
///
/// # Errors
/// [`OutputError::Empty`], [`OutputError::Shape`], [`OutputError::NotFinite`].
pub fn encode(
    grid: &Grid,
    time: f64,
    precision: Precision,
    place: &str,
) -> Result<Vec<u8>, OutputError> {
    check_shape(grid, place)?;
    let cells = grid.cells();
    let size = grid.cell.points();
    let mut document = Document {
        place,
        precision,
        tags: Vec::new(),
    };

    document.section("<FieldData>");
    document.reals("TimeValue", None, std::iter::once(time), Precision::Double)?;
    document.unit("s");
    document.section("</FieldData>");
    document.section(&format!(
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">\n<Points>",
        grid.points.len()
    ));
    let coordinates = grid.points.iter().flat_map(|p| <[f64; 3]>::from(*p));
    document.reals("Points", Some(3), coordinates, precision)?;
    document.unit("m");
    document.section("</Points>\n<Cells>");
    let connectivity = grid.connectivity.iter().map(|&i| i64::from(i));
    document.block(
        "Int64",
        "connectivity",
        Some(1),
        little_endian(connectivity),
    );
    let ends = (1..=cells).map(|cell| (cell * size) as i64);
    document.block("Int64", "offsets", Some(1), little_endian(ends));
    document.block("UInt8", "types", Some(1), vec![grid.cell.code(); cells]);
    document.section("</Cells>\n<PointData>");
    for array in &grid.point_data {
        document.array(array)?;
    }
    document.section("</PointData>\n<CellData>");
    for array in &grid.cell_data {
        document.array(array)?;
    }
    document.section("</CellData>\n</Piece>");
    Ok(document.finish())
}

/// Refuses grids whose arrays do not fit.
fn check_shape(grid: &Grid, place: &str) -> Result<(), OutputError> {
    let cells = grid.cells();
    if cells == 0 {
        return Err(OutputError::Empty {
            place: place.to_owned(),
        });
    }
    let fits = |array: &str, found: usize, expected: usize| {
        if found == expected {
            Ok(())
        } else {
            Err(OutputError::Shape {
                place: place.to_owned(),
                array: array.to_owned(),
                found,
                expected,
            })
        }
    };
    fits(
        "connectivity",
        grid.connectivity.len(),
        cells * grid.cell.points(),
    )?;
    if let Some(&last) = grid.connectivity.iter().max()
        && last as usize >= grid.points.len()
    {
        fits("points", grid.points.len(), last as usize + 1)?;
    }
    for (arrays, count) in [
        (&grid.point_data, grid.points.len()),
        (&grid.cell_data, cells),
    ] {
        for array in arrays {
            fits(array.name, array.len(), array.components * count)?;
        }
    }
    Ok(())
}

/// A piece of the header: plain text, or an array tag with its block.
enum Tag {
    Text(String),
    Block {
        head: String,
        unit: &'static str,
        bytes: Vec<u8>,
    },
}

/// A file being put together.
struct Document<'a> {
    place: &'a str,
    precision: Precision,
    tags: Vec<Tag>,
}

impl Document<'_> {
    fn section(&mut self, text: &str) {
        self.tags.push(Tag::Text(format!("{text}\n")));
    }

    /// An array tag; without `components` it is field data, one tuple.
    fn block(&mut self, kind: &str, name: &str, components: Option<usize>, bytes: Vec<u8>) {
        let shape = match components {
            None => " NumberOfTuples=\"1\"".to_owned(),
            // Left out where it is the default: with it meshio makes scalars columns of a matrix.
            Some(1) => String::new(),
            Some(components) => format!(" NumberOfComponents=\"{components}\""),
        };
        let head = format!("<DataArray type=\"{kind}\" Name=\"{name}\"{shape} format=\"appended\"");
        let unit = "";
        self.tags.push(Tag::Block { head, unit, bytes });
    }

    /// Says in what unit the last array is.
    fn unit(&mut self, label: &'static str) {
        if let Some(Tag::Block { unit, .. }) = self.tags.last_mut() {
            *unit = label;
        }
    }

    fn reals(
        &mut self,
        name: &str,
        components: Option<usize>,
        values: impl Iterator<Item = f64>,
        precision: Precision,
    ) -> Result<(), OutputError> {
        let mut bytes = Vec::with_capacity(8 * values.size_hint().0);
        for (index, value) in values.enumerate() {
            let single = value as f32;
            let finite = match precision {
                Precision::Single => single.is_finite(),
                Precision::Double => value.is_finite(),
            };
            if !finite {
                return Err(OutputError::NotFinite {
                    place: self.place.to_owned(),
                    array: name.to_owned(),
                    index,
                    value,
                });
            }
            match precision {
                Precision::Single => bytes.extend_from_slice(&single.to_le_bytes()),
                Precision::Double => bytes.extend_from_slice(&value.to_le_bytes()),
            }
        }
        let kind = match precision {
            Precision::Single => "Float32",
            Precision::Double => "Float64",
        };
        self.block(kind, name, components, bytes);
        Ok(())
    }

    fn array(&mut self, array: &Array) -> Result<(), OutputError> {
        let components = Some(array.components);
        match &array.values {
            Values::Real(values) => {
                let values = values.iter().copied();
                self.reals(array.name, components, values, self.precision)?;
            }
            Values::Integer(values) => {
                let bytes = values.iter().flat_map(|v| v.to_le_bytes()).collect();
                self.block("Int32", array.name, components, bytes);
            }
        }
        self.unit(array.unit);
        Ok(())
    }

    /// Header with offsets, then the blocks in reverse order of their tags.
    fn finish(self) -> Vec<u8> {
        let block = |tag: &Tag| match tag {
            Tag::Text(_) => 0,
            Tag::Block { bytes, .. } => 8 + bytes.len(),
        };
        let total: usize = self.tags.iter().map(block).sum();
        let mut offset = total;
        let mut header = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
             byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
        );
        for tag in &self.tags {
            match tag {
                Tag::Text(text) => header.push_str(text),
                Tag::Block { head, unit, .. } => {
                    offset -= block(tag);
                    let end = match *unit {
                        "" => "/>".to_owned(),
                        unit => format!(
                            "><InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey></DataArray>"
                        ),
                    };
                    // Writing to a String cannot fail.
                    let _ = writeln!(header, "{head} offset=\"{offset}\"{end}");
                }
            }
        }
        header.push_str("</UnstructuredGrid>\n<AppendedData encoding=\"raw\">_");
        let mut file = header.into_bytes();
        file.reserve(total + 64);
        for tag in self.tags.iter().rev() {
            if let Tag::Block { bytes, .. } = tag {
                file.extend_from_slice(&(bytes.len() as u64).to_le_bytes());
                file.extend_from_slice(bytes);
            }
        }
        file.extend_from_slice(b"\n</AppendedData>\n</VTKFile>\n");
        file
    }
}

fn little_endian(values: impl Iterator<Item = i64>) -> Vec<u8> {
    values.flat_map(i64::to_le_bytes).collect()
}
