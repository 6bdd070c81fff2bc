//! Rules of the variables (section 2.2.7).

use std::collections::BTreeSet;
use std::fmt::Debug;

use super::super::{
    Causality, EnumerationVariable, Initial, IntegerVariable, RealType, RealVariable,
    ScalarVariable, TypeDefinition, Variability, VariableType,
};
use super::context::Context;
use crate::finding::{Report, Rule};
use crate::value::ScalarType;

pub(super) fn check(context: &Context<'_>, report: &mut Report) {
    let variables = &context.model.model_variables;
    if variables.is_empty() {
        report.error(
            Rule::VariablesMissing,
            "ModelVariables",
            "no variable",
            "at least one",
        );
    }
    let mut names = BTreeSet::new();
    let mut independent: Option<&str> = None;
    for (index, variable) in (1_usize..).zip(variables) {
        let place = place(index, variable);
        context.name(&variable.name, &place, report);
        if !names.insert(variable.name.as_str()) {
            report.error(
                Rule::NameUnique,
                &place,
                "a second variable of this name",
                "one",
            );
        }
        if variable.causality == Causality::Independent {
            if let Some(first) = independent {
                report.error(
                    Rule::Independent,
                    &place,
                    format!("a second independent variable beside `{first}`"),
                    "at most one",
                );
            }
            independent.get_or_insert(&variable.name);
        }
        attributes(variable, &place, report);
        start(variable, &place, report);
        Typed {
            context,
            place: &place,
        }
        .check(variable, report);
    }
}

/// Element, index and name of a variable, for messages.
fn place(index: usize, variable: &ScalarVariable) -> String {
    format!("ModelVariables/ScalarVariable {index} `{}`", variable.name)
}

/// What causality and variability ask of the type.
fn attributes(variable: &ScalarVariable, place: &str, report: &mut Report) {
    combination(variable, place, report);
    let real = variable.variable_type.scalar() == ScalarType::Float64;
    if !real && variable.variability == Variability::Continuous {
        report.error(
            Rule::Variability,
            format!("{place}/@variability"),
            "continuous, stated or by default, for a variable that is not real",
            "another variability",
        );
    }
    if !real && variable.causality == Causality::Independent {
        report.error(
            Rule::Independent,
            place,
            "an independent variable that is not real",
            "a real one",
        );
    }
}

/// Causality, variability and initial go together.
fn combination(variable: &ScalarVariable, place: &str, report: &mut Report) {
    let (causality, variability) = (variable.causality, variable.variability);
    match (causality.legal_initial(variability), variable.initial) {
        (None, _) => {
            let legal: Vec<&str> = Variability::ALL
                .into_iter()
                .filter(|&variability| causality.legal_initial(variability).is_some())
                .map(Variability::name)
                .collect();
            report.error(
                Rule::Combination,
                place,
                format!(
                    "causality {} with variability {}",
                    causality.name(),
                    variability.name()
                ),
                format!("variability {}", legal.join(" or ")),
            );
        }
        (Some([]), Some(initial)) => report.error(
            Rule::Initial,
            format!("{place}/@initial"),
            initial.name(),
            format!("none for causality {}", causality.name()),
        ),
        (Some(legal), Some(initial)) if !legal.contains(&initial) => {
            let legal: Vec<&str> = legal.iter().map(|initial| initial.name()).collect();
            report.error(
                Rule::Initial,
                format!("{place}/@initial"),
                initial.name(),
                format!(
                    "{} for causality {} and variability {}",
                    legal.join(" or "),
                    causality.name(),
                    variability.name()
                ),
            );
        }
        _ => {}
    }
}

/// A start value where one is required, none where none is allowed.
fn start(variable: &ScalarVariable, place: &str, report: &mut Report) {
    let initial = variable.effective_initial();
    let required = if matches!(variable.causality, Causality::Input | Causality::Parameter) {
        Some(format!("causality {}", variable.causality.name()))
    } else if variable.variability == Variability::Constant {
        Some("variability constant".to_owned())
    } else {
        initial
            .filter(|initial| matches!(initial, Initial::Exact | Initial::Approx))
            .map(|initial| format!("initial {}", initial.name()))
    };
    let forbidden = if variable.causality == Causality::Independent {
        Some("causality independent")
    } else if required.is_none() && initial == Some(Initial::Calculated) {
        Some("initial calculated, stated or by default")
    } else {
        None
    };
    match (variable.has_start(), required, forbidden) {
        (true, _, Some(reason)) => report.error(
            Rule::StartForbidden,
            format!("{place}/@start"),
            "a start value",
            format!("none because of {reason}"),
        ),
        (false, Some(reason), None) => report.error(
            Rule::StartMissing,
            place,
            "no start value",
            format!("one because of {reason}"),
        ),
        _ => {}
    }
}

/// Rules of what belongs to the type of one variable.
struct Typed<'a> {
    context: &'a Context<'a>,
    place: &'a str,
}

