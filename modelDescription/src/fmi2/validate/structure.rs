//! Rules of the model structure (section 2.2.8).

use std::collections::BTreeSet;

use super::super::structure::{exposed_states, indexed, initial_unknowns, variable_at};
use super::super::{Causality, DependencyKind, Initial, ModelDescription, ScalarVariable, Unknown};
use crate::finding::{Report, Rule};
use crate::value::ScalarType;

pub(super) fn check(model: &ModelDescription, report: &mut Report) {
    outputs(model, report);
    initial(model, report);
}

fn outputs(model: &ModelDescription, report: &mut Report) {
    let variables = &model.model_variables;
    let structure = &model.model_structure;
    let list = List {
        element: "Outputs",
        unknowns: &structure.outputs,
        variables,
    };
    let expected = indexed(variables)
        .filter(|(_, variable)| variable.causality == Causality::Output)
        .map(|(index, _)| index)
        .collect();
    list.indices(Rule::Outputs, report);
    list.complete(Rule::Outputs, &expected, "an output", report);
    if !list.ascends() {
        // The standard leaves the order to the exporter and advises this one.
        report.warning(
            Rule::OutputsOrder,
            "ModelStructure/Outputs",
            "another order than that of the variables",
            "ascending indices",
        );
    }
    let states = exposed_states(variables, &structure.derivatives);
    let known =
        |index: u32, variable: &ScalarVariable| is_given(variable) || states.contains(&index);
    let inputs = "an input, an exposed state or the independent variable";
    list.dependencies(&known, inputs, &[], report);
}

fn initial(model: &ModelDescription, report: &mut Report) {
    let variables = &model.model_variables;
    let structure = &model.model_structure;
    let list = List {
        element: "InitialUnknowns",
        unknowns: &structure.initial_unknowns,
        variables,
    };
    let expected = initial_unknowns(variables, &structure.derivatives);
    let expected = expected.into_iter().collect();
    let what = "computed by the initialization";
    list.indices(Rule::InitialUnknowns, report);
    list.complete(Rule::InitialUnknowns, &expected, what, report);
    if !list.ascends() {
        report.error(
            Rule::InitialUnknownsOrder,
            "ModelStructure/InitialUnknowns",
            "another order than that of the variables",
            "ascending indices",
        );
    }
    let known = |_: u32, variable: &ScalarVariable| {
        is_given(variable) || variable.effective_initial() == Some(Initial::Exact)
    };
    let kinds = [
        DependencyKind::Fixed,
        DependencyKind::Tunable,
        DependencyKind::Discrete,
    ];
    let given = "an input, a variable with initial exact or the independent variable";
    list.dependencies(&known, given, &kinds, report);
}

/// Whether the importer gives the value at any time.
fn is_given(variable: &ScalarVariable) -> bool {
    matches!(
        variable.causality,
        Causality::Input | Causality::Independent
    )
}

/// `Outputs` or `InitialUnknowns`.
struct List<'a> {
    element: &'static str,
    unknowns: &'a [Unknown],
    variables: &'a [ScalarVariable],
}

