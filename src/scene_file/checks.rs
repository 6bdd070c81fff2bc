//! Checks that several parts of a scene file share.

use super::document::Document;
use super::file;
use crate::Vec3;
use crate::geometry::GeometryError;
use crate::scene::clump::ClumpShape;
use crate::scene::materials::Material;
use crate::scene::particles::Particles;

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

/// Whether a mass \[kg\] and its moments of inertia \[kg m^2\] can be computed with; `what` gives them.
pub(super) fn has_mass(
    document: &mut Document<'_>,
    path: &str,
    what: &str,
    (mass, moments): (f64, &[f64]),
) -> bool {
    let good = |x: f64| x.is_normal() && x > 0.0;
    let usable = good(mass) && moments.iter().all(|moment| good(*moment));
    if !usable {
        let message = format!("{what} give no usable mass and inertia");
        document.error(path, message, "lengths are in metres, densities in kg/m^3");
    }
    usable
}

/// [`has_mass`] of the sphere added last, of a `material`.
pub(super) fn sphere_has_mass(
    document: &mut Document<'_>,
    path: &str,
    particles: &Particles,
    material: &Material,
) -> bool {
    let i = particles.len() - 1;
    let (radius, density) = (particles.radius[i], material.density);
    let what = format!("radius {radius:?} m and density {density} kg/m^3");
    has_mass(
        document,
        path,
        &what,
        (particles.mass[i], &[particles.inertia(i)]),
    )
}

/// [`has_mass`] of a scaled clump.
pub(super) fn clump_has_mass(document: &mut Document<'_>, path: &str, shape: &ClumpShape) -> bool {
    let radius = shape.equal_radius();
    let what = format!("clumps of the volume of a sphere of radius {radius:?} m");
    has_mass(
        document,
        path,
        &what,
        (shape.mass, shape.moments.as_slice()),
    )
}
