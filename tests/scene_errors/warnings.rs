//! Scenes that run, but probably not as meant.

use sphere_dda::scene::Scene;
use sphere_dda::scene_file::Summary;

use crate::{GOOD, edited, folder, load};

/// Scenes that run but are not meant so: the place and a part of the warning.
#[test]
fn what_will_hurt_is_warned_of() {
    let folder = folder();
    let floor = "{ plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0] } }";
    let gate =
        "{ rectangle = { corner = [9.0, 0.0, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] } }";
    let cases = [
        (
            "step = 1e-3",
            "step = 0.5\nfixed_step = true",
            "simulation.step",
            "times longer than the suggested",
        ),
        (
            "step = 1e-3",
            "step = 1e-3\npenalty = 1e5",
            "simulation.penalty",
            "has no effect with solver = \"auto\"",
        ),
        (
            "step = 1e-3",
            "step = 1e-3\npenalty = 1e5\nsolver = \"gauss-seidel\"",
            "simulation.penalty",
            "no effect with solver = \"gauss-seidel\"",
        ),
        (
            "step = 1e-3",
            "step = 1e-3\nthreads = 2",
            "simulation.threads",
            "no effect with 7 spheres",
        ),
        (
            "restitution = 0.5",
            "rolling_friction = 0.1\n[[material]]\nname = \"ice\"",
            "material[2]",
            "`ice` is used by no spheres",
        ),
        (
            "restitution = 0.5",
            "wear = 1e-12",
            "pair[0].wear",
            "no boundary keeps what it feels",
        ),
        (
            "restitution = 0.5",
            "bond = { normal_strength = 1.0, shear_strength = 1.0, young = 1e6 }",
            "pair[0].bond.young",
            "bonds of rigid grains are rigid",
        ),
        (
            "density = 2500.0\n[[material]]",
            "density = 2500.0\nyoung = 70\n[[material]]",
            "material[0].young",
            "70 GPa is `young = 7e10`",
        ),
        (
            "density = 2500.0\n[[material]]",
            "density = 2500.0\nyoung = 70e6\n[[material]]",
            "",
            "",
        ),
        (
            "[output]",
            "[[clump]]\nname = \"pair\"\nmembers = [{ position = [0, 0, 0], radius = 0.1 }, { position = [0, 0, 0.1], radius = 0.1 }]\n[output]",
            "clump[0]",
            "clump `pair` is placed by no spheres and no source",
        ),
        (
            "friction = 0.3",
            "friction = 0.3\nbond = { normal_strength = 1.0, shear_strength = 1.0 }",
            "pair_default.bond",
            "joins nothing: bonds are made at t = 0 alone, where the nearest surfaces are",
        ),
        (
            "friction = 0.3",
            "friction = 0.3\nbond = { normal_strength = 1.0, shear_strength = 1.0, reach = 0.2 }",
            "",
            "",
        ),
        (
            "materials = [\"rock\", \"steel\"]",
            "materials = [\"steel\", \"steel\"]",
            "pair[0]",
            "boundaries do not touch each other",
        ),
        (
            "restitution = 0.5\n",
            "restitution = 0.0\n[[spheres]]\nname = \"boulders\"\nmaterial = \"rock\"\nradius = 7.0\nlattice = { origin = [100, 100, 20], count = [10, 10, 10], spacing = 20 }\n",
            "spheres",
            "lengths are in m",
        ),
        ("faces = [\n", "wall_fields = true\nfaces = [\n", "", ""),
        (
            "v = [0.0, 1.0, 0.0] } },\n  { cone",
            "v = [0.0, 9.0, 0.0] } },\n]\nwall_fields = true\n[[boundary]]\nname = \"bell\"\nmaterial = \"steel\"\nfaces = [\n  { cone",
            "boundary[1].wall_fields",
            "`gate` has 2 triangles of 4.50e0 m2 on average, 36 sections of the largest sphere",
        ),
        (
            floor,
            gate,
            "spheres[0]",
            "6 of 7 spheres start outside all boundaries with nothing below, for example `grains[0]`",
        ),
        (
            floor,
            "{ box = { min = [-0.2, -0.2, 0], max = [0.8, 0.5, 1] } }, { plane = { point = [0, 0, -1], normal = [0, 0, 1] } }",
            "",
            "",
        ),
        (
            floor,
            "{ box = { min = [-5, -5, 2], max = [5, 5, 4] } }",
            "spheres[1]",
            "1 of 7 spheres starts inside the closed boundary `floor`",
        ),
        (
            floor,
            "{ terrain = { file = \"ground.asc\" } }",
            "spheres[0]",
            "6 of 7 spheres start below the terrain of boundary `floor`",
        ),
        (
            floor,
            "{ plane = { point = [0, 0, 0], normal = [0, 0, 1] } }, { stl = { file = \"large.stl\" } }",
            "boundary[0]",
            "`large.stl` is in mm, add `unit = \"mm\"`",
        ),
    ];
    let corners = ["-500 -500 -1", "500 -500 -1", "0 500 -1"].map(|c| format!("vertex {c}\n"));
    let mesh = format!(
        "solid s\nfacet normal 0 0 1\nouter loop\n{}endloop\nendfacet\nendsolid s\n",
        corners.concat()
    );
    std::fs::write(folder.path().join("large.stl"), mesh).unwrap();
    let ground = "ncols 2\nnrows 2\nxllcorner -100\nyllcorner -100\ncellsize 100\n2 2 2 2\n";
    std::fs::write(folder.path().join("ground.asc"), ground).unwrap();
    let mut failures = Vec::new();
    for (from, to, path, text) in cases {
        let scene = edited(from, to);
        let loaded = load(&scene, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
        let told: Vec<String> = loaded
            .warnings
            .iter()
            .map(|w| w.plain("scene.toml"))
            .collect();
        let hit = match path {
            "" => told.is_empty(),
            _ => loaded
                .warnings
                .iter()
                .zip(&told)
                .any(|(w, told)| w.path == path && told.contains(text)),
        };
        if !hit || told.len() > 2 {
            failures.push(format!(
                "`{to}` wants {path} `{text}`, got\n{}",
                told.join("\n")
            ));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n---\n"));
}

/// Bonds with the floor alone are none of the grains that lie beside each other.
#[test]
fn bonds_with_boundaries_alone_are_told() {
    let folder = folder();
    let bond = "friction = 0.3\nbond = { normal_strength = 1.0, shear_strength = 1.0 }";
    let text = edited("friction = 0.3", bond);
    let text = text.replacen("spacing = 0.3, jitter = 0.1", "spacing = 0.25", 1);
    let told = |height: &str| {
        let text = text.replacen("origin = [0.0, 0.0, 0.2]", height, 1);
        let loaded = load(&text, folder.path()).unwrap_or_else(|e| panic!("{}", e.plain()));
        let warning = loaded
            .warnings
            .iter()
            .find(|w| w.path == "pair_default.bond");
        let message = warning.map(|w| w.message.clone()).unwrap_or_default();
        (message, Summary::of(&loaded.scene).bonds)
    };
    let (message, bonds) = told("origin = [0.0, 0.0, 0.1]");
    assert!(
        message.contains("to boundaries, but not to each other"),
        "{message}"
    );
    assert!(message.contains("5.0e-2 m apart"), "{message}");
    assert_eq!(bonds, Some([0, 6]));
    let (message, bonds) = told("origin = [0.0, 0.0, 0.2]");
    assert!(message.starts_with("joins nothing"), "{message}");
    assert_eq!(bonds, Some([0, 0]));
}

#[test]
fn a_scene_without_title_has_the_name_of_its_file() {
    let folder = folder();
    let title = |name: &str, text: &str| {
        Scene::from_toml(name, text, folder.path())
            .unwrap()
            .scene
            .title
    };
    let untitled = edited("title = \"box\"\n", "");
    assert_eq!(title("some/where/hopper.v2.toml", &untitled), "hopper.v2");
    assert_eq!(title("", &untitled), "scene");
    assert_eq!(title("hopper.toml", GOOD), "box");
}
