//! Why a call was refused: the text of the log line beside `fmi2Error`.

use sphere_dda::error::{SnapshotError, StepError};
use sphere_dda::formats::error::OutputError;
use sphere_dda_fmi_interface::pointers::BadArgument;
use thiserror::Error;

use crate::model::ModelError;
use crate::runtime::life_cycle::LifeCycle;
use crate::runtime::resource::ResourceError;
use crate::runtime::state::StateError;

/// A refused call. Unless it says otherwise, nothing has changed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The call does not belong into this part of the life cycle.
    #[error("not allowed in state {found}, expected {expected}")]
    Stage {
        /// Present state.
        found: LifeCycle,
        /// States in which it is allowed.
        expected: String,
    },
    /// A null pointer, or a value that the argument cannot have.
    #[error(transparent)]
    Argument(#[from] BadArgument),
    /// No such variable, or one of another type.
    #[error("value reference {reference} is no {expected} variable{}", .found.as_ref().map(|f| format!(", it is {f}")).unwrap_or_default())]
    Reference {
        /// Value reference.
        reference: u32,
        /// The variable that has it, with its type.
        found: Option<String>,
        /// Type of the call.
        expected: String,
    },
    /// The variable cannot be set, or not now.
    #[error("`{name}` cannot be set in state {stage}: it is {kind}; {allowed}")]
    NotSettable {
        /// Name of the variable.
        name: String,
        /// Causality and variability.
        kind: String,
        /// Present state.
        stage: LifeCycle,
        /// When it may be set.
        allowed: &'static str,
    },
    /// No derivative of this kind.
    #[error("no derivative of `{name}`, expected {expected}")]
    NotDerivable {
        /// Name of the variable.
        name: String,
        /// What has one.
        expected: &'static str,
    },
    /// There is no step whose derivatives could be given.
    #[error("no derivatives in state {stage}: {why}")]
    NoStep {
        /// Present state.
        stage: LifeCycle,
        /// What is missing.
        why: &'static str,
    },
    /// The value is NaN, infinite or out of bounds.
    #[error("`{name}` = {found}, expected {expected}")]
    Range {
        /// Name of the variable.
        name: String,
        /// Value found.
        found: f64,
        /// What is allowed.
        expected: String,
    },
    /// The value is none of the enumeration's.
    #[error("`{name}` = {found}, expected one of {expected}")]
    Item {
        /// Name of the variable.
        name: String,
        /// Value found.
        found: i64,
        /// Values with their names.
        expected: String,
    },
    /// The variable has no value yet, or none any more.
    #[error(
        "`{name}` has no value in state {stage}: outputs are known from initialization mode on"
    )]
    NoValue {
        /// Name of the variable.
        name: String,
        /// Present state.
        stage: LifeCycle,
    },
    /// The communication point is not where the instance stands.
    #[error(
        "communication point {found} s, expected {expected} s (the end of the last step) within {tolerance:e} s"
    )]
    Point {
        /// Point of the call \[s\].
        found: f64,
        /// Where the instance stands \[s\].
        expected: f64,
        /// Allowed difference \[s\].
        tolerance: f64,
    },
    /// The step ends behind the stop time that was set up.
    #[error("the step ends at {end} s, expected at most the stop time {stop} s of the experiment")]
    PastStop {
        /// End of the step \[s\].
        end: f64,
        /// Stop time \[s\].
        stop: f64,
    },
    /// The step was impossible, and trying it again did not help; the instance needs a reset or an earlier state.
    #[error("the step failed again: {0}; reset the instance or restore an earlier state")]
    Repeated(StepError),
    /// The solver refused an argument, or the start is impossible.
    #[error("{0}")]
    Step(#[from] StepError),
    /// A saved state does not fit.
    #[error("{0}")]
    State(#[from] StateError),
    /// The simulation's part of a saved state does not fit.
    #[error("{0}")]
    Snapshot(#[from] SnapshotError),
    /// The scene does not take the values of its parameters.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// Result files cannot be written.
    #[error("{0}")]
    Output(#[from] OutputError),
    /// The capability is not offered.
    #[error("not offered: {capability} is {value} in the model description")]
    NotOffered {
        /// Name of the flag.
        capability: &'static str,
        /// Its value.
        value: &'static str,
    },
}

/// Why no instance was made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InstantiationError {
    /// No name: nothing to tell instances apart by.
    #[error("instanceName is empty, expected a name")]
    Name,
    /// The resources are not where they should be.
    #[error("{0}")]
    Resource(#[from] ResourceError),
    /// The scene cannot be used.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// The description belongs to another scene or version.
    #[error(
        "guid {found}, expected {expected}: modelDescription.xml, resources and library are not of one export; export the scene again"
    )]
    Guid {
        /// From the importer.
        found: String,
        /// Of the scene in `resources/` with this library.
        expected: String,
    },
    /// A null pointer.
    #[error(transparent)]
    Argument(#[from] BadArgument),
    /// A variable that the importer wants within a step does not exist, or cannot be had there.
    #[error(
        "requiredIntermediateVariables has {reference}, expected value references of variables with intermediateUpdate=\"true\": \
         inputs and outputs"
    )]
    Intermediate {
        /// Value reference.
        reference: u32,
    },
    /// An interface of FMI 3.0 is not offered.
    #[error("{interface} is not offered, expected co-simulation: use fmi3InstantiateCoSimulation")]
    Interface3 {
        /// Its name.
        interface: &'static str,
    },
    /// The interface is not offered.
    #[error("fmuType {found}, expected 1 (co-simulation): model exchange is not offered")]
    Interface {
        /// Value found.
        found: i32,
    },
}
