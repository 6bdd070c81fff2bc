//! Proximal steps on the impulses, each by Newton's method: the two solvers that factorize, without bodies.
//!
//! For impulses `p` held, each contact answers a velocity with `p^(u)`, its law at the trial impulse `p - S u`; the step solves
//!
//! ```text
//! x = p^(W x + q)            by Newton: (1 + T W) dx = p^ - x,   T = -dp^/du
//! ```
//!
//! and takes `p <- x`. `S = kappa / w`: the larger `kappa`, the fewer steps and the harder is each. With the discs of friction
//! as wide as the normal impulse of the answer itself this is [`crate::solver::newton`]; with those of the held impulses, the inner
//! problem of [`crate::solver::augmented_lagrangian`]. Same answers, same loop, without bodies: `1 + T W` in contact space has
//! the solutions of `A + J^T T J`.

use nalgebra::Matrix3;

use super::report::{FrictionReport, Goal};
use crate::Vec3;
use crate::linalg::{GeneralMatrix, LinearError};
use crate::problem::friction::FrictionProblem;
use crate::problem::{Row, bounding_scale};
use crate::solver::augmented_lagrangian::augmented;
use crate::solver::newton::row_response;

/// Growth of `kappa` after a success, and the least growth after failures.
const GROWTH: [f64; 2] = [4.0, 1.3];
/// Newton iterations for one proximal step.
const ITERATIONS: usize = 30;
/// Smallest step of the line search.
const SHORTEST: f64 = 1e-4;
/// What is left of a proximal step over its start or over the impulses at which it counts, and at which Newton stops.
const COUNTS: f64 = 1e-9;
const BALANCED: f64 = 1e-14;

/// How wide the discs of friction are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Discs {
    /// By the normal impulse of the answer: the true cone.
    True,
    /// By the normal impulse that is held: symmetric, convex (Tresca).
    Held,
}

/// What does not change while a problem is solved.
pub(super) struct Proximal<'a> {
    problem: &'a FrictionProblem,
    rows: Vec<Row>,
    /// `1/w_n` of each contact \[kg\].
    stiffness: Vec<f64>,
    matrix: GeneralMatrix<3>,
    pub(super) discs: Discs,
}

/// Answers of all contacts at impulses `x`.
struct Iterate {
    impulses: Vec<Vec3>,
    answers: Vec<Vec3>,
    tangents: Vec<Matrix3<f64>>,
    /// `sum w |x - p^|^2`, its root.
    merit: f64,
}

impl<'a> Proximal<'a> {
    /// # Errors
    /// [`LinearError::Memory`] if the factor does not fit into memory.
    pub(super) fn of(problem: &'a FrictionProblem, discs: Discs) -> Result<Self, LinearError> {
        let all = 0..problem.contacts();
        let pairs = all.clone().flat_map(|k| {
            let columns = problem.row(k).map(|(j, _)| j);
            columns.map(move |j| (k as u32, j as u32))
        });
        let pairs: Vec<(u32, u32)> = pairs.filter(|(k, j)| k != j).collect();
        let rows: Vec<Row> = all.clone().map(|k| problem.law_row(k)).collect();
        let stiffness = all.map(|k| match bounding_scale(problem.own(k), Vec3::x()).0 {
            w if w > 0.0 => 1.0 / w,
            _ => 1.0,
        });
        Ok(Self {
            stiffness: stiffness.collect(),
            matrix: GeneralMatrix::new(rows.len(), pairs)?,
            problem,
            rows,
            discs,
        })
    }

    fn at(&self, held: &[Vec3], kappa: f64, impulses: Vec<Vec3>) -> Iterate {
        let (mut answers, mut tangents) = (Vec::new(), Vec::new());
        let mut merit = 0.0;
        for (k, row) in self.rows.iter().enumerate() {
            let u = self.problem.velocity(k, &impulses);
            let s = kappa * self.stiffness[k];
            let (answer, tangent) = match self.discs {
                Discs::True => {
                    let response = row_response(row, u, held[k], s, None);
                    (response.impulse, response.tangent)
                }
                Discs::Held => {
                    let answer = augmented(row, u, held[k], s, held[k].x.max(0.0));
                    (answer.impulse, answer.tangent)
                }
            };
            merit += (impulses[k] - answer).norm_squared() / self.stiffness[k];
            answers.push(answer);
            tangents.push(tangent);
        }
        Iterate {
            impulses,
            answers,
            tangents,
            merit: merit.sqrt(),
        }
    }

