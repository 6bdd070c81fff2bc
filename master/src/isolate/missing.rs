//! Where there are no sockets between processes.

use std::io;

use crate::calls::Participant;
use crate::error::ImportError;
use crate::fmu::Fmu;

use super::Isolation;

/// Refuses.
pub(crate) fn participant(
    _: &Isolation,
    fmu: &Fmu,
    _: &str,
    _: bool,
) -> Result<Box<dyn Participant>, ImportError> {
    Err(ImportError::Process {
        path: fmu.path().to_owned(),
        source: io::ErrorKind::Unsupported.into(),
    })
}

/// Refuses.
///
/// # Errors
///
/// Always: it is there for Unix only.
pub fn serve() -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}
