//! What other tools write, and what nobody should.

mod model;

use sphere_dda_model_description::fmi2::{
    Causality, DependencyKind, Initial, ModelDescription, NamingConvention, TypeDefinition,
    Variability, VariableType,
};
use sphere_dda_model_description::{Error, MAX_ATTRIBUTES, MAX_BYTES, MAX_DEPTH, Rule, Severity};

const BOUNCING_BALL: &str = include_str!("samples/bouncing_ball.xml");
const DAHLQUIST: &str = include_str!("samples/dahlquist.xml");
const FEEDTHROUGH: &str = include_str!("samples/feedthrough.xml");
const OPEN_MODELICA: &str = include_str!("samples/openmodelica.xml");
const SIMULINK: &str = include_str!("samples/simulink.xml");

fn read(text: &str) -> ModelDescription {
    ModelDescription::from_xml(text).unwrap_or_else(|error| panic!("{error}"))
}

fn refuse(text: &str) -> Error {
    match ModelDescription::from_xml(text) {
        Ok(model) => panic!("read {model:?}"),
        Err(error) => error,
    }
}

/// A description around `variables`, on the lines 3 and on.
fn around(variables: &str) -> String {
    format!(
        "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"m\" guid=\"g\">\n\
         <ModelVariables>\n{variables}\n</ModelVariables><ModelStructure/></fmiModelDescription>"
    )
}

#[test]
fn samples_read_back_after_writing() {
    for text in [
        BOUNCING_BALL,
        DAHLQUIST,
        FEEDTHROUGH,
        OPEN_MODELICA,
        SIMULINK,
    ] {
        let model = read(text);
        assert_eq!(read(&model.to_xml().unwrap()), model);
    }
}

#[test]
fn both_interfaces() {
    let model = read(BOUNCING_BALL);
    assert_eq!(model.validate(), []);
    assert_eq!(model.variable_naming_convention, NamingConvention::Flat);
    assert_eq!(
        model.model_exchange.unwrap().model_identifier,
        "BouncingBall"
    );
    let interface = model.co_simulation.unwrap();
    assert!(interface.can_get_and_set_fmu_state, "`1` is true");

    let names: Vec<&str> = model
        .model_variables
        .iter()
        .map(|variable| variable.name.as_str())
        .collect();
    assert_eq!(
        names,
        ["time", "h", "der(h)", "v", "der(v)", "g", "e", "v_min"]
    );
    let height = &model.model_variables[1];
    assert_eq!(height.initial, Some(Initial::Exact));
    let VariableType::Real(real) = &height.variable_type else {
        panic!("{height:?}");
    };
    assert_eq!(real.start, Some(1.0));
    assert_eq!(real.reinit, Some(true));
    assert_eq!(real.declared_type.as_deref(), Some("Position"));
    assert_eq!(model.model_variables[2].derivative(), Some(2));
    // Causality by default.
    assert_eq!(model.model_variables[7].causality, Causality::Local);

    let structure = model.model_structure;
    assert_eq!(
        structure.outputs[0].dependencies_kind,
        Some(vec![DependencyKind::Constant])
    );
    // None at all is not the same as not stated.
    assert_eq!(structure.derivatives[1].dependencies, Some(vec![]));
    assert_eq!(structure.initial_unknowns[1].dependencies, None);
}

#[test]
fn co_simulation_only() {
    let model = read(DAHLQUIST);
    assert_eq!(model.validate(), []);
    assert!(model.model_exchange.is_none());
    let experiment = model.default_experiment.unwrap();
    assert_eq!(experiment.step_size, Some(0.1), "blanks around a number");
    assert_eq!(
        model.model_structure.initial_unknowns[0].dependencies,
        Some(vec![2, 4])
    );
}

