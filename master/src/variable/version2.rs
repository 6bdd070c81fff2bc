//! Variables of FMI 2.0.

use sphere_dda_model_description::fmi2::{
    Causality, Initial, ModelDescription, RealType, ScalarVariable, TypeDefinition, Variability,
    VariableType,
};
use sphere_dda_model_description::fmi3;

use crate::value::{ScalarType, Value};

use super::declaration::{Items, Unit, Variable};

/// All variables.
pub(crate) fn variables(description: &ModelDescription) -> Vec<Variable> {
    let scalars = description.model_variables.iter();
    scalars
        .map(|scalar| variable(description, scalar))
        .collect()
}

fn variable(description: &ModelDescription, scalar: &ScalarVariable) -> Variable {
    let mut unit = None;
    let mut items = None;
    let mut range = [None; 2];
    let (own_type, start) = match &scalar.variable_type {
        VariableType::Real(real) => {
            let name = real.unit.as_deref().or_else(|| {
                match definition(description, real.declared_type.as_deref()?)? {
                    TypeDefinition::Real(RealType { unit, .. }) => unit.as_deref(),
                    _ => None,
                }
            });
            let units = &description.unit_definitions;
            unit = name.map(|name| Unit {
                name: name.to_owned(),
                base: units
                    .iter()
                    .find(|unit| unit.name == name)
                    .and_then(|unit| unit.base_unit),
            });
            range = [real.min, real.max];
            (ScalarType::Float64, real.start.map(Value::Real))
        }
        VariableType::Integer(own) => {
            range = [own.min, own.max].map(|bound| bound.map(f64::from));
            (
                ScalarType::Int32,
                own.start.map(i64::from).map(Value::Integer),
            )
        }
        VariableType::Boolean(own) => (ScalarType::Boolean, own.start.map(Value::Boolean)),
        VariableType::String(own) => (ScalarType::String, own.start.clone().map(Value::String)),
        VariableType::Enumeration(own) => {
            items = Some(Items {
                name: own.declared_type.clone(),
                items: match definition(description, &own.declared_type) {
                    Some(TypeDefinition::Enumeration(known)) => known
                        .items
                        .iter()
                        .map(|item| (item.name.clone(), i64::from(item.value)))
                        .collect(),
                    _ => Vec::new(),
                },
            });
            (
                ScalarType::Int32,
                own.start.map(i64::from).map(Value::Integer),
            )
        }
    };
    Variable {
        name: scalar.name.clone(),
        aliases: Vec::new(),
        reference: scalar.value_reference,
        scalar: own_type,
        extents: None,
        causality: causality(scalar.causality),
        variability: scalar.variability,
        settable_at_start: settable_at_start(scalar),
        unit,
        items,
        range,
        start: start.into_iter().collect(),
    }
}

fn definition<'a>(description: &'a ModelDescription, name: &str) -> Option<&'a TypeDefinition> {
    let mut types = description.type_definitions.iter();
    types
        .find(|known| known.name == name)
        .map(|known| &known.definition)
}

fn causality(causality: Causality) -> fmi3::Causality {
    match causality {
        Causality::Parameter => fmi3::Causality::Parameter,
        Causality::CalculatedParameter => fmi3::Causality::CalculatedParameter,
        Causality::Input => fmi3::Causality::Input,
        Causality::Output => fmi3::Causality::Output,
        Causality::Local => fmi3::Causality::Local,
        Causality::Independent => fmi3::Causality::Independent,
    }
}

/// Section 2.2.7 of FMI 2.0.
fn settable_at_start(scalar: &ScalarVariable) -> bool {
    match scalar.causality {
        Causality::Independent => false,
        Causality::Input => true,
        _ => {
            scalar.variability != Variability::Constant
                && matches!(
                    scalar.effective_initial(),
                    Some(Initial::Exact | Initial::Approx)
                )
        }
    }
}
