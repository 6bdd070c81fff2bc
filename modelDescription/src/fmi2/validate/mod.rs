//! The rules of FMI 2.0: header, units and types here, then the variables and
//! the model structure.

mod context;
mod structure;
mod variables;

use std::collections::BTreeSet;

use context::Context;

use super::{DefaultExperiment, EnumerationType, FMI_VERSION, ModelDescription, TypeDefinition};
use crate::finding::{Finding, Report, Rule};
use crate::names;
use crate::units::{self};

/// All broken rules, in the order of the document.
fn validate(model: &ModelDescription) -> Vec<Finding> {
    let mut report = Report::default();
    let context = Context::new(model);
    header(model, &mut report);
    units::check(&model.unit_definitions, &mut report);
    types(&context, &mut report);
    log_categories(model, &mut report);
    if let Some(experiment) = &model.default_experiment {
        default_experiment(experiment, &mut report);
    }
    variables::check(&context, &mut report);
    structure::check(model, &mut report);
    report.findings
}

fn header(model: &ModelDescription, report: &mut Report) {
    const ROOT: &str = crate::fmi2::description::ROOT;
    if model.fmi_version != FMI_VERSION {
        report.error(
            Rule::FmiVersion,
            format!("{ROOT}/@fmiVersion"),
            format!("`{}`", model.fmi_version),
            format!("`{FMI_VERSION}`"),
        );
    }
    required(&model.model_name, format!("{ROOT}/@modelName"), report);
    required(&model.guid, format!("{ROOT}/@guid"), report);
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

    if model.model_exchange.is_none() && model.co_simulation.is_none() {
        report.error(
            Rule::Interface,
            ROOT,
            "no interface",
            "CoSimulation, ModelExchange or both",
        );
    }
    let own = model.co_simulation.as_ref();
    let exchange = model.model_exchange.as_ref();
    let interfaces = [
        exchange.map(|interface| ("ModelExchange", &interface.model_identifier)),
        own.map(|interface| ("CoSimulation", &interface.model_identifier)),
    ];
    for (element, identifier) in interfaces.into_iter().flatten() {
        if !names::is_c_identifier(identifier) {
            report.error(
                Rule::ModelIdentifier,
                format!("{element}/@modelIdentifier"),
                format!("`{identifier}`"),
                "a C identifier",
            );
        }
    }
    if own.is_some_and(|own| own.can_serialize_fmu_state && !own.can_get_and_set_fmu_state) {
        report.error(
            Rule::StateFlags,
            "CoSimulation/@canSerializeFMUstate",
            "`true` without canGetAndSetFMUstate",
            "canGetAndSetFMUstate also `true`",
        );
    }
}

pub(crate) fn required(text: &str, place: String, report: &mut Report) {
    if text.is_empty() {
        report.error(Rule::RequiredAttribute, place, "an empty text", "a text");
    }
}

fn types(context: &Context<'_>, report: &mut Report) {
    let variables = &context.model.model_variables;
    let variable_names: BTreeSet<&str> = variables.iter().map(|v| v.name.as_str()).collect();
    let mut names = BTreeSet::new();
    for simple in &context.model.type_definitions {
        let place = format!("TypeDefinitions/SimpleType `{}`", simple.name);
        context.name(&simple.name, &place, report);
        if !names.insert(simple.name.as_str()) {
            report.error(
                Rule::TypeNameUnique,
                &place,
                "a second type of this name",
                "one",
            );
        }
        if variable_names.contains(simple.name.as_str()) {
            report.error(
                Rule::TypeNameUnique,
                &place,
                "a variable of this name",
                "a name that no variable has",
            );
        }
        match &simple.definition {
            TypeDefinition::Real(real) => {
                let place = format!("{place}/Real");
                context.unit(
                    real.unit.as_deref(),
                    real.display_unit.as_deref(),
                    &place,
                    report,
                );
                variables::range(real.min, real.max, None, &place, report);
                variables::nominal(real.nominal, &place, report);
            }
            TypeDefinition::Integer(integer) => {
                let place = format!("{place}/Integer");
                variables::range(integer.min, integer.max, None, &place, report);
            }
            TypeDefinition::Enumeration(enumeration) => {
                items(enumeration, &format!("{place}/Enumeration"), report);
            }
            TypeDefinition::Boolean | TypeDefinition::String => {}
        }
    }
}

fn items(enumeration: &EnumerationType, place: &str, report: &mut Report) {
    if enumeration.items.is_empty() {
        report.error(Rule::EnumerationItems, place, "no item", "at least one");
    }
    let mut names = BTreeSet::new();
    let mut values = BTreeSet::new();
    for item in &enumeration.items {
        let place = format!("{place}/Item `{}`", item.name);
        required(&item.name, format!("{place}/@name"), report);
        if !names.insert(item.name.as_str()) {
            report.error(
                Rule::EnumerationUnique,
                &place,
                "a second item of this name",
                "one",
            );
        }
        if !values.insert(item.value) {
            report.error(
                Rule::EnumerationUnique,
                format!("{place}/@value"),
                format!("{} a second time", item.value),
                "a value that no other item has",
            );
        }
    }
}

