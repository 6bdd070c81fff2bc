//! Terminals and icons: `terminalsAndIcons/terminalsAndIcons.xml` of FMI 3.0 (section 2.4.9), which FMI 2.0.4 takes over.
//!
//! A terminal groups variables that are connected together, as the pose and the wrench of one body. Terminals nest.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use serde_with_macros::apply;

use crate::finding::{Finding, Report, Rule};
use crate::lexical;
use crate::list::list_element;
use crate::xml::{self, Error};

/// The value of `fmiVersion`, also in units of FMI 2.0: the file is that of FMI 3.0.
pub const FMI_VERSION: &str = "3.0";

/// Name of the root element.
const ROOT: &str = "fmiTerminalsAndIcons";

list_element!(terminal_list, super::Terminal, "Terminal");

/// The root element `fmiTerminalsAndIcons`.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
    Vec => #[serde(default, skip_serializing_if = "Vec::is_empty")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TerminalsAndIcons {
    /// [`FMI_VERSION`].
    #[serde(rename = "@fmiVersion")]
    fmi_version: String,
    /// Where `icon.png` is drawn; `None`: there is no icon.
    #[serde(rename = "GraphicalRepresentation")]
    pub graphical_representation: Option<GraphicalRepresentation>,
    /// The terminals.
    #[serde(rename = "Terminals", with = "terminal_list")]
    pub terminals: Vec<Terminal>,
}

/// The drawing area and the place of the icon in it.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GraphicalRepresentation {
    /// The drawing area.
    #[serde(rename = "CoordinateSystem")]
    pub coordinate_system: Option<CoordinateSystem>,
    /// The place of `icon.png`.
    #[serde(rename = "Icon")]
    pub icon: Option<Icon>,
}

impl GraphicalRepresentation {
    /// A square of `size` \[mm\] around the origin, filled by the icon.
    #[must_use]
    pub fn square(size: f64) -> Self {
        let (x1, x2) = (-size / 2.0, size / 2.0);
        Self {
            coordinate_system: Some(CoordinateSystem {
                x1,
                y1: x1,
                x2,
                y2: x2,
                scale: 1.0,
            }),
            icon: Some(Icon {
                x1,
                y1: x1,
                x2,
                y2: x2,
            }),
        }
    }
}

/// Lower left and upper right corner of the drawing area.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CoordinateSystem {
    /// Left.
    #[serde(rename = "@x1", with = "lexical")]
    pub x1: f64,
    /// Bottom.
    #[serde(rename = "@y1", with = "lexical")]
    pub y1: f64,
    /// Right.
    #[serde(rename = "@x2", with = "lexical")]
    pub x2: f64,
    /// Top.
    #[serde(rename = "@y2", with = "lexical")]
    pub y2: f64,
    /// Factor to millimetres \[mm\].
    #[serde(rename = "@suggestedScalingFactorTo_mm", with = "lexical")]
    pub scale: f64,
}

/// Lower left and upper right corner of the icon.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Icon {
    /// Left.
    #[serde(rename = "@x1", with = "lexical")]
    pub x1: f64,
    /// Bottom.
    #[serde(rename = "@y1", with = "lexical")]
    pub y1: f64,
    /// Right.
    #[serde(rename = "@x2", with = "lexical")]
    pub x2: f64,
    /// Top.
    #[serde(rename = "@y2", with = "lexical")]
    pub y2: f64,
}

/// Variables that are connected together.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Terminal {
    /// Name, unique among its neighbours.
    #[serde(rename = "@name")]
    pub name: String,
    /// How members of two terminals find each other: `plug`, `bus`, `sequence` or a name of another standard.
    #[serde(rename = "@matchingRule")]
    pub matching_rule: String,
    /// What it is, by the names of another standard.
    #[serde(rename = "@terminalKind")]
    pub terminal_kind: Option<String>,
    /// One line for people.
    #[serde(rename = "@description")]
    pub description: Option<String>,
    /// Its variables.
    #[serde(
        rename = "TerminalMemberVariable",
        default,
        skip_serializing_if = "Vec::is_empty"
    )]
    pub members: Vec<Member>,
    /// Terminals that are part of it.
    #[serde(rename = "Terminal", default, skip_serializing_if = "Vec::is_empty")]
    pub terminals: Vec<Terminal>,
}

impl Terminal {
    /// A terminal without members whose members connect by name, as far as both sides have them (`bus`).
    pub fn bus(name: impl Into<String>, description: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            matching_rule: "bus".to_owned(),
            terminal_kind: None,
            description: Some(description.into()),
            members: Vec::new(),
            terminals: Vec::new(),
        }
    }
}

