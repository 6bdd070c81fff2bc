//! What both files begin with.

use serde::de::DeserializeOwned;
use sphere_dda_model_description::Error;
use sphere_dda_model_description::xml::{self, Expected};

/// Version of the standard that is written.
pub(super) const SSP_VERSION: &str = "1.0";
/// The other one that is read: the same names in the same namespaces, and more types.
const NEWER: &str = "2.0";

pub(super) const SSD: &str = "http://ssp-standard.org/SSP1/SystemStructureDescription";
pub(super) const SSC: &str = "http://ssp-standard.org/SSP1/SystemStructureCommon";
pub(super) const SSV: &str = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";

/// Reads the document `root`.
///
/// # Errors
/// Every variant of [`Error`] that is about reading.
pub(super) fn read<T: DeserializeOwned>(text: &str, root: &'static str) -> Result<T, Error> {
    let read = |version| {
        let attribute = "version";
        xml::read_expected(
            text,
            Expected {
                root,
                attribute,
                version,
            },
        )
    };
    match read(SSP_VERSION) {
        Err(Error::Version { found, .. }) if found == NEWER => read(NEWER),
        Err(Error::Version {
            attribute, found, ..
        }) => Err(Error::Version {
            attribute,
            found,
            expected: "1.0` or `2.0",
        }),
        other => other,
    }
}
