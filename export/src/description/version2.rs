//! The model description of FMI 2.0.

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_model_description::fmi2::{
    BaseType, BooleanVariable, CoSimulation, DefaultExperiment, EnumerationVariable,
    IntegerVariable, LogCategory, ModelDescription, RealVariable, ScalarVariable, SimpleType,
    StringVariable, VariableType,
};

use sphere_dda_fmu::table::{Enumeration, Table, Value, Variable};
use sphere_dda_fmu::version::VERSION;

use super::definitions::{choices, units};

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
    let variables = table.variables().iter().map(scalar_variable).collect();
    let mut model = ModelDescription::new(&scene.title, guid, interface).with_variables(variables);
    model.description =
        Some("Spheres and moving boundaries by discontinuous deformation analysis".to_owned());
    model.version = Some(VERSION.to_owned());
    model.license = Some("MIT OR Apache-2.0".to_owned());
    model.generation_tool = Some(format!("sphere-dda {VERSION}"));
    model.unit_definitions = units();
    let used = choices(table.variables().iter().map(|v| v.choices));
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

fn scalar_variable(variable: &Variable) -> ScalarVariable {
    ScalarVariable::new(
        &variable.name,
        variable.reference,
        variable.causality,
        variable.variability,
        variable_type(variable),
    )
    .with_description(&variable.description)
}

fn variable_type(variable: &Variable) -> VariableType {
    if let Some(choices) = variable.choices {
        return VariableType::Enumeration(EnumerationVariable {
            start: match variable.start {
                Some(Value::Integer(start)) => Some(start),
                _ => None,
            },
            ..EnumerationVariable::new(choices.name)
        });
    }
    match variable.base {
        BaseType::Real => VariableType::Real(RealVariable {
            unit: variable.unit.map(str::to_owned),
            display_unit: match variable.unit {
                Some("rad") => Some("deg".to_owned()),
                _ => None,
            },
            min: variable.min,
            max: variable.max,
            start: match variable.start {
                Some(Value::Real(start)) => Some(start),
                _ => None,
            },
            ..RealVariable::new()
        }),
        BaseType::Integer => VariableType::Integer(IntegerVariable {
            // Bounds of counts: the only integers of the table.
            min: variable.min.map(|_| 0),
            start: match variable.start {
                Some(Value::Integer(start)) => Some(start),
                _ => None,
            },
            ..IntegerVariable::new()
        }),
        BaseType::Boolean => VariableType::Boolean(match variable.start {
            Some(Value::Boolean(start)) => BooleanVariable::new().with_start(start),
            _ => BooleanVariable::new(),
        }),
        BaseType::String => VariableType::String(match &variable.start {
            Some(Value::String(start)) => StringVariable::new().with_start(start),
            _ => StringVariable::new(),
        }),
    }
}
