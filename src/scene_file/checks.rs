//! Checks that several parts of a scene file share.

use super::document::Document;
use super::file;
use crate::Vec3;
use crate::geometry::GeometryError;

/// The unit vector along a direction of any length.
pub(super) fn direction(
    document: &mut Document<'_>,
    path: &str,
    given: file::Vector,
) -> Option<Vec3> {
    let unit = Vec3::from(given).try_normalize(0.0);
    document.demand(
        unit.is_some(),
        path,
        format!("{:?}", given.0),
        "a direction of length > 0",
    );
    unit
}

pub(super) fn increasing(document: &mut Document<'_>, path: &str, time: &[f64]) -> bool {
    if time.is_empty() {
        return document.demand(false, path, "no times", "at least one [s]");
    }
    match time.windows(2).find(|pair| pair[0] >= pair[1]) {
        Some(pair) => document.demand(
            false,
            path,
            format!("{} after {}", pair[1], pair[0]),
            "strictly increasing times [s]",
        ),
        None => true,
    }
}

/// Reports a refused geometry at its key.
pub(super) fn accept<T>(
    document: &mut Document<'_>,
    path: &str,
    built: Result<T, GeometryError>,
) -> Option<T> {
    match built {
        Ok(built) => Some(built),
        Err(error) => document.reject(path, error.to_string(), ""),
    }
}