fn log_categories(model: &ModelDescription, report: &mut Report) {
    let mut names = BTreeSet::new();
    for category in &model.log_categories {
        let place = format!("LogCategories/Category `{}`", category.name);
        required(&category.name, format!("{place}/@name"), report);
        if !names.insert(category.name.as_str()) {
            report.error(
                Rule::LogCategoryUnique,
                place,
                "a second category of this name",
                "one",
            );
        }
    }
}

pub(crate) fn default_experiment(experiment: &DefaultExperiment, report: &mut Report) {
    let mut finite = true;
    for (attribute, time) in [
        ("startTime", experiment.start_time),
        ("stopTime", experiment.stop_time),
    ] {
        if let Some(time) = time
            && !time.is_finite()
        {
            finite = false;
            report.error(
                Rule::DefaultExperiment,
                format!("DefaultExperiment/@{attribute}"),
                format!("{time:?}"),
                "a finite time",
            );
        }
    }
    let start = experiment.start_time.unwrap_or(0.0);
    if let Some(stop) = experiment.stop_time
        && finite
        && stop <= start
    {
        report.error(
            Rule::DefaultExperiment,
            "DefaultExperiment/@stopTime",
            format!("{stop:?}"),
            format!("a time after the start at {start:?}"),
        );
    }
    for (attribute, value) in [
        ("tolerance", experiment.tolerance),
        ("stepSize", experiment.step_size),
    ] {
        if let Some(value) = value
            && !(value.is_finite() && value > 0.0)
        {
            report.error(
                Rule::DefaultExperiment,
                format!("DefaultExperiment/@{attribute}"),
                format!("{value:?}"),
                "a finite number greater than 0",
            );
        }
    }
}

/// Whether `text` is a date and time of XML Schema:
/// `YYYY-MM-DDThh:mm:ss[.f][Z|±hh:mm]`.
pub(crate) fn is_date_and_time(text: &str) -> bool {
    fn number(text: &str, low: u32, high: u32) -> bool {
        text.len() == 2
            && text.bytes().all(|byte| byte.is_ascii_digit())
            && text.parse().is_ok_and(|n: u32| (low..=high).contains(&n))
    }
    fn date(text: &str) -> bool {
        let mut parts = text.strip_prefix('-').unwrap_or(text).split('-');
        let year = parts.next().unwrap_or_default();
        year.len() >= 4
            && year.bytes().all(|byte| byte.is_ascii_digit())
            && parts.next().is_some_and(|month| number(month, 1, 12))
            && parts.next().is_some_and(|day| number(day, 1, 31))
            && parts.next().is_none()
    }
    fn clock(text: &str) -> bool {
        let (whole, fraction) = text.split_once('.').unwrap_or((text, "0"));
        let mut parts = whole.split(':');
        !fraction.is_empty()
            && fraction.bytes().all(|byte| byte.is_ascii_digit())
            && parts.next().is_some_and(|hour| number(hour, 0, 23))
            && parts.next().is_some_and(|minute| number(minute, 0, 59))
            && parts.next().is_some_and(|second| number(second, 0, 59))
            && parts.next().is_none()
    }
    fn zone(text: &str) -> bool {
        text.split_once(':')
            .is_some_and(|(hour, minute)| number(hour, 0, 14) && number(minute, 0, 59))
    }
    let Some((day, time)) = text.split_once('T') else {
        return false;
    };
    let time_is_good = match (time.strip_suffix('Z'), time.find(['+', '-'])) {
        (Some(time), _) => clock(time),
        (None, Some(at)) => clock(&time[..at]) && zone(&time[at + 1..]),
        (None, None) => clock(time),
    };
    date(day) && time_is_good
}

impl ModelDescription {
    /// All broken rules at once, in the order of the document; empty if the
    /// description is valid.
    pub fn validate(&self) -> Vec<Finding> {
        validate(self)
    }
}

#[cfg(test)]
mod tests {
    use super::is_date_and_time;

    #[test]
    fn dates_and_times() {
        for text in [
            "2009-12-08T14:33:22Z",
            "2009-12-08T14:33:22",
            "2021-01-31T00:00:00.123+01:00",
            "12021-01-31T00:00:00-11:30",
        ] {
            assert!(is_date_and_time(text), "{text}");
        }
        for text in [
            "",
            "2009-12-08",
            "2009-12-08 14:33:22Z",
            "2009-13-08T14:33:22Z",
            "2009-12-08T24:33:22Z",
            "2009-12-08T14:33Z",
            "2009-12-08T14:33:22.Z",
            "09-12-08T14:33:22Z",
            "2009-12-08T14:33:22+1:00",
            "2009-12-08T14:33:22é",
        ] {
            assert!(!is_date_and_time(text), "{text}");
        }
    }
}