#[test]
fn every_base_type() {
    let model = read(FEEDTHROUGH);
    let findings = model.validate();
    // The infinite start value, put there on purpose.
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!(findings[0].rule, Rule::StartFinite);
    assert_eq!(findings[0].severity, Severity::Warning);
    let kinds: Vec<&TypeDefinition> = model
        .type_definitions
        .iter()
        .map(|simple| &simple.definition)
        .collect();
    assert!(matches!(
        kinds.as_slice(),
        [
            TypeDefinition::Enumeration(_),
            TypeDefinition::Integer(_),
            TypeDefinition::Boolean,
            TypeDefinition::String,
        ]
    ));
    let VariableType::Integer(integer) = &model.model_variables[7].variable_type else {
        panic!();
    };
    assert_eq!(integer.start, Some(0));
    let VariableType::Boolean(boolean) = &model.model_variables[9].variable_type else {
        panic!();
    };
    assert_eq!(boolean.start, Some(false));
    let VariableType::String(string) = &model.model_variables[11].variable_type else {
        panic!();
    };
    assert_eq!(string.start.as_deref(), Some("Set me!"));
}

#[test]
fn vendor_annotations_and_comments() {
    let model = read(OPEN_MODELICA);
    assert!(model.co_simulation.is_none());
    assert_eq!(model.model_variables.len(), 6);
    assert_eq!(model.unit_definitions[0].base_unit, None);
    assert_eq!(model.unit_definitions[1].display_units[0].name, "deg");
    // `$cse1` is no structured name, as the tool well knows.
    let rules: Vec<Rule> = model.validate().iter().map(|f| f.rule).collect();
    assert_eq!(rules, [Rule::Name]);
    assert_eq!(
        model.model_variables[4].variability,
        Variability::Fixed,
        "attributes in any order"
    );
}

#[test]
fn unknown_elements_and_attributes() {
    let model = read(SIMULINK);
    assert_eq!(model.validate(), []);
    let names: Vec<&str> = model
        .unit_definitions
        .iter()
        .map(|unit| unit.name.as_str())
        .collect();
    assert_eq!(names, ["N*m", "degC"], "a foreign element between the two");
    assert_eq!(model.unit_definitions[1].base_unit.unwrap().offset, 273.15);
    assert_eq!(model.model_variables[3].value_reference, u32::MAX);
    // The element of that name in the annotation is not the variable's.
    let VariableType::Real(real) = &model.model_variables[2].variable_type else {
        panic!();
    };
    assert_eq!(real.start, Some(20.0));
}

#[test]
fn a_byte_order_mark_and_odd_line_ends() {
    let text = format!("\u{feff}{}", DAHLQUIST.replace('\n', "\r\n"));
    assert_eq!(read(&text), read(DAHLQUIST));
}

#[test]
fn elements_in_another_order() {
    let model = model::small();
    let text = model.to_xml().unwrap();
    let start = text.find("  <ModelStructure>").unwrap();
    let end = text.find("</fmiModelDescription>").unwrap();
    let structure = &text[start..end];
    let moved = text.replacen(structure, "", 1).replacen(
        "  <CoSimulation",
        &format!("{structure}  <CoSimulation"),
        1,
    );
    assert_ne!(moved, text);
    assert_eq!(read(&moved), model);
}

#[test]
fn a_document_type_is_refused() {
    let bomb = format!(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">\
         <!ENTITY c SYSTEM \"file:///etc/passwd\">]>\n{}",
        around("")
    );
    assert_eq!(refuse(&bomb), Error::Doctype { line: 2, column: 1 });
    let entity =
        around("<ScalarVariable name=\"&b;\" valueReference=\"0\"><Real/></ScalarVariable>");
    assert!(matches!(refuse(&entity), Error::Content { line: 3, .. }));
}

