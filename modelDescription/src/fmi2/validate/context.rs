//! What the rules look up in a description.

use std::collections::BTreeMap;

use crate::finding::{Report, Rule};
use crate::fmi2::{ModelDescription, NamingConvention, SimpleType};
use crate::names;
use crate::units::Unit;

/// What variables are judged against.
pub(super) struct Context<'a> {
    pub(super) model: &'a ModelDescription,
    pub(super) units: BTreeMap<&'a str, &'a Unit>,
    pub(super) types: BTreeMap<&'a str, &'a SimpleType>,
}

impl<'a> Context<'a> {
    pub(super) fn new(model: &'a ModelDescription) -> Self {
        let units = model.unit_definitions.iter();
        let types = model.type_definitions.iter();
        Self {
            model,
            units: units.map(|unit| (unit.name.as_str(), unit)).collect(),
            types: types.map(|simple| (simple.name.as_str(), simple)).collect(),
        }
    }

    /// A name has the form that the convention asks for.
    pub(super) fn name(&self, name: &str, place: &str, report: &mut Report) {
        if name.is_empty() {
            report.error(Rule::RequiredAttribute, place, "an empty name", "a name");
            return;
        }
        match self.model.variable_naming_convention {
            NamingConvention::Flat => {
                if name.contains(['\n', '\r', '\t']) {
                    report.error(
                        Rule::Name,
                        place,
                        "a line feed, carriage return or tab",
                        "none in a flat name",
                    );
                }
            }
            NamingConvention::Structured => {
                if let Err(error) = names::check_structured(name) {
                    report.error(
                        Rule::Name,
                        place,
                        format!("{} at byte {}", error.found, error.offset),
                        format!("{} in a structured name", error.expected),
                    );
                }
            }
        }
    }

    /// Unit and display unit are defined.
    pub(super) fn unit(
        &self,
        unit: Option<&str>,
        display_unit: Option<&str>,
        place: &str,
        report: &mut Report,
    ) {
        let defined = unit.and_then(|name| self.units.get(name));
        if let Some(name) = unit
            && defined.is_none()
        {
            report.error(
                Rule::UnitDefined,
                format!("{place}/@unit"),
                format!("`{name}`"),
                "the name of a unit in UnitDefinitions",
            );
        }
        let Some(display_name) = display_unit else {
            return;
        };
        let place = format!("{place}/@displayUnit");
        let found = format!("`{display_name}`");
        match (unit, defined) {
            (None, _) => report.error(
                Rule::DisplayUnitDefined,
                place,
                format!("{found} without unit"),
                "a unit beside it",
            ),
            // The standard lets importers ignore such a display unit.
            (Some(name), Some(unit))
                if !unit.display_units.iter().any(|d| d.name == display_name) =>
            {
                report.warning(
                    Rule::DisplayUnitDefined,
                    place,
                    found,
                    format!("a display unit of `{name}`"),
                );
            }
            _ => {}
        }
    }
}
