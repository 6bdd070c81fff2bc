//! What is refused, and what the message says; and the STL files that are read.

use std::path::PathBuf;

use sphere_dda::geometry::{Facets, Geometry, GeometryError, HalfSpace, Revolution};

use super::{closest_points, geometry, v};

fn file(dir: &tempfile::TempDir, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
    let path = dir.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    path
}

fn ascii(header: &str, facets: &[[[f32; 3]; 3]]) -> String {
    let mut text = format!("{header}\n");
    for facet in facets {
        text += "facet normal 0 0 1\nouter loop\n";
        for [x, y, z] in facet {
            text += &format!("vertex {x} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid\n"
}

fn binary(header: &str, facets: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(80, b' ');
    bytes.extend((facets.len() as u32).to_le_bytes());
    for facet in facets {
        bytes.extend([0; 12]);
        bytes.extend(facet.iter().flatten().flat_map(|x| x.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

const SQUARE: [[[f32; 3]; 3]; 2] = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
    [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
];

#[test]
fn every_kind_of_stl_is_read() {
    let dir = tempfile::tempdir().unwrap();
    for (name, bytes) in [
        ("binary.stl", binary("made by hand", &SQUARE)),
        ("binary-solid.stl", binary("solid but binary\n", &SQUARE)),
        ("ascii.stl", ascii("solid square", &SQUARE).into_bytes()),
        ("nameless.stl", ascii("solid", &SQUARE).into_bytes()),
        (
            "crlf.stl",
            ascii("solid", &SQUARE).replace('\n', "\r\n").into_bytes(),
        ),
    ] {
        let mesh = Facets::stl(&file(&dir, name, bytes)).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(mesh.triangles.len(), 2, "{name}");
        let found = closest_points(&geometry([mesh]), v(0.5, 0.5, 0.2), 0.2, 0.1);
        assert_eq!(found.len(), 1, "{name}");
    }
}

#[test]
fn unusable_files_are_refused_with_their_name() {
    let dir = tempfile::tempdir().unwrap();
    let mut nan = SQUARE;
    nan[1][2][0] = f32::NAN;
    let cut = binary("cut", &SQUARE)[..150].to_vec();
    let cases = [
        (dir.path().join("missing.stl"), "cannot read mesh"),
        (file(&dir, "empty.stl", ""), "ends too early"),
        (file(&dir, "text.stl", "not a mesh"), "ends too early"),
        (file(&dir, "cut.stl", cut), "ends too early"),
        (
            file(
                &dir,
                "word.stl",
                ascii("solid", &SQUARE).replace("vertex 1 1", "vertex 1 one"),
            ),
            "invalid float",
        ),
        (file(&dir, "none.stl", ascii("solid", &[])), "no facet"),
        (
            file(&dir, "none-binary.stl", binary("none", &[])),
            "no facet",
        ),
        (
            file(&dir, "nan.stl", binary("nan", &nan)),
            "a vertex of facet 1",
        ),
    ];
    for (path, expected) in cases {
        let message = Facets::stl(&path).unwrap_err().to_string();
        assert!(message.contains(&*path.display().to_string()), "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn a_mesh_that_cannot_be_mended_names_its_facets() {
    let fan = |extra: [u32; 3]| {
        let corners = vec![
            v(0.0, 0.0, 0.0),
            v(1.0, 0.0, 0.0),
            v(0.0, 1.0, 0.0),
            v(0.0, 0.0, 1.0),
            v(0.0, -1.0, 0.0),
        ];
        Facets::mesh("fan", corners, vec![[0, 1, 2], [0, 1, 3], extra])
    };
    let error = Geometry::new(vec![fan([1, 0, 4]).into()]).unwrap_err();
    assert!(
        matches!(&error, GeometryError::NonManifold { facets, .. } if facets[..] == [0, 1, 2]),
        "{error}"
    );
    let error = Geometry::new(vec![fan([0, 1, 9]).into()]).unwrap_err();
    assert!(
        matches!(
            error,
            GeometryError::Index {
                facet: 2,
                vertex: 9,
                ..
            }
        ),
        "{error}"
    );
    let flat = Facets::mesh(
        "line",
        vec![v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(2.0, 0.0, 0.0)],
        vec![[0, 1, 2]],
    );
    let error = Geometry::new(vec![flat.into()]).unwrap_err();
    assert!(
        matches!(error, GeometryError::Empty { facets: 1, .. }),
        "{error}"
    );
    let nan = Facets::mesh(
        "nan",
        vec![v(0.0, 0.0, 0.0), v(1.0, f64::NAN, 0.0), v(2.0, 0.0, 0.0)],
        vec![[0, 1, 2]],
    );
    let error = Geometry::new(vec![nan.into()]).unwrap_err();
    assert!(error.to_string().contains("vertex 1"), "{error}");
}

#[test]
fn shapes_that_make_no_sense_are_refused() {
    let o = v(0.0, 0.0, 0.0);
    let z = v(0.0, 0.0, 1.0);
    let refused = [
        HalfSpace::new(o, o).unwrap_err(),
        HalfSpace::new(v(f64::NAN, 0.0, 0.0), z).unwrap_err(),
        Revolution::cylinder(o, o, 1.0, 1.0).unwrap_err(),
        Revolution::cylinder(o, z, 0.0, 1.0).unwrap_err(),
        Revolution::frustum(o, z, 1.0, -1.0, 1.0).unwrap_err(),
        Revolution::frustum(o, z, 1.0, 1.0, 0.0).unwrap_err(),
        Revolution::frustum(o, z, f64::INFINITY, 1.0, 1.0).unwrap_err(),
        Revolution::disc(o, z, 1.0, 0.5).unwrap_err(),
        Revolution::new(o, z, &[[1.0, 0.0], [1.0, 0.0]]).unwrap_err(),
        Facets::cuboid(o, v(1.0, 0.0, 1.0)).unwrap_err(),
        Facets::polygon(&[o, z]).unwrap_err(),
        Facets::polygon(&[o, z, z * 2.0]).unwrap_err(),
        Facets::polygon(&[o, v(1.0, 0.0, 0.0), v(1.0, 1.0, 0.1), v(0.0, 1.0, 0.0)]).unwrap_err(),
        Facets::polygon(&[o, v(2.0, 0.0, 0.0), v(0.5, 0.5, 0.0), v(0.0, 2.0, 0.0)]).unwrap_err(),
        Facets::rectangle(o, z, z).unwrap_err(),
        Facets::triangle(o, z, v(0.0, f64::NAN, 0.0)).unwrap_err(),
    ];
    for error in refused {
        let message = error.to_string();
        assert!(message.contains("expected"), "{message}");
    }
}
