//! `[[parameter]]`: its value is written where its paths lead, before anything of the scene is decoded. A scene with a value is
//! then the scene that has this value in its text, with every check.

mod path;

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use super::decode::Entry;
use super::document::{Document, LARGEST, Step, child, did_you_mean, join};
use super::edits::Edit;
use super::file;
use super::names::Names;
use super::values::OneOrMany;
use crate::scene::Parameter;
use path::{Target, number, resolve};

/// Whole numbers of parameters, as those of FMUs: 32 bits.
const LARGEST_WHOLE: f64 = i32::MAX as f64;

/// The parameters of the scene `root`, with `values` instead of their defaults, and what they write; what is wrong is added to the
/// problems.
pub(super) fn parameters(
    document: &mut Document<'_>,
    root: &Spanned<DeValue<'_>>,
    entries: &[Entry<file::Parameter>],
    values: &[(String, f64)],
) -> (Vec<Parameter>, Vec<Edit>) {
    Names::declare(document, "parameter", entries);
    refuse_unknown(document, entries, values);
    let mut taken: Vec<(Vec<Step>, &str)> = Vec::new();
    let (mut parameters, mut edits) = (Vec::new(), Vec::new());
    for entry in entries {
        let Some(typed) = &entry.value else { continue };
        let Some(targets) = targets(document, root, entry, typed) else {
            continue;
        };
        for target in &targets {
            let whole = |steps: &[Step]| join("", steps);
            if let Some((steps, other)) = taken.iter().find(|(steps, _)| *steps == target.steps) {
                let message = format!(
                    "`{}` is set by `{other}` and by `{}`",
                    whole(steps),
                    typed.name
                );
                document.error((&entry.path, "sets"), message, "remove one of them");
            }
            taken.push((target.steps.clone(), &typed.name));
        }
        let set = values.iter().rfind(|(name, _)| *name == typed.name);
        let set = set.map(|(_, value)| *value);
        if let Some(parameter) = parameter(document, &entry.path, typed, &targets, set) {
            for target in targets {
                if target.value != Some(parameter.value) {
                    document.mark(&target.steps, &parameter.name);
                    let literal = literal(&parameter);
                    let steps = target.steps;
                    edits.push(Edit { steps, literal });
                }
            }
            parameters.push(parameter);
        }
    }
    (parameters, edits)
}

/// Reports the values of parameters that the scene does not have.
fn refuse_unknown(
    document: &mut Document<'_>,
    entries: &[Entry<file::Parameter>],
    values: &[(String, f64)],
) {
    let known: Vec<&str> = entries.iter().filter_map(|e| e.name.as_deref()).collect();
    for (name, _) in values.iter().filter(|(name, _)| !known.contains(&&**name)) {
        let help = match known.is_empty() {
            true => "the scene has none: name one with `[[parameter]]`".to_owned(),
            false => {
                let near = did_you_mean(name, known.iter().copied());
                format!("{near}known: {}", known.join(", "))
            }
        };
        document.error("parameter", format!("unknown parameter `{name}`"), help);
    }
}

/// Where a parameter's paths lead; `None` if one of them leads nowhere.
fn targets(
    document: &mut Document<'_>,
    root: &Spanned<DeValue<'_>>,
    entry: &Entry<file::Parameter>,
    typed: &file::Parameter,
) -> Option<Vec<Target>> {
    let paths: Vec<(String, &String)> = match &typed.sets {
        OneOrMany::One(path) => vec![(format!("{}.sets", entry.path), path)],
        OneOrMany::Many(paths) => (paths.iter().enumerate())
            .map(|(k, path)| (format!("{}.sets[{k}]", entry.path), path))
            .collect(),
    };
    if paths.is_empty() {
        return document.refuse((&entry.path, "sets"), "an empty list", "one path or more");
    }
    let mut targets = Vec::new();
    for (place, path) in &paths {
        match resolve(root, path) {
            Ok(target) => targets.push(target),
            Err((message, help)) => document.error(place, message, help),
        }
    }
    (targets.len() == paths.len()).then_some(targets)
}

