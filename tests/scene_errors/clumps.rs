//! Clumps that are refused.

use crate::{edited, folder, load};

const GROUP: &str =
    "lattice = { origin = [0.0, 0.0, 0.2], count = [3, 2, 1], spacing = 0.3, jitter = 0.1 }";

/// The good scene whose first group has clumps, with more in the group, in the clump and at the end of the file.
fn scene(group: &str, clump: &str, more: &str) -> String {
    let text = edited("radius = 0.1\n", &format!("clump = \"rod\"\n{group}\n"));
    let text = text.replacen(
        GROUP,
        "lattice = { origin = [0.0, 0.0, 0.3], count = [3, 2, 1], spacing = 0.4 }",
        1,
    );
    let members = "members = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.1], radius = 0.1 }]";
    let clump = if clump.contains("members") || clump.contains("stl") || clump.contains("none") {
        clump.to_owned()
    } else {
        format!("{members}\n{clump}")
    };
    format!("{text}\n[[clump]]\nname = \"rod\"\n{clump}\n{more}\n")
}

#[test]
fn each_bad_clump_is_refused_with_place_and_reason() {
    let folder = folder();
    let good = scene("seed = 3", "mass = 4.0", "");
    let loaded = load(&good, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    assert_eq!(loaded.scene.clumps.len(), 6);
    assert_eq!(loaded.scene.particles.len(), 13);
    let mass: f64 = loaded.scene.particles.mass[..12].iter().sum();
    assert!((mass - 24.0).abs() < 1e-12);
    let cases = [
        (
            scene("radius = [0.1, 0.2]", "", ""),
            "spheres[0].radius",
            "a list of 2 radii",
        ),
        (
            scene("radius = 1e-110", "", ""),
            "spheres[0]",
            "no usable mass",
        ),
        (
            scene("lock = \"x\"", "", ""),
            "spheres[0].lock",
            "which has none",
        ),
        (
            scene("rotations = [[0, 0, 1], [0, 1, 0]]", "", ""),
            "spheres[0].rotations",
            "or 6 of them",
        ),
        (
            good.replacen("clump = \"rod\"", "clump = \"rodd\"", 1),
            "spheres[0].clump",
            "did you mean `rod`",
        ),
        (
            edited("radius = 0.1\n", "radius = 0.1\nrotations = [[0, 0, 1]]\n"),
            "spheres[0].rotations",
            "give `clump`",
        ),
        (
            scene("", "mass = 0.0", ""),
            "clump[0].mass",
            "a mass > 0 [kg]",
        ),
        (
            scene("", "inertia = [1.0, 2.0, 9.0]", ""),
            "clump[0].inertia",
            "[1.0, 2.0, 9.0]",
        ),
        (
            scene("", "members = [{ position = [0, 0, 0], radius = 1.0 }]", ""),
            "clump[0].members",
            "2 to 20",
        ),
        (
            scene(
                "",
                "members = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.01], radius = 0.05 }]",
                "",
            ),
            "clump[0].members[1]",
            "lies inside another member",
        ),
        (
            scene("", "", "[cell]\nx = [-5.0, -4.8]"),
            "cell.x",
            "diameters of the largest clump",
        ),
    ];
    for (text, path, part) in cases {
        let error = load(&text, folder.path()).expect_err(path).plain();
        assert!(
            error.contains(path) && error.contains(part),
            "{path}: {error}"
        );
    }
}

/// Symptom: radii of a CSV had no effect on clumps. As `radius` of their group they are those of spheres of the same volume.
#[test]
fn radii_of_a_file_are_those_of_spheres_of_the_same_volume() {
    let folder = folder();
    let places = "x,y,z,radius\n0,0,0.8,0.2\n2.0,0,0.8,0.4\n";
    std::fs::write(folder.path().join("places.csv"), places).unwrap();
    let lattice = "lattice = { origin = [0.0, 0.0, 0.3], count = [3, 2, 1], spacing = 0.4 }";
    let listed = |keys: &str| {
        scene(keys, "", "")
            .replacen(lattice, "csv = \"places.csv\"", 1)
            .replacen("grains[4]", "grains[0]", 1)
    };
    let loaded = load(&listed(""), folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
    let radii = loaded
        .scene
        .clumps
        .iter()
        .map(|clump| clump.shape.equal_radius());
    for (found, expected) in radii.zip([0.2, 0.4]) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
    let error = load(&listed("radius = 0.3"), folder.path())
        .expect_err("two radii")
        .plain();
    assert!(
        error.contains("spheres[0].radius") && error.contains("radii in the file"),
        "{error}"
    );
    std::fs::write(
        folder.path().join("places.csv"),
        places.replace("0.4", "-0.4"),
    )
    .unwrap();
    let error = load(&listed(""), folder.path())
        .expect_err("a radius < 0")
        .plain();
    assert!(error.contains("spheres[0].csv"), "{error}");
}

/// An ASCII STL file of a tetrahedron without its last `open` facets.
fn tetrahedron(open: usize) -> String {
    let corners = ["0 0 0", "0.2 0 0", "0 0.2 0", "0 0 0.2"];
    let facets = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let facets = facets[open..].iter().map(|facet| {
        let vertices: String = facet
            .iter()
            .map(|&k| format!("vertex {}\n", corners[k]))
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    });
    format!(
        "solid grain\n{}endsolid grain\n",
        facets.collect::<String>()
    )
}

/// Facets of a cube with this edge and lower corner.
fn cube(edge: f64, low: [f64; 3]) -> String {
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let corner = |k: usize| {
        let [x, y, z] = [0, 1, 2].map(|axis| low[axis] + edge * f64::from((k >> axis & 1) as u8));
        format!("vertex {x} {y} {z}\n")
    };
    let facets = quads
        .iter()
        .flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]);
    let facets = facets.map(|facet| {
        let vertices = facet.map(corner).concat();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    });
    facets.collect()
}

