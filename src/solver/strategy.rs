//! Which solver works on a problem, and which finishes what it leaves.

use super::augmented_lagrangian::{self, SolverWorkspace};
use super::local_problem::LocalProblem;
use super::params::{Params, SolverKind};
use super::report::{Best, Report};
use super::residual::{Scale, evaluate};
use super::{gauss_seidel, newton};
use crate::Vec3;
use crate::linalg::LinearError;
use crate::problem::Problem;

/// Contacts that lead from an unsolved row to the border of the first part that Newton solves.
const RINGS: usize = 2;
/// Most bodies of a part: Newton's factor grows faster than the work of more sweeps.
const MOST_BODIES: usize = 300;
/// Starts among which Newton's factorizations are shared out. Where it gets through it needs about a hundred; from another start
/// it may, where more of them do not help.
const ATTEMPTS: usize = 8;
/// Gauss-Seidel sweeps over the whole after each part.
const BETWEEN: usize = 100;

/// Most sweeps and factorizations of a solve whose best iterate is taken, and the sweeps after which it is looked at once more.
const ACCEPT_SWEEPS: usize = 2000;
const ACCEPT_FACTORIZATIONS: usize = 60;
const CHUNK: usize = 50;
const CHUNKS: usize = 10;
/// Sweeps without momentum from no impulses at all, each of which takes energy away, where the best iterate makes some.
const PLAIN_SWEEPS: usize = 500;

/// Gauss-Seidel sweeps that `auto` spends before it turns to Newton.
const AUTO_SWEEPS: usize = 1000;

/// Solves `problem` from the impulses given and leaves the solution in them, `[C]` \[N s\], and its velocities in the workspace.
/// With [`Params::accept`] they are the best that were found.
pub fn solve(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
) -> Report {
    if impulses.is_empty() {
        problem.velocities_into(impulses, &mut workspace.velocity);
        return Report {
            converged: true,
            ..Report::default()
        };
    }
    let (mut report, mut last) = match params.accept {
        true => attempt(problem, &params.brief(), workspace, impulses),
        false => attempt(problem, params, workspace, impulses),
    };
    if params.accept && !report.converged {
        report = best(problem, params, workspace, (impulses, report));
        last = Last::Factor;
    }
    let velocity = &mut workspace.velocity;
    match last {
        Last::Sweeps => workspace.kernel.velocities_into(problem, velocity),
        Last::Factor => problem.velocities_into(impulses, velocity),
    }
    report
}

fn attempt(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
) -> (Report, Last) {
    match params.kind {
        SolverKind::GaussSeidel => {
            let kernel = &mut workspace.kernel;
            let report = gauss_seidel::solve(problem, params, kernel, impulses);
            (report, Last::Sweeps)
        }
        SolverKind::Direct => (direct(problem, params, workspace, impulses), Last::Factor),
        SolverKind::Auto => auto(problem, params, workspace, impulses),
    }
}

impl Params {
    /// For a solve whose best iterate is taken.
    fn brief(&self) -> Self {
        Self {
            max_factorizations: self.max_factorizations.min(ACCEPT_FACTORIZATIONS),
            ..self.with_sweeps(self.max_sweeps.min(ACCEPT_SWEEPS))
        }
    }

    fn with_sweeps(&self, max_sweeps: usize) -> Self {
        Self {
            max_sweeps,
            ..*self
        }
    }
}

/// Goes on from impulses that do not satisfy the tolerances, and leaves the best of some.
fn best(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    (impulses, mut report): (&mut [Vec3], Report),
) -> Report {
    let tolerance = &params.tolerance;
    let mut best = Best::new(&report.residual, tolerance, impulses);
    let mut residual = report.residual;
    let few = params.with_sweeps(CHUNK);
    for _ in 0..CHUNKS {
        let more = gauss_seidel::solve(problem, &few, &mut workspace.kernel, impulses);
        if more.residual.excess(tolerance) < best.excess {
            residual = more.residual;
        }
        best.offer(&more.residual, tolerance, impulses);
        report = report.then(more);
        if more.converged {
            break;
        }
    }
    impulses.copy_from_slice(&best.impulses);
    if makes_energy(problem, impulses) {
        impulses.fill(Vec3::zeros());
        gauss_seidel::smooth(problem, PLAIN_SWEEPS, &mut workspace.kernel, impulses);
        report.sweeps += PLAIN_SWEEPS;
        residual = evaluate(problem, &Scale::of(problem), impulses);
    }
    report.residual = residual;
    report.converged = residual.within(tolerance);
    report
}

/// Whether impulses make energy that neither the motion nor what presses gives them: `p . ((u_0 + u)/2 + b + c p/2) > 0`, with `u_0` the
/// relative velocities without impulses. At a solution `p . (u + b + c p) <= 0`, and `p . u_0` is less than `p . u` by `p . W p`.
fn makes_energy(problem: &Problem, impulses: &[Vec3]) -> bool {
    let velocity = problem.velocities(impulses);
    let rows = problem.rows.iter().zip(impulses);
    let work = rows.map(|(row, p)| {
        let [free, after] =
            [&problem.free, &velocity].map(|velocity| row.relative_velocity(velocity));
        let p_n = p.dot(&row.normal);
        let springs =
            row.compliance_n * p_n * p_n + row.compliance_t * (p.norm_squared() - p_n * p_n);
        p.dot(&((free + after) * 0.5 + row.bias)) + 0.5 * springs
    });
    work.sum::<f64>() > 0.0
}

/// What a solution comes from: sweeps know its velocities.
enum Last {
    Sweeps,
    Factor,
}

