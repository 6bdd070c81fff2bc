//! Two FMUs.
