//! The rules of FMI 3.0 that matter to a co-simulation importer.

mod values;

use crate::xml::is_release_of;
use std::collections::{BTreeMap, BTreeSet};

use super::description::ROOT;
use super::structure::is_initial_unknown;
use super::{
    Causality, CoSimulation, FMI_VERSION, ModelDescription, NamingConvention, Unknown, Variable,
    types,
};
use crate::finding::{Finding, Report, Rule};
use crate::fmi2::DependencyKind;
use crate::fmi2::validate::{default_experiment, is_date_and_time, required};
use crate::names;
use crate::units::{self, Unit};
use crate::value::ScalarType;

/// All broken rules, in the order of the document.
fn validate(model: &ModelDescription) -> Vec<Finding> {
    let mut report = Report::default();
    header(model, &mut report);
    interfaces(model, &mut report);
    units::check(&model.unit_definitions, &mut report);
    types::check(&model.type_definitions, &mut report);
    let mut categories = BTreeSet::new();
    for category in &model.log_categories {
        let place = format!("LogCategories/Category `{}`", category.name);
        required(&category.name, format!("{place}/@name"), &mut report);
        if !categories.insert(&category.name) {
            let found = "a second category of this name";
            report.error(Rule::LogCategoryUnique, place, found, "one");
        }
    }
    if let Some(experiment) = &model.default_experiment {
        default_experiment(experiment, &mut report);
    }
    variables(model, &mut report);
    structure(model, &mut report);
    report.findings
}

fn header(model: &ModelDescription, report: &mut Report) {
    if !is_release_of(&model.fmi_version, FMI_VERSION) {
        report.error(
            Rule::FmiVersion,
            format!("{ROOT}/@fmiVersion"),
            format!("`{}`", model.fmi_version),
            format!("`{FMI_VERSION}`"),
        );
    }
    required(&model.model_name, format!("{ROOT}/@modelName"), report);
    let place = format!("{ROOT}/@instantiationToken");
    required(&model.instantiation_token, place, report);
    if let Some(text) = &model.generation_date_and_time
        && !is_date_and_time(text)
    {
        report.error(
            Rule::GenerationDateAndTime,
            format!("{ROOT}/@generationDateAndTime"),
            format!("`{text}`"),
            "a date and time such as `2009-12-08T14:33:22Z`",
        );
    }
}

fn interfaces(model: &ModelDescription, report: &mut Report) {
    let own = model
        .co_simulation
        .as_ref()
        .map(|i| ("CoSimulation", &i.model_identifier));
    let exchange = model.model_exchange.as_ref();
    let scheduled = model.scheduled_execution.as_ref();
    let others = [
        exchange.map(|i| ("ModelExchange", &i.model_identifier)),
        scheduled.map(|i| ("ScheduledExecution", &i.model_identifier)),
    ];
    let offered: Vec<_> = others.into_iter().chain([own]).flatten().collect();
    if offered.is_empty() {
        let expected = "CoSimulation, ModelExchange or ScheduledExecution";
        report.error(Rule::Interface, ROOT, "no interface", expected);
    }
    for (element, identifier) in offered {
        if !names::is_c_identifier(identifier) {
            report.error(
                Rule::ModelIdentifier,
                format!("{element}/@modelIdentifier"),
                format!("`{identifier}`"),
                "a C identifier",
            );
        }
    }
    if let Some(own) = &model.co_simulation {
        capabilities(own, report);
    }
}

/// Capabilities that need others.
fn capabilities(own: &CoSimulation, report: &mut Report) {
    let needs = [
        (
            Rule::StateFlags,
            "canSerializeFMUState",
            own.can_serialize_fmu_state,
            "canGetAndSetFMUState",
            own.can_get_and_set_fmu_state,
        ),
        (
            Rule::StepFlags,
            "canReturnEarlyAfterIntermediateUpdate",
            own.can_return_early_after_intermediate_update,
            "providesIntermediateUpdate",
            own.provides_intermediate_update,
        ),
    ];
    for (rule, flag, set, needed, given) in needs {
        if set && !given {
            report.error(
                rule,
                format!("CoSimulation/@{flag}"),
                format!("`true` without {needed}"),
                format!("{needed} also `true`"),
            );
        }
    }
    if own
        .fixed_internal_step_size
        .is_some_and(|step| !(step.is_finite() && step > 0.0))
    {
        report.error(
            Rule::StepFlags,
            "CoSimulation/@fixedInternalStepSize",
            format!("{:?}", own.fixed_internal_step_size),
            "a finite length greater than 0",
        );
    }
}

