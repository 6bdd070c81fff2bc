//! What an FMU of FMI 3.0 is, is able to do, and its variables.

use sphere_dda_model_description::fmi3::{CoSimulation, ModelDescription, Variable};

use super::{able, list, texts, times, uncapitalized, variables};

/// Header and variables.
pub(super) fn page(description: &ModelDescription) -> String {
    let mut lines = vec![
        ("model", description.model_name.clone()),
        ("standard", "FMI 3.0".to_owned()),
        ("token", description.instantiation_token.clone()),
    ];
    lines.extend(texts([
        &description.description,
        &description.version,
        &description.author,
        &description.license,
        &description.generation_tool,
    ]));
    lines.extend(description.default_experiment.map(times));
    if let Some(interface) = &description.co_simulation {
        lines.push(("library", interface.model_identifier.clone()));
        lines.push(("able to", abilities(interface)));
    }
    let rows = description.model_variables.iter().map(row).collect();
    list(&lines) + &variables(rows)
}

fn abilities(interface: &CoSimulation) -> String {
    let flags = [
        (
            interface.can_handle_variable_communication_step_size,
            "vary the step",
        ),
        (
            interface.can_get_and_set_fmu_state,
            "save and restore its state",
        ),
        (interface.can_serialize_fmu_state, "serialize its state"),
        (
            interface.provides_intermediate_update,
            "call the importer within a step",
        ),
        (
            interface.can_return_early_after_intermediate_update,
            "return early",
        ),
        (
            interface.max_output_derivative_order > 0,
            "give output derivatives",
        ),
        (
            interface.provides_directional_derivatives,
            "give directional derivatives",
        ),
        (interface.has_event_mode, "handle events"),
    ];
    able(&flags)
}

fn row(variable: &Variable) -> [String; 6] {
    let extents = variable.dimensions.iter();
    let extents = extents.map(|extent| match (extent.start, extent.value_reference) {
        (Some(start), _) => format!("[{start}]"),
        (None, reference) => format!("[of {}]", reference.unwrap_or_default()),
    });
    let texts = variable
        .starts
        .iter()
        .map(|start| format!("{:?}", start.value));
    let starts: Vec<String> = variable.start.iter().cloned().chain(texts).collect();
    [
        variable.name.clone(),
        uncapitalized(&format!("{:?}", variable.causality)),
        format!("{}{}", variable.scalar, extents.collect::<String>()),
        variable.unit.clone().unwrap_or_default(),
        starts.join(" "),
        variable.description.clone().unwrap_or_default(),
    ]
}