/// A parameter, checked.
fn parameter(
    document: &mut Document<'_>,
    path: &str,
    typed: &file::Parameter,
    targets: &[Target],
    set: Option<f64>,
) -> Option<Parameter> {
    let unit = &targets.first()?.unit;
    if let Some(other) = targets.iter().find(|target| target.unit != *unit) {
        let message = format!(
            "found keys in {unit} and in {}, expected one unit",
            other.unit
        );
        return document.reject((path, "sets"), message, "make two parameters of them");
    }
    if let Some(given) = typed.unit.as_ref().filter(|given| *given != unit) {
        let message = format!("found `{given}`, expected `{unit}`, the unit of what it sets");
        document.error((path, "unit"), message, "");
    }
    let is_integer = targets.iter().any(|target| target.is_integer);
    let default = default(document, path, typed, targets)?;
    let size = if is_integer { LARGEST_WHOLE } else { LARGEST };
    let (low, high) = (typed.min.unwrap_or(-size), typed.max.unwrap_or(size));
    let expected = match (typed.min, typed.max) {
        (Some(_), None) => format!("a number >= {low}"),
        (None, Some(_)) => format!("a number <= {high}"),
        _ => format!("a number from {low} to {high}"),
    };
    for (key, bound) in [("min", typed.min), ("max", typed.max)] {
        let whole = |bound: f64| !is_integer || bound.fract() == 0.0;
        let good = bound.is_none_or(|bound| bound.abs() <= size && whole(bound));
        let kind = if is_integer {
            "a whole number"
        } else {
            "a number"
        };
        let found = bound.unwrap_or_default();
        document.demand(
            good,
            (path, key),
            found,
            &format!("{kind} of size {size:e} at most"),
        );
    }
    if !document.demand(
        low <= high,
        (path, "max"),
        high,
        &format!("min = {low} or more"),
    ) {
        return None;
    }
    let mut check = |value: f64, key: &str, found: String| {
        let good = (low..=high).contains(&value);
        let good = document.demand(good, (path, key), &found, &expected);
        let whole = !is_integer || value.fract() == 0.0;
        good & document.demand(whole, (path, key), &found, "a whole number")
    };
    let mut good = check(default, "default", default.to_string());
    if let Some(set) = set {
        good &= check(set, "name", format!("`{}` = {set}", typed.name));
    }
    good.then(|| Parameter {
        name: typed.name.clone(),
        description: typed.description.clone().unwrap_or_else(|| {
            let paths = match &typed.sets {
                OneOrMany::One(path) => path.clone(),
                OneOrMany::Many(paths) => paths.join(", "),
            };
            format!("Sets {paths}")
        }),
        unit: unit.clone(),
        min: typed.min,
        max: typed.max,
        value: set.unwrap_or(default),
        is_integer,
        is_tunable: targets.iter().all(|target| target.is_tunable),
    })
}

/// The value of a parameter that is not set.
fn default(
    document: &mut Document<'_>,
    path: &str,
    typed: &file::Parameter,
    targets: &[Target],
) -> Option<f64> {
    if typed.default.is_some() {
        return typed.default;
    }
    let found: Option<Vec<f64>> = targets.iter().map(|target| target.value).collect();
    match found.as_deref() {
        Some([first, others @ ..]) if others.iter().all(|other| other == first) => Some(*first),
        Some(_) => {
            let message = "missing key `default`: what it sets has different values";
            document.reject(path, message, "add `default = ...`")
        }
        None => {
            let absent = targets.iter().find(|target| target.value.is_none());
            let absent = absent.map_or(String::new(), |target| join("", &target.steps));
            let message = format!("missing key `default`: `{absent}` has no number");
            document.reject(path, message, "add `default = ...`")
        }
    }
}

/// A value as a key takes it.
fn literal(parameter: &Parameter) -> String {
    let value = parameter.value;
    match parameter.is_integer {
        true => format!("{value:.0}"),
        // The shortest text that reads back to the same bits.
        false => format!("{value:?}"),
    }
}

/// The text with the values that are set as the defaults of their parameters; `None`: as it is.
pub(super) fn with_defaults(
    text: &str,
    document: &Document<'_>,
    entries: &[Entry<file::Parameter>],
    parameters: &[Parameter],
    values: &[(String, f64)],
) -> Option<String> {
    let set = |name: &str| values.iter().any(|(set, _)| set == name);
    let list = child(document.root(), &Step::Key("parameter".into()))?;
    let mut edits: Vec<(Range<usize>, String)> = Vec::new();
    for (k, entry) in entries.iter().enumerate() {
        let own = |parameter: &&Parameter| Some(&parameter.name) == entry.name.as_ref();
        let Some(parameter) = parameters.iter().find(own).filter(|own| set(&own.name)) else {
            continue;
        };
        let place = child(list, &Step::Index(k))?;
        match child(place, &Step::Key("default".into())) {
            Some(typed) if number(typed.get_ref()) == Some(parameter.value) => {}
            Some(typed) => edits.push((typed.span(), literal(parameter))),
            None => {
                let end = child(place, &Step::Key("name".into()))?.span().end;
                let before = match text[place.span()].starts_with('{') {
                    true => ", ",
                    false => "\n",
                };
                edits.push((
                    end..end,
                    format!("{before}default = {}", literal(parameter)),
                ));
            }
        }
    }
    let mut edited = text.to_owned();
    // From the end, so that the places before stay.
    edits.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    for (range, with) in &edits {
        edited.replace_range(range.clone(), with);
    }
    (!edits.is_empty()).then_some(edited)
}
