//! Spheres that boundaries whose motion is prescribed squeeze: rigid ones have no answer, and give way.
//!
//! One sphere between two boundaries is known by its normals, which oppose. A chain of spheres between them (two grains between the edge
//! of a blade and the wall, within the friction cones of all its contacts) is known by its load, which grows as long as the solver works.

use super::assemble::Assembly;
use super::solution::Solution;
use crate::Vec3;
use crate::contact::Partner;
use crate::state::Squeezed;

/// Largest cosine between normals of boundaries that squeeze.
const OPPOSITE: f64 = -0.5;
/// Share of the tolerated overlap by which boundaries that squeeze approach each other in the step.
const APPROACH: f64 = 0.1;
/// Overlaps in units of the tolerated one that only squeezing leaves, where boundaries have stopped.
const LEFT: f64 = 10.0;
/// Least impulse of a chain that is squeezed, over the momentum that a sphere at its ends has, gets from its weight, and would have
/// at the speed of the boundary.
const JAMMED: f64 = 100.0;
/// Share of the load at its end that all contacts of a chain carry.
const SHARE: f64 = 0.1;
/// Most contacts with boundaries from which chains are looked for, those with the largest loads.
const HEAVIEST: usize = 16;
/// Weights that press a squeezed sphere into a boundary by its radius: a thousand by a hundredth of it.
const WEIGHTS: f64 = 1e5;

/// A boundary that presses on a sphere.
struct Side {
    boundary: u16,
    /// Into the sphere.
    normal: Vec3,
    gap: f64,
    /// Of the boundary along the normal within the step \[m\].
    travel: f64,
}

/// A sphere that is squeezed: that of one of `rows`, or one of a chain.
pub(super) fn squeezed(
    assembly: &Assembly,
    solution: &Solution,
    mut rows: impl Iterator<Item = usize>,
) -> Option<Squeezed> {
    let pinched = rows.find_map(|row| pinch(assembly, solution, row));
    pinched.or_else(|| jam(assembly, solution))
}

/// Whether two rigid boundaries on opposite sides squeeze the sphere of contact `row`, which carries load from both: they
/// approach each other at its contacts, or have. A sphere that lies wedged between boundaries at rest, or faces of one, has a solution.
fn pinch(assembly: &Assembly, solution: &Solution, row: usize) -> Option<Squeezed> {
    let prediction = assembly.prediction;
    let sphere = assembly.candidates.get(row)?.key.sphere;
    let i = sphere as usize;
    let radius = prediction.scene.particles.radius[i];
    let overlap = prediction.scene.settings.tolerance.gap * radius;
    let sides: Vec<Side> = assembly
        .contacts_of(sphere)
        .filter(|&k| solution.loads(k) && !is_soft(assembly, k))
        .filter_map(|k| {
            let boundary = rigid_boundary(assembly, k)?;
            let candidate = &assembly.candidates[k];
            Some(Side {
                boundary,
                normal: candidate.normal,
                gap: candidate.gap,
                travel: motion(assembly, k).dot(&candidate.normal) * prediction.step,
            })
        })
        .collect();
    sides.iter().enumerate().find_map(|(k, a)| {
        let opposite = sides[k + 1..].iter().find(|b| {
            a.normal.dot(&b.normal) < OPPOSITE
                && (a.boundary != b.boundary && a.travel + b.travel > APPROACH * overlap
                    || a.gap + b.gap < -LEFT * overlap)
        })?;
        Some(Squeezed {
            sphere: i,
            boundaries: [a.boundary, opposite.boundary],
            by_others: false,
        })
    })
}

/// The boundary of contact `k`, if it has a prescribed motion and does not give way by the scene. What gives way is solved as rigid in an
/// impact; a driven body gives way.
fn rigid_boundary(assembly: &Assembly, k: usize) -> Option<u16> {
    let Partner::Boundary { boundary, .. } = assembly.candidates[k].key.partner else {
        return None;
    };
    let driven = assembly.prediction.body(usize::from(boundary)).is_some();
    (assembly.elastic(k).is_none() && !driven).then_some(boundary)
}

/// Whether contact `k` with a rigid boundary was softened.
fn is_soft(assembly: &Assembly, k: usize) -> bool {
    assembly.problem.rows.compliance(k) != 0.0
}

/// Velocity \[m/s\] of the boundary of contact `k` where it touches.
fn motion(assembly: &Assembly, k: usize) -> Vec3 {
    let prediction = assembly.prediction;
    let candidate = &assembly.candidates[k];
    let Partner::Boundary { boundary, .. } = candidate.key.partner else {
        return Vec3::zeros();
    };
    let i = candidate.key.sphere as usize;
    let radius = prediction.scene.particles.radius[i];
    let point = prediction.kinematics.position[i] - candidate.normal * radius;
    prediction.motions[usize::from(boundary)].at(point)
}

/// Spheres that are squeezed with others between: some contact with a boundary is jammed, or was, and from it a chain of contacts that
/// carry much leads to another boundary.
fn jam(assembly: &Assembly, solution: &Solution) -> Option<Squeezed> {
    let mut jammed = jammed(assembly, solution);
    let load = |k: &usize| solution.impulses[*k].norm();
    jammed.sort_by(|a, b| load(b).total_cmp(&load(a)));
    let mut heaviest = jammed.into_iter().take(HEAVIEST);
    heaviest.find_map(|k| chain(assembly, solution, k))
}