/// The augmented-Lagrangian loop, and Newton on what it leaves.
fn direct(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
) -> Report {
    let report = augmented_lagrangian::solve(problem, params, workspace, impulses);
    match params.smoothing {
        0 => report,
        _ => finish_by_newton(problem, params, workspace, impulses, report).0,
    }
}

/// Gauss-Seidel, then Newton; what is too large for that goes on with sweeps, and what parts do not finish goes to the direct
/// solver.
fn auto(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
) -> (Report, Last) {
    let brief = params.with_sweeps(params.max_sweeps.min(AUTO_SWEEPS));
    let report = gauss_seidel::solve(problem, &brief, &mut workspace.kernel, impulses);
    if report.converged {
        return (report, Last::Sweeps);
    }
    let (report, large) = finish_by_newton(problem, params, workspace, impulses, report);
    if report.converged {
        (report, Last::Factor)
    } else if large {
        let rest = params.with_sweeps(params.max_sweeps.saturating_sub(report.sweeps));
        let kernel = &mut workspace.kernel;
        let rest = gauss_seidel::solve(problem, &rest, kernel, impulses);
        (report.then(rest), Last::Sweeps)
    } else {
        let direct = direct(problem, params, workspace, impulses);
        (report.then(direct), Last::Factor)
    }
}

/// Where a solver crawls or goes in circles: Newton on the neighbourhoods of the rows that it leaves, sweeps over the whole
/// after each. `report` is that of the first solver; at most `max_factorizations` more. Also whether it ended because what is
/// unsolved spreads over more than [`MOST_BODIES`].
fn finish_by_newton(
    problem: &Problem,
    params: &Params,
    workspace: &mut SolverWorkspace,
    impulses: &mut [Vec3],
    mut report: Report,
) -> (Report, bool) {
    let scales = Scale::of(problem);
    let most = report.factorizations + params.max_factorizations;
    let attempt = params.max_factorizations.div_ceil(ATTEMPTS);
    let mut rings = RINGS;
    while !report.converged && report.factorizations < most {
        let seeds = unsolved(problem, &scales, params, impulses);
        let part = LocalProblem::around(problem, impulses, seeds.into_iter(), rings);
        if part.problem.free.len() > MOST_BODIES {
            return (report, true);
        }
        let before = report.factorizations;
        let budget = (most - before).min(attempt);
        match solve_part(&part, params, budget, impulses) {
            Ok(newton) => report = report.then(newton),
            Err(broken) => {
                report.broken = Some(broken);
                break;
            }
        }
        report.residual = evaluate(problem, &scales, impulses);
        report.converged = report.residual.within(&params.tolerance);
        let left = params.max_sweeps.saturating_sub(report.sweeps);
        let stuck = left == 0 && report.factorizations == before;
        if report.converged || stuck {
            break;
        }
        let between = params.with_sweeps(BETWEEN.min(left));
        let kernel = &mut workspace.kernel;
        report = report.then(gauss_seidel::solve(problem, &between, kernel, impulses));
        rings *= 2;
    }
    (report, false)
}

/// The rows whose residuals exceed the tolerance.
fn unsolved(problem: &Problem, scales: &[Scale], params: &Params, impulses: &[Vec3]) -> Vec<usize> {
    let velocity = problem.velocities(impulses);
    let wanted = &params.tolerance;
    let unsolved = |&k: &usize| {
        let row = &problem.rows.get(k);
        let load = row.load(&problem.rows, impulses);
        let u = row.relative_velocity(&velocity);
        let natural_map = scales[k].natural_map(row, u, impulses[k], load);
        let [gap, slip, force] = scales[k].residuals(row, problem.step, &natural_map);
        !(gap <= wanted.gap && slip <= wanted.slip && force <= wanted.force)
    };
    (0..problem.rows.len()).filter(unsolved).collect()
}

/// Newton on a part of the problem, with at most `budget` factorizations.
///
/// # Errors
/// [`LinearError`] if a matrix cannot be factorized; the impulses are unchanged.
fn solve_part(
    part: &LocalProblem,
    params: &Params,
    budget: usize,
    impulses: &mut [Vec3],
) -> Result<Report, LinearError> {
    // What the part's border costs the whole must fit in as well.
    let share = if part.closed { 1.0 } else { 0.5 };
    let params = Params {
        tolerance: params.tolerance.scaled(share),
        max_factorizations: budget,
        ..*params
    };
    let mut own: Vec<Vec3> = part.rows.iter().map(|&k| impulses[k]).collect();
    let report = newton::solve(&part.problem, &params, &mut own)?;
    for (&k, p) in part.rows.iter().zip(&own) {
        impulses[k] = *p;
    }
    Ok(report)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::Law;
    use crate::solver::bodies::probe_row;
    use crate::spatial::SpatialVector;

    /// A sphere of 1 kg comes down on the ground with 2 m/s: impulses up to twice the one that stops it make no energy, larger ones do.
    #[test]
    fn impulses_that_are_too_large_make_energy() {
        let mut row = probe_row(Law::Contact { mu: 0.0 });
        (row.bias, row.compliance_n, row.compliance_t) = (Vec3::zeros(), 0.0, 0.0);
        row.normal = Vec3::z();
        let mut problem = Problem {
            step: 1e-3,
            ..Problem::default()
        };
        problem.free.push(SpatialVector {
            linear: Vec3::z() * -2.0,
            angular: Vec3::zeros(),
        });
        problem.inverse_mass.push(SpatialVector {
            linear: Vec3::repeat(1.0),
            angular: Vec3::repeat(2.5),
        });
        problem.rows = [row].into_iter().collect();
        for (impulse, makes) in [(0.0, false), (2.0, false), (3.999, false), (4.001, true)] {
            assert_eq!(
                makes_energy(&problem, &[Vec3::z() * impulse]),
                makes,
                "{impulse}"
            );
        }
    }
}
