//! The paper's claim of ill-conditioning: `kappa(K)` of a frozen step against the penalty, beside the overlap that the same
//! penalty leaves.

use sphere_dda::Vec3;
use sphere_dda::integrator::Integrator;
use sphere_dda::linalg::{Condition, Symbolic};
use sphere_dda::problem::Problem;
use sphere_dda::scene::Method;
use sphere_dda::solver::augmented_lagrangian::{SolverWorkspace, stiffness};
use sphere_dda::solver::{Params, SMOOTHING, solve};
use sphere_dda::solver::{SolverKind, Tolerance};

use super::stepping::{Case, Example, Record, simulate};
use crate::error::ReportError;
use crate::{Part, Watch, parallel};

/// Factors on the paper's penalty: six decades.
pub const DECADES: [f64; 7] = [1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3];

/// One penalty of the study.
#[derive(Debug, Clone)]
pub struct Point {
    /// Factor on the paper's penalty.
    pub factor: f64,
    /// Condition number of `K` with the contacts that carry load \[-\]; `None` if its Cholesky factor does not exist.
    pub condition: Option<f64>,
    /// The penalty method's run, to the time given.
    pub penalty: Record,
    /// The augmented-Lagrangian run from that penalty, to the time given.
    pub alm: Record,
}

/// Condition number \[-\] of `K` at `penalty` \[N/m\], with the contacts of `problem` that carry load.
#[must_use]
pub fn condition(problem: &Problem, penalty: f64) -> Option<f64> {
    let mut impulses = vec![Vec3::zeros(); problem.rows.len()];
    let params = Params {
        kind: SolverKind::Direct,
        tolerance: Tolerance::default(),
        accept: false,
        min_sweeps: 1,
        max_sweeps: 10_000,
        max_factorizations: 1000,
        penalty,
        adapt_penalty: true,
        smoothing: SMOOTHING,
    };
    // Which contacts carry load is what is wanted; the last digits of the load are not.
    solve(
        problem,
        &params,
        &mut SolverWorkspace::default(),
        &mut impulses,
    );
    let matrix = stiffness(problem, penalty, &impulses);
    let factor = Symbolic::new(matrix.pattern())
        .and_then(|symbolic| symbolic.factorize(&matrix))
        .ok()?;
    Some(Condition::of(&matrix, &factor).number())
}

/// What one penalty costs until `end` \[s\], both methods, in seconds of one core as recorded.
#[must_use]
pub fn cost(example: Example, end: f64) -> f64 {
    let whole = match example {
        Example::Funnel => 4.0,
        Example::Slopes => 10.0,
    };
    whole * end / example.compared()
}

/// The study of one example; `problem` is the frozen step.
///
/// # Errors
/// As [`simulate`].
pub fn study(
    example: Example,
    problem: &Problem,
    end: f64,
    threads: usize,
    watch: &dyn Watch,
) -> Result<Vec<Point>, ReportError> {
    let base = example.scene()?.settings.penalty.unwrap_or(f64::NAN);
    let jobs: Vec<_> = DECADES
        .iter()
        .map(|&factor| {
            move || {
                let run = |method| {
                    let case = Case {
                        example,
                        integrator: Integrator::Shi,
                        method,
                        factor,
                        end,
                    };
                    simulate(case, &Part::new(watch, 0.5 * cost(example, end)))
                };
                let point = Point {
                    factor,
                    condition: condition(problem, factor * base),
                    penalty: run(Method::Penalty)?,
                    alm: run(Method::Alm)?,
                };
                watch.note(&format!("{}: penalty {factor} P", example.name()));
                Ok(point)
            }
        })
        .collect();
    parallel::run(threads, jobs).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::column::Column;

    /// One sphere on a floor without friction under load: K = diag(2 m, 2 m, 2 m + P dt^2, 2 I, 2 I, 2 I), and
    /// I = 2/5 m R^2 < m for R < 1 m: kappa = (2 m + P dt^2)/(2 I). Friction stiffens two tangents and the rotations
    /// they turn, so the closed form holds for mu = 0.
    #[test]
    fn one_sphere_has_its_closed_form() {
        let column = Column::of(Example::Funnel, 1).expect("the example");
        let (m, r, dt) = (column.mass(), column.radius, column.step);
        let problem = column.problem().expect("it starts");
        for p in [1e2, 1e5, 1e8, 1e11] {
            let closed = (2.0 * m + p * dt * dt) / (0.8 * m * r * r);
            let found = condition(&problem, p).expect("a factor");
            // Eigenvalues 2 m and 2 m + P dt^2 that nearly agree are taken for one.
            assert!(
                (found / closed - 1.0).abs() < 1e-4,
                "{p:e}: {found} {closed}"
            );
        }
    }
}
