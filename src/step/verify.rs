//! Fifth stage of a step: whether the true geometry at its end agrees with the solution of the linear problem.

use std::mem::take;
use std::ops::Range;

use super::Tunnelling;
use super::assemble::Assembly;
use super::correction::{Correction, error_of, left_of, true_gap};
use super::solution::Solution;
use super::tunnelling::{passed, struck};
use super::workspace::Workspace;
use crate::detection::configuration::{Candidate, Configuration};
use crate::scene::Method;
use crate::spatial::extent::larger;

/// What the true geometry says.
pub(super) struct Verdict {
    /// Largest overlap over radius at the end of the step \[-\], without what contacts that give way are compressed by.
    pub(super) max_overlap: f64,
    /// Largest compression over radius of a contact that gives way \[-\].
    pub(super) max_compression: f64,
    /// Largest gap over radius at which a contact carries load at the end of the step \[-\].
    pub(super) max_opening: f64,
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
    let mut max_overlap = end.overlaps(neighbors, limit, &mut overlapping);
    // Springs that sleep are compressed.
    overlapping.retain(|found| !prediction.sleeps(found.key));
    // The penalty method lets bodies overlap as they like.
    let alm = settings.method == Method::Alm;
    let swept = alm && assembly.moves && !pass;
    let closed = match alm {
        true => Closed::of(&assembly.candidates, &overlapping),
        false => Closed::default(),
    };
    let late_contact = match swept {
        true => struck(assembly, &end, &closed.late),
        false => None,
    };
    let gaps = Gaps::of(assembly, solution, &end);
    if alm && prediction.gives_way {
        max_overlap = closed.rigid_overlap(assembly, &end).max(gaps.overlap);
    }
    let correction = match late_contact.is_none() && alm && !as_it_is {
        true => correction(assembly, solution, &end, (&gaps, closed)),
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
            max_compression: gaps.compression,
            max_opening: gaps.opening,
            correction,
        }),
    }
}

/// What the contacts of the problem have in common at the end of a step.
struct Gaps {
    /// Largest gap over radius of a contact that carries load and did not rebound \[-\].
    opening: f64,
    /// Largest overlap and compression over radius of those that give way \[-\].
    overlap: f64,
    compression: f64,
    /// Whether a contact overlaps or opens by more than it may.
    off: bool,
}

impl Gaps {
    /// Two spheres without load that overlap are left out: they are among the overlapping pairs.
    fn of(assembly: &Assembly, solution: &Solution, end: &Configuration) -> Self {
        let settings = &assembly.prediction.scene.settings;
        let tolerance = settings.tolerance.gap;
        let widest = settings.widest();
        let of = |k: usize| {
            let loaded = solution.loads(k);
            if assembly.elastic(k).is_some() {
                return Self::of_spring(assembly, solution, end, k);
            }
            if !(loaded || assembly.is_with_boundary(k)) {
                return Self::NONE;
            }
            let radius = assembly.problem.rows.radius(k);
            let gap = true_gap(assembly, solution, end, k) / radius;
            let opening = match loaded && !assembly.impact[k] {
                true => gap.max(0.0),
                false => 0.0,
            };
            Self {
                opening,
                off: opening > widest
                    || gap < -tolerance
                        && gap < -tolerance - left_of(assembly, k) / radius
                        && assembly.problem.rows.compliance(k) == 0.0,
                ..Self::NONE
            }
        };
        let all = 0..assembly.candidates.len();
        let piece = |_, range: Range<usize>| range.map(of).fold(Self::NONE, Self::and);
        assembly.prediction.pool.pieces(all, piece, Self::and)
    }

    /// Of a contact that gives way: its compression is no error, what the force misses it by is one. Where the force compresses it by less
    /// than the tolerance, it may open as a rigid one: its force is off by no more than within the tolerance of its gap.
    fn of_spring(assembly: &Assembly, solution: &Solution, end: &Configuration, k: usize) -> Self {
        let radius = assembly.problem.rows.radius(k);
        let settings = &assembly.prediction.scene.settings;
        let gap = end.gap(&assembly.candidates[k]);
        let compression = match settings.method {
            Method::Alm => -gap / radius,
            // Of its springs nobody asked the material.
            Method::Penalty => 0.0,
        };
        let error = match assembly.compressed(k) {
            Some(elastic) if solution.loads(k) || compression > 0.0 || elastic.neck().is_some() => {
                error_of(assembly, solution, k, gap) / radius
            }
            _ => 0.0,
        };
        let tolerance = settings.tolerance.gap;
        let widest = match error - gap / radius < tolerance {
            true => settings.widest(),
            false => tolerance,
        };
        Self {
            opening: error.max(0.0),
            overlap: (-error).max(0.0),
            compression: compression.max(0.0),
            off: error < -tolerance || error > widest,
        }
    }

