//! Reads the points of a VTU file as this module writes it: one piece, raw appended data, uncompressed.
//!
//! The lay-out of the header is free, so frames that VTK or ParaView wrote with the same choices are read as well;
//! everything else is refused by name.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use thiserror::Error;

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

/// How an array lies in the file.
struct Block {
    name: String,
    /// Of the points themselves instead of over them.
    coordinates: bool,
    kind: String,
    components: usize,
    offset: usize,
}

/// Reads a file.
///
/// # Errors
/// `VtuError` for anything that is not a whole file of this form.
pub fn decode(file: &[u8]) -> Result<Cloud, VtuError> {
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
    let (points, blocks) = blocks(header)?;
    let mut cloud = Cloud::default();
    for block in blocks {
        let values = values(&block, points, data)?;
        if block.coordinates {
            let coordinates = values.as_chunks::<3>().0;
            cloud.points = coordinates.iter().map(|c| Vec3::from(*c)).collect();
        } else {
            cloud.arrays.insert(block.name, (block.components, values));
        }
    }
    if cloud.points.len() != points {
        let found = format!("of {} points", cloud.points.len());
        return Err(form(
            "the array of the points",
            found,
            format!("{points} points"),
        ));
    }
    Ok(cloud)
}

/// Number of points and the arrays of real numbers over them.
fn blocks(header: &str) -> Result<(usize, Vec<Block>), VtuError> {
    let xml = |error: quick_xml::Error| VtuError::Xml(error.to_string());
    let mut reader = Reader::from_str(header);
    let (mut points, mut blocks, mut section) = (None, Vec::new(), String::new());
    loop {
        let (tag, open) = match reader.read_event().map_err(xml)? {
            Event::Start(tag) => (tag, true),
            Event::Empty(tag) => (tag, false),
            Event::Eof => break,
            _ => continue,
        };
        match tag.name().as_ref() {
            "VTKFile" => check_kind(&tag)?,
            "Piece" => {
                if points.is_some() {
                    return Err(form("the file", "of several pieces", "one piece"));
                }
                points = Some(number(&tag, "NumberOfPoints", None)?);
            }
            "DataArray" if section == "Points" || section == "PointData" => {
                let kind = attribute(&tag, "type")?.unwrap_or_default();
                let name = attribute(&tag, "Name")?.unwrap_or_default();
                let place = attribute(&tag, "format")?.unwrap_or_default();
                if place != "appended" {
                    let what = format!("the format of array `{name}`");
                    return Err(form(what, format!("`{place}`"), "`appended`"));
                }
                blocks.push(Block {
                    coordinates: section == "Points",
                    components: number(&tag, "NumberOfComponents", Some(1))?,
                    offset: number(&tag, "offset", None)?,
                    kind,
                    name,
                });
            }
            // Units of arrays.
            "DataArray" | "InformationKey" => {}
            name if open => name.clone_into(&mut section),
            _ => {}
        }
    }
    let points = points.ok_or_else(|| form("the file", "without a piece", "one piece"))?;
    Ok((points, blocks))
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

/// The values of a block: its length in bytes, then as many.
fn values(block: &Block, points: usize, data: &[u8]) -> Result<Vec<f64>, VtuError> {
    let size = match block.kind.as_str() {
        "Float32" | "Int32" => 4,
        "Float64" => 8,
        other => {
            let what = format!("the type of array `{}`", block.name);
            return Err(form(
                what,
                format!("`{other}`"),
                "Float32, Float64 or Int32",
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
    let expected = points.saturating_mul(block.components).saturating_mul(size);
    if length != expected as u64 {
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
