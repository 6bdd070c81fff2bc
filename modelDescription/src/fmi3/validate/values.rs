//! Combination of attributes, and the values of one variable: type, number, bounds.

use crate::finding::{Report, Rule};
use crate::fmi2::{Initial, Variability};
use crate::fmi3::{Causality, Variable};
use crate::lexical::Lexical;
use crate::value::ScalarType;

pub(super) fn check(variable: &Variable, place: &str, report: &mut Report) {
    combination(variable, place, report);
    if variable.intermediate_update
        && !matches!(
            variable.causality,
            Causality::Input | Causality::Output | Causality::Local
        )
    {
        report.error(
            Rule::IntermediateUpdate,
            format!("{place}/@intermediateUpdate"),
            "`true`",
            "`false` but for inputs, outputs and local variables",
        );
    }
    bounds(variable, place, report);
    starts(variable, place, report);
}

fn combination(variable: &Variable, place: &str, report: &mut Report) {
    let variability = variable.effective_variability();
    let causality = variable.causality;
    // A clock has no variability of its own: it ticks.
    if variable.scalar == ScalarType::Clock {
        return;
    }
    if variability == Variability::Continuous && !variable.scalar.is_float() {
        report.error(
            Rule::Variability,
            format!("{place}/@variability"),
            "`continuous`",
            "another: only real numbers are continuous",
        );
    }
    match causality.legal_initial(variability) {
        None => report.error(
            Rule::Combination,
            place,
            format!("{causality:?} with {variability:?}"),
            "causality and variability that may go together",
        ),
        Some(legal) => {
            if let Some(initial) = variable.initial
                && !legal.contains(&initial)
            {
                report.error(
                    Rule::Initial,
                    format!("{place}/@initial"),
                    format!("{initial:?}"),
                    format!("one of {legal:?} for {causality:?}, {variability:?}"),
                );
            }
        }
    }
}

/// A number as far as bounds need it.
fn number(scalar: ScalarType, text: &str) -> Option<f64> {
    match scalar {
        ScalarType::Float64 | ScalarType::Float32 => f64::parse(text),
        ScalarType::Boolean => bool::parse(text).map(f64::from),
        ScalarType::String | ScalarType::Binary | ScalarType::Clock => None,
        integer => {
            let value: i128 = text.parse().ok()?;
            integer.range().contains(&value).then_some(value as f64)
        }
    }
}

fn bounds(variable: &Variable, place: &str, report: &mut Report) {
    let mut read = |attribute: &str, text: &Option<String>| {
        let text = text.as_ref()?;
        let value = number(variable.scalar, text.trim_ascii()).filter(|value| !value.is_nan());
        if value.is_none() {
            report.error(
                Rule::ValueType,
                format!("{place}/@{attribute}"),
                format!("`{text}`"),
                format!("a value of type {}", variable.scalar),
            );
        }
        value
    };
    let (min, max) = (read("min", &variable.min), read("max", &variable.max));
    let nominal = read("nominal", &variable.nominal);
    if let (Some(min), Some(max)) = (min, max)
        && min > max
    {
        report.error(
            Rule::Range,
            place,
            format!("min {min:?}, max {max:?}"),
            "a minimum not greater than the maximum",
        );
    }
    if nominal.is_some_and(|nominal| !(nominal.is_finite() && nominal > 0.0)) {
        report.error(
            Rule::Nominal,
            place,
            format!("{nominal:?}"),
            "a finite number greater than 0",
        );
    }
    let texts = variable
        .start
        .iter()
        .flat_map(|text| text.split_ascii_whitespace());
    for text in texts {
        let Some(value) = number(variable.scalar, text) else {
            let expected = format!("values of type {}", variable.scalar);
            let found = format!("`{text}`");
            report.error(Rule::ValueType, format!("{place}/@start"), found, expected);
            continue;
        };
        if variable.scalar.is_float() && !value.is_finite() {
            let place = format!("{place}/@start");
            report.error(Rule::StartFinite, place, format!("`{text}`"), "a number");
        } else if min.is_some_and(|min| value < min) || max.is_some_and(|max| value > max) {
            report.error(
                Rule::StartRange,
                format!("{place}/@start"),
                format!("`{text}`"),
                "a value within minimum and maximum",
            );
        }
    }
}

fn starts(variable: &Variable, place: &str, report: &mut Report) {
    if variable.scalar == ScalarType::Clock {
        return;
    }
    let count = variable.start_count();
    let initial = variable.effective_initial();
    let needed = matches!(initial, Some(Initial::Exact | Initial::Approx));
    let forbidden = initial == Some(Initial::Calculated);
    if needed && count == 0 {
        let expected = "one: the value is given before the initialization";
        report.error(Rule::StartMissing, place, "no start value", expected);
    }
    if forbidden && count > 0 {
        let expected = "none for a calculated value";
        report.error(Rule::StartForbidden, place, "a start value", expected);
    }
    if let Some(elements) = variable.elements()
        && count > 1
        && count as u64 != elements
    {
        report.error(
            Rule::StartCount,
            place,
            format!("{count} start values for {elements} elements"),
            "one for each element, or one for all",
        );
    }
    for start in &variable.starts {
        let digits = start.value.bytes().all(|byte| byte.is_ascii_hexdigit());
        if variable.scalar == ScalarType::Binary && (!digits || start.value.len() % 2 == 1) {
            report.error(
                Rule::ValueType,
                format!("{place}/Start"),
                format!("`{}`", start.value),
                "pairs of hexadecimal digits",
            );
        }
    }
}
