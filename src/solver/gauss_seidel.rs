//! Block Gauss-Seidel on the multipliers.
//!
//! Contact by contact, in canonical order: the contact's own law is solved in closed form with all other
//! multipliers held, and the velocities of its two bodies follow at once (for a sphere contact
//! the local operator is diagonal, so normal and tangent do not couple). Deterministic; robust with friction.

use super::residual::{Residual, Scale, evaluate};
use super::{Params, Report};
use crate::Vec3;
use crate::problem::{Dof6, Problem};

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
        let change = sweep(problem, &scales, damping, &mut velocity, impulses);
        if change.within(&params.tolerance.scaled(confidence)) {
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

/// One sweep over all rows; returns the residuals of the rows as each was met.
fn sweep(
    problem: &Problem,
    scales: &[Scale],
    damping: f64,
    velocity: &mut [Dof6],
    impulses: &mut [Vec3],
) -> Residual {
    let mut change = Residual::default();
    for (index, (row, scale)) in problem.rows.iter().zip(scales).enumerate() {
        let (p, load) = (impulses[index], row.load(&problem.rows, impulses));
        let correction = scale.correction(row, row.relative_velocity(velocity), p, load);
        change.include(index, scale.residuals(row, problem.step, &correction));
        let delta = (row.normal * correction.normal + correction.tangential) * damping;
        if delta != Vec3::zeros() {
            impulses[index] += delta;
            row.apply(&problem.inverse_mass, velocity, delta);
        }
    }
    change
}

/// `sweeps` undamped sweeps: what the augmented-Lagrangian loop uses to bring friction onto the true cone.
pub(super) fn smooth(problem: &Problem, scales: &[Scale], sweeps: usize, impulses: &mut [Vec3]) {
    let mut velocity = problem.velocities(impulses);
    for _ in 0..sweeps {
        sweep(problem, scales, 1.0, &mut velocity, impulses);
    }
}