#[test]
fn malformed_text() {
    let good = model::small().to_xml().unwrap();
    let cut = |marker: &str| good[..good.find(marker).unwrap()].to_owned();
    let cases = [
        ("nothing", String::new()),
        ("blanks", " \n\t ".to_owned()),
        ("no XML", "PK\u{3}\u{4}".to_owned()),
        ("plain text", "model".to_owned()),
        ("a declaration only", "<?xml version=\"1.0\"?>".to_owned()),
        ("an end too early", cut("<UnitDefinitions>")),
        ("an end in a tag", cut("modelName")),
        (
            "an end in a comment",
            format!("{}<!-- ", cut("<UnitDefinitions>")),
        ),
        (
            "crossed tags",
            good.replacen("</UnitDefinitions>", "</TypeDefinitions>", 1),
        ),
        (
            "an end tag too many",
            format!("{good}</fmiModelDescription>"),
        ),
        ("two roots", format!("{good}{}", around(""))),
        ("text after the root", format!("{good}more")),
        ("text before the root", format!("more{}", around(""))),
        (
            "an attribute twice",
            good.replacen("guid=", "modelName=", 1),
        ),
        ("no quotes", good.replacen("\"{5f3a}\"", "5f3a", 1)),
        (
            "a control character",
            good.replacen("Hopper", "Hop\u{1}per", 1),
        ),
    ];
    for (what, text) in cases {
        let error = refuse(&text);
        assert!(
            matches!(&error, Error::Malformed { line, column, .. } if *line >= 1 && *column >= 1),
            "{what}: {error:?}"
        );
    }
}

#[test]
fn another_document_or_version() {
    assert_eq!(
        refuse("<html fmiVersion=\"2.0\"/>"),
        Error::Root {
            found: "html".to_owned(),
            expected: "fmiModelDescription"
        }
    );
    for (attribute, found) in [
        ("fmiVersion=\"3.0\"", "3.0"),
        ("fmiVersion=\"1.0\"", "1.0"),
        ("", ""),
    ] {
        let text = format!("<fmiModelDescription {attribute} modelName=\"m\"/>");
        let error = refuse(&text);
        let expected = Error::Version {
            attribute: "fmiVersion",
            found: found.to_owned(),
            expected: "2.0",
        };
        assert_eq!(error, expected);
    }
}

#[test]
fn content_that_the_schema_refuses() {
    let good = model::small().to_xml().unwrap();
    let replaced = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, to, 1)
    };
    let cases = [
        (replaced(" guid=\"{5f3a}\"", ""), "guid"),
        (replaced("\"structured\"", "\"wild\""), "wild"),
        (
            replaced("<ModelStructure>", "<Structure>")
                .replace("</ModelStructure>", "</Structure>"),
            "ModelStructure",
        ),
        (
            replaced("modelIdentifier=\"sphere_dda\"", ""),
            "modelIdentifier",
        ),
        (
            replaced(
                "canInterpolateInputs=\"true\"",
                "canInterpolateInputs=\"yes\"",
            ),
            "`yes`",
        ),
        (
            replaced(
                "maxOutputDerivativeOrder=\"1\"",
                "maxOutputDerivativeOrder=\"-1\"",
            ),
            "`-1`",
        ),
        (replaced("factor=\"0.001\"", "factor=\"1,5\""), "`1,5`"),
        (
            replaced("<BaseUnit s=\"1\"/>", "<BaseUnit s=\"0.5\"/>"),
            "`0.5`",
        ),
        (
            replaced("<Enumeration>", "<Integer/><Enumeration>"),
            "found 2 of the elements",
        ),
        (
            replaced("<Integer min=\"0\"/>", ""),
            "found 0 of the elements",
        ),
        (
            replaced("<Integer min=\"0\"/>", "<Integer/><Real/>"),
            "`contactCount`: found 2",
        ),
        (replaced("valueReference=\"4\"", ""), "valueReference"),
        (
            replaced("valueReference=\"4\"", "valueReference=\"4294967296\""),
            "`4294967296`",
        ),
        (
            replaced("causality=\"input\"", "causality=\"Input\""),
            "Input",
        ),
        (replaced("initial=\"exact\"", "initial=\"\""), "variant"),
        (replaced("start=\"200\"", "start=\"2e2\""), "`2e2`"),
        (
            replaced("<Boolean start=\"false\"", "<Boolean start=\"\""),
            "``",
        ),
        (
            replaced("declaredType=\"Preconditioner\" ", ""),
            "declaredType",
        ),
        (replaced("value=\"1\" ", ""), "value"),
        (replaced("<Unknown index=\"3\"/>", "<Unknown/>"), "index"),
        (
            replaced(
                "<Unknown index=\"3\"/>",
                "<Unknown index=\"3\" dependencies=\"1;2\"/>",
            ),
            "`1;2`",
        ),
        (
            replaced(
                "<Unknown index=\"3\"/>",
                "<Unknown index=\"3\" dependenciesKind=\"some\"/>",
            ),
            "`some`",
        ),
        (
            replaced("<LogCategories>", "<DefaultExperiment/><LogCategories>"),
            "DefaultExperiment",
        ),
    ];
    for (text, part) in cases {
        match refuse(&text) {
            Error::Content { problem, line, .. } => {
                assert!(problem.contains(part), "{part}: {problem}");
                assert!(line > 1);
            }
            other => panic!("{part}: {other:?}"),
        }
    }
}

