//! Variables of FMI 3.0. Clocks are left out: they have no values that an importer without events could use.

use sphere_dda_model_description::fmi2::{Initial, Variability};
use sphere_dda_model_description::fmi3::{
    Causality, Dimension, ModelDescription, StartValue, Variable as Element,
};

use crate::value::{ScalarType, Value};

use super::declaration::{Items, MAX_ELEMENTS, Unit, Variable};

/// All variables but clocks, arrays with the sizes that structural parameters have at their start.
///
/// # Errors
///
/// Name and number of elements of the array that is too much.
pub(crate) fn variables(description: &ModelDescription) -> Result<Vec<Variable>, (String, String)> {
    let mut variables = Vec::new();
    let mut total = 0_u64;
    for variable in &description.model_variables {
        let scalar = match variable.scalar {
            ScalarType::Clock => continue,
            ScalarType::Enumeration => ScalarType::Int64,
            other => other,
        };
        let extents: Vec<u64> = variable
            .dimensions
            .iter()
            .map(|dimension| extent(description, dimension).unwrap_or(0))
            .collect();
        let mut factors = extents.iter();
        let elements = factors.try_fold(1_u64, |product, &next| product.checked_mul(next));
        total = total.saturating_add(elements.unwrap_or(u64::MAX));
        if total > MAX_ELEMENTS {
            let found = elements.map_or("more than 2^64".to_owned(), |found| found.to_string());
            return Err((variable.name.clone(), found));
        }
        variables.push(declared(description, variable, scalar, &extents));
    }
    Ok(variables)
}

/// The number, or the start value of the structural parameter that is named.
fn extent(description: &ModelDescription, dimension: &Dimension) -> Option<u64> {
    dimension.start.or_else(|| {
        let reference = dimension.value_reference?;
        let mut variables = description.model_variables.iter();
        let parameter = variables.find(|variable| variable.value_reference == reference)?;
        parameter.start.as_ref()?.trim().parse().ok()
    })
}

fn declared(
    description: &ModelDescription,
    variable: &Element,
    scalar: ScalarType,
    extents: &[u64],
) -> Variable {
    let unit = variable
        .unit
        .as_ref()
        .filter(|_| variable.scalar.is_float());
    let units = &description.unit_definitions;
    let types = &description.type_definitions;
    let variability = variable.effective_variability();
    Variable {
        name: variable.name.clone(),
        aliases: variable.aliases.iter().map(|a| a.name.clone()).collect(),
        reference: variable.value_reference,
        scalar,
        extents: (!extents.is_empty()).then(|| extents.iter().map(|&n| n as usize).collect()),
        causality: variable.causality,
        variability,
        // Structural parameters need configuration mode, which this importer does not enter.
        settable_at_start: match variable.causality {
            Causality::Independent | Causality::StructuralParameter => false,
            Causality::Input => true,
            _ => {
                variability != Variability::Constant
                    && matches!(
                        variable.effective_initial(),
                        Some(Initial::Exact | Initial::Approx)
                    )
            }
        },
        unit: unit.map(|name| Unit {
            name: name.clone(),
            base: units
                .iter()
                .find(|unit| unit.name == *name)
                .and_then(|unit| unit.base_unit),
        }),
        items: (variable.scalar == ScalarType::Enumeration).then(|| {
            let name = variable.declared_type.clone().unwrap_or_default();
            let known = types.iter().find(|known| known.name == name);
            let items = known.iter().flat_map(|known| &known.items);
            Items {
                items: items.map(|item| (item.name.clone(), item.value)).collect(),
                name,
            }
        }),
        range: [&variable.min, &variable.max].map(|bound| bound.as_ref()?.trim().parse().ok()),
        start: start(variable, scalar, extents.iter().product::<u64>() as usize),
    }
}

/// One value for each of the elements; a single one in the description holds for all of them.
fn start(variable: &Element, scalar: ScalarType, elements: usize) -> Vec<Value> {
    let texts: Vec<&str> = match scalar {
        ScalarType::String | ScalarType::Binary => variable.starts.iter().map(value).collect(),
        _ => {
            let text = variable.start.iter();
            text.flat_map(|text| text.split_ascii_whitespace())
                .collect()
        }
    };
    let values: Option<Vec<Value>> = texts.iter().map(|text| Value::read(scalar, text)).collect();
    match values.as_deref() {
        Some([one]) => vec![one.clone(); elements],
        Some(all) if all.len() == elements => all.to_vec(),
        _ => Vec::new(),
    }
}

fn value(start: &StartValue) -> &str {
    &start.value
}
