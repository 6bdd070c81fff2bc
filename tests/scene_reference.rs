//! The reference of scene files holds: its examples are good scenes, its schema says something of every key.

use std::fs;
use std::path::Path;

use serde_json::Value;
use sphere_dda::scene::Scene;
use sphere_dda::scene_file::file::TopLevel;
use sphere_dda::scene_file::json_schema;

/// What a part of a scene needs around it, by the table that is added where it is missing.
const REST: [(&str, &str); 4] = [
    ("simulation", "[simulation]\nduration = 1.0\nstep = 1e-3\n"),
    (
        "material",
        "[[material]]\nname = \"glass\"\ndensity = 2500.0\n",
    ),
    (
        "spheres",
        "[[spheres]]\nname = \"ball\"\nmaterial = \"glass\"\nradius = 0.01\npositions = [[0.2, 0.1, 0.1]]\n",
    ),
    (
        "boundary",
        "[[boundary]]\nname = \"floor\"\nmaterial = \"glass\"\n\
         faces = [{ plane = { point = [0.0, 0.0, -1.0], normal = [0.0, 0.0, 1.0] } }]\n",
    ),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The fenced blocks of TOML.
fn blocks(text: &str) -> Vec<String> {
    let parts = text.split("```toml\n").skip(1);
    let ends = parts.filter_map(|part| part.split_once("```"));
    ends.map(|(block, _)| block.to_owned()).collect()
}

/// Every example of the reference is a good part of a scene.
#[test]
fn every_example_of_the_reference_is_good() {
    let folder = tempfile::tempdir().expect("a folder");
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let corners = ["0 0 0", "20 0 0", "0 20 0", "0 0 20"];
    let gravel: String = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        .map(|facet| {
            let vertices: String = facet
                .map(|k: usize| format!("vertex {}\n", corners[k]))
                .concat();
            format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
        })
        .concat();
    let grid = "ncols 2\nnrows 2\nxllcorner 3456000\nyllcorner 5678000\ncellsize 1\n0 0\n0 0\n";
    for (name, content) in [
        ("part.stl", format!("solid part\n{facet}endsolid part\n")),
        (
            "gravel.stl",
            format!("solid gravel\n{gravel}endsolid gravel\n"),
        ),
        ("ground.asc", grid.into()),
    ] {
        fs::write(folder.path().join(name), content).expect("a file");
    }
    let text = fs::read_to_string(root().join("docs/scene.md")).expect("the reference");
    let blocks = blocks(&text);
    assert!(blocks.len() > 30, "{} examples", blocks.len());
    for block in blocks {
        let given: Value = toml::from_str(&block).unwrap_or_else(|e| panic!("{block}\n{e}"));
        let missing = REST.iter().filter(|(table, _)| given.get(table).is_none());
        let whole: String = block.clone() + &missing.map(|(_, rest)| *rest).collect::<String>();
        let typed: Result<TopLevel, _> = toml::from_str(&whole);
        typed.unwrap_or_else(|e| panic!("{block}\n{e}"));
        Scene::from_toml("example", &whole, folder.path())
            .unwrap_or_else(|e| panic!("{block}\n{}", e.plain()));
    }
}

/// Every key of every table says what it means; tables name their keys in order; numbers with a dimension say which.
#[test]
fn the_schema_is_complete() {
    let schema = json_schema();
    let definitions = schema["definitions"].as_object().expect("types");
    let tables = definitions
        .iter()
        .map(|(name, table)| (name.as_str(), table));
    for (name, table) in tables.chain([("scene", &schema)]) {
        assert!(
            table["description"].is_string(),
            "{name} has no description"
        );
        let Some(properties) = table["properties"].as_object() else {
            continue;
        };
        let order = table["x-order"]
            .as_array()
            .unwrap_or_else(|| panic!("{name} has no order: add it to schema.rs"));
        assert_eq!(order.len(), properties.len(), "{name}");
        for (key, property) in properties {
            assert!(order.contains(&key.as_str().into()), "{name}.{key}");
            assert!(
                property["description"]
                    .as_str()
                    .is_some_and(|d| d.len() > 4),
                "{name}.{key} says nothing"
            );
            let is_float = property["type"] == "number";
            assert!(
                !is_float
                    || property["x-unit"].is_string()
                    || key == "scale"
                    // Their unit is that of what the parameter sets.
                    || name == "Parameter",
                "{name}.{key} has no unit"
            );
        }
    }
    assert_eq!(
        definitions["Spheres"]["properties"]["radius_jitter"]["exclusiveMaximum"],
        1
    );
    assert_eq!(
        definitions["Simulation"]["properties"]["gravity"]["x-unit"],
        "m/s^2"
    );
    assert_eq!(
        definitions["Simulation"]["properties"]["max_cuts"]["default"],
        10
    );
}
