//! Systems of FMUs as SSP archives: 1.0 and 2.0 read, 1.0 written.

mod open;
mod package;
mod xml;

pub use open::{Ssp, SspError};
pub use package::PackageError;
