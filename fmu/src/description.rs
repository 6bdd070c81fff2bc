//! The model description of a scene, and the guid that ties it to its variable table.

pub mod version3;

use std::collections::BTreeMap;

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::archive;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::fmi2::{
    BaseType, BooleanVariable, CoSimulation, DefaultExperiment, EnumerationVariable,
    IntegerVariable, LogCategory, ModelDescription, RealVariable, ScalarVariable, SimpleType,
    StringVariable, VariableType,
};
use sphere_dda_model_description::units::{BaseUnit, Unit};

use crate::variables::{Arrays, Choices, Table, Value, Variable};

/// Name of the model in what the guid is a fingerprint of.
const UNTITLED: &str = "scene";

/// Version of this crate: part of the guid, so that a library and a description of another version part ways.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The model description of a scene with its `guid`: the same scene, identifier and version give the same bytes.
///
/// `identifier` names the shared library, a C identifier.
#[must_use]
pub fn describe(scene: &Scene, table: &Table, identifier: &str, guid: &str) -> ModelDescription {
    let mut model = unsigned(scene, table, identifier);
    model.guid = guid.to_owned();
    model
}

/// The guid, which is also the instantiation token of FMI 3.0: hash of version, scene content and both descriptions,
/// the library's name left out. One for both, so that a saved state of one is a state of the other.
///
/// # Errors
/// If a name or description of the scene has a character that XML cannot carry.
pub fn guid(scene: &Scene, table: &Table, arrays: &Arrays) -> Result<String, Error> {
    let mut text = unsigned(scene, table, "");
    let mut text3 = version3::describe(scene, arrays, "", "");
    // A scene without a title is called after its file, which has another name inside the FMU.
    text.model_name = UNTITLED.to_owned();
    text3.model_name = UNTITLED.to_owned();
    let (text, text3) = (text.to_xml()?, text3.to_xml()?);
    Ok(archive::guid(&[VERSION, &scene.hash, &text, &text3]))
}

/// The description with an empty guid.
fn unsigned(scene: &Scene, table: &Table, identifier: &str) -> ModelDescription {
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
    let mut model = ModelDescription::new(&scene.title, "", interface).with_variables(variables);
    model.description =
        Some("Spheres and moving boundaries by discontinuous deformation analysis".to_owned());
    model.version = Some(VERSION.to_owned());
    model.license = Some("MIT OR Apache-2.0".to_owned());
    model.generation_tool = Some(format!("sphere-dda {VERSION}"));
    model.unit_definitions = units();
    let used = choices(table.variables().iter().map(|v| v.choices));
    let definition = |c: &Choices| SimpleType::enumeration(c.name, c.items.iter().copied());
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

/// The enumerations among the variables, each once.
fn choices(
    used: impl Iterator<Item = Option<&'static Choices>>,
) -> BTreeMap<&'static str, &'static Choices> {
    used.flatten()
        .map(|choices| (choices.name, choices))
        .collect()
}

/// Every unit of the table, with SI exponents and display units.
#[must_use]
pub fn units() -> Vec<Unit> {
    const ONE: BaseUnit = BaseUnit::DIMENSIONLESS;
    let degrees = 180.0 / std::f64::consts::PI;
    let si = |name: &str, kg: i32, m: i32, s: i32| Unit::new(name, BaseUnit { kg, m, s, ..ONE });
    vec![
        si("s", 0, 0, 1).with_display_unit("ms", 1e3, 0.0),
        si("m", 0, 1, 0).with_display_unit("mm", 1e3, 0.0),
        si("m/s", 0, 1, -1),
        si("m/s2", 0, 1, -2),
        Unit::new("rad", BaseUnit { rad: 1, ..ONE }).with_display_unit("deg", degrees, 0.0),
        Unit::new(
            "rad/s",
            BaseUnit {
                rad: 1,
                s: -1,
                ..ONE
            },
        )
        .with_display_unit("deg/s", degrees, 0.0),
        si("kg", 1, 0, 0),
        si("kg/s", 1, 0, -1),
        si("kg.m/s", 1, 1, -1),
        si("kg.m2/s", 1, 2, -1),
        si("N", 1, 1, -2).with_display_unit("kN", 1e-3, 0.0),
        si("N.m", 1, 2, -2),
        si("J", 1, 2, -2),
        si("W", 1, 2, -3),
        si("Pa", 1, -1, -2).with_display_unit("kPa", 1e-3, 0.0),
    ]
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
