//! What a validation reports.

use std::fmt;

/// How serious a [`Finding`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Legal by the letter of the standard, but against its advice, or ignored or
    /// misread by importers.
    Warning,
    /// Against the standard or its schema.
    Error,
}

/// One broken rule of a model description.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// How serious it is.
    pub severity: Severity,
    /// Which rule is broken.
    pub rule: Rule,
    /// Where: element and, if it has one, its name or index.
    pub place: String,
    /// What stands there.
    pub found: String,
    /// What the rule asks for.
    pub expected: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = match self.severity {
            Severity::Warning => "warning",
            Severity::Error => "error",
        };
        write!(
            formatter,
            "{severity}: {}: found {}, expected {}",
            self.place, self.found, self.expected
        )
    }
}

/// The rules that a validation knows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Rule {
    // Header.
    /// `fmiVersion` is the version of the standard.
    FmiVersion,
    /// An attribute that the schema requires is not empty.
    RequiredAttribute,
    /// `generationDateAndTime` is a date and time (xs:dateTime).
    GenerationDateAndTime,
    /// There is an interface: co-simulation, model exchange or both.
    Interface,
    /// `modelIdentifier` is a C identifier.
    ModelIdentifier,
    /// A unit that serializes its state also gets and sets it.
    StateFlags,
    /// Names of log categories are unique.
    LogCategoryUnique,
    /// The default experiment can be run: finite, stop after start, positive
    /// tolerance and step.
    DefaultExperiment,

    // Units and types.
    /// Names of units are unique.
    UnitUnique,
    /// Names of display units are unique within their unit.
    DisplayUnitUnique,
    /// Factors are finite and not zero, offsets are finite.
    UnitConversion,
    /// Names of types are unique, also among the names of the variables.
    TypeNameUnique,
    /// An enumeration has items.
    EnumerationItems,
    /// Names and values of the items of an enumeration are unique.
    EnumerationUnique,

    // One variable.
    /// The name has the form that the naming convention asks for.
    Name,
    /// Names of variables are unique.
    NameUnique,
    /// Causality and variability may go together.
    Combination,
    /// `initial` is absent, or a value the combination allows.
    Initial,
    /// Only real variables are continuous.
    Variability,
    /// There is a start value where one is required.
    StartMissing,
    /// There is no start value where none is allowed.
    StartForbidden,
    /// The start value is finite.
    StartFinite,
    /// The start value lies within minimum and maximum, or is an item of the
    /// enumeration.
    StartRange,
    /// The minimum is not greater than the maximum; neither is NaN.
    Range,
    /// The nominal value is finite and positive.
    Nominal,
    /// The unit is defined.
    UnitDefined,
    /// A display unit has a unit and is defined under it.
    DisplayUnitDefined,
    /// The declared type is defined and of the same base type.
    DeclaredType,
    /// The independent variable is real, and there is at most one.
    Independent,

    // Model structure.
    /// The model has variables.
    VariablesMissing,
    /// Indices are those of variables, counted from 1.
    StructureIndex,
    /// `Outputs` has every output, once, and nothing else.
    Outputs,
    /// `Outputs` is in the order of the variables.
    OutputsOrder,
    /// `InitialUnknowns` has every unknown of the initialization, once, and
    /// nothing else.
    InitialUnknowns,
    /// `InitialUnknowns` is in the order of the variables.
    InitialUnknownsOrder,
    /// Dependencies are known variables, in ascending order.
    Dependencies,
    /// `dependenciesKind` is as long as `dependencies` and of the kinds the list
    /// allows.
    DependenciesKind,

    // FMI 3.0 only.
    /// Value references of variables are unique.
    ReferenceUnique,
    /// A dimension is a number greater than 0, or names a structural parameter or
    /// constant of type UInt64.
    Dimension,
    /// There are as many start values as elements, or one for all.
    StartCount,
    /// Values are of the type of their variable.
    ValueType,
    /// `intermediateUpdate` stands only at inputs, outputs and local variables.
    IntermediateUpdate,
    /// A capability of a step goes with those it needs.
    StepFlags,
    /// A clock named by a variable is one.
    Clocks,

    // Terminals and icons.
    /// A drawing area or icon has an area, and a scale greater than 0.
    Drawing,
    /// Names of terminals are unique among their neighbours.
    TerminalUnique,
    /// Members of a terminal that match by name have names, each its own.
    TerminalMember,
    /// Members of a terminal are variables of the model.
    TerminalVariable,
}

/// Collects findings.
#[derive(Default)]
pub(crate) struct Report {
    pub(crate) findings: Vec<Finding>,
}

impl Report {
    pub(crate) fn error(
        &mut self,
        rule: Rule,
        place: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) {
        self.add(Severity::Error, rule, place, found, expected);
    }

    pub(crate) fn warning(
        &mut self,
        rule: Rule,
        place: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) {
        self.add(Severity::Warning, rule, place, found, expected);
    }

    pub(crate) fn add(
        &mut self,
        severity: Severity,
        rule: Rule,
        place: impl Into<String>,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) {
        self.findings.push(Finding {
            severity,
            rule,
            place: place.into(),
            found: found.into(),
            expected: expected.into(),
        });
    }
}