/// The contacts with boundaries that are jammed, or were, of those that do not give way yet.
fn jammed(assembly: &Assembly, solution: &Solution) -> Vec<usize> {
    let all = 0..assembly.candidates.len();
    all.filter(|&k| {
        rigid_boundary(assembly, k).is_some()
            && solution.loads(k)
            && !is_soft(assembly, k)
            && (was_squeezed(assembly, k) || is_jammed(assembly, solution, k))
    })
    .collect()
}

/// The chain from contact `first` with a boundary to another boundary, if they squeeze it: one moves, or has left an overlap. One body
/// between both is such a chain where the step is too short for [`pinch`].
fn chain(assembly: &Assembly, solution: &Solution, first: usize) -> Option<Squeezed> {
    let start = rigid_boundary(assembly, first)?;
    let closes = |k| was_squeezed(assembly, k) || motion(assembly, k) != Vec3::zeros();
    let least = SHARE * solution.impulses[first].norm();
    let all = 0..assembly.candidates.len();
    let carries = |&k: &usize| solution.impulses[k].norm() >= least;
    let bodies = |k: usize| {
        let spheres = assembly.candidates[k].key.spheres();
        spheres.map(|i| assembly.prediction.mover(i).0)
    };
    let sides = all
        .filter(carries)
        .flat_map(|k| bodies(k).map(move |body| (body, k)));
    let mut sides: Vec<(u32, usize)> = sides.collect();
    sides.sort_unstable();
    let mut known = vec![false; assembly.candidates.len()];
    known[first] = true;
    let mut chain = vec![first];
    let mut reached = 0;
    while let Some(&from) = chain.get(reached) {
        let end = rigid_boundary(assembly, from).filter(|&boundary| boundary != start);
        if let Some(end) = end.filter(|_| closes(first) || closes(from)) {
            let by_others = !bodies(first).eq(bodies(from));
            let mut boundaries = [start, end];
            if !by_others {
                boundaries.sort_unstable();
            }
            return Some(Squeezed {
                sphere: assembly.candidates[first].key.sphere as usize,
                boundaries,
                by_others,
            });
        }
        for body in bodies(from) {
            let begin = sides.partition_point(|side| side.0 < body);
            let own = sides[begin..].iter().take_while(|side| side.0 == body);
            for &(_, k) in own {
                if !known[k] {
                    known[k] = true;
                    chain.push(k);
                }
            }
        }
        reached += 1;
    }
    None
}

/// Whether contact `k` with a boundary carries more than anything but a jam of its sphere gives it.
fn is_jammed(assembly: &Assembly, solution: &Solution, k: usize) -> bool {
    let prediction = assembly.prediction;
    let i = assembly.candidates[k].key.sphere as usize;
    let speed = prediction.velocity(i).linear.norm() + motion(assembly, k).norm();
    let own = speed + prediction.gravity_size * prediction.step;
    solution.impulses[k].norm() > JAMMED * prediction.scene.particles.mass[i] * own
}

/// Whether contact `k` with a boundary overlaps at the start by what only a squeeze leaves.
fn was_squeezed(assembly: &Assembly, k: usize) -> bool {
    let settings = &assembly.prediction.scene.settings;
    let overlap = settings.tolerance.gap * assembly.problem.rows.radius(k);
    assembly.candidates[k].gap < -LEFT * overlap
}

/// Lets the contacts with boundaries of what is squeezed give way, so that there is an answer: `k` such that [`WEIGHTS`] weights press
/// a sphere in by its radius. Returns one that did not give way before.
pub(super) fn soften(assembly: &mut Assembly, solution: &Solution) -> Option<Squeezed> {
    let pinched = soften_pinched(assembly, solution);
    let jam = jam(assembly, solution);
    if jam.is_some() {
        let contacts = jammed(assembly, solution);
        contacts.into_iter().for_each(|k| give_way(assembly, k));
    }
    pinched.or(jam)
}

fn soften_pinched(assembly: &mut Assembly, solution: &Solution) -> Option<Squeezed> {
    let mut squeezed: Vec<Squeezed> = (0..assembly.candidates.len())
        .filter_map(|row| pinch(assembly, solution, row))
        .collect();
    squeezed.dedup_by_key(|one| one.sphere);
    for one in &squeezed {
        for k in assembly.contacts_of(one.sphere as u32) {
            if assembly.is_with_boundary(k) && assembly.elastic(k).is_none() {
                give_way(assembly, k);
            }
        }
    }
    squeezed.first().copied()
}

/// `F = k (overlap + step v)` at the speed `v` of pressing in, where overlaps come out at `overlap/step`: `step` is the longest, so that
/// steps of any length have the same force.
fn give_way(assembly: &mut Assembly, k: usize) {
    let prediction = assembly.prediction;
    let particles = &prediction.scene.particles;
    let i = assembly.candidates[k].key.sphere as usize;
    let weight = particles.mass[i] * prediction.gravity_size.max(1.0);
    let stiffness = WEIGHTS * weight / particles.radius[i];
    let longest = prediction.scene.settings.step;
    let compliance = 1.0 / (stiffness * prediction.step * longest);
    let rows = &mut assembly.problem.rows;
    rows.update(k, |row| row.compliance_n = compliance);
}