    const NONE: Self = Self {
        opening: 0.0,
        overlap: 0.0,
        compression: 0.0,
        off: false,
    };

    fn and(self, other: Self) -> Self {
        Self {
            opening: larger(self.opening, other.opening),
            overlap: larger(self.overlap, other.overlap),
            compression: larger(self.compression, other.compression),
            off: self.off || other.off,
        }
    }
}

/// Pairs that overlap at the end of a step by more than the tolerance.
#[derive(Default)]
struct Closed {
    /// Those that are candidates, with their gaps \[m\].
    known: Vec<(usize, f64)>,
    /// The others.
    late: Vec<Candidate>,
}

impl Closed {
    /// Tells those `found` apart by `all` candidates. They ascend but for a few places, so that the next one is near.
    fn of(all: &[Candidate], found: &[Candidate]) -> Self {
        let (mut closed, mut at) = (Self::default(), 0);
        for found in found {
            if all[..at].last().is_some_and(|last| last.key >= found.key) {
                at = all.partition_point(|candidate| candidate.key < found.key);
            }
            let before = |candidate: &&Candidate| candidate.key < found.key;
            at += all[at..].iter().take_while(before).count();
            match all.get(at).is_some_and(|known| known.key == found.key) {
                true => closed.known.push((at, found.gap)),
                false => closed.late.push(*found),
            }
        }
        closed
    }

    /// Largest overlap over radius of those that do not give way.
    fn rigid_overlap(&self, assembly: &Assembly, end: &Configuration) -> f64 {
        let rigid = self.known.iter();
        let rigid = rigid.filter(|(k, _)| assembly.elastic(*k).is_none());
        let rigid = rigid.map(|&(k, gap)| (assembly.candidates[k].key, gap));
        let late = self.late.iter().map(|found| (found.key, found.gap));
        rigid
            .chain(late)
            .map(|(key, gap)| -gap / end.scale(key))
            .fold(0.0, f64::max)
    }
}

/// Contacts whose linear gaps are off, and those that closed without being candidates; `None` without any.
fn correction(
    assembly: &Assembly,
    solution: &Solution,
    end: &Configuration,
    (gaps, Closed { known, late }): (&Gaps, Closed),
) -> Option<Correction> {
    let tolerance = assembly.prediction.scene.settings.tolerance.gap;
    let resolves = |k: usize| assembly.elastic(k).is_some() && assembly.compressed(k).is_none();
    // What overlapped at the start may be undone by later steps.
    let is_left = |k: usize, gap: f64| {
        gap >= -tolerance * assembly.problem.rows.radius(k) - left_of(assembly, k)
    };
    let hidden = |&(k, gap): &(usize, f64)| !solution.loads(k) && !resolves(k) && !is_left(k, gap);
    let off = gaps.off || known.iter().any(hidden);
    if !off && late.is_empty() {
        return None;
    }
    // A rebound yields only to an overlap; a spring that the step resolves is as it is.
    let yields = |k: usize| {
        let overlaps = || !is_left(k, true_gap(assembly, solution, end, k));
        assembly.compressed(k).is_some()
            || assembly.elastic(k).is_none() && (!assembly.impact[k] || overlaps())
    };
    let mut all = vec![false; assembly.candidates.len()];
    assembly.prediction.pool.fill(&mut all[..], yields);
    Some(Correction {
        yields: all,
        late,
        ..Correction::default()
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Vec3;
    use crate::contact::{ContactId, Partner};

    proptest! {
        /// In any order, those that are candidates are told from the others.
        #[test]
        fn what_overlaps_is_found_among_the_candidates(
            known in prop::collection::btree_set(0..40_u32, 0..30),
            found in prop::collection::vec(0..40_u32, 0..30),
        ) {
            let candidate = |key: u32| Candidate {
                key: ContactId {
                    sphere: key / 8,
                    partner: Partner::sphere(key % 8),
                },
                gap: -f64::from(key),
                normal: Vec3::z(),
                curvature: 0.0,
            };
            let all: Vec<_> = known.iter().map(|&key| candidate(key)).collect();
            let overlapping: Vec<_> = found.iter().map(|&key| candidate(key)).collect();
            let closed = Closed::of(&all, &overlapping);
            let at = |key: &u32| known.iter().position(|known| known == key);
            let expected = found.iter().filter_map(|key| Some((at(key)?, -f64::from(*key))));
            prop_assert_eq!(closed.known, expected.collect::<Vec<_>>());
            let others = found.iter().filter(|key| at(key).is_none());
            let others = others.map(|&key| candidate(key).key);
            let late = closed.late.iter().map(|late| late.key);
            prop_assert_eq!(late.collect::<Vec<_>>(), others.collect::<Vec<_>>());
        }
    }
}
