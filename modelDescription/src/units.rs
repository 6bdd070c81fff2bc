//! Units: exponents of the SI base units and display units.
//!
//! A value `v` in a unit is `factor * v + offset` in its base unit, and
//! `factor * v + offset` of the [`DisplayUnit`] in the display unit. Both point
//! away from the unit of the variable, so kN as display unit of N has the factor
//! 1e-3.

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::finding::{Report, Rule};
use crate::lexical::{self, is_zero};

/// A unit that variables refer to by name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Unit {
    /// Name, unique in the description, for example `N.m`.
    #[serde(rename = "@name")]
    pub name: String,
    /// The unit in SI base units; `None` if it has no such meaning.
    #[serde(rename = "BaseUnit", default, skip_serializing_if = "Option::is_none")]
    pub base_unit: Option<BaseUnit>,
    /// Units in which an importer may show the values.
    #[serde(rename = "DisplayUnit", default)]
    pub display_units: Vec<DisplayUnit>,
}

impl Unit {
    /// A unit of the given SI base units without display units.
    pub fn new(name: impl Into<String>, base_unit: BaseUnit) -> Self {
        Self {
            name: name.into(),
            base_unit: Some(base_unit),
            display_units: Vec::new(),
        }
    }

    /// Adds a display unit: shown value = `factor` * value + `offset`.
    #[must_use]
    pub fn with_display_unit(mut self, name: impl Into<String>, factor: f64, offset: f64) -> Self {
        self.display_units.push(DisplayUnit {
            name: name.into(),
            factor,
            offset,
        });
        self
    }
}

/// Exponents of the SI base units, and the way there.
///
/// Value in base units = `factor` * value + `offset`.
#[apply(
    crate = "serde_with_macros",
    i32 => #[serde(default, skip_serializing_if = "is_zero", with = "lexical")],
)]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BaseUnit {
    /// Exponent of the kilogram.
    #[serde(rename = "@kg")]
    pub kg: i32,
    /// Exponent of the metre.
    #[serde(rename = "@m")]
    pub m: i32,
    /// Exponent of the second.
    #[serde(rename = "@s")]
    pub s: i32,
    /// Exponent of the ampere.
    #[serde(rename = "@A")]
    pub a: i32,
    /// Exponent of the kelvin.
    #[serde(rename = "@K")]
    pub k: i32,
    /// Exponent of the mole.
    #[serde(rename = "@mol")]
    pub mol: i32,
    /// Exponent of the candela.
    #[serde(rename = "@cd")]
    pub cd: i32,
    /// Exponent of the radian, which FMI counts as if it were a base unit.
    #[serde(rename = "@rad")]
    pub rad: i32,
    /// Factor to base units; 1 if absent.
    #[serde(
        rename = "@factor",
        default = "one",
        skip_serializing_if = "is_one",
        with = "lexical"
    )]
    pub factor: f64,
    /// Offset to base units; 0 if absent.
    #[serde(
        rename = "@offset",
        default,
        skip_serializing_if = "is_zero",
        with = "lexical"
    )]
    pub offset: f64,
}

impl BaseUnit {
    /// The unit 1, to start others from: all exponents 0, factor 1, offset 0.
    pub const DIMENSIONLESS: Self = Self {
        kg: 0,
        m: 0,
        s: 0,
        a: 0,
        k: 0,
        mol: 0,
        cd: 0,
        rad: 0,
        factor: 1.0,
        offset: 0.0,
    };
}

impl Default for BaseUnit {
    fn default() -> Self {
        Self::DIMENSIONLESS
    }
}

/// A unit in which an importer may show a value.
///
/// Shown value = `factor` * value + `offset`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DisplayUnit {
    /// Name, unique within its unit.
    #[serde(rename = "@name")]
    pub name: String,
    /// Factor from the unit; 1 if absent.
    #[serde(
        rename = "@factor",
        default = "one",
        skip_serializing_if = "is_one",
        with = "lexical"
    )]
    pub factor: f64,
    /// Offset from the unit; 0 if absent.
    #[serde(
        rename = "@offset",
        default,
        skip_serializing_if = "is_zero",
        with = "lexical"
    )]
    pub offset: f64,
}

fn one() -> f64 {
    1.0
}

fn is_one(value: &f64) -> bool {
    *value == 1.0
}

/// Unique names, usable conversions.
pub(crate) fn check(units: &[Unit], report: &mut Report) {
    let mut names = std::collections::BTreeSet::new();
    for unit in units {
        // An empty name is legal: the standard says so.
        let place = format!("UnitDefinitions/Unit `{}`", unit.name);
        if !names.insert(unit.name.as_str()) {
            report.error(
                Rule::UnitUnique,
                &place,
                "a second unit of this name",
                "one",
            );
        }
        if let Some(base) = &unit.base_unit {
            conversion(
                &format!("{place}/BaseUnit"),
                base.factor,
                base.offset,
                report,
            );
        }
        let mut display_names = std::collections::BTreeSet::new();
        for display in &unit.display_units {
            let place = format!("{place}/DisplayUnit `{}`", display.name);
            if !display_names.insert(display.name.as_str()) {
                report.error(
                    Rule::DisplayUnitUnique,
                    &place,
                    "a second display unit of this name",
                    "one",
                );
            }
            conversion(&place, display.factor, display.offset, report);
        }
    }
}

fn conversion(place: &str, factor: f64, offset: f64, report: &mut Report) {
    if !factor.is_finite() || factor == 0.0 {
        report.error(
            Rule::UnitConversion,
            format!("{place}/@factor"),
            format!("{factor:?}"),
            "a finite number other than 0",
        );
    }
    if !offset.is_finite() {
        report.error(
            Rule::UnitConversion,
            format!("{place}/@offset"),
            format!("{offset:?}"),
            "a finite number",
        );
    }
}
