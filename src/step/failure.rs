//! Why a step failed, from the solver's report and the rows.

use super::assembly::Assembly;
use super::{StepFailure, Tunnelling};
use crate::Vec3;
use crate::contact::Partner;
use crate::linalg::LinearError;
use crate::solver::Report;

impl Assembly<'_> {
    pub(super) fn too_fast(&self, report: &Report, passed: Tunnelling) -> StepFailure {
        StepFailure {
            passed: Some(passed),
            ..self.failure(report)
        }
    }

    pub(super) fn broken(&self, report: &Report, broken: LinearError) -> StepFailure {
        StepFailure {
            broken: Some(Box::new(broken)),
            ..self.failure(report)
        }
    }

    pub(super) fn failure(&self, report: &Report) -> StepFailure {
        let tolerance = &self.inputs.scene.settings.tolerance;
        let residual = &report.residual;
        let kinds = [
            ("gap", residual.gap, tolerance.gap, residual.worst[0]),
            ("slip", residual.slip, tolerance.slip, residual.worst[1]),
            ("force", residual.force, tolerance.force, residual.worst[2]),
        ];
        let excess = |(_, value, limit, _): &(_, f64, f64, _)| value / limit;
        let worst = kinds.iter().max_by(|a, b| excess(a).total_cmp(&excess(b)));
        let (what, residual, tolerance, row) = worst.copied().unwrap_or(kinds[0]);
        StepFailure {
            what,
            residual,
            tolerance,
            contact: self.contact_of(row).map(|k| self.candidates[k].key),
            pinched: report
                .residual
                .worst
                .iter()
                .find_map(|&row| self.pinch(row)),
            passed: None,
            broken: report.broken.map(Box::new),
        }
    }

    /// Whether the sphere of contact `row` carries load from two rigid boundaries on opposite sides.
    pub(super) fn pinch(&self, row: usize) -> Option<(usize, [u16; 2])> {
        let sphere = self.candidates.get(row)?.key.sphere;
        let boundaries: Vec<(u16, Vec3)> = (0..self.candidates.len())
            .filter(|&k| self.candidates[k].key.sphere == sphere)
            .filter(|&k| self.problem.rows.compliance(k) == 0.0)
            .filter(|&k| self.impulses[k] != Vec3::zeros())
            .filter_map(|k| match self.candidates[k].key.partner {
                Partner::Boundary { boundary, .. } => {
                    // A driven body gives way.
                    let rigid = self.inputs.body(usize::from(boundary)).is_none();
                    rigid.then_some((boundary, self.candidates[k].normal))
                }
                Partner::Sphere { .. } => None,
            })
            .collect();
        boundaries.iter().enumerate().find_map(|(k, (a, n))| {
            let opposite = boundaries[k + 1..].iter().find(|(_, m)| n.dot(m) < -0.5)?;
            Some((sphere as usize, [*a, opposite.0]))
        })
    }
}
