//! What both files begin with.

use serde::de::DeserializeOwned;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::xml::{self, Expected};

/// Version of the standard that is written and read.
pub(super) const SSP_VERSION: &str = "1.0";

pub(super) const SSD: &str = "http://ssp-standard.org/SSP1/SystemStructureDescription";
pub(super) const SSC: &str = "http://ssp-standard.org/SSP1/SystemStructureCommon";
pub(super) const SSV: &str = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";

/// Reads the document `root`.
///
/// # Errors
/// Every variant of [`Error`] that is about reading.
pub(super) fn read<T: DeserializeOwned>(text: &str, root: &'static str) -> Result<T, Error> {
    let expected = Expected {
        root,
        attribute: "version",
        version: SSP_VERSION,
    };
    xml::read_expected(text, expected)
}
