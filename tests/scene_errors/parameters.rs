//! `[[parameter]]`: what it sets, and every mistake with its message.

use std::path::Path;

use sphere_dda::scene::Scene;
use sphere_dda::scene_file::{Loaded, SceneError};

use crate::GOOD;

/// The good scene with `parameters` at its end.
fn load(parameters: &str) -> Result<Loaded, Box<SceneError>> {
    Scene::from_toml("scene", &format!("{GOOD}{parameters}"), Path::new("")).map_err(Box::new)
}

fn parameter(rest: &str) -> String {
    format!("[[parameter]]\nname = \"p\"\n{rest}\n")
}

/// With values, from a folder.
fn set(text: &str, values: &[(&str, f64)]) -> Result<Loaded, Box<SceneError>> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).unwrap();
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    Scene::from_file_with(&path, &values).map_err(Box::new)
}

/// Path in `sets`, from and to in the text, value: the scene is the one with the edited text.
const PLACES: [(&str, &str, &str, f64); 13] = [
    (
        "material.rock.density",
        "density = 2500.0",
        "density = 2600.0",
        2600.0,
    ),
    (
        "pair_default.friction",
        "friction = 0.3",
        "friction = 0.35",
        0.35,
    ),
    (
        "pair[steel,rock].restitution",
        "restitution = 0.5",
        "restitution = 0.25",
        0.25,
    ),
    (
        "pair[1].friction_angle",
        "friction_angle = 20.0",
        "friction_angle = 21.5",
        21.5,
    ),
    (
        "spheres.grains.radius",
        "radius = 0.1\n",
        "radius = 0.11\n",
        0.11,
    ),
    (
        "spheres.one.radius[1]",
        "radius = [0.2]",
        "radius = [0.21]",
        0.21,
    ),
    (
        "spheres.grains.lattice.count[2]",
        "count = [3, 2, 1]",
        "count = [3, 4, 1]",
        4.0,
    ),
    (
        "boundary.floor.faces[1].plane.point[3]",
        "point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 2.0]",
        "point = [0.0, 0.0, -0.2], normal = [0.0, 0.0, 2.0]",
        -0.2,
    ),
    (
        "boundary[gate].motion.table.translation[2][3]",
        "[0.0, 0.0, 1.0]] } }",
        "[0.0, 0.0, 0.9]] } }",
        0.9,
    ),
    (
        "load[1].force[3]",
        "force = [0.0, 0.0, 1.0]",
        "force = [0.0, 0.0, 0.1]",
        0.1,
    ),
    (
        "spring[1].stiffness",
        "stiffness = 1e3",
        "stiffness = 2e3",
        2e3,
    ),
    (
        "sensor.flow.mass_flow.plane.point[3]",
        "mass_flow = { plane = { point = [0.0, 0.0, 0.0]",
        "mass_flow = { plane = { point = [0.0, 0.0, 0.3]",
        0.3,
    ),
    ("simulation.tolerance.gap", "gap = 1e-6", "gap = 1e-7", 1e-7),
];

#[test]
fn a_value_is_that_of_an_edited_scene() {
    for (path, from, to, value) in PLACES {
        assert!(GOOD.contains(from), "{from}");
        let mut edited = load("").unwrap().scene;
        let other = Scene::from_toml("scene", &GOOD.replacen(from, to, 1), Path::new(""));
        edited.clone_from(&other.unwrap().scene);
        let with = |default: &str| parameter(&format!("sets = \"{path}\"{default}"));
        // By its default, and set from outside.
        let own = load(&with(&format!("\ndefault = {value:?}")));
        let set = set(&format!("{GOOD}{}", with("")), &[("p", value)]);
        for loaded in [own, set] {
            let mut scene = loaded
                .unwrap_or_else(|e| panic!("{path}: {}", e.plain()))
                .scene;
            assert_eq!(scene.parameters[0].value, value);
            scene.parameters.clear();
            scene.hash.clone_from(&edited.hash);
            assert_eq!(scene, edited, "{path}");
        }
        // Nothing set: as the text says.
        let mut untouched = load(&with("")).unwrap().scene;
        let plain = load("").unwrap().scene;
        untouched.parameters.clear();
        untouched.hash.clone_from(&plain.hash);
        assert_eq!(untouched, plain, "{path}");
    }
}

