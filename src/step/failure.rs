//! Why a step failed, from the solver's report and the rows.

use super::StepFailure;
use super::assemble::Assembly;
use super::solution::Solution;
use super::squeeze::squeezed;
use crate::linalg::LinearError;
use crate::solver::Report;

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
    StepFailure {
        what,
        residual: value,
        tolerance,
        contact: assembly.contact_of(row).map(|k| assembly.candidates[k].key),
        pinched: squeezed(assembly, solution, residual.worst.into_iter()),
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
        pinched: squeezed(assembly, solution, 0..assembly.candidates.len()),
        passed: None,
        broken: None,
    }
}
