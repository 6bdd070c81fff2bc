//! Spheres that start at a wrong place: below a terrain, inside a closed boundary, outside of everything.

use std::ops::Range;

use crate::Vec3;
use crate::geometry::region::Region;
use crate::geometry::{Facets, Shape, Solid};
use crate::scene::Scene;
use crate::scene::gravity::GravityMotion;
use crate::scene::line_of_sight::Wall;
use crate::scene_file::decode::SceneFile;
use crate::scene_file::diagnostic::Advice;
use crate::scene_file::file;
use crate::spatial::extent::{corners, passed};

pub(super) fn advise(
    scene: &Scene,
    typed: &SceneFile,
    ranges: &[Option<Range<usize>>],
) -> Vec<Advice> {
    let boundaries: Vec<Wall<'_>> = scene
        .boundaries
        .iter()
        .map(|boundary| Wall::new(boundary, boundary.motion.pose_at(0.0)))
        .collect();
    let present: Vec<usize> = (0..scene.particles.len())
        .filter(|&i| scene.initial.present[i])
        .collect();
    let told = |i: usize| call(scene, typed, ranges, i);
    let mut advice = Vec::new();
    let mut below = vec![false; scene.particles.len()];
    for (index, wall) in boundaries.iter().enumerate() {
        let found: Vec<usize> = present
            .iter()
            .copied()
            .filter(|&i| is_terrain(typed, index) && is_below(scene, wall, i))
            .collect();
        found.iter().for_each(|&i| below[i] = true);
        advice.extend(found.first().map(|&first| {
            let (path, example) = told(first);
            Advice::warning(
                path,
                format!(
                    "{} below the terrain of boundary `{}`, for example {example}",
                    start(found.len(), present.len()),
                    wall.boundary.name
                ),
                "raise the region or the positions above the highest ground",
            )
        }));
    }
    advice.extend(boundaries.iter().filter_map(|wall| {
        let inside = enclosed(scene, wall, &present)?;
        let (path, example) = told(*inside.first()?);
        Some(Advice::warning(
            path,
            format!(
                "{} inside the closed boundary `{}` and cannot leave it, for example {example}; the others are outside",
                start(inside.len(), present.len()),
                wall.boundary.name
            ),
            "move them out of the boundary, unless they belong there",
        ))
    }));
    let lost: Vec<usize> = match downwards(scene) {
        Some(down) => {
            let around = Surroundings::new(scene, &boundaries, down);
            let lost = |&i: &usize| !below[i] && is_free(scene, i, down) && around.loses(i);
            present.iter().copied().filter(lost).collect()
        }
        None => Vec::new(),
    };
    advice.extend(lost.first().map(|&first| {
        let (path, example) = told(first);
        Advice::warning(
            path,
            format!(
                "{} outside all boundaries with nothing below, for example {example}: they fall out of the scene",
                start(lost.len(), present.len())
            ),
            "move them over a boundary, or add a floor, or a `[[sink]]` that removes them",
        )
    }));
    advice
}

/// `3 of 10 spheres start`.
fn start(n: usize, all: usize) -> String {
    match (n, all) {
        (1, 1) => "the sphere starts".to_owned(),
        (1, _) => format!("1 of {all} spheres starts"),
        _ => format!("{n} of {all} spheres start"),
    }
}

/// Key path of the group of a sphere, and the sphere with its place.
fn call(
    scene: &Scene,
    typed: &SceneFile,
    ranges: &[Option<Range<usize>>],
    i: usize,
) -> (String, String) {
    let groups = ranges.iter().zip(&typed.spheres);
    let group = groups.filter_map(|(range, group)| Some((range.as_ref()?, group)));
    let x = scene.initial.position[i].map(|x| format!("{:.4}", x).parse().unwrap_or(x));
    let place = format!("at ({}, {}, {}) m", x.x, x.y, x.z);
    match group.into_iter().find(|(range, _)| range.contains(&i)) {
        Some((range, group)) => {
            let name = match &group.name {
                Some(name) => format!("`{name}[{}]`", i - range.start),
                None => format!("sphere {i}"),
            };
            (group.path.clone(), format!("{name} {place}"))
        }
        None => ("spheres".to_owned(), format!("sphere {i} {place}")),
    }
}

/// Whether a boundary has a height field.
fn is_terrain(typed: &SceneFile, index: usize) -> bool {
    let value = typed.boundaries[index].value.as_ref();
    value.is_some_and(|b| b.faces.iter().any(|f| matches!(f, file::Face::Terrain(_))))
}