fn variables(model: &ModelDescription, report: &mut Report) {
    if model.model_variables.is_empty() {
        report.error(
            Rule::VariablesMissing,
            "ModelVariables",
            "no variable",
            "one",
        );
    }
    let units = model.unit_definitions.iter();
    let units: BTreeMap<&str, &Unit> = units.map(|unit| (unit.name.as_str(), unit)).collect();
    let by_reference: BTreeMap<u32, &Variable> = by_reference(model);
    let mut names = BTreeSet::new();
    let mut references = BTreeSet::new();
    let mut independents = 0;
    for variable in &model.model_variables {
        let place = format!("ModelVariables/{} `{}`", variable.scalar, variable.name);
        let aliases = variable.aliases.iter().map(|alias| alias.name.as_str());
        for name in std::iter::once(variable.name.as_str()).chain(aliases) {
            form(model.variable_naming_convention, name, &place, report);
            if !names.insert(name) {
                let found = format!("the name `{name}` a second time");
                report.error(Rule::NameUnique, &place, found, "one variable or alias");
            }
        }
        if !references.insert(variable.value_reference) {
            report.error(
                Rule::ReferenceUnique,
                format!("{place}/@valueReference"),
                format!("{} a second time", variable.value_reference),
                "a reference that no other variable has; aliases are children in FMI 3.0",
            );
        }
        if variable.causality == Causality::Independent {
            independents += 1;
            if independents > 1 || !variable.scalar.is_float() || !variable.dimensions.is_empty() {
                report.error(
                    Rule::Independent,
                    &place,
                    "an independent variable that is a second one, an array or no real number",
                    "one real scalar at most",
                );
            }
        }
        dimensions(variable, &by_reference, &place, report);
        clocks(variable, &by_reference, &place, report);
        unit(variable, &units, &place, report);
        values::check(variable, &place, report);
        types::declared(variable, &model.type_definitions, &place, report);
    }
}

fn by_reference(model: &ModelDescription) -> BTreeMap<u32, &Variable> {
    let variables = model.model_variables.iter();
    variables.map(|v| (v.value_reference, v)).collect()
}

fn form(convention: NamingConvention, name: &str, place: &str, report: &mut Report) {
    required(name, format!("{place}/@name"), report);
    if convention == NamingConvention::Structured
        && !name.is_empty()
        && let Err(error) = names::check_structured(name)
    {
        report.error(
            Rule::Name,
            place,
            format!("{} at byte {} of `{name}`", error.found, error.offset),
            format!("{} in a structured name", error.expected),
        );
    }
}

/// A dimension is a positive number or an unsigned variable that does not change during the run.
fn dimensions(
    variable: &Variable,
    by_reference: &BTreeMap<u32, &Variable>,
    place: &str,
    report: &mut Report,
) {
    for dimension in &variable.dimensions {
        let good = match (dimension.start, dimension.value_reference) {
            (Some(extent), None) => extent > 0,
            (None, Some(reference)) => by_reference.get(&reference).is_some_and(|size| {
                size.scalar == ScalarType::UInt64
                    && (size.causality == Causality::StructuralParameter
                        || size.effective_variability() == super::Variability::Constant)
            }),
            _ => false,
        };
        if !good {
            report.error(
                Rule::Dimension,
                format!("{place}/Dimension"),
                format!("{dimension:?}"),
                "`start` greater than 0, or `valueReference` of a structural parameter or constant of type UInt64",
            );
        }
    }
}

fn clocks(
    variable: &Variable,
    by_reference: &BTreeMap<u32, &Variable>,
    place: &str,
    report: &mut Report,
) {
    for reference in variable.clocks.iter().flatten() {
        let clock = by_reference.get(reference);
        if clock.is_none_or(|clock| clock.scalar != ScalarType::Clock) {
            report.error(
                Rule::Clocks,
                format!("{place}/@clocks"),
                format!("{reference}, which is no clock"),
                "value references of clocks",
            );
        }
    }
}

