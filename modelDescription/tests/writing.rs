//! What is written: the text itself, and that it reads back to the same.

mod any;
mod model;

use proptest::prelude::*;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::fmi2::{
    Causality, CoSimulation, Initial, ModelDescription, ModelStructure, RealVariable,
    ScalarVariable, Unknown, Variability, VariableType,
};

/// The text is part of the unit that ships. Accept a change only if an importer
/// was shown to read the new text.
#[test]
fn the_text_of_a_small_model() {
    insta::assert_snapshot!(model::small().to_xml().unwrap());
}

#[test]
fn a_small_model_reads_back_and_is_valid() {
    let model = model::small();
    assert_eq!(model.validate(), []);
    let text = model.to_xml().unwrap();
    assert_eq!(ModelDescription::from_xml(&text).unwrap(), model);
}

#[test]
fn writing_is_deterministic() {
    let text = model::small().to_xml().unwrap();
    let again = ModelDescription::from_xml(&text).unwrap().to_xml().unwrap();
    assert_eq!(text, again);
}

#[test]
fn numbers_are_short_and_exact() {
    for (value, written) in [
        (0.1, "0.1"),
        (-0.0, "-0.0"),
        (1e300, "1e300"),
        (5e-324, "5e-324"),
        (1.0 / 3.0, "0.3333333333333333"),
        (f64::INFINITY, "INF"),
        (f64::NEG_INFINITY, "-INF"),
    ] {
        let mut model = model::small();
        real(&mut model).start = Some(value);
        let text = model.to_xml().unwrap();
        assert!(text.contains(&format!("start=\"{written}\"")), "{text}");
        let mut back = ModelDescription::from_xml(&text).unwrap();
        let bits = real(&mut back).start.map(f64::to_bits);
        assert_eq!(bits, Some(value.to_bits()));
    }
}

#[test]
fn every_character_of_xml_survives() {
    let hard = "<&>\"' \t\n\r\u{85}\u{2028} é 漢 🦀 ]]> <!-- &amp; &#10; %s";
    let mut model = model::small();
    model.description = Some(hard.to_owned());
    let text = model.to_xml().unwrap();
    let back = ModelDescription::from_xml(&text).unwrap();
    assert_eq!(back.description.as_deref(), Some(hard));
}

#[test]
fn a_character_that_xml_cannot_carry_is_refused() {
    for found in ['\0', '\u{8}', '\u{1f}', '\u{fffe}'] {
        let mut model = model::small();
        model.author = Some(format!("A{found}B"));
        let error = model.to_xml().unwrap_err();
        assert!(
            matches!(&error, Error::Character { found: f, near } if *f == found && near.contains("author=\"A")),
            "{error}"
        );
    }
}

#[test]
fn empty_lists_are_absent() {
    let model = ModelDescription::new("m", "g", CoSimulation::new("m"));
    let text = model.to_xml().unwrap();
    for element in [
        "UnitDefinitions",
        "TypeDefinitions",
        "LogCategories",
        "Outputs",
        "Derivatives",
        "InitialUnknowns",
        "VendorAnnotations",
    ] {
        assert!(!text.contains(element), "{text}");
    }
    assert!(text.contains("<ModelStructure/>"), "{text}");
    assert_eq!(ModelDescription::from_xml(&text).unwrap(), model);
}

#[test]
fn the_structure_follows_from_the_variables() {
    let structure = model::small().model_structure;
    let indices = |unknowns: &[Unknown]| unknowns.iter().map(|u| u.index).collect::<Vec<_>>();
    assert_eq!(indices(&structure.outputs), [3, 4]);
    assert_eq!(indices(&structure.initial_unknowns), [3, 4, 9]);
    assert_eq!(structure.derivatives, []);
    assert!(structure.outputs.iter().all(|u| u.dependencies.is_none()));
}

/// An output that starts exactly is known to the initialization.
#[test]
fn an_exact_output_is_no_initial_unknown() {
    let output = |initial| {
        ScalarVariable::new(
            "y",
            0,
            Causality::Output,
            Variability::Continuous,
            RealVariable::new().with_start(1.0),
        )
        .with_initial(initial)
    };
    for (initial, unknowns) in [
        (Initial::Exact, 0),
        (Initial::Approx, 1),
        (Initial::Calculated, 1),
    ] {
        let structure = ModelStructure::from_variables(&[output(initial)]);
        assert_eq!(structure.outputs.len(), 1);
        assert_eq!(structure.initial_unknowns.len(), unknowns, "{initial:?}");
    }
}

#[test]
fn a_large_model_reads_back() {
    let variables = (0..20_000)
        .map(|i| {
            ScalarVariable::new(
                format!("sphere[{i}].position[1]"),
                i,
                Causality::Output,
                Variability::Continuous,
                RealVariable::new(),
            )
        })
        .collect();
    let model =
        ModelDescription::new("large", "g", CoSimulation::new("large")).with_variables(variables);
    let text = model.to_xml().unwrap();
    let back = ModelDescription::from_xml(&text).unwrap();
    assert_eq!(back, model);
    assert_eq!(back.validate(), []);
}

fn real(model: &mut ModelDescription) -> &mut RealVariable {
    match &mut model.model_variables[model::index::VELOCITY - 1].variable_type {
        VariableType::Real(real) => real,
        other => panic!("{other:?}"),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any description, sensible or not, reads back to itself, and validation
    /// copes with it.
    #[test]
    fn any_model_reads_back(model in any::description()) {
        let text = model.to_xml().unwrap();
        let back = ModelDescription::from_xml(&text);
        prop_assert_eq!(back.as_ref(), Ok(&model), "{}", text);
        for finding in model.validate() {
            prop_assert!(!finding.place.is_empty());
            prop_assert!(!finding.found.is_empty() && !finding.expected.is_empty());
        }
    }

    /// Whatever stands in the text, reading ends in a value or an error.
    #[test]
    fn any_damage_is_an_error(position in any::<proptest::sample::Index>(), junk in any::text(), cut in 0..40_usize) {
        let text: Vec<char> = model::small().to_xml().unwrap().chars().collect();
        let at = position.index(text.len());
        let end = (at + cut).min(text.len());
        let damaged: String = text[..at].iter().copied().chain(junk.chars()).chain(text[end..].iter().copied()).collect();
        if let Ok(model) = ModelDescription::from_xml(&damaged) {
            model.validate();
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in ".{0,200}") {
        prop_assert!(ModelDescription::from_xml(&text).is_err());
    }
}