/// Fault: a facet without area and its far vertex spoiled the fit, so that the clump "gave no usable mass", without the warning that
/// boundaries get; a mesh that crosses itself was called thin.
#[test]
fn damaged_meshes_are_told_as_what_they_are() {
    let folder = folder();
    let put = |name: &str, facets: &str| {
        std::fs::write(
            folder.path().join(name),
            format!("solid s\n{facets}endsolid s\n"),
        )
        .unwrap();
    };
    let whole = cube(0.2, [0.0; 3]);
    let sliver = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 10 0 0\nendloop\nendfacet\n";
    put("whole.stl", &whole);
    put("sliver.stl", &format!("{whole}{sliver}"));
    put(
        "crossed.stl",
        &format!("{whole}{}", cube(0.2, [0.05, 0.05, 0.1])),
    );
    let fitted = |name: &str| {
        let text = scene("", &format!("stl = \"{name}\"\nspheres = 4"), "");
        load(&text, folder.path())
    };
    let whole = fitted("whole.stl").unwrap_or_else(|e| panic!("{}", e.plain()));
    let mended = fitted("sliver.stl").unwrap_or_else(|e| panic!("{}", e.plain()));
    assert_eq!(
        mended.scene.clumps[0].shape.radii,
        whole.scene.clumps[0].shape.radii
    );
    let told = |warning: &sphere_dda::scene_file::Diagnostic| {
        warning.path == "clump[0].stl" && warning.message.contains("left out 1 facets without area")
    };
    assert!(mended.warnings.iter().any(told), "{:?}", mended.warnings);
    assert!(!whole.warnings.iter().any(told));
    let error = fitted("crossed.stl")
        .expect_err("it crosses itself")
        .plain();
    assert!(error.contains("whose surface crosses itself"), "{error}");
}

