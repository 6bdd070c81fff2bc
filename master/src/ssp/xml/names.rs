//! Version, media type and namespaces.

/// Version of the standard that is written and read.
pub(super) const SSP_VERSION: &str = "1.0";

/// Media type of an FMU.
pub(super) const FMU: &str = "application/x-fmu-sharedlibrary";

pub(super) const SSD: &str = "http://ssp-standard.org/SSP1/SystemStructureDescription";
pub(super) const SSC: &str = "http://ssp-standard.org/SSP1/SystemStructureCommon";
pub(super) const SSV: &str = "http://ssp-standard.org/SSP1/SystemStructureParameterValues";
