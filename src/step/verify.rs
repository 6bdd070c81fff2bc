//! Fifth stage of a step: whether the true geometry at its end agrees with the solution of the linear problem.

use std::mem::take;
use std::ops::Range;

use super::Tunnelling;
use super::assemble::Assembly;
use super::correction::{Correction, true_gap};
use super::solution::Solution;
use super::tunnelling::{passed, struck};
use super::workspace::Workspace;
use crate::detection::configuration::{Candidate, Configuration};
use crate::scene::Method;

/// A loaded contact may leave its linearised surface by this share of the radius before its gap is
/// re-linearised; overlaps are held to the tolerance whatever this is.
const OPENING: f64 = 1e-3;

/// What the true geometry says.
pub(super) struct Verdict {
    /// Largest overlap over radius at the end of the step \[-\].
    pub(super) max_overlap: f64,
    /// What the problem lacks; `None` where it may stay as it is.
    pub(super) correction: Option<Correction>,
}

/// Compares the solution with the true geometry at the end of the step, and leaves in it where it leads. If it is to be taken
/// `as_it_is` nothing is corrected, and bodies may `pass` through each other if they may.
///
/// # Errors
/// Bodies that pass through each other.
pub(super) fn verify(
    assembly: &Assembly,
    solution: &mut Solution,
    workspace: &mut Workspace,
    (as_it_is, pass): (bool, bool),
) -> Result<Verdict, Tunnelling> {
    let prediction = assembly.prediction;
    let settings = &prediction.scene.settings;
    let mut position = take(&mut solution.position);
    let mut overlapping = take(&mut solution.overlapping);
    prediction.end_positions(&solution.velocity, &mut position);
    let poses = prediction.end_poses(&solution.velocity);
    let end = Configuration {
        position: &position,
        poses: &poses,
        ..assembly.start()
    };
    let neighbors = &mut workspace.neighbors;
    neighbors.ensure(&end, &[], 0.0);
    let limit = settings.tolerance.gap;
    let max_overlap = end.overlaps(neighbors, limit, &assembly.pool, &mut overlapping);
    // The penalty method lets bodies overlap as they like.
    let alm = settings.method == Method::Alm;
    let swept = alm && assembly.moves && !pass;
    let late_contact = match swept {
        true => struck(assembly, &end, &overlapping),
        false => None,
    };
    let correction = match late_contact.is_none() && alm && !as_it_is {
        true => correction(assembly, solution, &end, &overlapping),
        false => None,
    };
    (solution.position, solution.overlapping) = (position, overlapping);
    let tunnelling = match late_contact {
        None if swept && correction.is_none() => passed(assembly, solution, &poses, workspace),
        found => found,
    };
    match tunnelling {
        Some(tunnelling) => Err(tunnelling),
        None => Ok(Verdict {
            max_overlap,
            correction,
        }),
    }
}

/// Contacts whose linear gaps are off, and those that closed without being candidates; `None` without any.
fn correction(
    assembly: &Assembly,
    solution: &Solution,
    end: &Configuration,
    overlapping: &[Candidate],
) -> Option<Correction> {
    let settings = &assembly.prediction.scene.settings;
    let tolerance = settings.tolerance.gap;
    let opening = OPENING.max(3.0 * settings.opening);
    let gap = |k: usize| true_gap(assembly, solution, end, k);
    let radius = |k: usize| assembly.problem.rows.radius(k);
    // Two spheres without load that overlap are among the overlapping ones below.
    let is_off = |k: usize| {
        let loaded = solution.loads(k);
        (loaded || assembly.is_with_boundary(k)) && {
            let (gap, radius) = (gap(k), radius(k));
            let opens = loaded && !assembly.impact[k] && gap > opening * radius;
            (gap < -tolerance * radius || opens) && assembly.elastic(k).is_none()
        }
    };
    let any = |_, range: Range<usize>| range.into_iter().any(is_off);
    let all = 0..assembly.candidates.len();
    let mut off = assembly.pool.pieces(all, any, |a, b| a | b);
    let mut late = Vec::new();
    for found in overlapping {
        let known = |candidate: &Candidate| candidate.key;
        match assembly.candidates.binary_search_by_key(&found.key, known) {
            Ok(k) => off |= !solution.loads(k) && assembly.elastic(k).is_none(),
            Err(_) => late.push(*found),
        }
    }
    if !off && late.is_empty() {
        return None;
    }
    // A rebound yields only to an overlap; a spring is as it is.
    let yields = |k: usize| {
        let overlaps = || gap(k) < -tolerance * radius(k);
        assembly.elastic(k).is_none() && (!assembly.impact[k] || overlaps())
    };
    Some(Correction {
        yields: (0..assembly.candidates.len()).map(yields).collect(),
        late,
        rebounds: Vec::new(),
    })
}
