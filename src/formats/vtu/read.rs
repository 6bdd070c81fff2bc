//! Reads a VTU file as this module writes it: one piece, raw appended data, uncompressed.
//!
//! The lay-out of the header is free, so frames that VTK or ParaView wrote with the same choices are read as well;
//! everything else is refused by name.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use thiserror::Error;

use super::{Array, Grid, Values};
use crate::Vec3;

/// Where the header ends.
const APPENDED: &[u8] = b"<AppendedData encoding=\"raw\">";

/// Why a file is not read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum VtuError {
    /// Not the kind of VTU file that is written here.
    #[error("{what} is {found}, expected {expected}")]
    Form {
        /// Which part of the file.
        what: String,
        /// What it says.
        found: String,
        /// What can be read.
        expected: String,
    },
    /// The header is no XML.
    #[error("the header is no XML: {0}")]
    Xml(String),
    /// A block lies outside the file.
    #[error(
        "array `{array}` ends at byte {end} of the appended data, expected at most {length}: the file is cut short"
    )]
    Short {
        /// The array.
        array: String,
        /// Where it should end.
        end: usize,
        /// Bytes there are.
        length: usize,
    },
}

fn form(
    what: impl Into<String>,
    found: impl Into<String>,
    expected: impl Into<String>,
) -> VtuError {
    VtuError::Form {
        what: what.into(),
        found: found.into(),
        expected: expected.into(),
    }
}

/// The points of a file with their arrays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cloud {
    /// Points \[m\], `[P]`.
    pub points: Vec<Vec3>,
    /// Components per point and values, `[components * P]`, by name.
    arrays: BTreeMap<String, (usize, Vec<f64>)>,
}

impl Cloud {
    /// Array `name` over the points with `N` components each, `[P]`.
    ///
    /// # Errors
    /// [`VtuError::Form`] if there is none, or one with other components.
    pub(crate) fn array<const N: usize>(&self, name: &str) -> Result<Vec<[f64; N]>, VtuError> {
        let what = format!("array `{name}` over the points");
        let expected = format!("{N} components");
        let Some((components, values)) = self.arrays.get(name) else {
            return Err(form(what, "missing", expected));
        };
        if *components != N {
            return Err(form(what, format!("of {components} components"), expected));
        }
        Ok(values.as_chunks().0.to_vec())
    }
}

/// A named array over the points or cells of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its unit; empty where there is none.
    pub unit: String,
    /// Numbers per point or cell.
    pub components: usize,
    /// `[components * P]` or `[components * C]`.
    pub values: Vec<f64>,
}

impl From<&Array> for Field {
    fn from(array: &Array) -> Self {
        Self {
            name: array.name.to_owned(),
            unit: array.unit.to_owned(),
            components: array.components,
            values: match &array.values {
                Values::Real(values) => values.clone(),
                Values::Integer(values) => values.iter().copied().map(f64::from).collect(),
            },
        }
    }
}

/// All that a file of this form holds: a [`Grid`] as it is read back.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contents {
    /// Points \[m\], `[P]`.
    pub points: Vec<Vec3>,
    /// Point indices of all cells one after the other, each less than `P`.
    pub connectivity: Vec<u32>,
    /// Arrays over the points.
    pub point_data: Vec<Field>,
    /// Arrays over the cells.
    pub cell_data: Vec<Field>,
}

impl From<&Grid> for Contents {
    fn from(grid: &Grid) -> Self {
        Self {
            points: grid.points.clone(),
            connectivity: grid.connectivity.clone(),
            point_data: grid.point_data.iter().map(Field::from).collect(),
            cell_data: grid.cell_data.iter().map(Field::from).collect(),
        }
    }
}

/// How an array lies in the file.
struct Block {
    name: String,
    unit: String,
    /// The element of the header that it stands in.
    section: String,
    kind: String,
    components: usize,
    offset: usize,
}

/// Reads the points of a file and the arrays over them; its cells may be of any kind.
///
/// # Errors
/// `VtuError` for anything that is not a whole file of this form.
pub fn decode(file: &[u8]) -> Result<Cloud, VtuError> {
    let (header, data) = split(file)?;
    let (Sizes { points, .. }, blocks) = blocks(header, &["Points", "PointData"])?;
    let mut cloud = Cloud::default();
    for block in blocks {
        let values = values(&block, Some(points), data)?;
        if block.section == "Points" {
            cloud.points = coordinates(&values);
        } else {
            cloud.arrays.insert(block.name, (block.components, values));
        }
    }
    check_points(cloud.points.len(), points)?;
    Ok(cloud)
}

