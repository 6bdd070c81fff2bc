//! Contacts that are bonded at t = 0: pairs with `bond` whose surfaces touch or are no farther apart than its `reach`.

use crate::detection::periodic::periodic_pairs;
use crate::parallel::Pool;
use crate::scene::{Boundary, Scene};

/// What may be bonded at t = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StartBond {
    /// The two materials.
    pub(super) materials: [u16; 2],
    /// Whether it is one of two spheres; else with a boundary.
    pub(super) of_spheres: bool,
    /// Gap \[m\].
    pub(super) gap: f64,
    /// Whether it is bonded; else it is too far apart.
    pub(super) joined: bool,
}

/// All contacts of pairs with `bond` at t = 0 that are bonded, and those apart by no more than the smaller radius that are not.
pub(super) fn at_start(scene: &Scene) -> Vec<StartBond> {
    let reaches = scene
        .pairs
        .all()
        .filter_map(|(a, b)| scene.pairs.get(a, b).bond);
    let Some(reach) = reaches.map(|bond| bond.reach).reduce(f64::max) else {
        return Vec::new();
    };
    let (particles, initial) = (&scene.particles, &scene.initial);
    let settings = &scene.settings;
    // As steps judge what touches, `Prediction::hold`.
    let closed = settings.closed();
    let mut found = Vec::new();
    let mut judge = |(materials, of_spheres): ([u16; 2], bool), gap: f64, radius: f64| {
        let Some(bond) = scene.pairs.get(materials[0], materials[1]).bond else {
            return;
        };
        let joined = bond.joins(gap, closed * radius);
        if joined || gap <= radius {
            found.push(StartBond {
                materials,
                of_spheres,
                gap,
                joined,
            });
        }
    };
    let radius = &particles.radius;
    let size: Vec<f64> = radius.iter().map(|r| r + 0.5 * r.max(reach)).collect();
    for (i, j, image) in periodic_pairs(
        &scene.cell,
        &initial.position,
        &initial.present,
        &size,
        &Pool::default(),
    ) {
        if particles.are_one(i, j) {
            continue;
        }
        let [i, j] = [i, j].map(|i| i as usize);
        let arm = initial.position[i] - initial.position[j] - scene.cell.shift(image);
        let materials = [i, j].map(|i| particles.material[i]);
        judge(
            (materials, true),
            arm.norm() - radius[i] - radius[j],
            radius[i].min(radius[j]),
        );
    }
    let start = |boundary: &Boundary| boundary.motion.pose_at(0.0);
    let mut points = Vec::new();
    for boundary in &scene.boundaries {
        let pose = start(boundary);
        for i in (0..radius.len()).filter(|i| initial.present[*i]) {
            let materials = [particles.material[i], boundary.material];
            if scene.pairs.get(materials[0], materials[1]).bond.is_none() {
                continue;
            }
            points.clear();
            let sphere = (initial.position[i], radius[i]);
            boundary.closest_points(
                (&scene.cell, &pose),
                sphere,
                radius[i].max(reach),
                &mut points,
            );
            for point in &points {
                judge((materials, false), point.gap, radius[i]);
            }
        }
    }
    found
}
