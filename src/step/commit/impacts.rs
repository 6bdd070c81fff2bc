//! Which contacts of a solved step count as impacts: their forces are none that the next step may go on with. As smooth forces they
//! would shift the half step.

use crate::Vec3;
use crate::spatial::SpatialVector;
use crate::state::State;
use crate::step::assemble::Assembly;
use crate::step::rows::elastic::ElasticContact;
use crate::step::solution::Solution;

/// Forces over those carried before and what loads bring, from which on a contact was hit through others.
const STRUCK: f64 = 2.0;
/// Change of a force since the last step, over the force, up to which it lasts.
const STEADY: f64 = 0.2;
/// Forces that a body keeps over what changes its motion, from which on they only hold against its impacts.
const HELD: f64 = 4.0;

/// Counts as impacts the contacts that an impact has hit through others: their impulses are more than [`STRUCK`] times what they
/// carried before and what loads bring in a step, or their sum on a body only holds against its impacts. Of a step that is `unconverged` all
/// are.
pub(crate) fn spread_impacts(
    assembly: &mut Assembly,
    solution: &Solution,
    state: &State,
    unconverged: bool,
) {
    if unconverged {
        assembly.impact.fill(true);
        assembly
            .joints
            .iter_mut()
            .for_each(|joint| joint.impact = true);
        return;
    }
    let struck = |(k, p): (usize, &Vec3)| *p != Vec3::zeros() && assembly.is_impact(k);
    if !solution.impulses.iter().enumerate().any(struck) {
        return;
    }
    let prediction = assembly.prediction;
    let step = prediction.step;
    let first = assembly.first_joint();
    for (k, joint) in assembly.joints.iter_mut().enumerate() {
        let load = prediction.weight(assembly.problem.rows.bodies(first + k)[0]);
        let before = joint.limit.force.abs();
        let handed_on = solution.impulses[first + k].norm() > STRUCK * step * (before + load);
        joint.impact |= joint.limit.stops() && handed_on;
    }
    // What a step resolves is no impact.
    let resolved =
        |assembly: &Assembly, k| assembly.elastic(k).is_some_and(ElasticContact::is_resolved);
    for k in (0..assembly.impact.len()).filter(|&k| solution.loads(k)) {
        if resolved(assembly, k) {
            continue;
        }
        let size = solution.impulses[k].norm();
        let before = assembly.past[k].force(&state.contacts).norm();
        // Most carry what they did.
        if size <= STRUCK * step * before {
            continue;
        }
        let bodies = assembly.problem.rows.bodies(k);
        let load = bodies.map(|body| prediction.weight(body));
        let load = load[0].max(load[1]);
        assembly.impact[k] |= size > STRUCK * step * (before + load);
    }
    let found = held(assembly, solution);
    if found.is_empty() {
        return;
    }
    for k in found {
        let (size, before) = (
            solution.impulses[k].norm(),
            assembly.past[k].force(&state.contacts),
        );
        assembly.impact[k] &= (size - step * before.norm()).abs() > STEADY * size;
    }
    loop {
        let mut found = held(assembly, solution);
        found.retain(|&k| !assembly.impact[k] && !resolved(assembly, k));
        if found.is_empty() {
            return;
        }
        found.iter().for_each(|&k| assembly.impact[k] = true);
    }
}

/// The loaded contacts of bodies whose smooth forces and impacts, each much more than what both together change of the motion, cancel.
fn held(assembly: &Assembly, solution: &Solution) -> Vec<usize> {
    let rows = &assembly.problem.rows;
    let loaded = |k: &usize| solution.loads(*k);
    let kind = |k: usize| usize::from(assembly.is_impact(k));
    let on = |k: usize| rows.bodies(k).into_iter().map(|body| body as usize);
    let count = solution.velocity.len();
    let mut kinds = vec![0; count];
    for k in (0..solution.impulses.len()).filter(loaded) {
        for body in on(k).filter(|&i| i < count) {
            kinds[body] |= 1 << kind(k);
        }
    }
    // Of one kind alone nothing cancels.
    let mixed: Vec<usize> = (0..count).filter(|&i| kinds[i] == 0b11).collect();
    if mixed.is_empty() {
        return Vec::new();
    }
    let mut rank = vec![None; count];
    for (at, &body) in mixed.iter().enumerate() {
        rank[body] = Some(at);
    }
    let rank = |body: usize| rank.get(body).copied().flatten();
    let mut sums = vec![[SpatialVector::ZERO; 2]; mixed.len()];
    for k in (0..solution.impulses.len()).filter(loaded) {
        for (side, body) in on(k).enumerate() {
            if let Some(at) = rank(body) {
                let grip = rows.get(k).jacobian()[side];
                let impulse = solution.impulses[k];
                let push = grip.momentum([impulse, -impulse][side]);
                let sum = &mut sums[at][kind(k)];
                *sum = sum.plus(&push, 1.0);
            }
        }
    }
    // Radius \[m\] of a contact below which those of a body cancel.
    let limit = |(&body, [smooth, impacts]): (&usize, &[SpatialVector; 2])| {
        let net = smooth.plus(impacts, 1.0);
        let brought = assembly.prediction.step * assembly.prediction.weight(body as u32);
        match smooth.linear.norm() > HELD * (net.linear.norm() + brought) {
            true => f64::INFINITY,
            false => (smooth.angular.norm() / HELD - net.angular.norm()) / brought,
        }
    };
    let limits: Vec<f64> = mixed.iter().zip(&sums).map(limit).collect();
    let cancel = |body: usize, radius: f64| rank(body).is_some_and(|at| radius < limits[at]);
    let all = (0..assembly.impact.len()).filter(loaded);
    all.filter(|&k| on(k).any(|body| cancel(body, rows.radius(k))))
        .collect()
}
