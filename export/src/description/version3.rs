//! The model description of FMI 3.0.

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_model_description::fmi3::{
    Causality, CoSimulation, DefaultExperiment, EnumerationType, Kind, LogCategory,
    ModelDescription, StartValue, Variable,
};

use sphere_dda_fmu::runtime::document::{self, MEDIA_TYPE};
use sphere_dda_fmu::table::{Array, Arrays, Enumeration, Source, Value};
use sphere_dda_fmu::version::VERSION;

use super::definitions::{choices, units};

/// The description with the instantiation token `guid`: the same scene, identifier and version give the same bytes.
#[must_use]
pub fn describe(scene: &Scene, arrays: &Arrays, identifier: &str, guid: &str) -> ModelDescription {
    let interface = CoSimulation {
        can_get_and_set_fmu_state: true,
        can_serialize_fmu_state: true,
        provides_directional_derivatives: true,
        provides_adjoint_derivatives: true,
        max_output_derivative_order: 1,
        can_handle_variable_communication_step_size: true,
        provides_intermediate_update: true,
        can_return_early_after_intermediate_update: true,
        ..CoSimulation::new(identifier)
    };
    let spheres = scene.particles.len();
    let variables = arrays.list().iter().map(|a| variable(a, spheres)).collect();
    let mut model = ModelDescription::new(&scene.title, guid, interface).with_variables(variables);
    model.description =
        Some("Spheres and moving boundaries by discontinuous deformation analysis".to_owned());
    model.version = Some(VERSION.to_owned());
    model.license = Some("MIT OR Apache-2.0".to_owned());
    model.generation_tool = Some(format!("sphere-dda {VERSION}"));
    model.unit_definitions = units();
    let used = choices(arrays.list().iter().map(|a| a.choices));
    let definition = |c: &Enumeration| {
        let items = c.items.iter();
        EnumerationType::new(
            c.name,
            items.map(|&(name, value, text)| (name, value.into(), text)),
        )
    };
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
    // Of the spheres' rows and radii nothing that an importer sets decides anything.
    for unknown in &mut model.model_structure.initial_unknowns {
        let known = arrays.get(unknown.value_reference);
        if known.is_some_and(|array| array.causality == Causality::CalculatedParameter) {
            unknown.dependencies = Some(Vec::new());
        }
    }
    model
}

fn variable(array: &Array, spheres: usize) -> Variable {
    let extents: Vec<u64> = array.dimensions.iter().map(|&n| n as u64).collect();
    let mut variable = Variable::new(
        array.kind,
        &array.name,
        array.reference,
        array.causality,
        array.variability,
    )
    .with_dimensions(&extents);
    variable.description = Some(array.description.clone());
    variable.intermediate_update = matches!(array.causality, Causality::Input | Causality::Output);
    variable.unit = array.unit.map(str::to_owned);
    variable.declared_type = array.choices.map(|choices| choices.name.to_owned());
    variable.display_unit = (array.unit == Some("rad")).then(|| "deg".to_owned());
    let bound = |value: Option<f64>| {
        value.map(|value| match array.kind {
            Kind::Float64 => format!("{value:?}"),
            // Bounds of counts: the only integers of the table.
            _ => format!("{value}"),
        })
    };
    (variable.min, variable.max) = (bound(array.min), bound(array.max));
    let mut numbers = Vec::new();
    for start in &array.start {
        match start {
            Value::Real(value) => numbers.push(format!("{value:?}")),
            Value::Integer(value) => numbers.push(value.to_string()),
            Value::Boolean(value) => numbers.push(value.to_string()),
            Value::String(value) => variable.starts.push(StartValue {
                value: value.clone(),
            }),
        }
    }
    variable.start = (!numbers.is_empty()).then(|| numbers.join(" "));
    if array.source == Source::Document {
        variable.mime_type = Some(MEDIA_TYPE.to_owned());
        variable.max_size = u32::try_from(document::size(spheres)).ok();
    }
    variable
}
