//! `sphere-dda corpus PATH...`: contact problems of others, and dumped steps, solved by every solver.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use miette::miette;
use sphere_dda::formats::problem;
use sphere_dda::solver::friction::{FrictionParams, FrictionSolver};
use sphere_dda_studies::corpus::{self, Case, CorpusError, Outcome};

use crate::failure::Failure;
use crate::progress::{Interrupt, count, note, print};

/// Arguments of `corpus`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  sphere-dda corpus siconos/numerics/src/FrictionContact/test/data
  sphere-dda corpus failed-steps --solver all
  sphere-dda corpus step-0001.dat --solver newton --tolerance 1e-12 -o solved

Reads Siconos' text format, local and global, in two and three dimensions; fclib's HDF5 after benches/corpus/convert.py. The error
is Siconos' own, relative to the largest norm of q, impulses and velocities. Exit code 1 if a problem is solved by none of the solvers.")]
pub(crate) struct Corpus {
    /// Problem files, or folders of files that end with .dat.
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Solver, or `all`.
    #[arg(long, value_parser = solvers(), default_value = "auto")]
    solver: Solvers,
    /// Error to reach [-].
    #[arg(long, value_name = "ERROR", value_parser = tolerance, default_value = "1e-8")]
    tolerance: f64,
    /// Most sweeps of Gauss-Seidel.
    #[arg(long, value_name = "N", default_value_t = FrictionParams::default().max_sweeps)]
    max_sweeps: usize,
    /// Most factorizations.
    #[arg(long, value_name = "N", default_value_t = FrictionParams::default().max_factorizations)]
    max_factorizations: usize,
    /// Folder for corpus.csv, and of every problem its local form in three dimensions (NAME.dat) and the impulses
    /// (NAME.SOLVER.txt: normal and two tangents of a contact on each line).
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Some solvers.
#[derive(Debug, Clone)]
struct Solvers(Vec<FrictionSolver>);

fn solvers() -> impl TypedValueParser<Value = Solvers> {
    let names = FrictionSolver::ALL.map(FrictionSolver::name);
    let parser = PossibleValuesParser::new(names.into_iter().chain(["all"]));
    parser.map(|name| {
        let all = FrictionSolver::ALL.into_iter();
        Solvers(
            all.filter(|one| name == "all" || one.name() == name)
                .collect(),
        )
    })
}

fn tolerance(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if value > 0.0 && value < 1.0 => Ok(value),
        _ => Err("expected a number greater than 0 and less than 1".to_owned()),
    }
}

/// Solves the problems and prints a table.
///
/// # Errors
/// Files that cannot be read or written, problems that no solver solves, or Ctrl-C.
pub(crate) fn run(arguments: &Corpus, interrupt: &Interrupt) -> Result<(), Failure> {
    let params = FrictionParams {
        tolerance: arguments.tolerance,
        max_sweeps: arguments.max_sweeps,
        max_factorizations: arguments.max_factorizations,
    };
    let (mut cases, mut refused) = (Vec::new(), Vec::new());
    for path in corpus::files(&arguments.paths)? {
        let read = match corpus::read(&path) {
            Ok(read) => read,
            Err(error) => {
                refused.push(error);
                continue;
            }
        };
        let mut outcomes = Vec::new();
        for &solver in &arguments.solver.0 {
            if interrupt.requested() {
                return Err(Failure::Interrupted);
            }
            outcomes.push(corpus::solve(&read, solver, &params));
        }
        let case = Case {
            name: corpus::name(&path),
            read,
            outcomes,
        };
        if let Some(folder) = &arguments.output {
            write(folder, &case, &path)?;
        }
        cases.push(case);
    }
    report(&cases, arguments.output.as_deref())?;
    verdict(&cases, &refused, arguments)
}

fn report(cases: &[Case], folder: Option<&Path>) -> Result<(), Failure> {
    let table = corpus::table(cases);
    if let Some(folder) = folder {
        let path = folder.join("corpus.csv");
        std::fs::write(&path, table.csv("corpus")?).map_err(disk(&path))?;
    }
    print(|out| {
        write!(out, "{}", table.markdown())?;
        writeln!(out)?;
        for (solver, solved, median) in corpus::summary(cases) {
            writeln!(
                out,
                "{:<16}{solved} of {} solved, median time {:.3} ms",
                solver.name(),
                count(cases.len() as u64, "problem"),
                1e3 * median
            )?;
        }
        Ok(())
    })
}

/// A file that was named must be readable; in a folder others may lie about, as long as one is a problem.
fn verdict(cases: &[Case], refused: &[CorpusError], arguments: &Corpus) -> Result<(), Failure> {
    for error in refused {
        note(format_args!("not read: {error}"));
    }
    let named = arguments.paths.iter().all(|path| !path.is_dir());
    if !refused.is_empty() && (named || cases.is_empty()) {
        return Err(Failure::Input(miette!(
            "{} not read: see above",
            count(refused.len() as u64, "file")
        )));
    }
    let solved = |case: &&Case| !case.outcomes.iter().any(|outcome| outcome.report.converged);
    let unsolved: Vec<&str> = cases
        .iter()
        .filter(solved)
        .map(|case| case.name.as_str())
        .collect();
    match unsolved.is_empty() {
        true => Ok(()),
        false => Err(Failure::Run(miette!(
            "{} of {} not solved to {:e}: {}; try --solver all, more --max-sweeps or --max-factorizations",
            unsolved.len(),
            count(cases.len() as u64, "problem"),
            arguments.tolerance,
            unsolved.join(", ")
        ))),
    }
}

/// The local form of a problem, and its impulses.
fn write(folder: &Path, case: &Case, source: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(disk(folder))?;
    let notes = [format!("read from {}", source.display())];
    let path = folder.join(format!("{}.dat", case.name));
    problem::write(&path, &case.read.problem, &notes).map_err(Failure::input)?;
    for Outcome {
        solver, impulses, ..
    } in &case.outcomes
    {
        let mut text = String::new();
        for p in impulses {
            let _ = writeln!(text, "{:e} {:e} {:e}", p.x, p.y, p.z);
        }
        let path = folder.join(format!("{}.{}.txt", case.name, solver.name()));
        std::fs::write(&path, text).map_err(disk(&path))?;
    }
    Ok(())
}

fn disk(path: &Path) -> impl FnOnce(std::io::Error) -> Failure {
    let place = path.display().to_string();
    move |error| Failure::Input(miette!("cannot write `{place}`: {error}"))
}

impl From<CorpusError> for Failure {
    fn from(error: CorpusError) -> Self {
        Self::Input(miette!("{error}"))
    }
}
