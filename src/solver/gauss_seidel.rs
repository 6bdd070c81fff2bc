//! Block Gauss-Seidel on the multipliers.
//!
//! Contact by contact, in canonical order: the contact's own law is solved in closed form with all other
//! multipliers held, and the velocities of its two bodies follow at once (Jean 1999; for a sphere contact
//! the local operator is diagonal, so normal and tangent do not couple). Deterministic; robust with friction.

use super::residual::{Residual, Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::problem::Problem;

/// Sweeps after which updates are damped: exact Coulomb friction can cycle.
const DAMP_AFTER: [(usize, f64); 2] = [(300, 0.6), (1200, 0.3)];

/// Solves `problem` from the impulses given; see [`super::solve`].
pub fn solve(problem: &Problem, params: &Params, impulses: &mut [Vec3]) -> Report {
    let scales = Scale::of(problem);
    let mut velocity = problem.velocities(impulses);
    let mut report = Report::default();
    // A sweep's own changes say when to ask for the residual; where they promised too much, ask later.
    let mut confidence = 1.0;
    while report.sweeps < params.max_sweeps {
        report.sweeps += 1;
        let damping = DAMP_AFTER
            .iter()
            .rev()
            .find(|(after, _)| report.sweeps > *after)
            .map_or(1.0, |(_, damping)| *damping);
        let mut change = Residual::default();
        for (index, ((row, scale), p)) in problem
            .rows
            .iter()
            .zip(&scales)
            .zip(&mut *impulses)
            .enumerate()
        {
            let correction = scale.correction(row, row.relative_velocity(&velocity), *p);
            change.include(index, scale.residuals(row, problem.step, &correction));
            let delta = (row.normal * correction.normal + correction.tangential) * damping;
            if delta != Vec3::zeros() {
                *p += delta;
                row.apply(&problem.inverse_mass, &mut velocity, delta);
            }
        }
        let wanted = crate::scene::Tolerance {
            gap: params.tolerance.gap * confidence,
            slip: params.tolerance.slip * confidence,
            force: params.tolerance.force * confidence,
        };
        if change.within(&wanted) {
            report.residual = evaluate(problem, &scales, impulses);
            if report.residual.within(&params.tolerance) {
                report.converged = true;
                return report;
            }
            confidence *= 0.5;
            velocity = problem.velocities(impulses);
        }
    }
    report.residual = evaluate(problem, &scales, impulses);
    report.converged = report.residual.within(&params.tolerance);
    report
}
