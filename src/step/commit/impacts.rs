//! Which contacts of a solved step count as impacts: their forces are none that the next step may go on with. As smooth forces they
//! would shift the half step.

use crate::Vec3;
use crate::problem::GROUND;
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
    for k in held(assembly, solution) {
        let (size, before) = (
            solution.impulses[k].norm(),
            assembly.past[k].force(&state.contacts),
        );
        assembly.impact[k] &= (size - step * before.norm()).abs() > STEADY * size;
    }
    loop {
        let smooth = |k: &usize| !assembly.impact[*k] && !resolved(assembly, *k);
        let found: Vec<usize> = held(assembly, solution)
            .into_iter()
            .filter(smooth)
            .collect();
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
    let impacts = (0..assembly.impact.len()).filter(|&k| assembly.impact[k]);
    let mut struck: Vec<u32> = impacts
        .filter(loaded)
        .flat_map(|k| rows.bodies(k))
        .filter(|&body| body != GROUND)
        .collect();
    struck.sort_unstable();
    struck.dedup();
    let mut sums = vec![[SpatialVector::ZERO; 2]; struck.len()];
    for k in (0..solution.impulses.len()).filter(loaded) {
        let (kind, impulse) = (usize::from(assembly.is_impact(k)), solution.impulses[k]);
        for (side, body) in rows.bodies(k).into_iter().enumerate() {
            if let Ok(rank) = struck.binary_search(&body) {
                let grip = rows.get(k).jacobian()[side];
                let push = grip.momentum([impulse, -impulse][side]);
                sums[rank][kind] = sums[rank][kind].plus(&push, 1.0);
            }
        }
    }
    let prediction = assembly.prediction;
    let cancel = |body: u32, radius: f64| {
        let Ok(rank) = struck.binary_search(&body) else {
            return false;
        };
        let [smooth, impacts] = &sums[rank];
        let net = smooth.plus(impacts, 1.0);
        let brought = prediction.step * prediction.weight(body);
        smooth.linear.norm() > HELD * (net.linear.norm() + brought)
            || smooth.angular.norm() > HELD * (net.angular.norm() + brought * radius)
    };
    let of = |k: &usize| {
        let bodies = rows.bodies(*k);
        loaded(k) && bodies.into_iter().any(|body| cancel(body, rows.radius(*k)))
    };
    (0..assembly.impact.len()).filter(of).collect()
}