impl List<'_> {
    fn place(&self, position: usize, unknown: &Unknown) -> String {
        let name = match variable_at(self.variables, unknown.index) {
            Some(variable) => format!(" `{}`", variable.name),
            None => String::new(),
        };
        format!(
            "ModelStructure/{}/Unknown {position}, index {}{name}",
            self.element, unknown.index
        )
    }

    /// Every index is that of a variable and stands once.
    fn indices(&self, rule: Rule, report: &mut Report) {
        let mut seen = BTreeSet::new();
        for (position, unknown) in (1..).zip(self.unknowns) {
            let place = self.place(position, unknown);
            if variable_at(self.variables, unknown.index).is_none() {
                report.error(
                    Rule::StructureIndex,
                    place,
                    unknown.index.to_string(),
                    format!("an index from 1 to {}", self.variables.len()),
                );
            } else if !seen.insert(unknown.index) {
                report.error(rule, place, "the variable a second time", "once");
            }
        }
    }

    /// The list has exactly the `expected` indices.
    fn complete(&self, rule: Rule, expected: &BTreeSet<u32>, what: &str, report: &mut Report) {
        let found: BTreeSet<u32> = self.unknowns.iter().map(|unknown| unknown.index).collect();
        for (position, unknown) in (1..).zip(self.unknowns) {
            if variable_at(self.variables, unknown.index).is_some()
                && !expected.contains(&unknown.index)
            {
                report.error(
                    rule,
                    self.place(position, unknown),
                    format!("a variable that is not {what}"),
                    "no such entry",
                );
            }
        }
        for &index in expected.difference(&found) {
            let name = variable_at(self.variables, index).map_or("", |v| v.name.as_str());
            report.error(
                rule,
                format!("ModelStructure/{}", self.element),
                format!("no entry for the variable {index} `{name}`, which is {what}"),
                "one entry",
            );
        }
    }

    fn ascends(&self) -> bool {
        self.unknowns.is_sorted_by_key(|unknown| unknown.index)
    }

    fn dependencies(
        &self,
        known: &dyn Fn(u32, &ScalarVariable) -> bool,
        what: &str,
        forbidden: &[DependencyKind],
        report: &mut Report,
    ) {
        for (position, unknown) in (1..).zip(self.unknowns) {
            let place = self.place(position, unknown);
            if let Some(dependencies) = &unknown.dependencies {
                self.known(dependencies, known, what, &place, report);
            }
            if let Some(kinds) = &unknown.dependencies_kind {
                self.kinds(unknown, kinds, forbidden, &place, report);
            }
        }
    }

    fn known(
        &self,
        dependencies: &[u32],
        known: &dyn Fn(u32, &ScalarVariable) -> bool,
        what: &str,
        place: &str,
        report: &mut Report,
    ) {
        let place = format!("{place}/@dependencies");
        if !dependencies.is_sorted_by(|one, next| one < next) {
            report.error(
                Rule::Dependencies,
                &place,
                "indices that do not ascend",
                "each once, in ascending order",
            );
        }
        for &index in dependencies {
            match variable_at(self.variables, index) {
                None => report.error(
                    Rule::StructureIndex,
                    &place,
                    index.to_string(),
                    format!("an index from 1 to {}", self.variables.len()),
                ),
                // Exporters do this; importers ignore what they do not know.
                Some(variable) if !known(index, variable) => report.warning(
                    Rule::Dependencies,
                    &place,
                    format!("{index} `{}`, which is not known here", variable.name),
                    what,
                ),
                Some(_) => {}
            }
        }
    }

    fn kinds(
        &self,
        unknown: &Unknown,
        kinds: &[DependencyKind],
        forbidden: &[DependencyKind],
        place: &str,
        report: &mut Report,
    ) {
        let place = format!("{place}/@dependenciesKind");
        let dependencies = unknown.dependencies.as_deref().unwrap_or_default();
        if unknown.dependencies.is_none() || dependencies.len() != kinds.len() {
            report.error(
                Rule::DependenciesKind,
                &place,
                format!(
                    "{} kinds for {} dependencies",
                    kinds.len(),
                    dependencies.len()
                ),
                "dependencies beside it, and one kind for each",
            );
        }
        let is_real = |index: u32| {
            variable_at(self.variables, index)
                .is_none_or(|variable| variable.variable_type.scalar() == ScalarType::Float64)
        };
        for (kind, &index) in kinds.iter().zip(dependencies) {
            if forbidden.contains(kind) {
                // Against the text of the standard, yet legal for its schema.
                report.warning(
                    Rule::DependenciesKind,
                    &place,
                    kind.name(),
                    "dependent or constant in this list",
                );
            } else if *kind != DependencyKind::Dependent
                && !(is_real(index) && is_real(unknown.index))
            {
                // Even the reference units of the standard's authors do this.
                report.warning(
                    Rule::DependenciesKind,
                    &place,
                    format!("{} with a variable that is not real", kind.name()),
                    "dependent",
                );
            }
        }
    }
}
