//! Rules of variables that share a value reference (section 2.2.7).
//!
//! Variables of one base type and one value reference always have one value, so
//! nothing may let their values differ.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::super::{Causality, ScalarVariable, TypeDefinition, Variability, VariableType};
use super::context::Context;
use super::variables::place;
use crate::finding::{Report, Rule, Severity};
use crate::value::ScalarType;

/// Variables of one base type and one value reference.
struct Aliases<'a> {
    first: &'a ScalarVariable,
    /// The first whose value is given from outside.
    free: Option<&'a ScalarVariable>,
}

pub(super) fn check(context: &Context<'_>, report: &mut Report) {
    let mut sets: BTreeMap<(ScalarType, u32), Aliases<'_>> = BTreeMap::new();
    for (index, variable) in (1..).zip(&context.model.model_variables) {
        // Enumerations pass through the C interface as integers.
        let passed = match variable.variable_type.scalar() {
            ScalarType::Enumeration => ScalarType::Int32,
            other => other,
        };
        let handle = (passed, variable.value_reference);
        match sets.entry(handle) {
            Entry::Vacant(entry) => {
                entry.insert(Aliases {
                    first: variable,
                    free: is_free(variable).then_some(variable),
                });
            }
            Entry::Occupied(mut entry) => {
                compare(context, entry.get(), index, variable, report);
                if is_free(variable) {
                    entry.get_mut().free.get_or_insert(variable);
                }
            }
        }
    }
}

/// A further variable against those before it.
fn compare(
    context: &Context<'_>,
    aliases: &Aliases<'_>,
    index: usize,
    variable: &ScalarVariable,
    report: &mut Report,
) {
    let first = aliases.first;
    let mut conflict = |severity: Severity, rule: Rule, other: &ScalarVariable, what: &str| {
        report.add(
            severity,
            rule,
            place(index, variable),
            format!(
                "value reference {}, shared with `{}`, {what}",
                variable.value_reference, other.name
            ),
            "a reference of its own",
        );
    };
    if is_constant(first) != is_constant(variable) {
        conflict(
            Severity::Error,
            Rule::AliasConstant,
            first,
            "only one of them constant",
        );
    } else if is_constant(variable) && !same_start(first, variable) {
        conflict(
            Severity::Error,
            Rule::AliasConstant,
            first,
            "a constant of another value",
        );
    }
    if let Some(free) = aliases.free
        && is_free(variable)
    {
        conflict(
            Severity::Error,
            Rule::AliasStart,
            free,
            "both with a start value or given from outside",
        );
    }
    match (context.unit_of(first), context.unit_of(variable)) {
        (Some(one), Some(other)) if one != other => {
            conflict(Severity::Error, Rule::AliasUnit, first, "with another unit");
        }
        // Modelica tools write this for a connector without unit, and importers
        // take it.
        (Some(_), None) | (None, Some(_)) => {
            conflict(
                Severity::Warning,
                Rule::AliasUnit,
                first,
                "only one of them with a unit",
            );
        }
        _ => {}
    }
}

fn is_constant(variable: &ScalarVariable) -> bool {
    variable.variability == Variability::Constant
}

/// Whether the value is given from outside and not by another variable.
fn is_free(variable: &ScalarVariable) -> bool {
    let set = matches!(
        variable.causality,
        Causality::Input | Causality::Parameter | Causality::Independent
    );
    !is_constant(variable) && (set || variable.has_start())
}

/// Whether two variables of one base type have the same start value.
fn same_start(one: &ScalarVariable, other: &ScalarVariable) -> bool {
    fn integer(variable: &ScalarVariable) -> Option<i32> {
        match &variable.variable_type {
            VariableType::Integer(integer) => integer.start,
            VariableType::Enumeration(enumeration) => enumeration.start,
            _ => None,
        }
    }
    match (&one.variable_type, &other.variable_type) {
        (VariableType::Real(one), VariableType::Real(other)) => one.start == other.start,
        (VariableType::Boolean(one), VariableType::Boolean(other)) => one.start == other.start,
        (VariableType::String(one), VariableType::String(other)) => one.start == other.start,
        _ => integer(one) == integer(other),
    }
}

impl Context<'_> {
    /// Unit of a variable, its own or that of its type.
    fn unit_of<'b>(&'b self, variable: &'b ScalarVariable) -> Option<&'b str> {
        let VariableType::Real(real) = &variable.variable_type else {
            return None;
        };
        let from_type = || {
            let simple = self.types.get(real.declared_type.as_deref()?)?;
            match &simple.definition {
                TypeDefinition::Real(defaults) => defaults.unit.as_deref(),
                _ => None,
            }
        };
        real.unit.as_deref().or_else(from_type)
    }
}