/// Reads a file with its cells, of which all have as many points.
///
/// # Errors
/// `VtuError` for anything that is not a whole file of this form.
pub fn decode_contents(file: &[u8]) -> Result<Contents, VtuError> {
    let (header, data) = split(file)?;
    let sections = ["Points", "Cells", "PointData", "CellData"];
    let (Sizes { points, cells }, blocks) = blocks(header, &sections)?;
    let mut contents = Contents::default();
    for block in blocks {
        let count = match block.section.as_str() {
            "Cells" if block.name == "connectivity" => None,
            "Cells" => continue,
            "CellData" => Some(cells),
            _ => Some(points),
        };
        let values = values(&block, count, data)?;
        match block.section.as_str() {
            "Points" => contents.points = coordinates(&values),
            "Cells" => contents.connectivity = indices(&values, points)?,
            section => {
                let field = Field {
                    name: block.name,
                    unit: block.unit,
                    components: block.components,
                    values,
                };
                match section {
                    "CellData" => contents.cell_data.push(field),
                    _ => contents.point_data.push(field),
                }
            }
        }
    }
    check_points(contents.points.len(), points)?;
    if cells > 0 && !contents.connectivity.len().is_multiple_of(cells) {
        let found = format!("{} long", contents.connectivity.len());
        let expected = format!("as many points for each of {cells} cells");
        return Err(form("the array `connectivity`", found, expected));
    }
    Ok(contents)
}

/// Header and appended data.
fn split(file: &[u8]) -> Result<(&str, &[u8]), VtuError> {
    let expected = "`<AppendedData encoding=\"raw\">`: the spheres frame of a run";
    let at = file.windows(APPENDED.len()).position(|w| w == APPENDED);
    let (header, rest) = at
        .map(|at| (&file[..at], &file[at + APPENDED.len()..]))
        .ok_or_else(|| form("the data", "elsewhere", expected))?;
    let data = rest
        .trim_ascii_start()
        .strip_prefix(b"_")
        .ok_or_else(|| form("the start of the data", "damaged", "`_`"))?;
    let header = std::str::from_utf8(header).map_err(|e| VtuError::Xml(e.to_string()))?;
    Ok((header, data))
}

fn coordinates(values: &[f64]) -> Vec<Vec3> {
    values
        .as_chunks()
        .0
        .iter()
        .map(|c| Vec3::from(*c))
        .collect()
}

fn check_points(found: usize, expected: usize) -> Result<(), VtuError> {
    if found == expected {
        return Ok(());
    }
    let found = format!("of {found} points");
    let expected = format!("{expected} points");
    Err(form("the array of the points", found, expected))
}

/// Point indices, each below `points`.
fn indices(values: &[f64], points: usize) -> Result<Vec<u32>, VtuError> {
    let index = |value: &f64| {
        let inside = (0.0..points as f64).contains(value);
        let expected = format!("a point below {points}");
        let refused = || form("an entry of `connectivity`", value.to_string(), expected);
        inside.then_some(*value as u32).ok_or_else(refused)
    };
    values.iter().map(index).collect()
}

/// Numbers of points and cells.
struct Sizes {
    points: usize,
    cells: usize,
}

/// How large the piece is, and its arrays in those sections that are `wanted`.
fn blocks(header: &str, wanted: &[&str]) -> Result<(Sizes, Vec<Block>), VtuError> {
    let xml = |error: quick_xml::Error| VtuError::Xml(error.to_string());
    let mut reader = Reader::from_str(header);
    let (mut sizes, mut section) = (None, String::new());
    let mut blocks: Vec<Block> = Vec::new();
    let mut labelled = false;
    loop {
        let (tag, open) = match reader.read_event().map_err(xml)? {
            Event::Start(tag) => (tag, true),
            Event::Empty(tag) => (tag, false),
            Event::Text(text) if std::mem::take(&mut labelled) => {
                if let Some(block) = blocks.last_mut() {
                    (*text).clone_into(&mut block.unit);
                }
                continue;
            }
            Event::Eof => break,
            _ => continue,
        };
        match tag.name().as_ref() {
            "VTKFile" => check_kind(&tag)?,
            "Piece" => {
                if sizes.is_some() {
                    return Err(form("the file", "of several pieces", "one piece"));
                }
                sizes = Some(Sizes {
                    points: number(&tag, "NumberOfPoints", None)?,
                    cells: number(&tag, "NumberOfCells", Some(0))?,
                });
            }
            "DataArray" if wanted.contains(&section.as_str()) => {
                let kind = attribute(&tag, "type")?.unwrap_or_default();
                let name = attribute(&tag, "Name")?.unwrap_or_default();
                let place = attribute(&tag, "format")?.unwrap_or_default();
                if place != "appended" {
                    let what = format!("the format of array `{name}`");
                    return Err(form(what, format!("`{place}`"), "`appended`"));
                }
                blocks.push(Block {
                    section: section.clone(),
                    unit: String::new(),
                    components: number(&tag, "NumberOfComponents", Some(1))?,
                    offset: number(&tag, "offset", None)?,
                    kind,
                    name,
                });
            }
            "InformationKey" => {
                let key = attribute(&tag, "name")?;
                labelled = open
                    && wanted.contains(&section.as_str())
                    && key.as_deref() == Some("UNITS_LABEL");
            }
            "DataArray" => {}
            name if open => name.clone_into(&mut section),
            _ => {}
        }
    }
    let sizes = sizes.ok_or_else(|| form("the file", "without a piece", "one piece"))?;
    Ok((sizes, blocks))
}