fn unit(variable: &Variable, units: &BTreeMap<&str, &Unit>, place: &str, report: &mut Report) {
    let unit = variable.unit.as_deref();
    let defined = unit.and_then(|name| units.get(name));
    if let (Some(name), None) = (unit, defined) {
        report.error(
            Rule::UnitDefined,
            format!("{place}/@unit"),
            format!("`{name}`"),
            "the name of a unit in UnitDefinitions",
        );
    }
    if unit.is_some() && !variable.scalar.is_float() {
        let expected = "none: only real numbers have units";
        report.error(Rule::UnitDefined, place, "a unit", expected);
    }
    let aliases = variable.aliases.iter();
    let shown = aliases.map(|alias| alias.display_unit.as_deref());
    for name in shown.chain([variable.display_unit.as_deref()]).flatten() {
        // A unit that is not defined has been reported.
        let known = defined.is_some_and(|unit| unit.display_units.iter().any(|d| d.name == name));
        if !known && (unit.is_none() || defined.is_some()) {
            report.error(
                Rule::DisplayUnitDefined,
                format!("{place}/@displayUnit"),
                format!("`{name}`"),
                "a display unit of the variable's unit",
            );
        }
    }
}

fn structure(model: &ModelDescription, report: &mut Report) {
    let by_reference = by_reference(model);
    let lists = [
        (
            "Output",
            Rule::Outputs,
            &model.model_structure.outputs,
            (|v: &Variable| v.causality == Causality::Output) as fn(&Variable) -> bool,
        ),
        (
            "InitialUnknown",
            Rule::InitialUnknowns,
            &model.model_structure.initial_unknowns,
            is_initial_unknown,
        ),
    ];
    for (element, rule, list, wanted) in lists {
        let mut seen = BTreeSet::new();
        for unknown in list {
            let reference = unknown.value_reference;
            let place = format!("ModelStructure/{element} {reference}");
            match by_reference.get(&reference) {
                None => report.error(
                    Rule::StructureIndex,
                    &place,
                    "no variable of this value reference",
                    "one",
                ),
                // Local variables that are states may be initial unknowns too.
                Some(v) if !wanted(v) && v.causality != Causality::Local => {
                    let found = format!("`{}`, which is none", v.name);
                    report.error(rule, &place, found, format!("a variable that is {element}"));
                }
                Some(_) => {}
            }
            if !seen.insert(reference) {
                report.error(rule, &place, "a second entry of this variable", "one");
            }
            dependencies(unknown, &by_reference, &place, report);
        }
        for variable in &model.model_variables {
            if wanted(variable) && !seen.contains(&variable.value_reference) {
                report.error(
                    rule,
                    format!("ModelStructure/{element}"),
                    format!("no entry of `{}`", variable.name),
                    "one for each such variable",
                );
            }
        }
    }
}

fn dependencies(
    unknown: &Unknown,
    by_reference: &BTreeMap<u32, &Variable>,
    place: &str,
    report: &mut Report,
) {
    let listed = unknown.dependencies.as_deref().unwrap_or_default();
    let mut seen = BTreeSet::new();
    for reference in listed {
        if !by_reference.contains_key(reference) || !seen.insert(reference) {
            report.error(
                Rule::Dependencies,
                format!("{place}/@dependencies"),
                format!("{reference}, which is no variable or stands there twice"),
                "value references of variables, each once",
            );
        }
    }
    let Some(kinds) = &unknown.dependencies_kind else {
        return;
    };
    let known = |name: &str| DependencyKind::ALL.iter().any(|kind| kind.name() == name);
    let names: Vec<&str> = kinds.split_ascii_whitespace().collect();
    if unknown.dependencies.is_none()
        || names.len() != listed.len()
        || !names.iter().all(|name| known(name))
    {
        report.error(
            Rule::DependenciesKind,
            format!("{place}/@dependenciesKind"),
            format!("`{kinds}` for {} dependencies", listed.len()),
            "dependent, constant, fixed, tunable or discrete for each dependency",
        );
    }
}

impl ModelDescription {
    /// All broken rules at once, in the order of the document; empty if the description is valid.
    pub fn validate(&self) -> Vec<Finding> {
        validate(self)
    }
}
