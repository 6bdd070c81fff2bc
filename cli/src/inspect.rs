//! `sphere-dda inspect X.fmu`.

mod version3;

use std::path::PathBuf;

use clap::Args;
use miette::miette;
use sphere_dda_master::{Description, Fmu};
use sphere_dda_model_description::Severity;
use sphere_dda_model_description::fmi2::{
    CoSimulation, DefaultExperiment, ModelDescription, ScalarVariable, TypeDefinition, VariableType,
};

use crate::failure::Failure;
use crate::progress::print;

/// Arguments of `inspect`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda inspect funnel.fmu
  sphere-dda inspect --validate funnel.fmu")]
pub(crate) struct Inspect {
    /// The FMU, of FMI 2.0 or 3.0, for co-simulation.
    fmu: PathBuf,
    /// Show also errors and warnings about its model description; exit code 2 if there is an error.
    #[arg(long)]
    validate: bool,
}

/// Prints what an FMU is, what it is able to do, and its variables.
///
/// # Errors
/// What the importer says; findings of the validation if it was asked for.
pub(crate) fn run(arguments: &Inspect) -> Result<(), Failure> {
    let fmu = Fmu::open(&arguments.fmu)?;
    let (text, findings) = match fmu.description() {
        Description::Three(description) => (version3::page(description), description.validate()),
        Description::Two(description) => {
            let rows = description.model_variables.iter();
            let rows = rows.map(|variable| row(description, variable)).collect();
            (
                header(description) + &variables(rows),
                description.validate(),
            )
        }
    };
    let findings = if arguments.validate {
        findings
    } else {
        Vec::new()
    };
    print(|out| {
        write!(out, "{text}")?;
        findings
            .iter()
            .try_for_each(|finding| writeln!(out, "{finding}"))
    })?;
    let errors = findings.iter().filter(|f| f.severity == Severity::Error);
    match errors.count() {
        0 => Ok(()),
        errors => Err(Failure::Input(miette!(
            "{}: found {errors} errors in modelDescription.xml, expected none",
            arguments.fmu.display(),
        ))),
    }
}

fn header(description: &ModelDescription) -> String {
    let mut lines = vec![
        ("model", description.model_name.clone()),
        ("guid", description.guid.clone()),
    ];
    lines.extend(texts([
        &description.description,
        &description.version,
        &description.author,
        &description.license,
        &description.generation_tool,
    ]));
    lines.extend(description.default_experiment.map(times));
    if let Some(co_simulation) = &description.co_simulation {
        lines.insert(1, ("library", co_simulation.model_identifier.clone()));
        lines.push(("able to", abilities(co_simulation)));
    }
    list(&lines)
}

/// What people wrote about the model, as far as they did.
fn texts(texts: [&Option<String>; 5]) -> impl Iterator<Item = (&'static str, String)> {
    let names = ["description", "version", "author", "license", "tool"];
    let named = names.into_iter().zip(texts);
    named.filter_map(|(name, text)| Some((name, text.clone()?)))
}

/// The suggested experiment as a line.
fn times(experiment: DefaultExperiment) -> (&'static str, String) {
    let times = [
        ("start", experiment.start_time),
        ("stop", experiment.stop_time),
        ("step", experiment.step_size),
    ];
    let times: Vec<String> = times
        .iter()
        .filter_map(|(name, time)| Some(format!("{name} {} s", (*time)?)))
        .collect();
    ("experiment", times.join(", "))
}

fn list(lines: &[(&str, String)]) -> String {
    lines
        .iter()
        .map(|(name, text)| format!("{name:<12}{text}\n"))
        .collect()
}

fn abilities(co_simulation: &CoSimulation) -> String {
    let flags = [
        (
            co_simulation.can_handle_variable_communication_step_size,
            "vary the step",
        ),
        (
            co_simulation.can_get_and_set_fmu_state,
            "save and restore its state",
        ),
        (co_simulation.can_serialize_fmu_state, "serialize its state"),
        (co_simulation.can_interpolate_inputs, "interpolate inputs"),
        (
            co_simulation.max_output_derivative_order > 0,
            "give output derivatives",
        ),
        (
            co_simulation.provides_directional_derivative,
            "give directional derivatives",
        ),
    ];
    able(&flags)
}

/// The abilities that are there, in a sentence.
fn able(flags: &[(bool, &str)]) -> String {
    let able = flags.iter().filter(|(flag, _)| *flag);
    let able: Vec<&str> = able.map(|(_, text)| *text).collect();
    if able.is_empty() {
        return "take steps of one length only".to_owned();
    }
    able.join(", ")
}

/// One line for each variable, the columns as wide as they must be.
fn variables(variables: Vec<[String; 6]>) -> String {
    let count = variables.len();
    let title = ["name", "causality", "type", "unit", "start", "description"];
    let mut rows = vec![title.map(str::to_owned)];
    rows.extend(variables);
    let mut widths = [0; 6];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = cell.chars().count().max(*width);
        }
    }
    let line = |row: &[String; 6]| {
        let cells = row.iter().zip(widths);
        let cells: Vec<String> = cells
            .map(|(cell, width)| {
                // The width of a format is bounded, a name is not.
                format!("{cell}{}", " ".repeat(width - cell.chars().count()))
            })
            .collect();
        format!("{}\n", cells.join("  ").trim_end())
    };
    let lines: String = rows.iter().map(line).collect();
    format!("\n{count} variables\n{lines}")
}

fn row(description: &ModelDescription, variable: &ScalarVariable) -> [String; 6] {
    fn text<T: ToString>(start: Option<T>) -> Option<String> {
        start.map(|start| start.to_string())
    }
    let (kind, unit, start) = match &variable.variable_type {
        VariableType::Real(real) => {
            let declared = || declared_unit(description, real.declared_type.as_deref()?);
            (
                "Real",
                real.unit.clone().or_else(declared),
                text(real.start),
            )
        }
        VariableType::Integer(integer) => ("Integer", None, text(integer.start)),
        VariableType::Boolean(boolean) => ("Boolean", None, text(boolean.start)),
        VariableType::String(string) => {
            let quoted = string.start.as_ref().map(|start| format!("{start:?}"));
            ("String", None, quoted)
        }
        VariableType::Enumeration(own) => (&*own.declared_type, None, text(own.start)),
    };
    [
        variable.name.clone(),
        // The standard's names are the variants' with a small first letter.
        uncapitalized(&format!("{:?}", variable.causality)),
        kind.to_owned(),
        unit.unwrap_or_default(),
        start.unwrap_or_default(),
        variable.description.clone().unwrap_or_default(),
    ]
}

fn declared_unit(description: &ModelDescription, name: &str) -> Option<String> {
    let mut types = description.type_definitions.iter();
    match &types.find(|definition| definition.name == name)?.definition {
        TypeDefinition::Real(real) => real.unit.clone(),
        _ => None,
    }
}

fn uncapitalized(text: &str) -> String {
    let mut characters = text.chars();
    let first = characters.next().map(|first| first.to_ascii_lowercase());
    first.into_iter().chain(characters).collect()
}