    fn norm(&self, impulses: &[Vec3]) -> f64 {
        let squares = impulses.iter().zip(&self.stiffness);
        squares
            .map(|(p, s)| p.norm_squared() / s)
            .sum::<f64>()
            .sqrt()
    }

    /// One proximal step from `held`; whether it is balanced.
    fn step(
        &mut self,
        held: &[Vec3],
        kappa: f64,
        report: &mut FrictionReport,
        most: usize,
    ) -> Result<(Vec<Vec3>, bool), LinearError> {
        let mut now = self.at(held, kappa, held.to_vec());
        let worst = now.merit;
        for _ in 0..ITERATIONS {
            let size = self.norm(&now.answers);
            if now.merit <= BALANCED * size || report.factorizations >= most {
                break;
            }
            let step = self.direction(&now)?;
            report.factorizations += 1;
            let mut scale = 1.0;
            let better = loop {
                let moved = now.impulses.iter().zip(&step);
                let moved = moved.map(|(x, dx)| x + dx * scale).collect();
                let trial = self.at(held, kappa, moved);
                if trial.merit < now.merit * (1.0 - 1e-4 * scale) {
                    break Some(trial);
                }
                scale *= 0.5;
                if scale < SHORTEST {
                    break None;
                }
            };
            match better {
                Some(trial) => now = trial,
                None => break,
            }
        }
        let size = self.norm(&now.answers).max(worst);
        Ok((now.answers, now.merit <= COUNTS * size))
    }

    /// Newton's step from an iterate.
    fn direction(&mut self, now: &Iterate) -> Result<Vec<Vec3>, LinearError> {
        self.matrix.clear();
        let mut right = Vec::with_capacity(3 * now.impulses.len());
        for (k, tangent) in now.tangents.iter().enumerate() {
            self.matrix.add(k, k, &Matrix3::identity());
            if *tangent != Matrix3::zeros() {
                for (j, block) in self.problem.row(k) {
                    self.matrix.add(k, j, &(tangent * block));
                }
            }
            right.extend_from_slice((now.answers[k] - now.impulses[k]).as_slice());
        }
        self.matrix.solve(&mut right)?;
        Ok(right.chunks_exact(3).map(Vec3::from_column_slice).collect())
    }

    /// Proximal steps from the impulses given, with `kappa` to begin with, until the goal is reached or `most` factorizations
    /// are done; `between` follows each step. The best impulses stay.
    ///
    /// # Errors
    /// [`LinearError`] if a factorization fails; the best impulses stay as well.
    pub(super) fn solve(
        &mut self,
        goal: Goal,
        (mut kappa, most): (f64, usize),
        impulses: &mut [Vec3],
        mut between: impl FnMut(&mut [Vec3]) -> usize,
    ) -> Result<FrictionReport, LinearError> {
        let mut report = FrictionReport::default();
        let mut growth = GROWTH[0];
        let mut now = impulses.to_vec();
        let mut best = self.problem.error(impulses);
        let mut broken = None;
        while best > goal.tolerance && report.factorizations < most {
            let before = report.factorizations;
            let (answers, balanced) = match self.step(&now, kappa, &mut report, most) {
                Ok(step) => step,
                Err(error) => {
                    broken = Some(error);
                    break;
                }
            };
            if balanced {
                now = answers;
                report.sweeps += between(&mut now);
                let error = self.problem.error(&now);
                if error < best {
                    best = error;
                    impulses.copy_from_slice(&now);
                }
                kappa *= growth;
            } else {
                kappa /= growth * growth;
                growth = growth.sqrt().max(GROWTH[1]);
            }
            if report.factorizations == before || !kappa.is_normal() {
                break;
            }
        }
        match broken {
            Some(error) if report.factorizations == 0 => Err(error),
            _ => Ok(report.close(self.problem, goal, impulses)),
        }
    }
}
