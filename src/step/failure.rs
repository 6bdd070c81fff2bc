//! Why a step failed, from the solver's report and the rows.

use super::StepFailure;
use super::assemble::Assembly;
use super::solution::Solution;
use crate::Vec3;
use crate::contact::Partner;
use crate::linalg::LinearError;
use crate::solver::Report;
use crate::state::Squeezed;

/// A solve that missed its tolerances.
pub(super) fn failed(assembly: &Assembly, solution: &Solution, report: &Report) -> StepFailure {
    let tolerance = &assembly.prediction.scene.settings.tolerance;
    let residual = &report.residual;
    let kinds = [
        ("gap", residual.gap, tolerance.gap, residual.worst[0]),
        ("slip", residual.slip, tolerance.slip, residual.worst[1]),
        ("force", residual.force, tolerance.force, residual.worst[2]),
    ];
    let excess = |(_, value, limit, _): &(_, f64, f64, _)| value / limit;
    let worst = kinds.iter().max_by(|a, b| excess(a).total_cmp(&excess(b)));
    let (what, value, tolerance, row) = worst.copied().unwrap_or(kinds[0]);
    let mut rows = residual.worst.iter();
    StepFailure {
        what,
        residual: value,
        tolerance,
        contact: assembly.contact_of(row).map(|k| assembly.candidates[k].key),
        pinched: rows.find_map(|&row| pinch(assembly, solution, row)),
        passed: None,
        broken: report.broken.map(Box::new),
    }
}

/// A solution whose derivative does not exist.
pub(super) fn singular(
    assembly: &Assembly,
    solution: &Solution,
    report: &Report,
    error: LinearError,
) -> StepFailure {
    StepFailure {
        broken: Some(Box::new(error)),
        ..failed(assembly, solution, report)
    }
}

/// Passes that never met the true geometry, whose worst overlap and opening are `gaps`. Forces without bound satisfy a pinch on
/// paper: then only the geometry refuses it.
pub(super) fn failed_to_converge(
    assembly: &Assembly,
    solution: &Solution,
    (overlap, opening): (f64, f64),
) -> StepFailure {
    let mut rows = 0..assembly.candidates.len();
    let settings = &assembly.prediction.scene.settings;
    let (gap, widest) = (settings.tolerance.gap, settings.widest());
    let (what, residual, tolerance) = if overlap > gap {
        ("gap", overlap, gap)
    } else if opening > widest {
        ("opening", opening, widest)
    } else {
        ("gap", f64::NAN, gap)
    };
    StepFailure {
        what,
        residual,
        tolerance,
        contact: None,
        pinched: rows.find_map(|row| pinch(assembly, solution, row)),
        passed: None,
        broken: None,
    }
}

/// Largest cosine between normals of boundaries that squeeze.
const OPPOSITE: f64 = -0.5;
/// Share of the tolerated overlap by which boundaries that squeeze approach each other in the step.
const APPROACH: f64 = 0.1;
/// Overlaps in units of the tolerated one that only squeezing leaves, where boundaries have stopped.
const LEFT: f64 = 10.0;

/// Whether two rigid boundaries on opposite sides squeeze the sphere of contact `row`, which carries load from both: they
/// approach each other at its contacts, or have. A sphere that lies wedged between boundaries at rest has a solution.
pub(super) fn pinch(assembly: &Assembly, solution: &Solution, row: usize) -> Option<Squeezed> {
    let prediction = assembly.prediction;
    let sphere = assembly.candidates.get(row)?.key.sphere;
    let i = sphere as usize;
    let radius = prediction.scene.particles.radius[i];
    let overlap = prediction.scene.settings.tolerance.gap * radius;
    let sides: Vec<Side> = assembly
        .contacts_of(sphere)
        // What gives way is solved as rigid in an impact, and rigid as what gives way where it was softened.
        .filter(|&k| assembly.elastic(k).is_none() && assembly.problem.rows.compliance(k) == 0.0)
        .filter(|&k| solution.loads(k))
        .filter_map(|k| {
            let candidate = &assembly.candidates[k];
            let Partner::Boundary { boundary, .. } = candidate.key.partner else {
                return None;
            };
            // A driven body gives way.
            let rigid = prediction.body(usize::from(boundary)).is_none();
            let point = prediction.kinematics.position[i] - candidate.normal * radius;
            let motion = prediction.motions[usize::from(boundary)].at(point);
            rigid.then_some(Side {
                boundary,
                normal: candidate.normal,
                gap: candidate.gap,
                travel: motion.dot(&candidate.normal) * prediction.step,
            })
        })
        .collect();
    sides.iter().enumerate().find_map(|(k, a)| {
        let opposite = sides[k + 1..].iter().find(|b| {
            a.normal.dot(&b.normal) < OPPOSITE
                && (a.travel + b.travel > APPROACH * overlap || a.gap + b.gap < -LEFT * overlap)
        })?;
        Some(Squeezed {
            sphere: i,
            boundaries: [a.boundary, opposite.boundary],
        })
    })
}

/// A boundary that presses on a sphere.
struct Side {
    boundary: u16,
    /// Into the sphere.
    normal: Vec3,
    gap: f64,
    /// Of the boundary along the normal within the step \[m\].
    travel: f64,
}
