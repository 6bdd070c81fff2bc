//! Descriptions of FMI 3.0: what is written reads back, and every rule is broken once.

#[path = "version3/breakages.rs"]
mod breakages;

use breakages::{broken, small};
use sphere_dda_model_description::fmi3::{ModelDescription, Unknown};
use sphere_dda_model_description::{Error, Rule};

#[test]
fn the_text_of_a_small_model() {
    insta::assert_snapshot!(small().to_xml().unwrap());
}

#[test]
fn a_small_model_is_valid_and_reads_back() {
    let model = small();
    assert_eq!(model.validate(), []);
    assert_eq!(model.model_variables[2].elements(), Some(300));
    let references = |list: &[Unknown]| -> Vec<u32> {
        list.iter().map(|unknown| unknown.value_reference).collect()
    };
    assert_eq!(references(&model.model_structure.outputs), [2, 4, 5]);
    let unknowns = references(&model.model_structure.initial_unknowns);
    assert_eq!(unknowns, [2, 4, 5, 6]);
    let text = model.to_xml().unwrap();
    assert_eq!(ModelDescription::from_xml(&text).unwrap(), model);
}

#[test]
fn a_description_of_another_version_is_refused_with_its_version() {
    let text = small()
        .to_xml()
        .unwrap()
        .replace("fmiVersion=\"3.0\"", "fmiVersion=\"2.0\"");
    let refused = ModelDescription::from_xml(&text).unwrap_err();
    assert!(matches!(refused, Error::Version { found, .. } if found == "2.0"));
}

#[test]
fn a_patch_release_of_the_standard_is_read() {
    let text = small().to_xml().unwrap();
    let of = |version: &str| text.replace("fmiVersion=\"3.0\"", version);
    for version in ["3.0.2", "3.0.10"] {
        let found = ModelDescription::from_xml(&of(&format!("fmiVersion=\"{version}\"")));
        let found = found.unwrap();
        assert_eq!(found.model_variables, small().model_variables);
        assert_eq!(found.validate(), []);
    }
    for version in ["3.01", "3.0.", "3.0.x", "3.1"] {
        let found = ModelDescription::from_xml(&of(&format!("fmiVersion=\"{version}\"")));
        assert!(matches!(found, Err(Error::Version { .. })), "{version}");
    }
}

#[test]
fn every_broken_rule_is_found_alone() {
    for (rule, model) in broken() {
        let findings = model.validate();
        assert!(!findings.is_empty(), "{rule:?} is not found");
        for finding in findings {
            assert_eq!(finding.rule, rule, "{finding}");
        }
    }
}

#[test]
fn references_and_structure_are_judged_together() {
    let mut model = small();
    model.model_variables[5].value_reference = 4;
    let rules: Vec<Rule> = model.validate().iter().map(|f| f.rule).collect();
    let expected = [
        Rule::ReferenceUnique,
        Rule::StructureIndex,
        Rule::StructureIndex,
    ];
    assert_eq!(rules, expected);
}
