//! Type definitions: enumerations. Those that only give defaults to several variables are skipped when read.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::Variable;
use crate::finding::{Report, Rule};
use crate::fmi2::validate::required;
use crate::lexical;
use crate::value::ScalarType;

/// A named set of named integers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct EnumerationType {
    /// Name, unique among types.
    #[serde(rename = "@name")]
    pub name: String,
    /// What the type is for.
    #[serde(
        rename = "@description",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub description: Option<String>,
    /// Physical quantity.
    #[serde(rename = "@quantity", default, skip_serializing_if = "Option::is_none")]
    pub quantity: Option<String>,
    /// The items, at least one.
    #[serde(rename = "Item", default)]
    pub items: Vec<EnumerationItem>,
}

/// One named value of an enumeration.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct EnumerationItem {
    /// Name, unique in the enumeration.
    #[serde(rename = "@name")]
    pub name: String,
    /// Value, unique in the enumeration.
    #[serde(rename = "@value", with = "lexical")]
    pub value: i64,
    /// What it means.
    #[serde(
        rename = "@description",
        default,
        skip_serializing_if = "Option::is_none"
    )]
    pub description: Option<String>,
}

impl EnumerationType {
    /// An enumeration of the items `(name, value, description)`.
    pub fn new<'a>(
        name: impl Into<String>,
        items: impl IntoIterator<Item = (&'a str, i64, &'a str)>,
    ) -> Self {
        let items = items
            .into_iter()
            .map(|(name, value, text)| EnumerationItem {
                name: name.to_owned(),
                value,
                description: Some(text.to_owned()),
            });
        Self {
            name: name.into(),
            description: None,
            quantity: None,
            items: items.collect(),
        }
    }
}

/// Names of types and items, and values of items, are there and unique.
pub(super) fn check(types: &[EnumerationType], report: &mut Report) {
    let mut names = BTreeSet::new();
    for definition in types {
        let place = format!("TypeDefinitions/EnumerationType `{}`", definition.name);
        required(&definition.name, format!("{place}/@name"), report);
        if !names.insert(&definition.name) {
            report.error(
                Rule::TypeNameUnique,
                &place,
                "a second type of this name",
                "one",
            );
        }
        if definition.items.is_empty() {
            report.error(Rule::EnumerationItems, &place, "no item", "at least one");
        }
        let (mut items, mut values) = (BTreeSet::new(), BTreeSet::new());
        for item in &definition.items {
            let place = format!("{place}/Item `{}`", item.name);
            required(&item.name, format!("{place}/@name"), report);
            if !items.insert(&item.name) || !values.insert(item.value) {
                let found = format!("the name or the value {} a second time", item.value);
                report.error(Rule::EnumerationUnique, &place, found, "each once");
            }
        }
    }
}

/// An enumeration names its type, and its start values are items.
pub(super) fn declared(
    variable: &Variable,
    types: &[EnumerationType],
    place: &str,
    report: &mut Report,
) {
    if variable.scalar != ScalarType::Enumeration {
        return;
    }
    let name = variable.declared_type.as_deref();
    let definition = types.iter().find(|d| Some(d.name.as_str()) == name);
    let Some(definition) = definition else {
        report.error(
            Rule::DeclaredType,
            format!("{place}/@declaredType"),
            format!("`{}`", name.unwrap_or_default()),
            "the name of an EnumerationType",
        );
        return;
    };
    let starts = variable.start.iter();
    for start in starts.flat_map(|text| text.split_ascii_whitespace()) {
        // What is no number has been reported.
        if let Ok(value) = start.parse::<i64>()
            && !definition.items.iter().any(|item| item.value == value)
        {
            report.error(
                Rule::StartRange,
                format!("{place}/@start"),
                start,
                format!("the value of an item of `{}`", definition.name),
            );
        }
    }
}
