//! The study of S. A. R. Beyabanaki, A. C. Bagtzoglou, *Modified contact constraints in sphere-based 3-D DDA*, 2020: both
//! examples, both integrators, augmented Lagrangian beside penalty, and the claims of the text as numbers.

pub mod beyond;
pub mod column;
pub mod conditioning;
pub mod held;
pub mod overlap;
mod pictures;
mod sections;
pub mod stepping;
mod study;
mod text;

use sphere_dda::integrator::Integrator;
use sphere_dda::scene::Method;

pub use study::Options;
use study::{STACKS, StackRow, Study};

use crate::error::ReportError;
use crate::folder::Folder;
use crate::{Watch, parallel};
use column::{Column, Stop};
use held::{Held, Outcome};
use stepping::{Case, Example, Record, simulate};

/// Runs the study and writes it: `paper.md`, and below `paper/` its drawings (SVG) and tables (CSV).
///
/// # Errors
/// What a case that must run says, or [`ReportError::Interrupted`].
pub fn study(options: &Options, watch: &dyn Watch) -> Result<Folder, ReportError> {
    let end = |example: Example| {
        let last = example.printed().iter().copied().fold(0.0, f64::max);
        last * options.duration
    };
    let records = records(options, &end, watch)?;
    let mut sweeps = Vec::new();
    for example in Example::ALL {
        let frozen = records.iter().find_map(|record| {
            let case = record.case;
            let wanted = case.example == example && case.method == Method::Alm;
            record.problem.as_ref().filter(|_| wanted)
        });
        if let Some(problem) = frozen {
            let until = example.compared().min(end(example));
            let points = conditioning::study(example, problem, until, options.threads, watch)?;
            sweeps.push((example, points));
        }
    }
    let study = Study {
        duration: options.duration,
        records,
        sweeps,
        stacks: stacks(options, watch)?,
        held: held(options, &end, watch)?,
    };
    sections::write(&study)
}

/// Both examples, both integrators, both methods.
fn records(
    options: &Options,
    end: &(dyn Fn(Example) -> f64 + Sync),
    watch: &dyn Watch,
) -> Result<Vec<Record>, ReportError> {
    let mut jobs = Vec::new();
    for example in Example::ALL {
        for integrator in [Integrator::Shi, Integrator::Moreau] {
            for method in [Method::Alm, Method::Penalty] {
                jobs.push(move || {
                    let case = Case {
                        example,
                        integrator,
                        method,
                        factor: 1.0,
                        end: end(example),
                    };
                    let record = simulate(case, watch)?;
                    watch.note(&format!("{}: {} steps", case.name(), record.steps));
                    Ok(record)
                });
            }
        }
    }
    parallel::run(options.threads, jobs).into_iter().collect()
}

/// Stacks at held penalties; a trial leaves out those that need more than ten thousand augmentations.
fn stacks(options: &Options, watch: &dyn Watch) -> Result<Vec<StackRow>, ReportError> {
    let mut jobs = Vec::new();
    for example in Example::ALL {
        for spheres in STACKS {
            let column = Column::of(example, spheres)?;
            for factor in column::FACTORS {
                let p = factor * column.penalty;
                if options.duration < 1.0 && column.predicted(p, Stop::Force) > 1e4 {
                    continue;
                }
                jobs.push(move || {
                    if watch.stop() {
                        return Err(ReportError::Interrupted);
                    }
                    let counted = column.counted(p)?;
                    let row = StackRow {
                        example,
                        spheres,
                        factor,
                        contraction: column.contraction(p),
                        gap: (column.predicted(p, Stop::Gap), counted.gap),
                        force: (column.predicted(p, Stop::Force), counted.force),
                        error: counted.error,
                        adapted: column.adapted(p)?,
                        penalty: column.penalty_overlap(p)?,
                    };
                    let name = example.name();
                    watch.note(&format!(
                        "{name}: stack of {spheres} at {factor} P, {} augmentations",
                        counted.force
                    ));
                    Ok(row)
                });
            }
        }
    }
    parallel::run(options.threads, jobs).into_iter().collect()
}

fn held(
    options: &Options,
    end: &(dyn Fn(Example) -> f64 + Sync),
    watch: &dyn Watch,
) -> Result<Vec<(Held, Outcome)>, ReportError> {
    let mut jobs = Vec::new();
    for example in Example::ALL {
        for factor in column::FACTORS {
            let largest = factor == column::FACTORS[column::FACTORS.len() - 1];
            for friction in [true, false] {
                if !friction && !largest {
                    continue;
                }
                let held = Held {
                    example,
                    factor,
                    friction,
                };
                jobs.push(move || {
                    let outcome = held.run(end(example), watch)?;
                    watch.note(&format!("{}: penalty held at {factor} P", example.name()));
                    Ok((held, outcome))
                });
            }
        }
    }
    parallel::run(options.threads, jobs).into_iter().collect()
}
