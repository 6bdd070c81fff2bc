//! Every rule of the validation, shown to fire, and to fire alone.

mod breakages;
mod model;
#[path = "version3/breakages.rs"]
mod version3;

use std::collections::BTreeSet;

use breakages::{Case, cases};
use sphere_dda_model_description::fmi2::{
    Causality, Initial, ModelDescription, RealVariable, ScalarVariable, Variability,
};
use sphere_dda_model_description::{Finding, Rule, Severity};

#[test]
fn each_breakage_is_found_and_nothing_else() {
    let mut wrong = Vec::new();
    for Case {
        what,
        severity,
        rule,
        place,
        break_it,
    } in cases()
    {
        let mut model = model::small();
        break_it(&mut model);
        let findings = model.validate();
        let alone = findings.iter().all(|finding| finding.rule == *rule);
        let placed = findings
            .iter()
            .any(|f| f.severity == *severity && f.place.contains(place));
        if findings.is_empty() || !alone || !placed {
            wrong.push(format!(
                "{what}: expected {severity:?} {rule:?} at {place}, found {findings:#?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn every_rule_has_a_breakage() {
    let source = include_str!("../src/finding.rs");
    let (_, rules) = source.split_once("pub enum Rule {").unwrap();
    // Those of terminals are broken in tests/terminals.rs.
    let (rules, _) = rules.split_once("// Terminals and icons").unwrap();
    let declared: BTreeSet<&str> = rules
        .lines()
        .map(str::trim)
        .filter(|line| !line.starts_with("//"))
        .filter_map(|line| line.strip_suffix(','))
        .collect();
    let version2 = cases().map(|case| case.rule);
    let version3 = version3::broken().map(|(rule, _)| rule);
    let broken: BTreeSet<String> = version2
        .chain(version3)
        .map(|rule| format!("{rule:?}"))
        .collect();
    assert!(declared.len() > 40);
    for rule in declared {
        assert!(broken.contains(rule), "no test breaks {rule}");
    }
}

#[test]
fn all_problems_come_at_once() {
    let mut model = model::small();
    model.guid.clear();
    model.log_categories.push(model.log_categories[0].clone());
    model.model_variables[1].name = "two words".to_owned();
    model.model_structure.outputs.pop();
    let rules: Vec<Rule> = model.validate().iter().map(|f| f.rule).collect();
    assert_eq!(
        rules,
        [
            Rule::RequiredAttribute,
            Rule::LogCategoryUnique,
            Rule::Name,
            Rule::Outputs,
        ]
    );
}

#[test]
fn a_finding_reads_as_a_sentence() {
    let mut model = model::small();
    model.model_variables[1].name = "two words".to_owned();
    let findings = model.validate();
    let [finding] = findings.as_slice() else {
        panic!("{findings:?}");
    };
    assert_eq!(
        finding.to_string(),
        "error: ModelVariables/ScalarVariable 2 `two words`: found ' ' at byte 3, expected `.`, \
         `[`, a letter, a digit, `_` or the end in a structured name"
    );
}

/// The table of section 2.2.7, written out as triples.
#[test]
fn the_table_of_causality_variability_and_initial() {
    use Causality as C;
    use Variability as V;
    const E: Initial = Initial::Exact;
    const A: Initial = Initial::Approx;
    const U: Initial = Initial::Calculated;
    let legal: &[(C, V, &[Initial])] = &[
        (C::Parameter, V::Fixed, &[E]),
        (C::Parameter, V::Tunable, &[E]),
        (C::CalculatedParameter, V::Fixed, &[U, A]),
        (C::CalculatedParameter, V::Tunable, &[U, A]),
        (C::Input, V::Discrete, &[]),
        (C::Input, V::Continuous, &[]),
        (C::Output, V::Constant, &[E]),
        (C::Output, V::Discrete, &[U, E, A]),
        (C::Output, V::Continuous, &[U, E, A]),
        (C::Local, V::Constant, &[E]),
        (C::Local, V::Fixed, &[U, A]),
        (C::Local, V::Tunable, &[U, A]),
        (C::Local, V::Discrete, &[U, E, A]),
        (C::Local, V::Continuous, &[U, E, A]),
        (C::Independent, V::Continuous, &[]),
    ];
    for causality in [
        C::Parameter,
        C::CalculatedParameter,
        C::Input,
        C::Output,
        C::Local,
        C::Independent,
    ] {
        for variability in [
            V::Constant,
            V::Fixed,
            V::Tunable,
            V::Discrete,
            V::Continuous,
        ] {
            let row = legal
                .iter()
                .find(|(c, v, _)| (*c, *v) == (causality, variability));
            for initial in [None, Some(E), Some(A), Some(U)] {
                let expected = row.is_some_and(|(_, _, initials)| {
                    initial.is_none_or(|initial| initials.contains(&initial))
                });
                let findings = one_variable(causality, variability, initial);
                let found = !findings
                    .iter()
                    .any(|f| matches!(f.rule, Rule::Combination | Rule::Initial));
                assert_eq!(
                    found, expected,
                    "{causality:?} {variability:?} {initial:?}: {findings:?}"
                );
                // With the start value it needs, a legal variable is clean.
                assert!(!expected || findings.is_empty(), "{findings:?}");
            }
            let default = row.and_then(|(_, _, initials)| initials.first().copied());
            let variable = ScalarVariable::new("x", 0, causality, variability, RealVariable::new());
            assert_eq!(variable.effective_initial(), default);
        }
    }
}

/// Findings of a description with one real variable that has a start value just
/// if it must.
fn one_variable(
    causality: Causality,
    variability: Variability,
    initial: Option<Initial>,
) -> Vec<Finding> {
    let mut variable = ScalarVariable::new("x", 0, causality, variability, RealVariable::new());
    variable.initial = initial;
    let exact = matches!(
        variable.effective_initial(),
        Some(Initial::Exact | Initial::Approx)
    );
    if exact || causality == Causality::Input {
        variable.variable_type = RealVariable::new().with_start(1.0).into();
    }
    let mut model = model::small();
    model.type_definitions.clear();
    model = model.with_variables(vec![variable]);
    model.validate()
}

/// Defaults of a declared type count for the variable.
#[test]
fn a_variable_takes_defaults_from_its_type() {
    use sphere_dda_model_description::fmi2::{RealType, SimpleType, TypeDefinition};
    let with_bounds = |own: RealVariable| -> ModelDescription {
        let mut model = model::small().with_variables(vec![ScalarVariable::new(
            "radius",
            0,
            Causality::Parameter,
            Variability::Fixed,
            RealVariable {
                declared_type: Some("Radius".to_owned()),
                ..own
            },
        )]);
        model.type_definitions = vec![SimpleType {
            name: "Radius".to_owned(),
            description: None,
            definition: TypeDefinition::Real(RealType {
                unit: Some("N".to_owned()),
                min: Some(0.0),
                ..RealType::default()
            }),
        }];
        model
    };
    let start = RealVariable::new().with_start(-1.0);
    let rules = |model: ModelDescription| -> Vec<(Severity, Rule)> {
        let findings = model.validate();
        findings.iter().map(|f| (f.severity, f.rule)).collect()
    };
    assert_eq!(
        rules(with_bounds(start.clone())),
        [(Severity::Error, Rule::StartRange)]
    );
    assert_eq!(rules(with_bounds(start.clone().with_min(-2.0))), []);
    let shown = start.with_min(-2.0).with_display_unit("kN");
    assert_eq!(rules(with_bounds(shown)), []);
}
