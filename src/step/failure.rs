//! Why a step failed, from the solver's report and the rows.

use super::StepFailure;
use super::assemble::Assembly;
use super::solution::Solution;
use crate::Vec3;
use crate::contact::Partner;
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

/// Passes that never met the true geometry. Forces without bound satisfy a pinch on paper: then only the geometry refuses it.
pub(super) fn failed_to_converge(assembly: &Assembly, solution: &Solution) -> StepFailure {
    let mut rows = 0..assembly.candidates.len();
    StepFailure {
        what: "gap",
        residual: f64::NAN,
        tolerance: assembly.prediction.scene.settings.tolerance.gap,
        contact: None,
        pinched: rows.find_map(|row| pinch(assembly, solution, row)),
        passed: None,
        broken: None,
    }
}

/// Whether the sphere of contact `row` carries load from two rigid boundaries on opposite sides.
pub(super) fn pinch(
    assembly: &Assembly,
    solution: &Solution,
    row: usize,
) -> Option<(usize, [u16; 2])> {
    let sphere = assembly.candidates.get(row)?.key.sphere;
    let boundaries: Vec<(u16, Vec3)> = (0..assembly.candidates.len())
        .filter(|&k| assembly.candidates[k].key.sphere == sphere)
        .filter(|&k| assembly.problem.rows.compliance(k) == 0.0)
        .filter(|&k| solution.loads(k))
        .filter_map(|k| match assembly.candidates[k].key.partner {
            Partner::Boundary { boundary, .. } => {
                // A driven body gives way.
                let rigid = assembly.prediction.body(usize::from(boundary)).is_none();
                rigid.then_some((boundary, assembly.candidates[k].normal))
            }
            Partner::Sphere { .. } => None,
        })
        .collect();
    boundaries.iter().enumerate().find_map(|(k, (a, n))| {
        let opposite = boundaries[k + 1..].iter().find(|(_, m)| n.dot(m) < -0.5)?;
        Some((sphere as usize, [*a, opposite.0]))
    })
}