/// Whether the ground is above the centre of a sphere and not below it.
fn is_below(scene: &Scene, wall: &Wall<'_>, i: usize) -> bool {
    let x = wall.local(scene, scene.initial.position[i]);
    wall.rays.is_hit(x, Vec3::z()) && !wall.rays.is_hit(x, -Vec3::z())
}

/// The spheres inside a boundary that is one closed mesh, if they are fewer than those outside: a container holds most.
fn enclosed(scene: &Scene, wall: &Wall<'_>, present: &[usize]) -> Option<Vec<usize>> {
    let mut all = Facets::mesh("", Vec::new(), Vec::new());
    for shape in wall.boundary.geometry.shapes() {
        let Shape::Facets(facets) = shape else {
            return None;
        };
        let first = all.vertices.len() as u32;
        all.vertices.extend(&facets.vertices);
        let shifted = facets.triangles.iter().map(|t| t.map(|k| k + first));
        all.triangles.extend(shifted);
        all.rounding = all.rounding.max(facets.rounding);
    }
    let solid = Solid::new(all).ok()?;
    let inside = present.iter().copied().filter(|&i| {
        let x = scene.initial.position[i];
        solid.contains(wall.local(scene, x))
    });
    let inside: Vec<usize> = inside.collect();
    (2 * inside.len() < present.len()).then_some(inside)
}

/// The direction in which everything falls for good: that of a gravity that stays, across the periodic axes.
fn downwards(scene: &Scene) -> Option<Vec3> {
    let settings = &scene.settings;
    let stays =
        settings.gravity_motion == GravityMotion::Fixed && settings.rotating_frame.is_none();
    let g = settings.gravity;
    let periodic = (0..3).any(|axis| g[axis] != 0.0 && scene.cell.faces(axis).is_some());
    g.try_normalize(0.0).filter(|_| stays && !periodic)
}

/// Whether nothing holds a sphere against gravity.
fn is_free(scene: &Scene, i: usize, down: Vec3) -> bool {
    let locked = scene.particles.locks[i].translation;
    let held = (0..3).any(|axis| locked[axis] && down[axis] != 0.0);
    !held && scene.springs.iter().all(|spring| spring.sphere != i)
}

/// All boundaries seen along gravity.
struct Surroundings<'a> {
    scene: &'a Scene,
    boundaries: &'a [Wall<'a>],
    down: Vec3,
    /// Two unit vectors across gravity.
    across: [Vec3; 2],
    /// For each bounded boundary the least and the greatest place along either \[m\].
    shadows: Vec<[[f64; 2]; 2]>,
}

impl<'a> Surroundings<'a> {
    fn new(scene: &'a Scene, boundaries: &'a [Wall<'a>], down: Vec3) -> Self {
        let first = down.cross(&Vec3::ith(down.iamin(), 1.0)).normalize();
        let across = [first, down.cross(&first)];
        let shadow = |wall: &Wall<'_>| {
            let bounds = wall.boundary.geometry.finite_bounds()?;
            let corners = corners(bounds).map(|x| wall.boundary.from_frame(&wall.pose, x));
            Some(across.map(|e| {
                let places = || corners.iter().map(|c| c.dot(&e));
                [
                    places().fold(f64::INFINITY, f64::min),
                    places().fold(f64::NEG_INFINITY, f64::max),
                ]
            }))
        };
        Self {
            scene,
            boundaries,
            down,
            across,
            shadows: boundaries.iter().filter_map(shadow).collect(),
        }
    }

    /// Whether a sphere falls for ever: it starts outside the shadow of all bounded boundaries, and no boundary or sink is below. One over
    /// the mouth of a hopper is meant to fall.
    fn loses(&self, i: usize) -> bool {
        let x = self.scene.initial.position[i];
        let beside = self.shadows.iter().all(|shadow| {
            let apart = |([low, high], e): (&[f64; 2], &Vec3)| {
                let place = x.dot(e);
                place < *low || place > *high
            };
            shadow.iter().zip(&self.across).any(apart)
        });
        !self.boundaries.is_empty()
            && self.scene.cell.is_open()
            && beside
            && !self
                .boundaries
                .iter()
                .any(|w| w.meets(self.scene, x, self.down))
            && !self.scene.sinks.iter().any(|s| self.catches(&s.region, x))
    }

    /// Whether a fall from `x` \[m\] passes a region, or the box around it.
    fn catches(&self, region: &Region, x: Vec3) -> bool {
        match (region, region.bounds()) {
            (Region::Beyond { point, normal }, _) => {
                self.down.dot(normal) > 0.0 || (x - point).dot(normal) >= 0.0
            }
            // Whatever falls for ever leaves a box.
            (Region::Outside { .. }, _) => true,
            (_, Some(bounds)) => passed(bounds, x, self.down),
            (_, None) => false,
        }
    }
}
