//! `[[clump]]`, checked, and what scenes with clumps do not have.

use std::ops::RangeInclusive;

use nalgebra::{Matrix3, UnitQuaternion};

use super::bodies::{stl_file, tell_dropped, unit_of_length};
use super::cell::clear_of_copies;
use super::checks::{accept, has_mass};
use super::decode::Entry;
use super::document::Document;
use super::driven::principal;
use super::file;
use super::fitted::Fitted;
use super::summary;
use crate::Vec3;
use crate::geometry::{BallFit, Solid, Triangulation};
use crate::scene::Scene;
use crate::scene::clump::ClumpShape;

/// Fewest and most members.
const MEMBERS: RangeInclusive<usize> = 2..=20;

/// Least volume of a solid over that of its box [-].
const LEAST_VOLUME: f64 = 1e-9;

/// A clump as given: its shape for every density.
pub(super) struct Template {
    centres: Vec<Vec3>,
    radii: Vec<f64>,
    mass: Option<f64>,
    inertia: Option<Matrix3<f64>>,
    /// The mesh that its members stand for, and its surface if frames are to show it.
    pub(super) fitted: Option<Fitted>,
    surface: Option<Triangulation>,
}

impl Template {
    /// Checks one; `None` if it was refused.
    pub(super) fn new(document: &mut Document<'_>, element: &Entry<file::Clump>) -> Option<Self> {
        let (path, given) = (&element.path, element.value.as_ref()?);
        let mut good = document.positive((path, "mass"), given.mass, "a mass > 0 [kg]");
        let inertia = match &given.inertia {
            None => None,
            Some(rows) => {
                let (moments, axes) = principal(document, &format!("{path}.inertia"), rows)?;
                let axes = axes.to_rotation_matrix();
                Some(axes * Matrix3::from_diagonal(&moments) * axes.inverse())
            }
        };
        let mut surface = None;
        let (centres, radii, fitted) = match (&given.members, &given.stl) {
            (Some(members), None) => {
                good &= judge_members(document, &format!("{path}.members"), members);
                for (key, given) in [
                    ("spheres", given.spheres.is_some()),
                    ("unit", given.unit.is_some()),
                    ("surface", given.surface.is_some()),
                ] {
                    if given {
                        let message =
                            format!("found `{key}` beside `members`, which it is not for");
                        document.error((path, key), message, "it goes with `stl`: remove it");
                        good = false;
                    }
                }
                let centres = members.iter().map(|m| m.position.into()).collect();
                (centres, members.iter().map(|m| m.radius).collect(), None)
            }
            (None, Some(file)) => {
                let (fitted, solid) = fit(document, path, given, file)?;
                surface = (given.surface == Some(true)).then(|| solid.surface());
                let balls = fitted.balls.clone();
                (balls.centres, balls.radii, Some(fitted))
            }
            (Some(_), Some(_)) => {
                let message = "found both `stl` and `members`, expected one of them";
                return document.reject((path, "stl"), message, "remove the one or the other");
            }
            (None, None) => {
                let message = "found neither `members` nor `stl`, expected one of them";
                let help =
                    "give 2 to 20 spheres as `members`, or an STL file and a number of `spheres`";
                return document.reject(path, message, help);
            }
        };
        good.then_some(Self {
            centres,
            radii,
            mass: given.mass,
            inertia,
            fitted,
            surface,
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
        let given = (self.mass, self.inertia);
        let shape = match &self.fitted {
            None => ClumpShape::new(centres, radii, density, given.0, given.1),
            Some(fitted) => {
                let moments = (&fitted.mesh, &fitted.balls.union);
                ClumpShape::of_solid(centres, radii, moments, density, given.0, given.1)
            }
        };
        let shape = shape.map(|(shape, centre)| match &self.surface {
            Some(surface) => shape.shown_as(surface, centre),
            None => shape,
        });
        let Some(shape) = shape else {
            let message = format!(
                "the centre of mass of its clump does not lie between the centres of its {} spheres, which cannot carry its mass",
                centres.len()
            );
            let help = match self.fitted {
                Some(_) => {
                    "try another number of `spheres`; a mesh with damaged facets gets bad ones: clean it"
                }
                None => "move or remove members: none may lie inside another",
            };
            return document.reject(path, message, help);
        };
        let what = format!("its members and a density of {density} kg/m^3");
        let found = (shape.mass, shape.moments.as_slice());
        has_mass(document, path, &what, found).then_some(shape)
    }
}

/// Checks the members at `key`.
fn judge_members(document: &mut Document<'_>, key: &str, members: &[file::Member]) -> bool {
    let mut good = document.demand(
        MEMBERS.contains(&members.len()),
        key,
        format!("{} members", members.len()),
        "2 to 20 of them: a single sphere needs no clump",
    );
    for (k, member) in members.iter().enumerate() {
        let key = format!("{key}[{k}].radius");
        good &= document.positive(key, member.radius, "a radius > 0 [m]");
    }
    for (k, member) in members.iter().enumerate() {
        let place = |member: &file::Member| Vec3::from(member.position);
        let holds = |other: &&file::Member| {
            (place(other) - place(member)).norm() + member.radius <= other.radius
        };
        let others = members.iter().enumerate().filter(|(j, _)| *j != k);
        if good && others.map(|(_, other)| other).any(|other| holds(&other)) {
            let message = "lies inside another member of its clump, where nothing touches it";
            document.error(format!("{key}[{k}]"), message, "remove it");
            good = false;
        }
    }
    good
}

/// Fits the spheres of the clump at `path` to the mesh in `file`. Returns the mesh as well.
fn fit(
    document: &mut Document<'_>,
    path: &str,
    given: &file::Clump,
    file: &str,
) -> Option<(Fitted, Solid)> {
    let key = format!("{path}.stl");
    let metres = unit_of_length(document, path, given.unit.as_deref());
    let facets = stl_file(document, &key, file);
    let expected = "2 to 20 spheres that stand for the mesh";
    let count = match given.spheres {
        None => document.reject(
            path,
            "missing key `spheres`",
            format!("add `spheres = 10`: {expected}"),
        ),
        Some(count) => {
            let few = usize::try_from(count).ok().filter(|n| MEMBERS.contains(n));
            document.demand(few.is_some(), (path, "spheres"), count, expected);
            few
        }
    };
    let (facets, metres, count) = (facets?, metres?, count?);
    let placed = facets.placed(metres, UnitQuaternion::identity(), Vec3::zeros());
    let solid = accept(document, &key, Solid::new(placed))?;
    tell_dropped(document, &key, Some(solid.repair()));
    let (low, high) = solid.bounds();
    let size = high - low;
    // Of parts that cross one counts as a cavity of the other: next to nothing may be left.
    let is_full = solid.volume() > LEAST_VOLUME * size.product();
    let balls = is_full.then(|| BallFit::new(&solid, count)).flatten();
    let balls = balls.filter(|fit| fit.radii.len() >= *MEMBERS.start());
    let Some(balls) = balls else {
        let [x, y, z] = <[f64; 3]>::from(size).map(summary::metres);
        let message = format!(
            "no two spheres lie inside `{file}`, of {:.1e} m^3 in a box of {x} x {y} x {z} m: found a solid that is thin, or whose \
             surface crosses itself",
            solid.volume()
        );
        let help = "of a thin one give `members`; of one that crosses itself join the parts into one surface in a mesh editor";
        return document.reject(key, message, help);
    };
    let fitted = Fitted {
        clump: given.name.clone(),
        file: file.to_owned(),
        mesh: *solid.moments(),
        balls,
    };
    Some((fitted, solid))
}

/// Refuses clumps that meet their copies in a periodic cell. Returns whether they fit into it.
pub(super) fn judge(document: &mut Document<'_>, scene: &Scene) -> bool {
    if scene.clumps.is_empty() {
        return true;
    }
    let reaches = scene.clumps.iter().map(|clump| clump.shape.reach());
    let largest = 2.0 * reaches.fold(0.0, f64::max);
    let clear =
        [0, 1, 2].map(|axis| clear_of_copies(document, &scene.cell, axis, (largest, "clump")));
    clear.iter().all(|clear| *clear)
}