fn check_kind(tag: &BytesStart<'_>) -> Result<(), VtuError> {
    for (key, expected) in [
        ("type", "UnstructuredGrid"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
    ] {
        let found = attribute(tag, key)?.unwrap_or_default();
        if found != expected {
            let what = format!("`{key}` of the file");
            return Err(form(what, format!("`{found}`"), format!("`{expected}`")));
        }
    }
    match attribute(tag, "compressor")? {
        Some(found) => Err(form("the compressor", format!("`{found}`"), "none")),
        None => Ok(()),
    }
}

fn attribute(tag: &BytesStart<'_>, key: &str) -> Result<Option<String>, VtuError> {
    let found = tag.try_get_attribute(key);
    let found = found.map_err(|error| VtuError::Xml(error.to_string()))?;
    Ok(found.map(|a| a.value.into_owned()))
}

fn number(tag: &BytesStart<'_>, key: &str, default: Option<usize>) -> Result<usize, VtuError> {
    let text = attribute(tag, key)?;
    let value = text.as_ref().map_or(default, |text| text.parse().ok());
    value.ok_or_else(|| {
        let found = text.map_or("missing".to_owned(), |text| format!("`{text}`"));
        form(format!("`{key}` of a tag"), found, "a whole number")
    })
}

/// The values of a block: its length in bytes, then as many; over `count` points or cells, or as many as there are.
fn values(block: &Block, count: Option<usize>, data: &[u8]) -> Result<Vec<f64>, VtuError> {
    let size = match block.kind.as_str() {
        "Float32" | "Int32" => 4,
        "Float64" | "Int64" => 8,
        other => {
            let what = format!("the type of array `{}`", block.name);
            return Err(form(
                what,
                format!("`{other}`"),
                "Float32, Float64, Int32 or Int64",
            ));
        }
    };
    let short = |end: usize| VtuError::Short {
        array: block.name.clone(),
        end,
        length: data.len(),
    };
    let start = block.offset.saturating_add(8);
    let rest = data.get(block.offset..).unwrap_or_default();
    let (length, rest) = rest.split_first_chunk().ok_or_else(|| short(start))?;
    let length = u64::from_le_bytes(*length);
    let expected = match count {
        Some(count) => count.saturating_mul(block.components).saturating_mul(size),
        None => usize::try_from(length).unwrap_or(usize::MAX),
    };
    if length != expected as u64 || !expected.is_multiple_of(size) {
        let what = format!("array `{}`", block.name);
        return Err(form(
            what,
            format!("{length} bytes long"),
            format!("{expected} bytes"),
        ));
    }
    let bytes = rest
        .get(..expected)
        .ok_or_else(|| short(start.saturating_add(expected)))?;
    Ok(match block.kind.as_str() {
        "Float64" => bytes
            .as_chunks()
            .0
            .iter()
            .map(|b| f64::from_le_bytes(*b))
            .collect(),
        "Int64" => {
            let integers = bytes.as_chunks().0.iter().map(|b| i64::from_le_bytes(*b));
            integers.map(|value| value as f64).collect()
        }
        "Float32" => {
            let singles = bytes.as_chunks().0.iter().map(|b| f32::from_le_bytes(*b));
            singles.map(f64::from).collect()
        }
        _ => {
            let integers = bytes.as_chunks().0.iter().map(|b| i32::from_le_bytes(*b));
            integers.map(f64::from).collect()
        }
    })
}
