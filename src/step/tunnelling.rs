//! Bodies that pass through each other within a step: found along their paths, not at the ends.
//!
//! Contacts are linear in the step, with the normals of its start. That is right for motions of a fraction of a radius.
//! Where two bodies move farther against each other, and only there, their straight paths are checked after the solve:
//!
//! ```text
//! struck   a contact that was not foreseen is found closed: its normal at the end may be any
//! passed   the solution's path goes deeper into the other body than its ends do
//! ghost    a contact carries load that the path without contacts would not have touched
//! ```
//! Each fails the step, which is then cut until motions are small or the paths are free.

use std::mem::take;

use super::Tunnelling;
use super::assemble::Assembly;
use super::solution::Solution;
use super::workspace::Workspace;
use crate::Vec3;
use crate::contact::{ContactId, Partner};
use crate::detection::configuration::{Candidate, Configuration};
use crate::detection::detection_distance::DetectionDistance;
use crate::detection::near_boundaries::NearBoundary;
use crate::detection::sweep::{least_distance, meets};
use crate::spatial::Pose;
use crate::spatial::cell::{HERE, Image};

/// Relative motion over the smaller radius up to which the gaps at the ends of a step suffice \[-\].
pub(super) const SMALL_MOTION: f64 = 0.5;
/// How deep a path may go into another body before it counts as passing, over the smaller radius \[-\].
const DEPTH: f64 = 0.1;
/// Rounding of motions over a radius, generously.
const ROUNDING: f64 = 1e-9;

/// The first pair, in canonical order, that passes through another or is held apart without need.
pub(super) fn passed(
    assembly: &Assembly,
    solution: &Solution,
    ends: &[Pose],
    workspace: &mut Workspace,
) -> Option<Tunnelling> {
    let (prediction, start) = (assembly.prediction, &assembly.start());
    let step = prediction.step;
    let spheres = prediction.kinematics.len();
    let free = &assembly.problem.free;
    let velocities = [&solution.velocity[..spheres], &free[..spheres]];
    let both = |i: usize| velocities.map(|of| of[i].linear);
    let mut reach = take(&mut workspace.reach);
    reach.resize(spheres, DetectionDistance::default());
    DetectionDistance::of(both, step, |_| 0.0, (&mut reach, &assembly.prediction.pool));
    let smallest = start.particles.smallest_radius();
    let freely = &prediction.poses[1];
    let carried =
        (0..ends.len()).flat_map(|b| [&ends[b], &freely[b]].map(|to| start.carried(b, to)));
    let carried = carried.fold(0.0, f64::max);
    let largest = DetectionDistance::largest(&reach);
    let pairs = 2.0 * largest.pairs.min(largest.boundaries);
    if let Some(edge) = prediction.scene.cell.smallest_edge()
        && pairs > 2.0 * edge
    {
        // All copies on its way are more than can be looked at.
        let fastest = (0..spheres).max_by(|&a, &b| reach[a].pairs.total_cmp(&reach[b].pairs));
        let sphere = fastest.unwrap_or(0) as u32;
        let contact = ContactId {
            sphere,
            partner: Partner::sphere((sphere + 1) % spheres as u32),
        };
        workspace.reach = reach;
        return Some(Tunnelling {
            contact,
            motion: pairs / smallest,
        });
    }
    let small = pairs.max(largest.boundaries + carried) <= SMALL_MOTION * smallest;
    if small {
        workspace.reach = reach;
        return None;
    }
    workspace.neighbors.ensure(start, &reach, carried);
    let mut unhindered = Vec::new();
    prediction.end_positions(free, &mut unhindered);
    let ends = [(&solution.position, ends), (&unhindered, &freely[..])];
    let [end, free] = ends.map(|(position, poses)| Configuration {
        position,
        poses,
        ..*start
    });
    let radius = &start.particles.radius;
    let apart = |i: u32, index: u32, image: Image| {
        let paths = [&end, &free].map(|to| [start, to].map(|at| at.between(i, index, image)));
        (i, Partner::Sphere { index, image }, paths)
    };
    let list = &workspace.neighbors;
    // Most pairs hardly move against each other, most spheres hardly at all.
    let far = |&&(i, j): &&(u32, u32)| {
        let [a, b] = [i, j].map(|k| k as usize);
        let limit = SMALL_MOTION * radius[a].min(radius[b]) * (1.0 - ROUNDING);
        if reach[a].pairs + reach[b].pairs < limit {
            return false;
        }
        let motion = velocities.map(|v| (v[a].linear - v[b].linear).norm_squared() * step * step);
        motion[0].max(motion[1]) > limit * limit
    };
    let may_go_far = |near: &&NearBoundary| {
        let i = near.sphere as usize;
        let limit = SMALL_MOTION * radius[i] * (1.0 - ROUNDING);
        reach[i].boundaries + carried >= limit
    };
    let here = list.pairs.iter().filter(far);
    let here = here.map(|&(i, j)| apart(i, j, HERE));
    let images = list.images.iter().map(|&(i, j, image)| apart(i, j, image));
    let boundaries = list.boundaries.all().iter().filter(may_go_far);
    let boundaries = boundaries.map(|near| {
        let (i, boundary) = (near.sphere, near.boundary);
        let paths = [&end, &free].map(|to| start.path_in_frame(to, i, boundary));
        let feature = 0;
        (i, Partner::Boundary { boundary, feature }, paths)
    });
    let found =
        here.chain(images)
            .chain(boundaries)
            .find_map(|(sphere, partner, [path, free_path])| {
                let scale = start.scale(ContactId { sphere, partner });
                let motion = [path, free_path].map(|[a, b]| (b - a).norm() / scale);
                let far = motion.map(|m| m > SMALL_MOTION);
                let failed = (far[0] && through(start, sphere, partner, path, radius, scale))
                    || (far[1]
                        && carries(assembly, solution, sphere, partner)
                        && !met(start, sphere, partner, free_path, radius));
                let contact = ContactId { sphere, partner };
                failed.then_some(Tunnelling {
                    contact,
                    motion: motion[0].max(motion[1]),
                })
            });
    workspace.reach = reach;
    found
}