#[test]
fn an_error_says_where() {
    let text = around(
        "<ScalarVariable name=\"a\" valueReference=\"0\"><Real/></ScalarVariable>\n  \
         <ScalarVariable name=\"b\" valueReference=\"1\"><Real start=\"fast\"/></ScalarVariable>",
    );
    assert_eq!(
        refuse(&text).to_string(),
        "line 4, column 47, near `<Real start=\"fast\"/></ScalarVariable>`: found `fast`, \
         expected a real number (xs:double)"
    );
}

#[test]
fn limits() {
    let nested = |depth: usize| {
        let inner = format!("{}{}", "<x>".repeat(depth), "</x>".repeat(depth));
        around("").replace("<ModelStructure/>", &format!("{inner}<ModelStructure/>"))
    };
    read(&nested(MAX_DEPTH - 1));
    for depth in [MAX_DEPTH, 100_000] {
        let error = refuse(&nested(depth));
        assert!(
            matches!(
                error,
                Error::Limit {
                    limit: MAX_DEPTH,
                    ..
                }
            ),
            "{error}"
        );
    }

    let wide = |count: usize| {
        let attributes: String = (0..count).map(|i| format!(" a{i}=\"\"")).collect();
        around("").replace("<ModelVariables>", &format!("<ModelVariables{attributes}>"))
    };
    read(&wide(MAX_ATTRIBUTES));
    for count in [MAX_ATTRIBUTES + 1, 100_000] {
        let error = refuse(&wide(count));
        assert!(
            matches!(
                error,
                Error::Limit {
                    limit: MAX_ATTRIBUTES,
                    ..
                }
            ),
            "{error}"
        );
    }

    let found = MAX_BYTES + 1;
    let expected = Error::TooLarge {
        found,
        limit: MAX_BYTES,
    };
    // Zeros cost no memory until they are written to.
    let text = String::from_utf8(vec![0; found]).unwrap();
    assert_eq!(refuse(&text), expected);
}

/// A long list of unknown elements between two known ones costs no more than the
/// text is long.
#[test]
fn a_flood_of_unknown_elements() {
    let variable = |i: usize| {
        format!("<ScalarVariable name=\"v{i}\" valueReference=\"{i}\"><Real/></ScalarVariable>")
    };
    let flood = "<x a=\"1\"/>".repeat(100_000);
    let model = read(&around(&format!("{}{flood}{}", variable(0), variable(1))));
    assert_eq!(model.model_variables.len(), 2);
    let interleaved: String = (0..2_000).map(|i| variable(i) + "<x/>text<y/>").collect();
    assert_eq!(read(&around(&interleaved)).model_variables.len(), 2_000);
}