/// A variable of a terminal.
#[apply(
    crate = "serde_with_macros",
    Option => #[serde(skip_serializing_if = "Option::is_none")],
)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Member {
    /// Name of the variable.
    #[serde(rename = "@variableName")]
    pub variable_name: String,
    /// Its name in the terminal.
    #[serde(rename = "@memberName")]
    pub member_name: Option<String>,
    /// `signal`, or `inflow` and `outflow` of what adds up to zero where terminals meet.
    #[serde(rename = "@variableKind")]
    pub variable_kind: String,
}

impl Member {
    /// A signal.
    pub fn signal(variable: impl Into<String>, name: impl Into<String>) -> Self {
        Self {
            variable_name: variable.into(),
            member_name: Some(name.into()),
            variable_kind: "signal".to_owned(),
        }
    }
}

impl TerminalsAndIcons {
    /// Terminals without an icon.
    #[must_use]
    pub fn new(terminals: Vec<Terminal>) -> Self {
        Self {
            fmi_version: FMI_VERSION.to_owned(),
            graphical_representation: None,
            terminals,
        }
    }

    /// Reads the text of a `terminalsAndIcons.xml`. Graphical representations of single terminals and stream members
    /// are skipped.
    ///
    /// # Errors
    /// [`Error`], with line and column.
    pub fn from_xml(text: &str) -> Result<Self, Error> {
        xml::read(text, ROOT, FMI_VERSION)
    }

    /// Writes the text of a `terminalsAndIcons.xml`.
    ///
    /// # Errors
    /// [`Error::Character`] if a text has a character that XML cannot carry.
    pub fn to_xml(&self) -> Result<String, Error> {
        xml::write(self, ROOT)
    }

    /// All broken rules, in the order of the document; `variables` are the names of the model's.
    #[must_use]
    pub fn validate<'a>(&self, variables: impl IntoIterator<Item = &'a str>) -> Vec<Finding> {
        let variables: BTreeSet<&str> = variables.into_iter().collect();
        let mut report = Report::default();
        if let Some(area) = self.graphical_representation.as_ref() {
            drawing(area, &mut report);
        }
        level(&self.terminals, "", &variables, &mut report);
        report.findings
    }
}

fn drawing(area: &GraphicalRepresentation, report: &mut Report) {
    let corners = |place: &str, [x1, y1, x2, y2]: [f64; 4], report: &mut Report| {
        let finite = [x1, y1, x2, y2].iter().all(|x| x.is_finite());
        if !finite || x1 == x2 || y1 == y2 {
            let found = format!("the corners ({x1}, {y1}) and ({x2}, {y2})");
            report.error(Rule::Drawing, place, found, "two corners of an area");
        }
    };
    if let Some(c) = &area.coordinate_system {
        corners("CoordinateSystem", [c.x1, c.y1, c.x2, c.y2], report);
        if !(c.scale.is_finite() && c.scale > 0.0) {
            let found = format!("suggestedScalingFactorTo_mm {}", c.scale);
            report.error(Rule::Drawing, "CoordinateSystem", found, "a number > 0");
        }
    }
    if let Some(i) = &area.icon {
        corners("Icon", [i.x1, i.y1, i.x2, i.y2], report);
    }
}

/// The terminals of one level, below `path`.
fn level(terminals: &[Terminal], path: &str, variables: &BTreeSet<&str>, report: &mut Report) {
    let mut names = BTreeSet::new();
    for terminal in terminals {
        let place = format!("Terminal `{path}{}`", terminal.name);
        if terminal.name.is_empty() || terminal.matching_rule.is_empty() {
            let found = "an empty name or matchingRule";
            report.error(Rule::RequiredAttribute, &place, found, "both");
        }
        if !names.insert(&terminal.name) {
            let expected = "names that differ from those of its neighbours";
            report.error(Rule::TerminalUnique, &place, "the name twice", expected);
        }
        members(terminal, &place, variables, report);
        let below = format!("{path}{}/", terminal.name);
        level(&terminal.terminals, &below, variables, report);
    }
}

fn members(terminal: &Terminal, place: &str, variables: &BTreeSet<&str>, report: &mut Report) {
    // Members of a sequence match by their order.
    let by_name = matches!(terminal.matching_rule.as_str(), "plug" | "bus");
    let mut names = BTreeSet::new();
    for member in &terminal.members {
        let variable = &member.variable_name;
        if !variables.contains(variable.as_str()) {
            let expected = "a variable of the model";
            report.error(
                Rule::TerminalVariable,
                place,
                format!("`{variable}`"),
                expected,
            );
        }
        let name = member.member_name.as_deref().unwrap_or_default();
        if by_name && (name.is_empty() || !names.insert(name)) {
            let found = format!("the memberName `{name}` of `{variable}`");
            let expected = "one that no other member has";
            report.error(Rule::TerminalMember, place, found, expected);
        }
    }
}
