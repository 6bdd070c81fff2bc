//! `[[clump]]`, checked, and what scenes with clumps do not have.

use nalgebra::Matrix3;

use super::decode::Entry;
use super::document::Document;
use super::driven::principal;
use super::file;
use crate::Vec3;
use crate::scene::Scene;
use crate::scene::clump::ClumpShape;

/// Fewest and most members.
const MEMBERS: [usize; 2] = [2, 20];
/// Smallest edge of a periodic cell over the largest diameter of a clump [-].
const ROOM: f64 = 1.001;

/// A clump as given: its shape for every density.
pub(super) struct Template {
    centres: Vec<Vec3>,
    radii: Vec<f64>,
    mass: Option<f64>,
    inertia: Option<Matrix3<f64>>,
}

impl Template {
    /// Checks one; `None` if it was refused.
    pub(super) fn new(document: &mut Document<'_>, element: &Entry<file::Clump>) -> Option<Self> {
        let (path, given) = (&element.path, element.value.as_ref()?);
        let [fewest, most] = MEMBERS;
        let key = format!("{path}.members");
        let expected = "2 to 20 of them: a single sphere needs no clump";
        let mut good = document.demand(
            (fewest..=most).contains(&given.members.len()),
            key.as_str(),
            format!("{} members", given.members.len()),
            expected,
        );
        for (k, member) in given.members.iter().enumerate() {
            let key = format!("{key}[{k}].radius");
            good &= document.positive(key, member.radius, "a radius > 0 [m]");
        }
        for (k, member) in given.members.iter().enumerate() {
            let place = |member: &file::Member| Vec3::from(member.position);
            let holds = |other: &&file::Member| {
                (place(other) - place(member)).norm() + member.radius <= other.radius
            };
            let others = given.members.iter().enumerate().filter(|(j, _)| *j != k);
            if good && others.map(|(_, other)| other).any(|other| holds(&other)) {
                let message = "lies inside another member of its clump, where nothing touches it";
                document.error(format!("{key}[{k}]"), message, "remove it");
                good = false;
            }
        }
        good &= document.positive((path, "mass"), given.mass, "a mass > 0 [kg]");
        let inertia = match &given.inertia {
            None => None,
            Some(rows) => {
                let (moments, axes) = principal(document, &format!("{path}.inertia"), rows)?;
                let axes = axes.to_rotation_matrix();
                Some(axes * Matrix3::from_diagonal(&moments) * axes.inverse())
            }
        };
        good.then(|| Self {
            centres: given.members.iter().map(|m| m.position.into()).collect(),
            radii: given.members.iter().map(|m| m.radius).collect(),
            mass: given.mass,
            inertia,
        })
    }

    /// Its shape where its material has this density \[kg/m^3\]; an error at `path` if there is none.
    pub(super) fn shape(
        &self,
        document: &mut Document<'_>,
        path: &str,
        density: f64,
    ) -> Option<ClumpShape> {
        let (centres, radii) = (&self.centres, &self.radii);
        let shape = ClumpShape::new(centres, radii, density, self.mass, self.inertia);
        let shape = shape.map(|(shape, _)| shape);
        let usable = |shape: &ClumpShape| {
            shape.mass.is_normal() && shape.moments.iter().all(|m| m.is_normal() && *m > 0.0)
        };
        match shape.filter(usable) {
            Some(shape) => Some(shape),
            None => {
                let message = format!(
                    "its members and a density of {density} kg/m^3 give no usable mass and inertia"
                );
                document.reject(path, message, "lengths are in metres, densities in kg/m^3")
            }
        }
    }
}

/// Refuses what has no meaning with clumps, or is not there yet. Returns whether they fit into the cell.
pub(super) fn judge(document: &mut Document<'_>, scene: &Scene) -> bool {
    if scene.clumps.is_empty() {
        return true;
    }
    if scene.settings.rotating_frame.is_some() {
        let message = "found a rotating frame in a scene with clumps, on which its inertial forces do not act";
        let help = "give the scene as seen from the world, with boundaries that turn";
        document.error("simulation.rotating_frame", message, help);
    }
    let reaches = scene.clumps.iter().map(|clump| clump.shape.reach());
    let room = 2.0 * ROOM * reaches.fold(0.0, f64::max);
    let mut fit = true;
    for (axis, name) in ["x", "y", "z"].iter().enumerate() {
        if let Some([low, high]) = scene.cell.faces(axis) {
            let found = format!("an edge of {} m", high - low);
            let expected = format!(
                "at least {room} m, {ROOM} diameters of the largest clump: none may meet its own copy"
            );
            fit &= document.demand(high - low >= room, format!("cell.{name}"), found, &expected);
        }
    }
    fit
}
