//! An FMU in a process of its own: its crash, exit or endless loop is an error, not the end of the simulation's process.
//!
//! The process serves one instance. It gets requests and gives reports over a socket, its standard input; what the FMU
//! prints goes to standard error. It ends when the socket does.

use std::ffi::OsString;
use std::path::PathBuf;
use std::time::Duration;

#[cfg(unix)]
mod instance;
#[cfg(unix)]
mod protocol;
#[cfg(unix)]
mod served;

#[cfg(unix)]
pub(crate) use instance::participant;
#[cfg(unix)]
pub use served::serve;

/// How FMUs are run in processes of their own. Unix only: elsewhere [`simulate`](crate::simulate) refuses it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Isolation {
    /// The program to start for each FMU, which must call [`serve`] at once; it is started in the folder and with the
    /// environment of this process.
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
    /// Longest time that one call may take; any if `None`.
    pub call_timeout: Option<Duration>,
}

#[cfg(not(unix))]
mod missing;
#[cfg(not(unix))]
pub(crate) use missing::participant;
#[cfg(not(unix))]
pub use missing::serve;
