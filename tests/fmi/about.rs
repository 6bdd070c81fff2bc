//! What the author of a scene says of it, in the model description; nothing of this program's own.

use sphere_dda_export::description::{version2, version3};
use sphere_dda_model_description::{fmi2, fmi3};

use crate::{BOX, Scene};

/// Description, author, version, copyright and licence of both model descriptions, as read back from XML.
fn said(text: &str) -> [[Option<String>; 5]; 2] {
    let model = Scene::new(text).model;
    let two = version2::describe(&model.scene, &model.table, "box", &model.guid);
    let three = version3::describe(&model.scene, &model.table, "box", &model.guid);
    assert_eq!((two.validate(), three.validate()), (vec![], vec![]));
    for tool in [&two.generation_tool, &three.generation_tool] {
        assert!(tool.as_ref().unwrap().starts_with("sphere-dda "));
    }
    let two = fmi2::ModelDescription::from_xml(&two.to_xml().unwrap()).unwrap();
    let three = fmi3::ModelDescription::from_xml(&three.to_xml().unwrap()).unwrap();
    [
        [
            two.description,
            two.author,
            two.version,
            two.copyright,
            two.license,
        ],
        [
            three.description,
            three.author,
            three.version,
            three.copyright,
            three.license,
        ],
    ]
}

#[test]
fn a_scene_says_whose_model_it_is() {
    let texts = [
        "Balls \"in\" a <box> & more",
        "Änne Müller",
        "1.2-beta",
        "© 2026 Müller",
        "CC-BY-4.0",
    ];
    let keys = ["description", "author", "version", "copyright", "license"];
    let lines: Vec<String> = keys
        .iter()
        .zip(texts)
        .map(|(key, text)| format!("{key} = '{text}'\n"))
        .collect();
    let expected = texts.map(|text| Some(text.to_owned()));
    assert_eq!(
        said(&format!("{}{BOX}", lines.concat())),
        [expected.clone(), expected]
    );
}

#[test]
fn a_silent_scene_has_no_author_version_or_licence() {
    for text in [BOX.to_owned(), format!("author = ''\nlicense = ''{BOX}")] {
        for [description, rest @ ..] in said(&text) {
            assert!(description.unwrap().starts_with("Spheres and moving"));
            assert_eq!(rest, [const { None }; 4]);
        }
    }
}
