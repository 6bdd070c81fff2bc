//! The solvers on contacts without bodies ([`FrictionProblem`]): problems of others, and steps dumped for study.
//!
//! The law is that of `problem::law` and the answers of contacts are those of the step's own solvers; what is different
//! is that `W` comes as blocks. All work in double precision until Siconos' measure ([`FrictionProblem::error`]) reaches the
//! tolerance.

mod gauss_seidel;
mod proximal;
mod report;

use crate::Vec3;
use crate::linalg::LinearError;
use crate::problem::friction::FrictionProblem;
use proximal::{Discs, Proximal};
pub use report::FrictionReport;
use report::Goal;

/// Sweeps that `auto` begins with, and after each try that factorizes.
const FIRST_SWEEPS: usize = 400;
const MORE_SWEEPS: usize = 400;
/// First `kappa` of each try of Newton in turn: large ones take few factorizations where they succeed.
const STARTS: [f64; 4] = [1e3, 30.0, 1.0, 1e5];
/// What `auto` tries in turn.
const TRIES: [(Discs, f64); 4] = [
    (Discs::True, 1e3),
    (Discs::Held, PENALTY),
    (Discs::True, 30.0),
    (Discs::True, 1.0),
];
/// First `kappa` of the augmented-Lagrangian loop, and its sweeps between.
const PENALTY: f64 = 30.0;
const SMOOTHING: usize = 60;
/// Factorizations of one try.
const TRY: usize = 150;

/// Which solver takes a friction problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrictionSolver {
    /// Gauss-Seidel first; Newton, the augmented-Lagrangian loop and sweeps in turn on what it leaves.
    Auto,
    /// Block Gauss-Seidel with momentum.
    GaussSeidel,
    /// Augmented-Lagrangian loop with held discs, sweeps between.
    Direct,
    /// Proximal Newton on the true cone.
    Newton,
}

impl FrictionSolver {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Auto, Self::GaussSeidel, Self::Direct, Self::Newton];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::GaussSeidel => "gauss-seidel",
            Self::Direct => "direct",
            Self::Newton => "newton",
        }
    }
}

/// What a solver of friction problems is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionParams {
    /// Siconos' measure to reach \[-\].
    pub tolerance: f64,
    /// Most sweeps of Gauss-Seidel.
    pub max_sweeps: usize,
    /// Most factorizations.
    pub max_factorizations: usize,
}

impl Default for FrictionParams {
    fn default() -> Self {
        Self {
            tolerance: 1e-8,
            max_sweeps: 20_000,
            max_factorizations: 1000,
        }
    }
}

/// Solves `problem` from the impulses given and leaves the best that were found in them, `[C]` \[N s\].
pub fn solve(
    problem: &FrictionProblem,
    solver: FrictionSolver,
    params: &FrictionParams,
    impulses: &mut [Vec3],
) -> FrictionReport {
    let goal = Goal {
        tolerance: params.tolerance,
    };
    if problem.error(impulses) <= goal.tolerance {
        return FrictionReport::default().close(problem, goal, impulses);
    }
    match solver {
        FrictionSolver::GaussSeidel => {
            gauss_seidel::solve(problem, goal, params.max_sweeps, impulses)
        }
        FrictionSolver::Newton => newton(problem, goal, params.max_factorizations, impulses),
        FrictionSolver::Direct => direct(problem, goal, params, impulses),
        FrictionSolver::Auto => auto(problem, goal, params, impulses),
    }
}

/// Newton from one `kappa` after the other.
fn newton(
    problem: &FrictionProblem,
    goal: Goal,
    most: usize,
    impulses: &mut [Vec3],
) -> FrictionReport {
    let mut proximal = match Proximal::of(problem, Discs::True) {
        Ok(proximal) => proximal,
        Err(broken) => return broken_off(problem, goal, impulses, broken),
    };
    let mut report = FrictionReport::default().close(problem, goal, impulses);
    for kappa in STARTS.into_iter().cycle() {
        let left = most.saturating_sub(report.factorizations).min(TRY);
        let before = (report.factorizations, report.error);
        if report.converged || left == 0 {
            break;
        }
        match proximal.solve(goal, (kappa, left), impulses, |_| 0) {
            Ok(next) => report = report.then(next),
            Err(broken) => report.broken = Some(broken),
        }
        if before == (report.factorizations, report.error) {
            break;
        }
    }
    report
}

/// The augmented-Lagrangian loop with sweeps between, then Newton.
fn direct(
    problem: &FrictionProblem,
    goal: Goal,
    params: &FrictionParams,
    impulses: &mut [Vec3],
) -> FrictionReport {
    let mut proximal = match Proximal::of(problem, Discs::Held) {
        Ok(proximal) => proximal,
        Err(broken) => return broken_off(problem, goal, impulses, broken),
    };
    let smooth = |p: &mut [Vec3]| gauss_seidel::solve(problem, goal, SMOOTHING, p).sweeps;
    let most = params.max_factorizations;
    let report = match proximal.solve(goal, (PENALTY, most), impulses, smooth) {
        Ok(report) => report,
        Err(broken) => broken_off(problem, goal, impulses, broken),
    };
    match report.converged {
        true => report,
        false => report.then(newton(problem, goal, most, impulses)),
    }
}

/// Gauss-Seidel, and where it crawls the solvers that factorize, in turn.
fn auto(
    problem: &FrictionProblem,
    goal: Goal,
    params: &FrictionParams,
    impulses: &mut [Vec3],
) -> FrictionReport {
    let brief = FIRST_SWEEPS.min(params.max_sweeps);
    let mut report = gauss_seidel::solve(problem, goal, brief, impulses);
    if report.converged {
        return report;
    }
    let mut proximal = match Proximal::of(problem, Discs::True) {
        Ok(proximal) => proximal,
        Err(broken) => {
            report.broken = Some(broken);
            let left = params.max_sweeps.saturating_sub(report.sweeps);
            return report.then(gauss_seidel::solve(problem, goal, left, impulses));
        }
    };
    for (discs, kappa) in TRIES.into_iter().cycle() {
        let left = params
            .max_factorizations
            .saturating_sub(report.factorizations);
        if report.converged || left == 0 {
            break;
        }
        proximal.discs = discs;
        let smooth = |p: &mut [Vec3]| match discs {
            Discs::True => 0,
            Discs::Held => gauss_seidel::solve(problem, goal, SMOOTHING, p).sweeps,
        };
        match proximal.solve(goal, (kappa, left.min(TRY)), impulses, smooth) {
            Ok(next) => report = report.then(next),
            Err(broken) => report.broken = Some(broken),
        }
        let left = params.max_sweeps.saturating_sub(report.sweeps);
        if report.converged || left == 0 {
            break;
        }
        let sweeps = MORE_SWEEPS.min(left);
        report = report.then(gauss_seidel::solve(problem, goal, sweeps, impulses));
    }
    report
}

fn broken_off(
    problem: &FrictionProblem,
    goal: Goal,
    impulses: &[Vec3],
    broken: LinearError,
) -> FrictionReport {
    FrictionReport {
        broken: Some(broken),
        ..FrictionReport::default().close(problem, goal, impulses)
    }
}