impl Typed<'_> {
    fn check(&self, variable: &ScalarVariable, report: &mut Report) {
        match &variable.variable_type {
            VariableType::Real(real) => self.real(real, report),
            VariableType::Integer(integer) => self.integer(integer, report),
            VariableType::Boolean(boolean) => {
                self.declared(
                    boolean.declared_type.as_deref(),
                    ScalarType::Boolean,
                    report,
                );
            }
            VariableType::String(string) => {
                self.declared(string.declared_type.as_deref(), ScalarType::String, report);
            }
            VariableType::Enumeration(enumeration) => self.enumeration(enumeration, report),
        }
    }

    fn real(&self, real: &RealVariable, report: &mut Report) {
        let place = self.place;
        let definition = self.declared(real.declared_type.as_deref(), ScalarType::Float64, report);
        let defaults = match definition {
            Some(TypeDefinition::Real(defaults)) => defaults,
            _ => &RealType::default(),
        };
        // What the type says of itself is judged where the type stands.
        if real.unit.is_some() || real.display_unit.is_some() {
            self.context.unit(
                real.unit.as_deref().or(defaults.unit.as_deref()),
                real.display_unit.as_deref(),
                place,
                report,
            );
        }
        match real.start {
            Some(start) if !start.is_finite() => report.warning(
                Rule::StartFinite,
                format!("{place}/@start"),
                format!("{start:?}"),
                "a finite number",
            ),
            start => range(
                real.min.or(defaults.min),
                real.max.or(defaults.max),
                start,
                place,
                report,
            ),
        }
        nominal(real.nominal, place, report);
    }

    fn integer(&self, integer: &IntegerVariable, report: &mut Report) {
        let definition = self.declared(integer.declared_type.as_deref(), ScalarType::Int32, report);
        let (min, max) = match definition {
            Some(TypeDefinition::Integer(defaults)) => (defaults.min, defaults.max),
            _ => (None, None),
        };
        range(
            integer.min.or(min),
            integer.max.or(max),
            integer.start,
            self.place,
            report,
        );
    }

    fn enumeration(&self, enumeration: &EnumerationVariable, report: &mut Report) {
        let definition = self.declared(
            Some(&enumeration.declared_type),
            ScalarType::Enumeration,
            report,
        );
        range(
            enumeration.min,
            enumeration.max,
            enumeration.start,
            self.place,
            report,
        );
        if let Some(TypeDefinition::Enumeration(defaults)) = definition
            && let Some(start) = enumeration.start
            && !defaults.items.iter().any(|item| item.value == start)
        {
            report.error(
                Rule::StartRange,
                format!("{}/@start", self.place),
                start.to_string(),
                format!("the value of an item of `{}`", enumeration.declared_type),
            );
        }
    }

    /// The declared type is there and of the base type of the variable.
    fn declared(
        &self,
        name: Option<&str>,
        scalar: ScalarType,
        report: &mut Report,
    ) -> Option<&TypeDefinition> {
        let name = name?;
        let definition = self
            .context
            .types
            .get(name)
            .map(|simple| &simple.definition);
        let found = match definition {
            Some(definition) if definition.scalar() == scalar => return Some(definition),
            Some(_) => format!("`{name}`, a type of another base type"),
            None => format!("`{name}`"),
        };
        report.error(
            Rule::DeclaredType,
            format!("{}/@declaredType", self.place),
            found,
            "the name of a type in TypeDefinitions with the base type of the variable",
        );
        None
    }
}

/// Minimum, maximum and start value are in this order.
pub(super) fn range<T: PartialOrd + Debug + Copy>(
    min: Option<T>,
    max: Option<T>,
    start: Option<T>,
    place: &str,
    report: &mut Report,
) {
    // A NaN is not even equal to itself.
    let ordered = |low: T, high: T| low <= high;
    let mut usable = true;
    for (attribute, bound) in [("min", min), ("max", max)] {
        if let Some(bound) = bound
            && !ordered(bound, bound)
        {
            usable = false;
            report.error(
                Rule::Range,
                format!("{place}/@{attribute}"),
                format!("{bound:?}"),
                "a number",
            );
        }
    }
    if !usable {
        return;
    }
    if let (Some(min), Some(max)) = (min, max)
        && !ordered(min, max)
    {
        report.error(
            Rule::Range,
            place,
            format!("the minimum {min:?} above the maximum {max:?}"),
            "a minimum not greater than the maximum",
        );
        return;
    }
    let Some(start) = start else { return };
    let place = format!("{place}/@start");
    if let Some(min) = min
        && !ordered(min, start)
    {
        let expected = format!("at least the minimum {min:?}");
        report.error(Rule::StartRange, &place, format!("{start:?}"), expected);
    }
    if let Some(max) = max
        && !ordered(start, max)
    {
        let expected = format!("at most the maximum {max:?}");
        report.error(Rule::StartRange, &place, format!("{start:?}"), expected);
    }
}

/// The nominal value is a size.
pub(super) fn nominal(nominal: Option<f64>, place: &str, report: &mut Report) {
    if let Some(nominal) = nominal
        && !(nominal.is_finite() && nominal > 0.0)
    {
        report.error(
            Rule::Nominal,
            format!("{place}/@nominal"),
            format!("{nominal:?}"),
            "a finite number greater than 0",
        );
    }
}
