//! What can go wrong with a foreign FMU.

use std::io;
use std::path::PathBuf;
use std::process::ExitStatus;
use std::time::Duration;

use thiserror::Error;
use zip::result::ZipError;

use crate::status::{Phase, Status};

/// Why an archive was not unpacked. Nothing of it is left on disk.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ArchiveError {
    /// The archive could not be read.
    #[error("{0}; expected a file that can be read")]
    Open(io::Error),
    /// A file to unpack it to could not be written.
    #[error(
        "cannot unpack to `{path}`: {source}; expected a folder with free space: set TMPDIR (TMP on Windows) to one",
        path = path.display()
    )]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// It is not a zip archive, or one that is damaged or packed in a way that FMI does not allow.
    #[error(
        "{place}: {source}; expected a zip archive, its entries stored or deflated, without password: \
         export the FMU again"
    )]
    Zip {
        /// "archive", or the entry in it.
        place: String,
        /// What is wrong.
        source: ZipError,
    },
    /// An entry would land outside the folder that it is unpacked to.
    #[error(
        "entry {name:?}: found a path that leaves the archive, expected a relative path without `..`: \
         do not use this file, it may be an attack"
    )]
    Escape {
        /// Name of the entry.
        name: String,
    },
    /// An entry is a symbolic link, which could lead outside the folder.
    #[error(
        "entry {name:?}: found a symbolic link, expected a file or folder: pack the file that it leads to"
    )]
    SymbolicLink {
        /// Name of the entry.
        name: String,
    },
    /// Two entries have the same name or share their packed bytes.
    #[error(
        "found entries that overlap or differ under one name, expected each byte once and one content for a name: do not use this file, it may be an attack"
    )]
    Overlap,
    /// The archive asks for more than [`Limits`](crate::Limits) allow.
    #[error(
        "found more than {limit} {what}, expected at most that: if the file is to be trusted, raise the limit"
    )]
    Limit {
        /// What there is too much of.
        what: &'static str,
        /// How much is allowed.
        limit: u64,
    },
}

