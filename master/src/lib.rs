//! Runs foreign FMUs, alone or coupled: any co-simulation FMU of FMI 2.0 or 3.0 with a library for this system.
//!
//! | type or function | is                                                                     |
//! |------------------|------------------------------------------------------------------------|
//! | [`Fmu`]          | an unpacked archive and its model description; loads the library once  |
//! | [`Instance2`]    | one running instance: every call of the standard, judged by its status |
//! | [`System`]       | one FMU, or several with outputs connected to inputs; to an SSP        |
//! | [`Ssp`]          | FMUs, connections and parameters from an SSP                           |
//! | [`simulate`]     | a small master: inputs from a table, outputs to a table                |
//!
//! The archive and the description are untrusted: they are read within limits and refused with a reason. The
//! library itself is native code of this process. It is called as the standard says, in the order it says, so
//! that a library that keeps to the standard cannot do harm; one that does not can do anything, as everywhere. With an
//! [`Isolation`] each instance has a process of its own, and its crash, exit or endless loop is an error here.
//!
//! ```no_run
//! use sphere_dda_master::{Fmu, Options, System, simulate};
//! use std::ops::ControlFlow;
//!
//! let fmu = Fmu::open("funnel.fmu")?;
//! let table = simulate(&System::of(&fmu), &Options::default(), |_| ControlFlow::Continue(()))?;
//! table.write_csv(std::io::stdout())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Rooms, each of which imports only from those before it: `status`, `value`, `error`; `open` (archives and
//! descriptions), `variable` (variables of either version in one form), `calls` (the C interfaces, the one room with
//! unsafe code), `fmu`, `isolate` (an FMU in a process of its own), `system` (names and connections), `ssp`, `run` (one
//! simulation).

mod calls;
mod error;
mod fmu;
mod isolate;
mod open;
mod references;
mod run;
mod ssp;
mod status;
mod system;
mod value;
mod variable;

pub use calls::{Instance2, Message, SavedState, Step};
pub use error::{ArchiveError, ImportError};
pub use fmu::Fmu;
pub use isolate::{Isolation, serve};
pub use open::{Description, Limits, RATIO_FLOOR, remove_unpacked};
pub use references::{Comparison, Expected, References, ReferencesError, SmokeTest};
pub use run::{
    Column, Coupling, CsvWriter, End, Event, InputTable, InputTableError, Iteration, NotConverged,
    Options, SimulateError, Table, simulate,
};
pub use ssp::{PackageError, Ssp, SspError};
pub use status::{Phase, Status};
pub use system::{ConnectionError, ConnectionFault, System, SystemError, VariableError};
pub use value::{Value, ValueType, Values};