#[test]
fn a_set_value_is_the_default_of_the_text_that_is_carried() {
    let with = |default: &str| {
        let rest =
            format!("sets = [\"pair_default.friction\", \"pair[1].restitution\"]\n{default}");
        format!("{GOOD}{}", parameter(&rest))
    };
    let set = |text: &str| set(text, &[("p", 0.4)]).unwrap();
    // An edit of the default, or a new line for it; then the hash is that of the text.
    let replaced = set(&with("default = 0.1 # mine"));
    assert_eq!(replaced.text, with("default = 0.4 # mine"));
    let inserted = set(&format!(
        "{GOOD}{}",
        parameter("sets = \"pair_default.friction\"")
    ));
    assert!(
        inserted.text.contains("name = \"p\"\ndefault = 0.4\nsets"),
        "{}",
        inserted.text
    );
    let inline = GOOD.replacen(
        "title",
        "parameter = [{ name = \"p\", sets = \"pair_default.friction\" }]\ntitle",
        1,
    );
    let inline = set(&inline);
    assert!(
        inline.text.contains("{ name = \"p\", default = 0.4, sets"),
        "{}",
        inline.text
    );
    for loaded in [replaced, inserted, inline] {
        let again = Scene::from_toml("scene", &loaded.text, Path::new("")).unwrap();
        assert_eq!(again.scene.hash, loaded.scene.hash);
        assert_eq!(again.scene.parameters, loaded.scene.parameters);
        assert_eq!(again.scene.pairs, loaded.scene.pairs);
    }
    let same = set(&with("default = 0.4"));
    assert_eq!(same.text, with("default = 0.4"));
}

/// What a run takes between steps, and units; others shape the scene.
#[test]
fn kinds_and_units_follow_from_the_keys() {
    for (path, unit, is_integer, is_tunable) in [
        ("pair_default.friction", "-", false, true),
        ("material.rock.density", "kg/m^3", false, false),
        ("spheres.grains.lattice.count[1]", "-", true, false),
        ("spheres.grains.radius", "m", false, false),
        ("load[1].force[3]", "N", false, true),
        ("spring[1].stiffness", "N/m", false, false),
    ] {
        let scene = load(&parameter(&format!("sets = \"{path}\"")))
            .unwrap()
            .scene;
        let own = &scene.parameters[0];
        let found = (own.unit.as_str(), own.is_integer, own.is_tunable);
        assert_eq!(found, (unit, is_integer, is_tunable), "{path}");
        assert_eq!(own.description, format!("Sets {path}"));
    }
    let both =
        "sets = [\"pair_default.friction\", \"spheres.grains.radius_jitter\"]\ndefault = 0.1";
    let scene = load(&parameter(both)).unwrap().scene;
    assert!(!scene.parameters[0].is_tunable);
    assert_eq!(scene.parameters[0].value, 0.1);
}

/// Rest of the parameter, path of the problem, a part of its text.
const MISTAKES: [(&str, &str, &str); 26] = [
    (
        "sets = \"material.rok.density\"",
        "parameter[0].sets",
        "unknown material `rok`\n  help: did you mean `rock`? known: rock, steel",
    ),
    (
        "sets = \"material.rock.densty\"",
        "parameter[0].sets",
        "unknown key `densty` of `material.rock`\n  help: did you mean `density`?",
    ),
    (
        "sets = \"materiel.rock.density\"",
        "parameter[0].sets",
        "unknown key `materiel` of a scene\n  help: did you mean `material`?",
    ),
    (
        "sets = \"pair[rock,glass].friction\"",
        "parameter[0].sets",
        "found no pair of `rock` and `glass`\n  help: known: [rock,steel]",
    ),
    (
        "sets = \"load.first.force[1]\"",
        "parameter[0].sets",
        "entries of `load` have no names\n  help: number them from 1: `load[1]`",
    ),
    (
        "sets = \"load[2].force[1]\"",
        "parameter[0].sets",
        "found `[2]`, expected a number from 1 to 1, which `load` has",
    ),
    (
        "sets = \"load[0].force[1]\"",
        "parameter[0].sets",
        "found `[0]`, expected a number from 1 to 1",
    ),
    (
        "sets = \"simulation.gravity[3]\"",
        "parameter[0].sets",
        "but the scene has no `simulation.gravity`",
    ),
    (
        "sets = \"simulation.duration[1]\"",
        "parameter[0].sets",
        "`simulation.duration`, which is no list",
    ),
    (
        "sets = \"spheres.grains.lattice.count\"",
        "parameter[0].sets",
        "is a list of 3, expected one number",
    ),
    (
        "sets = \"spheres.grains.material\"",
        "parameter[0].sets",
        "is no number",
    ),
    (
        "sets = \"spheres.grains.lattice\"",
        "parameter[0].sets",
        "numbers below it: spacing, jitter",
    ),
    (
        "sets = \"material..density\"",
        "parameter[0].sets",
        "expected keys joined by points",
    ),
    (
        "sets = \"pair[rock\"",
        "parameter[0].sets",
        "expected keys joined by points",
    ),
    ("sets = []", "parameter[0].sets", "found an empty list"),
    (
        "sets = [\"pair_default.friction\", \"pair_default.frictoin\"]",
        "parameter[0].sets[1]",
        "did you mean `friction`?",
    ),
    (
        "sets = [\"pair_default.friction\", \"pair_default.friction\"]",
        "parameter[0].sets",
        "`pair_default.friction` is set by `p` and by `p`",
    ),
    (
        "sets = [\"spheres.grains.radius\", \"material.rock.density\"]\ndefault = 1",
        "parameter[0].sets",
        "found keys in m and in kg/m^3",
    ),
    (
        "sets = [\"pair_default.friction\", \"pair[1].restitution\"]",
        "parameter[0]",
        "missing key `default`: what it sets has different values",
    ),
    (
        "sets = \"pair_default.restitution\"",
        "parameter[0]",
        "missing key `default`: `pair_default.restitution` has no number",
    ),
    (
        "sets = \"spheres.grains.radius\"\nunit = \"mm\"",
        "parameter[0].unit",
        "found `mm`, expected `m`",
    ),
    (
        "sets = \"pair_default.friction\"\nmax = 0.2",
        "parameter[0].default",
        "found 0.3, expected a number <= 0.2",
    ),
    (
        "sets = \"pair_default.friction\"\nmin = 1\nmax = 0",
        "parameter[0].max",
        "found 0, expected min = 1 or more",
    ),
    (
        "sets = \"spheres.grains.lattice.count[1]\"\nmin = 0.5",
        "parameter[0].min",
        "found 0.5, expected a whole number",
    ),
    (
        "sets = \"spheres.grains.lattice.count[1]\"\ndefault = 1.5",
        "parameter[0].default",
        "found 1.5, expected a whole number",
    ),
    (
        "sets = \"pair_default.friction\"\ndefault = -1",
        "pair_default.friction",
        "the parameter `p` has set it",
    ),
];

