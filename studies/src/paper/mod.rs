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
use crate::{Part, Watch, parallel};
use column::{Column, Stop};
use held::Held;
use stepping::{Case, Example, simulate};

/// Runs the study and writes it: `paper.md`, and below `paper/` its drawings (SVG) and tables (CSV).
///
/// # Errors
/// What a case that must run says, or [`ReportError::Interrupted`].
pub fn study(options: &Options, watch: &dyn Watch) -> Result<Folder, ReportError> {
    let end = |example: Example| example.end() * options.duration;
    let compared = |example: Example| example.compared().min(end(example));
    let (cases, stacks, held) = (cases(&end), stacks(options)?, held());
    let sweep = |example| {
        conditioning::DECADES.len() as f64 * conditioning::cost(example, compared(example))
    };
    watch.plan(
        cases.iter().map(Case::cost).sum::<f64>()
            + Example::ALL.map(sweep).iter().sum::<f64>()
            + stacks.iter().map(Stack::cost).sum::<f64>()
            + held.iter().map(|h| h.cost(end(h.example))).sum::<f64>(),
    );
    let threads = options.threads;
    let records = parallel::all(threads, cases, |case| {
        let record = simulate(case, &Part::new(watch, case.cost()))?;
        watch.note(&format!("{}: {} steps", case.name(), record.steps));
        Ok(record)
    })?;
    let mut sweeps = Vec::new();
    for example in Example::ALL {
        let frozen = records.iter().find_map(|record| {
            let case = record.case;
            let wanted = case.example == example && case.method == Method::Alm;
            record.problem.as_ref().filter(|_| wanted)
        });
        if let Some(problem) = frozen {
            let points = conditioning::study(example, problem, compared(example), threads, watch)?;
            sweeps.push((example, points));
        }
    }
    let study = Study {
        duration: options.duration,
        records,
        sweeps,
        stacks: parallel::all(threads, stacks, |stack| stack.count(watch))?,
        held: parallel::all(threads, held, |held| {
            let end = end(held.example);
            let outcome = held.run(end, &Part::new(watch, held.cost(end)))?;
            let Held {
                example, factor, ..
            } = held;
            watch.note(&format!("{}: penalty held at {factor} P", example.name()));
            Ok((held, outcome))
        })?,
    };
    sections::write(&study)
}

/// Both examples, both integrators, both methods.
fn cases(end: &dyn Fn(Example) -> f64) -> Vec<Case> {
    let mut cases = Vec::new();
    for example in Example::ALL {
        for integrator in [Integrator::Shi, Integrator::Moreau] {
            cases.extend([Method::Alm, Method::Penalty].map(|method| Case {
                example,
                integrator,
                method,
                factor: 1.0,
                end: end(example),
            }));
        }
    }
    cases
}

/// A stack at a held penalty.
struct Stack {
    example: Example,
    spheres: usize,
    factor: f64,
    column: Column,
}

/// Stacks at held penalties; a trial leaves out those that need more than ten thousand augmentations.
fn stacks(options: &Options) -> Result<Vec<Stack>, ReportError> {
    let mut stacks = Vec::new();
    for example in Example::ALL {
        for spheres in STACKS {
            let column = Column::of(example, spheres)?;
            stacks.extend(column::FACTORS.map(|factor| Stack {
                example,
                spheres,
                factor,
                column,
            }));
        }
    }
    let short = |s: &Stack| s.column.predicted(s.penalty(), Stop::Force) <= 1e4;
    stacks.retain(|stack| options.duration >= 1.0 || short(stack));
    Ok(stacks)
}

impl Stack {
    /// Penalty \[N/m\].
    fn penalty(&self) -> f64 {
        self.factor * self.column.penalty
    }

    fn cost(&self) -> f64 {
        self.column.cost(self.penalty())
    }

    fn count(&self, watch: &dyn Watch) -> Result<StackRow, ReportError> {
        if watch.stop() {
            return Err(ReportError::Interrupted);
        }
        let _part = Part::new(watch, self.cost());
        let (column, p) = (self.column, self.penalty());
        let counted = column.counted(p)?;
        let row = StackRow {
            example: self.example,
            spheres: self.spheres,
            factor: self.factor,
            contraction: column.contraction(p),
            gap: (column.predicted(p, Stop::Gap), counted.gap),
            force: (column.predicted(p, Stop::Force), counted.force),
            error: counted.error,
            adapted: column.adapted(p)?,
            penalty: column.penalty_overlap(p)?,
        };
        let (
            name,
            Self {
                spheres, factor, ..
            },
        ) = (self.example.name(), self);
        watch.note(&format!(
            "{name}: stack of {spheres} at {factor} P, {} augmentations",
            counted.force
        ));
        Ok(row)
    }
}

/// Both examples at every penalty, and at the largest without friction.
fn held() -> Vec<Held> {
    let mut list = Vec::new();
    for example in Example::ALL {
        for factor in column::FACTORS {
            let largest = factor == column::FACTORS[column::FACTORS.len() - 1];
            for friction in [true, false] {
                if friction || largest {
                    list.push(Held {
                        example,
                        factor,
                        friction,
                    });
                }
            }
        }
    }
    list
}
