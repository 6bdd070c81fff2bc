//! Contact problems of others, and steps that `--dump-failed` wrote, solved by every solver in double precision.
//!
//! [`read()`] reads a file, [`solve`] solves it by one solver and takes the time, [`table`] sets the outcomes side by side. The measure
//! is Siconos' own ([`FrictionProblem::error`](sphere_dda::problem::friction::FrictionProblem::error)).

mod global;
mod matrix;
mod read;
mod tokens;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

pub use read::{CorpusError, Read, read};
use sphere_dda::Vec3;
use sphere_dda::solver::friction::{self, FrictionParams, FrictionReport, FrictionSolver};

use crate::table::Table;

/// Time for which a short solve is repeated; the shortest counts.
const REPEATED: Duration = Duration::from_millis(50);
/// Most repetitions.
const TIMES: usize = 20;

/// What a solver made of a problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Which solver.
    pub solver: FrictionSolver,
    /// Error, iterations, verdict.
    pub report: FrictionReport,
    /// Impulses, `[C]` \[N s\].
    pub impulses: Vec<Vec3>,
    /// Wall time on one thread \[s\], the shortest of some.
    pub seconds: f64,
}

/// A problem and what the solvers made of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// File name without ending.
    pub name: String,
    /// The problem.
    pub read: Read,
    /// One for each solver.
    pub outcomes: Vec<Outcome>,
}

/// The files of `paths`: files as they are, of folders those that end with `.dat` in order of their names.
///
/// # Errors
/// [`CorpusError::Disk`], [`CorpusError::Empty`].
pub fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, CorpusError> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let refuse = |error| CorpusError::Disk {
            path: path.clone(),
            error,
        };
        let entries = std::fs::read_dir(path).map_err(refuse)?;
        let mut own = Vec::new();
        for entry in entries {
            let file = entry.map_err(refuse)?.path();
            if file.extension() == Some(OsStr::new("dat")) {
                own.push(file);
            }
        }
        if own.is_empty() {
            return Err(CorpusError::Empty(path.clone()));
        }
        own.sort();
        files.append(&mut own);
    }
    Ok(files)
}

/// File name without the ending `.dat`.
#[must_use]
pub fn name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.trim_end_matches(".dat").to_owned()
}

/// Solves a problem from rest.
#[must_use]
pub fn solve(read: &Read, solver: FrictionSolver, params: &FrictionParams) -> Outcome {
    let began = Instant::now();
    let mut best = once(read, solver, params);
    for _ in 1..TIMES {
        if began.elapsed() > REPEATED {
            break;
        }
        let again = once(read, solver, params);
        best.seconds = best.seconds.min(again.seconds);
    }
    best
}

fn once(read: &Read, solver: FrictionSolver, params: &FrictionParams) -> Outcome {
    let mut impulses = vec![Vec3::zeros(); read.problem.contacts()];
    let began = Instant::now();
    let report = friction::solve(&read.problem, solver, params, &mut impulses);
    Outcome {
        solver,
        report,
        impulses,
        seconds: began.elapsed().as_secs_f64(),
    }
}

/// A row for each problem and solver.
#[must_use]
pub fn table(cases: &[Case]) -> Table {
    let headings = [
        "problem",
        "contacts",
        "solver",
        "error",
        "sweeps",
        "factorizations",
        "time (ms)",
    ];
    let mut table = Table::new(&headings);
    for case in cases {
        for outcome in &case.outcomes {
            let FrictionReport {
                converged,
                error,
                sweeps,
                factorizations,
                ..
            } = outcome.report;
            let mark = if converged { "" } else { " (unsolved)" };
            table.row([
                case.name.clone(),
                case.read.problem.contacts().to_string(),
                outcome.solver.name().to_owned(),
                format!("{error:.1e}{mark}"),
                sweeps.to_string(),
                factorizations.to_string(),
                format!("{:.4}", 1e3 * outcome.seconds),
            ]);
        }
    }
    table
}

/// How many of the problems each solver solves, and its median time \[s\].
#[must_use]
pub fn summary(cases: &[Case]) -> Vec<(FrictionSolver, usize, f64)> {
    let of = |solver: FrictionSolver| {
        let all = cases.iter().flat_map(|case| &case.outcomes);
        let own: Vec<&Outcome> = all.filter(|outcome| outcome.solver == solver).collect();
        let solved = own.iter().filter(|outcome| outcome.report.converged);
        let mut times: Vec<f64> = own.iter().map(|outcome| outcome.seconds).collect();
        times.sort_by(f64::total_cmp);
        let median = times.get(times.len() / 2).copied()?;
        Some((solver, solved.count(), median))
    };
    FrictionSolver::ALL.into_iter().filter_map(of).collect()
}

mod tests;