/// Why a foreign FMU could not be loaded, or a call of it failed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The file is not an archive that can be unpacked.
    #[error("{path}: {source}", path = path.display())]
    Archive {
        /// The FMU.
        path: PathBuf,
        /// What is wrong with it.
        source: ArchiveError,
    },
    /// The archive has no readable `modelDescription.xml`.
    #[error(
        "{path}: modelDescription.xml: {problem}; expected a text in UTF-8 at the top of the archive: \
         pack the contents of the FMU's folder, not the folder itself",
        path = path.display()
    )]
    NoDescription {
        /// The FMU.
        path: PathBuf,
        /// What the system says.
        problem: io::Error,
    },
    /// The model description cannot be understood.
    #[error(
        "{path}: modelDescription.xml: {source}; expected a model description of FMI 2.0 or 3.0: export the FMU \
         again, for co-simulation",
        path = path.display()
    )]
    Description {
        /// The FMU.
        path: PathBuf,
        /// Where and why.
        source: sphere_dda_model_description::Error,
    },
    /// The FMU does not offer co-simulation.
    #[error(
        "{path}: found no <CoSimulation> in modelDescription.xml, expected one: export the FMU for co-simulation",
        path = path.display()
    )]
    NoCoSimulation {
        /// The FMU.
        path: PathBuf,
    },
    /// The model identifier would lead to another file than a library of the FMU.
    #[error(
        "{path}: modelIdentifier: found {found:?}, expected a C identifier: export the FMU again",
        path = path.display()
    )]
    ModelIdentifier {
        /// The FMU.
        path: PathBuf,
        /// The identifier.
        found: String,
    },
    /// The FMU has no library for this system.
    #[error(
        "{path}: found binaries for {found}, expected {expected}: export the FMU for this platform",
        path = path.display()
    )]
    NoBinary {
        /// The FMU.
        path: PathBuf,
        /// Path that the library should have in the archive.
        expected: String,
        /// Platforms that there are binaries for.
        found: String,
    },
    /// The library cannot be loaded.
    #[error(
        "{path}: {source}; expected a shared library for this system, with all that it depends on: \
         build it for this system, or install what it names",
        path = path.display()
    )]
    Load {
        /// The unpacked library.
        path: PathBuf,
        /// What the system's loader says.
        source: libloading::Error,
    },
    /// The library lacks a function that the call needs.
    #[error("{path}: found no function `{function}`, expected one: build the FMU with it", path = path.display())]
    MissingFunction {
        /// The unpacked library.
        path: PathBuf,
        /// Its name in C.
        function: &'static str,
    },
    /// Events of an FMU of FMI 3.0 do not come to an end.
    #[error(
        "{function}: found {found} calls at one time, each with another event to handle, expected an end of them: see what the \
         FMU logged"
    )]
    Endless {
        /// The function that asks for more.
        function: &'static str,
        /// How often it was called.
        found: u32,
    },
    /// The library speaks another version or another set of types.
    #[error("{function}: found {found:?}, expected {expected:?}: export the FMU again")]
    Interface {
        /// The function that tells.
        function: &'static str,
        /// What it says.
        found: String,
        /// What it should say.
        expected: &'static str,
    },
    /// A second instance of an FMU that can have one only.
    #[error(
        "found a living instance, expected none: the FMU can be instantiated only once per process; drop the first \
         instance before, or give each a process of its own (`--isolate`)"
    )]
    OnlyOnce,
    /// No instance was made.
    #[error(
        "{function}: found no instance of `{instance}`, expected one{}: see what the FMU logged, and whether guid \
         and resources are those of its library",
        said(.log)
    )]
    Instantiate {
        /// The function in C.
        function: &'static str,
        /// Name of the instance.
        instance: String,
        /// Last messages of the FMU.
        log: Vec<String>,
    },
    /// A call is not allowed now.
    #[error("{function}: found the instance {found}, expected it {expected}")]
    Phase {
        /// The function in C.
        function: &'static str,
        /// The phase it is in.
        found: Phase,
        /// The phases that allow the call.
        expected: String,
    },
    /// A call returned a status that says it did not do its work.
    #[error("{function}: found status {status}, expected OK{}", said(.log))]
    Call {
        /// The function in C.
        function: &'static str,
        /// `Discard`, `Error`, `Fatal`, or `Pending` where nothing may be pending.
        status: Status,
        /// Last messages of the FMU.
        log: Vec<String>,
    },
    /// A call returned a number that is no status.
    #[error(
        "{function}: found status {found}, expected 0 to 5: the FMU does not keep to the standard"
    )]
    UnknownStatus {
        /// The function in C.
        function: &'static str,
        /// The number.
        found: i32,
    },
    /// A call gave NULL where it promised data.
    #[error(
        "{function}: found NULL for {what}, expected data: the FMU does not keep to the standard"
    )]
    Null {
        /// The function in C.
        function: &'static str,
        /// What should be there.
        what: String,
    },
    /// Two lists of one call differ in length.
    #[error("{function}: found {found} values, expected {expected}, one for each value reference")]
    Length {
        /// The function in C.
        function: &'static str,
        /// Number of values.
        found: usize,
        /// Number of value references.
        expected: usize,
    },
    /// A text with a NUL character cannot pass the C interface.
    #[error("{function}: found a NUL character in {text:?}, expected none")]
    Nul {
        /// The function in C.
        function: &'static str,
        /// The text.
        text: String,
    },
    /// A number does not fit the type of the variable.
    #[error("{function}: found {found}, expected a value of {expected}")]
    Range {
        /// The function in C.
        function: &'static str,
        /// The number.
        found: String,
        /// The type.
        expected: String,
    },
    /// An array is too large to be looked at element by element.
    #[error(
        "{path}: variable `{name}`: found {found} elements, expected at most {limit} in all variables together: \
         the array is too large to be read element by element",
        path = path.display()
    )]
    Elements {
        /// The FMU.
        path: PathBuf,
        /// Name of the array.
        name: String,
        /// Number of its elements.
        found: String,
        /// The limit.
        limit: u64,
    },
    /// An FMU of FMI 3.0 where only one of 2.0 will do.
    #[error("{path}: found FMI 3.0, expected FMI 2.0: export the FMU as FMI 2.0", path = path.display())]
    Version {
        /// The FMU.
        path: PathBuf,
    },
    /// A call of an FMU in a process of its own failed, for one of the other reasons.
    #[error("{0}")]
    Isolated(String),
    /// The process of an FMU ended within a call, or after it.
    #[error(
        "{path}: {function}: found the process of the FMU ended by {how}, expected it to return{}: report it to its vendor",
        said(.log),
        path = path.display()
    )]
    Ended {
        /// The FMU.
        path: PathBuf,
        /// The function in C.
        function: String,
        /// Exit code or signal.
        how: ExitStatus,
        /// Last messages of the FMU.
        log: Vec<String>,
    },
    /// A call took too long; the process of the FMU is ended.
    #[error(
        "{path}: {function}: found no return within the limit of {limit} s, expected one{}: allow longer calls, or report it to \
         its vendor",
        said(.log),
        limit = limit.as_secs_f64(),
        path = path.display()
    )]
    TimedOut {
        /// The FMU.
        path: PathBuf,
        /// The function in C.
        function: String,
        /// The limit.
        limit: Duration,
        /// Last messages of the FMU.
        log: Vec<String>,
    },
    /// The process of an FMU could not be started or understood.
    #[error("{path}: {source}; expected a process for the FMU", path = path.display())]
    Process {
        /// The FMU.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A saved state of another instance, or one that was freed.
    #[error(
        "{function}: found a state that is not of this instance, expected one that it saved and did not free"
    )]
    ForeignState {
        /// The function in C.
        function: &'static str,
    },
}

/// The last messages of an FMU, for the end of an error.
fn said(log: &[String]) -> String {
    match log {
        [] => String::new(),
        log => format!("; the FMU says: {}", log.join(" | ")),
    }
}
