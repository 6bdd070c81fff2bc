//! Ways to break the small description, one rule each.

use sphere_dda_model_description::Rule;
use sphere_dda_model_description::Severity::{self, Error, Warning};
use sphere_dda_model_description::fmi2::{
    Causality, DependencyKind, EnumerationItem, Initial, IntegerVariable, ModelDescription,
    RealType, RealVariable, ScalarVariable, SimpleType, TypeDefinition, Unknown, Variability,
    VariableType,
};
use sphere_dda_model_description::units::{BaseUnit, Unit};

use crate::model::index::*;

mod header;
mod structure;
mod variables;

pub(crate) struct Case {
    pub(crate) what: &'static str,
    pub(crate) severity: Severity,
    pub(crate) rule: Rule,
    /// A part of the place that is reported.
    pub(crate) place: &'static str,
    pub(crate) break_it: fn(&mut ModelDescription),
}

const fn case(
    what: &'static str,
    severity: Severity,
    rule: Rule,
    place: &'static str,
    break_it: fn(&mut ModelDescription),
) -> Case {
    Case {
        what,
        severity,
        rule,
        place,
        break_it,
    }
}

type Model = ModelDescription;

fn variable(m: &mut Model, index: usize) -> &mut ScalarVariable {
    &mut m.model_variables[index - 1]
}

fn real(m: &mut Model, index: usize) -> &mut RealVariable {
    match &mut variable(m, index).variable_type {
        VariableType::Real(real) => real,
        other => panic!("{other:?}"),
    }
}

fn integer(m: &mut Model, index: usize) -> &mut IntegerVariable {
    match &mut variable(m, index).variable_type {
        VariableType::Integer(integer) => integer,
        other => panic!("{other:?}"),
    }
}

fn items(m: &mut Model) -> &mut Vec<EnumerationItem> {
    match &mut m.type_definitions[0].definition {
        TypeDefinition::Enumeration(enumeration) => &mut enumeration.items,
        other => panic!("{other:?}"),
    }
}

fn real_type(m: &mut Model, name: &str, real: RealType) {
    m.type_definitions.push(SimpleType {
        name: name.to_owned(),
        description: None,
        definition: TypeDefinition::Real(real),
    });
}

/// Adds a variable and brings the structure up to date.
fn add(m: &mut Model, variable: ScalarVariable) {
    let mut variables = std::mem::take(&mut m.model_variables);
    variables.push(variable);
    *m = m.clone().with_variables(variables);
}

fn local(name: &str, reference: u32, real: RealVariable) -> ScalarVariable {
    ScalarVariable::new(
        name,
        reference,
        Causality::Local,
        Variability::Continuous,
        real,
    )
}

/// A state `x` and its derivative, the latter exposed: indices 11 and 12.
fn expose_a_state(m: &mut Model, state: ScalarVariable, derivative: RealVariable) {
    add(m, state);
    add(m, local("der(x)", 21, derivative));
    m.model_structure.derivatives = vec![Unknown::new(12)];
    m.model_structure.initial_unknowns.push(Unknown::new(12));
}

/// All of them.
pub(crate) fn cases() -> impl Iterator<Item = &'static Case> {
    [header::CASES, variables::CASES, structure::CASES]
        .into_iter()
        .flatten()
}
