//! Systems of FMUs as SSP 1.0 archives, read and written.

mod open;
mod package;
mod xml;

pub use open::{Ssp, SspError};
pub use package::PackageError;
