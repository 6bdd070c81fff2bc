//! Model descriptions and terminals. What is read is judged and written again.

use sphere_dda_export::description::{version2, version3};
use sphere_dda_fmu::model::Model;
use sphere_dda_model_description::terminals::TerminalsAndIcons;
use sphere_dda_model_description::{fmi2, fmi3};

use super::Target;

pub(super) struct Xml;

impl Target for Xml {
    fn name(&self) -> &'static str {
        "xml"
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("scene.toml");
        std::fs::write(&path, include_str!("corpus/machine.toml")).expect("a file in it");
        let model = Model::read(&path, None).expect("the scene is sound");
        let two = version2::describe(&model.scene, &model.table, "box", &model.guid);
        let three = version3::describe(&model.scene, &model.table, "box", &model.guid);
        let terminals = "<fmiTerminalsAndIcons fmiVersion=\"3.0\"><Terminals><Terminal name=\"a\" matchingRule=\"bus\">\
                         <TerminalMemberVariable variableName=\"a.x\" memberName=\"x\" variableKind=\"signal\"/>\
                         </Terminal></Terminals></fmiTerminalsAndIcons>";
        let texts = [two.to_xml(), three.to_xml(), Ok(terminals.to_owned())];
        texts
            .into_iter()
            .flatten()
            .map(String::into_bytes)
            .collect()
    }

    fn attempt(&self, input: &[u8]) -> bool {
        let text = String::from_utf8_lossy(input);
        let two = fmi2::ModelDescription::from_xml(&text).is_ok_and(|description| {
            let _judged = description.validate();
            let _written = description.to_xml();
            true
        });
        let three = fmi3::ModelDescription::from_xml(&text).is_ok_and(|description| {
            let _judged = description.validate();
            let _written = description.to_xml();
            true
        });
        two || three || TerminalsAndIcons::from_xml(&text).is_ok()
    }
}
