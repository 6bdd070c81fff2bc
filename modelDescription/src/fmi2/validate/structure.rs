//! Rules of the model structure (section 2.2.8).

use std::collections::BTreeSet;

use super::super::structure::{exposed_states, indexed, initial_unknowns, variable_at};
use super::super::{
    Causality, DependencyKind, Initial, ModelDescription, ScalarVariable, Unknown, Variability,
};
use crate::finding::{Report, Rule};
use crate::value::ScalarType;

pub(super) fn check(model: &ModelDescription, report: &mut Report) {
    let variables = &model.model_variables;
    let structure = &model.model_structure;
    let states = exposed_states(variables, &structure.derivatives);

    let outputs = List {
        element: "Outputs",
        unknowns: &structure.outputs,
        variables,
    };
    let expected = indexed(variables)
        .filter(|(_, variable)| variable.causality == Causality::Output)
        .map(|(index, _)| index)
        .collect();
    outputs.indices(Rule::Outputs, report);
    outputs.complete(Rule::Outputs, &expected, "an output", report);
    if !outputs.ascends() {
        // The standard leaves the order to the exporter and advises this one.
        report.warning(
            Rule::OutputsOrder,
            "ModelStructure/Outputs",
            "another order than that of the variables",
            "ascending indices",
        );
    }
    let known_while_running = |index: u32, variable: &ScalarVariable| {
        matches!(
            variable.causality,
            Causality::Input | Causality::Independent
        ) || states.contains(&index)
    };
    let inputs = "an input, an exposed state or the independent variable";
    outputs.dependencies(&known_while_running, inputs, &[], report);

    let derivatives = List {
        element: "Derivatives",
        unknowns: &structure.derivatives,
        variables,
    };
    derivatives.indices(Rule::Derivatives, report);
    derivatives.are_state_derivatives(report);
    derivatives.dependencies(&known_while_running, inputs, &[], report);

    let initial = List {
        element: "InitialUnknowns",
        unknowns: &structure.initial_unknowns,
        variables,
    };
    let expected = initial_unknowns(variables, &structure.derivatives)
        .into_iter()
        .collect();
    initial.indices(Rule::InitialUnknowns, report);
    initial.complete(
        Rule::InitialUnknowns,
        &expected,
        "computed by the initialization",
        report,
    );
    if !initial.ascends() {
        report.error(
            Rule::InitialUnknownsOrder,
            "ModelStructure/InitialUnknowns",
            "another order than that of the variables",
            "ascending indices",
        );
    }
    let known_at_start = |_: u32, variable: &ScalarVariable| {
        matches!(
            variable.causality,
            Causality::Input | Causality::Independent
        ) || variable.effective_initial() == Some(Initial::Exact)
    };
    initial.dependencies(
        &known_at_start,
        "an input, a variable with initial exact or the independent variable",
        &[
            DependencyKind::Fixed,
            DependencyKind::Tunable,
            DependencyKind::Discrete,
        ],
        report,
    );
}

/// One of the three lists.
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

    /// Every entry is a continuous real variable that says of what it is the
    /// derivative, and that is a state.
    fn are_state_derivatives(&self, report: &mut Report) {
        for (position, unknown) in (1..).zip(self.unknowns) {
            let Some(variable) = variable_at(self.variables, unknown.index) else {
                continue;
            };
            let place = self.place(position, unknown);
            let Some(state) = variable.derivative() else {
                report.error(
                    Rule::Derivatives,
                    place,
                    "a variable without the attribute derivative",
                    "a state derivative",
                );
                continue;
            };
            if variable.variability != Variability::Continuous {
                report.error(
                    Rule::Derivatives,
                    &place,
                    format!(
                        "a derivative of variability {}",
                        variable.variability.name()
                    ),
                    "a continuous one",
                );
            }
            // A wrong index is reported with the variable itself.
            if let Some(state) = variable_at(self.variables, state)
                && (!matches!(state.causality, Causality::Local | Causality::Output)
                    || state.variability != Variability::Continuous)
            {
                report.error(
                    Rule::Derivatives,
                    place,
                    format!(
                        "a state `{}` of causality {} and variability {}",
                        state.name,
                        state.causality.name(),
                        state.variability.name()
                    ),
                    "a continuous state of causality local or output",
                );
            }
        }
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