/// The first pair of `late` ones, which are no candidates, that has moved far.
pub(super) fn struck(
    assembly: &Assembly,
    end: &Configuration,
    late: &[Candidate],
) -> Option<Tunnelling> {
    let start = &assembly.start();
    // By whatever feature.
    let foreseen = |key: ContactId| {
        let mut contacts = assembly.contacts_between(key.sphere, key.partner);
        contacts.next().is_some()
    };
    late.iter().find_map(|found| {
        let contact = found.key;
        let [from, to] = match contact.partner {
            Partner::Sphere { index, image } => {
                [start, end].map(|at| at.between(contact.sphere, index, image))
            }
            Partner::Boundary { boundary, .. } => {
                start.path_in_frame(end, contact.sphere, boundary)
            }
        };
        let motion = (to - from).norm() / start.scale(contact);
        // Rolling on, a sphere finds the next feature of its boundary closed: that is no surprise.
        (motion > SMALL_MOTION && !foreseen(contact)).then_some(Tunnelling { contact, motion })
    })
}

/// Whether a contact of this sphere and partner, by whatever feature, is loaded.
fn carries(assembly: &Assembly, solution: &Solution, sphere: u32, partner: Partner) -> bool {
    let mut contacts = assembly.contacts_between(sphere, partner);
    contacts.any(|k| solution.loads(k))
}

/// Whether the path goes deeper into the partner than its ends.
fn through(
    start: &Configuration,
    sphere: u32,
    partner: Partner,
    [a, b]: [Vec3; 2],
    radius: &[f64],
    scale: f64,
) -> bool {
    let own = radius[sphere as usize];
    match partner {
        Partner::Sphere { index, .. } => {
            let touching = own + radius[index as usize];
            let ends = a.norm().min(b.norm()).min(touching);
            least_distance(a, b) < ends - DEPTH * scale
        }
        Partner::Boundary { boundary, .. } => {
            let geometry = &start.boundaries[usize::from(boundary)].geometry;
            meets(geometry, a, b, (1.0 - DEPTH) * own)
        }
    }
}

/// Whether the path touches the partner at all.
fn met(
    start: &Configuration,
    sphere: u32,
    partner: Partner,
    [a, b]: [Vec3; 2],
    radius: &[f64],
) -> bool {
    let own = radius[sphere as usize];
    match partner {
        Partner::Sphere { index, .. } => least_distance(a, b) <= own + radius[index as usize],
        Partner::Boundary { boundary, .. } => {
            let geometry = &start.boundaries[usize::from(boundary)].geometry;
            meets(geometry, a, b, own)
        }
    }
}
