//! The model description of FMI 3.0.

use sphere_dda::scene::Scene;
use sphere_dda_fmi_interface::log::Category;
use sphere_dda_model_description::fmi3::{
    Causality, CoSimulation, DefaultExperiment, EnumerationType, LogCategory, ModelDescription,
    StartValue, Variable,
};
use sphere_dda_model_description::value::{ScalarType, Value};

use sphere_dda_fmu::runtime::{contacts, document};
use sphere_dda_fmu::table::{Binding, Entry, Enumeration, Table};
use sphere_dda_fmu::version::{VERSION, Version};

use super::definitions::{DESCRIPTION, choices, display_unit, units};

/// The description with the instantiation token `guid`: the same scene, identifier and version give the same bytes.
#[must_use]
pub fn describe(scene: &Scene, table: &Table, identifier: &str, guid: &str) -> ModelDescription {
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
    let entries = table.entries(Version::Three);
    let variables = entries.iter().map(|e| variable(e, spheres)).collect();
    let mut model = ModelDescription::new(&scene.title, guid, interface).with_variables(variables);
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
    // A set changes no output before the next step: there is no algebraic loop through the FMU.
    for unknown in &mut model.model_structure.outputs {
        unknown.dependencies = Some(Vec::new());
    }
    // Of the spheres' rows and radii nothing that an importer sets decides anything.
    for unknown in &mut model.model_structure.initial_unknowns {
        let known = table.get(Version::Three, unknown.value_reference);
        if known.is_some_and(|entry| {
            Causality::from(entry.variable.causality) == Causality::CalculatedParameter
        }) {
            unknown.dependencies = Some(Vec::new());
        }
    }
    model
}

fn variable(entry: &Entry, spheres: usize) -> Variable {
    let own = entry.variable;
    let extents: Vec<u64> = own.dims.iter().map(|&n| n as u64).collect();
    let mut variable = Variable::new(
        own.scalar,
        &own.name,
        entry.reference,
        own.causality.into(),
        own.variability,
    )
    .with_dimensions(&extents);
    variable.description = Some(own.description.clone());
    variable.intermediate_update = own.is_intermediate();
    variable.unit = own.unit.map(str::to_owned);
    variable.declared_type = own.choices.map(|choices| choices.name.to_owned());
    variable.display_unit = own.unit.and_then(display_unit).map(str::to_owned);
    let bound = |value: Option<f64>| {
        value.map(|value| match own.scalar {
            ScalarType::Float64 => format!("{value:?}"),
            _ => format!("{value}"),
        })
    };
    (variable.min, variable.max) = (bound(own.min), bound(own.max));
    let texts = own.start.iter().map(Value::to_string);
    match own.scalar {
        ScalarType::String => {
            variable.starts = texts.map(|value| StartValue { value }).collect();
        }
        _ if !own.start.is_empty() => {
            variable.start = Some(texts.collect::<Vec<_>>().join(" "));
        }
        _ => {}
    }
    match own.binding {
        Binding::Document => {
            variable.mime_type = Some(document::MEDIA_TYPE.to_owned());
            variable.max_size = u32::try_from(document::size(spheres)).ok();
        }
        Binding::ContactsDocument => {
            variable.mime_type = Some(contacts::MEDIA_TYPE.to_owned());
        }
        _ => {}
    }
    variable
}
