//! Reading STL files, binary and ASCII, with `stl_io`.

use std::io::Cursor;
use std::path::Path;

use super::error::GeometryError;
use super::facets::Facets;
use crate::Vec3;

impl Facets {
    /// Reads a binary or ASCII STL file. Its coordinates are taken as metres; see [`Facets::placed`].
    ///
    /// The facet normals in the file are ignored and flipped facets do not matter: contact is two-sided.
    ///
    /// # Errors
    /// A file that cannot be read or parsed, without facets, or with coordinates that are not finite. What
    /// only shows after welding (slivers, non-manifold edges) is found by [`super::Geometry::new`].
    pub fn stl(path: &Path) -> Result<Self, GeometryError> {
        let name = path.display().to_string();
        let unreadable = |e: std::io::Error| GeometryError::Unreadable {
            path: name.clone(),
            reason: match e.kind() {
                std::io::ErrorKind::UnexpectedEof => "the file ends too early".into(),
                _ => e.to_string(),
            },
        };
        let mut bytes = crate::files::read(path).map_err(unreadable)?;
        normalise_header(&mut bytes);
        let mesh = stl_io::read_stl(&mut Cursor::new(bytes)).map_err(unreadable)?;
        if mesh.faces.is_empty() {
            return Err(GeometryError::Empty { name, facets: 0 });
        }
        let vertices: Vec<Vec3> = mesh
            .vertices
            .iter()
            .map(|v| Vec3::from(v.0.map(f64::from)))
            .collect();
        for (facet, face) in mesh.faces.iter().enumerate() {
            for &v in &face.vertices {
                super::error::finite(&name, format!("a vertex of facet {facet}"), vertices[v])?;
            }
        }
        let triangles = mesh
            .faces
            .iter()
            .map(|f| f.vertices.map(|v| v as u32))
            .collect();
        let largest = vertices.iter().map(|v| v.amax()).fold(0.0, f64::max);
        Ok(Self {
            name,
            vertices,
            triangles,
            rounding: largest * f64::from(f32::EPSILON),
            computed: false,
        })
    }
}

/// Some binary files begin with `solid`, and some ASCII files with `solid` and no name; `stl_io` takes the
/// first for ASCII and the second for binary. The length distinguishes them.
fn normalise_header(bytes: &mut Vec<u8>) {
    let count = bytes
        .get(80..84)
        .map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    if count.is_some_and(|n| bytes.len() as u64 == 84 + 50 * u64::from(n)) {
        bytes[..80].fill(b' ');
    } else if bytes.trim_ascii_start().starts_with(b"solid") {
        let start = bytes.len() - bytes.trim_ascii_start().len();
        let rest = bytes
            .iter()
            .position(|&b| b == b'\n')
            .unwrap_or(bytes.len());
        if start < rest {
            bytes.splice(..rest, *b"solid mesh");
        }
    }
}