/// A clump has the mass and the inertia of its mesh; `unit` scales both.
#[test]
fn a_clump_from_a_mesh_has_the_mass_of_the_mesh() {
    let folder = folder();
    std::fs::write(folder.path().join("grain.stl"), tetrahedron(0)).unwrap();
    for (unit, scale) in [("", 1.0_f64), ("unit = \"cm\"", 0.01)] {
        let text = scene("", &format!("stl = \"grain.stl\"\nspheres = 4\n{unit}"), "");
        let loaded = load(&text, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
        assert_eq!(loaded.scene.clumps.len(), 6);
        assert_eq!(loaded.attachments.len(), 1);
        let volume = (0.2 * scale).powi(3) / 6.0;
        let shape = &loaded.scene.clumps[0].shape;
        assert_eq!(shape.radii.len(), 4);
        assert!(
            (shape.mass / (2500.0 * volume) - 1.0).abs() < 1e-6,
            "{}",
            shape.mass
        );
        // About the corner int x^2 dV = a^5/60 and int x y dV = a^5/120; the centroid is at a/4 along each axis.
        let (side, mass) = (0.2 * scale, 2500.0 * volume);
        let [diagonal, beside] = [2.0 * (0.1 - 0.0625), 0.0625 - 0.05];
        let moments = [
            diagonal - beside,
            diagonal - beside,
            diagonal + 2.0 * beside,
        ];
        let mut expected = moments.map(|x| x * mass * side * side);
        let mut found: [f64; 3] = shape.moments.into();
        expected.sort_by(f64::total_cmp);
        found.sort_by(f64::total_cmp);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
        }
        let told = loaded.fitted[0].to_string();
        assert!(told.contains("4 spheres for `grain.stl`"), "{told}");
        for word in ["volume", "centroid", "inertia", "surface"] {
            assert!(told.contains(word), "{told}");
        }
    }
}

#[test]
fn each_bad_mesh_of_a_clump_is_refused_with_place_and_reason() {
    let folder = folder();
    for (name, content) in [
        ("grain.stl", tetrahedron(0)),
        ("open.stl", tetrahedron(1)),
        ("text.stl", "no mesh".to_owned()),
    ] {
        std::fs::write(folder.path().join(name), content).unwrap();
    }
    let members = "members = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.1], radius = 0.1 }]";
    for (clump, path, part) in [
        (
            "stl = \"open.stl\"\nspheres = 4",
            "clump[0].stl",
            "expected a closed mesh",
        ),
        (
            "stl = \"text.stl\"\nspheres = 4",
            "clump[0].stl",
            "expected a binary or ASCII STL file",
        ),
        (
            "stl = \"none.stl\"\nspheres = 4",
            "clump[0].stl",
            "cannot read",
        ),
        (
            "stl = \"../grain.stl\"\nspheres = 4",
            "clump[0].stl",
            "below the scene's folder",
        ),
        (
            "stl = \"grain.stl\"\nspheres = 1",
            "clump[0].spheres",
            "found 1, expected 2 to 20",
        ),
        (
            "stl = \"grain.stl\"\nspheres = 21",
            "clump[0].spheres",
            "found 21, expected 2 to 20",
        ),
        (
            "stl = \"grain.stl\"\nspheres = -3",
            "clump[0].spheres",
            "found -3, expected 2 to 20",
        ),
        ("stl = \"grain.stl\"", "clump[0]", "missing key `spheres`"),
        (
            "stl = \"grain.stl\"\nspheres = 4\nunit = \"kg\"",
            "clump[0].unit",
            "a unit of length",
        ),
        (
            &format!("stl = \"grain.stl\"\nspheres = 4\n{members}"),
            "clump[0].stl",
            "found both",
        ),
        (
            &format!("spheres = 4\n{members}"),
            "clump[0].spheres",
            "beside `members`",
        ),
        (
            &format!("unit = \"mm\"\n{members}"),
            "clump[0].unit",
            "beside `members`",
        ),
        ("# none", "clump[0]", "found neither `members` nor `stl`"),
    ] {
        let error = load(&scene("", clump, ""), folder.path())
            .expect_err(clump)
            .plain();
        assert!(
            error.contains(path) && error.contains(part),
            "{clump}: {error}"
        );
    }
}
