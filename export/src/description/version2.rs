//! The model description of FMI 2.0.

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_model_description::fmi2::{
    BooleanVariable, CoSimulation, DefaultExperiment, EnumerationVariable, IntegerVariable,
    LogCategory, ModelDescription, RealVariable, ScalarVariable, SimpleType, StringVariable,
    VariableType,
};
use sphere_dda_model_description::value::{ScalarType, Value};

use sphere_dda_fmu::table::{Entry, Enumeration, Table};
use sphere_dda_fmu::version::{VERSION, Version};

use super::definitions::{DESCRIPTION, choices, display_unit, units};

/// The model description of a scene with its `guid`: the same scene, identifier and version give the same bytes.
///
/// `identifier` names the shared library, a C identifier.
#[must_use]
pub fn describe(scene: &Scene, table: &Table, identifier: &str, guid: &str) -> ModelDescription {
    let interface = CoSimulation {
        can_handle_variable_communication_step_size: true,
        can_not_use_memory_management_functions: true,
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        can_interpolate_inputs: true,
        provides_directional_derivative: true,
        max_output_derivative_order: 1,
        ..CoSimulation::new(identifier)
    };
    let entries = table.entries(Version::Two);
    let variables = entries.iter().map(scalar_variable).collect();
    let mut model = ModelDescription::new(&scene.title, guid, interface).with_variables(variables);
    // A set changes no output before the next step: there is no algebraic loop through the FMU.
    for unknown in &mut model.model_structure.outputs {
        unknown.dependencies = Some(Vec::new());
    }
    // The model is its author's: what they do not say stays unsaid, but for what it computes.
    let about = &scene.about;
    let described = about.description.clone();
    model.description = described.or_else(|| Some(DESCRIPTION.to_owned()));
    model.author = about.author.clone();
    model.version = about.version.clone();
    model.copyright = about.copyright.clone();
    model.license = about.license.clone();
    model.generation_tool = Some(format!("sphere-dda {VERSION}"));
    let used = entries.iter().filter_map(|entry| entry.variable.unit);
    model.unit_definitions = units(used);
    let used = choices(entries.iter().map(|entry| entry.variable.choices));
    let definition = |c: &Enumeration| SimpleType::enumeration(c.name, c.items.iter().copied());
    model.type_definitions = used.into_values().map(definition).collect();
    model.log_categories = Category::ALL
        .iter()
        .map(|category| LogCategory::new(category.name(), category.description()))
        .collect();
    model.default_experiment = Some(DefaultExperiment {
        start_time: Some(0.0),
        stop_time: Some(scene.settings.duration),
        tolerance: None,
        step_size: Some(scene.settings.communication_step),
    });
    model
}

fn scalar_variable(entry: &Entry) -> ScalarVariable {
    let variable = entry.variable;
    ScalarVariable::new(
        entry.name(),
        entry.reference,
        variable.causality,
        variable.variability,
        variable_type(entry),
    )
    .with_description(entry.description())
}

fn variable_type(entry: &Entry) -> VariableType {
    let variable = entry.variable;
    let start = entry.start().first();
    let integer = match start {
        Some(Value::Integer(start)) => i32::try_from(*start).ok(),
        _ => None,
    };
    if let Some(choices) = variable.choices {
        return VariableType::Enumeration(EnumerationVariable {
            start: integer,
            ..EnumerationVariable::new(choices.name)
        });
    }
    match variable.scalar {
        ScalarType::Int32 => VariableType::Integer(IntegerVariable {
            // Bounds of integers are whole and of 32 bits.
            min: variable.min.map(|min| min as i32),
            max: variable.max.map(|max| max as i32),
            start: integer,
            ..IntegerVariable::new()
        }),
        ScalarType::Boolean => VariableType::Boolean(match start {
            Some(Value::Boolean(start)) => BooleanVariable::new().with_start(*start),
            _ => BooleanVariable::new(),
        }),
        ScalarType::String => VariableType::String(match start {
            Some(Value::String(start)) => StringVariable::new().with_start(start),
            _ => StringVariable::new(),
        }),
        _ => VariableType::Real(RealVariable {
            unit: variable.unit.map(str::to_owned),
            display_unit: variable.unit.and_then(display_unit).map(str::to_owned),
            min: variable.min,
            max: variable.max,
            start: match start {
                Some(Value::Real(start)) => Some(*start),
                _ => None,
            },
            ..RealVariable::new()
        }),
    }
}