#[test]
fn mistakes_are_told_with_their_place() {
    for (rest, path, text) in MISTAKES {
        let error = load(&parameter(rest)).expect_err(rest);
        let plain = error.plain();
        assert!(
            error.problems.iter().any(|p| p.path == path),
            "{rest}: {plain}"
        );
        assert!(plain.contains(text), "{rest}: {plain}");
    }
    let twice = format!(
        "{}{}",
        parameter("sets = \"pair_default.friction\""),
        parameter("sets = \"load[1].force[1]\"")
    );
    let error = load(&twice).unwrap_err();
    assert!(
        error.plain().contains("parameter `p` appears twice"),
        "{}",
        error.plain()
    );
}

#[test]
fn all_values_that_are_wrong_are_told_together() {
    let text = format!(
        "{GOOD}{}[[parameter]]\nname = \"count\"\nsets = \"spheres.grains.lattice.count[1]\"\n",
        parameter("sets = \"pair_default.friction\"\nmin = 0\nmax = 1")
    );
    let error = set(&text, &[("p", 2.0), ("cuont", 3.0), ("count", 2.5)]).unwrap_err();
    let plain = error.plain();
    for part in [
        "found `p` = 2, expected a number from 0 to 1",
        "unknown parameter `cuont`\n  help: did you mean `count`? known: p, count",
        "found `count` = 2.5, expected a whole number",
    ] {
        assert!(plain.contains(part), "{plain}");
    }
    assert_eq!(error.problems.len(), 3, "{plain}");
    let none = set(GOOD, &[("friction", 0.4)]).unwrap_err().plain();
    assert!(
        none.contains("the scene has none: name one with `[[parameter]]`"),
        "{none}"
    );
    // The last of several counts.
    let last = set(&text, &[("p", 0.5), ("p", 0.6)]).unwrap();
    assert_eq!(last.scene.parameters[0].value, 0.6);
}

/// Numbers with a unit, also in lists and in a mesh's file, are the numbers in the unit of their key.
#[test]
fn quantities_are_their_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1000 0 0\nvertex 0 1000 0\nendloop\nendfacet\n";
    std::fs::write(
        folder.path().join("part.stl"),
        format!("solid part\n{facet}endsolid part\n"),
    )
    .unwrap();
    let mesh = |more: &str| {
        format!(
            "[[boundary]]\nname = \"mesh\"\nmaterial = \"steel\"\nfaces = [{{ stl = {{ file = \"part.stl\", {more} }} }}]\n"
        )
    };
    let scene = |text: &str| {
        let loaded = Scene::from_toml("scene", text, folder.path()).map_err(|e| e.plain());
        loaded.map(|loaded| Scene {
            hash: String::new(),
            ..loaded.scene
        })
    };
    let plain = format!("{GOOD}{}", mesh("scale = 0.001"));
    let mut typed = format!("{GOOD}{}", mesh("unit = \"mm\""));
    for (from, to) in [
        ("step = 1e-3", "step = \"1 ms\""),
        ("density = 2500.0", "density = \"2.5 g/cm^3\""),
        ("radius = [0.2]", "radius = [\"20 cm\"]"),
        ("[0.0, 0.0, 3.0]", "[0.0, 0.0, \"3000 mm\"]"),
        ("friction_angle = 20.0", "friction_angle = \"20 deg\""),
        ("stiffness = 1e3", "stiffness = \"1 kN/m\""),
    ] {
        assert!(typed.contains(from), "{from}");
        typed = typed.replacen(from, to, 1);
    }
    assert_eq!(scene(&typed).unwrap(), scene(&plain).unwrap());
    let error = scene(&format!("{GOOD}{}", mesh("unit = \"kg\""))).unwrap_err();
    let expected = "found `kg`, expected a unit of length like \"mm\"";
    assert!(error.contains(expected), "{error}");
}
