//! What every FMU of FMI 2.0 or 3.0 has, whatever it computes; knows no model.
//!
//! | module       | holds                                                                |
//! |--------------|----------------------------------------------------------------------|
//! | [`abi2`]     | the types of the C interface of FMI 2.0, for both sides of it        |
//! | [`abi3`]     | the types of the C interface of FMI 3.0                              |
//! | [`pointers`] | pointers from C as slices and texts, or a reason why not             |
//! | [`handle`]   | values behind the pointers that an importer hands back              |
//! | [`log`]      | log lines, their categories, and the way to the importer's logger    |
//! | [`guid`]     | fingerprints in the form of a guid                                   |
//! | `archive`    | files to an `.fmu`, with the same bytes every time; feature `archive` |
//! | [`panics`]   | what a caught panic says, and where it came from                     |
//! | [`platform`] | where the library of each platform lies in the archive               |

pub mod abi2;
pub mod abi3;
#[cfg(feature = "archive")]
pub mod archive;
pub mod checksum;
pub mod guid;
pub mod handle;
pub mod log;
pub mod panics;
pub mod platform;
pub mod pointers;
