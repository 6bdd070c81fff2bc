//! Lengths that look like millimetres.

use crate::Vec3;
use crate::geometry::{Facets, Shape};
use crate::scene::{Boundary, Scene};
use crate::scene_file::diagnostic::Advice;
use crate::scene_file::summary::{metres, spheres_extent};
use crate::spatial::extent::joined;

/// A mesh file this many times larger than what the spheres occupy is taken for one in mm.
const LARGE_MESH: f64 = 100.0;
/// The same for boundaries that were typed: a wide floor under few spheres is common.
const LARGE_FACES: f64 = 1e4;
/// Spheres of this radius \[m\] and more, so many of them and no terrain, are taken for spheres in mm.
const LARGE_RADIUS: f64 = 1.0;
const MANY_SPHERES: usize = 500;

pub(super) fn advise(scene: &Scene) -> Vec<Advice> {
    let Some(occupied) = occupied(scene) else {
        return Vec::new();
    };
    let mut advice: Vec<Advice> = scene
        .boundaries
        .iter()
        .enumerate()
        .filter_map(|(index, boundary)| large(scene, index, boundary, occupied))
        .collect();
    advice.extend(all_in_millimetres(scene, occupied));
    advice
}

/// The box around what spheres occupy at t = 0 and what sources feed \[m\].
fn occupied(scene: &Scene) -> Option<(Vec3, Vec3)> {
    let fed = scene.sources.iter().filter_map(|s| s.region.bounds());
    spheres_extent(scene).into_iter().chain(fed).reduce(joined)
}

/// The longest side of a box \[m\].
fn longest((low, high): (Vec3, Vec3)) -> f64 {
    (high - low).max()
}

/// A boundary that is far larger than what the spheres occupy, or a mesh far smaller.
fn large(
    scene: &Scene,
    index: usize,
    boundary: &Boundary,
    occupied: (Vec3, Vec3),
) -> Option<Advice> {
    let size = longest(boundary.geometry.finite_bounds()?);
    let around = longest(occupied);
    let smallest = scene.particles.smallest_radius();
    let mesh = mesh_file(boundary);
    let path = format!("boundary[{index}]");
    let found = format!(
        "boundary `{}` is {} m long, the spheres occupy {} m and have radii from {} m",
        boundary.name,
        metres(size),
        metres(around),
        metres(smallest)
    );
    match mesh {
        Some(name) if size > LARGE_MESH * around => {
            let help = format!("if `{name}` is in mm, add `unit = \"mm\"` next to `file`");
            Some(Advice::warning(path, found, help))
        }
        Some(name) if size < smallest => {
            let help =
                format!("lengths are in m: add `unit` or `scale` next to `file = \"{name}\"`");
            Some(Advice::warning(path, found, help))
        }
        None if size > LARGE_FACES * around && !has_terrain(boundary) => {
            let help = "lengths are in m: if these are in mm, divide them by 1000";
            Some(Advice::warning(path, found, help))
        }
        _ => None,
    }
}

fn facets(boundary: &Boundary) -> impl Iterator<Item = &Facets> {
    let shapes = boundary.geometry.shapes().iter();
    shapes.filter_map(|shape| match shape {
        Shape::Facets(facets) => Some(facets),
        Shape::HalfSpace(_) | Shape::Revolution(_) => None,
    })
}

/// Name of the first STL file.
fn mesh_file(boundary: &Boundary) -> Option<&str> {
    let mut names = facets(boundary).map(|facets| &*facets.name);
    names.find(|name| name.to_lowercase().ends_with(".stl"))
}

/// Whether a face is a height field: the one kind of computed facets with the name of a file.
fn has_terrain(boundary: &Boundary) -> bool {
    facets(boundary).any(|f| f.computed && f.name.contains('.'))
}

fn all_in_millimetres(scene: &Scene, occupied: (Vec3, Vec3)) -> Option<Advice> {
    let mut radii = scene.particles.radius.clone();
    radii.sort_unstable_by(f64::total_cmp);
    let median = radii[radii.len() / 2];
    let large = median >= LARGE_RADIUS && radii.len() >= MANY_SPHERES;
    let terrain = scene.boundaries.iter().any(has_terrain);
    (large && !terrain).then(|| {
        Advice::warning(
            "spheres",
            format!(
                "{} spheres with a median radius of {} m occupy {} m: found metres as large as millimetres would be",
                radii.len(),
                metres(median),
                metres(longest(occupied))
            ),
            "lengths are in m: if the scene is in mm, divide all its lengths by 1000",
        )
    })
}
